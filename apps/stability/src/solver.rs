//! The methods, this crate's and others', as one kind of thing: a pair of places in, a distance out.

use std::error::Error;

use geo::line_measures::{Distance, HaversineMeasure};
use geo::{Point, VincentyDistance};
use geo3d::WGS84;
use geographiclib_rs::InverseGeodesic;
use terrella::geodesic::{Geodesic, Method, Profile, Surface};
use terrella::{Ellipsoid, LatLon, Real};

use crate::pair::{Pair, Place, Scalar};

/// A method in one precision.
pub struct Solver {
    pub name: &'static str,
    pub scalar: Scalar,
    pub surface: Surface,
    /// Its colour in the pictures.
    pub colour: &'static str,
    distance: Box<dyn Fn(Pair) -> Option<f64> + Send + Sync>,
}

impl Solver {
    fn new(
        name: &'static str,
        scalar: Scalar,
        surface: Surface,
        colour: &'static str,
        distance: impl Fn(Pair) -> Option<f64> + Send + Sync + 'static,
    ) -> Self {
        Self {
            name,
            scalar,
            surface,
            colour,
            distance: Box::new(distance),
        }
    }

    /// The distance in metres, none where the method reports an error or gives what is not a number. The pair is one that
    /// was rounded to the method's precision.
    pub fn distance(&self, pair: Pair) -> Option<f64> {
        (self.distance)(pair).filter(|d| d.is_finite())
    }
}

/// The radius that stands for the Earth on the sphere.
pub fn radius() -> f64 {
    Ellipsoid::<f64>::WGS84.mean_radius()
}

/// This crate's methods, each in both precisions.
pub fn ours() -> Result<Vec<Solver>, Box<dyn Error>> {
    let mut solvers = Vec::new();
    let methods = Method::ALL.iter().filter(|method| !method.needs_place());
    for (method, colour) in methods.zip(COLOURS.into_iter().cycle()) {
        let &Profile { title, surface, .. } = method.profile();
        let (double, single) = (method.on(Ellipsoid::<f64>::WGS84)?, method.on(Ellipsoid::<f32>::WGS84)?);
        let double = move |pair| solve(&double, pair, |x| x);
        let single = move |pair| solve(&single, pair, |x| x as f32).map(f64::from);
        solvers.push(Solver::new(title, Scalar::F64, surface, colour, double));
        solvers.push(Solver::new(title, Scalar::F32, surface, colour, single));
    }
    Ok(solvers)
}

/// The colours of this crate's methods, in their order.
const COLOURS: [&str; 8] = [
    "#9aa5b5", "#f2dd6e", "#6fb7f2", "#c9a1f2", "#f39b4a", "#6fd98f", "#5bd6e0", "#ef7fb4",
];

fn solve<T: Real>(method: &impl Geodesic<T>, pair: Pair, scalar: impl Fn(f64) -> T) -> Option<T> {
    let place = |p: Place| LatLon::new(scalar(p.lat), scalar(p.lon)).ok();
    Some(method.inverse(place(pair.from)?, place(pair.to)?).ok()?.distance)
}

/// What other crates offer.
pub fn theirs() -> Vec<Solver> {
    const COLOUR: &str = "#d5dae3";
    let point = |p: Place| Point::new(p.lon, p.lat);
    let position = |p: Place| geo3d::Geodetic::new(p.lat, p.lon, 0.0);
    let sphere = HaversineMeasure::new(radius());
    let library = geographiclib_rs::Geodesic::wgs84();
    let other = |name, surface, distance: Box<dyn Fn(Pair) -> Option<f64> + Send + Sync>| {
        Solver::new(name, Scalar::F64, surface, COLOUR, distance)
    };
    vec![
        other(
            "geo, Haversine",
            Surface::Sphere,
            Box::new(move |pair| Some(sphere.distance(point(pair.from), point(pair.to)))),
        ),
        other(
            "geo3d, great_circle_distance_m",
            Surface::Sphere,
            Box::new(move |pair| Some(WGS84.great_circle_distance_m(position(pair.from), position(pair.to)))),
        ),
        other(
            "geo, vincenty_distance",
            Surface::Ellipsoid,
            Box::new(move |pair| point(pair.from).vincenty_distance(&point(pair.to)).ok()),
        ),
        other(
            "geo, Geodesic",
            Surface::Ellipsoid,
            Box::new(move |pair| Some(geo::Geodesic.distance(point(pair.from), point(pair.to)))),
        ),
        other(
            "geo3d, geodesic_inverse",
            Surface::Ellipsoid,
            Box::new(move |pair| {
                WGS84
                    .geodesic_inverse(position(pair.from), position(pair.to))
                    .map(|line| line.distance_m)
            }),
        ),
        other(
            GEOGRAPHICLIB,
            Surface::Ellipsoid,
            Box::new(move |pair| {
                let Pair { from, to } = pair;
                Some(library.inverse(from.lat, from.lon, to.lat, to.lon))
            }),
        ),
    ]
}

/// The crate that the others are measured against.
pub const GEOGRAPHICLIB: &str = "geographiclib-rs, inverse";
