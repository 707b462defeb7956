//! The truth files: text in, numbers of twice the precision out.

use std::path::Path;

/// An unevaluated sum: a number of 25 digits and more as two.
#[derive(Clone, Copy, Debug)]
pub struct Exact {
    /// The nearest `f64`.
    pub value: f64,
    rest: f64,
}

impl Exact {
    /// A number of the file.
    fn parse(text: &str) -> Self {
        let value: f64 = text.parse().unwrap_or_else(|why| panic!("{text}: {why}"));
        let rest = if value.is_finite() { rest_of(text, value) } else { 0.0 };
        Self { value, rest }
    }

    /// Radians as degrees.
    pub fn degrees(radians: f64) -> Self {
        // 180/π beyond its f64.
        const REST: f64 = -1.987_849_567_057_628_3e-15;
        let factor = 180.0 / std::f64::consts::PI;
        let value = radians * factor;
        let rest = radians.mul_add(factor, -value) + radians * REST;
        Self { value, rest }
    }

    /// The same of an exact number.
    pub fn degrees_of(radians: Self) -> Self {
        let Self { value, rest } = Self::degrees(radians.value);
        Self {
            value,
            rest: rest + radians.rest.to_degrees(),
        }
    }

    /// A multiple.
    pub fn times(self, factor: f64) -> Self {
        let value = self.value * factor;
        let rest = self.value.mul_add(factor, -value) + self.rest * factor;
        Self { value, rest }
    }

    /// `self` − `other`, rounded once where they are close.
    pub fn minus(self, other: Self) -> f64 {
        (self.value - other.value) + (self.rest - other.rest)
    }
}

impl From<f64> for Exact {
    fn from(value: f64) -> Self {
        Self { value, rest: 0.0 }
    }
}

/// What the decimal adds to its nearest `f64`; 0 for numbers below 1e-20.
fn rest_of(text: &str, value: f64) -> f64 {
    // Numbers of metres reach 1e15 (areas, unused here) and 1e8; 24 places of those fit in 127 bits up to 1e14.
    if value.abs() > 1e13 {
        return 0.0;
    }
    (fixed(text) - fixed(&format!("{value:.24}"))) as f64 * 1e-24
}

/// A decimal as a multiple of 1e-24, truncated.
fn fixed(text: &str) -> i128 {
    let (mantissa, exponent) = match text.split_once(['e', 'E']) {
        Some((mantissa, exponent)) => (mantissa, exponent.parse::<i32>().expect("an exponent")),
        None => (text, 0),
    };
    let (negative, digits) = match mantissa.strip_prefix('-') {
        Some(rest) => (true, rest),
        None => (false, mantissa),
    };
    let (whole, fraction) = digits.split_once('.').unwrap_or((digits, ""));
    let mut all = format!("{whole}{fraction}");
    let surplus = fraction.len() as i32 - exponent - 24;
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

/// A truth file.
pub struct Truth {
    header: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Truth {
    /// Reads `tests/truth/NAME.tsv`.
    pub fn read(name: &str) -> Self {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../tests/truth/{name}.tsv"));
        let text = std::fs::read_to_string(&path).unwrap_or_else(|why| panic!("{}: {why}", path.display()));
        let mut lines = text.lines().filter(|line| !line.starts_with('#'));
        let split = |line: &str| line.split('\t').map(str::to_owned).collect::<Vec<_>>();
        let header = split(lines.next().expect("a header line"));
        Self {
            rows: lines.map(split).collect(),
            header,
        }
    }

    /// The file without the rows that `keep` refuses, by the text of a column.
    pub fn keep(mut self, column: &str, keep: impl Fn(&str) -> bool) -> Self {
        let index = self.index(column);
        self.rows.retain(|row| keep(&row[index]));
        assert!(self.rows.len() >= 40, "{column}: only {} rows", self.rows.len());
        self
    }

    fn index(&self, column: &str) -> usize {
        self.header
            .iter()
            .position(|name| name == column)
            .unwrap_or_else(|| panic!("no column {column}"))
    }

    /// A column as text.
    pub fn text(&self, column: &str) -> Vec<String> {
        let index = self.index(column);
        self.rows.iter().map(|row| row[index].clone()).collect()
    }

    /// A column to twice the precision.
    pub fn exact(&self, column: &str) -> Vec<Exact> {
        self.text(column).iter().map(|text| Exact::parse(text)).collect()
    }

    /// A column rounded to `f64`: exact for inputs.
    pub fn values(&self, column: &str) -> Vec<f64> {
        self.exact(column).iter().map(|exact| exact.value).collect()
    }
}

#[test]
fn differences_are_exact() {
    let off = |computed: f64, text: &str| Exact::from(computed).minus(Exact::parse(text));
    assert!((off(0.1, "0.1") - 5.551_115_123_125_783e-18).abs() < 1e-23);
    assert!((off(-11777732.0, "-11777732.0226154702556032237897") - 0.022_615_470_255_603_223).abs() < 1e-15);
    assert!((off(1e-7, "1.0000001e-7") + 1e-14).abs() < 1e-23);
    let turn = Exact::degrees(std::f64::consts::PI);
    assert!((turn.minus(Exact::from(180.0)) + 1.224_646_799_147_353_2e-16 * 57.295_779_513_082_32).abs() < 1e-28);
}
