//! Andoyer and Lambert's correction, to the first and the second order.

use terrella::Ellipsoid;
use terrella::geodesic::{Andoyer, AndoyerSecond};

use crate::along::{Errors, hold, measure};

/// Distance; errors of distance, azimuth and position.
type Table<'a> = &'a [(f64, [f64; 3])];

fn errors([distance, azimuth, position]: [f64; 3]) -> Errors {
    Errors {
        distance,
        azimuth,
        position,
    }
}

const ANYWHERE: (f64, f64) = (0.0, 90.0);

#[test]
fn the_first_order_holds() {
    let double = Andoyer::new(Ellipsoid::WGS84).unwrap();
    let single = Andoyer::new(Ellipsoid::WGS84).unwrap();
    for s in [10.0, 1e3, 1e5, 1e6, 5e6] {
        let claimed = errors([1.5e-6 * s, 4e-6 * s, 6e-6 * s]);
        hold(&double, &single, s, ANYWHERE, claimed);
    }
    let table: Table<'_> = &[
        (1e7, [15.0, 45.0, 40.0]),
        (1.5e7, [70.0, 200.0, 50.0]),
        (1.8e7, [280.0, 600.0, 40.0]),
        (1.9e7, [600.0, 1300.0, 40.0]),
        (1.99e7, [3.5e4, 2.2e5, 40.0]),
        (2e7, [3.5e4, 2.2e5, 40.0]),
    ];
    for &(s, row) in table {
        hold(&double, &single, s, ANYWHERE, errors(row));
    }
}

#[test]
fn the_second_order_holds() {
    let double = AndoyerSecond::new(Ellipsoid::WGS84).unwrap();
    let single = AndoyerSecond::new(Ellipsoid::WGS84).unwrap();
    for s in [10.0, 1e3, 1e5, 1e6, 3e6] {
        let claimed = errors([2e-9 * s + 5e-9, 1e-9 * s + 5e-9, 4e-9 * s + 6e-9]);
        hold(&double, &single, s, ANYWHERE, claimed);
    }
    let table: Table<'_> = &[
        (5e6, [0.02, 0.012, 0.015]),
        (1e7, [0.2, 0.15, 0.02]),
        (1.5e7, [2.0, 1.6, 0.03]),
        (1.8e7, [20.0, 15.0, 0.03]),
        (1.9e7, [80.0, 70.0, 0.03]),
        (1.99e7, [3.5e4, 2.2e5, 0.03]),
        (2e7, [3.5e4, 2.2e5, 0.03]),
    ];
    for &(s, row) in table {
        hold(&double, &single, s, ANYWHERE, errors(row));
    }
}

/// What the last row of the tables says.
#[test]
fn lines_go_around_any_number_of_times() {
    let earth = Ellipsoid::<f64>::WGS84;
    for s in [3.5e7, -3.5e7, 1e8, 4e8] {
        let [first, second] = [
            measure(&Andoyer::new(earth).unwrap(), s, ANYWHERE).position,
            measure(&AndoyerSecond::new(earth).unwrap(), s, ANYWHERE).position,
        ];
        println!("{s:e} m: {first} {second}");
        assert!(first <= 1.5e-6 * s.abs() && second <= 1.5e-9 * s.abs());
    }
}
