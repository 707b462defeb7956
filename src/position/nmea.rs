//! A [`LatLon`] as the fields of NMEA 0183.

use core::fmt;
use core::num::NonZeroU64;
use core::str::FromStr;

use super::LatLon;
use super::dms::{TEN, is_negative, parts};
use super::parse::quotient;
use crate::Real;

/// A latitude and a longitude in degrees and minutes, each with a number of decimals of a minute: the four
/// fields of sentences like GGA, GLL and RMC, `4723.8100,N,00832.7300,E`.
///
/// It parses such text and [writes](fmt::Display) it, in whole numbers: neither rounds.
/// [`LatLon::to_nmea`] and [`to_lat_lon`](Self::to_lat_lon) convert.
///
/// ```
/// use terrella::{LatLon, NmeaLatLon, ParseNmeaError};
/// let fields: NmeaLatLon = "4723.8100,N,00832.7300,E".parse()?;
/// assert_eq!(fields.to_lat_lon(), LatLon::new(47.396_833_333_333_336, 8.545_5)?);
/// // A receiver that has no position yet.
/// assert_eq!(",,,".parse::<NmeaLatLon>(), Err(ParseNmeaError::Unexpected { at: 0, found: Some(',') }));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use]
pub struct NmeaLatLon {
    lat: Angle,
    lon: Angle,
}

/// An angle as whole numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Angle {
    negative: bool,
    /// In units of the last decimal of a minute.
    size: u64,
    digits: u8,
}

impl<T: Real> LatLon<T> {
    /// Returns the fields of NMEA 0183, with `digits` decimals of a minute: the 4 of most receivers are 0.19
    /// m.
    ///
    /// Each angle is rounded to the nearest such number, ties to even, and carries: 9.999999 degrees with 2
    /// decimals are `1000.00`, not `0960.00`. A number of digits above [`NmeaLatLon::MAX_DIGITS`] counts as
    /// that one. The error is half of the last decimal.
    ///
    /// ```
    /// use terrella::LatLon;
    /// let oslo = LatLon::new(59.91, 10.75)?;
    /// assert_eq!(oslo.to_nmea(4).to_string(), "5954.6000,N,01045.0000,E");
    /// # Ok::<(), terrella::InvalidLatLon<f64>>(())
    /// ```
    pub fn to_nmea(self, digits: u8) -> NmeaLatLon {
        let digits = digits.min(NmeaLatLon::MAX_DIGITS);
        let angle = |angle: T| Angle {
            negative: is_negative(angle),
            size: parts(angle, 60 * minute(digits).get()),
            digits,
        };
        NmeaLatLon {
            lat: angle(self.lat()),
            lon: angle(self.lon()),
        }
    }
}

impl NmeaLatLon {
    /// The largest number of decimals of a minute.
    pub const MAX_DIGITS: u8 = 12;

    /// Returns the place. Whole minutes give the nearest scalar; with decimals it is within 1.5 ulp.
    #[must_use]
    pub fn to_lat_lon<T: Real>(self) -> LatLon<T> {
        let [lat, lon] = [self.lat, self.lon].map(|angle| {
            let minute = minute(angle.digits);
            let degree = minute.saturating_mul(SIXTY);
            let (degrees, rest) = (angle.size / degree, angle.size % degree);
            let minutes = T::whole(rest) / T::whole(minute.get());
            let sixty = T::of(60.0);
            let size = quotient(T::whole(degrees) * sixty, minutes, sixty);
            if angle.negative { -size } else { size }
        });
        LatLon::within(lat, lon)
    }
}

const SIXTY: NonZeroU64 = NonZeroU64::MIN.saturating_add(59);

/// The units of a minute.
fn minute(digits: u8) -> NonZeroU64 {
    TEN.saturating_pow(digits.into())
}

impl FromStr for NmeaLatLon {
    type Err = ParseNmeaError;

    /// Parses four fields with commas between them: latitude as `ddmm.mmmm`, N or S, longitude as
    /// `dddmm.mmmm`, E or W.
    ///
    /// There are up to 12 decimals; without decimals the point may be left out. Leading zeros may not, and
    /// nothing else is accepted: no sign, no space, no small letter, no 60 minutes.
    ///
    /// # Errors
    /// [`ParseNmeaError`] with the byte at which something is wrong.
    fn from_str(text: &str) -> Result<Self, ParseNmeaError> {
        let (lat, at) = angle(text, 0, 2, ['N', 'S'])?;
        let at = exactly(text, at, ',')?;
        let (lon, at) = angle(text, at, 3, ['E', 'W'])?;
        if at < text.len() {
            return Err(unexpected(text, at));
        }
        Ok(Self { lat, lon })
    }
}

