//! What the README claims about the errors, held against what was found.

use std::f64::consts::SQRT_2;

use terrella::cube::Projection;
use testkit::table;

use timing::points::WGS84_A;
use timing::record::{METRES_PER_FACE_UNIT, METRES_PER_RADIAN, Record};

/// Parts of a distance in `f32` beyond which the claims of geodesics count: that it is rounded.
const ROUNDING: f64 = 1.5e-7;

/// What the documentation of `GeodeticSeries` claims, in metres.
const SERIES: [(&str, [f64; 2]); 3] = [
    ("second_order", [0.4, 1.3]),
    ("third_order", [2.5e-3, 1.3]),
    ("fourth_order", [1e-7, 1.3]),
];

/// The largest error that is claimed, in metres. `None`: the method makes no such claim, or the pass no such result.
fn claim(record: &Record) -> Option<f64> {
    let single = usize::from(record.scalar == "f32");
    let of = |what: &str| table::claim(what)[single];
    // Of the longest lines in the truth.
    let rounding = |longest: f64| if single == 1 { ROUNDING * longest } else { 0.0 };
    let operation = record.operation.as_str();
    Some(match (record.chart.as_str(), operation) {
        ("distance", "inverse" | "distance") if record.method == "karney" => {
            of("Karney inverse, distance") + rounding(2.004e7)
        }
        ("distance", "inverse" | "distance") if record.method == "vincenty" => {
            of("Vincenty inverse, distance") + rounding(2.004e7)
        }
        ("distance", "direct") if record.method == "karney" => of("Karney direct, position") + rounding(2.1e7),
        ("position", "geodetic to ecef") => of("Ellipsoid::to_ecef to 50 000 km"),
        ("position", "ecef to geodetic") if record.method.starts_with("GeodeticSeries") => {
            SERIES.iter().find(|(order, _)| record.method.ends_with(order))?.1[single]
        }
        ("position", "ecef to geodetic") => of("Ellipsoid::to_geodetic to 50 000 km"),
        ("position", "lat lon to direction") => of("LatLon to Direction") * METRES_PER_RADIAN,
        ("position", _) if operation.contains("isometric") => return None,
        ("position", _) if operation.ends_with("to geodetic latitude") => of("geodetic latitude of another") * WGS84_A,
        ("position", _) if operation.ends_with("latitude") => of("latitude of a geodetic one") * WGS84_A,
        ("projection", _) => {
            let (name, ground) = record.method.split_once("; ")?;
            let projection: Projection = name.parse().ok()?;
            if ground != "unit vectors" {
                // The claim is of the ground. On a face it is up to twice as much, and near the corners of the conformal cube, which have
                // no scale, any number of times.
                let claim = of("LatLon to FacePoint and back, any projection and shift");
                let on_face = operation.ends_with("forward");
                return (!on_face || projection != Projection::Conformal).then_some(if on_face {
                    2.0 * claim
                } else {
                    claim
                });
            }
            let (forward, inverse) = table::claims_of(projection);
            if operation == format!("{projection} forward") {
                // Claimed of x and y each.
                SQRT_2 * forward[single] * METRES_PER_FACE_UNIT
            } else {
                inverse[single] * METRES_PER_RADIAN
            }
        }
        _ => return None,
    })
}

/// Every record whose error is not a number, or larger than claimed; but those of scenes, which have bounds in place of errors.
pub fn broken(records: &[Record]) -> Vec<String> {
    let complaint = |record: &Record| {
        let of = record.key().join(" ");
        match claim(record) {
            Some(claim) if record.error.is_nan() || record.error > claim => Some(format!(
                "{of}: an error of {:e} m is over the claimed {claim:e} m",
                record.error
            )),
            None if !record.error.is_finite() && !record.operation.starts_with("bytes") && record.chart != "scene" => {
                Some(format!("{of}: an error of {} m", record.error))
            }
            _ => None,
        }
    };
    records.iter().filter_map(complaint).collect()
}
