use core::fmt;

use super::correction::{Correction, Turn, supported};
use super::{Latitude, Shift, UnsupportedFlattening};
use crate::math::{gudermannian, inverse_gudermannian, sin_cos, sin_cos_degrees};
use crate::{Ellipsoid, Real};

/// Converts an angle from one kind of latitude to another, on one ellipsoid.
///
/// Angles are in degrees ([`degrees`](Self::degrees)) or in radians ([`radians`](Self::radians)). The
/// isometric latitude has no unit, and is the same number for both functions.
///
/// | worst error for −1/150 ≤ f ≤ 1/10, in radians | `f64` | `f32` |
/// |---|---|---|
/// | from the geodetic latitude | 1.6e-16 | 8.2e-8 |
/// | to the geodetic latitude | 3.3e-16 | 8.5e-8 |
/// | between two others | 5e-16 | 1.7e-7 |
/// | from the isometric latitude, whose e^ψ is rounded | 7e-16 | 3.5e-7 |
///
/// Near the equator, the relative precision is full.
///
/// ```
/// use terrella::{Ellipsoid, Latitude, latitude::Conversion};
/// let authalic = Conversion::new(Ellipsoid::WGS84, Latitude::Geodetic, Latitude::Authalic).unwrap();
/// assert!((authalic.degrees(45.0).unwrap() - 44.871_702_87_f64).abs() < 1e-8);
/// ```
#[doc(alias("AuxLatitude", "geodetic2authalic", "geodetic2conformal", "geodetic2isometric"))]
#[doc(alias("geodetic2geocentric", "geodetic2parametric", "geodetic2rectifying"))]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Conversion<T> {
    from: Latitude,
    to: Latitude,
    to_geodetic: Correction<T>,
    from_geodetic: Correction<T>,
}

/// The shift that computes a latitude. The isometric latitude is a function of the conformal one.
fn angle_of(latitude: Latitude) -> Shift {
    match latitude {
        Latitude::Geodetic => Shift::Geodetic,
        Latitude::Geocentric => Shift::Geocentric,
        Latitude::Parametric => Shift::Parametric,
        Latitude::Authalic => Shift::Authalic,
        Latitude::Conformal | Latitude::Isometric => Shift::Conformal,
        Latitude::Rectifying => Shift::Rectifying,
    }
}

impl<T: Real> Conversion<T> {
    /// Creates the conversion from one latitude to another on an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the flattening is out of the range of one of the two latitudes. From a
    /// latitude to itself, and between the conformal and the isometric one, every ellipsoid is accepted.
    pub fn new(ellipsoid: Ellipsoid<T>, from: Latitude, to: Latitude) -> Result<Self, UnsupportedFlattening<T>> {
        let (start, end) = (angle_of(from), angle_of(to));
        let same = start == end;
        Ok(Self {
            from,
            to,
            to_geodetic: if same {
                Correction::None
            } else {
                Correction::to_geodetic(supported(ellipsoid, start)?, start)
            },
            from_geodetic: if same {
                Correction::None
            } else {
                Correction::to_shifted(supported(ellipsoid, end)?, end)
            },
        })
    }

    /// Converts a latitude in degrees, and returns degrees.
    ///
    /// To the isometric latitude, it returns the number ψ, infinite at the poles; from it, it takes any ψ.
    ///
    /// # Errors
    /// [`InvalidLatitude`] if the angle is outside [−90, 90] or NaN.
    #[inline]
    pub fn degrees(&self, value: T) -> Result<T, InvalidLatitude<T>> {
        self.convert::<Degrees>(value)
    }

    /// Converts a latitude in radians, and returns radians.
    ///
    /// To the isometric latitude, it returns the number ψ, infinite at the poles; from it, it takes any ψ.
    ///
    /// # Errors
    /// [`InvalidLatitude`] if the angle is outside [−π/2, π/2] or NaN; π/2 stands for the number of the
    /// scalar nearest to it.
    #[inline]
    pub fn radians(&self, value: T) -> Result<T, InvalidLatitude<T>> {
        self.convert::<Radians>(value)
    }

