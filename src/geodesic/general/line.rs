use core::f64::consts::PI;

use super::Solver;
use super::canonical::{rounded, tiny};
use crate::geodesic::angle::{Angle, wrapped};
use crate::geodesic::series::{Integrals, Row, sines};
use crate::geodesic::sphere::node;
use crate::geodesic::{Direct, GeodesicError};
use crate::math::{atan2_degrees, hypot, max, min, select};
use crate::{LatLon, Real};

mod passage;

pub use passage::Passage;

/// A geodesic from one place at one azimuth: for many points at different distances on the same line.
///
/// [`Karney::line`](crate::geodesic::Karney::line) makes one. What depends on the start alone is computed
/// once: each further point costs less than a direct problem, and comes with reduced length and scales.
/// [`batch::geodesic::along`](crate::batch::geodesic::along) takes many distances.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = Karney::new(Ellipsoid::WGS84).unwrap();
/// let line = earth.line(LatLon::new(40.6_f64, -73.8).unwrap(), 53.5).unwrap();
/// let point = line.at(1_000_000.0).unwrap();
/// assert!((point.position.lat() - 45.515_600).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Line<T> {
    solver: Solver<T>,
    lon1: T,
    alpha0: Angle<T>,
    pub(in crate::geodesic) alpha1: Angle<T>,
    sigma1: Angle<T>,
    omega1: Angle<T>,
    dn1: T,
    k2: T,
    /// A₁ − 1 and A₂ − 1.
    a1: T,
    a2: T,
    c1: Row<T>,
    c1_reverted: Row<T>,
    c2: Row<T>,
    /// −f sin α₀ times A₃ and A₃C₃.
    a3: T,
    c3: Row<T>,
    b11: T,
    b21: T,
    b31: T,
    tau1: Angle<T>,
}

/// A point of a [`Line`], from [`Line::at`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePoint<T> {
    /// The latitude and longitude of the point.
    pub position: LatLon<T>,
    /// The azimuth of travel there, in degrees clockwise from north, in [−180, 180].
    pub azimuth: T,
    /// The arc σ₁₂ on the auxiliary sphere from the start of the line to the point, in degrees; negative
    /// behind the start.
    pub arc: T,
    /// The reduced length m₁₂ in metres: a turn of one radian at the start moves the point by this much
    /// sideways.
    pub reduced_length: T,
    /// The geodesic scale M₁₂, without a unit: two lines that start parallel and one metre apart are M₁₂
    /// metres apart at the point.
    pub scale12: T,
    /// The geodesic scale M₂₁: the same for two lines that are parallel at the point, at the start.
    pub scale21: T,
}

/// A point as the area needs it.
#[derive(Clone, Copy)]
pub struct Place<T> {
    pub point: LinePoint<T>,
    pub alpha2: Angle<T>,
    pub sigma12: Angle<T>,
    pub sigma2: Angle<T>,
}

impl<T: Real> Line<T> {
    /// The line from a place at an azimuth in degrees.
    pub(in crate::geodesic) fn new(solver: &Solver<T>, from: LatLon<T>, azimuth: T) -> Result<Self, GeodesicError<T>> {
        if !azimuth.is_finite() {
            return Err(GeodesicError::Azimuth(azimuth));
        }
        Ok(Self::along(solver, from, azimuth))
    }

