//! The seams of the cube: a point on an edge or a corner is one direction, whichever face it is named on.
//!
//! The measure is the ulp of a unit vector's large components and of a coordinate near 1, half of `T::EPSILON`. Zeros of
//! either sign are equal.

use terrella::Direction;
use terrella::cube::{Corner, CubeProjection, Edge, Face, FacePoint, Projection};
use testkit::Worst;

use crate::sample::{Scalar, coordinates, every_projection, ulps};
use testkit::unfolded::{across_and_along, all_edges, at_corner, beyond, normal, on_edge};

/// How far from exact a seam may be, in ulps.
#[derive(Clone, Copy)]
struct Seam {
    /// Between a component of the direction from one face and from the other.
    joint: f64,
    /// Between 1 and the coordinate across the edge, of a direction on the edge.
    across: f64,
    /// Between the coordinate along the edge from one face and from the other.
    along: f64,
}

/// What is not listed is exact, as every new projection should be.
const fn seam(projection: Projection) -> Seam {
    let (joint, across, along) = match projection {
        // The parallel sin φ = ⅔: a side face has it as ⅔y, a polar one as 1 − σ²/3. The meridians are exact, see below.
        Projection::Healpix => (1.0, 0.0, 0.0),
        // The square root of a difference of squares is rounded between u = 1 and x.
        Projection::Cartesian => (0.0, 1.0, 3.0),
        _ => (0.0, 0.0, 0.0),
    };
    Seam { joint, across, along }
}

fn direction<T: Scalar>(projection: Projection, face: Face, [x, y]: [T; 2]) -> [T; 3] {
    projection.unproject(FacePoint::new(face, x, y).unwrap()).to_array()
}

fn apart<T: Scalar>(a: [T; 3], b: [T; 3]) -> f64 {
    Worst::of((0..3).map(|i| ulps(a[i], b[i])))
}

/// The edges along which a projection says that faces agree.
fn agreeing(projection: Projection) -> impl Iterator<Item = (Face, Edge)> {
    all_edges().filter(move |&(face, edge)| projection.faces().agree(face, edge))
}

fn inverse_meets<T: Scalar>(projection: Projection) {
    for (face, edge) in agreeing(projection) {
        let neighbour = face.neighbour(edge);
        for s in coordinates::<T>(7, 1000) {
            let here = on_edge(edge, s);
            let there = beyond(here, edge, neighbour.turns);
            let (a, b) = (
                direction(projection, face, here),
                direction(projection, neighbour.face, there),
            );
            assert!(
                apart(a, b) <= seam(projection).joint,
                "{projection} {}: {face:?} {here:?} is {a:?}, {:?} {there:?} is {b:?}",
                T::NAME,
                neighbour.face
            );
        }
    }
}

#[test]
fn a_point_on_an_edge_is_one_direction_from_both_faces() {
    every_projection(|projection| {
        inverse_meets::<f64>(projection);
        inverse_meets::<f32>(projection);
    });
}

/// Along the other edges they do not: a face and its neighbour say the same of it.
#[test]
fn faces_part_where_the_projection_says_so() {
    every_projection(|projection| {
        let faces = projection.faces();
        for (face, edge) in all_edges() {
            let neighbour = face.neighbour(edge);
            let here = on_edge(edge, 0.5);
            let there = beyond(here, edge, neighbour.turns);
            let moved = apart(
                direction(projection, face, here),
                direction(projection, neighbour.face, there),
            );
            assert_eq!(faces.agree(face, edge), moved < 2.0, "{projection}, {face:?} {edge:?}");
            assert_eq!(
                faces.agree(face, edge),
                faces.agree(neighbour.face, neighbour.edge),
                "{projection}, {face:?} {edge:?}"
            );
        }
    });
}

