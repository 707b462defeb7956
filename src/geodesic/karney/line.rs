use core::f64::consts::PI;

use super::Karney;
use super::angle::Angle;
use super::inverse::{rounded, tiny};
use super::series::{Row, Series};
use crate::geodesic::GeodesicError;
use crate::geodesic::degrees::{hypot, wrapped};
use crate::math::select;
use crate::{LatLon, Real};

/// A geodesic from one place in one direction, on which many points are wanted.
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
    karney: Karney<T>,
    lon1: T,
    alpha0: Angle<T>,
    pub(super) alpha1: Angle<T>,
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

/// A point of a [`Line`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LinePoint<T> {
    /// Where it is.
    pub position: LatLon<T>,
    /// The azimuth of travel there, in degrees clockwise from north, in [−180, 180].
    pub azimuth: T,
    /// The arc on the auxiliary sphere from the line's start, in degrees.
    pub arc: T,
    /// The reduced length in metres: how far a turn of one radian at the start moves the point.
    pub reduced_length: T,
    /// The geodesic scale M₁₂: how far apart there are lines that start parallel, one metre apart.
    pub scale12: T,
    /// The geodesic scale M₂₁, the same from the point back to the start.
    pub scale21: T,
}

/// A point as the area needs it.
#[derive(Clone, Copy)]
pub(super) struct Place<T> {
    pub point: LinePoint<T>,
    pub alpha2: Angle<T>,
    pub sigma12: Angle<T>,
    pub sigma2: Angle<T>,
}

impl<T: Real> Line<T> {
    pub(super) fn new(karney: &Karney<T>, from: LatLon<T>, azimuth: T) -> Result<Self, GeodesicError<T>> {
        if !azimuth.is_finite() {
            return Err(GeodesicError::Azimuth(azimuth));
        }
        let alpha1 = Angle::degrees(rounded(azimuth.remainder(T::of(360.0))));
        let (beta1, _) = karney.reduced(rounded(from.lat()));
        let alpha0 = Angle {
            sin: alpha1.sin * beta1.cos,
            cos: hypot(alpha1.cos, alpha1.sin * beta1.sin),
        };
        let equatorial = beta1.sin == T::ZERO && alpha1.cos == T::ZERO;
        let cos = select(equatorial, T::ONE, beta1.cos * alpha1.cos);
        let sigma1 = Angle::of(beta1.sin, cos);
        let omega1 = Angle {
            sin: alpha0.sin * beta1.sin,
            cos,
        };
        let series = &karney.series;
        let k2 = alpha0.cos * alpha0.cos * karney.ellipsoid.ep2();
        let epsilon = Series::epsilon(k2);
        let factor = -karney.ellipsoid.f() * alpha0.sin;
        let (c1, c2) = (series.c1(epsilon), series.c2(epsilon));
        let c3 = series.c3(epsilon).map(|c| factor * c);
        let b11 = series.sines(&c1, sigma1);
        Ok(Self {
            karney: *karney,
            lon1: from.lon(),
            alpha0,
            alpha1,
            sigma1,
            omega1,
            dn1: karney.dn(beta1.sin),
            k2,
            a1: series.a1_less_1(epsilon),
            a2: series.a2_less_1(epsilon),
            c1,
            c1_reverted: series.c1_reverted(epsilon),
            c2,
            a3: factor * series.a3(epsilon),
            c3,
            b11,
            b21: series.sines(&c2, sigma1),
            b31: series.sines(&c3, sigma1),
            tau1: sigma1.plus(Angle::radians(b11)),
        })
    }

    /// The point at a distance in metres from the start; a negative distance lies behind it.
    ///
    /// # Errors
    /// [`GeodesicError::Distance`] if it is not finite; [`GeodesicError::TooFar`] if it is longer than 10⁵
    /// (`f64`) or 100 (`f32`) polar radii times the mean of √(1 + k² sin²σ) on the line, A₁.
    pub fn at(&self, distance: T) -> Result<LinePoint<T>, GeodesicError<T>> {
        self.place(distance).map(|place| place.point)
    }

    pub(super) fn alpha0(&self) -> Angle<T> {
        self.alpha0
    }

    pub(super) fn sigma1(&self) -> Angle<T> {
        self.sigma1
    }

    pub(super) fn place(&self, distance: T) -> Result<Place<T>, GeodesicError<T>> {
        let Self {
            karney, sigma1, alpha0, ..
        } = self;
        let series = &karney.series;
        let b = karney.ellipsoid.b();
        // One quotient: over many circuits each rounding counts.
        let radius = b + b * self.a1;
        let tau12 = distance / radius;
        let longest = T::pick(1e5, 100.0);
        // Also false for NaN.
        let within = tau12.abs() < longest;
        if !within {
            return Err(GeodesicError::refused(distance, longest * radius));
        }
        let tau2 = self.tau1.plus(Angle::radians(tau12));
        let b12 = -series.sines(&self.c1_reverted, tau2);
        let mut arc = tau12 - (b12 - self.b11);
        let mut sigma12 = Angle::radians(arc);
        let mut sigma2 = sigma1.plus(sigma12);
        if karney.ellipsoid.f().abs() > T::of(0.01) {
            // The reversion converges more slowly than the series: one step of Newton's method.
            let error = (arc - tau12) + (series.sines(&self.c1, sigma2) - self.b11);
            arc -= error * (T::ONE + self.a1) / (T::ONE + self.k2 * sigma2.sin * sigma2.sin).sqrt();
            sigma12 = Angle::radians(arc);
            sigma2 = sigma1.plus(sigma12);
        }
        let dn2 = (T::ONE + self.k2 * sigma2.sin * sigma2.sin).sqrt();
        let mut cos_beta2 = hypot(alpha0.sin, alpha0.cos * sigma2.cos);
        if cos_beta2 == T::ZERO {
            // At a pole, leaving it along a definite meridian.
            cos_beta2 = tiny();
            sigma2.cos = cos_beta2;
        }
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
        let lambda12 = omega12 + (self.a3 * arc + (series.sines(&self.c3, sigma2) - self.b31));
        let degree = T::of(180.0 / PI);
        // Of very many circuits the flattening alone makes a circle and more.
        let lon2 = wrapped(self.lon1 + wrapped((lambda12 * degree).remainder(T::of(360.0))));
        let lat2 = crate::math::atan2_degrees(sin_beta2, karney.axes * cos_beta2);
        let b1 = (T::ONE + self.a1) * (series.sines(&self.c1, sigma2) - self.b11);
        let b2 = (T::ONE + self.a2) * (series.sines(&self.c2, sigma2) - self.b21);
        let j12 = (self.a1 - self.a2) * arc + (b1 - b2);
        let t = self.k2 * (sigma2.sin - sigma1.sin) * (sigma2.sin + sigma1.sin) / (self.dn1 + dn2);
        Ok(Place {
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
        })
    }
}