    /// The line from a place at a finite azimuth in degrees.
    pub(in crate::geodesic) fn along(solver: &Solver<T>, from: LatLon<T>, azimuth: T) -> Self {
        let alpha1 = Angle::degrees(rounded(azimuth.remainder(T::of(360.0))));
        let (beta1, _) = solver.parametric(rounded(from.lat()));
        let alpha0 = node(alpha1, beta1);
        // Along the equator any point is the node.
        let equatorial = beta1.sin == T::ZERO && alpha1.cos == T::ZERO;
        let cos = select(equatorial, T::ONE, beta1.cos * alpha1.cos);
        let sigma1 = Angle::of(beta1.sin, cos);
        let omega1 = Angle {
            sin: alpha0.sin * beta1.sin,
            cos,
        };
        let integrals = &solver.integrals;
        let k2 = alpha0.cos * alpha0.cos * solver.ellipsoid.ep2();
        let epsilon = Integrals::epsilon(k2);
        let factor = -solver.ellipsoid.f() * alpha0.sin;
        let (c1, c2) = (integrals.c1(epsilon), integrals.c2(epsilon));
        let c3 = integrals.c3(epsilon).map(|c| factor * c);
        let b11 = integrals.sines(&c1, sigma1);
        Self {
            solver: *solver,
            lon1: from.lon(),
            alpha0,
            alpha1,
            sigma1,
            omega1,
            dn1: solver.dn(beta1.sin),
            k2,
            a1: integrals.a1_less_1(epsilon),
            a2: integrals.a2_less_1(epsilon),
            c1,
            c1_reverted: integrals.c1_reverted(epsilon),
            c2,
            a3: factor * integrals.a3(epsilon),
            c3,
            b11,
            b21: integrals.sines(&c2, sigma1),
            b31: integrals.sines(&c3, sigma1),
            tau1: sigma1.plus(Angle::radians(b11)),
        }
    }

    /// Returns the point at a distance in metres from the start; a negative distance lies behind it.
    ///
    /// # Errors
    /// [`GeodesicError::Distance`] if the distance is not finite. [`GeodesicError::TooFar`] if it is longer
    /// than 10⁵ (`f32`: 100) polar radii times A₁, the mean of √(1 + k² sin²σ) on the line: 6·10⁸ km (6·10⁵
    /// km) on the Earth.
    pub fn at(&self, distance: T) -> Result<LinePoint<T>, GeodesicError<T>> {
        self.place(distance).map(|place| place.point)
    }

    /// [`Self::at`] of a distance known to be short enough; of any other, the point at the longest one.
    pub(crate) fn near(&self, distance: T) -> LinePoint<T> {
        self.near_place(distance).point
    }

    fn near_place(&self, distance: T) -> Place<T> {
        let (tau12, _) = self.mean_arc(distance);
        let tau12 = min(max(tau12, -longest::<T>()), longest());
        let integrals = &self.solver.integrals;
        self.reach(tau12, true, |row, sigma| integrals.sines(row, sigma))
    }

    pub(in crate::geodesic) fn alpha0(&self) -> Angle<T> {
        self.alpha0
    }

    pub(in crate::geodesic) fn sigma1(&self) -> Angle<T> {
        self.sigma1
    }

    pub(in crate::geodesic) fn place(&self, distance: T) -> Result<Place<T>, GeodesicError<T>> {
        let (tau12, radius) = self.mean_arc(distance);
        let longest = longest::<T>();
        // Also false for NaN.
        let within = tau12.abs() < longest;
        if !within {
            return Err(GeodesicError::refused(distance, longest * radius));
        }
        let integrals = &self.solver.integrals;
        Ok(self.reach(tau12, true, |row, sigma| integrals.sines(row, sigma)))
    }

    /// The point of [`Self::at`] without a branch, and whether it is that, bit for bit: not on ellipsoids far
    /// flatter than the Earth, nor after some fifty circuits of it.
    #[inline(always)]
    pub(crate) fn fast_at(&self, distance: T) -> (Direct<T>, bool) {
        let (tau12, _) = self.mean_arc(distance);
        let terms = T::terms(6, 3);
        let point = self.reach(tau12, false, |row, sigma| sines(row, terms, sigma)).point;
        // So the longitudes differ by less than a circle.
        let few = (tau12.abs() < longest()) & ((self.a3 * tau12).abs() <= T::ONE);
        let end = Direct {
            position: point.position,
            azimuth: point.azimuth,
        };
        (
            end,
            few & !self.reverts_slowly() & (self.solver.integrals.order() <= terms),
        )
    }

    /// τ₁₂ and its unit in metres.
    #[inline(always)]
    fn mean_arc(&self, distance: T) -> (T, T) {
        let b = self.solver.ellipsoid.b();
        // One quotient: over many circuits each rounding counts.
        let radius = b + b * self.a1;
        (distance / radius, radius)
    }

