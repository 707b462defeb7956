//! A [`LatLon`] as the fields of NMEA 0183.

use core::fmt;
use core::str::FromStr;

use super::LatLon;
use super::dms::{TEN, is_negative, parts};
use super::lat_lon::InvalidLatLon;
use super::parse::quotient;
use crate::Real;

/// A latitude and a longitude in degrees and minutes, rounded to a number of decimals of a minute: the four fields of
/// sentences like GGA, GLL and RMC.
///
/// [`LatLon::to_nmea`] returns it, and [`Display`](fmt::Display) writes it as text that [`LatLon::from_nmea`] reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[must_use]
pub struct NmeaLatLon {
    /// Each by its sign and its size in units of the last decimal of a minute.
    lat: (bool, u64),
    lon: (bool, u64),
    digits: u8,
}

impl NmeaLatLon {
    /// The largest number of decimals of a minute.
    pub const MAX_DIGITS: u8 = 12;
}

impl<T: Real> LatLon<T> {
    /// Returns the fields of NMEA 0183, with `digits` decimals of a minute: 4 of most receivers are 0.19 m.
    ///
    /// Each angle is rounded to the nearest such number, ties to even, and carries: 9.999999 degrees with 2 decimals
    /// are `1000.00`, not `0960.00`. A number of digits above [`NmeaLatLon::MAX_DIGITS`] counts as that one. The error
    /// is half of the last decimal.
    ///
    /// ```
    /// use terrella::LatLon;
    /// let oslo = LatLon::new(59.91, 10.75)?;
    /// assert_eq!(oslo.to_nmea(4).to_string(), "5954.6000,N,01045.0000,E");
    /// assert_eq!(LatLon::from_nmea("5954.6000,N,01045.0000,E"), Ok(oslo));
    /// # Ok::<(), terrella::InvalidLatLon<f64>>(())
    /// ```
    pub fn to_nmea(self, digits: u8) -> NmeaLatLon {
        let digits = digits.min(NmeaLatLon::MAX_DIGITS);
        let minute = TEN.saturating_pow(digits.into()).get();
        let angle = |angle: T| (is_negative(angle), parts(angle, 60 * minute));
        NmeaLatLon {
            lat: angle(self.lat()),
            lon: angle(self.lon()),
            digits,
        }
    }
}

impl<T: Real + FromStr> LatLon<T> {
    /// Reads four fields of NMEA 0183 with commas between them: latitude as `ddmm.mmmm`, N or S, longitude as
    /// `dddmm.mmmm`, E or W.
    ///
    /// The number of decimals is any; without decimals the point may be left out. Leading zeros may not, and nothing
    /// else is accepted: no sign, no space, no small letter, no 60 minutes. The result is the scalar nearest to whole
    /// minutes; with decimals it is within 1.5 ulp.
    ///
    /// ```
    /// use terrella::{LatLon, ParseNmeaError};
    /// let zurich = LatLon::from_nmea("4723.8100,N,00832.7300,E")?;
    /// assert_eq!(zurich, LatLon::new(47.396_833_333_333_336, 8.545_5)?);
    /// // A receiver that has no position yet.
    /// assert_eq!(LatLon::<f32>::from_nmea(",,,"), Err(ParseNmeaError::Unexpected { at: 0, found: Some(',') }));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ParseNmeaError`] with the byte or the number that is wrong.
    pub fn from_nmea(text: &str) -> Result<Self, ParseNmeaError<T>> {
        let (lat, at) = angle(text, 0, 2, ['N', 'S'])?;
        let at = exactly(text, at, ',')?;
        let (lon, at) = angle(text, at, 3, ['E', 'W'])?;
        if at < text.len() {
            return Err(unexpected(text, at));
        }
        if lon.abs() > T::of(180.0) {
            return Err(ParseNmeaError::Beyond180(lon));
        }
        Self::new(lat, lon).map_err(ParseNmeaError::OutOfRange)
    }
}

