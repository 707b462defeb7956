use fastrand::Rng;
use terrella::latitude::Shift;
use terrella::scene::Figure;
use terrella::{Ellipsoid, Geodetic, LatLon};
use testkit::maximum;

use crate::draw::{Drawn, Tally, median, power, say};

/// A position on the ground that a figure stands for.
fn on(figure: &Figure, position: Geodetic<f64>) -> [f64; 3] {
    let direction = figure.shifted::<f64>(Shift::Authalic).to_direction(position.lat_lon());
    match figure {
        Figure::Ellipsoid { ellipsoid, .. } => ellipsoid.to_ecef(position).to_array(),
        Figure::Sphere { radius, .. } | Figure::Shifted { radius, .. } => {
            direction.to_array().map(|v| v * (radius + position.height()))
        }
    }
}

fn hold(scenes: usize) {
    let mut rng = Rng::with_seed(4);
    let mut idle = [Vec::new(), Vec::new()];
    let mut tally = Tally::default();
    for _ in 0..scenes {
        let drawn = Drawn::any(&mut rng, 1e3);
        let high = power(&mut rng, 1.0, 4.5);
        let scene = drawn.scene.heights(-0.2 * high, high);
        let tolerance = power(&mut rng, 1.0, 5.0);
        let mut errors = [0.0_f64; 2];
        let figures = scene.figures().unwrap();
        for k in 0..64 {
            let lat = match k {
                0 => drawn.south,
                1 => drawn.north,
                2 => 45_f64.clamp(drawn.south, drawn.north),
                3 => (-45_f64).clamp(drawn.south, drawn.north),
                4 => 0_f64.clamp(drawn.south, drawn.north),
                _ => drawn.south + (drawn.north - drawn.south) * rng.f64(),
            };
            let lon = 360.0 * rng.f64();
            for height in [-0.2 * high, high] {
                let position = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
                let truth = drawn.ellipsoid.to_ecef(position).to_array();
                for (figure, error) in figures.iter().zip(&mut errors) {
                    let place = on(figure, position);
                    let off = (0..3).map(|k| (place[k] - truth[k]).powi(2)).sum::<f64>().sqrt();
                    assert!(off <= figure.bound(), "{figure:?} in {drawn:?}: {off:e}");
                    *error = maximum(*error, off);
                }
            }
        }
        let taken = scene.within(tolerance).figure().unwrap();
        let mut enough = None;
        for ((figure, error), idle) in figures.iter().zip(errors).zip(&mut idle) {
            if figure.bound() > 1e-3 {
                idle.push(figure.bound() / error);
            }
            if enough.is_none() && error < 0.25 * tolerance {
                enough = Some(-figure.bound());
            }
        }
        // The coarser is the cheaper.
        tally.count(enough, Some(-taken.bound()));
    }
    for (name, ratios) in ["sphere", "shifted"].into_iter().zip(&mut idle) {
        say(name, ratios);
        assert!(median(ratios) < 4.0);
    }
    tally.hold();
}

#[test]
fn no_bound_is_exceeded_or_idle_and_nothing_dearer_is_taken() {
    hold(2000);
}

#[test]
#[ignore = "a million scenes"]
fn a_million_scenes() {
    hold(1_000_000);
}

/// Half of the difference of the axes, and the whole of it.
#[test]
fn the_whole_earth() {
    let earth = terrella::scene::Scene::new(Ellipsoid::WGS84);
    let [sphere, shifted] = earth.figures().unwrap().map(|figure| figure.bound());
    assert!((sphere - 23_933.0).abs() < 10.0, "{sphere}");
    assert!((shifted - 10_692.4).abs() < 0.2, "{shifted}");
}
