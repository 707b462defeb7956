//! The local frames, and which face a direction belongs to.

use fastrand::Rng;
use terrella::cube::{CubeProjection, Face, FacePoint, Healpix, Projection, ProjectionTask};
use terrella::{Direction, Dual, Real};

use crate::sample::{Scalar, directions, signed};
use testkit::unfolded::{cross, frame};

#[test]
fn frames_are_those_of_the_table() {
    for face in Face::ALL {
        for (i, vector) in frame(face).into_iter().enumerate() {
            let mut axis = [0.0; 3];
            axis[i] = 1.0;
            assert_eq!(face.to_earth(axis), vector, "{face:?}, axis {i}");
            assert_eq!(face.to_local(vector), axis, "{face:?}, axis {i}");
        }
    }
}

#[test]
fn frames_are_right_handed() {
    for face in Face::ALL {
        let [right, up, outward] =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|axis| face.to_earth::<f64>(axis));
        assert_eq!(cross(right, up), outward, "{face:?}");
    }
}

/// Only components change places and signs: every bit comes back, that of a zero's sign too.
fn undo<T: Scalar>() {
    let mut rng = Rng::with_seed(1);
    let special = [0.0, -0.0, 1.0, f64::INFINITY, f64::MIN_POSITIVE].map(T::of);
    for _ in 0..10_000 {
        let v: [T; 3] = std::array::from_fn(|_| {
            if rng.bool() {
                T::of(signed(&mut rng))
            } else {
                special[rng.usize(0..5)]
            }
        });
        for face in Face::ALL {
            let there = face.to_earth(face.to_local(v));
            let back = face.to_local(face.to_earth(v));
            assert_eq!(there.map(T::bits), v.map(T::bits), "{face:?} {v:?}");
            assert_eq!(back.map(T::bits), v.map(T::bits), "{face:?} {v:?}");
        }
    }
}

#[test]
fn frames_undo_each_other() {
    undo::<f64>();
    undo::<f32>();
}

/// The face by its definition: the first of y, z, x whose magnitude no other exceeds.
fn by_definition<T: Real>([x, y, z]: [T; 3]) -> Face {
    let largest = [x, y, z]
        .map(T::abs)
        .into_iter()
        .fold(T::ZERO, |a, b| if b > a { b } else { a });
    let positive = |v: T| v > T::ZERO;
    if y.abs() == largest {
        if positive(y) { Face::Right } else { Face::Left }
    } else if z.abs() == largest {
        if positive(z) { Face::Top } else { Face::Bottom }
    } else if positive(x) {
        Face::Front
    } else {
        Face::Back
    }
}

/// All signs, zeros and ties, and the same with one component moved by one bit.
fn ties<T: Scalar>() {
    let values = [-2.0, -1.0, -0.0, 0.0, 1.0, 2.0].map(T::of);
    let mut tied = 0;
    for x in values {
        for y in values {
            for z in values {
                let Ok(exact) = Direction::new(x, y, z) else { continue };
                tied += usize::from(x.abs() == y.abs() || y.abs() == z.abs() || z.abs() == x.abs());
                assert_eq!(
                    Face::containing(exact),
                    by_definition(exact.to_array()),
                    "{x:?} {y:?} {z:?}"
                );
                for i in 0..3 {
                    for step in [T::above, T::below] {
                        let mut moved = exact.to_array();
                        moved[i] = step(moved[i]);
                        let [x, y, z] = moved;
                        let direction = Direction::new(x, y, z).unwrap();
                        assert_eq!(direction.to_array(), moved, "a unit vector but for rounding is kept");
                        assert_eq!(Face::containing(direction), by_definition(moved), "{moved:?}");
                    }
                }
            }
        }
    }
    assert!(tied > 100, "only {tied} ties");
}

#[test]
fn ties_go_to_y_then_z_then_x() {
    ties::<f64>();
    ties::<f32>();
    let face = |x: f64, y: f64, z: f64| Face::containing(Direction::new(x, y, z).unwrap());
    assert_eq!(face(1.0, -1.0, 1.0), Face::Left);
    assert_eq!(face(-1.0, 0.5, -1.0), Face::Bottom);
    assert_eq!(face(-1.0, 0.5, 0.9), Face::Back);
}

#[test]
fn any_direction_is_on_the_face_of_its_largest_component() {
    for direction in directions::<f64>(2, 40_000) {
        assert_eq!(
            Face::containing(direction),
            by_definition(direction.to_array()),
            "{direction:?}"
        );
    }
    for direction in directions::<f32>(3, 40_000) {
        assert_eq!(
            Face::containing(direction),
            by_definition(direction.to_array()),
            "{direction:?}"
        );
    }
}

