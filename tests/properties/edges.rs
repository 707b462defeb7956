//! The cube's seams: across edges and around corners nothing jumps.

use terrella::Direction;
use terrella::cube::{CubeProjection, Edge, FacePoint, Projection};
use testkit::{Worst, maximum};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::{Scalar, steps, ulps};
use testkit::unfolded::{beyond, on_edge};

properties! { seam step }

/// A point some ulps inside an edge and one some ulps inside the neighbour's are as many ulps apart on the sphere; on the edge
/// itself they are one.
fn seam<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let (face, edge) = (bytes.face(), bytes.choice(&Edge::ALL));
    if !projection.faces().agree(face, edge) {
        return;
    }
    let along = bytes.within::<T>(1.0);
    let (inside, outside) = (bytes.between(8).abs(), bytes.between(8).abs());
    let neighbour = face.neighbour(edge);
    let here = inward(on_edge(edge, along), edge, inside);
    let there = inward(
        beyond(on_edge(edge, along), edge, neighbour.turns),
        neighbour.edge,
        outside,
    );
    let direction = |face, [x, y]: [T; 2]| projection.unproject(FacePoint::new(face, x, y).unwrap()).to_array();
    let (a, b) = (direction(face, here), direction(neighbour.face, there));
    let moved = Worst::of((0..3).map(|i| ulps(a[i], b[i])));
    let between = f64::from(inside + outside);
    // A projection that is exact on its edges rounds once more beside them.
    let exact = if projection == Projection::Healpix { 1.0 } else { 0.0 };
    let allowed = if between == 0.0 { exact } else { 1.5 * between + 4.0 };
    assert!(
        moved <= allowed,
        "{projection} {}: {face:?} {here:?} is {a:?}, {:?} {there:?} is {b:?}: {moved} ulps",
        T::NAME,
        neighbour.face
    );
}

/// A point of an edge, some ulps inward.
fn inward<T: Scalar>([x, y]: [T; 2], edge: Edge, count: i32) -> [T; 2] {
    match edge {
        Edge::Right => [steps(x, -count), y],
        Edge::Up => [x, steps(y, -count)],
        Edge::Left => [steps(x, count), y],
        Edge::Down => [x, steps(y, count)],
    }
}

/// A step of some ulps of a direction is one of as many ulps on the cube, within a face and across its edges and corners, where the
/// neighbour's coordinates are turned as [`Face::neighbour`](terrella::cube::Face::neighbour) says.
fn step<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let start = if bytes.flag() {
        let (face, edge) = (bytes.face(), bytes.choice(&Edge::ALL));
        let [x, y] = on_edge(edge, bytes.within(1.0));
        projection.unproject(FacePoint::new(face, x, y).unwrap())
    } else {
        bytes.direction::<T>()
    };
    let counts = [bytes.between(4), bytes.between(4), bytes.between(4)];
    let [x, y, z] = start.to_array();
    let [x, y, z] = [steps(x, counts[0]), steps(y, counts[1]), steps(z, counts[2])];
    let Ok(end) = Direction::new(x, y, z) else { return };
    let (from, to) = (projection.project(start), projection.project(end));
    let context = || format!("{projection} {}: {start:?} is {from:?}, {end:?} is {to:?}", T::NAME);
    let here = [from.x(), from.y()];
    let expected = if from.face() == to.face() {
        here
    } else {
        let neighbours = Edge::ALL.map(|edge| (edge, from.face().neighbour(edge)));
        let Some((edge, neighbour)) = neighbours.into_iter().find(|(_, n)| n.face == to.face()) else {
            panic!("the other side: {}", context());
        };
        if !projection.faces().agree(from.face(), edge) {
            return;
        }
        beyond(here, edge, neighbour.turns)
    };
    let moved = maximum(ulps(expected[0], to.x()), ulps(expected[1], to.y()));
    let (before, after) = (start.to_array(), end.to_array());
    let count = Worst::of((0..3).map(|i| ulps(before[i], after[i])));
    let allowed = match projection {
        Projection::Conformal => {
            // Near a corner a coordinate goes with the ¾th power of the distance.
            let ulp = 0.5 * T::EPSILON.into();
            let near = |v: T| 1.0 - v.abs().into();
            let corner = maximum(near(from.x()).hypot(near(from.y())), ((count + 2.0) * ulp).powf(0.75));
            (2.0 * count + 8.0) * corner.powf(-1.0 / 3.0)
        }
        _ => 3.0 * count + 6.0,
    };
    assert!(moved <= allowed, "{}: {moved} ulps after {count}", context());
}
