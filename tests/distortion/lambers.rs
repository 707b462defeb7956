//! Lambers' distortions against what his own program prints, and the optimum of Zucker & Higashi.

use terrella::cube::{CubeProjection, Face, FacePoint, Projection};
use terrella::distortion::{Ground, Jacobian, Survey};
use terrella::{LatLon, Real};
use testkit::Worst;

use crate::sphere::{at, unit_sphere};

/// The areal scale and the isotropy: mean, largest deviation from 1, and root of the mean square deviation.
type Printed = [[f64; 3]; 2];

/// Printed with six digits by the program of Lambers' survey (2019; `mappings-sphere-cube`, `analyzer`), which
/// differentiates numerically at the middles of 512 × 512 cells.
#[rustfmt::skip]
const PRINTED: &[(Projection, Face, Printed)] = &[
    (Projection::Tangential, Face::Front, [[1.153376, 1.710089, 0.464170], [1.280788, 0.729796, 0.324172]]),
    (Projection::Adjusted, Face::Front, [[1.007952, 0.198584, 0.089424], [1.234020, 0.728515, 0.280064]]),
    (Projection::Quadrilateralized, Face::Front, [[1.0, 0.000007, 0.0], [1.329349, 0.547542, 0.345642]]),
    (Projection::Cartesian, Face::Front, [[1.001146, 0.204529, 0.033832], [1.235336, 0.726995, 0.295269]]),
    (Projection::Outerra, Face::Front, [[1.057655, 1.701389, 0.296883], [1.078449, 0.724240, 0.133987]]),
    (Projection::Healpix, Face::Front, [[1.0, 0.0, 0.0], [1.154525, 0.523132, 0.191135]]),
    (Projection::Healpix, Face::Top, [[1.0, 0.000006, 0.0], [1.766790, 1.418039, 0.827905]]),
    (Projection::Algebraic, Face::Front, [[1.001953, 0.116811, 0.044405], [1.271493, 0.728100, 0.326997]]),
    (Projection::ZuckerHigashi, Face::Front, [[1.001627, 0.142623, 0.041086], [1.289972, 0.728087, 0.345093]]),
    (Projection::Lambers, Face::Front, [[1.001642, 0.138457, 0.040970], [1.294925, 0.728052, 0.351370]]),
    (Projection::Tanh, Face::Front, [[1.003143, 0.119493, 0.055287], [1.256950, 0.728093, 0.313848]]),
    (Projection::Unicube, Face::Front, [[1.001442, 0.171060, 0.037839], [1.288282, 0.727972, 0.347930]]),
];

/// A survey at the middles of n × n cells. On the diagonals, where a map may have a crease, the differences
/// are his: of the map from the sphere, 1e-5 to each side in latitude and in longitude.
fn survey<P: CubeProjection>(projection: P, face: Face, n: u32) -> Survey<f64> {
    let ground = unit_sphere(projection);
    let mut survey = Survey::new(ground.fair_texel());
    let middle = |i: u32| f64::from(2 * i + 1) / f64::from(n) - 1.0;
    for (row, column) in (0..n).flat_map(|row| (0..n).map(move |column| (row, column))) {
        let point = at(face, middle(column), middle(row));
        let texel = if row == column || row + column + 1 == n {
            across_the_diagonal(&ground, point)
        } else {
            ground.jacobian(point).unwrap()
        };
        survey.include(point, &texel);
    }
    survey
}

fn across_the_diagonal<P: CubeProjection>(ground: &Ground<f64, P>, point: FacePoint<f64>) -> Jacobian<f64> {
    let step = 1e-5_f64.to_degrees();
    let place = ground.map().unproject(point);
    let project = |north: f64, east: f64| {
        let there = LatLon::new(place.lat() + north, place.lon() + east).unwrap();
        let point = ground.map().project(there);
        [point.x(), point.y()]
    };
    let quotient = |[a, b]: [f64; 2], [c, d]: [f64; 2], length: f64| [(c - a) / length, (d - b) / length];
    let east = 2e-5 * place.lat().to_radians().cos();
    let [xe, ye] = quotient(project(0.0, -step), project(0.0, step), east);
    let [xn, yn] = quotient(project(-step, 0.0), project(step, 0.0), 2e-5);
    let area = xe * yn - xn * ye;
    Jacobian {
        by_x: [yn / area, -ye / area],
        by_y: [-xn / area, xe / area],
    }
}

#[test]
fn his_program_prints_the_same() {
    let mut worst = Worst::default();
    for &(projection, face, printed) in PRINTED {
        let survey = survey(projection, face, 512);
        let largest = |least: f64, most: f64| testkit::maximum(1.0 - least, most - 1.0);
        for (statistic, printed) in [survey.scale(), survey.isotropy()].into_iter().zip(printed) {
            let seen = [
                statistic.mean(),
                largest(statistic.min(), statistic.max()),
                statistic.rmsd(),
            ];
            for (seen, printed) in seen.into_iter().zip(printed) {
                worst.add((seen - printed).abs());
                // Its differences are off by 7e-6 near the diagonals of QSC, where all areas are alike.
                assert!(
                    (seen - printed).abs() < 8e-6,
                    "{projection}, {face:?}: {seen}, {printed}"
                );
            }
        }
    }
    println!("largest difference: {:.1e}", worst.value());
    assert!(worst.value() < 8e-6);
}

/// The tangent family, by its angle.
#[derive(Clone, Copy)]
struct Tangent(f64);

impl CubeProjection for Tangent {
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let theta = T::of(self.0);
        let t = terrella::math::tan(theta / T::of(2.0));
        let tan = T::of(2.0) * t / (T::ONE - t * t);
        [right, up].map(|v| terrella::math::atan(v / outward * tan) / theta)
    }

    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        // By half of the angle, for the tangent of more than π/4.
        let tangent = |x: T| {
            let t = terrella::math::tan(x * T::of(self.0 / 2.0));
            T::of(2.0) * t / (T::ONE - t * t)
        };
        let [u, v] = point.map(|x| tangent(x) / tangent(T::ONE));
        let length = (u * u + v * v + T::ONE).sqrt();
        [u / length, v / length, T::ONE / length]
    }
}

#[test]
fn the_optimum_of_zucker_and_higashi_is_that_of_the_root_mean_square_area() {
    // Their angle, published with twelve digits; how fine their grid was they do not say.
    let published = 0.868_734_829_276;
    let step = 0.002;
    let [less, here, more] =
        [-step, 0.0, step].map(|by| survey(Tangent(published + by), Face::Front, 192).area().rmsd().powi(2));
    // The vertex of the parabola through the three.
    let optimum = published + step / 2.0 * (less - more) / (less - 2.0 * here + more);
    println!("{optimum:.6}");
    assert!((optimum - published).abs() < 1e-4, "{optimum}");
}
