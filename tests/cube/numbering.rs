//! The numberings of S2, OpenGL and FITS, against their own formulas typed from their own specifications; those of
//! climate models and of video by which edges meet.

use terrella::Direction;
use terrella::cube::{
    Adjusted, CubeProjection, Face, FacePoint, InvalidFace, InvalidFacePoint, InvalidNumbered, Numbering, Tangential,
};

use crate::sample::{Scalar, coordinates, directions};

const SPECIFIED: [Numbering; 3] = [Numbering::S2, Numbering::OpenGl, Numbering::Fits];
const ALL: [Numbering; 4] = [Numbering::S2, Numbering::OpenGl, Numbering::Fits, Numbering::Eac];

/// S2's face_xyz_to_uv (s2coords.h): gnomonic coordinates of a vector on a face.
fn s2<T: Scalar>(face: u8, [x, y, z]: [T; 3]) -> (T, T) {
    match face {
        0 => (y / x, z / x),
        1 => (-x / y, z / y),
        2 => (-x / z, -y / z),
        3 => (z / x, y / x),
        4 => (z / y, -x / y),
        5 => (-y / z, -x / z),
        _ => panic!("{face}"),
    }
}

/// OpenGL 4.6, table 8.19: (sc, tc, ma) by the major axis; the coordinates are sc/|ma| and tc/|ma|, to the right and down.
fn open_gl<T: Scalar>(face: u8, [x, y, z]: [T; 3]) -> (T, T) {
    // A renderer's axes: its x is the Earth's y, its y the Earth's z, its z the Earth's x.
    let (rx, ry, rz) = (y, z, x);
    let (sc, tc, ma) = match face {
        0 => (-rz, -ry, rx),
        1 => (rz, -ry, rx),
        2 => (rx, rz, ry),
        3 => (rx, -rz, ry),
        4 => (rx, -ry, rz),
        5 => (-rx, -ry, rz),
        _ => panic!("{face}"),
    };
    (sc / ma.abs(), tc / ma.abs())
}

/// Calabretta & Greisen (2002), table 12: (ξ, η, ζ) of the direction cosines (l, m, n); χ = ξ/ζ, ψ = η/ζ.
fn fits<T: Scalar>(face: u8, [l, m, n]: [T; 3]) -> (T, T) {
    let (xi, eta, zeta) = match face {
        0 => (m, -l, n),
        1 => (m, n, l),
        2 => (-l, n, m),
        3 => (-m, n, -l),
        4 => (l, n, -m),
        5 => (m, l, -n),
        _ => panic!("{face}"),
    };
    (xi / zeta, eta / zeta)
}

fn specification<T: Scalar>(numbering: Numbering, face: u8, vector: [T; 3]) -> (T, T) {
    match numbering {
        Numbering::S2 => s2(face, vector),
        Numbering::OpenGl => open_gl(face, vector),
        Numbering::Fits => fits(face, vector),
        other => panic!("{other:?}"),
    }
}

/// The outward axes of faces 0 to 5, from the specifications.
fn centres(numbering: Numbering) -> [[f64; 3]; 6] {
    let (x, y, z) = ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let minus = |v: [f64; 3]| v.map(|c| 0.0 - c);
    match numbering {
        Numbering::S2 => [x, y, z, minus(x), minus(y), minus(z)],
        Numbering::OpenGl => [y, minus(y), z, minus(z), x, minus(x)],
        Numbering::Fits => [z, x, y, minus(x), minus(y), minus(z)],
        other => panic!("{other:?}"),
    }
}

#[test]
fn numbers_are_those_of_the_axes() {
    for numbering in SPECIFIED {
        for (number, [x, y, z]) in centres(numbering).into_iter().enumerate() {
            let number = number as u8;
            let face = Face::containing(Direction::new(x, y, z).unwrap());
            assert_eq!(numbering.number(face), number, "{numbering:?} {face:?}");
            assert_eq!(numbering.face(number), Ok(face), "{numbering:?}");
        }
    }
}

fn coordinates_are_theirs<T: Scalar>(numbering: Numbering) {
    for direction in directions::<T>(5, 20_000) {
        let (face, x, y) = numbering.to_point(Tangential.project(direction));
        let theirs = specification(numbering, face, direction.to_array());
        assert_eq!((x, y), theirs, "{numbering:?} face {face} {direction:?}");
    }
}

#[test]
fn coordinates_are_those_of_the_specifications() {
    for numbering in SPECIFIED {
        coordinates_are_theirs::<f64>(numbering);
        coordinates_are_theirs::<f32>(numbering);
    }
}

