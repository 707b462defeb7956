//! Writes a slice of the truth, with what the README claims, as tables for the firmware.

use std::fmt::Write;
use std::path::{Path, PathBuf};
use std::{env, fs};

use terrella::cube::Projection;

/// How many rows are taken of a file, and how many more that are exact in `f32`.
const ROWS: usize = 40;

/// A table: its name, file, columns given, columns of truth, and the column of words that goes along.
type Slice<'a> = (&'a str, &'a str, &'a [&'a str], &'a [&'a str], &'a str);

const PLACES: &[&str] = &["lat1", "lon1", "lat2", "lon2"];
const EARTH: &[&str] = &["X", "Y", "Z"];

#[rustfmt::skip]
const SLICES: &[Slice] = &[
    ("SIN_COS", "kernel_sin_cos", &["x"], &["sin", "cos"], "class"),
    ("SIN_COS_DEGREES", "kernel_sin_cos_degrees", &["x"], &["sin", "cos"], "class"),
    ("TAN", "kernel_tan", &["x"], &["tan"], "class"),
    ("ATAN", "kernel_atan", &["x"], &["atan"], "class"),
    ("ATAN2", "kernel_atan2", &["y", "x"], &["atan2_radians", "atan2_degrees"], "class"),
    ("CBRT", "kernel_cbrt", &["x"], &["cbrt"], "class"),
    ("DIRECTION", "kernel_direction", &["lat", "lon"], &["x", "y", "z"], "class"),
    ("LAT_LON", "kernel_lat_lon", &["x", "y", "z"], &["lat", "lon"], "class"),
    ("LATITUDES", "auxlat_wgs84_rad", &["phi"],
        &["geocentric", "parametric", "authalic", "conformal", "rectifying", "isometric"], "class"),
    ("GEODETIC", "auxlat_inverse_wgs84_rad", &["value"], &["phi"], "kind"),
    ("TO_ECEF", "ecef_forward_wgs84", &["lat", "lon", "h"], EARTH, "class"),
    ("TO_GEODETIC", "ecef_reverse_wgs84", EARTH, &["lat", "lon", "h"], "class"),
    ("GREAT_CIRCLE", "greatcircle_deg", PLACES, &["dist"], "class"),
    ("INVERSE", "geod_inverse_wgs84", PLACES, &["s12", "azi1", "azi2", "m12", "S12"], "multi"),
    ("DIRECT", "geod_direct_wgs84", &["lat1", "lon1", "azi1", "s12"], &["lat2", "lon2"], "multi"),
    ("JACOBIAN", "cube_jacobian", &["face", "x", "y"], &["area"], "projection"),
];

/// The paper's axes, in the order of the Earth's.
const VECTOR: &[&str] = &["vz", "vx", "vy"];
const POINT: &[&str] = &["face", "x", "y"];

fn main() {
    let here = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap());
    let root = here.join("../..");
    println!("cargo::rustc-link-search={}", here.display());
    println!("cargo::rerun-if-changed=memory.x");
    println!("cargo::rerun-if-changed={}", root.join("tests/truth").display());
    let mut text = String::new();
    for slice in SLICES {
        text += &table(&root, slice);
    }
    text += "pub static PROJECTIONS: &[(Projection, &[Row<3, 3>], &[Row<3, 3>])] = &[\n";
    for &projection in Projection::ALL {
        // The forward polynomials of the two are one.
        let forward = if projection == Projection::Cobe {
            Projection::CobeExact
        } else {
            projection
        };
        let forward = rows(&root, &format!("cube_{forward}_forward"), VECTOR, POINT, "class");
        let inverse = rows(&root, &format!("cube_{projection}_inverse"), POINT, VECTOR, "class");
        writeln!(text, "(Projection::{projection:?}, &[{forward}], &[{inverse}]),").unwrap();
    }
    text += "];\n";
    text += &claims(&root.join("README.md"));
    fs::write(PathBuf::from(env::var("OUT_DIR").unwrap()).join("truth.rs"), text).unwrap();
}

fn table(root: &Path, (name, file, given, truth, word): &Slice) -> String {
    let rows = rows(root, file, given, truth, word);
    format!(
        "pub static {name}: &[Row<{}, {}>] = &[{rows}];\n",
        given.len(),
        truth.len()
    )
}

