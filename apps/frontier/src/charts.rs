//! Which records stand on which chart.

use terrella::Latitude;
use terrella::cube::Projection;

use crate::bench::OURS;
use crate::chart::{Mark, Panel};
use crate::projection::BYTES;
use timing::record::Record;

/// A chart: the stem of its file, its title, its panels.
pub struct Chart {
    pub file: &'static str,
    pub title: &'static str,
    /// Of each plot.
    pub height: f64,
    pub panels: Vec<Panel>,
}

/// All three, of terrella's records and the rivals'.
pub fn all(records: &[Record]) -> Vec<Chart> {
    let projections: Vec<String> = Projection::ALL
        .iter()
        .map(|projection| projection.name().to_owned())
        .collect();
    let latitudes: Vec<String> = Latitude::ALL[1..]
        .iter()
        .map(|latitude| latitude.name().to_owned())
        .collect();
    let of = |chart: &str, input: &str, operations: &dyn Fn(&str) -> bool| -> Vec<&Record> {
        let wanted = records.iter().filter(|record| {
            record.chart == chart && record.input == input && operations(&record.operation) && record.error.is_finite()
        });
        wanted.collect()
    };
    let distance = |title: &str, input: &str, operation: &str| {
        let records = of("distance", input, &|other| other == operation);
        named(title, &records, distance_name)
    };
    let position = |title: &str, operations: &dyn Fn(&str) -> bool| {
        let records = of("position", "random", operations);
        named(title, &records, position_name)
    };
    let is_back = |operation: &str| operation.ends_with("to geodetic latitude");
    let latitude = |title: &str, operations: &dyn Fn(&str) -> bool| {
        let records = of("position", "random", operations);
        numbered(title, &records, Vec::new(), &latitudes, latitude_name)
    };
    let projection = |title: &str, direction: &str, ground: &str| {
        let mut found = of("projection", "random", &|operation| operation.ends_with(direction));
        found.retain(|record| format!("{};", record.method).contains(&format!("; {ground};")));
        let bytes = records.iter().filter(|record| {
            ground == "unit vectors"
                && BYTES.contains(&record.operation.as_str())
                && record.operation.ends_with(direction)
                && record.input == "random"
        });
        let guides = bytes.map(|record| (record.ns_min, format!("moves the bytes, {}", record.scalar)));
        numbered(title, &found, guides.collect(), &projections, projection_name)
    };
    vec![
        Chart {
            file: "distances",
            title: "Geodesics on WGS84: time per point and largest error",
            height: 600.0,
            panels: vec![
                distance("Distance alone, of random pairs", "random", "distance"),
                distance("Distance and both azimuths, of random pairs", "random", "inverse"),
                distance(
                    "Distance and both azimuths, 20 % of the pairs nearly antipodal",
                    "antipodal mix",
                    "inverse",
                ),
                distance("Ends of random lines of up to 20 000 km", "random", "direct"),
            ],
        },
        Chart {
            file: "projections",
            title: "Cube projections: time per point and largest error",
            height: 600.0,
            panels: vec![
                projection("Forward, from unit vectors", "forward", "unit vectors"),
                projection("Inverse, to unit vectors", "inverse", "unit vectors"),
                projection(
                    "Forward, from latitude and longitude of the sphere",
                    "forward",
                    "lat lon",
                ),
                projection("Inverse, to latitude and longitude of the sphere", "inverse", "lat lon"),
            ],
        },
        Chart {
            file: "positions",
            title: "Earth-centred coordinates, latitudes, directions: time per point and largest error",
            height: 380.0,
            panels: vec![
                position("Earth-centred coordinates to latitude, longitude and height", &|o| {
                    o == "ecef to geodetic"
                }),
                position("Latitude, longitude and height to Earth-centred coordinates", &|o| {
                    o == "geodetic to ecef"
                }),
                latitude("Auxiliary latitudes of the geodetic one", &|o| {
                    o.ends_with("latitude") && !is_back(o)
                }),
                latitude("The geodetic latitude of auxiliary ones", &is_back),
                position("Latitude and longitude of the sphere, and unit vectors", &|o| {
                    o.contains("direction")
                }),
            ],
        },
    ]
}

