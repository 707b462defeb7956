//! Scenes, and places in them.

use fastrand::Rng;
use terrella::geodesic::{Geodesic, Inverse, Karney};
use terrella::scene::Scene;
use terrella::{Ellipsoid, LatLon, Real};
use testkit::minimum;

/// A scene before its tolerance, and what it was made of.
#[derive(Debug)]
pub struct Drawn {
    pub scene: Scene,
    pub ellipsoid: Ellipsoid<f64>,
    pub south: f64,
    pub north: f64,
    pub near: f64,
    pub far: f64,
}

/// Between powers of ten.
pub fn power(rng: &mut Rng, low: f64, high: f64) -> f64 {
    10_f64.powf(low + (high - low) * rng.f64())
}

pub fn ellipsoid(rng: &mut Rng) -> Ellipsoid<f64> {
    match rng.u8(..6) {
        0 | 1 => Ellipsoid::WGS84,
        2 => Ellipsoid::MARS,
        3 => Ellipsoid::MOON,
        4 => Ellipsoid::new(power(rng, 5.0, 8.0), 0.01).unwrap(),
        _ => Ellipsoid::new(6.4e6, 0.01 * rng.f64()).unwrap(),
    }
}

impl Drawn {
    /// Of any size to half the circumference, its latitudes at least as wide as its places are apart.
    pub fn any(rng: &mut Rng, smallest: f64) -> Self {
        let ellipsoid = ellipsoid(rng);
        let half_circle = core::f64::consts::PI * ellipsoid.b();
        let far = power(rng, smallest.log10(), half_circle.log10());
        let width = 1.02 * far / half_circle
            * 180.0
            * (1.0 + 2.0 * ellipsoid.f())
            * if rng.bool() { 1.0 } else { power(rng, 0.0, 1.5) };
        let (south, north) = if width >= 180.0 {
            (-90.0, 90.0)
        } else {
            let south = -90.0 + (180.0 - width) * rng.f64();
            (south, south + width)
        };
        let near = far * power(rng, -3.0, -0.01);
        Self {
            scene: Scene::new(ellipsoid).latitudes(south, north).between(near, far),
            near,
            ellipsoid,
            south,
            north,
            far,
        }
    }

    /// Two places of the scene, mostly where errors are largest: at an end of the latitudes and as far apart as may be.
    pub fn pair(&self, karney: &Karney<f64>, local: bool, rng: &mut Rng) -> Option<([LatLon<f64>; 2], Inverse<f64>)> {
        let lat = match rng.u8(..4) {
            0 => self.south,
            1 => self.north,
            _ => self.south + (self.north - self.south) * rng.f64(),
        };
        let azimuth = match rng.u8(..4) {
            0 => 90.0,
            1 => 0.0,
            _ => 180.0 * rng.f64(),
        };
        let distance = match rng.u8(..8) {
            0 => self.near + (self.far - self.near) * rng.f64(),
            1 => 1.000_001 * self.near,
            _ => 0.999_999 * self.far,
        };
        let lon = if local { 0.0 } else { 360.0 * rng.f64() };
        let from = LatLon::new(lat, lon).unwrap();
        [azimuth, 180.0 - azimuth].into_iter().find_map(|azimuth| {
            let to = karney.direct(from, azimuth, distance).unwrap().position;
            let inside = self.south <= to.lat() && to.lat() <= self.north;
            inside.then(|| ([from, to], karney.inverse(from, to).unwrap()))
        })
    }
}

/// A number as it is.
pub fn double<T: Real>(value: T) -> f64 {
    value.to_string().parse().unwrap()
}

/// The difference of two angles, in radians.
pub fn turned(a: f64, b: f64) -> f64 {
    let off = (a - b).rem_euclid(360.0);
    minimum(off, 360.0 - off).to_radians()
}

pub fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// How often something dearer was taken than was enough.
#[derive(Default)]
pub struct Tally {
    decided: u32,
    dearer: u32,
}

impl Tally {
    /// Of a scene: what would have been enough, and what was taken.
    pub fn count<M: PartialOrd>(&mut self, enough: Option<M>, taken: Option<M>) {
        if let Some(enough) = enough {
            self.decided += 1;
            self.dearer += u32::from(taken.is_none_or(|taken| taken > enough));
        }
    }

    /// In less than 5 of 100.
    pub fn hold(&self) {
        println!("dearer than needed: {} of {}", self.dearer, self.decided);
        assert!(20 * self.dearer < self.decided);
    }
}

/// Says how many times the largest error the bounds are.
pub fn say(what: &str, ratios: &mut [f64]) {
    if let Some(scenes) = ratios.len().checked_sub(1) {
        let middle = median(ratios);
        println!(
            "{what}: {middle:.2} times the largest error, at least {:.3}, in {} scenes",
            ratios[0],
            scenes + 1
        );
    }
}
