//! A projection that takes latitudes and longitudes agrees with itself by way of directions.

use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Healpix};
use terrella::{Ellipsoid, LatLon, Shift};

use crate::sample::Scalar;

/// Angles where something changes, on both sides of it, and some between.
fn angles<T: Scalar>(limit: f64) -> Vec<T> {
    let steps = (0..=(limit / 7.5) as u32).map(|k| f64::from(k) * 7.5);
    let beside = |angle: f64| [angle - 1e-4, angle, angle + 1e-4];
    let angles = steps.flat_map(beside).filter(|&angle| angle.abs() <= limit);
    angles.flat_map(|angle| [T::of(angle), -T::of(angle)]).collect()
}

fn agree<T: Scalar>() {
    let map = CubeMap::new(Ellipsoid::new(T::ONE, T::ZERO).unwrap(), Shift::Geodetic, Healpix).unwrap();
    // Of a direction the coordinates are rounded thrice; next to a pole its longitude is as good as its length allows.
    let tolerance = T::of(8.0) * T::EPSILON;
    for lat in angles::<T>(90.0) {
        for lon in angles::<T>(180.0) {
            let place = LatLon::new(lat, lon).unwrap();
            let (found, expected) = (map.project(place), Healpix.project(place.to_direction()));
            assert_eq!(found.face(), expected.face(), "{place:?}");
            let error = (found.x() - expected.x()).abs() + (found.y() - expected.y()).abs();
            assert!(error <= tolerance, "{place:?}: {found:?} and {expected:?}");
            let back = map.unproject(found);
            if lat.abs() < T::of(90.0) {
                assert!(
                    (back.lat() - lat).abs() <= T::of(180.0) * tolerance,
                    "{place:?}: {back:?}"
                );
                assert!(
                    (back.lon() - lon).abs() <= T::of(180.0) * tolerance / lat_cosine(lat),
                    "{place:?}: {back:?}"
                );
            }
        }
    }
    for face in Face::ALL {
        for i in -32..=32 {
            for j in -32..=32 {
                let [x, y] = [i, j].map(|k| T::of(f64::from(k) / 32.0));
                let point = FacePoint::new(face, x, y).unwrap();
                let (found, expected) = (map.unproject(point).to_direction(), Healpix.unproject(point));
                for (a, b) in found.to_array().into_iter().zip(expected.to_array()) {
                    assert!((a - b).abs() <= tolerance, "{point:?}: {found:?} and {expected:?}");
                }
            }
        }
    }
}

fn lat_cosine<T: Scalar>(lat: T) -> T {
    let (_, cos) = terrella::math::sin_cos_degrees(lat);
    cos
}

#[test]
fn healpix_from_places_and_from_directions() {
    agree::<f64>();
    agree::<f32>();
}