fn mark(record: &Record, label: String) -> Mark {
    let label = match record.failures {
        0.0 => label,
        share if share < 1e-3 => format!("{label} ({:.3} % fail)", 100.0 * share),
        share => format!("{label} ({:.0} % fail)", 100.0 * share),
    };
    Mark {
        label,
        ns: record.ns_min,
        error: record.error,
        ours: record.library == OURS,
        single: record.scalar == "f32",
        batch: record.mode == "batch",
        failures: record.failures,
    }
}

/// A panel with a name beside each mark. Of a rival's builds the fastest stands for all; a record without a name is left out.
fn named(title: &str, records: &[&Record], name: impl Fn(&Record) -> Option<String>) -> Panel {
    let labelled: Vec<_> = records
        .iter()
        .filter_map(|record| Some((*record, name(record)?)))
        .collect();
    let marks = fastest(labelled).into_iter().map(|(record, label)| mark(record, label));
    Panel {
        title: title.to_owned(),
        marks: marks.collect(),
        guides: Vec::new(),
        key: Vec::new(),
    }
}

/// Of the records of a name, scalar and mode the fastest.
fn fastest(labelled: Vec<(&Record, String)>) -> Vec<(&Record, String)> {
    let mut kept: Vec<(&Record, String)> = Vec::new();
    for (record, label) in labelled {
        let same = |(other, name): &&mut (&Record, String)| {
            *name == label
                && (&other.scalar, &other.mode, other.library == OURS)
                    == (&record.scalar, &record.mode, record.library == OURS)
        };
        match kept.iter_mut().find(same) {
            Some((other, _)) if record.ns_min < other.ns_min => *other = record,
            Some(_) => {}
            None => kept.push((record, label)),
        }
    }
    kept
}

/// The name of a library without its version.
fn library(record: &Record) -> &str {
    record.library.split(' ').next().unwrap_or_default()
}

fn distance_name(record: &Record) -> Option<String> {
    let library = library(record);
    let method = record.method.split('.').next().unwrap_or_default();
    Some(match library {
        OURS => record.method.clone(),
        "geo" => format!("geo {method}"),
        "numkong" => format!("NumKong {}", record.method),
        "geodesy" => "geodesy Vincenty".to_owned(),
        "sguaba" => "sguaba haversine".to_owned(),
        _ => library.to_owned(),
    })
}

fn position_name(record: &Record) -> Option<String> {
    let library = library(record);
    let operation = record.operation.as_str();
    Some(if operation.contains("direction") {
        operation.to_owned()
    } else if library == OURS {
        match record.method.strip_prefix("GeodeticSeries::") {
            Some(order) => format!("series, {}", order.replace('_', " ")),
            None => OURS.to_owned(),
        }
    } else if record.method.contains("_fast") || record.method.contains("_extended") {
        let method = record.method.split(' ').next().unwrap_or_default();
        format!("{library} {method}")
    } else {
        library.to_owned()
    })
}

/// A panel of numbers for what terrella has and letters for what its rivals have, with a key that begins with terrella's names.
fn numbered(
    title: &str,
    records: &[&Record],
    guides: Vec<(f64, String)>,
    ours: &[String],
    name: impl Fn(&Record) -> Option<String>,
) -> Panel {
    let number = |(name, number): (&String, i32)| (number.to_string(), name.clone());
    let mut key: Vec<(String, String)> = ours.iter().zip(1..).map(number).collect();
    let mut labelled = Vec::new();
    for &record in records {
        let Some(long) = name(record) else { continue };
        let short = match key.iter().find(|(_, name)| *name == long) {
            Some((short, _)) => short.clone(),
            None => {
                let letter = char::from(b'a' + (key.len() - ours.len()) as u8).to_string();
                key.push((letter.clone(), long));
                letter
            }
        };
        labelled.push((record, short));
    }
    let marks = fastest(labelled).into_iter().map(|(record, label)| mark(record, label));
    Panel {
        title: title.to_owned(),
        marks: marks.collect(),
        guides,
        key,
    }
}

fn projection_name(record: &Record) -> Option<String> {
    let (projection, _) = record.operation.split_once(' ')?;
    Some(match library(record) {
        OURS => projection.to_owned(),
        "S2" => format!("S2 (C++): {projection}"),
        "s2" => format!("s2 (crate): {projection}"),
        other => format!("{other}: {projection}"),
    })
}

fn latitude_name(record: &Record) -> Option<String> {
    let (kind, _) = record.operation.split_once(' ')?;
    Some(match library(record) {
        OURS => kind.to_owned(),
        other => format!("{other}: {kind}"),
    })
}
