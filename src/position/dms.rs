//! A [`LatLon`] as text in degrees, minutes and seconds.

use core::fmt;
use core::num::NonZeroU64;

use super::LatLon;
use crate::Real;
use crate::math::min;

/// A latitude and a longitude in degrees, minutes and seconds, rounded to a number of decimals of a second.
///
/// [`LatLon::to_dms`] returns it, and [`Display`](fmt::Display) writes it as text that [`LatLon`] parses.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use]
pub struct DmsLatLon {
    /// The latitude; negative in the south.
    pub lat: Dms,
    /// The longitude; negative in the west.
    pub lon: Dms,
}

/// An angle in degrees, minutes and seconds, rounded to a number of decimals of a second.
///
/// ```
/// use terrella::LatLon;
/// let lat = LatLon::new(-33.868_82, 151.209_29)?.to_dms(2).lat;
/// assert!(lat.is_negative());
/// assert_eq!((lat.degrees(), lat.minutes(), lat.seconds(), lat.fraction()), (33, 52, 7, 75));
/// assert_eq!(lat.to_string(), "-33°52′07.75″");
/// # Ok::<(), terrella::InvalidLatLon<f64>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use]
pub struct Dms {
    negative: bool,
    degrees: u16,
    minutes: u8,
    seconds: u8,
    fraction: u64,
    digits: u8,
}

impl<T: Real> LatLon<T> {
    /// Returns the degrees, minutes and seconds of latitude and longitude, with `digits` decimals of a
    /// second.
    ///
    /// Each angle is rounded to the nearest such number, ties to even, and carries: 59.999999° with no
    /// decimals is 60°00′00″, not 59°59′60″. A number of digits above [`Dms::MAX_DIGITS`] counts as that one.
    /// Neighbouring longitudes near 180° differ by 10⁻¹⁰″ in `f64`, by 0.06″ in `f32`.
    ///
    /// ```
    /// use terrella::LatLon;
    /// let oslo = LatLon::new(59.91, 10.75)?;
    /// assert_eq!(oslo.to_dms(0).to_string(), "59°54′36″N 10°45′00″E");
    /// assert_eq!(LatLon::new(59.999_999, -0.5)?.to_dms(1).to_string(), "60°00′00.0″N 0°30′00.0″W");
    /// assert_eq!(oslo.to_dms(0).to_string().parse(), Ok(oslo));
    /// # Ok::<(), terrella::InvalidLatLon<f64>>(())
    /// ```
    pub fn to_dms(self, digits: u8) -> DmsLatLon {
        DmsLatLon {
            lat: Dms::rounded(self.lat(), digits),
            lon: Dms::rounded(self.lon(), digits),
        }
    }
}

impl Dms {
    /// The largest number of decimals of a second.
    pub const MAX_DIGITS: u8 = 12;

    /// Of an angle in [−180, 180] degrees, in whole numbers: no step rounds but the last.
    fn rounded<T: Real>(angle: T, digits: u8) -> Self {
        let digits = digits.min(Self::MAX_DIGITS);
        let second = TEN.saturating_pow(digits.into());
        let parts = parts(angle, 3600 * second.get());
        let seconds = parts / second;
        Self {
            negative: is_negative(angle),
            degrees: (seconds / 3600) as u16,
            minutes: (seconds / 60 % 60) as u8,
            seconds: (seconds % 60) as u8,
            fraction: parts % second,
            digits,
        }
    }

    /// Returns whether the angle is negative: south of the equator, or west of Greenwich. −0 is negative,
    /// too.
    #[must_use]
    pub const fn is_negative(self) -> bool {
        self.negative
    }

    /// Returns the whole degrees, in 0 to 180.
    #[must_use]
    pub const fn degrees(self) -> u16 {
        self.degrees
    }

    /// Returns the whole minutes, in 0 to 59.
    #[must_use]
    pub const fn minutes(self) -> u8 {
        self.minutes
    }

    /// Returns the whole seconds, in 0 to 59.
    #[must_use]
    pub const fn seconds(self) -> u8 {
        self.seconds
    }

    /// Returns the decimals of a second, in units of the last decimal: 75 for 7.75″ with two digits.
    #[must_use]
    pub const fn fraction(self) -> u64 {
        self.fraction
    }

    /// Returns the number of decimals of a second.
    #[must_use]
    pub const fn digits(self) -> u8 {
        self.digits
    }

    /// Writes the angle without its sign.
    fn unsigned(self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            degrees,
            minutes,
            seconds,
            fraction,
            digits,
            ..
        } = self;
        write!(f, "{degrees}°{minutes:02}′{seconds:02}")?;
        if digits > 0 {
            write!(f, ".{fraction:0digits$}", digits = usize::from(digits))?;
        }
        f.write_str("″")
    }
}

pub(super) const TEN: NonZeroU64 = NonZeroU64::MIN.saturating_add(9);

/// Whether an angle has the sign of −0.
pub(super) fn is_negative<T: Real>(angle: T) -> bool {
    T::ONE.copysign(angle) < T::ZERO
}

/// The size of an angle in [−180, 180] degrees, in so many parts of a degree, below 10¹⁷: to the nearest
/// whole number, ties to even. No step rounds but the last.
pub(super) fn parts<T: Real>(angle: T, of_degree: u64) -> u64 {
    let magnitude = min(angle.abs(), T::of(180.0));
    let whole = magnitude.floor().unsigned_abs();
    // What is left of a degree, 120 binary digits of it. Those below are of numbers that are rounded to 0.
    let mut rest = magnitude - T::whole(whole.into());
    let mut binary = 0_u128;
    for _ in 0..5 {
        rest *= T::of(16_777_216.0);
        let next = rest.floor().unsigned_abs();
        rest -= T::whole(next.into());
        binary = binary << 24 | u128::from(next);
    }
    let zeros = binary.trailing_zeros().min(120);
    let product = (binary >> zeros) * u128::from(of_degree);
    halved(product, 120 - zeros) + u64::from(whole) * of_degree
}

/// A number over 2 to a power of at most 120, to the nearest whole number, ties to even.
fn halved(number: u128, power: u32) -> u64 {
    let Some(half) = power.checked_sub(1) else {
        return number as u64;
    };
    let (whole, rest) = (number >> power, number & ((1 << power) - 1));
    let tie = 1 << half;
    (whole + u128::from(rest > tie || (rest == tie && whole & 1 == 1))) as u64
}

impl fmt::Display for Dms {
    /// Writes `-33°52′07.75″`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.negative {
            f.write_str("-")?;
        }
        self.unsigned(f)
    }
}

impl fmt::Display for DmsLatLon {
    /// Writes `33°52′07.75″S 151°12′33.44″E`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { lat, lon } = self;
        lat.unsigned(f)?;
        f.write_str(if lat.negative { "S " } else { "N " })?;
        lon.unsigned(f)?;
        f.write_str(if lon.negative { "W" } else { "E" })
    }
}
