//! Polylines and rings: the answer of all legs, whatever is skipped.

use fastrand::Rng;
use terrella::geodesic::{GreatCircle, Karney};
use terrella::route::{Closest, Legs, OnPath, TangentPlane, Track};
use terrella::{Ellipsoid, LatLon};
use testkit::truth::Scalar;

use crate::closest::place;

/// A surface that skips no leg.
struct Whole<'a, S>(&'a S);

impl<T: Scalar, S: Legs<T>> Legs<T> for Whole<'_, S> {
    type Leg = S::Leg;

    fn leg(&self, start: LatLon<T>, end: LatLon<T>) -> S::Leg {
        self.0.leg(start, end)
    }

    fn length(&self, leg: &S::Leg) -> T {
        self.0.length(leg)
    }

    fn closest_on(&self, leg: &S::Leg, place: LatLon<T>) -> Closest<T> {
        self.0.closest_on(leg, place)
    }

    fn track_beside(&self, leg: &S::Leg, place: LatLon<T>) -> Track<T> {
        self.0.track_beside(leg, place)
    }
}

fn path<T: Scalar>(rng: &mut Rng) -> Vec<LatLon<T>> {
    let step = 10.0_f64.powf(-5.0 + 7.5 * rng.f64());
    let (mut lat, mut lon) = (180.0 * rng.f64() - 90.0, 360.0 * rng.f64());
    let mut next = || {
        lat = (lat + step * (rng.f64() - 0.5)).clamp(-90.0, 90.0);
        lon += step * (rng.f64() - 0.4);
        place(T::of(lat), T::of(lon))
    };
    (0..12).map(|_| next()).collect()
}

fn skipping<T: Scalar, S: Legs<T>>(surface: &S, rounds: usize) {
    let mut rng = Rng::with_seed(20);
    for _ in 0..rounds {
        let path = path::<T>(&mut rng);
        let count = rng.usize(0..path.len());
        let near = path[count];
        let away = 10.0_f64.powf(-6.0 + 8.0 * rng.f64());
        let lat = Into::<f64>::into(near.lat()) + away * (rng.f64() - 0.5);
        let lon = Into::<f64>::into(near.lon()) + away * (rng.f64() - 0.5);
        let ship = place(T::of(lat.clamp(-90.0, 90.0)), T::of(lon));
        let path = &path[..count];
        let open = |surface: &dyn Fn() -> Option<OnPath<T>>| surface();
        assert_eq!(
            open(&|| surface.closest_of_path(ship, path.iter().copied())),
            Whole(surface).closest_of_path(ship, path.iter().copied()),
        );
        let ring = surface.closest_of_ring(ship, path.iter().copied());
        assert_eq!(ring, Whole(surface).closest_of_ring(ship, path.iter().copied()));
        // By hand.
        let legs = (0..count).map(|leg| surface.closest(ship, path[leg], path[(leg + 1) % count]));
        let first = legs
            .enumerate()
            .reduce(|best, next| if next.1.distance < best.1.distance { next } else { best });
        assert_eq!(ring.map(|on| (on.leg, on.closest)), first);
    }
}

#[test]
fn of_all_legs_it_is_the_closest() {
    fn compare<T: Scalar>() {
        let earth = Ellipsoid::<T>::WGS84;
        skipping(&GreatCircle::new(earth.mean_radius()).unwrap(), 1000);
        skipping(&Karney::new(earth).unwrap(), 300);
        skipping(&TangentPlane::new(earth).unwrap(), 300);
        skipping(
            &Karney::new(Ellipsoid::new(T::of(6.4e6), T::of(-0.1)).unwrap()).unwrap(),
            100,
        );
        skipping(
            &Karney::new(Ellipsoid::new(T::of(6.4e6), T::of(0.1)).unwrap()).unwrap(),
            100,
        );
    }
    compare::<f64>();
    compare::<f32>();
}

/// Most legs are skipped, or a ring of a thousand places would be too slow.
#[test]
fn far_legs_cost_little() {
    struct Counting(Karney<f64>, core::cell::Cell<usize>);
    impl Legs<f64> for Counting {
        type Leg = <Karney<f64> as Legs<f64>>::Leg;
        fn leg(&self, start: LatLon, end: LatLon) -> Self::Leg {
            self.1.set(self.1.get() + 1);
            self.0.leg(start, end)
        }
        fn length(&self, leg: &Self::Leg) -> f64 {
            self.0.length(leg)
        }
        fn closest_on(&self, leg: &Self::Leg, place: LatLon) -> Closest<f64> {
            self.0.closest_on(leg, place)
        }
        fn track_beside(&self, leg: &Self::Leg, place: LatLon) -> Track<f64> {
            self.0.track_beside(leg, place)
        }
        fn at_least(&self, place: LatLon, start: LatLon, end: LatLon) -> f64 {
            self.0.at_least(place, start, end)
        }
    }
    let earth = Counting(Karney::new(Ellipsoid::WGS84).unwrap(), 0.into());
    let ring = (0..1000).map(|k| {
        let (sin, cos) = (f64::from(k) * 0.36).to_radians().sin_cos();
        place(50.0 + sin, 10.0 + cos)
    });
    let found = earth.closest_of_ring(place(50.5, 10.8), ring).unwrap();
    println!("{found:?} {}", earth.1.get());
    assert!(earth.1.get() < 250, "{}", earth.1.get());
}

#[test]
fn paths_of_few_places() {
    let earth = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let (here, there) = (place(10.0, 20.0), place(11.0, 20.0));
    assert_eq!(earth.closest_of_path(here, []), None);
    assert_eq!(earth.closest_of_ring(here, []), None);
    for one in [
        earth.closest_of_path(here, [there]),
        earth.closest_of_ring(here, [there]),
    ] {
        let one = one.unwrap();
        assert_eq!((one.leg, one.closest.position, one.closest.along), (0, there, 0.0));
        assert!((one.closest.distance - 110_611.0).abs() < 100.0);
    }
    // Coincident neighbours change nothing (turf, issue 2906), nor does a ring whose first place is repeated.
    let ship = place(10.2, 20.1);
    let ring = [here, here, there, there, place(10.5, 21.0), here];
    let plain = [here, there, place(10.5, 21.0)];
    let [one, two] = [
        earth.closest_of_ring(ship, ring).unwrap(),
        earth.closest_of_ring(ship, plain).unwrap(),
    ];
    assert_eq!(one.closest.distance, two.closest.distance);
}