fn unexpected<T>(text: &str, at: usize) -> ParseNmeaError<T> {
    ParseNmeaError::Unexpected {
        at,
        found: text.get(at..).and_then(|rest| rest.chars().next()),
    }
}

/// The byte after a character that must stand at one.
fn exactly<T>(text: &str, at: usize, character: char) -> Result<usize, ParseNmeaError<T>> {
    if text.get(at..).is_some_and(|rest| rest.starts_with(character)) {
        Ok(at + character.len_utf8())
    } else {
        Err(unexpected(text, at))
    }
}

/// How many digits there are from a byte on.
fn digits(text: &str, at: usize) -> usize {
    let rest = text.get(at..).unwrap_or_default();
    rest.bytes().take_while(u8::is_ascii_digit).count()
}

/// An angle from its two fields, and the byte after them.
fn angle<T: Real + FromStr>(
    text: &str,
    at: usize,
    of_degrees: usize,
    [positive, negative]: [char; 2],
) -> Result<(T, usize), ParseNmeaError<T>> {
    let whole = digits(text, at);
    if whole != of_degrees + 2 {
        // The first byte that is no digit, or is one too many.
        return Err(unexpected(text, at + whole.min(of_degrees + 2)));
    }
    let (minutes, point) = (at + of_degrees, at + whole);
    let mut end = point;
    if text.get(point..).is_some_and(|rest| rest.starts_with('.')) {
        end += 1 + digits(text, point + 1);
    }
    let number = |from: usize, to: usize| {
        let number = text.get(from..to).and_then(|digits| digits.parse::<T>().ok());
        number.ok_or(unexpected(text, from))
    };
    let (degrees, minutes) = (number(at, minutes)?, number(minutes, end)?);
    let sixty = T::of(60.0);
    if minutes >= sixty {
        return Err(ParseNmeaError::NotBelow60(minutes));
    }
    let size = quotient(degrees * sixty, minutes, sixty);
    let at = exactly(text, end, ',')?;
    match exactly::<T>(text, at, positive) {
        Ok(end) => Ok((size, end)),
        Err(_) => exactly(text, at, negative).map(|end| (-size, end)),
    }
}

impl fmt::Display for NmeaLatLon {
    /// Writes `4723.8100,N,00832.7300,E`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let digits = usize::from(self.digits);
        let minute = TEN.saturating_pow(self.digits.into());
        for ((negative, size), of_degrees, letters, after) in [
            (self.lat, 2, ["N", "S"], ","),
            (self.lon, 3, ["E", "W"], ""),
        ] {
            let (minutes, fraction) = (size / minute, size % minute);
            write!(f, "{:0of_degrees$}{:02}", minutes / 60, minutes % 60)?;
            if digits > 0 {
                write!(f, ".{fraction:0digits$}")?;
            }
            let [positive, negation] = letters;
            write!(f, ",{}{after}", if negative { negation } else { positive })?;
        }
        Ok(())
    }
}

/// Why fields of NMEA 0183 were not read as a [`LatLon`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ParseNmeaError<T> {
    /// A character that is not expected there, or the end of the text.
    Unexpected {
        /// The byte at which it begins.
        at: usize,
        /// The character; `None` at the end of the text.
        found: Option<char>,
    },
    /// A number of minutes that is 60 or more.
    NotBelow60(T),
    /// The longitude in degrees is above 180.
    Beyond180(T),
    /// The latitude is above 90 degrees.
    OutOfRange(InvalidLatLon<T>),
}

impl<T: fmt::Debug> fmt::Display for ParseNmeaError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unexpected { at, found: Some(found) } => {
                write!(f, "expected fields of latitude and longitude, got {found:?} at byte {at}")
            }
            Self::Unexpected { at, found: None } => {
                write!(f, "expected fields of latitude and longitude, got the end of the text at byte {at}")
            }
            Self::NotBelow60(number) => write!(f, "expected minutes below 60, got {number:?}"),
            Self::Beyond180(lon) => write!(f, "longitude {lon:?} is not in [-180, 180] degrees"),
            Self::OutOfRange(error) => error.fmt(f),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for ParseNmeaError<T> {}