/// Healpix's seams along meridians are exact, unlike those along parallels.
fn healpix_meridians<T: Scalar>() {
    for face in [Face::Front, Face::Right, Face::Back, Face::Left] {
        let neighbour = face.neighbour(Edge::Right);
        for s in coordinates::<T>(8, 3000) {
            let here = on_edge(Edge::Right, s);
            let there = beyond(here, Edge::Right, neighbour.turns);
            assert_eq!(
                direction(Projection::Healpix, face, here),
                direction(Projection::Healpix, neighbour.face, there),
                "{} {face:?} {here:?}",
                T::NAME
            );
        }
    }
}

#[test]
fn healpix_meets_exactly_along_meridians() {
    healpix_meridians::<f64>();
    healpix_meridians::<f32>();
}

fn corners_meet<T: Scalar>(projection: Projection) {
    // Of a true corner of the cube; Healpix has its own at sin φ = ⅔ on the diagonal meridians.
    let expected = if projection == Projection::Healpix {
        [(5.0f64 / 18.0).sqrt(), (5.0f64 / 18.0).sqrt(), 2.0 / 3.0]
    } else {
        [(1.0f64 / 3.0).sqrt(); 3]
    };
    for face in Face::ALL {
        for corner in Corner::ALL {
            let around = face.corner(corner);
            let [a, b, c] = around.map(|(face, corner)| direction::<T>(projection, face, at_corner(corner)));
            let joint = seam(projection).joint;
            assert!(
                apart(a, b) <= joint && apart(b, c) <= joint && apart(c, a) <= joint,
                "{projection} {}: {around:?} give {a:?} {b:?} {c:?}",
                T::NAME
            );
            assert!(
                apart(a.map(T::abs), expected.map(T::of)) <= 1.0,
                "{projection} {} {around:?}: {a:?} is not the corner {expected:?}",
                T::NAME
            );
        }
    }
}

#[test]
fn a_corner_is_one_direction_from_three_faces() {
    every_projection(|projection| {
        corners_meet::<f64>(projection);
        corners_meet::<f32>(projection);
    });
}

/// Directions on an edge: two components of equal magnitude, the third no larger.
fn on_ties<T: Scalar>(face: Face, edge: Edge) -> impl Iterator<Item = Direction<T>> {
    coordinates::<T>(9, 1000).into_iter().map(move |s| {
        let [u, v] = on_edge(edge, s);
        let [x, y, z] = face.to_earth([u, v, T::ONE]);
        Direction::new(x, y, z).unwrap()
    })
}

fn forward_meets<T: Scalar>(projection: Projection) {
    let allowed = seam(projection);
    for (face, edge) in agreeing(projection) {
        let neighbour = face.neighbour(edge);
        let meridian = !face.is_polar() && !neighbour.face.is_polar();
        if projection == Projection::Healpix && !meridian {
            continue; // the cube's edge is none of Healpix's
        }
        for direction in on_ties::<T>(face, edge) {
            if projection.face(direction).is_polar() && meridian {
                continue; // beyond Healpix's border
            }
            let on = |face: Face| projection.forward(face, face.to_local(direction.to_array()));
            let (here, there) = (on(face), on(neighbour.face));
            let (across, along) = across_and_along(here, edge);
            let (_, theirs) = across_and_along(there, neighbour.edge);
            // The edge runs backward on the neighbour, or does not: as `neighbour` says.
            let (_, same) = across_and_along(beyond(on_edge(edge, along), edge, neighbour.turns), neighbour.edge);
            let context = || {
                format!(
                    "{projection} {}: {face:?} {edge:?} {direction:?} {here:?} {there:?}",
                    T::NAME
                )
            };
            assert!(ulps(across, T::ONE) <= allowed.across, "{}", context());
            assert!(ulps(same, theirs) <= allowed.along, "{}", context());
        }
    }
}

#[test]
fn a_direction_on_an_edge_has_a_coordinate_1_from_both_faces() {
    every_projection(|projection| {
        forward_meets::<f64>(projection);
        forward_meets::<f32>(projection);
    });
}

