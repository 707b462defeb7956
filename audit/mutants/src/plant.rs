//! Where a NaN can be planted: in what the functions of a source give.

use quote::ToTokens;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Block, Fields, GenericParam, Generics, Ident, ImplItemFn, Item, ItemFn, ItemImpl, ItemTrait, ReturnType, Signature,
    TraitItemFn, Type, parse_quote,
};

/// How many numbers a place has, for [`planted`]'s scalars and parts; and from where the next place has them.
///
/// [`planted`]: ../planted.rs
pub const STEP: usize = 6;

/// A function whose results may have a NaN.
pub struct Function {
    pub name: String,
    pub is_public: bool,
}

/// The source in which they do; `functions` gets them, each at a place of its own.
pub fn plant(file: &str, source: &str, functions: &mut Vec<Function>) -> syn::Result<String> {
    let mut parsed = syn::parse_file(source)?;
    Planter {
        file,
        of: Vec::new(),
        is_trait: false,
        functions,
    }
    .visit_file_mut(&mut parsed);
    impls(&mut parsed.items);
    Ok(prettyplease::unparse(&parsed))
}

struct Planter<'a> {
    file: &'a str,
    /// The types and traits around.
    of: Vec<String>,
    /// Their functions are as public as the trait.
    is_trait: bool,
    functions: &'a mut Vec<Function>,
}

impl Planter<'_> {
    fn function(&mut self, signature: &Signature, is_public: bool, block: &mut Block) {
        let ReturnType::Type(_, given) = &signature.output else {
            return;
        };
        // In a constant nothing can be planted, nor in what is borrowed; of `impl Trait` nothing is known.
        let text = given.to_token_stream().to_string();
        if signature.constness.is_some() || text.contains('&') || matches!(**given, Type::ImplTrait(_) | Type::Never(_))
        {
            return;
        }
        let place = STEP * self.functions.len();
        let path = [self.of.clone(), vec![signature.ident.to_string()]].concat().join("::");
        self.functions.push(Function {
            name: format!("{}:{}: {path}", self.file, signature.ident.span().start().line),
            is_public: is_public || self.is_trait,
        });
        *block = parse_quote! {{
            let mut result = (move || -> #given #block)();
            if crate::planted::wanted(#place) {
                #[allow(unused_imports)]
                use crate::planted::{Known as _, Unknown as _};
                crate::planted::plant(#place, &mut |each| (&mut crate::planted::Any(&mut result)).numbers(each));
            }
            result
        }};
    }
}

fn is_public(visibility: &syn::Visibility) -> bool {
    matches!(visibility, syn::Visibility::Public(_))
}

impl VisitMut for Planter<'_> {
    fn visit_item_fn_mut(&mut self, function: &mut ItemFn) {
        self.function(&function.sig, is_public(&function.vis), &mut function.block);
    }
    fn visit_impl_item_fn_mut(&mut self, function: &mut ImplItemFn) {
        self.function(&function.sig, is_public(&function.vis), &mut function.block);
    }
    fn visit_trait_item_fn_mut(&mut self, function: &mut TraitItemFn) {
        if let Some(block) = &mut function.default {
            self.function(&function.sig, false, block);
        }
    }

    fn visit_item_impl_mut(&mut self, item: &mut ItemImpl) {
        let of = &item.self_ty;
        let of = match &item.trait_ {
            Some((_, name, _)) => format!("<{} as {}>", of.to_token_stream(), name.to_token_stream()),
            None => of.to_token_stream().to_string(),
        };
        self.of.push(of.replace(' ', ""));
        let before = std::mem::replace(&mut self.is_trait, item.trait_.is_some());
        visit_mut::visit_item_impl_mut(self, item);
        self.is_trait = before;
        self.of.pop();
    }

    fn visit_item_trait_mut(&mut self, item: &mut ItemTrait) {
        if item.ident == "Real" {
            item.supertraits.push(parse_quote! { crate::planted::Plant });
        }
        self.of.push(item.ident.to_string());
        let before = std::mem::replace(&mut self.is_trait, true);
        visit_mut::visit_item_trait_mut(self, item);
        self.is_trait = before;
        self.of.pop();
    }
}

/// Tells of every type the numbers in it.
fn impls(items: &mut Vec<Item>) {
    let mut made = Vec::new();
    for item in items.iter_mut() {
        match item {
            Item::Mod(module) => {
                if let Some((_, items)) = &mut module.content {
                    impls(items);
                }
            }
            Item::Struct(item) if !item.attrs.iter().any(|attribute| attribute.path().is_ident("cfg")) => {
                let body = fields(&item.fields);
                let (pattern, body) = (&body.0, &body.1);
                made.push(told(
                    &item.ident,
                    &item.generics,
                    parse_quote! {{
                        let Self #pattern = self;
                        #body
                    }},
                ));
            }
            Item::Enum(item) if !item.variants.is_empty() => {
                let arms = item.variants.iter().map(|variant| {
                    let (name, (pattern, body)) = (&variant.ident, fields(&variant.fields));
                    quote::quote! { Self::#name #pattern => #body }
                });
                made.push(told(
                    &item.ident,
                    &item.generics,
                    parse_quote! {{ match self { #(#arms)* } }},
                ));
            }
            _ => {}
        }
    }
    items.extend(made);
}

fn told(name: &Ident, generics: &Generics, body: Block) -> Item {
    let mut bounded = generics.clone();
    for parameter in &mut bounded.params {
        if let GenericParam::Type(parameter) = parameter
            && parameter.ident == "T"
        {
            parameter.bounds.push(parse_quote! { crate::planted::Plant });
        }
    }
    let (_, arguments, _) = generics.split_for_impl();
    let (parameters, _, conditions) = bounded.split_for_impl();
    parse_quote! {
        impl #parameters crate::planted::Plant for #name #arguments #conditions {
            fn numbers(&mut self, each: &mut dyn FnMut(crate::planted::Number<'_>)) {
                #[allow(unused_imports)]
                use crate::planted::{Known as _, Unknown as _};
                let _ = &each;
                #body
            }
        }
    }
}

/// The pattern that names fields, and what asks each of them.
fn fields(fields: &Fields) -> (proc_macro2::TokenStream, Block) {
    let names: Vec<Ident> = (0..fields.len())
        .map(|index| Ident::new(&format!("field{index}"), fields.span()))
        .collect();
    let pattern = match fields {
        Fields::Named(named) => {
            let own = named.named.iter().map(|field| &field.ident);
            quote::quote! { { #(#own: #names),* } }
        }
        Fields::Unnamed(_) => quote::quote! { ( #(#names),* ) },
        Fields::Unit => quote::quote! {},
    };
    let body = parse_quote! {{ #( (&mut crate::planted::Any(#names)).numbers(each); )* }};
    (pattern, body)
}
