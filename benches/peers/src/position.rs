//! Earth-centred coordinates both ways on WGS84, and auxiliary latitudes.

use geodesy::prelude::*;
use nav_types::{ECEF, WGS84};
use sguaba::builder::wgs84::Components;
use sguaba::systems::{Ecef, Wgs84};
use sguaba::{Coordinate, coordinate};
use uom::si::f64::{Angle, Length};
use uom::si::{angle::radian, length::meter};

use crate::bench::{Bench, Task};
use crate::distance::displacement;
use crate::pass::{Pass, Set, each};
use crate::shim::Shim;
use crate::truth::{Exact, Truth};
use crate::{Unit, one_by_one};
use timing::points::{N, Order, WGS84_A, lat_lons, positions};

/// Heights of less are of no use to anybody, and most libraries do not claim them.
const DEEPEST: f64 = -10_000.0;

/// Whether latitude comes before longitude.
#[derive(Clone, Copy, PartialEq)]
enum First {
    Latitude,
    Longitude,
}

impl First {
    fn columns(self, lat: Vec<f64>, lon: Vec<f64>, height: Vec<f64>) -> Set {
        Set::new(match self {
            Self::Latitude => vec![lat, lon, height],
            Self::Longitude => vec![lon, lat, height],
        })
    }
}

fn to_ecef(unit: Unit, first: First) -> Task {
    let set = |order| {
        let p = positions(order, N);
        unit.of(first.columns(p.lat, p.lon, p.height), &[0, 1])
    };
    let truth = Truth::read("ecef_forward_wgs84").keep("h", high);
    let axes = ["X", "Y", "Z"].map(|name| truth.exact(name));
    Task {
        chart: "position",
        operation: "geodetic to ecef".to_owned(),
        inputs: Order::ALL.map(|order| (order.name(), set(order))).into(),
        truth: unit.of(
            first.columns(truth.values("lat"), truth.values("lon"), truth.values("h")),
            &[0, 1],
        ),
        error: Box::new(move |i, room| {
            let off = [0, 1, 2].map(|k: usize| Exact::from(room.columns[k][i]).minus(axes[k][i]));
            Some(off[0].hypot(off[1]).hypot(off[2]))
        }),
    }
}

fn to_geodetic(unit: Unit, first: First) -> Task {
    let set = |order| {
        let p = positions(order, N);
        Set::new(vec![p.x, p.y, p.z])
    };
    let truth = Truth::read("ecef_reverse_wgs84").keep("h", high);
    let [lat, lon, height] = ["lat", "lon", "h"].map(|name| truth.exact(name));
    let (lat_at, lon_at) = if first == First::Latitude { (0, 1) } else { (1, 0) };
    Task {
        chart: "position",
        operation: "ecef to geodetic".to_owned(),
        inputs: Order::ALL.map(|order| (order.name(), set(order))).into(),
        truth: Set::new(vec![truth.values("X"), truth.values("Y"), truth.values("Z")]),
        error: Box::new(move |i, room| {
            let lat_off = unit.degrees(room.columns[lat_at][i]).minus(lat[i]);
            let lon_off = unit.degrees(room.columns[lon_at][i]).minus(lon[i]);
            let up = Exact::from(room.columns[2][i]).minus(height[i]);
            Some(displacement(lat_off, lon_off, lat[i].value, height[i].value).hypot(up))
        }),
    }
}

/// The crate sguaba's place, of radians and metres.
pub fn place(lat: f64, lon: f64, height: f64) -> Option<Wgs84> {
    Wgs84::build(Components {
        latitude: Angle::new::<radian>(lat),
        longitude: Angle::new::<radian>(lon),
        altitude: Length::new::<meter>(height),
    })
}

fn high(height: &str) -> bool {
    height.parse::<f64>().expect("a number") >= DEEPEST
}

/// From geodetic latitude to the one named, in the unit of the library, which may have it `scale` times as large.
fn from_geodetic(kind: &str, unit: Unit, scale: f64) -> Task {
    let truth = Truth::read(match unit {
        Unit::Degrees => "auxlat_wgs84_deg",
        Unit::Radians => "auxlat_wgs84_rad",
    });
    let auxiliary = truth.exact(kind).iter().map(|value| value.times(scale)).collect();
    latitude_task(format!("{kind} latitude"), unit, truth.values("phi"), auxiliary)
}

