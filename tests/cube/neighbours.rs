//! What lies across an edge and around a corner, against the cube cut open and laid flat.

use std::collections::BTreeMap;

use terrella::cube::{Corner, CubeProjection, Edge, Face, FacePoint};

use crate::sample::every_projection;
use testkit::unfolded::{Vector, all_edges, at_corner, beyond, combine, cross, dot, frame, normal, on_edge};

/// The neighbour by geometry: the face whose outward vector is the edge's.
fn across(face: Face, edge: Edge) -> Face {
    let [right, up, _] = frame(face);
    let [ex, ey] = normal::<f64>(edge);
    let out = combine([ex, ey, 0.0], [right, up, [0.0; 3]]);
    Face::ALL.into_iter().find(|&other| frame(other)[2] == out).unwrap()
}

/// A vector by its components doubled, to key a map.
fn key(vector: Vector) -> [i8; 3] {
    vector.map(|v| (2.0 * v) as i8)
}

/// Beyond an edge the cube goes on at a right angle: a way t past the edge is a way t down the neighbour.
#[test]
fn unfolding_follows_the_documented_rule() {
    for (face, edge) in all_edges() {
        let [right, up, outward] = frame(face);
        let neighbour = face.neighbour(edge);
        assert_eq!(neighbour.face, across(face, edge), "{face:?} {edge:?}");
        assert!(neighbour.turns < 4, "{face:?} {edge:?}");
        let [ex, ey] = normal::<f64>(edge);
        for t in [0.0, 0.25, 1.0, 2.0] {
            for s in [-1.0, -0.5, 0.0, 0.125, 1.0] {
                let [u, v] = on_edge(edge, s);
                let on_cube = combine([u, v, 1.0 - t], [right, up, outward]);
                let [right, up, outward] = frame(neighbour.face);
                assert_eq!(dot(on_cube, outward), 1.0, "{face:?} {edge:?}");
                let expected = [dot(on_cube, right), dot(on_cube, up)];
                let unfolded = [u + t * ex, v + t * ey];
                assert_eq!(
                    beyond(unfolded, edge, neighbour.turns),
                    expected,
                    "{face:?} {edge:?} {unfolded:?}"
                );
            }
        }
    }
}

#[test]
fn the_neighbour_names_the_same_edge() {
    for (face, edge) in all_edges() {
        let neighbour = face.neighbour(edge);
        let middle = |face: Face, edge: Edge| {
            let [u, v] = normal::<f64>(edge);
            combine([u, v, 1.0], frame(face))
        };
        assert_eq!(
            middle(face, edge),
            middle(neighbour.face, neighbour.edge),
            "{face:?} {edge:?}"
        );
    }
}

#[test]
fn going_there_and_back_is_no_move() {
    for (face, edge) in all_edges() {
        let there = face.neighbour(edge);
        let back = there.face.neighbour(there.edge);
        assert_eq!((back.face, back.edge), (face, edge), "{face:?} {edge:?}");
        assert_eq!((there.turns + back.turns) % 4, 0, "{face:?} {edge:?}");
    }
}

#[test]
fn twelve_edges_each_of_two_faces() {
    let mut seen = BTreeMap::<_, Vec<_>>::new();
    for (face, edge) in all_edges() {
        let [u, v] = normal::<f64>(edge);
        seen.entry(key(combine([u, v, 1.0], frame(face))))
            .or_default()
            .push(face);
    }
    assert_eq!(seen.len(), 12);
    assert!(seen.values().all(|faces| faces.len() == 2), "{seen:?}");
}

/// Going round four faces by the same edge, straight ahead, comes back to the start as it was.
#[test]
fn straight_ahead_goes_round_the_cube() {
    for (start, heading) in all_edges() {
        let (mut face, mut edge) = (start, heading);
        let mut visited = Vec::new();
        for _ in 0..4 {
            visited.push(face);
            let next = face.neighbour(edge);
            // Leave by the edge opposite the one entered through.
            (face, edge) = (next.face, Edge::ALL[(next.edge as usize + 2) % 4]);
        }
        assert_eq!((face, edge), (start, heading), "{visited:?}");
        visited.sort();
        visited.dedup();
        assert_eq!(visited.len(), 4, "{start:?} {heading:?}");
    }
}

#[test]
fn a_corner_is_between_its_edges() {
    for corner in Corner::ALL {
        let (ends, begins) = corner.edges();
        let ([ax, ay], [bx, by]) = (normal::<f64>(ends), normal::<f64>(begins));
        assert_eq!([ax + bx, ay + by], at_corner(corner), "{corner:?}");
        assert_eq!(ax * by - ay * bx, 1.0, "{corner:?}: not counter-clockwise");
    }
}

#[test]
fn eight_corners_each_of_three_faces() {
    let vector = |(face, corner): (Face, Corner)| {
        let [u, v] = at_corner(corner);
        combine([u, v, 1.0], frame(face))
    };
    let mut seen = BTreeMap::<_, Vec<_>>::new();
    for face in Face::ALL {
        for corner in Corner::ALL {
            let around = face.corner(corner);
            assert_eq!(around[0], (face, corner));
            let [first, second, third] = around.map(vector);
            assert!(first == second && second == third, "{around:?} are different corners");
            // Seen from outside the normals turn counter-clockwise if they are right-handed.
            let [a, b, c] = around.map(|(face, _)| frame(face)[2]);
            assert_eq!(dot(cross(a, b), c), 1.0, "{around:?} is clockwise");
            seen.entry(key(first)).or_default().push(face);
        }
    }
    assert_eq!(seen.len(), 8);
    for faces in seen.values_mut() {
        faces.sort();
        faces.dedup();
        assert_eq!(faces.len(), 3, "{faces:?}");
    }
}

#[test]
fn any_face_of_a_corner_gives_the_same_cycle() {
    for face in Face::ALL {
        for corner in Corner::ALL {
            let [a, b, c] = face.corner(corner);
            assert_eq!(b.0.corner(b.1), [b, c, a], "{face:?} {corner:?}");
        }
    }
}

/// A sample just inside an edge and the one that `neighbour` finds just beyond it are side by side on the sphere, in every
/// projection: interpolation across a face's edge reads the right texel.
#[test]
fn space_teams_pro_178_interpolation_across_an_edge() {
    let step = 1.0 / 64.0;
    every_projection(|projection| {
        for (face, edge) in all_edges() {
            let neighbour = face.neighbour(edge);
            let [ex, ey] = normal::<f64>(edge);
            for i in -7..=7 {
                let [x, y] = on_edge(edge, f64::from(i) / 8.0);
                let inside = FacePoint::new(face, x - step * ex, y - step * ey).unwrap();
                let [bx, by] = beyond([x + step * ex, y + step * ey], edge, neighbour.turns);
                let outside = FacePoint::new(neighbour.face, bx, by).unwrap();
                let [a, b] = [inside, outside].map(|p| projection.unproject(p).to_array());
                let distance = (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f64>().sqrt();
                assert!(distance < 3.0 * step, "{projection}: {inside:?} {outside:?} {distance}");
            }
        }
    });
}
