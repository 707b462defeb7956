//! Andoyer and Lambert's correction, to the first and the second order.

use terrella::Ellipsoid;
use terrella::geodesic::{Andoyer, AndoyerSecond};

use crate::along::measure;

const ANYWHERE: (f64, f64) = (0.0, 90.0);

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