/// From the latitude named to the geodetic. The truth is in radians: for a library in degrees, or with a scale, its inputs
/// are rounded.
fn from_auxiliary(kind: &str, unit: Unit, scale: f64) -> Task {
    let truth = Truth::read("auxlat_inverse_wgs84_rad").keep("kind", |other| other == kind);
    let inputs: Vec<f64> = truth.values("value").iter().map(|value| value * scale).collect();
    let phi = truth.exact("phi");
    match unit {
        Unit::Radians => latitude_task(format!("{kind} to geodetic latitude"), unit, inputs, phi),
        Unit::Degrees => {
            let inputs = inputs.iter().map(|value| value.to_degrees()).collect();
            let phi = phi.iter().map(|phi| Exact::degrees_of(*phi)).collect();
            latitude_task(format!("{kind} to geodetic latitude"), unit, inputs, phi)
        }
    }
}

fn latitude_task(operation: String, unit: Unit, inputs: Vec<f64>, truth: Vec<Exact>) -> Task {
    let metres = match unit {
        Unit::Degrees => WGS84_A.to_radians(),
        Unit::Radians => WGS84_A,
    };
    Task {
        chart: "position",
        operation,
        inputs: Order::ALL
            .map(|order| (order.name(), unit.of(Set::new(vec![lat_lons(order, N).lat]), &[0])))
            .into(),
        truth: Set::new(vec![inputs]),
        error: Box::new(move |i, room| Some(Exact::from(room.columns[0][i]).minus(truth[i]).abs() * metres)),
    }
}

/// The auxiliary latitudes that rivals have, but for the isometric.
const KINDS: [&str; 5] = ["authalic", "conformal", "rectifying", "parametric", "geocentric"];

/// Runs the chart.
pub fn run(bench: &mut Bench) {
    for shim in Shim::all("geographiclib", "GeographicLib") {
        let (out, back) = (
            to_ecef(Unit::Degrees, First::Latitude),
            to_geodetic(Unit::Degrees, First::Latitude),
        );
        one_by_one(bench, &out, &shim, "Geocentric::Forward", "to_ecef");
        one_by_one(bench, &back, &shim, "Geocentric::Reverse", "to_geodetic");
        for kind in KINDS {
            one_by_one(
                bench,
                &from_geodetic(kind, Unit::Degrees, 1.0),
                &shim,
                "Ellipsoid",
                kind,
            );
            one_by_one(
                bench,
                &from_auxiliary(kind, Unit::Degrees, 1.0),
                &shim,
                "Ellipsoid",
                &format!("{kind}_inverse"),
            );
        }
    }
    for shim in Shim::all("proj", "PROJ") {
        let (out, back) = (
            to_ecef(Unit::Radians, First::Longitude),
            to_geodetic(Unit::Radians, First::Longitude),
        );
        for (mode, method, suffix) in [
            ("one by one", "+proj=cart +ellps=WGS84; proj_trans", ""),
            ("batch", "+proj=cart +ellps=WGS84; proj_trans_generic", "_batch"),
        ] {
            bench.run(
                &out,
                &shim.library,
                method,
                mode,
                &shim.pass(&format!("to_ecef{suffix}")),
            );
            bench.run(
                &back,
                &shim.library,
                method,
                mode,
                &shim.pass(&format!("to_geodetic{suffix}")),
            );
        }
    }
    for shim in Shim::alone("olson", "Olson") {
        let back = to_geodetic(Unit::Radians, First::Latitude);
        one_by_one(bench, &back, &shim, "latlon", "to_geodetic");
    }

    let mut run = |task: &Task, library: &str, method: &str, pass: Pass| {
        bench.run(task, library, method, "one by one", &pass);
    };
    let out = to_ecef(Unit::Degrees, First::Latitude);
    let back = to_geodetic(Unit::Degrees, First::Latitude);
    let out_radians = to_ecef(Unit::Radians, First::Latitude);
    let back_radians = to_geodetic(Unit::Radians, First::Latitude);

    let library = crate::crate_version("geo3d");
    run(
        &out,
        &library,
        "to_ecef",
        each(|[lat, lon, height]| {
            let e = geo3d::WGS84.to_ecef(geo3d::Geodetic::new(lat, lon, height));
            [e.x, e.y, e.z]
        }),
    );
    run(
        &back,
        &library,
        "to_geodetic",
        each(|[x, y, z]| {
            let g = geo3d::WGS84.to_geodetic(geo3d::Ecef::new(x, y, z));
            [g.lat_deg, g.lon_deg, g.height_m]
        }),
    );

    let library = crate::crate_version("nav-types");
    run(
        &out_radians,
        &library,
        "ECEF::from(WGS84)",
        each(|[lat, lon, height]| {
            let e = ECEF::from(WGS84::from_radians_and_meters(lat, lon, height));
            [e.x(), e.y(), e.z()]
        }),
    );
    run(
        &back_radians,
        &library,
        "WGS84::from(ECEF)",
        each(|[x, y, z]| {
            let g = WGS84::from(ECEF::new(x, y, z));
            [g.latitude_radians(), g.longitude_radians(), g.altitude()]
        }),
    );

    let library = crate::crate_version("sguaba");
    run(
        &out_radians,
        &library,
        "Coordinate::from_wgs84",
        each(|[lat, lon, height]| {
            let Some(place) = place(lat, lon, height) else {
                return [f64::NAN; 3];
            };
            Coordinate::<Ecef>::from_wgs84(&place)
                .to_cartesian()
                .map(|length| length.get::<meter>())
        }),
    );
    let here = |x, y, z| -> Coordinate<Ecef> {
        coordinate! { x = Length::new::<meter>(x), y = Length::new::<meter>(y), z = Length::new::<meter>(z) }
    };
    let parts = |g: Wgs84| {
        [
            g.latitude().get::<radian>(),
            g.longitude().get::<radian>(),
            g.altitude().get::<meter>(),
        ]
    };
    run(
        &back_radians,
        &library,
        "to_wgs84",
        each(move |[x, y, z]| parts(here(x, y, z).to_wgs84())),
    );
    run(
        &back_radians,
        &library,
        "to_wgs84_extended",
        each(move |[x, y, z]| parts(here(x, y, z).to_wgs84_extended())),
    );
    run(
        &back_radians,
        &library,
        "to_wgs84_fast (meant for -10 to 50 km)",
        each(move |[x, y, z]| parts(here(x, y, z).to_wgs84_fast())),
    );

    let library = crate::crate_version("geodesy");
    let earth = || Ellipsoid::named("WGS84").expect("a known ellipsoid");
    let wgs84 = earth();
    run(
        &to_ecef(Unit::Radians, First::Longitude),
        &library,
        "cartesian",
        each(move |[lon, lat, height]| {
            let e = wgs84.cartesian(&Coor3D::raw(lon, lat, height));
            [e[0], e[1], e[2]]
        }),
    );
    let wgs84 = earth();
    run(
        &to_geodetic(Unit::Radians, First::Longitude),
        &library,
        "geographic",
        each(move |[x, y, z]| {
            let g = wgs84.geographic(&Coor3D::raw(x, y, z));
            [g[0], g[1], g[2]]
        }),
    );
    for kind in KINDS {
        // Its rectifying latitude is 90° at the pole times the quarter meridian over π/2 a.
        let scale = match kind {
            "rectifying" => earth().coefficients_for_rectifying_latitude_computations().etc[0],
            _ => 1.0,
        };
        let (there, back) = latitudes(kind);
        run(&from_geodetic(kind, Unit::Radians, scale), &library, "Latitudes", there);
        run(&from_auxiliary(kind, Unit::Radians, scale), &library, "Latitudes", back);
    }
}

