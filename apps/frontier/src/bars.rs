//! What the speed of each function is held against, as a table.

use std::fmt::Write;

use terrella::cube::Projection;

use crate::bench::OURS;
use crate::projection::Ground;
use timing::record::Record;

/// A comparison of two records.
struct Bar<'a> {
    what: String,
    ours: &'a Record,
    other: &'a Record,
    /// How many times as fast as the other ours should be.
    wanted: f64,
}

/// All records, and how to find some of them.
pub struct Bars<'a> {
    /// Terrella's.
    pub ours: &'a [Record],
    /// The rivals'.
    pub theirs: &'a [Record],
    /// Whether a rival's record was measured beside terrella's.
    pub now: &'a dyn Fn(&Record) -> bool,
}

/// The auxiliary latitudes that `geodesy` has.
const LATITUDES: [&str; 5] = ["authalic", "conformal", "rectifying", "parametric", "geocentric"];

/// What a function on Earth-centred coordinates may be wrong by, in metres, to be called accurate.
const ACCURATE: f64 = 1e-3;

impl<'a> Bars<'a> {
    fn our(&self, operation: &str, method: &str, scalar: &str, mode: &str, input: &str) -> Option<&'a Record> {
        self.ours.iter().find(|record| {
            [
                record.operation.as_str(),
                &record.method,
                &record.scalar,
                &record.mode,
                &record.input,
            ] == [operation, method, scalar, mode, input]
        })
    }

    /// The fastest record of a library, of whatever build and call.
    fn rival(&self, operation: &str, library: &str, method: &str, input: &str) -> Option<&'a Record> {
        let fits = |record: &&Record| {
            record.operation == operation
                && record.library.split(' ').next() == Some(library)
                && record.method.contains(method)
                && record.input == input
        };
        let fastest = |a: &&Record, b: &&Record| a.ns_min.total_cmp(&b.ns_min);
        self.theirs.iter().filter(fits).min_by(fastest)
    }

    /// All comparisons for which both sides were measured.
    fn all(&self) -> Vec<Bar<'a>> {
        let mut bars = Vec::new();
        let mut add = |what: String, ours: Option<&'a Record>, other: Option<&'a Record>, wanted: f64| {
            if let (Some(ours), Some(other)) = (ours, other) {
                bars.push(Bar {
                    what,
                    ours,
                    other,
                    wanted,
                });
            }
        };
        let projected = |projection: Projection, direction: usize, ground: Ground, scalar: &str, mode: &str| {
            let operation = format!("{projection} {}", ["forward", "inverse"][direction]);
            self.our(
                &operation,
                &format!("{projection}; {}", ground.name()),
                scalar,
                mode,
                "random",
            )
        };

        for direction in [0, 1] {
            let gnomonic = projected(Projection::Tangential, direction, Ground::Vector, "f64", "batch");
            for &projection in &Projection::ALL[1..] {
                let times = match projection {
                    Projection::Conformal | Projection::CobeExact => 20.0,
                    _ => 6.0,
                };
                let ours = projected(projection, direction, Ground::Vector, "f64", "batch");
                add(
                    format!("at most {times} × the gnomonic pass"),
                    ours,
                    gnomonic,
                    1.0 / times,
                );
            }
        }
        for (direction, word) in ["forward", "inverse"].into_iter().enumerate() {
            let ours = |projection, ground, mode| projected(projection, direction, ground, "f64", mode);
            let rival = |projection: &str, library, method| {
                self.rival(&format!("{projection} {word}"), library, method, "random")
            };
            let (qsc, s2q, healpix) = (
                Projection::Quadrilateralized,
                Projection::S2Quadratic,
                Projection::Healpix,
            );
            for (mode, wanted) in [("batch", 30.0), ("one by one", 6.0)] {
                add(
                    format!("WCSLIB, {mode}"),
                    ours(qsc, Ground::Vector, mode),
                    rival("quadrilateralized", "WCSLIB", ""),
                    wanted,
                );
            }
            add(
                "S2 in C++".to_owned(),
                ours(s2q, Ground::Vector, "one by one"),
                rival("s2-quadratic", "S2", ""),
                1.0,
            );
            for (mode, wanted) in [("batch", 12.0), ("one by one", 3.0)] {
                add(
                    format!("PROJ, sphere, {mode}"),
                    ours(qsc, Ground::Sphere, mode),
                    rival("quadrilateralized", "PROJ", "+R=1"),
                    wanted,
                );
                let wgs84 = rival("quadrilateralized", "PROJ", "WGS84");
                add(
                    format!("PROJ, WGS84, {mode}"),
                    ours(qsc, Ground::Geocentric, mode),
                    wgs84,
                    wanted,
                );
            }
            add(
                "cdshealpix, batch".to_owned(),
                ours(healpix, Ground::Sphere, "batch"),
                rival("healpix", "cdshealpix", ""),
                3.0,
            );
            for projection in [s2q, Projection::Adjusted, Projection::Tangential, healpix] {
                let proj = rival(projection.name(), "PROJ", "+R=1");
                add(
                    "PROJ, one by one".to_owned(),
                    ours(projection, Ground::Sphere, "one by one"),
                    proj,
                    3.0,
                );
            }
        }

        let geodesic = |operation, method, mode, input| self.our(operation, method, "f64", mode, input);
        for (operation, input, batch) in [
            ("inverse", "random", 6.0),
            ("inverse", "antipodal mix", 3.0),
            ("direct", "random", 6.0),
        ] {
            let theirs = self.rival(operation, "GeographicLib", "", input);
            add(
                format!("GeographicLib, batch, {input}"),
                geodesic(operation, "karney", "batch", input),
                theirs,
                batch,
            );
        }
        for operation in ["inverse", "direct"] {
            for library in ["GeographicLib", "geographiclib-rs"] {
                let theirs = self.rival(operation, library, "", "random");
                let ours = geodesic(operation, "karney", "one by one", "random");
                add(format!("{library}, one by one, random"), ours, theirs, 1.5);
            }
        }
        for (method, mode, input, wanted) in [
            ("vincenty", "batch", "random", 3.0),
            ("vincenty", "one by one", "random", 1.0),
            // Where it fails for most.
            ("karney", "one by one", "antipodal", 20.0),
        ] {
            let theirs = self.rival("distance", "geo", "vincenty", input);
            add(
                format!("geo's Vincenty, {mode}, {input}"),
                geodesic("inverse", method, mode, input),
                theirs,
                wanted,
            );
        }

        let ecef = |mode| self.our("ecef to geodetic", "Ellipsoid::to_geodetic", "f64", mode, "random");
        for (mode, wanted) in [("batch", 10.0), ("one by one", 2.0)] {
            let theirs = self.rival("ecef to geodetic", "GeographicLib", "", "random");
            add(format!("GeographicLib, {mode}"), ecef(mode), theirs, wanted);
        }
        let accurate = self.theirs.iter().filter(|record| {
            // Of the crates, which are named in lower case.
            record.operation == "ecef to geodetic"
                && record.input == "random"
                && record.error < ACCURATE
                && record.library.starts_with(char::is_lowercase)
        });
        let fastest = accurate.min_by(|a, b| a.ns_min.total_cmp(&b.ns_min));
        add(
            "the fastest accurate crate, one by one".to_owned(),
            ecef("one by one"),
            fastest,
            1.2,
        );

        for kind in LATITUDES {
            for operation in [format!("{kind} latitude"), format!("{kind} to geodetic latitude")] {
                for (mode, wanted) in [("batch", 4.0), ("one by one", 1.0)] {
                    let ours = self.our(&operation, "Conversion::radians", "f64", mode, "random");
                    add(
                        format!("geodesy, {mode}"),
                        ours,
                        self.rival(&operation, "geodesy", "", "random"),
                        wanted,
                    );
                }
            }
        }

        for single in self
            .ours
            .iter()
            .filter(|r| r.scalar == "f32" && r.mode == "batch" && r.input == "random")
        {
            let is_bytes = single.operation.starts_with("bytes");
            let double = self.our(&single.operation, &single.method, "f64", "batch", "random");
            add(
                "f32 against f64, batch".to_owned(),
                Some(single),
                double.filter(|_| !is_bytes),
                1.7,
            );
        }
        bars
    }

    /// The table, and under it what was not met.
    pub fn markdown(&self) -> String {
        let mut text = String::from(
            "| terrella | against | ns | other | measured | times as fast | wanted | |\n|---|---|--:|--:|---|--:|--:|---|\n",
        );
        let bars = self.all();
        let mut short = Vec::new();
        for bar in &bars {
            let Bar {
                what,
                ours,
                other,
                wanted,
            } = bar;
            let ratio = other.ns_min / ours.ns_min;
            let met = ratio >= *wanted;
            let measured = match other.library == OURS || (self.now)(other) {
                true => "now",
                false => "kept",
            };
            let line = format!(
                "| {}: {} | {what} | {:.2} | {:.2} | {measured} | {ratio:.2} | {wanted:.2} | {} |",
                ours.operation,
                ours.method,
                ours.ns_min,
                other.ns_min,
                if met { "met" } else { "NOT MET" }
            );
            let _ = writeln!(text, "{line}");
            if !met {
                short.push(line);
            }
        }
        let _ = writeln!(
            text,
            "\n{} of {} met. \"now\": measured in this run or given as just measured; \"kept\": from benches/peers/peers.csv, taken in another run.",
            bars.len() - short.len(),
            bars.len()
        );
        if !short.is_empty() {
            let _ = writeln!(text, "\nNot met:\n\n{}", short.join("\n"));
        }
        text
    }
}
