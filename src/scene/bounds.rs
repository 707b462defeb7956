//! The bounds of [`Scene::distances`](super::Scene::distances), from what `methods` says of each method.

use super::Scene;
use super::band::{Band, DEGREE, Parallel, e2, hypot, ulp};
use crate::Ellipsoid;
use crate::geodesic::Method;

const PI: f64 = core::f64::consts::PI;

/// The largest errors that a method makes in a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bound {
    /// The error of a distance or a position, in metres.
    pub distance: f64,
    /// The error of an azimuth between places no nearer than the scene's nearest, in radians. It is infinite
    /// if that distance is 0.
    pub azimuth: f64,
}

/// What the formulas take of a scene.
pub(super) struct Models {
    pub ellipsoid: Ellipsoid<f64>,
    pub band: Band,
    near: f64,
    pub far: f64,
    pub single: bool,
    pub local: bool,
    /// Both places moved to the nearest numbers: metres.
    input: f64,
    /// The tangent of the farthest latitude.
    tan: f64,
    /// The farthest distance over the smallest radius of curvature.
    pub arc: f64,
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

    pub const fn bound(&self, method: Method) -> Bound {
        Bound {
            distance: self.distance(method),
            azimuth: self.azimuth(method),
        }
    }

    #[inline(always)]
    pub const fn distance(&self, method: Method) -> f64 {
        let truncation = if self.holds(method) {
            self.distance_truncated(method)
        } else {
            f64::INFINITY
        };
        truncation + self.rounding(method) + self.input
    }

    pub const fn azimuth(&self, method: Method) -> f64 {
        let truncation = if self.holds(method) {
            self.azimuth_truncated(method)
        } else {
            f64::INFINITY
        };
        // What is off across the line turns it by so much of its reduced length.
        let across = if self.single { self.input } else { self.across(method) };
        let relative = if self.single { 1e-6 } else { 2e-15 };
        truncation
            + self
                .turn(self.near, relative, across)
                .max(self.turn(self.far, relative, across))
    }

    /// The ellipsoid's size, in Earths.
    pub const fn size(&self) -> f64 {
        self.ellipsoid.a() / 6_378_137.0
    }

    /// Whether a plane holds.
    pub const fn flat_holds(&self) -> bool {
        self.arc <= 0.5 && self.arc * self.tan <= 0.5
    }

    /// How far a plane's azimuths are off, in radians.
    pub const fn flat_turned(&self) -> f64 {
        1.25 * self.arc * self.arc * (0.033 + 0.027 * self.tan * self.tan)
    }

    /// How far a plane's distances are off, in metres.
    pub const fn flat(&self) -> f64 {
        1.25 / 24.0 * self.far * self.arc * self.arc * (0.26 + 1.13 * self.tan * self.tan)
    }

    /// How far Gauss's distances, and the places that Bowring's direct problem finds, are off, in metres.
    pub const fn gauss(&self) -> f64 {
        let (f, u, t2) = (self.ellipsoid.f(), self.arc, self.tan * self.tan);
        let steep = (0.0009 + 0.0037 * t2).max(0.000_53 * t2 * t2);
        1.25 * self.far * u * u * (2.0 * f * f + 0.14 * f * u + u * u * steep)
    }

    /// How far Gauss's azimuths are off, in radians.
    pub const fn gauss_turned(&self) -> f64 {
        let (f, u, t2) = (self.ellipsoid.f(), self.arc, self.tan * self.tan);
        1.25 * u * u * (0.24 * f * f + 0.045 * f * u + u * u * (0.0007 + 0.000_55 * t2 * t2))
    }

    /// How far a scale that is a polynomial of latitude is off, relative.
    pub const fn bent(&self) -> f64 {
        let half = self.band.half;
        1.1 / 6.0 * half * half * half * (self.tan + 6.0 * e2(self.ellipsoid) + 0.25 * half)
    }

    /// σ, how far it is past a right angle in right angles, and what it lacks to π.
    pub const fn angle(&self) -> [f64; 3] {
        let sigma = (self.far / polar_radius(self.ellipsoid)).min(PI);
        [sigma, (2.0 / PI * sigma - 1.0).max(0.0), PI - sigma]
    }

    /// An azimuth's error between places a distance apart, of a relative one and one in metres: over the
    /// reduced length, which is at least (s/π)(π − 2πf − s/b)(1 − 2f).
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

/// How far the length of a degree of longitude is off, relative, where an origin's latitude is rounded to
/// single precision.
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
