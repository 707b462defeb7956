//! The bounds of [`Scene::distances`](super::Scene::distances): its table of formulas, and the rounding.

use super::band::{Band, DEGREE, Parallel, e2, hypot, ulp};
use super::{Bound, Model, Scene};
use crate::Ellipsoid;

const PI: f64 = core::f64::consts::PI;

/// What the formulas take of a scene.
pub(super) struct Models {
    ellipsoid: Ellipsoid<f64>,
    band: Band,
    near: f64,
    far: f64,
    single: bool,
    local: bool,
    /// Both places moved to the nearest numbers: metres.
    input: f64,
    /// The tangent of the farthest latitude.
    tan: f64,
    /// The farthest distance over the smallest radius of curvature.
    arc: f64,
}

impl Models {
    pub const fn of(scene: &Scene, single: bool) -> Self {
        let (ellipsoid, band, [near, far]) = (scene.ellipsoid, Band::new(scene.latitudes), scene.distances);
        let input = match (single, scene.local) {
            (false, _) => 0.0,
            (true, true) => {
                hypot(largest(ellipsoid) * band.half, far) * f32::EPSILON as f64 + middle_rounded(band) * far
            }
            (true, false) => places_rounded(ellipsoid, band, 0.0),
        };
        Self {
            ellipsoid,
            band,
            near,
            far,
            single,
            local: scene.local,
            input,
            tan: band.tan(),
            arc: far / smallest(ellipsoid),
        }
    }

    /// The sphere's radius in metres, and how far its distances are off, relative.
    pub const fn sphere(&self) -> [f64; 2] {
        let excursion = 0.5 * self.arc / DEGREE;
        let m = self.band.flattest.along(self.ellipsoid);
        let n = Parallel::new((self.band.steepest.degrees + excursion).min(90.0)).across(self.ellipsoid);
        // What the sines are off.
        let slack = 2e-7 * e2(self.ellipsoid);
        [0.5 * (m + n), 0.5 * (n - m) / m + slack]
    }

    pub const fn bound(&self, model: Model) -> Bound {
        Bound {
            distance: self.distance(model),
            azimuth: self.azimuth(model),
        }
    }

    pub const fn distance(&self, model: Model) -> f64 {
        let (s, f, size) = (self.far, self.ellipsoid.f(), self.ellipsoid.a() / 6_378_137.0);
        let truncation = match model {
            _ if !self.holds(model) => f64::INFINITY,
            Model::Plane => self.flat() + s * self.bent(),
            Model::Flat => self.flat(),
            Model::Sphere => {
                let [_, off] = self.sphere();
                off * s
            }
            Model::Andoyer => {
                let [sigma, beyond, short] = self.angle();
                let a = self.ellipsoid.a();
                (1.2 * a * f * f * (0.125 * sigma + 1.08 * beyond / short)).min(2.0 * a * f)
            }
            Model::Karney => 0.0,
        };
        let rounding = match (self.single, model) {
            (false, Model::Plane | Model::Flat | Model::Sphere) => 2e-15 * s,
            (false, Model::Andoyer) => 2e-15 * s + 3e-9 * size,
            (false, Model::Karney) if f <= 1.0 / 150.0 => 7e-9 * size,
            (false, Model::Karney) => 1.2e-8 * size,
            (true, Model::Plane | Model::Flat | Model::Sphere | Model::Andoyer) => 7e-7 * s,
            // Half way round the equator, where the straight lines do not hold.
            (true, Model::Karney) if f > 1.0 / 150.0 && self.arc > 0.97 * PI => 33.0 * size,
            (true, Model::Karney) => (1e-6 * s).min(1.5e-7 * s + 4.0 * size),
        };
        truncation + rounding + self.input
    }

