//! Sides of fences and distances to them, one by one and many at a time.

use terrella::batch::{self, InvalidBatch};
use terrella::geodesic::{GreatCircle, Karney};
use terrella::route::{Fence, Side};
use terrella::{Ellipsoid, InvalidLatLon, LatLon};

use super::{Scalar, bits, parts, places};

fn every_place<T: Scalar>() {
    let [lat, lon] = places::<T>();
    let earth = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
    let sphere = GreatCircle::new(T::of(6_371_000.0)).unwrap();
    let ring = [
        (-20.0, 175.0),
        (-50.0, -100.0),
        (60.0, -80.0),
        (80.0, 100.0),
        (10.0, 30.0),
    ]
    .map(|(lat, lon)| LatLon::new(T::of(lat), T::of(lon)).unwrap());
    let rings = [ring.as_slice()];
    let (fence, round) = (Fence::new(&earth, &rings), Fence::new(&sphere, &rings));
    for part in parts() {
        let here = [&lat[part.clone()], &lon[part.clone()]];
        let (mut sides, mut distances) = (vec![Side::Edge; part.len()], vec![T::ZERO; part.len()]);
        batch::route::sides(&fence, here, &mut sides).unwrap();
        batch::route::distances(&round, here, &mut distances).unwrap();
        for ((i, &side), &distance) in part.clone().zip(&sides).zip(&distances) {
            let place = LatLon::new(lat[i], lon[i]).unwrap();
            assert_eq!(fence.side(place), side);
            assert_eq!(bits(&[round.distance(place)]), bits(&[distance]));
        }
    }
    let (mut sides, mut distances) = ([Side::Edge; 2], [T::ONE; 2]);
    let wrong = [[T::of(91.0), T::ZERO], [T::ZERO; 2]];
    let refused = Err(InvalidBatch::Elements {
        count: 1,
        first: 0,
        why: InvalidLatLon::Latitude(T::of(91.0)),
    });
    assert_eq!(batch::route::sides(&fence, [&wrong[0], &wrong[1]], &mut sides), refused);
    assert_eq!(
        batch::route::distances(&round, [&wrong[0], &wrong[1]], &mut distances),
        refused
    );
    assert_eq!(sides[0], Side::Outside);
    assert!(!distances[0].is_finite() && distances[1].is_finite());
    let lengths = Err(InvalidBatch::Lengths { first: 2, other: 1 });
    assert_eq!(
        batch::route::sides(&fence, [&wrong[0], &wrong[1][..1]], &mut sides),
        lengths
    );
}

#[test]
fn sides_are_those_of_one_by_one() {
    every_place::<f64>();
    every_place::<f32>();
}
