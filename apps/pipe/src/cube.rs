//! A projection onto the cube where it is, or turned and stretched.

use terrella::cube::{CubeProjection, Face, Projection, ProjectionTask, Stretched, Turned};
use terrella::{Direction, Real};

#[derive(Clone, Copy)]
pub enum Cube {
    Plain(Projection),
    Oblique(Turned<Stretched<Projection>>),
}

/// Asks the projection that it is.
macro_rules! ask {
    ($cube:ident, $projection:ident => $answer:expr) => {
        match $cube {
            Cube::Plain($projection) => $answer,
            Cube::Oblique($projection) => $answer,
        }
    };
}

impl CubeProjection for Cube {
    const SYMMETRIC: bool = false;

    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
        ask!(self, projection => projection.forward(face, local))
    }

    fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
        ask!(self, projection => projection.inverse(face, point))
    }

    fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
        ask!(self, projection => projection.is_polar(direction))
    }

    fn to_cube<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        ask!(self, projection => projection.to_cube(vector))
    }

    fn to_earth<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        ask!(self, projection => projection.to_earth(vector))
    }

    fn with<W: ProjectionTask>(self, task: W) -> W::Output {
        ask!(self, projection => projection.with(task))
    }
}