    /// Whether the reversion converges more slowly than the series.
    #[inline(always)]
    fn reverts_slowly(&self) -> bool {
        self.solver.ellipsoid.f().abs() > T::of(0.01)
    }

    /// The point at τ₁₂; `any` if the reversion may converge slowly, and the longitudes may differ by more
    /// than a circle.
    #[inline(always)]
    fn reach(&self, tau12: T, any: bool, sines: impl Fn(&Row<T>, Angle<T>) -> T) -> Place<T> {
        let Self {
            solver, sigma1, alpha0, ..
        } = self;
        let b = solver.ellipsoid.b();
        let tau2 = self.tau1.plus(Angle::radians(tau12));
        let b12 = -sines(&self.c1_reverted, tau2);
        let mut arc = tau12 - (b12 - self.b11);
        let mut sigma12 = Angle::radians(arc);
        let mut sigma2 = sigma1.plus(sigma12);
        if any && self.reverts_slowly() {
            // One step of Newton's method.
            let error = (arc - tau12) + (sines(&self.c1, sigma2) - self.b11);
            arc -= error * (T::ONE + self.a1) / (T::ONE + self.k2 * sigma2.sin * sigma2.sin).sqrt();
            sigma12 = Angle::radians(arc);
            sigma2 = sigma1.plus(sigma12);
        }
        let dn2 = (T::ONE + self.k2 * sigma2.sin * sigma2.sin).sqrt();
        let mut cos_beta2 = hypot(alpha0.sin, alpha0.cos * sigma2.cos);
        // At a pole, leaving it along a definite meridian.
        let polar = cos_beta2 == T::ZERO;
        cos_beta2 = select(polar, tiny(), cos_beta2);
        sigma2.cos = select(polar, cos_beta2, sigma2.cos);
        let sin_beta2 = alpha0.cos * sigma2.sin;
        let alpha2 = Angle {
            sin: alpha0.sin,
            cos: alpha0.cos * sigma2.cos,
        };
        let omega2 = Angle {
            sin: alpha0.sin * sigma2.sin,
            cos: sigma2.cos,
        };
        let omega12 = omega2.minus(self.omega1).to_radians();
        let lambda12 = omega12 + (self.a3 * arc + (sines(&self.c3, sigma2) - self.b31));
        let degree = T::of(180.0 / PI);
        let lon12 = lambda12 * degree;
        // Of very many circuits the flattening alone makes a circle and more.
        let lon12 = if any { lon12.remainder(T::of(360.0)) } else { lon12 };
        let lon2 = wrapped(self.lon1 + wrapped(lon12));
        let lat2 = atan2_degrees(sin_beta2, solver.axes * cos_beta2);
        let b1 = (T::ONE + self.a1) * (sines(&self.c1, sigma2) - self.b11);
        let b2 = (T::ONE + self.a2) * (sines(&self.c2, sigma2) - self.b21);
        let j12 = (self.a1 - self.a2) * arc + (b1 - b2);
        let t = self.k2 * (sigma2.sin - sigma1.sin) * (sigma2.sin + sigma1.sin) / (self.dn1 + dn2);
        Place {
            point: LinePoint {
                position: LatLon::within(lat2, lon2),
                azimuth: alpha2.to_degrees(),
                arc: arc * degree,
                reduced_length: b
                    * (dn2 * (sigma1.cos * sigma2.sin)
                        - self.dn1 * (sigma1.sin * sigma2.cos)
                        - sigma1.cos * sigma2.cos * j12),
                scale12: sigma12.cos + (t * sigma2.sin - sigma2.cos * j12) * sigma1.sin / self.dn1,
                scale21: sigma12.cos - (t * sigma1.sin - sigma1.cos * j12) * sigma2.sin / dn2,
            },
            alpha2,
            sigma12,
            sigma2,
        }
    }
}

/// The longest arc in radians.
#[inline(always)]
fn longest<T: Real>() -> T {
    T::pick(1e5, 100.0)
}
