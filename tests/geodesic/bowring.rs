//! Bowring's formulas for short lines.

use terrella::Ellipsoid;
use terrella::geodesic::Bowring;

use crate::along::{Errors, hold};

#[test]
fn the_table_holds() {
    let double = Bowring::new(Ellipsoid::WGS84).unwrap();
    let single = Bowring::new(Ellipsoid::WGS84).unwrap();
    let table = [
        (1e3, 6e-9, 6.4e-9),
        (1e4, 1e-6, 4e-7),
        (1e5, 1.1e-3, 6e-4),
        (1.5e5, 4e-3, 3e-3),
        (1e6, 5.0, 6.0),
    ];
    for (distance, metres, azimuth) in table {
        let claimed = Errors {
            distance: metres,
            azimuth,
            position: metres,
        };
        hold(&double, &single, distance, (0.0, 90.0), claimed);
    }
}
