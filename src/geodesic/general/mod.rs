//! The general solver: Karney's algorithms, for any two places on any ellipsoid with −1/9 ≤ f ≤ 1/10. The
//! inverse problem looks for the azimuth α₁ inside a bracket, so that it always ends; it knows the reduced
//! length and the scales, too.
//!
//! C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013); the handling of special places as in
//! GeographicLib, unless said.

use super::Inverse;
use super::angle::{Angle, northward_between_poles};
use super::series::Integrals;
use super::sphere::parametric;
use crate::math::{max, select};
use crate::{Ellipsoid, LatLon, Real};

mod astroid;
mod canonical;
mod lengths;
mod line;
mod newton;
mod start;

pub use canonical::{Canonical, Course, Segment};
pub use line::{Line, LinePoint, Passage, Place};

use canonical::tiny;

/// An ellipsoid as the general solver needs it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Solver<T> {
    pub ellipsoid: Ellipsoid<T>,
    pub integrals: Integrals<T>,
    /// b/a = 1 − f.
    axes: T,
    /// The arc in radians below which the sphere of the middle latitude is exact enough.
    short: T,
}

impl<T: Real> Solver<T> {
    /// For an ellipsoid known to be one that the series hold for.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Self {
        let f = ellipsoid.f();
        let half = T::of(0.5);
        let size = max(T::of(0.001), f.abs());
        let narrow = if f > T::ZERO { T::ONE - half * f } else { T::ONE };
        Self {
            ellipsoid,
            integrals: Integrals::new(ellipsoid),
            axes: T::ONE - f,
            short: T::of(0.1) * T::EPSILON.sqrt() / (half * size * narrow).sqrt(),
        }
    }

    /// The inverse problem, its canonical form and all of its solution.
    #[cold]
    #[inline(never)]
    pub fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, Canonical<T>, Segment<T>) {
        let problem = Canonical::new(self, from, to);
        let segment = problem.solve(self);
        let ([alpha1, alpha2], _) = problem.turned_back(&segment);
        let degrees = |alpha: Angle<T>| select(segment.sigma12 == T::ZERO, T::ZERO, alpha.to_degrees());
        let line = Inverse {
            distance: segment.distance + T::ZERO,
            azimuth1: degrees(alpha1),
            azimuth2: degrees(alpha2),
        };
        (northward_between_poles(from, to, line), problem, segment)
    }

    /// β of a latitude φ in degrees, its cosine never 0, and √(cos²φ + (1 − f)² sin²φ).
    #[cfg_attr(not(small), inline(always))]
    fn parametric(&self, lat: T) -> (Angle<T>, T) {
        let (beta, divisor) = parametric(lat, self.axes);
        let beta = Angle {
            cos: max(beta.cos, tiny()),
            ..beta
        };
        (beta, divisor)
    }

    /// √(1 + e′² sin²β).
    #[inline(always)]
    fn dn(&self, sin_beta: T) -> T {
        (T::ONE + self.ellipsoid.ep2() * sin_beta * sin_beta).sqrt()
    }
}
