//! Cells of n × n, for n that are no powers of two too: corners against the surface of the cube, places against corners.

use std::collections::BTreeMap;

use fastrand::Rng;
use terrella::cube::{Cell, Corner, Edge, Face, FacePoint, InvalidCell};
use terrella::terrain::Tile;
use testkit::scalar::Scalar;

/// A corner on the surface of the cube, in whole numbers: −n to n.
fn on_cube(cell: Cell, corner: Corner) -> [i64; 3] {
    let point = cell.corner::<f64>(corner);
    let n = f64::from(cell.n());
    point
        .face()
        .to_earth([point.x(), point.y(), 1.0])
        .map(|v| (v * n).round() as i64)
}

fn all(n: u32) -> impl Iterator<Item = Cell> {
    Face::ALL
        .into_iter()
        .flat_map(move |face| (0..n * n).map(move |number| Cell::new(face, n, number % n, number / n).unwrap()))
}

/// Neighbours are the cells that share two corners, diagonal ones those that share one.
#[test]
fn neighbours_share_corners() {
    for n in [1, 2, 3, 5, 7] {
        let mut meeting = BTreeMap::<_, Vec<_>>::new();
        for cell in all(n) {
            for corner in Corner::ALL {
                meeting.entry(on_cube(cell, corner)).or_default().push(cell);
            }
        }
        for cell in all(n) {
            for edge in Edge::ALL {
                let ends = [Corner::ALL[(edge as usize + 3) % 4], Corner::ALL[edge as usize]];
                let [one, two] = ends.map(|corner| &meeting[&on_cube(cell, corner)]);
                let sharing: Vec<_> = one
                    .iter()
                    .filter(|&&other| other != cell && two.contains(&other))
                    .collect();
                assert_eq!(sharing, [&cell.neighbour(edge)], "{cell} {edge:?}");
            }
            for corner in Corner::ALL {
                let (first, second) = corner.edges();
                let near = [cell, cell.neighbour(first), cell.neighbour(second)];
                let rest: Vec<_> = meeting[&on_cube(cell, corner)]
                    .iter()
                    .filter(|other| !near.contains(other))
                    .copied()
                    .collect();
                assert_eq!(
                    rest,
                    cell.diagonal(corner).into_iter().collect::<Vec<_>>(),
                    "{cell} {corner:?}"
                );
            }
        }
    }
}

#[test]
fn powers_of_two_are_tiles() {
    for cell in all(8) {
        let tile = Tile::new(cell.face(), 3, cell.i(), cell.j()).unwrap();
        assert_eq!(cell.corners::<f64>(), tile.corners());
        assert_eq!(cell.centre::<f32>(), tile.centre());
    }
}

fn places<T: Scalar>() {
    let mut rng = Rng::with_seed(19);
    for n in [1, 2, 3, 48, 90, 720, 5760, 9_999_991, Cell::MAX_N] {
        for _ in 0..2000 {
            let (i, j) = (rng.u32(0..n), rng.u32(0..n));
            let cell = Cell::new(Face::Left, n, i, j).unwrap();
            assert_eq!(Cell::containing(cell.centre::<T>(), n), Ok(cell));
            // A line belongs to the larger cell; its lower neighbour ends just below.
            let low = cell.corner::<T>(Corner::DownLeft);
            assert_eq!(Cell::containing(low, n), Ok(cell), "{}", T::NAME);
            let [x, y] = [(); 2].map(|()| T::of(2.0 * rng.f64() - 1.0));
            let point = FacePoint::new(Face::Top, x, y).unwrap();
            let found = Cell::containing(point, n).unwrap();
            let (low, high) = (found.corner::<T>(Corner::DownLeft), found.corner::<T>(Corner::UpRight));
            assert!(low.x() <= x && low.y() <= y, "{point:?} {found}");
            assert!(x < high.x() || found.i() == n - 1, "{point:?} {found}");
            assert!(y < high.y() || found.j() == n - 1, "{point:?} {found}");
        }
        let last = FacePoint::new(Face::Top, T::ONE, -T::ONE).unwrap();
        assert_eq!(Cell::containing(last, n), Cell::new(Face::Top, n, n - 1, 0));
    }
}

#[test]
fn a_place_is_between_the_corners_of_its_cell() {
    places::<f64>();
    places::<f32>();
}

#[test]
fn what_is_out_of_range_is_refused() {
    assert_eq!(Cell::new(Face::Top, 0, 0, 0), Err(InvalidCell::Count(0)));
    assert_eq!(
        Cell::new(Face::Top, Cell::MAX_N + 1, 0, 0),
        Err(InvalidCell::Count(Cell::MAX_N + 1))
    );
    assert_eq!(
        Cell::new(Face::Top, 48, 48, 0),
        Err(InvalidCell::Column { n: 48, i: 48 })
    );
    let row = Cell::new(Face::Top, 48, 0, u32::MAX);
    assert_eq!(row, Err(InvalidCell::Row { n: 48, j: u32::MAX }));
    assert_eq!(row.unwrap_err().to_string(), "row 4294967295 is not in 0 to 48 - 1");
    let middle = FacePoint::new(Face::Top, 0.0, 0.0).unwrap();
    assert_eq!(Cell::containing(middle, 0), Err(InvalidCell::Count(0)));
}
