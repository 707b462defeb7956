//! What the speed of each function is held against.

use terrella::cube::Projection;
use terrella::geodesic::Method;

use crate::projection::{BYTES, Ground};
use crate::table::{Against, Bar, Section};
use timing::points::Pairing;
use timing::record::Record;

/// All records, and how to find some of them.
pub struct Bars<'a> {
    /// Terrella's.
    pub ours: &'a [Record],
    /// The rivals'.
    pub theirs: &'a [Record],
}

/// The auxiliary latitudes that `geodesy` has.
const LATITUDES: [&str; 5] = ["authalic", "conformal", "rectifying", "parametric", "geocentric"];

/// What a function on Earth-centred coordinates may be wrong by, in metres, to be called accurate.
const ACCURATE: f64 = 1e-3;

/// How many times as fast `f32` should be as `f64`.
const SINGLE: f64 = 2.0;

/// How many times the time of random pairs others may take.
const SPECIAL: f64 = 1.3;

/// Where a bar stands: its section, and its row and column if the section is a grid.
type Place = (Section, Option<[String; 2]>);

/// The comparisons for which both sides were measured.
#[derive(Default)]
struct List<'a>(Vec<Bar<'a>>);

impl<'a> List<'a> {
    fn add(&mut self, (section, cell): Place, what: &str, ours: Option<&'a Record>, against: Option<Against<'a>>) {
        if let (Some(ours), Some(against)) = (ours, against) {
            self.0.push(Bar {
                section,
                cell,
                what: what.to_owned(),
                ours,
                against,
            });
        }
    }

    /// At least so many times as fast as another.
    fn faster(&mut self, place: Place, what: &str, ours: Option<&'a Record>, other: Option<&'a Record>, times: f64) {
        self.add(place, what, ours, other.map(|other| Against::Faster(other, times)));
    }

    /// At most so many times the time of another.
    fn within(&mut self, place: Place, what: &str, ours: Option<&'a Record>, other: Option<&'a Record>, times: f64) {
        self.add(place, what, ours, other.map(|other| Against::Within(other, times)));
    }
}

