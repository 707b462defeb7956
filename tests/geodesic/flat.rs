//! The flat model.

use terrella::Ellipsoid;
use terrella::geodesic::Flat;

use crate::along::{Errors, hold};

#[test]
fn the_table_holds() {
    let double = Flat::new(Ellipsoid::WGS84).unwrap();
    let single = Flat::new(Ellipsoid::WGS84).unwrap();
    let bands = [(0.0, 30.0), (30.0, 60.0), (60.0, 80.0), (80.0, 89.0)];
    let table = [
        (1e3, [1.4e-6, 6e-6, 6e-5, 6e-3]),
        (1e4, [1.4e-3, 6e-3, 6e-2, 6.0]),
        (1e5, [1.4, 6.0, 60.0, 1.2e4]),
    ];
    for (distance, row) in table {
        for (band, metres) in bands.into_iter().zip(row) {
            let claimed = Errors {
                distance: metres,
                azimuth: metres,
                position: metres,
            };
            hold(&double, &single, distance, band, claimed);
        }
    }
}
