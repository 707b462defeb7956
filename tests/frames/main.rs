//! Positions with height to Earth axes and back, and the local frames.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod accuracy;
mod extremes;
mod local;
mod nearest;
mod offset;
mod round_trip;
mod series;

use terrella::{Ecef, Ellipsoid, Geodetic, LatLon};
use testkit::truth::Scalar;

/// The ellipsoids of the truth files.
const ELLIPSOIDS: [&str; 4] = ["wgs84", "moon", "oblate10", "prolate150"];

/// An ellipsoid of the truth files by name.
fn ellipsoid<T: Scalar>(name: &str) -> Ellipsoid<T> {
    match name {
        "oblate10" => Ellipsoid::new(T::of(6.4e6), T::of(0.1)).unwrap(),
        "oblate151" => Ellipsoid::new(T::of(6.4e6), T::of(1.0 / 151.0)).unwrap(),
        "prolate150" => Ellipsoid::new(T::of(6.4e6), T::of(-1.0 / 150.0)).unwrap(),
        _ => Ellipsoid::named(name).unwrap(),
    }
}

fn geodetic<T: Scalar>(lat: T, lon: T, height: T) -> Geodetic<T> {
    Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap()
}

fn ecef<T: Scalar>(x: T, y: T, z: T) -> Ecef<T> {
    Ecef::new(x, y, z).unwrap()
}

/// The length of a vector.
fn length(vector: &[f64]) -> f64 {
    vector.iter().map(|v| v * v).sum::<f64>().sqrt()
}

/// The distance of two points.
fn distance<T: Scalar>(a: Ecef<T>, b: Ecef<T>) -> f64 {
    let differences: Vec<f64> = a
        .to_array()
        .iter()
        .zip(b.to_array())
        .map(|(&a, b)| a.into() - b.into())
        .collect();
    length(&differences)
}