fn cell(row: impl ToString, column: impl ToString) -> Option<[String; 2]> {
    Some([row.to_string(), column.to_string()])
}

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

    /// The fastest record of a library in `f64`, of whatever build and call.
    fn rival(&self, operation: &str, library: &str, method: &str, input: &str) -> Option<&'a Record> {
        self.rival_in("f64", operation, library, method, input)
    }

    fn rival_in(&self, scalar: &str, operation: &str, library: &str, method: &str, input: &str) -> Option<&'a Record> {
        let fits = |record: &&Record| {
            record.operation == operation
                && record.library.split(' ').next() == Some(library)
                && record.method.contains(method)
                && record.input == input
                && record.scalar == scalar
        };
        let fastest = |a: &&Record, b: &&Record| a.ns_min.total_cmp(&b.ns_min);
        self.theirs.iter().filter(fits).min_by(fastest)
    }

    /// All bars.
    pub fn all(&self) -> Vec<Bar<'a>> {
        let mut list = List::default();
        self.geodesics(&mut list);
        self.inputs(&mut list);
        self.places(&mut list);
        self.latitudes(&mut list);
        self.projections(&mut list);
        self.gnomonic(&mut list);
        self.singles(&mut list);
        list.0
    }

    fn geodesics(&self, list: &mut List<'a>) {
        let place = || (Section::Geodesics, None);
        let ours = |operation, method, mode, input| self.our(operation, method, "f64", mode, input);
        for (operation, input, times) in [
            ("inverse", "random", 30.0),
            ("inverse", "antipodal mix", 18.0),
            ("direct", "random", 6.0),
        ] {
            let theirs = self.rival(operation, "GeographicLib", "", input);
            let what = format!("GeographicLib, batch, {input}");
            list.faster(place(), &what, ours(operation, "karney", "batch", input), theirs, times);
        }
        for operation in ["inverse", "direct"] {
            for library in ["GeographicLib", "geographiclib-rs"] {
                let theirs = self.rival(operation, library, "", "random");
                let ours = ours(operation, "karney", "one by one", "random");
                list.faster(place(), &format!("{library}, one by one"), ours, theirs, 1.5);
            }
        }
        for (scalar, method, theirs, times) in [
            ("f64", "great-circle", "Haversine", 1.3),
            ("f32", "great-circle", "Haversine", 1.3),
            ("f64", "vincenty", "Vincenty", 3.0),
            ("f32", "vincenty", "Vincenty", 3.0),
        ] {
            let ours = self.our("distance", method, scalar, "batch", "random");
            let what = format!("NumKong's {theirs}, batch");
            let theirs = self.rival_in(scalar, "distance", "numkong", theirs, "random");
            list.faster(place(), &what, ours, theirs, times);
        }
        for (scalar, ns) in [("f64", 7.0), ("f32", 2.0)] {
            let ours = self.our("distance", "great-circle", scalar, "batch", "random");
            list.add(place(), "time in batch", ours, Some(Against::Nanoseconds(ns)));
        }
        for method in ["great-circle", "haversine"] {
            for (operation, call) in [("distance", "distance"), ("direct", "destination")] {
                let theirs = self.rival(operation, "geo", &format!("Haversine.{call}"), "random");
                let ours = ours(operation, method, "one by one", "random");
                list.faster(place(), "geo's Haversine, one by one", ours, theirs, 1.0);
            }
        }
        for (method, mode, input, times) in [
            ("vincenty", "batch", "random", 3.0),
            ("vincenty", "one by one", "random", 1.0),
            // Where it fails for most.
            ("karney", "one by one", "antipodal", 20.0),
        ] {
            let theirs = self.rival("distance", "geo", "vincenty", input);
            let what = format!("geo's Vincenty, {mode}, {input}");
            list.faster(place(), &what, ours("inverse", method, mode, input), theirs, times);
        }
    }

    fn inputs(&self, list: &mut List<'a>) {
        for method in Method::ALL {
            let ours = |input| self.our("inverse", method.name(), "f64", "batch", input);
            for pairing in Pairing::SPECIAL {
                let place = (Section::Inputs, cell(method, pairing.name()));
                let what = format!("random pairs; these are: {}", pairing.name());
                list.within(place, &what, ours(pairing.name()), ours("random"), SPECIAL);
            }
        }
    }

    fn places(&self, list: &mut List<'a>) {
        let place = || (Section::Places, None);
        let ours = |mode| self.our("ecef to geodetic", "Ellipsoid::to_geodetic", "f64", mode, "random");
        let rival = |library| self.rival("ecef to geodetic", library, "", "random");
        for (mode, times) in [("batch", 12.0), ("one by one", 2.0)] {
            let what = format!("GeographicLib, {mode}");
            list.faster(place(), &what, ours(mode), rival("GeographicLib"), times);
        }
        list.faster(place(), "Olson, one by one", ours("one by one"), rival("Olson"), 1.0);
        let accurate = self.theirs.iter().filter(|record| {
            // Of the crates, which are named in lower case.
            record.operation == "ecef to geodetic"
                && record.input == "random"
                && record.error < ACCURATE
                && record.library.starts_with(char::is_lowercase)
        });
        let fastest = accurate.min_by(|a, b| a.ns_min.total_cmp(&b.ns_min));
        let what = "the fastest accurate crate, one by one";
        list.faster(place(), what, ours("one by one"), fastest, 1.2);
    }

    fn latitudes(&self, list: &mut List<'a>) {
        for kind in LATITUDES {
            for (operation, way) in [("latitude", "from geodetic"), ("to geodetic latitude", "to geodetic")] {
                let operation = format!("{kind} {operation}");
                for (mode, times) in [("batch", 4.0), ("one by one", 1.0)] {
                    let ours = self.our(&operation, "Conversion::radians", "f64", mode, "random");
                    let theirs = self.rival(&operation, "geodesy", "", "random");
                    let place = (Section::Latitudes, cell(kind, format!("{way}, {mode}")));
                    list.faster(place, &format!("geodesy, {mode}"), ours, theirs, times);
                }
            }
        }
    }

    fn projected(&self, projection: Projection, way: &str, ground: Ground, mode: &str) -> Option<&'a Record> {
        let method = format!("{projection}; {}", ground.name());
        self.our(&format!("{projection} {way}"), &method, "f64", mode, "random")
    }

    fn projections(&self, list: &mut List<'a>) {
        let place = || (Section::Projections, None);
        let (qsc, s2q, adjusted, healpix) = (
            Projection::Quadrilateralized,
            Projection::S2Quadratic,
            Projection::Adjusted,
            Projection::Healpix,
        );
        for way in ["forward", "inverse"] {
            let ours = |projection, ground, mode| self.projected(projection, way, ground, mode);
            let rival = |projection: Projection, library, method| {
                self.rival(&format!("{projection} {way}"), library, method, "random")
            };
            for (mode, times) in [("batch", 32.0), ("one by one", 6.0)] {
                let what = format!("WCSLIB, {mode}");
                list.faster(
                    place(),
                    &what,
                    ours(qsc, Ground::Vector, mode),
                    rival(qsc, "WCSLIB", ""),
                    times,
                );
            }
            let single = ours(s2q, Ground::Vector, "one by one");
            list.faster(place(), "S2 in C++, one by one", single, rival(s2q, "S2", ""), 1.0);
            for (mode, times) in [("batch", 12.0), ("one by one", 3.0)] {
                for (ground, body, parameter) in [
                    (Ground::Sphere, "sphere", "+R=1"),
                    (Ground::Geocentric, "WGS84", "WGS84"),
                ] {
                    let what = format!("PROJ, {body}, {mode}");
                    let theirs = rival(qsc, "PROJ", parameter);
                    list.faster(place(), &what, ours(qsc, ground, mode), theirs, times);
                }
            }
            let many = ours(healpix, Ground::Sphere, "batch");
            list.faster(
                place(),
                "cdshealpix, batch",
                many,
                rival(healpix, "cdshealpix", ""),
                3.0,
            );
            for projection in [s2q, adjusted, Projection::Tangential, healpix] {
                let times = match (projection, way) {
                    (Projection::S2Quadratic | Projection::Adjusted, "forward") => 2.0,
                    _ => 3.0,
                };
                let ours = ours(projection, Ground::Sphere, "one by one");
                list.faster(
                    place(),
                    "PROJ, sphere, one by one",
                    ours,
                    rival(projection, "PROJ", "+R=1"),
                    times,
                );
            }
        }
    }

    fn gnomonic(&self, list: &mut List<'a>) {
        for &projection in &Projection::ALL[1..] {
            let times = match projection {
                Projection::Conformal | Projection::CobeExact => 20.0,
                _ => 6.0,
            };
            for way in ["forward", "inverse"] {
                let pass = |projection| self.projected(projection, way, Ground::Vector, "batch");
                let place = (Section::Gnomonic, cell(projection, way));
                list.within(
                    place,
                    "the gnomonic pass",
                    pass(projection),
                    pass(Projection::Tangential),
                    times,
                );
            }
        }
    }

    fn singles(&self, list: &mut List<'a>) {
        let is_single = |record: &&Record| {
            let is_bytes = BYTES.contains(&record.operation.as_str());
            // What holds about a place is timed in a field.
            let is_place = record.chart == "scene" && record.method == Method::Plane.name();
            let is_random = record.input == "random" || is_place;
            record.scalar == "f32" && record.mode == "batch" && is_random && !is_bytes
        };
        for single in self.ours.iter().filter(is_single) {
            let Record {
                operation,
                method,
                input,
                ..
            } = single;
            let double = self.our(operation, method, "f64", "batch", input);
            let place = match single.chart.as_str() {
                "projection" => {
                    let (projection, ground) = method.split_once("; ").unwrap_or_default();
                    let way = operation.rsplit(' ').next().unwrap_or_default();
                    (Section::SingleProjections, cell(projection, format!("{way}, {ground}")))
                }
                "position" => (Section::SinglePlaces, cell(format!("{operation}: {method}"), "times")),
                _ => (Section::SingleGeodesics, cell(method, operation)),
            };
            list.faster(place, "f64, batch", Some(single), double, SINGLE);
        }
    }
}
