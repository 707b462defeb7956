//! One measurement, and its line of a CSV file.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use testkit::Worst;

/// Metres that an error of one face unit counts for: the sphere's radius of 6371 km times π/4, the length of half a
/// middle line of a face.
pub const METRES_PER_FACE_UNIT: f64 = METRES_PER_RADIAN * std::f64::consts::FRAC_PI_4;

/// Metres that the length of a difference of unit vectors counts for: the sphere's radius.
pub const METRES_PER_RADIAN: f64 = 6_371_000.0;

/// The speed and the largest error of one function on one set of points.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    /// The chart it belongs to: `distance`, `projection`, `position` or `scene`.
    pub chart: String,
    /// What is computed, such as `inverse`, `direct`, `qsc forward`, `ecef to geodetic`, `authalic latitude`.
    pub operation: String,
    /// The library, with how it was built where that differs: `GeographicLib 2.1.2 (Debian)`.
    pub library: String,
    /// The function or algorithm in it, and from and to which coordinates.
    pub method: String,
    /// `f32` or `f64`.
    pub scalar: String,
    /// `one by one` or `batch`.
    pub mode: String,
    /// The set of points: `random`, `scan`, or one of `Pairing`.
    pub input: String,
    /// Nanoseconds per point: the least, as `Timing::min` has it.
    pub ns_min: f64,
    /// Nanoseconds per point: the median, as `Timing::median` has it.
    pub ns_median: f64,
    /// The largest error on the truth data, in metres, of the rows that did not fail.
    ///
    /// `distance`: of the distance, or of the end of a line of at most 2.1e7 m. `position`: displacement in space, heights of at least
    /// −10 km; a latitude's error times the equatorial radius. `projection`: the length of the difference in face units or of unit vectors,
    /// times [`METRES_PER_FACE_UNIT`] or [`METRES_PER_RADIAN`]. NaN: not measured.
    pub error: f64,
    /// The share of the points of the set, 0 to 1, that gave an error or a number that is not finite.
    pub failures: f64,
}

/// The first line of the file.
pub const HEADER: &str = "chart,operation,library,method,scalar,mode,input,ns_min,ns_median,error_m,failures";

impl Record {
    /// All that tells one measurement from another.
    pub fn key(&self) -> [&str; 7] {
        [
            &self.chart, &self.operation, &self.library, &self.method, &self.scalar, &self.mode, &self.input,
        ]
    }

    /// The line of the file. No field may hold a comma.
    pub fn line(&self) -> String {
        assert!(self.key().iter().all(|field| !field.contains(',')), "a comma: {self:?}");
        format!(
            "{},{:.3},{:.3},{:.3e},{:.6}",
            self.key().join(","),
            self.ns_min,
            self.ns_median,
            self.error,
            self.failures
        )
    }

    /// Reads a line of the file.
    pub fn parse(line: &str) -> Option<Self> {
        let fields: Vec<&str> = line.split(',').collect();
        let &[
            chart,
            operation,
            library,
            method,
            scalar,
            mode,
            input,
            ns_min,
            ns_median,
            error,
            failures,
        ] = fields.as_slice()
        else {
            return None;
        };
        Some(Self {
            chart: chart.to_owned(),
            operation: operation.to_owned(),
            library: library.to_owned(),
            method: method.to_owned(),
            scalar: scalar.to_owned(),
            mode: mode.to_owned(),
            input: input.to_owned(),
            ns_min: ns_min.parse().ok()?,
            ns_median: ns_median.parse().ok()?,
            error: error.parse().ok()?,
            failures: failures.parse().ok()?,
        })
    }
}

/// Reads a file of records.
pub fn read(path: &Path) -> io::Result<Vec<Record>> {
    let text = fs::read_to_string(path)?;
    let bad = |line: &str| io::Error::new(io::ErrorKind::InvalidData, format!("not a record: {line}"));
    let lines = text.lines().filter(|&line| line != HEADER);
    lines.map(|line| Record::parse(line).ok_or_else(|| bad(line))).collect()
}

/// Adds records to a file, which begins with [`HEADER`].
pub fn append(path: &Path, records: &[Record]) -> io::Result<()> {
    let mut file = fs::OpenOptions::new().create(true).append(true).open(path)?;
    if file.metadata()?.len() == 0 {
        writeln!(file, "{HEADER}")?;
    }
    records
        .iter()
        .try_for_each(|record| writeln!(file, "{}", record.line()))
}

/// Joins the records of several runs: the least minimum, the median of medians, the largest error and share of failures.
pub fn merge(records: &[Record]) -> Vec<Record> {
    let mut merged: Vec<Record> = Vec::new();
    for record in records {
        if merged.iter().any(|other| other.key() == record.key()) {
            continue;
        }
        let same: Vec<&Record> = records.iter().filter(|other| other.key() == record.key()).collect();
        let mut medians: Vec<f64> = same.iter().map(|record| record.ns_median).collect();
        medians.sort_by(f64::total_cmp);
        let largest = |value: fn(&Record) -> f64| Worst::of(same.iter().map(|record| value(record)));
        merged.push(Record {
            ns_min: same.iter().map(|record| record.ns_min).fold(f64::INFINITY, f64::min),
            ns_median: medians[medians.len() / 2],
            error: largest(|record| record.error),
            failures: largest(|record| record.failures),
            ..record.clone()
        });
    }
    merged
}
