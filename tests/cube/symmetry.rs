//! The symmetries of the face, in every bit: a mirrored or swapped input is a mirrored or swapped output.
//!
//! Zeros of either sign are equal. Some faces have only the mirrors: the projection says which.

use terrella::cube::{CubeProjection, Face, Faces, Projection};

use crate::sample::{Scalar, coordinates, directions, every_projection, ulps};

/// How far, in ulps of 1 (halves of `T::EPSILON`), swapping right and up may differ from swapping x and y: forward, inverse.
/// The mirrors are exact for all.
const fn swap(projection: Projection) -> (f64, f64) {
    match projection {
        // The product of the sum and the difference of uv.
        Projection::Cartesian => (3.0, 0.0),
        // On the diagonals, where x and y are computed differently.
        Projection::Conformal => (2.0, 2.0),
        _ => (0.0, 0.0),
    }
}

fn swaps(projection: Projection, face: Face) -> bool {
    projection.faces().are_square(face)
}

fn forward<T: Scalar>(projection: Projection) {
    for direction in directions::<T>(30, 40_000) {
        let face = projection.face(direction);
        let [right, up, outward] = face.to_local(direction.to_array());
        let map = |right: T, up: T| projection.forward(face, [right, up, outward]);
        let [x, y] = map(right, up);
        let context = || format!("{projection} {}: {face:?} ({right:?}, {up:?}, {outward:?})", T::NAME);
        assert_eq!(map(-right, up), [-x, y], "{}", context());
        assert_eq!(map(right, -up), [x, -y], "{}", context());
        assert_eq!(map(-right, -up), [-x, -y], "{}", context());
        if swaps(projection, face) {
            let [b, a] = map(up, right);
            let allowed = swap(projection).0;
            assert!(
                ulps(a, x) <= allowed && ulps(b, y) <= allowed,
                "{}: {a:?} {b:?}",
                context()
            );
        }
    }
}

#[test]
fn forward_has_the_symmetries_of_the_square() {
    every_projection(|projection| {
        forward::<f64>(projection);
        forward::<f32>(projection);
    });
}

fn inverse<T: Scalar>(projection: Projection) {
    let numbers = coordinates::<T>(31, 150);
    for face in [Face::Front, Face::Bottom] {
        for &x in &numbers {
            for &y in &numbers {
                let map = |x: T, y: T| projection.inverse(face, [x, y]);
                let [right, up, outward] = map(x, y);
                let context = || format!("{projection} {}: {face:?} ({x:?}, {y:?})", T::NAME);
                assert_eq!(map(-x, y), [-right, up, outward], "{}", context());
                assert_eq!(map(x, -y), [right, -up, outward], "{}", context());
                assert_eq!(map(-x, -y), [-right, -up, outward], "{}", context());
                if swaps(projection, face) {
                    let [b, a, c] = map(y, x);
                    let allowed = swap(projection).1;
                    assert!(
                        ulps(a, right) <= allowed && ulps(b, up) <= allowed && ulps(c, outward) <= allowed,
                        "{}: {a:?} {b:?} {c:?}",
                        context()
                    );
                }
            }
        }
    }
}

#[test]
fn inverse_has_the_symmetries_of_the_square() {
    every_projection(|projection| {
        inverse::<f64>(projection);
        inverse::<f32>(projection);
    });
}

/// On a midline of the face x or y is 0, and 0 is on a midline.
fn midlines<T: Scalar>(projection: Projection) {
    let zero = T::ZERO;
    for face in Face::ALL {
        for s in coordinates::<T>(33, 1500) {
            for zero in [zero, -zero] {
                let [right, _, _] = projection.inverse(face, [zero, s]);
                let [_, up, _] = projection.inverse(face, [s, zero]);
                let context = || format!("{projection} {}: {face:?} {s:?} and {zero:?}", T::NAME);
                assert_eq!([right, up], [zero; 2], "{}", context());
                let length = (T::ONE + s * s).sqrt();
                let (a, b) = (s / length, T::ONE / length);
                let [x, _] = projection.forward(face, [zero, a, b]);
                let [_, y] = projection.forward(face, [a, zero, b]);
                assert_eq!([x, y], [zero; 2], "{}", context());
            }
        }
    }
}

#[test]
fn midlines_stay_midlines() {
    every_projection(|projection| {
        midlines::<f64>(projection);
        midlines::<f32>(projection);
    });
}

/// Every face is the same map in its own frame; some projections have one for the sides and one for the poles.
fn faces_alike<T: Scalar>(projection: Projection) {
    for direction in directions::<T>(32, 5000) {
        let face = projection.face(direction);
        let local = face.to_local(direction.to_array());
        let point = projection.forward(face, local);
        let vector = projection.inverse(face, point);
        for other in Face::ALL {
            if projection.faces() == Faces::SideAndPolar && other.is_polar() != face.is_polar() {
                continue;
            }
            let context = || format!("{projection} {}: {face:?} {other:?} {local:?}", T::NAME);
            assert_eq!(projection.forward(other, local), point, "{}", context());
            assert_eq!(projection.inverse(other, point), vector, "{}", context());
        }
    }
}

#[test]
fn every_face_is_the_same_map() {
    every_projection(|projection| {
        faces_alike::<f64>(projection);
        faces_alike::<f32>(projection);
    });
}

/// How far from alike x and y, or a side face and a polar one, are at a place somewhere.
fn unlike<T: Scalar>(projection: Projection, swapped: bool, [face, other]: [Face; 2]) -> f64 {
    let [a, b] = [0.5, 0.25].map(T::of);
    let [right, up, _] = projection.inverse(face, [a, b]);
    let found = if swapped {
        let [up, right, _] = projection.inverse(other, [b, a]);
        [right, up]
    } else {
        let [right, up, _] = projection.inverse(other, [a, b]);
        [right, up]
    };
    ulps(found[0], right) + ulps(found[1], up)
}

/// A projection claims no symmetry less than there is.
#[test]
fn projections_name_all_symmetries() {
    every_projection(|projection| {
        let faces = projection.faces();
        for face in [Face::Front, Face::Top] {
            let differ = unlike::<f64>(projection, true, [face, face]) > 1e9;
            assert_eq!(differ, !faces.are_square(face), "{projection}, {face:?}");
        }
        let differ = unlike::<f64>(projection, false, [Face::Front, Face::Top]) > 1e9;
        assert_eq!(differ, faces == Faces::SideAndPolar, "{projection}");
    });
}