    #[inline(always)]
    fn convert<A: Angle>(&self, value: T) -> Result<T, InvalidLatitude<T>> {
        let valid = value.abs() <= self.limit::<A>();
        if !valid {
            return Err(InvalidLatitude(value));
        }
        if self.from == self.to {
            return Ok(value);
        }
        let start = if self.from == Latitude::Isometric {
            conformal::<T, A>(value)
        } else {
            value
        };
        // Without a correction, no sine is computed.
        let corrected = |value: T, correction: &Correction<T>| match correction {
            Correction::None => value,
            _ => corrected::<T, A>(value, correction),
        };
        let geodetic = corrected(start, &self.to_geodetic);
        Ok(if self.to == Latitude::Isometric {
            isometric::<T, A>(geodetic, &self.from_geodetic)
        } else {
            corrected(geodetic, &self.from_geodetic)
        })
    }

    /// The largest absolute value that is accepted.
    #[inline(always)]
    pub(crate) fn limit<A: Angle>(&self) -> T {
        if self.from == Latitude::Isometric {
            T::of(f64::INFINITY)
        } else {
            A::quarter()
        }
    }

    /// The latitudes of argument and result.
    pub(crate) fn ends(&self) -> [Latitude; 2] {
        [self.from, self.to]
    }

    /// The corrections to the geodetic latitude, and from it.
    pub(crate) fn corrections(&self) -> [Correction<T>; 2] {
        [self.to_geodetic, self.from_geodetic]
    }
}

/// A unit of angles.
pub(crate) trait Angle: Copy {
    /// A right angle.
    fn quarter<T: Real>() -> T;
    /// A radian.
    fn radian<T: Real>() -> T;
    /// Sine and cosine.
    fn sin_cos<T: Real>(angle: T) -> (T, T);
}

/// Angles in degrees.
#[derive(Clone, Copy)]
pub(crate) struct Degrees;

impl Angle for Degrees {
    #[inline(always)]
    fn quarter<T: Real>() -> T {
        T::of(90.0)
    }

    #[inline(always)]
    fn radian<T: Real>() -> T {
        T::pick(180.0 / core::f64::consts::PI, 57.295_78)
    }

    #[inline(always)]
    fn sin_cos<T: Real>(angle: T) -> (T, T) {
        sin_cos_degrees(angle)
    }
}

/// Angles in radians.
#[derive(Clone, Copy)]
pub(crate) struct Radians;

impl Angle for Radians {
    #[inline(always)]
    fn quarter<T: Real>() -> T {
        T::pick(core::f64::consts::FRAC_PI_2, core::f32::consts::FRAC_PI_2)
    }

    #[inline(always)]
    fn radian<T: Real>() -> T {
        T::ONE
    }

    #[inline(always)]
    fn sin_cos<T: Real>(angle: T) -> (T, T) {
        sin_cos(angle)
    }
}

/// The latitude after a correction.
#[inline(always)]
pub(crate) fn corrected<T: Real, A: Angle>(value: T, correction: &impl Turn<T>) -> T {
    (value + correction.angle(A::sin_cos(value + value)) * A::radian()).copysign(value)
}

/// The isometric latitude of a geodetic one; `correction` leads from there to the conformal latitude.
#[inline(always)]
pub(crate) fn isometric<T: Real, A: Angle>(geodetic: T, correction: &impl Turn<T>) -> T {
    inverse_gudermannian(correction.turn(A::sin_cos(geodetic))).copysign(geodetic)
}

/// The conformal latitude of an isometric one.
#[inline(always)]
pub(crate) fn conformal<T: Real, A: Angle>(isometric: T) -> T {
    gudermannian(isometric) * A::radian()
}

/// The error for a number that is not a latitude: outside the range between the poles, or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidLatitude<T>(pub T);

impl<T: fmt::Debug> fmt::Display for InvalidLatitude<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "latitude {:?} is not between the poles", self.0)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidLatitude<T> {}
