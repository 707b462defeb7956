//! The projections: against the truth, and in `f32` over many points against `f64`.

use terrella::Direction;
use terrella::cube::{CubeProjection, Face, FacePoint, Projection};
use testkit::{Worst, maximum};

use testkit::table::hold_projection;
use testkit::truth::{Row, Scalar, Truth};

/// The truth files of a projection, forward and inverse.
fn files(projection: Projection) -> [String; 2] {
    let forward = match projection {
        // Their forward polynomials are one.
        Projection::Cobe => Projection::CobeExact,
        other => other,
    };
    [format!("cube_{forward}_forward"), format!("cube_{projection}_inverse")]
}

/// The truth's columns, by the paper's axes, in the order of the Earth's.
const EARTH: [&str; 3] = ["vz", "vx", "vy"];

fn forward_error<T: Scalar>(projection: Projection, row: Row) -> f64 {
    let [x, y, z] = EARTH.map(|column| row.input::<T>(column));
    let point = projection.project(Direction::new(x, y, z).unwrap());
    let face = Face::from_index(row.value("face") as u8).unwrap();
    if point.face() == face {
        return maximum(row.error("x", point.x()), row.error("y", point.y()));
    }
    // Where a tie is decided by the rounding of the input, the neighbour's point must be the same direction.
    let theirs = FacePoint::new(face, row.value("x"), row.value("y")).unwrap();
    let ours = FacePoint::new(point.face(), point.x().into(), point.y().into()).unwrap();
    distance(
        projection.unproject(theirs).to_array(),
        projection.unproject(ours).to_array(),
    )
}

fn inverse_error<T: Scalar>(projection: Projection, row: Row) -> f64 {
    let face = Face::from_index(row.value("face") as u8).unwrap();
    let point = FacePoint::new(face, row.input::<T>("x"), row.input("y")).unwrap();
    let computed = projection.unproject(point).to_array();
    let squares = EARTH
        .iter()
        .zip(computed)
        .map(|(column, v)| row.error(column, v).powi(2));
    squares.sum::<f64>().sqrt()
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// The largest errors over the truth, forward and inverse.
fn against_truth<T: Scalar>(projection: Projection) -> [f64; 2] {
    let [forward, inverse] = files(projection).map(|file| Truth::read(&file));
    let forward = forward
        .exact_in::<T>(&EARTH)
        .into_iter()
        .map(|row| forward_error::<T>(projection, row));
    let inverse = inverse
        .exact_in::<T>(&["x", "y"])
        .into_iter()
        .map(|row| inverse_error::<T>(projection, row));
    [Worst::of(forward), Worst::of(inverse)]
}

/// A coordinate, often on or near an edge, a diagonal's end or a midline.
fn coordinate(rng: &mut fastrand::Rng) -> f32 {
    let signed = 2.0 * rng.f32() - 1.0;
    match rng.u8(0..8) {
        0 => 1f32.copysign(signed),
        1 => (1.0 - 10f32.powf(-7.0 * rng.f32())).copysign(signed),
        2 => 10f32.powf(-7.0 * rng.f32()) * signed,
        3 => 0.0,
        _ => signed,
    }
}

/// The largest errors of `f32` against `f64`, forward and inverse, over many points.
fn against_double(projection: Projection, points: usize) -> [f64; 2] {
    let mut rng = fastrand::Rng::with_seed(2);
    let mut worst = [Worst::default(); 2];
    for _ in 0..points {
        let face = Face::ALL[rng.usize(0..6)];
        let x = coordinate(&mut rng);
        let y = if rng.u8(0..8) == 0 {
            x * (1.0 - 1e-5 * rng.f32())
        } else {
            coordinate(&mut rng)
        };

        let [a, b, c] = face.to_earth([x, y, 1.0]);
        let single = Direction::new(a, b, c).unwrap();
        let [a, b, c] = single.to_array().map(f64::from);
        let (p, q) = (
            projection.project(single),
            projection.project(Direction::new(a, b, c).unwrap()),
        );
        // HEALPix compares 3|z| with 2, which rounds.
        assert!(p.face() == q.face() || projection == Projection::Healpix);
        if p.face() == q.face() {
            worst[0].add((f64::from(p.x()) - q.x()).abs());
            worst[0].add((f64::from(p.y()) - q.y()).abs());
        }

        let single = projection.unproject(FacePoint::new(face, x, y).unwrap()).to_array();
        let double = projection
            .unproject(FacePoint::new(face, x.into(), y.into()).unwrap())
            .to_array();
        worst[1].add(distance(single.map(f64::from), double));
    }
    worst.map(Worst::value)
}

#[test]
fn projections_are_as_accurate_as_claimed() {
    for &projection in Projection::ALL {
        let double = against_truth::<f64>(projection);
        let single = against_truth::<f32>(projection);
        let wide = against_double(projection, 100_000);
        hold_projection(
            projection,
            [double[0], maximum(single[0], wide[0])],
            [double[1], maximum(single[1], wide[1])],
        );
    }
}
