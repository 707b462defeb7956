//! The comparison with other crates on the same pairs of places.

use rayon::prelude::*;

use crate::pair::{Pair, Place, Scalar, Truth};
use crate::solver::{GEOGRAPHICLIB, Solver};
use draw::page::escaped;
use draw::units::{length, percent};

/// How far from the antipode the hard pairs are, in degrees and in metres.
const NEAR_DEGREES: f64 = 0.5;
const NEAR: f64 = NEAR_DEGREES * 111_195.0;
/// An error in metres that makes an answer a wrong one.
const WRONG: f64 = 1000.0;

/// A method and what it did.
pub struct Row {
    name: String,
    scalar: &'static str,
    near: Measured,
    anywhere: Measured,
}

/// What a method did with a set of pairs.
struct Measured {
    /// Of the answers' errors, in metres.
    median: f64,
    worst: f64,
    /// Shares of all the pairs.
    failed: f64,
    wrong: f64,
}

/// Compares all methods.
pub fn compare(ours: &[Solver], theirs: &[Solver], truth: &Truth, count: usize) -> Vec<Row> {
    let near = Set::new(truth, near(truth, count));
    let anywhere = Set::new(truth, anywhere(count));
    // What the others are measured against is measured against this crate.
    let karney = ours.iter().find(|s| s.name == "Karney" && s.scalar == Scalar::F64);
    let row = |solver: &Solver, name: String| {
        let judge = karney.filter(|_| solver.name == GEOGRAPHICLIB);
        Row {
            name,
            scalar: solver.scalar.name(),
            near: near.measure(solver, judge),
            anywhere: anywhere.measure(solver, judge),
        }
    };
    let ours = ours.iter().map(|s| row(s, format!("terrella, {}", s.name)));
    ours.chain(theirs.iter().map(|s| row(s, s.name.to_owned()))).collect()
}

/// Pairs with their distances, for each scalar.
struct Set([Vec<(Pair, f64)>; 2]);

impl Set {
    fn new(truth: &Truth, pairs: Vec<Pair>) -> Self {
        Self(Scalar::ALL.map(|scalar| {
            let known = |pair: &Pair| {
                let pair = pair.rounded(scalar);
                (pair, truth.distance(pair))
            };
            pairs.par_iter().map(known).collect()
        }))
    }

    fn measure(&self, solver: &Solver, judge: Option<&Solver>) -> Measured {
        let [double, single] = &self.0;
        let pairs = if solver.scalar == Scalar::F64 { double } else { single };
        let error = |&(pair, truth): &(Pair, f64)| {
            let truth = judge.and_then(|j| j.distance(pair)).unwrap_or(truth);
            Some((solver.distance(pair)? - truth).abs())
        };
        let mut errors: Vec<f64> = pairs.par_iter().filter_map(error).collect();
        errors.sort_by(f64::total_cmp);
        let share = |count: usize| count as f64 / pairs.len() as f64;
        Measured {
            median: errors.get(errors.len() / 2).copied().unwrap_or(f64::NAN),
            worst: errors.last().copied().unwrap_or(f64::NAN),
            failed: share(pairs.len() - errors.len()),
            wrong: share(errors.iter().filter(|&&e| e > WRONG).count()),
        }
    }
}

fn near(truth: &Truth, count: usize) -> Vec<Pair> {
    let mut rng = fastrand::Rng::with_seed(1);
    let pair = |_| {
        let from = Place::anywhere(&mut rng);
        let (azimuth, distance) = (360.0 * rng.f64(), NEAR * rng.f64().sqrt());
        let to = truth.destination(from.antipode(), azimuth, distance);
        Pair { from, to }
    };
    (0..count).map(pair).collect()
}

fn anywhere(count: usize) -> Vec<Pair> {
    let mut rng = fastrand::Rng::with_seed(2);
    let mut place = || Place::anywhere(&mut rng);
    (0..count)
        .map(|_| Pair {
            from: place(),
            to: place(),
        })
        .collect()
}

/// What the sets are, in words.
pub fn caption(count: usize) -> String {
    format!(
        "{count} pairs within {NEAR_DEGREES}° of the antipode, and {count} of any two places. Median and largest error of \
         the answers against geographiclib-rs (its own against terrella’s Karney in f64); failed: an error or what is not \
         a number; wrong: an answer more than {} km off.",
        WRONG / 1e3
    )
}

const HEADINGS: [&str; 8] = [
    "median", "largest", "failed", "wrong", "median", "largest", "failed", "wrong",
];

/// The comparison in Markdown.
pub fn markdown(rows: &[Row]) -> String {
    let mut table = String::from(
        "| method | scalar | antipode: median | largest | failed | wrong | anywhere: median | largest | failed | wrong |\n\
         |---|---|--:|--:|--:|--:|--:|--:|--:|--:|\n",
    );
    for row in rows {
        let cells = cells(row).join(" | ");
        table.push_str(&format!("| {} | {} | {cells} |\n", row.name, row.scalar));
    }
    table
}

/// The comparison in HTML.
pub fn html(rows: &[Row]) -> String {
    let headings: String = HEADINGS
        .iter()
        .map(|h| format!("<th scope=\"col\" class=\"number\">{h}</th>"))
        .collect();
    let body: String = rows
        .iter()
        .map(|row| {
            let cells: String = cells(row)
                .iter()
                .map(|c| format!("<td class=\"number\">{c}</td>"))
                .collect();
            format!(
                "<tr><th scope=\"row\">{}</th><td>{}</td>{cells}</tr>\n",
                escaped(&row.name),
                row.scalar
            )
        })
        .collect();
    format!(
        "<table>\n<thead>\n<tr><th rowspan=\"2\" scope=\"col\">method</th><th rowspan=\"2\" scope=\"col\">scalar</th>\
         <th colspan=\"4\" scope=\"colgroup\" class=\"group\">within {NEAR_DEGREES}° of the antipode</th>\
         <th colspan=\"4\" scope=\"colgroup\" class=\"group\">anywhere</th></tr>\n<tr>{headings}</tr>\n</thead>\n\
         <tbody>\n{body}</tbody>\n</table>\n"
    )
}

fn cells(row: &Row) -> Vec<String> {
    let of = |m: &Measured| [length(m.median), length(m.worst), percent(m.failed), percent(m.wrong)];
    [of(&row.near), of(&row.anywhere)].concat()
}
