//! Which of the mutants that are woven in the compiler refuses.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use std::process::Command;

use cargo_metadata::Message;
use cargo_metadata::diagnostic::{DiagnosticLevel, DiagnosticSpan};
use proc_macro2::Span;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Expr, ExprMatch, Lit, Pat};

use crate::Failure;
use crate::mutant::Place;

/// No more than the first errors are told at a time: to be called until there is none.
pub fn refused(tree: &Path) -> Result<BTreeSet<usize>, Failure> {
    let said = cargo(tree)
        .args(["check", "--lib", "--quiet", "--message-format", "json"])
        .output()?;
    let mut arms = BTreeMap::new();
    let mut refused = BTreeSet::new();
    for message in Message::parse_stream(&*said.stdout) {
        let Message::CompilerMessage(message) = message? else {
            continue;
        };
        if message.message.level != DiagnosticLevel::Error {
            continue;
        }
        for span in message.message.spans.iter().filter(|span| span.is_primary) {
            if !arms.contains_key(&span.file_name) {
                let mut found = Arms::default();
                found.visit_file(&syn::parse_file(&fs::read_to_string(tree.join(&span.file_name))?)?);
                arms.insert(span.file_name.clone(), found);
            }
            refused.extend(arms[&span.file_name].around(span));
        }
    }
    if refused.is_empty() && !said.status.success() {
        return Err(format!(
            "does not compile, and not for a mutant: {}",
            String::from_utf8_lossy(&said.stderr)
        )
        .into());
    }
    Ok(refused)
}

/// Cargo in a tree of mutants, which warnings say nothing about.
pub fn cargo(tree: &Path) -> Command {
    let mut cargo = Command::new("cargo");
    cargo.current_dir(tree).env("RUSTFLAGS", "--cap-lints allow");
    cargo
}

/// For each arm that is a mutant its range, and the ranges of the matches with the mutants that they choose from.
#[derive(Default)]
struct Arms(Vec<(Place, Place, Vec<usize>)>);

impl Arms {
    /// The mutant whose arm an error is in, or those of the match, if it is about the match.
    fn around(&self, error: &DiagnosticSpan) -> Vec<usize> {
        let start = Place {
            line: error.line_start,
            column: error.column_start,
        };
        let end = Place {
            line: error.line_end,
            column: error.column_end,
        };
        let around = self.0.iter().filter(|(from, to, _)| *from <= start && end <= *to);
        // Of ranges one in the other the innermost starts last, and of those that start together ends first.
        around
            .max_by(|a, b| a.0.cmp(&b.0).then(b.1.cmp(&a.1)))
            .map_or_else(Vec::new, |(.., mutants)| mutants.clone())
    }

    fn add(&mut self, span: Span, mutants: Vec<usize>) {
        self.0.push((span.start().into(), span.end().into(), mutants));
    }
}

impl<'a> Visit<'a> for Arms {
    fn visit_expr_match(&mut self, chosen: &'a ExprMatch) {
        if let Expr::Call(call) = &*chosen.expr
            && let Expr::Path(function) = &*call.func
            && function.path.segments.iter().any(|segment| segment.ident == "chosen")
        {
            let mut all = Vec::new();
            for arm in &chosen.arms {
                if let Pat::Lit(number) = &arm.pat
                    && let Lit::Int(number) = &number.lit
                    && let Ok(number) = number.base10_parse()
                {
                    self.add(arm.body.span(), vec![number]);
                    all.push(number);
                }
            }
            self.add(chosen.span(), all);
        }
        visit::visit_expr_match(self, chosen);
    }
}