/// Rows spread over a file, then rows spread over those that are exact in `f32`.
fn rows(root: &Path, file: &str, given: &[&str], truth: &[&str], word: &str) -> String {
    let text = fs::read_to_string(root.join(format!("tests/truth/{file}.tsv"))).unwrap();
    let mut lines = text
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split('\t').collect::<Vec<_>>());
    let header = lines.next().unwrap();
    let column = |name: &str| header.iter().position(|&column| column == name).unwrap();
    let all: Vec<_> = lines.collect();
    let single = |text: &str| {
        let value: f64 = text.parse().unwrap();
        f64::from(value as f32) == value
    };
    let exact: Vec<_> = all
        .iter()
        .filter(|row| given.iter().all(|&name| single(row[column(name)])))
        .collect();
    let spread = |rows: Vec<&Vec<&str>>| {
        let step = rows.len().div_ceil(ROWS).max(1);
        rows.into_iter()
            .step_by(step)
            .map(|row| {
                let given: Vec<_> = given
                    .iter()
                    .map(|&name| number(row[column(name)].parse().unwrap()))
                    .collect();
                let truth: Vec<_> = truth.iter().map(|&name| long(row[column(name)])).collect();
                let (given, truth, word) = (given.join(","), truth.join(","), row[column(word)]);
                format!("Row {{ given: [{given}], truth: [{truth}], word: {word:?} }},\n")
            })
            .collect::<String>()
    };
    spread(all.iter().collect()) + &spread(exact)
}

fn number(value: f64) -> String {
    match value {
        f64::INFINITY => "f64::INFINITY".to_owned(),
        f64::NEG_INFINITY => "f64::NEG_INFINITY".to_owned(),
        value if value.is_nan() => "f64::NAN".to_owned(),
        value => format!("{value:?}"),
    }
}

/// A decimal as the sum of two `f64`.
fn long(text: &str) -> String {
    let high: f64 = text.parse().unwrap();
    let low = if high == 0.0 || !high.is_finite() {
        0.0
    } else {
        rest(text, high)
    };
    format!("Long({}, {low:?})", number(high))
}

/// What a decimal is more than the `f64` nearest to it.
fn rest(text: &str, high: f64) -> f64 {
    // Both as multiples of the same power of ten.
    let (digits, exponent) = scaled(text);
    let (nearest, other) = scaled(&format!("{high:.35e}"));
    let common = exponent.max(other);
    let shift = |digits: i128, exponent: i32| digits / 10_i128.pow((common - exponent) as u32);
    (shift(digits, exponent) - shift(nearest, other)) as f64 * 10_f64.powi(common - 35)
}

/// A number's first 36 digits, and the power of ten of the first one.
fn scaled(text: &str) -> (i128, i32) {
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let (sign, mantissa) = mantissa.strip_prefix('-').map_or((1, mantissa), |rest| (-1, rest));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = format!("{whole}{fraction}");
    let significant = digits.trim_start_matches('0');
    let leading = (digits.len() - significant.len()) as i32;
    let first = whole.len() as i32 - 1 - leading + exponent.parse::<i32>().unwrap();
    let padded = format!("{:0<36}", significant);
    (sign * padded[..36].parse::<i128>().unwrap(), first)
}

/// The README's tables of largest errors.
fn claims(readme: &Path) -> String {
    println!("cargo::rerun-if-changed={}", readme.display());
    let text = fs::read_to_string(readme).unwrap();
    let (mut functions, mut projections) = (String::new(), String::new());
    for line in text.lines() {
        let cells: Vec<_> = line.trim_matches('|').split('|').map(str::trim).collect();
        let numbers: Vec<f64> = cells.iter().filter_map(|cell| cell.parse().ok()).collect();
        match (cells.as_slice(), numbers.as_slice()) {
            ([name, _, _, _], [double, single]) => {
                writeln!(functions, "({name:?}, [{double:?}, {single:?}]),").unwrap();
            }
            ([name, ..], [a, b, c, d]) if cells.len() == 5 => {
                writeln!(projections, "({name:?}, [[{a:?}, {b:?}], [{c:?}, {d:?}]]),").unwrap();
            }
            _ => {}
        }
    }
    format!(
        "pub static CLAIMS: &[(&str, [f64; 2])] = &[{functions}];\n\
         pub static CLAIMS_OF_PROJECTIONS: &[(&str, [[f64; 2]; 2])] = &[{projections}];\n"
    )
}
