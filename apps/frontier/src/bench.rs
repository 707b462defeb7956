//! Speed of a pass on the timed sets, its largest error on the truth.

use std::rc::Rc;

use crate::set::{Pass, Set};
use crate::truth::Scalar;
use timing::points::Pairing;
use timing::record::Record;
use timing::time;

/// The library's name in the records.
pub const OURS: &str = "terrella";

/// How a function is called.
#[derive(Clone, Copy, PartialEq)]
pub enum Mode {
    /// A call for each point.
    OneByOne,
    /// A call for many points in slices.
    Batch,
}

impl Mode {
    /// The word for a record's `mode`.
    pub fn name(self) -> &'static str {
        match self {
            Self::OneByOne => "one by one",
            Self::Batch => "batch",
        }
    }
}

/// The error in metres of a row, given all results.
pub type Error<T> = Box<dyn Fn(usize, &Set<T>) -> f64>;

/// What is computed, on which points, and what it should give.
pub struct Task<T> {
    /// The chart.
    pub chart: &'static str,
    /// What is computed.
    pub operation: String,
    /// Name and points of the sets that are timed.
    pub inputs: Vec<(&'static str, Rc<Set<T>>)>,
    /// The inputs of the truth.
    pub truth: Set<T>,
    /// What the truth says of the results.
    pub error: Error<T>,
}

/// How much to measure, and what was measured.
pub struct Bench {
    /// Points of a timed set.
    pub points: usize,
    /// Timed passes over a set.
    pub repetitions: usize,
    /// Only what has this text in its key is run.
    pub only: String,
    /// The records so far.
    pub records: Vec<Record>,
}

impl Bench {
    /// Times one function and measures its error.
    pub fn run<T: Scalar>(&mut self, task: &Task<T>, method: &str, mode: Mode, pass: Pass<T>) {
        let mut record = Record {
            chart: task.chart.to_owned(),
            operation: task.operation.clone(),
            library: OURS.to_owned(),
            method: method.to_owned(),
            scalar: T::NAME.to_owned(),
            mode: mode.name().to_owned(),
            input: String::new(),
            ns_min: f64::NAN,
            ns_median: f64::NAN,
            error: f64::NAN,
            failures: 0.0,
        };
        if !record.key().join(",").contains(&self.only) {
            return;
        }
        // Where its iteration does not end it has no answer; no other method has none.
        let may_refuse = method == "vincenty";
        record.error = largest_error(task, pass, may_refuse);
        for (input, set) in &task.inputs {
            if may_refuse && *input == Pairing::Antipodal.name() {
                // Minutes of iterations that do not end.
                continue;
            }
            let mut room = Set::room(set.len());
            let timing = time(set.len(), self.repetitions, |range| pass(set, &mut room, range));
            let failed = room.columns[0].iter().filter(|&&value| !is_finite(value)).count();
            record.input = (*input).to_owned();
            record.ns_min = timing.min;
            record.ns_median = timing.median;
            record.failures = failed as f64 / set.len() as f64;
            self.records.push(record.clone());
        }
        eprint!("\r{} records", self.records.len());
    }
}

fn is_finite<T: Scalar>(value: T) -> bool {
    value.into().is_finite()
}

/// Infinite if a row gave no number that must not refuse; NaN if there is no truth.
fn largest_error<T: Scalar>(task: &Task<T>, pass: Pass<T>, may_refuse: bool) -> f64 {
    let rows = task.truth.len();
    let mut room = Set::room(rows);
    pass(&task.truth, &mut room, 0..rows);
    let found = (0..rows).filter(|&i| !may_refuse || is_finite(room.columns[0][i]));
    found.map(|i| (task.error)(i, &room)).fold(f64::NAN, |worst, error| {
        if error.is_nan() {
            f64::INFINITY
        } else {
            worst.max(error)
        }
    })
}