fn there_and_back<T: Scalar>(numbering: Numbering) {
    let numbers = coordinates::<T>(6, 30);
    for face in Face::ALL {
        for &x in &numbers {
            for &y in &numbers {
                let point = FacePoint::new(face, x, y).unwrap();
                let (number, a, b) = numbering.to_point(point);
                let back = numbering.from_point(number, a, b).unwrap();
                assert_eq!(back, point, "{numbering:?}");
                // A zero's sign survives too.
                assert_eq!(
                    (back.x().bits(), back.y().bits()),
                    (x.bits(), y.bits()),
                    "{numbering:?} {point:?}"
                );
                assert_eq!(
                    numbering.to_point(numbering.from_point(number, x, y).unwrap()),
                    (number, x, y),
                    "{numbering:?} {number} {x:?} {y:?}"
                );
            }
        }
    }
}

#[test]
fn points_come_back() {
    for numbering in ALL {
        there_and_back::<f64>(numbering);
        there_and_back::<f32>(numbering);
    }
}

#[test]
fn numbers_above_5_are_refused() {
    for numbering in ALL {
        for number in 6..=u8::MAX {
            assert_eq!(numbering.face(number), Err(InvalidFace(number)), "{numbering:?}");
            assert_eq!(
                numbering.from_point(number, 0.5, 0.5),
                Err(InvalidNumbered::Face(InvalidFace(number))),
                "{numbering:?}"
            );
        }
    }
}

fn refused_off_the_face<T: Scalar>(numbering: Numbering) {
    let bad = [
        T::ONE.above(),
        -T::ONE.above(),
        T::of(f64::INFINITY),
        T::of(f64::NEG_INFINITY),
        T::of(f64::NAN),
    ];
    let good = [T::ZERO, T::ONE, T::of(-0.25)];
    for number in 0..6 {
        for b in bad {
            for g in good {
                for (x, y) in [(b, g), (g, b), (b, b)] {
                    let refused = numbering.from_point(number, x, y);
                    let Err(InvalidNumbered::Point(InvalidFacePoint { x: cx, y: cy })) = refused else {
                        panic!("{numbering:?} {number} {x:?} {y:?} gave {refused:?}");
                    };
                    // As they were given, not as they would be on this crate's face.
                    assert_eq!((cx.bits(), cy.bits()), (x.bits(), y.bits()), "{numbering:?} {number}");
                }
            }
        }
    }
}

#[test]
fn coordinates_off_the_face_are_refused() {
    for numbering in ALL {
        refused_off_the_face::<f64>(numbering);
        refused_off_the_face::<f32>(numbering);
    }
}

/// A place on an edge of a face: 'N', 'S', 'E' or 'W', from −1 at its western or southern end to 1.
fn on_edge(edge: char, along: f64) -> [f64; 2] {
    match edge {
        'N' => [along, 1.0],
        'S' => [along, -1.0],
        'E' => [1.0, along],
        _ => [-1.0, along],
    }
}

fn meet(numbering: Numbering, [first, second]: [(u8, char); 2], forward: bool) {
    for along in [-0.75, -0.25, 0.5] {
        let direction = |(face, edge): (u8, char), along: f64| {
            let [x, y] = on_edge(edge, along);
            Adjusted.unproject(numbering.from_point(face, x, y).unwrap())
        };
        let other = if forward { along } else { -along };
        assert_eq!(
            direction(first, along),
            direction(second, other),
            "{numbering:?} {first:?} {second:?}"
        );
    }
}

/// The twelve contacts of the mosaic that GFDL's models define, by tiles from 1; MITgcm's six domains name the same edges.
#[test]
fn s2s_faces_are_the_tiles_of_fv3_and_the_faces_of_mitgcm() {
    for (first, second, forward) in [
        ((1, 'E'), (2, 'W'), true),
        ((1, 'N'), (3, 'W'), false),
        ((1, 'W'), (5, 'N'), false),
        ((1, 'S'), (6, 'N'), true),
        ((2, 'N'), (3, 'S'), true),
        ((2, 'E'), (4, 'S'), false),
        ((2, 'S'), (6, 'E'), false),
        ((3, 'E'), (4, 'W'), true),
        ((3, 'N'), (5, 'W'), false),
        ((4, 'N'), (5, 'S'), true),
        ((4, 'E'), (6, 'S'), false),
        ((5, 'E'), (6, 'W'), true),
    ] {
        meet(
            Numbering::S2,
            [first, second].map(|(tile, edge)| (tile - 1, edge)),
            forward,
        );
    }
}

/// Left, front, right; bottom, back, top: a row is one strip of the sphere, and the first row is upright.
#[test]
fn rows_of_the_picture_of_three_by_two_are_strips() {
    let order = [
        Face::Left,
        Face::Front,
        Face::Right,
        Face::Bottom,
        Face::Back,
        Face::Top,
    ];
    assert_eq!(order.map(|face| Numbering::Eac.number(face)), [0, 1, 2, 3, 4, 5]);
    for west in [0, 1, 3, 4] {
        meet(Numbering::Eac, [(west, 'E'), (west + 1, 'W')], true);
    }
    let point = FacePoint::new(Face::Front, 0.25, 0.5).unwrap();
    assert_eq!(Numbering::Eac.to_point(point), (1, 0.25, 0.5));
}
