//! Speed of a pass on the timed sets, its largest error on the truth.

use crate::pass::{Pass, Scalar, Set};
use timing::record::Record;
use timing::time;

/// The error of a row of the truth in metres, given the results of all.
type ErrorOf = Box<dyn Fn(usize, &Set) -> Option<f64>>;

/// What is computed, on which points, and what it should give. One per operation and convention of coordinates.
pub struct Task<T = f64> {
    /// The chart.
    pub chart: &'static str,
    /// What is computed.
    pub operation: String,
    /// Name and points of the sets that are timed.
    pub inputs: Vec<(&'static str, Set<T>)>,
    /// The inputs of the truth file.
    pub truth: Set<T>,
    /// The error in metres of a row, given all results; `None` where the row says nothing.
    pub error: ErrorOf,
}

impl Task {
    /// The same in another scalar.
    pub fn rounded<T: Scalar>(self) -> Task<T> {
        let rounded = |(name, set): (_, Set)| (name, set.rounded());
        Task {
            chart: self.chart,
            operation: self.operation,
            inputs: self.inputs.into_iter().map(rounded).collect(),
            truth: self.truth.rounded(),
            error: self.error,
        }
    }
}

/// The records so far.
pub struct Bench {
    /// Only what has this text in its key is run.
    pub only: String,
    /// Timed passes over a set.
    pub repetitions: usize,
    /// What was measured.
    pub records: Vec<Record>,
}

impl Bench {
    /// Times one function of a library and measures its error.
    pub fn run<T: Scalar>(&mut self, task: &Task<T>, library: &str, method: &str, mode: &str, pass: &Pass<T>) {
        let mut record = Record {
            chart: task.chart.to_owned(),
            operation: task.operation.clone(),
            library: library.to_owned(),
            method: method.to_owned(),
            scalar: T::NAME.to_owned(),
            mode: mode.to_owned(),
            input: String::new(),
            ns_min: f64::NAN,
            ns_median: f64::NAN,
            error: f64::NAN,
            failures: 0.0,
        };
        if !record.key().join(",").contains(&self.only) {
            return;
        }
        record.error = largest_error(task, pass);
        for (input, set) in &task.inputs {
            let mut room = Set::room(set.len());
            // A pass that gives faces overwrites them, one that reads them finds them.
            room.face.copy_from_slice(&set.face);
            let timing = time(set.len(), self.repetitions, |range| pass(set, &mut room, range));
            let failed = room.columns[0]
                .iter()
                .filter(|&&value| !value.into().is_finite())
                .count();
            record.input = (*input).to_owned();
            record.ns_min = timing.min;
            record.ns_median = timing.median;
            record.failures = failed as f64 / set.len() as f64;
            eprintln!("{}", record.line());
            self.records.push(record.clone());
        }
    }
}

fn largest_error<T: Scalar>(task: &Task<T>, pass: &Pass<T>) -> f64 {
    let mut room = Set::room(task.truth.len());
    room.face.copy_from_slice(&task.truth.face);
    pass(&task.truth, &mut room, 0..task.truth.len());
    let (truth, room): (Set, Set) = (task.truth.rounded(), room.rounded());
    let rows = (0..task.truth.len()).filter(|&i| room.columns[0][i].is_finite());
    let worst = rows
        .filter_map(|i| Some((i, (task.error)(i, &room)?)))
        .max_by(|a, b| a.1.total_cmp(&b.1));
    if let Some((i, error)) = worst
        && std::env::var_os("PEERS_WORST").is_some()
    {
        let row = |set: &Set| set.columns.iter().map(|column| column[i]).collect::<Vec<_>>();
        eprintln!(
            "worst {error:e}: {} {:?} -> {:?}",
            truth.face[i],
            row(&truth),
            row(&room)
        );
    }
    worst.map_or(f64::NAN, |(_, error)| error)
}
