//! The methods, this crate's and others', as one kind of thing: a pair of places in, a distance out.

use std::error::Error;

use geo::line_measures::{Distance, HaversineMeasure};
use geo::{Point, VincentyDistance};
use geo3d::WGS84;
use geographiclib_rs::InverseGeodesic;
use terrella::geodesic::{Geodesic, Method};
use terrella::{Ellipsoid, LatLon, Real};

use crate::pair::{Pair, Place, Scalar};

/// What a method takes the Earth for.
#[derive(Clone, Copy, PartialEq)]
pub enum Figure {
    /// No more than what surrounds the first place.
    Plane,
    Sphere,
    Ellipsoid,
}

/// A method in one precision.
pub struct Solver {
    pub name: &'static str,
    pub scalar: Scalar,
    pub figure: Figure,
    /// Its colour in the pictures.
    pub colour: &'static str,
    distance: Box<dyn Fn(Pair) -> Option<f64> + Send + Sync>,
}

impl Solver {
    fn new(
        name: &'static str,
        scalar: Scalar,
        figure: Figure,
        colour: &'static str,
        distance: impl Fn(Pair) -> Option<f64> + Send + Sync + 'static,
    ) -> Self {
        Self {
            name,
            scalar,
            figure,
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
    for &method in Method::ALL.iter().filter(|method| !method.needs_place()) {
        let (name, colour, figure) = shown(method);
        let (double, single) = (method.on(Ellipsoid::<f64>::WGS84)?, method.on(Ellipsoid::<f32>::WGS84)?);
        let double = move |pair| solve(&double, pair, |x| x);
        let single = move |pair| solve(&single, pair, |x| x as f32).map(f64::from);
        solvers.push(Solver::new(name, Scalar::F64, figure, colour, double));
        solvers.push(Solver::new(name, Scalar::F32, figure, colour, single));
    }
    Ok(solvers)
}

/// How a method is called and drawn, and what it takes the Earth for.
fn shown(method: Method) -> (&'static str, &'static str, Figure) {
    match method {
        Method::Haversine => ("Haversine", "#f39b4a", Figure::Sphere),
        Method::GreatCircle => ("Great circle", "#f2dd6e", Figure::Sphere),
        Method::Flat => ("Flat", "#9aa5b5", Figure::Plane),
        Method::Bowring => ("Bowring", "#c9a1f2", Figure::Plane),
        Method::Andoyer => ("Andoyer", "#6fb7f2", Figure::Ellipsoid),
        Method::AndoyerSecond => ("Andoyer, 2nd order", "#5bd6e0", Figure::Ellipsoid),
        Method::Vincenty => ("Vincenty", "#ef7fb4", Figure::Ellipsoid),
        Method::Karney => ("Karney", "#6fd98f", Figure::Ellipsoid),
        other => (other.name(), "#ffffff", Figure::Ellipsoid),
    }
}

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
    let other = |name, figure, distance: Box<dyn Fn(Pair) -> Option<f64> + Send + Sync>| {
        Solver::new(name, Scalar::F64, figure, COLOUR, distance)
    };
    vec![
        other(
            "geo, Haversine",
            Figure::Sphere,
            Box::new(move |pair| Some(sphere.distance(point(pair.from), point(pair.to)))),
        ),
        other(
            "geo3d, great_circle_distance_m",
            Figure::Sphere,
            Box::new(move |pair| Some(WGS84.great_circle_distance_m(position(pair.from), position(pair.to)))),
        ),
        other(
            "geo, vincenty_distance",
            Figure::Ellipsoid,
            Box::new(move |pair| point(pair.from).vincenty_distance(&point(pair.to)).ok()),
        ),
        other(
            "geo, Geodesic",
            Figure::Ellipsoid,
            Box::new(move |pair| Some(geo::Geodesic.distance(point(pair.from), point(pair.to)))),
        ),
        other(
            "geo3d, geodesic_inverse",
            Figure::Ellipsoid,
            Box::new(move |pair| {
                WGS84
                    .geodesic_inverse(position(pair.from), position(pair.to))
                    .map(|line| line.distance_m)
            }),
        ),
        other(
            GEOGRAPHICLIB,
            Figure::Ellipsoid,
            Box::new(move |pair| {
                let Pair { from, to } = pair;
                Some(library.inverse(from.lat, from.lon, to.lat, to.lon))
            }),
        ),
    ]
}

/// The crate that the others are measured against.
pub const GEOGRAPHICLIB: &str = "geographiclib-rs, inverse";
