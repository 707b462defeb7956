//! [`Ellipsoid`]: the size and shape of a planet; its named ones, and its conversions to Earth-centred axes.

mod ecef;
mod geodetic_series;
mod named;
mod sight;

use core::fmt;

pub use geodetic_series::GeodeticSeries;
pub use named::{NAMED, UnknownEllipsoid};
pub use sight::{Meeting, Ray};

use crate::math::{atan, cbrt, inverse_gudermannian};
use crate::{Direction, Real};

/// An ellipsoid of revolution, given by its semi-major axis a in metres and its flattening f = (a − b)/a.
///
/// The ellipsoid is oblate for f > 0, a sphere for f = 0 and prolate for f < 0.
///
/// The type `Ellipsoid` is `Ellipsoid<f64>`. Named ellipsoids are constants of every scalar. In an
/// expression, Rust does not assume `f64`, so write the type where nothing else tells it:
///
/// ```
/// use terrella::Ellipsoid;
/// let earth: Ellipsoid = Ellipsoid::WGS84;
/// assert_eq!(earth.a(), 6_378_137.0);
/// assert!((earth.b() - 6_356_752.314_245).abs() < 1e-6);
///
/// // Any other: from a and f, from a and b, or from a and 1/f; in a constant too.
/// let bessel: Ellipsoid = Ellipsoid::from_inverse_flattening(6_377_397.155, 299.152_812_8)?;
/// assert_eq!(bessel, Ellipsoid::BESSEL1841);
/// const MINE: Ellipsoid = match Ellipsoid::const_new(6_377_000.0, 1.0 / 299.0) {
///     Ok(ellipsoid) => ellipsoid,
///     Err(_) => panic!("out of range"),
/// };
/// const SINGLE: Ellipsoid<f32> = MINE.to_f32();
/// # assert_eq!(SINGLE.a(), 6_377_000.0);
/// # Ok::<(), terrella::InvalidEllipsoid<f64>>(())
/// ```
#[doc(alias = "spheroid", alias = "datum")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ellipsoid<T = f64> {
    a: T,
    f: T,
}

impl Ellipsoid {
    /// [`Ellipsoid::new`] for constants: the same, in `f64` alone.
    ///
    /// From the polar semi-axis b, pass f = (a − b)/a; from 1/f, pass its inverse. For `f32`, use
    /// [`to_f32`](Self::to_f32) on the result.
    ///
    /// # Errors
    /// [`InvalidEllipsoid`] for what [`Ellipsoid::new`] refuses.
    pub const fn const_new(a: f64, f: f64) -> Result<Self, InvalidEllipsoid<f64>> {
        // Comparisons are written so that NaN is refused.
        if !(a >= SHORTEST && a <= LONGEST) {
            return Err(InvalidEllipsoid::SemiMajorAxis(a));
        }
        if !(f >= MOST_PROLATE && f < 1.0) {
            return Err(InvalidEllipsoid::Flattening(f));
        }
        Ok(Self { a, f })
    }

    /// Returns the ellipsoid with a and f rounded to the nearest `f32`; an f that would round to 1, to the
    /// number below.
    #[must_use]
    pub const fn to_f32(self) -> Ellipsoid<f32> {
        let (f, flattest) = (self.f as f32, 1.0 - f32::EPSILON / 2.0);
        Ellipsoid::within(self.a as f32, if f < flattest { f } else { flattest })
    }

    /// The same ellipsoid in another scalar.
    #[inline(always)]
    pub(crate) fn rounded<T: Real>(self) -> Ellipsoid<T> {
        Ellipsoid::within(T::of(self.a), T::of(self.f))
    }
}

impl From<Ellipsoid<f32>> for Ellipsoid {
    /// The same a and f: every `f32` is an `f64`.
    fn from(ellipsoid: Ellipsoid<f32>) -> Self {
        Self::within(ellipsoid.a.into(), ellipsoid.f.into())
    }
}

/// Bounds of a in metres and of f, within which no derived constant overflows or vanishes.
const SHORTEST: f64 = 1e-15;
const LONGEST: f64 = 1e15;
const MOST_PROLATE: f64 = -1000.0;

impl<T: Real> Ellipsoid<T> {
    /// Creates the ellipsoid of a semi-major axis a in metres and a flattening f.
    ///
    /// a lies in [10⁻¹⁵, 10¹⁵] and f in [−1000, 1).
    ///
    /// # Errors
    /// [`InvalidEllipsoid`] with the value that lies outside, or is NaN.
    pub fn new(a: T, f: T) -> Result<Self, InvalidEllipsoid<T>> {
        if !(T::of(SHORTEST)..=T::of(LONGEST)).contains(&a) {
            return Err(InvalidEllipsoid::SemiMajorAxis(a));
        }
        if !(T::of(MOST_PROLATE)..T::ONE).contains(&f) {
            return Err(InvalidEllipsoid::Flattening(f));
        }
        Ok(Self { a, f })
    }

    /// Creates the ellipsoid of an equatorial semi-axis a and a polar semi-axis b, both in metres.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// let clarke: Ellipsoid = Ellipsoid::from_semi_axes(6_378_206.4, 6_356_583.8)?;
    /// assert!((1.0 / clarke.f() - 294.978_698_2).abs() < 1e-7);
    /// # Ok::<(), terrella::InvalidEllipsoid<f64>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidEllipsoid`] unless a lies in [10⁻¹⁵, 10¹⁵] and f = (a − b)/a in [−1000, 1).
    pub fn from_semi_axes(a: T, b: T) -> Result<Self, InvalidEllipsoid<T>> {
        Self::new(a, (a - b) / a)
    }

