//! Pixels of HEALPix, in every depth, on the sphere and on an ellipsoid.

use terrella::batch;
use terrella::healpix::{OnEllipsoid, Pixel};
use terrella::{Ellipsoid, LatLon};

use super::{Scalar, bits, parts, places};

fn every_pixel<T: Scalar>() {
    let [lat, lon] = places::<T>();
    let unit = Ellipsoid::sphere(T::ONE).unwrap();
    for (part, depth) in parts().zip((0..=Pixel::MAX_DEPTH).cycle()) {
        for ellipsoid in [unit, Ellipsoid::WGS84] {
            let surface = OnEllipsoid::new(ellipsoid).unwrap();
            let mut numbers = vec![7; part.len()];
            let here = [&lat[part.clone()], &lon[part.clone()]];
            batch::healpix::containing(&surface, depth, here, &mut numbers).unwrap();
            for (i, &number) in part.clone().zip(&numbers) {
                let place = LatLon::new(lat[i], lon[i]).unwrap();
                assert_eq!(surface.containing(place, depth), Pixel::new(depth, number));
            }
            let (mut a, mut b) = (vec![T::ZERO; part.len()], vec![T::ZERO; part.len()]);
            batch::healpix::centre(&surface, depth, &numbers, [&mut a, &mut b]).unwrap();
            for (number, (a, b)) in numbers.into_iter().zip(a.into_iter().zip(b)) {
                let centre = surface.centre(Pixel::new(depth, number).unwrap());
                assert_eq!(bits(&[centre.lat(), centre.lon()]), bits(&[a, b]), "{number} {depth}");
            }
        }
    }
}

#[test]
fn pixels_are_those_of_one_by_one() {
    every_pixel::<f64>();
    every_pixel::<f32>();
}
