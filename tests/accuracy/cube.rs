//! Cube projections against the truth.

use terrella::Direction;
use terrella::cube::{CubeProjection, Face, FacePoint, Projection};

use crate::truth::{Row, Scalar, Truth};

/// The truth file of a projection.
pub fn file(projection: Projection) -> &'static str {
    match projection {
        Projection::Tangential => "tsc",
        Projection::Adjusted => "asc",
        Projection::Outerra => "osc",
        Projection::Cobe | Projection::CobeExact => "csc",
        Projection::Quadrilateralized => "qsc",
        Projection::Cartesian => "ksc",
        Projection::Healpix => "healpix",
        Projection::S2Quadratic => "s2q",
        other => other.name(),
    }
}

/// Earth axes of the paper's (vx, vy, vz).
fn earth<V>([vx, vy, vz]: [V; 3]) -> [V; 3] {
    [vz, vx, vy]
}

pub fn forward_error<T: Scalar>(projection: Projection, row: Row) -> f64 {
    let [x, y, z] = earth(["vx", "vy", "vz"].map(|c| row.input::<T>(c)));
    let point = projection.project(Direction::new(x, y, z).expect("a direction"));
    let face = row.value("face") as u8;
    if point.face().index() != face {
        // Across a tie the truth may choose the neighbour: compare through the inverse, at the truth's place.
        let truth = FacePoint::new(Face::from_index(face).unwrap(), row.value("x"), row.value("y")).unwrap();
        let here = FacePoint::new(point.face(), point.x().into(), point.y().into()).unwrap();
        let (a, b) = (
            projection.unproject(truth).to_array(),
            projection.unproject(here).to_array(),
        );
        return a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    }
    row.error("x", point.x()).max(row.error("y", point.y()))
}

pub fn inverse_error<T: Scalar>(projection: Projection, row: Row) -> f64 {
    let face = Face::from_index(row.value("face") as u8).unwrap();
    let point = FacePoint::new(face, row.input::<T>("x"), row.input::<T>("y")).unwrap();
    let computed = projection.unproject(point).to_array();
    let columns = earth(["vx", "vy", "vz"]);
    columns
        .iter()
        .zip(computed)
        .map(|(c, v)| row.error(c, v).powi(2))
        .sum::<f64>()
        .sqrt()
}

fn worst<T: Scalar>(p: Projection) -> [f64; 2] {
    let name = if p == Projection::Cobe {
        "cobe-published"
    } else {
        file(p)
    };
    let forward = Truth::read(&format!("cube_{}_forward", file(p)));
    let inverse = Truth::read(&format!("cube_{name}_inverse"));
    let largest = |errors: Vec<f64>| errors.into_iter().fold(0.0, f64::max);
    [
        largest(
            forward
                .exact_in::<T>(&["vx", "vy", "vz"])
                .into_iter()
                .map(|r| forward_error::<T>(p, r))
                .collect(),
        ),
        largest(
            inverse
                .exact_in::<T>(&["x", "y"])
                .into_iter()
                .map(|r| inverse_error::<T>(p, r))
                .collect(),
        ),
    ]
}

#[test]
fn print_all() {
    for &p in Projection::ALL {
        println!("{:18} {:?} {:?}", p.name(), worst::<f64>(p), worst::<f32>(p));
    }
}