    /// Creates the ellipsoid of a semi-major axis a in metres and an inverse flattening 1/f, which is
    /// infinite for a sphere.
    ///
    /// # Errors
    /// [`InvalidEllipsoid`] unless a lies in [10⁻¹⁵, 10¹⁵] and f in [−1000, 1). So an inverse flattening of
    /// 0, which WKT writes for a sphere, is refused: see [`sphere`](Self::sphere).
    pub fn from_inverse_flattening(a: T, inverse: T) -> Result<Self, InvalidEllipsoid<T>> {
        Self::new(a, T::ONE / inverse)
    }

    /// What is known to be within the bounds of [`new`](Self::new).
    #[inline(always)]
    pub(crate) const fn within(a: T, f: T) -> Self {
        Self { a, f }
    }

    /// Creates a sphere of a radius in metres.
    ///
    /// # Errors
    /// [`InvalidEllipsoid::SemiMajorAxis`] unless 10⁻¹⁵ ≤ radius ≤ 10¹⁵.
    pub fn sphere(radius: T) -> Result<Self, InvalidEllipsoid<T>> {
        Self::new(radius, T::ZERO)
    }

    /// Returns the semi-major axis a in metres: the radius of the equator, for f < 0 too.
    #[must_use]
    #[inline(always)]
    pub const fn a(self) -> T {
        self.a
    }

    /// Returns the flattening f = (a − b)/a.
    #[must_use]
    #[inline(always)]
    pub const fn f(self) -> T {
        self.f
    }

    /// Returns the polar semi-axis b = a(1 − f) in metres.
    #[must_use]
    #[inline]
    pub fn b(self) -> T {
        self.a * (T::ONE - self.f)
    }

    /// Returns the third flattening n = (a − b)/(a + b) = f/(2 − f).
    #[must_use]
    #[inline]
    pub fn n(self) -> T {
        self.f / (T::of(2.0) - self.f)
    }

    /// Returns the first eccentricity squared, e² = f(2 − f). It is negative for a prolate ellipsoid.
    #[must_use]
    #[inline]
    pub fn e2(self) -> T {
        self.f * (T::of(2.0) - self.f)
    }

    /// Returns the second eccentricity squared, e′² = e²/(1 − e²). It is negative for a prolate ellipsoid.
    #[must_use]
    #[inline]
    pub fn ep2(self) -> T {
        let axes = T::ONE - self.f;
        self.e2() / (axes * axes)
    }

    /// Returns the mean radius (2a + b)/3 in metres.
    #[must_use]
    pub fn mean_radius(self) -> T {
        self.a * (T::ONE - self.f / T::of(3.0))
    }

    /// Returns the radius in metres of the sphere of equal volume, (a²b)^⅓.
    #[must_use]
    pub fn volumetric_radius(self) -> T {
        self.a * cbrt(T::ONE - self.f)
    }

    /// Returns the radius in metres of the sphere of equal area: the root of a²/2 + b²/2 · atanh(e)/e, with
    /// atan in place of atanh for a prolate ellipsoid.
    #[must_use]
    pub fn authalic_radius(self) -> T {
        self.authalic_radius_squared().sqrt()
    }

    /// The same ellipsoid for another scalar.
    pub(crate) fn map<U: Real>(self, scalar: impl Fn(T) -> U) -> Ellipsoid<U> {
        Ellipsoid {
            a: scalar(self.a),
            f: scalar(self.f),
        }
    }

    /// The point of the ellipsoid, in metres from the centre, where this is the outward normal.
    #[inline(always)]
    pub(crate) fn foot(self, normal: Direction<T>) -> [T; 3] {
        let [x, y, z] = normal.to_array();
        let e2 = self.e2();
        let radius = self.a / (T::ONE - e2 * (z * z)).sqrt();
        [radius * x, radius * y, radius * (T::ONE - e2) * z]
    }

    pub(crate) fn authalic_radius_squared(self) -> T {
        let half = T::of(0.5);
        let e2 = self.e2();
        // 1 − e².
        let squeeze = (T::ONE - self.f) * (T::ONE - self.f);
        // w in atanh(e)/e = 1 + e²w, for either sign of e².
        let w = if e2.abs() <= T::of(0.2) {
            let terms = (1..=T::terms(22, 9)).rev();
            terms.fold(T::ZERO, |sum, k| sum * e2 + T::ONE / T::whole(2 * k as u64 + 1))
        } else {
            let e = e2.abs().sqrt();
            let ratio = if self.f > T::ZERO {
                // atanh e, where √(1 − e²) = 1 − f.
                inverse_gudermannian((e, T::ONE - self.f)) / e
            } else {
                atan(e) / e
            };
            (ratio - T::ONE) / e2
        };
        // a² less a small part, for the last digit's sake.
        let square = self.a * self.a;
        square - square * (half * e2 * (T::ONE - squeeze * w))
    }
}

/// Why [`Ellipsoid::new`] refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidEllipsoid<T> {
    /// The semi-major axis is not in [10⁻¹⁵, 10¹⁵] metres.
    SemiMajorAxis(T),
    /// The flattening is not in [−1000, 1).
    Flattening(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidEllipsoid<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::SemiMajorAxis(a) => write!(f, "semi-major axis {a:?} is not in [1e-15, 1e15] metres"),
            Self::Flattening(flattening) => write!(f, "flattening {flattening:?} is not in [-1000, 1)"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidEllipsoid<T> {}
