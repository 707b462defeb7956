use fastrand::Rng;
use terrella::scene::{Geodetics, Order, Scene, SceneError};
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon, Real};
use testkit::{maximum, minimum};

use crate::draw::{Tally, double, ellipsoid, median, power, say};

/// Points drawn in each scene.
const POINTS: usize = 48;

/// As for positions: every point against the way back in double precision.
fn hold<T: Real>(scenes: usize) {
    let mut rng = Rng::with_seed(9);
    let mut idle: [Vec<f64>; 4] = Default::default();
    let mut tally = Tally::default();
    for _ in 0..scenes {
        let ellipsoid = ellipsoid(&mut rng);
        let b = ellipsoid.b();
        let span = power(&mut rng, -5.0, 0.0) * b;
        // Below the ground mostly, where errors are largest.
        let low = maximum(-0.5 * b, (rng.f64() - 0.6) * b * power(&mut rng, -4.0, 0.0));
        let high = minimum(b, low + span);
        let scene = Scene::new(ellipsoid).heights(low, high);
        let tolerance = power(&mut rng, -9.0, 3.0) * ellipsoid.a() / 6.4e6;
        let taken = scene.within(tolerance).geodetics::<T>();
        let ways = Order::ALL.map(|order| scene.geodetics_by::<T>(order).unwrap());
        let truth = 1e-9 * (ellipsoid.a() + high.abs()) / 6.4e6;
        let mut seen = [0.0_f64; 4];
        for _ in 0..POINTS {
            let lat = [45.0, 90.0 * rng.f64(), 180.0 * rng.f64() - 90.0][rng.usize(..3)];
            let height = [low, low, high, low + (high - low) * rng.f64()][rng.usize(..4)];
            let place = LatLon::new(lat, 360.0 * rng.f64()).unwrap();
            let at = ellipsoid.to_ecef(Geodetic::new(place, height).unwrap()).to_array();
            let [x, y, z] = at.map(T::of);
            for (way, seen) in ways.iter().zip(&mut seen) {
                let found = way.solver().to_geodetic(Ecef::new(x, y, z).unwrap());
                let place = LatLon::new(double(found.lat()), double(found.lon())).unwrap();
                let found = ellipsoid.to_ecef(Geodetic::new(place, double(found.height())).unwrap());
                let found = found.to_array();
                let off = [0, 1, 2].map(|i| (found[i] - at[i]).powi(2));
                *seen = maximum(*seen, off.iter().sum::<f64>().sqrt());
            }
        }
        let mut enough = None;
        for ((way, seen), idle) in ways.iter().zip(seen).zip(&mut idle) {
            if way.bound().is_finite() {
                assert!(seen <= way.bound() + truth, "{way:?}: {seen:e}");
                if seen > 10.0 * truth {
                    idle.push(way.bound() / seen);
                }
                if enough.is_none() && seen + truth < 0.25 * tolerance {
                    enough = Some(way.order());
                }
            }
        }
        tally.count(enough, taken.ok().map(|way: Geodetics<T>| way.order()));
    }
    println!("{} digits", T::DIGITS);
    for (order, ratios) in Order::ALL.into_iter().zip(&mut idle) {
        say(&format!("{order:?}"), ratios);
    }
    assert!(median(&mut idle.concat()) < 4.0);
    tally.hold();
}

#[test]
fn no_bound_is_exceeded_or_idle_and_nothing_dearer_is_taken() {
    hold::<f64>(1000);
    hold::<f32>(1000);
}

#[test]
#[ignore = "a million scenes of each kind"]
fn a_million_scenes() {
    hold::<f64>(1_000_000);
    hold::<f32>(1_000_000);
}

/// About an origin there are no Earth-centred points.
#[test]
fn local_scenes_have_none() {
    let local = Scene::new(Ellipsoid::WGS84).local().within(1e6);
    let infinite = |error| matches!(error, SceneError::OutOfReach(bound) if bound.distance == f64::INFINITY);
    assert!(infinite(local.geodetics::<f64>().unwrap_err()));
    assert!(infinite(local.geodetics::<f32>().unwrap_err()));
}
