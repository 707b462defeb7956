use fastrand::Rng;
use terrella::geodesic::Karney;
use terrella::scene::{Positions, View};
use terrella::{Geodetic, LatLon, LocalFrame, Real};
use testkit::{maximum, minimum};

use crate::draw::{Drawn, Tally, double, median, power, say};

/// Positions drawn in each scene.
const POSITIONS: usize = 32;

/// As for distances: every position seen from an origin in the scene, against the frame in double precision.
fn hold<T: Real>(local: bool, scenes: usize) {
    let mut rng = Rng::with_seed(3);
    let mut idle: [Vec<f64>; 3] = Default::default();
    let mut tally = Tally::default();
    for _ in 0..scenes {
        let mut drawn = Drawn::any(&mut rng, 10.0);
        let karney = Karney::new(drawn.ellipsoid).unwrap();
        let span = power(&mut rng, -3.0, 0.0) * minimum(drawn.far, 1e4);
        let low = (1e4 - span) * rng.f64();
        drawn.scene = drawn.scene.heights(low, low + span);
        if local {
            drawn.scene = drawn.scene.local();
        }
        let mut seen = [0.0_f64; 3];
        let tolerance = power(&mut rng, -7.0, 3.0);
        let taken = drawn.scene.within(tolerance).positions::<T>();
        let ways = View::ALL.map(|view| drawn.scene.positions_by::<T>(view).unwrap());
        let pairs: Vec<_> = (0..POSITIONS)
            .filter_map(|_| drawn.pair(&karney, false, &mut rng))
            .collect();
        for ([from, to], _) in pairs {
            let mut height = || low + span * [0.0, 1.0, rng.f64()][rng.usize(..3)];
            let (origin, position) = (
                Geodetic::new(from, height()).unwrap(),
                Geodetic::new(to, height()).unwrap(),
            );
            let truth = LocalFrame::new(drawn.ellipsoid, origin).geodetic_to_enu(position);
            let given = if local {
                let lon = (to.lon() - from.lon() + 540.0).rem_euclid(360.0) - 180.0;
                [to.lat() - from.lat(), lon, position.height() - origin.height()]
            } else {
                [to.lat(), to.lon(), position.height()]
            };
            let narrow = |[lat, lon, height]: [f64; 3]| {
                Geodetic::new(LatLon::new(T::of(lat), T::of(lon)).unwrap(), T::of(height)).unwrap()
            };
            for (way, seen) in ways.iter().zip(&mut seen) {
                if way.bound().is_finite() {
                    let enu = way
                        .about(narrow([from.lat(), from.lon(), origin.height()]))
                        .enu(narrow(given));
                    let off = [enu.east, enu.north, enu.up].map(double);
                    let off = [off[0] - truth.east, off[1] - truth.north, off[2] - truth.up];
                    *seen = maximum(*seen, off.iter().map(|x| x * x).sum::<f64>().sqrt());
                }
            }
        }
        let mut enough = None;
        for ((way, seen), idle) in ways.iter().zip(seen).zip(&mut idle) {
            if way.bound().is_finite() {
                assert!(
                    seen <= way.bound() + 1e-15 * drawn.far,
                    "{way:?} in {drawn:?}: {seen:e}"
                );
                if seen > 1e-14 * drawn.far {
                    idle.push(way.bound() / seen);
                }
                if enough.is_none() && seen < 0.25 * tolerance {
                    enough = Some(way.view());
                }
            }
        }
        tally.count(enough, taken.ok().map(|positions: Positions<T>| positions.view()));
    }
    println!("{} digits{}", T::DIGITS, if local { ", local" } else { "" });
    for (view, ratios) in View::ALL.into_iter().zip(&mut idle) {
        say(&format!("{view:?}"), ratios);
    }
    assert!(median(&mut idle.concat()) < 4.0);
    tally.hold();
}

#[test]
fn no_bound_is_exceeded_or_idle_and_nothing_dearer_is_taken() {
    hold::<f64>(false, 1000);
    hold::<f32>(false, 1000);
    hold::<f32>(true, 1000);
}

#[test]
#[ignore = "a million scenes of each kind"]
fn a_million_scenes() {
    hold::<f64>(false, 1_000_000);
    hold::<f32>(false, 1_000_000);
    hold::<f32>(true, 1_000_000);
}
