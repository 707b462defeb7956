//! From a face to the next: places beyond an edge of the unfolded cube.

use crate::Real;
use crate::cube::{Edge, Face, Neighbour};

/// The point of an edge with the coordinate `s` along it, `out` beyond it.
pub(super) fn along<T: Real>(edge: Edge, s: T, out: T) -> [T; 2] {
    match edge {
        Edge::Right => [T::ONE + out, s],
        Edge::Up => [s, T::ONE + out],
        Edge::Left => [-T::ONE - out, s],
        Edge::Down => [s, -T::ONE - out],
    }
}

/// The face across an edge, and there the coordinates of a point that lies beyond that edge.
pub(super) fn across<T: Real>(face: Face, edge: Edge, [x, y]: [T; 2]) -> (Face, [T; 2]) {
    let Neighbour { face, turns, .. } = face.neighbour(edge);
    let two = T::of(2.0);
    let from_there = match edge {
        Edge::Right => [x - two, y],
        Edge::Up => [x, y - two],
        Edge::Left => [x + two, y],
        Edge::Down => [x, y + two],
    };
    (face, turned(from_there, turns))
}

/// A vector, turned counter-clockwise by quarter circles.
pub(super) fn turned<T: Real>([x, y]: [T; 2], quarters: u8) -> [T; 2] {
    match quarters % 4 {
        0 => [x, y],
        1 => [-y, x],
        2 => [-x, -y],
        _ => [y, -x],
    }
}