fn unexpected(text: &str, at: usize) -> ParseNmeaError {
    ParseNmeaError::Unexpected {
        at,
        found: text.get(at..).and_then(|rest| rest.chars().next()),
    }
}

/// The byte after a character that must stand at one.
fn exactly(text: &str, at: usize, character: char) -> Result<usize, ParseNmeaError> {
    if text.get(at..).is_some_and(|rest| rest.starts_with(character)) {
        Ok(at + character.len_utf8())
    } else {
        Err(unexpected(text, at))
    }
}

/// The number that a text has from a byte on, in at most so many digits, and how many it has.
fn number(text: &str, at: usize, most: usize) -> (u64, usize) {
    let digits = text.get(at..).unwrap_or_default().bytes();
    digits
        .take(most)
        .take_while(u8::is_ascii_digit)
        .fold((0, 0), |(number, count), digit| {
            (number * 10 + u64::from(digit - b'0'), count + 1)
        })
}

/// An angle from its two fields, and the byte after them.
fn angle(
    text: &str,
    at: usize,
    of_degrees: usize,
    [positive, negative]: [char; 2],
) -> Result<(Angle, usize), ParseNmeaError> {
    let ((degrees, count), minutes_at) = (number(text, at, of_degrees), at + of_degrees);
    if count < of_degrees {
        return Err(unexpected(text, at + count));
    }
    let (minutes, count) = number(text, minutes_at, 2);
    if count < 2 {
        return Err(unexpected(text, minutes_at + count));
    }
    let point = minutes_at + 2;
    let (mut fraction, mut count, mut end) = (0, 0, point);
    if let Ok(decimals) = exactly(text, point, '.') {
        (fraction, count) = number(text, decimals, NmeaLatLon::MAX_DIGITS.into());
        end = decimals + count;
    }
    let after = exactly(text, end, ',')?;
    let (negative, after) = match exactly(text, after, positive) {
        Ok(after) => (false, after),
        Err(_) => (true, exactly(text, after, negative)?),
    };
    if minutes >= 60 {
        return Err(ParseNmeaError::NotBelow60 { at: minutes_at });
    }
    let digits = count as u8;
    let minute = minute(digits).get();
    let size = (degrees * 60 + minutes) * minute + fraction;
    // 90 of two digits, 180 of three.
    let most: u64 = if of_degrees == 2 { 90 } else { 180 };
    if size > most * 60 * minute {
        return Err(ParseNmeaError::OutOfRange { at });
    }
    let angle = Angle { negative, size, digits };
    Ok((angle, after))
}

impl fmt::Display for NmeaLatLon {
    /// Writes `4723.8100,N,00832.7300,E`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (angle, of_degrees, [positive, negative], after) in
            [(self.lat, 2, ["N", "S"], ","), (self.lon, 3, ["E", "W"], "")]
        {
            let (minutes, fraction) = (angle.size / minute(angle.digits), angle.size % minute(angle.digits));
            write!(f, "{:0of_degrees$}{:02}", minutes / 60, minutes % 60)?;
            if angle.digits > 0 {
                write!(f, ".{fraction:0digits$}", digits = usize::from(angle.digits))?;
            }
            write!(f, ",{}{after}", if angle.negative { negative } else { positive })?;
        }
        Ok(())
    }
}

/// Why fields of NMEA 0183 were not parsed as a [`NmeaLatLon`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ParseNmeaError {
    /// A character that is not expected there, or the end of the text.
    Unexpected {
        /// The byte at which it begins.
        at: usize,
        /// The character; `None` at the end of the text.
        found: Option<char>,
    },
    /// A number of minutes that is 60 or more.
    NotBelow60 {
        /// The byte at which it begins.
        at: usize,
    },
    /// A latitude above 90 degrees, or a longitude above 180.
    OutOfRange {
        /// The byte at which it begins.
        at: usize,
    },
}

impl fmt::Display for ParseNmeaError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unexpected { at, found: Some(found) } => {
                write!(
                    f,
                    "expected fields of latitude and longitude, got {found:?} at byte {at}"
                )
            }
            Self::Unexpected { at, found: None } => {
                write!(
                    f,
                    "expected fields of latitude and longitude, got the end of the text at byte {at}"
                )
            }
            Self::NotBelow60 { at } => write!(f, "expected minutes below 60 at byte {at}"),
            Self::OutOfRange { at } => {
                write!(
                    f,
                    "expected a latitude up to 90 or a longitude up to 180 degrees at byte {at}"
                )
            }
        }
    }
}

impl core::error::Error for ParseNmeaError {}
