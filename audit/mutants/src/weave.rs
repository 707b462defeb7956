//! Mutants as arms of a match on the one that is chosen.

use std::collections::BTreeMap;

use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::visit_mut::{self, VisitMut};
use syn::{
    Arm, BinOp, Block, Expr, ExprBinary, ExprConst, ExprRepeat, ImplItemConst, ImplItemFn, ItemConst, ItemFn,
    ItemStatic, Pat, Signature, TraitItemConst, TraitItemFn, Type, parse_quote,
};

use crate::mutant::{Genre, Mutant, Place};

/// The source with all of these mutants in it, but those of constants, which cannot choose. `places` gets for each mutant that is in it
/// the first one of its place, which is what [`chosen::at`] is asked there.
///
/// [`chosen::at`]: ../chosen.rs
pub fn weave<'a>(
    source: &str,
    mutants: impl Iterator<Item = (usize, &'a Mutant)>,
    places: &mut BTreeMap<usize, usize>,
) -> syn::Result<String> {
    let mut at: BTreeMap<Place, Vec<(usize, &Mutant)>> = BTreeMap::new();
    for (number, mutant) in mutants {
        at.entry(mutant.span.start).or_default().push((number, mutant));
    }
    let mut file = syn::parse_file(source)?;
    Weaver { at, places }.visit_file_mut(&mut file);
    Ok(prettyplease::unparse(&file))
}

struct Weaver<'a> {
    at: BTreeMap<Place, Vec<(usize, &'a Mutant)>>,
    places: &'a mut BTreeMap<usize, usize>,
}

/// The mutants of one place: their numbers and what they put there.
type Here<'a> = Vec<(usize, &'a str)>;