/// The crate geodesy's functions to and from a latitude.
fn latitudes(kind: &str) -> (Pass, Pass) {
    let [e, f] = [(); 2].map(|()| Ellipsoid::named("WGS84").expect("a known ellipsoid"));
    match kind {
        "authalic" => {
            let [c, d] = [(); 2].map(|()| e.coefficients_for_authalic_latitude_computations());
            (
                each(move |[phi]| [e.latitude_geographic_to_authalic(phi, &c)]),
                each(move |[phi]| [f.latitude_authalic_to_geographic(phi, &d)]),
            )
        }
        "conformal" => {
            let [c, d] = [(); 2].map(|()| e.coefficients_for_conformal_latitude_computations());
            (
                each(move |[phi]| [e.latitude_geographic_to_conformal(phi, &c)]),
                each(move |[phi]| [f.latitude_conformal_to_geographic(phi, &d)]),
            )
        }
        "rectifying" => {
            let [c, d] = [(); 2].map(|()| e.coefficients_for_rectifying_latitude_computations());
            (
                each(move |[phi]| [e.latitude_geographic_to_rectifying(phi, &c)]),
                each(move |[phi]| [f.latitude_rectifying_to_geographic(phi, &d)]),
            )
        }
        "parametric" => (
            each(move |[phi]| [e.latitude_geographic_to_reduced(phi)]),
            each(move |[phi]| [f.latitude_reduced_to_geographic(phi)]),
        ),
        _ => (
            each(move |[phi]| [e.latitude_geographic_to_geocentric(phi)]),
            each(move |[phi]| [f.latitude_geocentric_to_geographic(phi)]),
        ),
    }
}
