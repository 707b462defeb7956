//! Reading the truth files, and differences from them in decimal, without rounding.

use std::path::PathBuf;

pub use crate::scalar::Scalar;

/// The rows of a truth file, as text.
pub struct Truth {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// One row of a truth file.
#[derive(Clone, Copy)]
pub struct Row<'a> {
    header: &'a [String],
    fields: &'a [String],
}

impl Truth {
    /// Reads `tests/truth/NAME.tsv`.
    pub fn read(name: &str) -> Self {
        let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../tests/truth/{name}.tsv"));
        let text = std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let split = |line: &str| line.split('\t').map(str::to_owned).collect::<Vec<_>>();
        let header = split(lines.next().expect("a header line"));
        let rows: Vec<_> = lines.map(split).collect();
        assert!(rows.len() > 100, "{name}: only {} rows", rows.len());
        assert!(rows.iter().all(|row| row.len() == header.len()), "{name}: ragged");
        Self { header, rows }
    }

    /// The rows whose input columns are exact in the scalar: all of them for `f64`.
    pub fn exact_in<T: Scalar>(&self, inputs: &[&str]) -> Vec<Row<'_>> {
        let rows = self.rows.iter().map(|fields| Row {
            header: &self.header,
            fields,
        });
        let rows: Vec<_> = rows
            .filter(|row| inputs.iter().all(|&c| T::lift(row.value(c)).is_some()))
            .collect();
        assert!(rows.len() >= 20, "only {} rows for this scalar", rows.len());
        rows
    }
}

impl<'a> Row<'a> {
    /// A column's text.
    pub fn text(self, column: &str) -> &'a str {
        let index = self.header.iter().position(|name| name == column);
        &self.fields[index.unwrap_or_else(|| panic!("no column {column}"))]
    }

    /// A column rounded to the nearest `f64`: exact for inputs.
    pub fn value(self, column: &str) -> f64 {
        self.text(column)
            .parse()
            .unwrap_or_else(|why| panic!("{}: {why}", self.text(column)))
    }

    /// An input in the scalar.
    pub fn input<T: Scalar>(self, column: &str) -> T {
        T::lift(self.value(column)).expect("an input exact in the scalar")
    }

    /// |computed − truth|.
    pub fn error<T: Scalar>(self, column: &str, computed: T) -> f64 {
        self.deviation(column, computed).abs()
    }

    /// computed − truth.
    pub fn deviation<T: Scalar>(self, column: &str, computed: T) -> f64 {
        difference(computed.into(), self.text(column))
    }

    /// |computed − truth| in units of the last place of the truth.
    pub fn ulps<T: Scalar>(self, column: &str, computed: T) -> f64 {
        let truth = self.value(column);
        if truth == 0.0 || truth.is_infinite() {
            return if computed.into() == truth { 0.0 } else { f64::INFINITY };
        }
        relative(computed.into(), self.text(column)).abs() * significand(truth) / T::EPSILON.into()
    }
}

/// |single − double| in units of the last place of `f32`.
pub fn ulps_between(single: f32, double: f64) -> f64 {
    if f64::from(single) == double {
        return 0.0;
    }
    ((f64::from(single) - double) / double).abs() * significand(double) / f64::from(f32::EPSILON)
}

/// The significand in [1, 2).
fn significand(value: f64) -> f64 {
    value.abs() / value.abs().log2().floor().exp2()
}

/// `computed` − `truth`, rounded once.
fn difference(computed: f64, truth: &str) -> f64 {
    match truth.parse::<f64>() {
        // Far from a tiny truth there is nothing to cancel.
        Ok(value) if value != 0.0 && (computed / value).abs() < 1e4 => relative(computed, truth) * value,
        Ok(value) => computed - value,
        Err(why) => panic!("{truth}: {why}"),
    }
}

/// (`computed` − `truth`)/`truth`, from 33 significant decimals.
fn relative(computed: f64, truth: &str) -> f64 {
    let value: f64 = truth.parse().expect("a number");
    if !computed.is_finite() || (computed / value).abs() > 1e4 {
        return f64::INFINITY;
    }
    let magnitude = value.abs().log10().floor() as i32;
    let places = 33 - magnitude;
    let difference = fixed(&decimal(computed, places), places) - fixed(truth, places);
    let leading = fixed(truth, places) as f64;
    difference as f64 / leading
}

/// All the digits of a number down to the given place.
fn decimal(value: f64, places: i32) -> String {
    format!("{value:.*}", places.max(0) as usize)
}

/// A decimal as an integer of 10^−places, truncated.
fn fixed(text: &str, places: i32) -> i128 {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().expect("an exponent")),
        None => (text, 0),
    };
    let (negative, digits) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    // Digits after the last wanted place, if positive.
    let surplus = fraction.len() as i32 - exponent - places;
    let mut all = format!("{whole}{fraction}");
    if surplus > 0 {
        all.truncate(all.len().saturating_sub(surplus as usize));
    } else {
        all.extend(std::iter::repeat_n('0', -surplus as usize));
    }
    let value: i128 = if all.is_empty() {
        0
    } else {
        all.parse().expect("digits")
    };
    if negative { -value } else { value }
}

#[test]
fn differences_are_exact() {
    assert_eq!(difference(0.25, "0.25"), 0.0);
    assert!((difference(1.0, "0.9999999999999999999999999") - 1e-25).abs() < 1e-40);
    assert!((difference(-2.5e-20, "-1.5e-20") + 1e-20).abs() < 1e-35);
    assert!((relative(2e-300, "1e-300") - 1.0).abs() < 1e-15);
    assert_eq!(difference(180.0, "1.79e2"), 1.0);
    assert!((difference(0.1, "0.1") - 5.551_115_123_125_783e-18).abs() < 1e-30);
}