const SIDES: [Face; 4] = [Face::Front, Face::Right, Face::Back, Face::Left];

#[test]
fn healpix_cuts_at_two_thirds_and_by_quarters_of_longitude() {
    for direction in directions::<f64>(4, 40_000) {
        let [x, y, z] = direction.to_array();
        let quarters = y.atan2(x).to_degrees() / 90.0;
        if (z.abs() - 2.0 / 3.0).abs() < 1e-15 || (quarters.rem_euclid(1.0) - 0.5).abs() < 1e-14 {
            continue; // too close to call from here
        }
        let expected = if z.abs() < 2.0 / 3.0 {
            SIDES[quarters.round().rem_euclid(4.0) as usize]
        } else if z > 0.0 {
            Face::Top
        } else {
            Face::Bottom
        };
        assert_eq!(Healpix.face(direction), expected, "{direction:?}");
    }
}

/// Two bits above and below sin φ = ⅔ the face is certain.
fn healpix_border<T: Scalar>() {
    for (i, side) in SIDES.into_iter().enumerate() {
        for north in [true, false] {
            let cap = if north { Face::Top } else { Face::Bottom };
            let border = T::of(2.0 / 3.0);
            for (height, expected) in [(border.below().below(), side), (border.above().above(), cap)] {
                let radius = (T::ONE - height * height).sqrt();
                let z = if north { height } else { -height };
                let [x, y] = [
                    [radius, T::ZERO],
                    [T::ZERO, radius],
                    [-radius, T::ZERO],
                    [T::ZERO, -radius],
                ][i];
                let direction = Direction::new(x, y, z).unwrap();
                assert_eq!(direction.z(), z, "kept");
                assert_eq!(Healpix.face(direction), expected, "{direction:?}");
            }
        }
    }
}

#[test]
fn healpix_border_is_where_it_should_be() {
    healpix_border::<f64>();
    healpix_border::<f32>();
}

#[test]
fn healpix_cuts_elsewhere_than_the_cube() {
    let faces = |x, y, z| {
        let direction = Direction::new(x, y, z).unwrap();
        (Face::containing(direction), Healpix.face(direction))
    };
    assert_eq!(faces(0.55, 0.56, 0.62), (Face::Top, Face::Right));
    assert_eq!(faces(0.71, 0.0, -0.7), (Face::Front, Face::Bottom));
}

#[test]
fn healpix_gives_ties_of_longitude_to_y() {
    for z in [-0.9, -0.6, 0.0, 0.3] {
        for (x, y, side) in [
            (1.0, 1.0, Face::Right),
            (-1.0, 1.0, Face::Right),
            (-1.0, -1.0, Face::Left),
            (1.0, -1.0, Face::Left),
        ] {
            let direction = Direction::new(x, y, z).unwrap();
            assert_eq!(Healpix.face(direction), side, "{direction:?}");
        }
    }
}

/// The middle of a face is on its axis to the last bit.
fn middles<T: Scalar>() {
    for &projection in Projection::ALL {
        for face in Face::ALL {
            let middle = projection.unproject(FacePoint::new(face, T::ZERO, T::ZERO).unwrap());
            let axis = face.to_earth([T::ZERO, T::ZERO, T::ONE]);
            assert_eq!(middle.to_array(), axis, "{projection} {face:?}");
        }
    }
}

#[test]
fn middles_are_on_the_axes() {
    middles::<f64>();
    middles::<f32>();
}

/// There the outward component of a unit vector falls by half of the square of the others: its second derivative stays.
struct SecondDerivatives;

impl ProjectionTask for SecondDerivatives {
    type Output = [f64; 2];

    /// The second derivative, and what it should be. Not inlined: one function of all projections takes 20 s to compile.
    #[inline(never)]
    fn run<P: CubeProjection>(self, projection: P) -> [f64; 2] {
        let x = Dual::new(Dual::new(0.0_f64, [1.0]), [Dual::new(1.0, [0.0])]);
        let zero = Dual::constant(Dual::constant(0.0));
        let [right, up, outward] = projection.inverse(Face::Front, [x, zero]);
        let [[slope], [aside]] = [right, up].map(|component| component.slopes().map(Dual::value));
        let [bend] = outward.slopes().map(|slope| slope.slopes()[0]);
        [bend, -(slope * slope + aside * aside)]
    }
}

#[test]
fn middles_keep_their_second_derivatives() {
    for projection in Projection::ALL.iter().filter(|&&p| p != Projection::Healpix) {
        let [bend, expected] = projection.with(SecondDerivatives);
        assert!((bend - expected).abs() < 1e-12, "{projection}: {bend}, not {expected}");
    }
}
