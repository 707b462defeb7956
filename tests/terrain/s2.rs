//! S2's own cells, also for points on the lines between cells, where S2's order of axes and its rounding
//! decide.

use fastrand::Rng;
use terrella::cube::{CubeProjection, Face, FacePoint, InvalidFace, InvalidNumbered, Numbering, S2Quadratic};
use terrella::terrain::{Hilbert, InvalidNumberedTile, InvalidTile, Key, Tile};
use terrella::{Direction, LatLon};

use crate::sample;

/// Vectors and leaf cells by S2 in C++.
fn truth() -> impl Iterator<Item = ([f64; 3], u64)> {
    include_str!("../truth/s2_cells.tsv").lines().skip(3).map(|line| {
        let values: Vec<_> = line.split('\t').collect();
        let vector = [0, 1, 2].map(|at| values[at].parse().unwrap());
        (vector, u64::from_str_radix(values[3], 16).unwrap())
    })
}

fn token(lat: f64, lon: f64, level: u8) -> String {
    let direction = LatLon::new(lat, lon).unwrap().to_direction();
    Key::s2_leaf(direction).ancestor(level).unwrap().to_string()
}

#[test]
fn cells_are_those_of_s2_in_cpp_bit_for_bit() {
    let mut count = 0;
    for (vector, id) in truth() {
        assert_eq!(Key::s2_leaf_of(vector).unwrap().bits(), id, "{vector:?}");
        count += 1;
    }
    assert!(count > 2000, "{count} rows");
}

/// Google's s2geometry, `S2CellId(S2LatLng::FromDegrees(lat, lon))` and `S2CellId(S2Point)`, parents of level 10.
#[test]
fn places_on_lines_between_cells_are_in_s2s_own() {
    for (lat, lon, cell, ours) in [
        (90.0, 0.0, "500001", "5aaaab"),
        (51.4779, 0.0, "487603", "47d8a9"),
        (0.0, -78.5, "91d587", "8e2a79"),
    ] {
        assert_eq!(token(lat, lon, 10), cell, "{lat} {lon}");
        // The tile, by this crate's axes.
        let point = S2Quadratic.project(LatLon::new(lat, lon).unwrap().to_direction());
        let tile = Tile::containing(point, 10).unwrap();
        assert_eq!(Key::<Hilbert>::from(tile).to_string(), ours, "{lat} {lon}");
    }
    let of = |vector| Key::s2_leaf_of(vector).unwrap().ancestor(10).unwrap().to_string();
    assert_eq!(of([1.0, 1.0, 1.0]), "400001");
    let [x, y, z] = Direction::new(1.0, 1.0, 1.0).unwrap().to_array();
    assert_eq!(of([x, y, z]), "400001");
    assert_eq!(Key::s2_leaf_of([0.0, 1.0, 1.0]).unwrap().bits() >> 61, 2);
    assert_eq!(token(48.8566, 2.3522, 10), "47e66f");
    assert_eq!(token(40.7128, -74.006, 10), "89c25b");
    assert_eq!(token(-33.8688, 151.2093, 10), "6b12af");
}

/// S2's suite, IDFromPointExample1: 1.1·10⁻⁷ of a cell below an edge, where S2 rounds up.
#[test]
fn a_place_that_s2_rounds_into_another_cell_is_in_that() {
    let vector = [
        0.382_031_410_400_356_32,
        0.030_196_609_707_941_954,
        0.923_655_870_023_928_9,
    ];
    assert_eq!(Key::s2_leaf_of(vector).unwrap().bits(), 0x45fd_79ac_9bb9_3ad3);
}

/// Inside of a cell there is no choice: the tile of the same key.
#[test]
fn inside_of_a_cell_is_its_tile() {
    let mut rng = Rng::with_seed(3);
    for _ in 0..50_000 {
        let level = rng.u8(0..24);
        let tile = sample::tile_of(&mut rng, level);
        let place: [f64; 2] = [rng.f64() * 0.98 + 0.01, rng.f64() * 0.98 + 0.01];
        let direction = S2Quadratic.unproject(tile.point(place).unwrap());
        let key = Key::s2_leaf(direction).ancestor(level).unwrap();
        assert_eq!(Tile::from(key), tile);
        let point = S2Quadratic.project(direction);
        assert_eq!(Tile::containing(point, level), Ok(tile));
    }
}

