//! Intersections of segments, of places anywhere and of ends that are refused.

use terrella::batch::{self, InvalidBatch};
use terrella::geodesic::Karney;
use terrella::route::{Intersections, Segment};
use terrella::{Ellipsoid, InvalidLatLon, LatLon};

use super::{Scalar, bits, places};

fn every_pair<T: Scalar>() {
    let karney = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
    let intersections = Intersections::new(Ellipsoid::<T>::WGS84).unwrap();
    let [lat, lon] = places::<T>();
    for length in [0, 1, 3, 4, 65, 150] {
        let of = |start: usize| start..start + length;
        let [mut x, mut y, mut a, mut b] = [(); 4].map(|()| vec![T::ONE; length]);
        let one = [&lat[of(0)], &lon[of(0)], &lat[of(50)], &lon[of(50)]];
        let other = [&lat[of(100)], &lon[of(100)], &lat[of(150)], &lon[of(150)]];
        let met = [&mut x, &mut y, &mut a, &mut b].map(Vec::as_mut_slice);
        batch::route::of_segments(&intersections, one, other, met).unwrap();
        for i in 0..length {
            let [one, other] = [one, other].map(|[lat1, lon1, lat2, lon2]| {
                let ends = [(lat1, lon1), (lat2, lon2)].map(|(lat, lon)| LatLon::new(lat[i], lon[i]).unwrap());
                Segment::new(&karney, ends[0], ends[1])
            });
            let met = intersections.of_segments(&one, &other);
            let nan = T::of(f64::NAN);
            let expected = met.map_or([nan; 4], |met| {
                [
                    met.displacement1,
                    met.displacement2,
                    met.position.lat(),
                    met.position.lon(),
                ]
            });
            assert_eq!(bits(&expected), bits(&[x[i], y[i], a[i], b[i]]), "{one:?} {other:?}");
        }
    }
}

#[test]
fn intersections_are_those_of_one_by_one() {
    every_pair::<f64>();
    every_pair::<f32>();
}

#[test]
fn a_wrong_end_costs_its_own_row() {
    let intersections = Intersections::new(Ellipsoid::<f64>::WGS84).unwrap();
    let one: [&[f64]; 4] = [&[50.0, 50.0], &[-10.0, -10.0], &[60.0, 60.0], &[10.0, 10.0]];
    let other: [&[f64]; 4] = [&[91.0, 60.0], &[-10.0, -10.0], &[50.0, 50.0], &[10.0, 10.0]];
    let [mut x, mut y, mut lat, mut lon] = [[0.0; 2]; 4];
    let met = [&mut x, &mut y, &mut lat, &mut lon].map(<[f64; 2]>::as_mut_slice);
    let result = batch::route::of_segments(&intersections, one, other, met);
    let why = InvalidLatLon::Latitude(91.0);
    assert_eq!(
        result,
        Err(InvalidBatch::Elements {
            count: 1,
            first: 0,
            why
        })
    );
    assert!(lat[0].is_nan() && lat[1] > 55.0);
    let result = batch::route::of_segments(&intersections, one, [&[]; 4], [&mut [], &mut [], &mut [], &mut []]);
    assert_eq!(result, Err(InvalidBatch::Lengths { first: 2, other: 0 }));
}
