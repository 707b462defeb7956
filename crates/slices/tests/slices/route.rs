//! Closest points and tracks, on every surface.

use terrella::batch::{self, InvalidBatch};
use terrella::geodesic::{GreatCircle, Karney};
use terrella::route::{Legs, TangentPlane};
use terrella::{Ellipsoid, LatLon};

use super::{Scalar, bits, places};

fn on<T: Scalar, S: Legs<T>>(surface: &S) {
    let [mut lat, mut lon] = places::<T>();
    let count = 70;
    lat.truncate(count);
    lon.truncate(count);
    let of = |lat: &[T], lon: &[T], i: usize| LatLon::new(lat[i], lon[i]);
    let (start, end) = (of(&lat, &lon, 3).unwrap(), of(&lat, &lon, 8).unwrap());
    (lat[20], lon[31], lon[40]) = (T::of(90.5), T::of(f64::NAN), T::of(725.0));
    let nan = T::of(f64::NAN);
    let refused = |result: Result<(), InvalidBatch<_>>, number, index| {
        assert!(
            matches!(result, Err(InvalidBatch::Elements { count, first, .. }) if (count, first) == (number, index))
        );
    };
    for legs in [false, true] {
        let length = if legs { count - 1 } else { count };
        let mut found = [(); 4].map(|()| vec![T::ONE; length]);
        let mut tracks = [(); 2].map(|()| vec![T::ONE; length]);
        let found_into = found.each_mut().map(|column| &mut column[..]);
        let tracks_into = tracks.each_mut().map(|column| &mut column[..]);
        let (here, number, index) = (
            [&lat[..], &lon[..]],
            [2, 4][usize::from(legs)],
            [20, 19][usize::from(legs)],
        );
        if legs {
            refused(
                batch::route::leg_closest(surface, start, here, found_into),
                number,
                index,
            );
            refused(
                batch::route::leg_tracks(surface, start, here, tracks_into),
                number,
                index,
            );
        } else {
            refused(
                batch::route::closest(surface, here, start, end, found_into),
                number,
                index,
            );
            refused(
                batch::route::tracks(surface, here, start, end, tracks_into),
                number,
                index,
            );
        }
        for i in 0..length {
            let one = if legs {
                of(&lat, &lon, i).and_then(|from| Ok((start, from, of(&lat, &lon, i + 1)?)))
            } else {
                of(&lat, &lon, i).map(|place| (place, start, end))
            };
            let (closest, track) = one.map_or(([nan; 4], [nan; 2]), |(place, from, to)| {
                let closest = surface.closest(place, from, to);
                let track = surface.track(place, from, to);
                let point = closest.position;
                (
                    [closest.distance, point.lat(), point.lon(), closest.along],
                    [track.across, track.along],
                )
            });
            assert_eq!(
                bits(&found.each_ref().map(|column| column[i])),
                bits(&closest),
                "{i} {legs}"
            );
            assert_eq!(
                bits(&tracks.each_ref().map(|column| column[i])),
                bits(&track),
                "{i} {legs}"
            );
        }
    }
    let (mut across, mut along) = ([T::ONE; 2], [T::ONE; 2]);
    let unequal = batch::route::leg_tracks(surface, start, [&lat[..4], &lon[..4]], [&mut across, &mut along]);
    assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 3, other: 2 }));
}

#[test]
fn closest_points_are_those_of_one_by_one() {
    fn both<T: Scalar>() {
        let earth = Ellipsoid::<T>::WGS84;
        on(&Karney::new(earth).unwrap());
        on(&GreatCircle::new(earth.mean_radius()).unwrap());
        on(&TangentPlane::new(earth).unwrap());
    }
    both::<f64>();
    both::<f32>();
}