impl<'a> Weaver<'a> {
    fn take(&mut self, span: Span, genre: Genre) -> Here<'a> {
        let all = self.at.get(&span.start().into()).into_iter().flatten();
        let here: Here = all
            .filter(|(_, mutant)| mutant.genre == genre)
            .map(|(number, mutant)| (*number, &*mutant.replacement))
            .collect();
        self.places.extend(here.iter().map(|(number, _)| (*number, here[0].0)));
        here
    }

    fn function(&mut self, signature: &Signature, block: &mut Block) {
        if signature.constness.is_some() {
            return;
        }
        let here = match block.stmts.first() {
            Some(first) => self.take(first.span(), Genre::FnValue),
            None => Vec::new(),
        };
        visit_mut::visit_block_mut(self, block);
        if !here.is_empty() {
            let mutated = choose(
                &here,
                |value| {
                    let value: Expr = parsed(value);
                    parse_quote! { return #value }
                },
                parse_quote! { {} },
            );
            block.stmts.insert(0, parse_quote! { #mutated; });
        }
    }
}

fn parsed<T: syn::parse::Parse>(text: &str) -> T {
    syn::parse_str(text).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// What is chosen of the mutants here, or what was there before.
fn choose(here: &Here, mutated: impl Fn(&str) -> Expr, before: Expr) -> Expr {
    let place = here[0].0;
    let numbers = here.iter().map(|(number, _)| number);
    let mutated = here.iter().map(|(_, replacement)| mutated(replacement));
    parse_quote! { (match crate::chosen::at(#place) { #(#numbers => #mutated,)* _ => #before }) }
}

/// Whether a condition binds: then it must stay where it is.
fn binds(condition: &Expr) -> bool {
    match condition {
        Expr::Let(_) => true,
        Expr::Binary(binary) => binds(&binary.left) || binds(&binary.right),
        _ => false,
    }
}

impl VisitMut for Weaver<'_> {
    fn visit_item_const_mut(&mut self, _: &mut ItemConst) {}
    fn visit_item_static_mut(&mut self, _: &mut ItemStatic) {}
    fn visit_impl_item_const_mut(&mut self, _: &mut ImplItemConst) {}
    fn visit_trait_item_const_mut(&mut self, _: &mut TraitItemConst) {}
    fn visit_expr_const_mut(&mut self, _: &mut ExprConst) {}
    fn visit_type_mut(&mut self, _: &mut Type) {}
    fn visit_pat_mut(&mut self, _: &mut Pat) {}
    fn visit_expr_repeat_mut(&mut self, repeat: &mut ExprRepeat) {
        self.visit_expr_mut(&mut repeat.expr);
    }

    fn visit_item_fn_mut(&mut self, function: &mut ItemFn) {
        self.function(&function.sig, &mut function.block);
    }
    fn visit_impl_item_fn_mut(&mut self, function: &mut ImplItemFn) {
        self.function(&function.sig, &mut function.block);
    }
    fn visit_trait_item_fn_mut(&mut self, function: &mut TraitItemFn) {
        if let Some(block) = &mut function.default {
            self.function(&function.sig, block);
        }
    }

    fn visit_arm_mut(&mut self, arm: &mut Arm) {
        let here = self.take(arm.span(), Genre::MatchArm);
        visit_mut::visit_arm_mut(self, arm);
        if !here.is_empty() {
            let guard = arm
                .guard
                .take()
                .map_or_else(|| parse_quote! { true }, |(_, guard)| *guard);
            arm.guard = Some((
                Default::default(),
                Box::new(choose(&here, |_| parse_quote! { false }, guard)),
            ));
        }
    }

    fn visit_expr_mut(&mut self, expression: &mut Expr) {
        let before = expression.clone();
        visit_mut::visit_expr_mut(self, expression);
        match (before, &*expression) {
            (Expr::Binary(before), Expr::Binary(now)) if !binds(expression) => {
                let here = self.take(before.op.span(), Genre::BinaryOperator);
                if !here.is_empty() {
                    *expression = binary(&here, &before, now);
                }
            }
            (Expr::Unary(before), Expr::Unary(now)) => {
                let here = self.take(before.span(), Genre::UnaryOperator);
                if !here.is_empty() {
                    let (operator, operand) = (&now.op, &now.expr);
                    let chosen = choose(&here, |_| parse_quote! { value }, parse_quote! { #operator value });
                    *expression = parse_quote! { (match #operand { value => #chosen }) };
                }
            }
            _ => {}
        }
    }
}

/// Operands are computed once, by a match that keeps what they borrow, but where they are not always computed, or are assigned to: there
/// those of `before`, without mutants, stand in each arm.
fn binary(here: &Here, before: &ExprBinary, now: &ExprBinary) -> Expr {
    let (left, operator, right) = (&now.left, &now.op, &now.right);
    let choose = |left: &Expr, right: &Expr, then_left: &Expr, then_right: &Expr| {
        let mutated = |text: &str| {
            let operator: BinOp = parsed(text);
            parse_quote! { #then_left #operator #then_right }
        };
        choose(here, mutated, parse_quote! { #left #operator #right })
    };
    let (l, r): (Expr, Expr) = (parse_quote! { left }, parse_quote! { right });
    match operator {
        BinOp::And(_) | BinOp::Or(_) => choose(left, right, &before.left, &before.right),
        BinOp::Eq(_) | BinOp::Ne(_) | BinOp::Lt(_) | BinOp::Le(_) | BinOp::Gt(_) | BinOp::Ge(_) => {
            let chosen = choose(&l, &r, &l, &r);
            parse_quote! { (match (&(#left), &(#right)) { (left, right) => #chosen }) }
        }
        _ if here[0].1.ends_with('=') => {
            let assigned: Expr = parse_quote! { assigned };
            let chosen = choose(&before.left, &assigned, &before.left, &assigned);
            parse_quote! { (match #right { assigned => #chosen }) }
        }
        _ => {
            let chosen = choose(&l, &r, &l, &r);
            parse_quote! { (match (#left, #right) { (left, right) => #chosen }) }
        }
    }
}