    pub const fn azimuth(&self, model: Model) -> f64 {
        let (f, size) = (self.ellipsoid.f(), self.ellipsoid.a() / 6_378_137.0);
        let turned = 1.25 * self.arc * self.arc * (0.033 + 0.027 * self.tan * self.tan);
        let truncation = match model {
            _ if !self.holds(model) => f64::INFINITY,
            Model::Plane => {
                let half = self.band.half;
                turned + self.bent() + self.arc * half * half * half / 12.0
            }
            Model::Flat => turned,
            Model::Sphere => {
                let [_, beyond, short] = self.angle();
                let cos = self.band.flattest.cos + 1e-7;
                (1.2 * f * cos * cos * (1.0 + 1.45 * beyond * beyond / short)).min(PI)
            }
            Model::Andoyer => {
                let [sigma, _, short] = self.angle();
                let turn = sigma / (PI * short);
                (1.2 * f * f * (0.33 + 2.9 * turn * turn)).min(PI)
            }
            Model::Karney => 0.0,
        };
        // What is off across the line turns it by so much of its reduced length.
        let across = match (self.single, model) {
            (false, Model::Plane | Model::Flat | Model::Sphere) => 0.0,
            (false, Model::Andoyer | Model::Karney) => 1.5e-8 * size,
            (true, _) => self.input,
        };
        let relative = if self.single { 1e-6 } else { 2e-15 };
        truncation
            + self
                .turn(self.near, relative, across)
                .max(self.turn(self.far, relative, across))
    }

    /// Whether the model is one at all.
    const fn holds(&self, model: Model) -> bool {
        let lean = self.arc * self.tan;
        match model {
            Model::Plane => self.arc <= 0.5 && lean <= 0.5 && self.band.half <= 0.3,
            _ if self.local => false,
            Model::Flat => self.arc <= 0.5 && lean <= 0.5,
            _ => true,
        }
    }

    const fn flat(&self) -> f64 {
        1.25 / 24.0 * self.far * self.arc * self.arc * (0.26 + 1.13 * self.tan * self.tan)
    }

    /// How far a scale that is a polynomial of latitude is off, relative.
    const fn bent(&self) -> f64 {
        let half = self.band.half;
        1.1 / 6.0 * half * half * half * (self.tan + 6.0 * e2(self.ellipsoid) + 0.25 * half)
    }

    /// σ, how far it is past a right angle in right angles, and what it lacks to π.
    const fn angle(&self) -> [f64; 3] {
        let sigma = (self.far / polar_radius(self.ellipsoid)).min(PI);
        [sigma, (2.0 / PI * sigma - 1.0).max(0.0), PI - sigma]
    }

    /// An azimuth's error between places a distance apart, of a relative one and one in metres: over the reduced length, which is at least (s/π)(π − 2πf − s/b)(1 − 2f).
    const fn turn(&self, s: f64, relative: f64, across: f64) -> f64 {
        let f = self.ellipsoid.f();
        let share = (1.0 - 2.0 * f) * (1.0 - 2.0 * f - s / (PI * polar_radius(self.ellipsoid)));
        let off = relative + if across > 0.0 { across / (s - across) } else { 0.0 };
        if share <= 0.0 || s < across {
            f64::INFINITY
        } else {
            off / share
        }
    }
}

/// Two places at a height moved to the nearest latitudes and longitudes in single precision: metres.
pub(super) const fn places_rounded(ellipsoid: Ellipsoid<f64>, band: Band, height: f64) -> f64 {
    let angles = hypot(ulp(band.steepest.degrees), ulp(180.0) * (band.flattest.cos + 1e-7));
    (largest(ellipsoid) + height) * DEGREE * angles
}

/// How far the length of a degree of longitude is off, relative, where an origin's latitude is rounded to single precision.
pub(super) const fn middle_rounded(band: Band) -> f64 {
    0.5 * ulp(band.steepest.degrees) * DEGREE * band.tan()
}

// `Ellipsoid` has these for every scalar, and so not in constants.

/// The smallest radius of curvature, b²/a.
pub(super) const fn smallest(ellipsoid: Ellipsoid<f64>) -> f64 {
    polar_radius(ellipsoid) * (1.0 - ellipsoid.f())
}

/// The largest radius of curvature, a²/b.
const fn largest(ellipsoid: Ellipsoid<f64>) -> f64 {
    ellipsoid.a() / (1.0 - ellipsoid.f())
}

/// The semi-minor axis b.
pub(super) const fn polar_radius(ellipsoid: Ellipsoid<f64>) -> f64 {
    ellipsoid.a() * (1.0 - ellipsoid.f())
}
