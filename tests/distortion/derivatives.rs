//! Derivatives by dual numbers against truth, against differences, and against those of the other direction.

use terrella::cube::{CubeProjection, Face, Projection, ProjectionTask};
use terrella::distortion::Jacobian;
use terrella::{Dual, Ellipsoid, Real, Shift};
use testkit::Worst;

use crate::sphere::{at, on, places, unit_sphere};
use testkit::table::hold;
use testkit::truth::{Scalar, Truth};

/// The largest errors of a slope, along the ground and in units of the longest, and of an area, relative.
fn errors<T: Scalar>(truth: &Truth) -> [f64; 2] {
    let mut worst = [Worst::default(); 2];
    for row in truth.exact_in::<T>(&["x", "y"]) {
        let projection: Projection = row.text("projection").parse().unwrap();
        let face = Face::from_index(row.text("face").parse().unwrap()).unwrap();
        let point = [row.input::<T>("x"), row.input("y")];
        let local = projection.inverse(face, Dual::variables(point));
        let direction = local.map(|component| component.value().into());
        let columns = [["rx", "ux", "ox"], ["ry", "uy", "oy"]];
        let longest = columns.map(|vector| length(vector.map(|column| row.value(column))));
        let longest = Worst::of(longest);
        let slopes = local.map(Dual::slopes);
        for (variable, vector) in columns.into_iter().enumerate() {
            let error = std::array::from_fn(|i| row.deviation(vector[i], slopes[i][variable]));
            // What is along the direction is no slope of the ground.
            let upward: f64 = dot(error, direction);
            let along = std::array::from_fn(|i| error[i] - upward * direction[i]);
            worst[0].add(length(along) / longest);
        }
        let ground = unit_sphere::<T, _>(projection);
        let area = ground.jacobian(at(face, point[0], point[1])).unwrap().area();
        worst[1].add(row.error("area", area) / row.value("area"));
    }
    worst.map(Worst::value)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

#[test]
fn slopes_and_areas_are_those_of_the_truth() {
    let truth = Truth::read("cube_jacobian");
    let [double, single] = [errors::<f64>(&truth), errors::<f32>(&truth)];
    hold(
        "Ground::jacobian, slopes relative to the longest",
        [double[0], single[0]],
    );
    hold("Ground::jacobian, area, relative", [double[1], single[1]]);
}

/// The largest error of the product of forward and inverse slopes, which is 1.
struct BothWays;

impl ProjectionTask for BothWays {
    type Output = f64;

    // Not inlined: one function of all projections in dual numbers takes half a minute to compile.
    #[inline(never)]
    fn run<P: CubeProjection>(self, projection: P) -> f64 {
        let mut worst = Worst::default();
        for point in places(3000, 1) {
            let face = point.face();
            let local = projection.inverse(face, Dual::variables([point.x(), point.y()]));
            let [x, y] = projection.forward(face, local).map(Dual::slopes);
            // Next to a corner of the conformal and the vertex cube, a rounding of the vector is a step on the map.
            let corner = (1.0 - point.x().abs()).hypot(1.0 - point.y().abs());
            if corner > 0.05 && point.x().hypot(point.y()) > 0.05 {
                worst.add(Worst::of([x[0] - 1.0, x[1], y[0], y[1] - 1.0].map(f64::abs)));
            }
        }
        worst.value()
    }
}

#[test]
fn forward_and_inverse_slopes_are_each_others_inverse() {
    for &projection in Projection::ALL.iter().filter(|p| **p != Projection::Cobe) {
        let worst = projection.with(BothWays);
        println!("{projection}: {worst:.1e}");
        assert!(worst < 1e-12, "{projection}: {worst:e}");
    }
}

fn largest_difference(a: &Jacobian<f64>, b: &Jacobian<f64>) -> f64 {
    let entries = |j: &Jacobian<f64>| [j.by_x[0], j.by_x[1], j.by_y[0], j.by_y[1]];
    let size = a.extremes()[1];
    let pairs = entries(a).into_iter().zip(entries(b));
    Worst::of(pairs.map(|(p, q)| (p - q).abs() / size))
}

#[test]
fn differences_agree_on_every_face_and_ellipsoid() {
    for (ellipsoid, shift) in [
        (Ellipsoid::WGS84, Shift::Authalic),
        (Ellipsoid::WGS84, Shift::Geocentric),
        (Ellipsoid::MARS, Shift::Conformal),
        (Ellipsoid::new(1.0, 0.1).unwrap(), Shift::Rectifying),
        (Ellipsoid::new(1e7, -1.0 / 150.0).unwrap(), Shift::Parametric),
        (Ellipsoid::MOON, Shift::Geodetic),
    ] {
        for &projection in Projection::ALL {
            let ground = on(ellipsoid, shift, projection);
            for point in places(300, 2) {
                let (x, y) = (point.x(), point.y());
                // Differences need room: from creases, and from the corners where a map is no polynomial.
                let room = [x, y, x.abs() - y.abs(), 1.0 - x.abs(), 1.0 - y.abs()];
                if room.into_iter().all(|gap| gap.abs() > 0.02) {
                    let exact = ground.jacobian(point).unwrap();
                    let error = largest_difference(&exact, &ground.differences(point.face(), [x, y], 1e-5));
                    assert!(error < 3e-8, "{projection} at {point:?}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn the_pole_is_no_exception() {
    let ground = on(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Outerra);
    for face in [Face::Top, Face::Bottom] {
        let pole = ground.jacobian(at(face, 0.0, 0.0)).unwrap();
        assert_eq!((pole.aspect(), pole.deformation()), (1.0, 0.0));
        // By the radius of curvature there, a/(1 − f), and by that of the authalic sphere.
        let beside = ground.jacobian(at(face, 1e-9, 0.0)).unwrap();
        assert!((pole.width() / beside.width() - 1.0).abs() < 1e-14);
        assert!((pole.area() / beside.area() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn where_there_is_no_derivative_that_is_said() {
    for (projection, face, [x, y]) in [
        (Projection::Quadrilateralized, Face::Front, [0.0, 0.0]),
        (Projection::Healpix, Face::Top, [0.0, 0.0]),
        (Projection::Vertex, Face::Left, [1.0, -1.0]),
        (Projection::Conformal, Face::Back, [-1.0, -1.0]),
    ] {
        let refused = unit_sphere::<f64, _>(projection).jacobian(at(face, x, y)).unwrap_err();
        assert_eq!(refused.0, at(face, x, y), "{projection}");
        assert!(
            refused
                .to_string()
                .contains(&format!("({x}, {y}) of face {}", face.index()))
        );
        assert!(
            unit_sphere::<f32, _>(projection)
                .jacobian(at(face, x as f32, y as f32))
                .is_err()
        );
    }
    for &projection in Projection::ALL {
        for face in Face::ALL {
            for (x, y) in [
                (1.0, 0.25),
                (-1.0, 0.5),
                (0.5, 1.0),
                (0.5, -1.0),
                (0.5, 0.5),
                (-0.5, 0.5),
                (0.0, 0.5),
            ] {
                assert!(
                    unit_sphere::<f64, _>(projection).jacobian(at(face, x, y)).is_ok(),
                    "{projection} {x} {y}"
                );
            }
        }
    }
}

/// A map that a user writes: the first half of the adjusted cube's tangents.
#[derive(Clone, Copy)]
struct Squeezed;

impl CubeProjection for Squeezed {
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let cube = |u: T| u * u * u;
        [cube(right / outward), up / outward]
    }

    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let u = terrella::math::cbrt(x);
        let length = (u * u + y * y + T::ONE).sqrt();
        [u / length, y / length, T::ONE / length]
    }
}

#[test]
fn a_users_projection_is_differentiated_too() {
    // u = x^⅓: du/dx = ⅓ x^−⅔, and the gnomonic area element is (1 + u² + v²)^−3/2.
    let (x, y) = (0.125_f64, 0.5_f64);
    let area = unit_sphere::<f64, _>(Squeezed)
        .jacobian(at(Face::Right, x, y))
        .unwrap()
        .area();
    let expected = (4.0 / 3.0) / (1.0 + 0.25 + 0.25_f64).powf(1.5);
    assert!((area / expected - 1.0).abs() < 1e-14);
}