/// S2's s2coords_test.cc, STtoIJHalfway and STtoIJBoundaries.
#[test]
fn coordinates_of_cells_are_rounded_down() {
    let count = f64::from(1 << 30);
    for (place, i) in [
        (0.0, 0),
        (0.5, 0),
        (1.0, 1),
        (1.5, 1),
        (2.0, 2),
        (4.5, 4),
        (count - 2.5, (1 << 30) - 3),
        (count - 2.0, (1 << 30) - 2),
        (count - 0.5, (1 << 30) - 1),
        (count, (1 << 30) - 1),
    ] {
        let key = Key::s2_leaf_at(0, [place / count, 0.5]).unwrap();
        assert_eq!(Tile::from(key).to_numbering(Numbering::S2), (0, i, 1 << 29), "{place}");
    }
    assert_eq!(Key::s2_leaf_at(0, [0.0, 0.5]).unwrap().bits(), 0x0800_0000_0000_0001);
    assert_eq!(Key::s2_leaf_at(0, [1.0, 0.5]).unwrap().bits(), 0x17ff_ffff_ffff_ffff);
}

#[test]
fn what_has_no_cell_is_refused() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for at in 0..3 {
            let mut vector = [0.6, 0.0, 0.8];
            vector[at] = bad;
            let error = Key::s2_leaf_of(vector).unwrap_err();
            assert_eq!([error.x, error.y, error.z].map(f64::to_bits), vector.map(f64::to_bits));
        }
        let refused = Key::s2_leaf_at(5, [0.5, bad]).unwrap_err();
        assert!(matches!(refused, InvalidNumbered::Point(p) if p.x == 0.5 && p.y.to_bits() == bad.to_bits()));
    }
    assert!(Key::s2_leaf_of([0.0, -0.0, 0.0]).is_err());
    assert!(Key::s2_leaf_of([0.0, -0.0, 5e-324]).is_ok());
    assert!(Key::s2_leaf_of([f64::MAX, f64::MAX, f64::MIN]).is_ok());
    assert_eq!(
        Key::s2_leaf_at(6, [0.5, 0.5]),
        Err(InvalidNumbered::Face(InvalidFace(6)))
    );
    for bad in [-f64::EPSILON, 1.0 + f64::EPSILON] {
        assert!(Key::s2_leaf_at(0, [bad, 0.5]).is_err());
    }
    let numbered = |face, level, i, j| Tile::from_numbering(Numbering::Fits, face, level, i, j);
    assert_eq!(numbered(6, 0, 0, 0), Err(InvalidNumberedTile::Face(InvalidFace(6))));
    assert_eq!(
        numbered(0, 31, 0, 0),
        Err(InvalidNumberedTile::Tile(InvalidTile::Level(31)))
    );
    let column = InvalidNumberedTile::Tile(InvalidTile::Column { level: 2, i: 4 });
    assert_eq!(numbered(0, 2, 4, 0), Err(column));
    assert_eq!(column.to_string(), "column 4 is not in 0 to 2^2 - 1");
}

/// Tiles go where their middles go.
#[test]
fn tiles_are_numbered_as_their_points_are() {
    let mut rng = Rng::with_seed(4);
    for numbering in [Numbering::S2, Numbering::OpenGl, Numbering::Fits] {
        for _ in 0..20_000 {
            let tile = sample::tile(&mut rng);
            let (face, i, j) = tile.to_numbering(numbering);
            assert_eq!(Tile::from_numbering(numbering, face, tile.level(), i, j), Ok(tile));
            let (number, x, y) = numbering.to_point(tile.centre::<f64>());
            let there = Tile::new(Face::Front, tile.level(), i, j).unwrap();
            let point = FacePoint::new(Face::Front, x, y).unwrap();
            assert_eq!((number, point), (face, there.centre()), "{numbering:?} {tile:?}");
        }
    }
}
