//! The bounds of [`Scene::distances`](super::Scene::distances): its table of formulas, and the rounding.

use super::band::{Band, DEGREE, cos, hypot, radii, root, ulp};
use super::{Bound, Model, Scene};
use crate::Ellipsoid;

const PI: f64 = core::f64::consts::PI;

/// What the formulas take of a scene.
pub(super) struct Models {
    ellipsoid: Ellipsoid<f64>,
    pub band: Band,
    near: f64,
    far: f64,
    /// The radius of the sphere, in metres.
    pub sphere: f64,
    /// What its distances are off, relative.
    stretch: f64,
    single: bool,
    local: bool,
    /// Both places moved to the nearest numbers: metres.
    input: f64,
}

const NONE: Bound = Bound::both(f64::INFINITY);

impl Models {
    pub const fn of(scene: &Scene, single: bool) -> Self {
        let (ellipsoid, band, [near, far]) = (scene.ellipsoid, Band::new(scene.latitudes), scene.distances);
        let a = ellipsoid.a();
        let excursion = 0.5 * far / (smallest(ellipsoid) * DEGREE);
        let [m, _] = radii(ellipsoid, band.flattest);
        let [_, n] = radii(ellipsoid, (band.steepest + excursion).min(90.0));
        let input = if !single {
            0.0
        } else if scene.local {
            // The middle latitude is rounded, too, and with it the length of a degree of longitude.
            let middle = 0.5 * ulp(band.steepest) * DEGREE * root(band.tan2());
            hypot(a * band.half, far) * f32::EPSILON as f64 + far * middle
        } else {
            a * DEGREE * hypot(ulp(band.steepest), ulp(180.0) * cos(band.flattest))
        };
        Self {
            ellipsoid,
            band,
            near,
            far,
            sphere: 0.5 * (m + n),
            stretch: 0.5 * (n - m) / m,
            single,
            local: scene.local,
            input,
        }
    }

    pub const fn bound(&self, model: Model) -> Bound {
        if self.local && !matches!(model, Model::Plane) {
            return NONE;
        }
        let truncation = match model {
            Model::Plane => self.plane(),
            Model::Flat => self.flat(),
            Model::Sphere => self.sphere(),
            Model::Andoyer => self.andoyer(),
            Model::Vincenty | Model::Karney => Bound::both(0.0),
        };
        let rounding = self.rounding(model);
        Bound {
            distance: truncation.distance + rounding.distance,
            azimuth: truncation.azimuth + rounding.azimuth,
        }
    }

    const fn flat(&self) -> Bound {
        let (s, r) = (self.far, smallest(self.ellipsoid));
        let (tan2, arc2) = (self.band.tan2(), s * s / (r * r));
        if arc2 > 0.25 || arc2 * tan2 > 0.25 {
            return NONE;
        }
        Bound {
            distance: 1.25 / 24.0 * s * arc2 * (0.26 + 1.13 * tan2),
            azimuth: 1.25 * arc2 * (0.033 + 0.027 * tan2),
        }
    }

    const fn plane(&self) -> Bound {
        let (flat, half) = (self.flat(), self.band.half);
        if half > 0.3 || flat.distance == f64::INFINITY {
            return NONE;
        }
        let tan = root(self.band.tan2());
        let e2 = self.ellipsoid.f() * (2.0 - self.ellipsoid.f());
        let cube = half * half * half;
        let off = 1.1 / 6.0 * cube * (tan + 6.0 * e2 + 0.25 * half);
        Bound {
            distance: flat.distance + self.far * off,
            azimuth: flat.azimuth + off + self.far / smallest(self.ellipsoid) * cube / 12.0,
        }
    }

    const fn sphere(&self) -> Bound {
        let [_, beyond, short] = self.arc();
        let cos = cos(self.band.flattest) + 1e-7;
        Bound {
            distance: self.stretch * self.far,
            azimuth: (1.2 * self.ellipsoid.f() * cos * cos * (1.0 + 1.45 * beyond * beyond / short)).min(PI),
        }
    }

    const fn andoyer(&self) -> Bound {
        let (a, f) = (self.ellipsoid.a(), self.ellipsoid.f());
        let [sigma, beyond, short] = self.arc();
        let turn = sigma / (PI * short);
        Bound {
            distance: (1.2 * a * f * f * (0.125 * sigma + 1.08 * beyond / short)).min(2.0 * a * f),
            azimuth: (1.2 * f * f * (0.33 + 2.9 * turn * turn)).min(PI),
        }
    }

    /// σ, how far it is past a right angle in right angles, and what it lacks to π.
    const fn arc(&self) -> [f64; 3] {
        let sigma = (self.far / smallest_axis(self.ellipsoid)).min(PI);
        [sigma, (2.0 / PI * sigma - 1.0).max(0.0), PI - sigma]
    }

    const fn rounding(&self, model: Model) -> Bound {
        let (s, size, f) = (self.far, self.ellipsoid.a() / 6_378_137.0, self.ellipsoid.f());
        // 4·10⁻⁵ m at f = 1/60, of the fifth order.
        let flat = 60.0 * f;
        let series = size * (4e-5 * (flat * flat * flat * flat * flat)).max(2e-8);
        let distance = match (self.single, model) {
            (false, Model::Plane | Model::Flat | Model::Sphere) => 2e-15 * s,
            (false, Model::Andoyer) => 2e-15 * s + 3e-9 * size,
            (false, Model::Vincenty) => series,
            (false, Model::Karney) if f <= 1.0 / 150.0 => 7e-9 * size,
            (false, Model::Karney) => 1.2e-8 * size,
            (true, Model::Plane | Model::Flat | Model::Sphere | Model::Andoyer) => 7e-7 * s,
            (true, Model::Vincenty) => (1e-6 * s).min(7.0 * size),
            (true, Model::Karney) => (1e-6 * s).min(1.5e-7 * s + 3.0 * size),
        };
        // What is off across the line turns it by so much of its reduced length.
        let across = match (self.single, model) {
            (false, Model::Plane | Model::Flat | Model::Sphere) => 0.0,
            (false, Model::Andoyer | Model::Karney) => 1.5e-8 * size,
            (false, Model::Vincenty) => series,
            (true, _) => self.input,
        };
        let unit = if self.single { 1e-6 } else { 2e-15 };
        Bound {
            distance: distance + self.input,
            azimuth: self
                .turn(self.near, unit, across)
                .max(self.turn(self.far, unit, across)),
        }
    }

    /// An azimuth's error between places a distance apart, of a relative one and one in metres: over the reduced length, which is at least (s/π)(π − 2πf − s/b)(1 − 2f).
    const fn turn(&self, s: f64, relative: f64, across: f64) -> f64 {
        let f = self.ellipsoid.f();
        let share = (1.0 - 2.0 * f) * (1.0 - 2.0 * f - s / (PI * smallest_axis(self.ellipsoid)));
        let off = relative + if across > 0.0 { across / (s - across) } else { 0.0 };
        if share <= 0.0 || s < across {
            f64::INFINITY
        } else {
            off / share
        }
    }
}

/// The smallest radius of curvature, b²/a.
pub(super) const fn smallest(ellipsoid: Ellipsoid<f64>) -> f64 {
    smallest_axis(ellipsoid) * (1.0 - ellipsoid.f())
}

pub(super) const fn smallest_axis(ellipsoid: Ellipsoid<f64>) -> f64 {
    ellipsoid.a() * (1.0 - ellipsoid.f())
}