/// What `project` says of a tie: on the face that `Face::containing` chooses, at its edge.
fn projects_to_edge<T: Scalar>(projection: Projection) {
    let allowed = seam(projection).across;
    for (face, edge) in all_edges() {
        for direction in on_ties::<T>(face, edge) {
            if projection == Projection::Healpix && (face.is_polar() || face.neighbour(edge).face.is_polar()) {
                continue;
            }
            let point = projection.project(direction);
            if projection == Projection::Healpix && point.face().is_polar() {
                continue;
            }
            let outer = if point.x().abs() > point.y().abs() {
                point.x()
            } else {
                point.y()
            };
            assert!(
                ulps(outer.abs(), T::ONE) <= allowed,
                "{projection} {}: {direction:?} is at {point:?}",
                T::NAME
            );
        }
    }
}

#[test]
fn a_direction_on_an_edge_projects_to_the_edge() {
    every_projection(|projection| {
        projects_to_edge::<f64>(projection);
        projects_to_edge::<f32>(projection);
    });
}

/// A corner of the cube has coordinates (±1, ±1) on each of its faces.
fn corners_project<T: Scalar>(projection: Projection) {
    let allowed = seam(projection).across;
    for face in Face::ALL {
        for corner in Corner::ALL {
            let [u, v] = at_corner::<T>(corner);
            let [x, y, z] = face.to_earth([u, v, T::ONE]);
            let direction = Direction::new(x, y, z).unwrap();
            let [x, y] = projection.forward(face, face.to_local(direction.to_array()));
            assert!(
                ulps(x, u) <= allowed && ulps(y, v) <= allowed,
                "{projection} {}: {face:?} {corner:?} is at ({x:?}, {y:?})",
                T::NAME
            );
        }
    }
}

#[test]
fn a_corner_projects_to_the_corner() {
    every_projection(|projection| {
        if projection != Projection::Healpix {
            corners_project::<f64>(projection);
            corners_project::<f32>(projection);
        }
    });
}

/// The direction of a point on sin φ = ±⅔ is back on the border from both faces: within 4 ulps across it, 6 along it.
///
/// Toward 1 a polar face's σ has to come out of √(3(1 − z)), so that an ulp of z is 1.5 of σ.
fn healpix_parallels<T: Scalar>() {
    let projection = Projection::Healpix;
    for face in [Face::Front, Face::Right, Face::Back, Face::Left] {
        for edge in [Edge::Up, Edge::Down] {
            let neighbour = face.neighbour(edge);
            for s in coordinates::<T>(10, 3000) {
                let here = on_edge(edge, s);
                let there = beyond(here, edge, neighbour.turns);
                for vector in [
                    direction(projection, face, here),
                    direction(projection, neighbour.face, there),
                ] {
                    for (face, edge, expected) in [(face, edge, here), (neighbour.face, neighbour.edge, there)] {
                        let (across, along) = across_and_along(projection.forward(face, face.to_local(vector)), edge);
                        let (_, truth) = across_and_along(expected, edge);
                        assert!(
                            ulps(across, T::ONE) <= 4.0 && ulps(along, truth) <= 6.0,
                            "{}: {vector:?} is at {across:?}, {along:?} and not at 1, {truth:?} of {face:?}",
                            T::NAME
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn healpix_meets_along_parallels() {
    healpix_parallels::<f64>();
    healpix_parallels::<f32>();
}

/// Edges go to edges: what lies on the edge of a face lies in the plane between the two faces.
fn edges_are_edges<T: Scalar>(projection: Projection) {
    for (face, edge) in all_edges() {
        for s in coordinates::<T>(11, 300) {
            let [right, up, outward] = face.to_local(direction(projection, face, on_edge(edge, s)));
            let [ex, ey] = normal::<T>(edge);
            assert!(
                right * ex + up * ey == outward,
                "{projection} {}: {face:?} {edge:?} {s:?} is ({right:?}, {up:?}, {outward:?})",
                T::NAME
            );
        }
    }
}

#[test]
fn edges_of_faces_are_edges_of_the_cube() {
    every_projection(|projection| {
        if projection != Projection::Healpix {
            edges_are_edges::<f64>(projection);
            edges_are_edges::<f32>(projection);
        }
    });
}
