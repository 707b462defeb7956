//! The cube as a box of cardboard: frames as vectors of −1, 0 and 1, points on edges, and the step across an edge.

use terrella::Real;
use terrella::cube::{Corner, Edge, Face};

pub type Vector = [f64; 3];

/// (right, up, outward) of every face in Earth axes, from the table of the documentation.
const FRAMES: [[Vector; 3]; 6] = {
    const X: Vector = [1.0, 0.0, 0.0];
    const Y: Vector = [0.0, 1.0, 0.0];
    const Z: Vector = [0.0, 0.0, 1.0];
    const fn minus([x, y, z]: Vector) -> Vector {
        [0.0 - x, 0.0 - y, 0.0 - z]
    }
    [
        [Y, Z, X],
        [minus(X), Z, Y],
        [minus(Y), Z, minus(X)],
        [X, Z, minus(Y)],
        [Y, minus(X), Z],
        [Y, X, minus(Z)],
    ]
};

/// (right, up, outward) of a face.
pub fn frame(face: Face) -> [Vector; 3] {
    FRAMES[face as usize]
}

/// a·A + b·B + c·C.
pub fn combine(weights: [f64; 3], vectors: [Vector; 3]) -> Vector {
    std::array::from_fn(|i| (0..3).map(|k| weights[k] * vectors[k][i]).sum())
}

pub fn dot(a: Vector, b: Vector) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

pub fn cross([ax, ay, az]: Vector, [bx, by, bz]: Vector) -> Vector {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// An edge's outward unit vector in the face.
pub fn normal<T: Real>(edge: Edge) -> [T; 2] {
    on_edge(edge, T::ZERO)
}

/// The point of an edge with coordinate s along it.
pub fn on_edge<T: Real>(edge: Edge, s: T) -> [T; 2] {
    match edge {
        Edge::Right => [T::ONE, s],
        Edge::Up => [s, T::ONE],
        Edge::Left => [-T::ONE, s],
        Edge::Down => [s, -T::ONE],
    }
}

/// A corner's coordinates.
pub fn at_corner<T: Real>(corner: Corner) -> [T; 2] {
    let one = T::ONE;
    match corner {
        Corner::UpRight => [one, one],
        Corner::UpLeft => [-one, one],
        Corner::DownLeft => [-one, -one],
        Corner::DownRight => [one, -one],
    }
}

/// (x, y) − 2e turned counter-clockwise: beyond an edge, in the neighbour's coordinates.
pub fn beyond<T: Real>([x, y]: [T; 2], edge: Edge, turns: u8) -> [T; 2] {
    let [ex, ey] = normal::<T>(edge);
    let two = T::of(2.0);
    (0..turns).fold([x - two * ex, y - two * ey], |[x, y], _| [-y, x])
}

/// The coordinate across an edge, positive outward, and the one along it.
pub fn across_and_along<T: Real>([x, y]: [T; 2], edge: Edge) -> (T, T) {
    match edge {
        Edge::Right => (x, y),
        Edge::Up => (y, x),
        Edge::Left => (-x, y),
        Edge::Down => (-y, x),
    }
}

/// Every edge of every face: each of the cube's twelve from both of its faces.
pub fn all_edges() -> impl Iterator<Item = (Face, Edge)> {
    Face::ALL
        .into_iter()
        .flat_map(|face| Edge::ALL.map(|edge| (face, edge)))
}
