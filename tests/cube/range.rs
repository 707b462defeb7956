//! Everywhere: coordinates in [−1, 1] and never NaN, on the face that was chosen, and increasing to the right.

use terrella::Direction;
use terrella::cube::{CubeProjection, Face, FacePoint, Projection};

use crate::sample::{Scalar, coordinates, directions, every_projection, ulps};

/// `project` would hide a NaN behind its bounds: so the bare `forward` is looked at, which may exceed them by an ulp.
fn forward_in_range<T: Scalar>(projection: Projection) {
    for direction in directions::<T>(20, 40_000) {
        let face = projection.face(direction);
        if projection != Projection::Healpix {
            assert_eq!(face, Face::containing(direction), "{projection}");
        }
        let [x, y] = projection.forward(face, face.to_local(direction.to_array()));
        let limit = T::ONE + T::EPSILON;
        assert!(
            x.abs() <= limit && y.abs() <= limit,
            "{projection} {}: {direction:?} on {face:?} is ({x:?}, {y:?})",
            T::NAME
        );
        let point = projection.project(direction);
        let bounded = |v: T| {
            if v > T::ONE {
                T::ONE
            } else if v < -T::ONE {
                -T::ONE
            } else {
                v
            }
        };
        assert_eq!(
            (point.face(), point.x(), point.y()),
            (face, bounded(x), bounded(y)),
            "{projection} {}: {direction:?}",
            T::NAME
        );
    }
}

#[test]
fn every_direction_has_a_place_on_its_face() {
    every_projection(|projection| {
        forward_in_range::<f64>(projection);
        forward_in_range::<f32>(projection);
    });
}

fn inverse_in_range<T: Scalar>(projection: Projection) {
    let numbers = coordinates::<T>(21, 60);
    // Well inside the face a rounding does not lead out of it. Near a corner of the conformal cube one does, by the map's
    // own conditioning.
    let inside = T::of(0.999);
    for face in Face::ALL {
        for &x in &numbers {
            for &y in &numbers {
                let point = FacePoint::new(face, x, y).unwrap();
                let direction = projection.unproject(point);
                let [a, b, c] = direction.to_array().map(Into::<f64>::into);
                let length = (a * a + b * b + c * c).sqrt();
                // NaN fails too.
                assert!(
                    (length - 1.0).abs() <= 2.5 * T::EPSILON.into(),
                    "{projection} {}: {point:?} is {direction:?} of length {length}",
                    T::NAME
                );
                if x.abs() <= inside && y.abs() <= inside {
                    assert_eq!(
                        projection.face(direction),
                        face,
                        "{projection} {}: {point:?} is {direction:?}",
                        T::NAME
                    );
                }
            }
        }
    }
}

#[test]
fn every_place_is_a_unit_vector_on_its_face() {
    every_projection(|projection| {
        inverse_in_range::<f64>(projection);
        inverse_in_range::<f32>(projection);
    });
}

/// A direction by its gnomonic coordinates on a face.
fn gnomonic<T: Scalar>(face: Face, u: f64, v: f64) -> Direction<T> {
    let [x, y, z] = face.to_earth([T::of(u), T::of(v), T::ONE]);
    Direction::new(x, y, z).unwrap()
}

/// Along rows and columns of gnomonic coordinates x and y increase, and along rows and columns of x and y those do.
fn increases<T: Scalar>(projection: Projection) {
    let grid = |i: i32, n: i32| f64::from(2 * i - n) / f64::from(n);
    for face in [Face::Front, Face::Left, Face::Bottom] {
        for row in 0..=40 {
            let v = grid(row, 40);
            let mut last: [Option<T>; 4] = [None; 4];
            for column in 0..=400 {
                let u = grid(column, 400);
                let (along_row, along_column) = (gnomonic::<T>(face, u, v), gnomonic::<T>(face, v, u));
                let [x, _] = projection.forward(face, face.to_local(along_row.to_array()));
                let [_, y] = projection.forward(face, face.to_local(along_column.to_array()));
                let [right, _, outward] = projection.inverse(face, [T::of(u), T::of(v)]);
                let [_, up, outward_too] = projection.inverse(face, [T::of(v), T::of(u)]);
                // Healpix's border runs elsewhere: there, a gnomonic row leaves the face.
                let here = |d| projection != Projection::Healpix || (!face.is_polar() && projection.face(d) == face);
                let now = [
                    here(along_row).then_some(x),
                    here(along_column).then_some(y),
                    Some(right / outward),
                    Some(up / outward_too),
                ];
                for (before, now) in last.iter().zip(now) {
                    assert!(
                        before.zip(now).is_none_or(|(before, now)| now > before),
                        "{projection} {}: {face:?} u {u} v {v}: {now:?} after {before:?}",
                        T::NAME
                    );
                }
                last = now;
            }
        }
    }
}

#[test]
fn coordinates_increase_to_the_right_and_upward() {
    every_projection(|projection| {
        increases::<f64>(projection);
        increases::<f32>(projection);
    });
}

/// From one number to the next, rounding may take x back, but by no more than 4 ulps of 1.
fn hardly_wavers<T: Scalar>(projection: Projection) {
    let mut rng = fastrand::Rng::with_seed(22);
    for _ in 0..4000 {
        let (u, v) = (rng.f64() * 0.999, 1.2 * rng.f64() - 0.6);
        let mut u = T::of(u);
        let v = T::of(v);
        let mut last: Option<T> = None;
        for _ in 0..8 {
            let length = (T::ONE + u * u + v * v).sqrt();
            let [x, _] = projection.forward(Face::Front, [u / length, v / length, T::ONE / length]);
            if let Some(last) = last {
                assert!(
                    x >= last || ulps(x, last) <= 4.0,
                    "{projection} {}: u {u:?} v {v:?}: {x:?} after {last:?}",
                    T::NAME
                );
            }
            last = Some(x);
            u = u.above();
        }
    }
}

#[test]
fn rounding_hardly_reverses_neighbours() {
    every_projection(|projection| {
        hardly_wavers::<f64>(projection);
        hardly_wavers::<f32>(projection);
    });
}
