//! Rhumb lines on the Earth and on a flatter ellipsoid.

use terrella::batch::{self, InvalidBatch};
use terrella::route::Rhumb;
use terrella::{Ellipsoid, LatLon};

use super::{Scalar, bits, numbers, parts, places};

fn every_line<T: Scalar>() {
    let [lat1, lon1] = places::<T>();
    let special = &[0.0, 1.0, -1.0, 0.5, 1e-7];
    let lat2: Vec<T> = numbers::<T>(51, special).iter().map(|&v| v * T::of(90.0)).collect();
    let lon2: Vec<T> = numbers::<T>(52, special).iter().map(|&v| v * T::of(300.0)).collect();
    let azimuth: Vec<T> = numbers::<T>(53, special).iter().map(|&v| v * T::of(540.0)).collect();
    let distance: Vec<T> = numbers::<T>(54, special).iter().map(|&v| v * T::of(2e7)).collect();
    let flat = Ellipsoid::new(T::of(6.4e6), T::of(0.1)).unwrap();
    for rhumb in [Ellipsoid::WGS84, flat].map(|ellipsoid| Rhumb::new(ellipsoid).unwrap()) {
        for part in parts() {
            let of = |column: &Vec<T>| column[part.clone()].to_vec();
            let [lat1, lon1, lat2, lon2, azimuth, distance] = [&lat1, &lon1, &lat2, &lon2, &azimuth, &distance].map(of);
            let zeros = || vec![T::ZERO; lat1.len()];
            let [mut s, mut azi, mut area, mut lat, mut lon] = [zeros(), zeros(), zeros(), zeros(), zeros()];
            let (from, to) = ([&lat1[..], &lon1[..]], [&lat2[..], &lon2[..]]);
            batch::route::rhumb_inverse(&rhumb, from, to, [&mut s, &mut azi]).unwrap();
            batch::route::rhumb_area(&rhumb, from, to, &mut area).unwrap();
            let outcome = batch::route::rhumb_direct(&rhumb, from, &azimuth, &distance, [&mut lat, &mut lon]);
            let mut refused = 0;
            for i in 0..lat1.len() {
                let (a, b) = (
                    LatLon::new(lat1[i], lon1[i]).unwrap(),
                    LatLon::new(lat2[i], lon2[i]).unwrap(),
                );
                let line = rhumb.inverse(a, b);
                assert_eq!(
                    bits(&[line.distance, line.azimuth, line.area]),
                    bits(&[s[i], azi[i], area[i]]),
                    "{a} {b}"
                );
                let end = rhumb.direct(a, azimuth[i], distance[i]).map(|end| end.position);
                refused += usize::from(end.is_err());
                let nan = T::of(f64::NAN);
                let expected = end.map_or([nan; 2], |end| [end.lat(), end.lon()]);
                assert_eq!(
                    bits(&expected),
                    bits(&[lat[i], lon[i]]),
                    "{a} {} {}",
                    azimuth[i],
                    distance[i]
                );
            }
            match outcome {
                Ok(()) => assert_eq!(refused, 0),
                Err(InvalidBatch::Elements { count, .. }) => assert_eq!(count, refused),
                Err(other) => panic!("{other}"),
            }
        }
    }
}

#[test]
fn rhumb_lines_are_those_of_one_by_one() {
    every_line::<f64>();
    every_line::<f32>();
}
