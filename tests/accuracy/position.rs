//! Latitude and longitude to a direction and back, against the truth.

use terrella::{Direction, LatLon};
use testkit::{Worst, maximum};

use testkit::table::hold;
use testkit::truth::{Scalar, Truth};

/// The largest distance of a direction from the truth, in radians.
fn direction<T: Scalar>() -> f64 {
    let truth = Truth::read("kernel_direction");
    let errors = truth.exact_in::<T>(&["lat", "lon"]).into_iter().map(|row| {
        let computed = LatLon::new(row.input::<T>("lat"), row.input("lon"))
            .unwrap()
            .to_direction()
            .to_array();
        let squares = ["x", "y", "z"]
            .iter()
            .zip(computed)
            .map(|(column, v)| row.error(column, v).powi(2));
        squares.sum::<f64>().sqrt()
    });
    Worst::of(errors)
}

/// The largest error of a latitude or longitude, in ulp.
fn lat_lon<T: Scalar>() -> f64 {
    let truth = Truth::read("kernel_lat_lon");
    let errors = truth.exact_in::<T>(&["x", "y", "z"]).into_iter().map(|row| {
        let [x, y, z] = ["x", "y", "z"].map(|column| row.input::<T>(column));
        let place = Direction::new(x, y, z).unwrap().to_lat_lon();
        maximum(row.ulps("lat", place.lat()), row.ulps("lon", place.lon()))
    });
    Worst::of(errors)
}

#[test]
fn positions_are_as_accurate_as_claimed() {
    hold("LatLon to Direction", [direction::<f64>(), direction::<f32>()]);
    hold("Direction to LatLon", [lat_lon::<f64>(), lat_lon::<f32>()]);
}
