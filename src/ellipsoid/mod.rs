//! [`Ellipsoid`]: the size and shape of a planet.

mod ecef;

use core::fmt;

use crate::math::{atan, cbrt, inverse_gudermannian};
use crate::{Direction, Dual, Real};

/// An ellipsoid of revolution: semi-major (equatorial) axis a in metres and flattening f = (a − b)/a.
///
/// Oblate for f > 0, a sphere for f = 0, prolate for f < 0.
///
/// ```
/// use terrella::Ellipsoid;
/// let earth = Ellipsoid::<f64>::wgs84();
/// assert_eq!(earth.a(), 6_378_137.0);
/// assert!((earth.b() - 6_356_752.314_245).abs() < 1e-6);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ellipsoid<T> {
    a: T,
    f: T,
}

macro_rules! named {
    ($($(#[$doc:meta])* $function:ident, $constant:ident, $name:literal, $a:expr, $f:expr;)*) => {
        /// Names that [`Ellipsoid::named`] knows.
        pub const NAMED: &[&str] = &[$($name),*];

        impl Ellipsoid<f64> {
            $(
                $(#[$doc])*
                pub const $constant: Self = Self { a: $a, f: $f };
            )*
        }

        impl<T: Real> Ellipsoid<T> {
            $(
                $(#[$doc])*
                #[must_use]
                #[inline]
                pub fn $function() -> Self {
                    Self { a: T::of($a), f: T::of($f) }
                }
            )*

            /// The ellipsoid of a name in [`NAMED`].
            ///
            /// ```
            /// # use terrella::Ellipsoid;
            /// assert_eq!(Ellipsoid::named("mars"), Some(Ellipsoid::<f32>::mars()));
            /// ```
            #[must_use]
            pub fn named(name: &str) -> Option<Self> {
                match name {
                    $($name => Some(Self::$function()),)*
                    _ => None,
                }
            }
        }
    };
}

named! {
    /// World Geodetic System 1984: 6 378 137 m, 1/298.257223563.
    wgs84, WGS84, "wgs84", 6_378_137.0, 1.0 / 298.257_223_563;
    /// Geodetic Reference System 1980: 6 378 137 m, 1/298.257222101.
    grs80, GRS80, "grs80", 6_378_137.0, 1.0 / 298.257_222_101;
    /// Clarke 1866: 6 378 206.4 m, b = 6 356 583.8 m.
    clarke1866, CLARKE1866, "clarke1866", 6_378_206.4, 21_622.6 / 6_378_206.4;
    /// International (Hayford) 1924: 6 378 388 m, 1/297.
    international1924, INTERNATIONAL1924, "international1924", 6_378_388.0, 1.0 / 297.0;
    /// Airy 1830: 6 377 563.396 m, 1/299.3249646.
    airy1830, AIRY1830, "airy1830", 6_377_563.396, 1.0 / 299.324_964_6;
    /// Bessel 1841: 6 377 397.155 m, 1/299.1528128.
    bessel1841, BESSEL1841, "bessel1841", 6_377_397.155, 1.0 / 299.152_812_8;
    /// The Moon, a sphere of 1 737 400 m (IAU).
    moon, MOON, "moon", 1_737_400.0, 0.0;
    /// Mars: 3 396 190 m, 1/169.8944472 (IAU).
    mars, MARS, "mars", 3_396_190.0, 1.0 / 169.894_447_2;
}

impl Ellipsoid<f64> {
    /// The same ellipsoid in another scalar.
    #[inline(always)]
    pub(crate) fn rounded<T: Real>(self) -> Ellipsoid<T> {
        Ellipsoid::within(T::of(self.a), T::of(self.f))
    }
}

impl<T: Real> Ellipsoid<T> {
    /// From the semi-major axis in metres, from 10⁻¹⁵ to 10¹⁵, and the flattening, from −1000 to just below 1: within these bounds no
    /// derived constant overflows or vanishes.
    ///
    /// # Errors
    /// [`InvalidEllipsoid`] outside these bounds, and for NaN.
    pub fn new(a: T, f: T) -> Result<Self, InvalidEllipsoid<T>> {
        if !(T::of(1e-15)..=T::of(1e15)).contains(&a) {
            return Err(InvalidEllipsoid::SemiMajorAxis(a));
        }
        if !(T::of(-1000.0)..T::ONE).contains(&f) {
            return Err(InvalidEllipsoid::Flattening(f));
        }
        Ok(Self { a, f })
    }

    /// What is known to be within the bounds of [`new`](Self::new).
    #[inline(always)]
    pub(crate) const fn within(a: T, f: T) -> Self {
        Self { a, f }
    }

    /// A sphere of the given radius in metres.
    ///
    /// # Errors
    /// [`InvalidEllipsoid::SemiMajorAxis`] unless 10⁻¹⁵ ≤ radius ≤ 10¹⁵.
    pub fn sphere(radius: T) -> Result<Self, InvalidEllipsoid<T>> {
        Self::new(radius, T::ZERO)
    }

    /// The semi-major axis a, the radius of the equator, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn a(self) -> T {
        self.a
    }

    /// The flattening f.
    #[must_use]
    #[inline(always)]
    pub const fn f(self) -> T {
        self.f
    }

    /// The polar semi-axis b = a(1 − f) in metres.
    #[must_use]
    #[inline]
    pub fn b(self) -> T {
        self.a * (T::ONE - self.f)
    }

    /// The third flattening n = (a − b)/(a + b) = f/(2 − f).
    #[must_use]
    #[inline]
    pub fn n(self) -> T {
        self.f / (T::of(2.0) - self.f)
    }

    /// The first eccentricity squared, e² = f(2 − f); negative if prolate.
    #[must_use]
    #[inline]
    pub fn e2(self) -> T {
        self.f * (T::of(2.0) - self.f)
    }

    /// The second eccentricity squared, e′² = e²/(1 − e²); negative if prolate.
    #[must_use]
    #[inline]
    pub fn ep2(self) -> T {
        let axes = T::ONE - self.f;
        self.e2() / (axes * axes)
    }

    /// The mean radius (2a + b)/3 in metres.
    #[must_use]
    pub fn mean_radius(self) -> T {
        self.a * (T::ONE - self.f / T::of(3.0))
    }

    /// The radius in metres of the sphere of equal volume, (a²b)^⅓.
    #[must_use]
    pub fn volumetric_radius(self) -> T {
        self.a * cbrt(T::ONE - self.f)
    }

    /// The radius in metres of the sphere of equal area.
    ///
    /// a²/2 + b²/2 · atanh(e)/e, with atan in place of atanh if prolate.
    #[must_use]
    pub fn authalic_radius(self) -> T {
        self.authalic_radius_squared().sqrt()
    }

    /// The same ellipsoid for a scalar with derivatives.
    pub(crate) const fn lifted<const N: usize>(self) -> Ellipsoid<Dual<T, N>> {
        Ellipsoid {
            a: Dual::constant(self.a),
            f: Dual::constant(self.f),
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
