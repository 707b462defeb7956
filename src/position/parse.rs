//! A [`LatLon`] from text: decimal degrees, or degrees, minutes and seconds.

use core::fmt;
use core::str::FromStr;

use super::LatLon;
use super::lat_lon::InvalidLatLon;
use super::token::{Hemisphere, Token, Unit, tokens};
use crate::Real;
use crate::math::{product_of_any, select, sum};

impl<T: Real + FromStr> FromStr for LatLon<T> {
    type Err = ParseLatLonError<T>;

    /// Parses two angles: latitude before longitude, unless letters N, S, E, W say otherwise.
    ///
    /// | text | |
    /// |---|---|
    /// | `59.91, 10.75` | decimal degrees; what [`Display`](fmt::Display) writes |
    /// | `59.91 10.75`, `59.91;10.75` | a space or a semicolon in place of the comma |
    /// | `59.91N 10.75E`, `N59.91 E10.75`, `E10.75 N59.91` | hemispheres; lower case, too |
    /// | `59°54′36″N 10°45′00″E` | degrees, minutes, seconds |
    /// | `59d54'36"N 10d45'0"E` | the same in ASCII; `''` is `"` |
    /// | `59:54:36, 10:45` | colons |
    /// | `59 54 36 N, 10 45 00 E`, `59 54 36 10 45 00` | spaces |
    ///
    /// The last number of an angle may have a decimal fraction, the others are whole. Minutes and seconds are
    /// below 60; `60.0`, which some programs write for 59.99, is accepted. A minus sign stands for S or W,
    /// and is refused beside such a letter. Exponents (`1e-7`), decimal commas, `nan` and `inf` are refused.
    ///
    /// The result is the scalar nearest to decimal degrees, and to whole minutes and seconds. With a decimal
    /// fraction of minutes or seconds it is within 1.5 ulp.
    ///
    /// ```
    /// use terrella::LatLon;
    /// let oslo: LatLon = "59°54′36″N 10°45′00″E".parse()?;
    /// assert_eq!(oslo, LatLon::new(59.91, 10.75)?);
    /// assert_eq!("59.91, 10.75".parse(), Ok(oslo));
    /// let refused = "59.91N, 200.5 m".parse::<LatLon>().unwrap_err();
    /// assert_eq!(refused.to_string(), "expected latitude and longitude, got 'm' at byte 14");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`ParseLatLonError`] with the byte or the number that is wrong.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let (first, second) = halves(text).ok_or(ParseLatLonError::Undivided)?;
        let first = Angle::parse(text, first)?;
        let second = Angle::parse(text, second)?;
        let is_lat = |letter: Option<Hemisphere>| letter.map(|letter| letter.is_latitude);
        let (lat, lon) = match (is_lat(first.letter), is_lat(second.letter)) {
            (Some(true) | None, Some(false) | None) => (first, second),
            (Some(false), Some(true) | None) | (None, Some(true)) => (second, first),
            (Some(true), Some(true)) | (Some(false), Some(false)) => return Err(ParseLatLonError::SameAxis),
        };
        Self::new(lat.degrees, lon.degrees).map_err(ParseLatLonError::OutOfRange)
    }
}

/// A part of the text: its first byte, and the byte after its last.
type Part = (usize, usize);

/// Where the first angle ends and the second begins; none where it cannot be told.
fn halves(text: &str) -> Option<(Part, Part)> {
    let all = text.len();
    let cut = |at: usize| Some(((0, at), (at, all)));
    let numbers = |from: usize| tokens(text, (from, all)).filter(|(_, token)| matches!(token, Token::Number));
    if let Some(((at, end), _)) = tokens(text, (0, all)).find(|(_, token)| matches!(token, Token::Comma)) {
        return Some(((0, at), (end, all)));
    }
    let first_number = numbers(0).next().map_or(all, |((at, _), _)| at);
    let mut letters = tokens(text, (0, all)).filter(|(_, token)| matches!(token, Token::Hemisphere(_)));
    let letters = (letters.next(), letters.next());
    if let (Some(((first, first_end), _)), Some(((second, _), _))) = letters {
        let at = select(first < first_number, second, first_end);
        if numbers(at).next().is_some() {
            return cut(at);
        }
    } else if let (Some(((letter, end), _)), None) = letters {
        // "59.91 E 10.75": of which of the two?
        if letter > first_number && numbers(end).next().is_some() {
            return None;
        }
    }
    // One gap and no more, whatever is on either side.
    let mut gaps =
        tokens(text, (0, all)).filter(|((at, end), token)| matches!(token, Token::Space) && *at > 0 && *end < all);
    if let (Some(((at, _), _)), None) = (gaps.next(), gaps.next()) {
        return cut(at);
    }
    let sign = |token: &Token| matches!(token, Token::Sign { .. });
    if let Some(((at, _), _)) = tokens(text, (first_number, all)).find(|(_, token)| sign(token)) {
        return cut(at);
    }
    // The number whose mark of degrees is the second.
    let (mut number, mut degrees) = (0, 0);
    for ((at, _), token) in tokens(text, (0, all)) {
        match token {
            Token::Number => number = at,
            Token::Mark(Unit::Degrees) if degrees > 0 => return cut(number),
            Token::Mark(Unit::Degrees) => degrees += 1,
            _ => {}
        }
    }
    // Numbers without marks: as many for each angle.
    let plain = |token: &Token| !matches!(token, Token::Mark(_) | Token::Colon);
    let count = numbers(0).count();
    if tokens(text, (0, all)).all(|(_, token)| plain(&token)) && count >= 2 && count % 2 == 0 {
        return numbers(0).nth(count / 2).and_then(|((at, _), _)| cut(at));
    }
    None
}

/// An angle in degrees, and the hemisphere that its text names.
struct Angle<T> {
    degrees: T,
    letter: Option<Hemisphere>,
}

impl<T: Real + FromStr> Angle<T> {
    fn parse(text: &str, part: Part) -> Result<Self, ParseLatLonError<T>> {
        let unexpected = |at: usize| ParseLatLonError::Unexpected {
            at,
            found: text.get(at..).and_then(|rest| rest.chars().next()),
        };
        let mut sexagesimal = Sexagesimal::new();
        let mut sign = None;
        let mut letter: Option<Hemisphere> = None;
        // Whether the angle is complete, its last number has yet no mark, and a colon waits for a number.
        let (mut complete, mut bare, mut waits) = (false, false, false);
        // The end of a sign, which its number must follow.
        let mut signed = None;
        for ((at, end), token) in tokens(text, part) {
            if signed
                .take()
                .is_some_and(|end| end != at || !matches!(token, Token::Number))
            {
                return Err(unexpected(at));
            }
            let begun = sexagesimal.last.is_some();
            match token {
                Token::Space => {}
                Token::Sign { negative } if !begun && sign.is_none() && !(negative && letter.is_some()) => {
                    (sign, signed) = (Some(negative), Some(end));
                }
                Token::Hemisphere(found) if letter.is_none() && !waits && sign != Some(true) => {
                    if !begun && sign.is_some() {
                        return Err(unexpected(at));
                    }
                    (letter, complete, bare) = (Some(found), begun, false);
                }
                Token::Number if !complete => {
                    let digits = text.get(at..end).unwrap_or_default();
                    let number = digits.parse().map_err(|_| unexpected(at))?;
                    if !sexagesimal.push(number, digits.contains('.')) {
                        return Err(unexpected(at));
                    }
                    (bare, waits) = (true, false);
                }
                Token::Mark(unit) if bare && sexagesimal.mark(unit) => bare = false,
                Token::Colon if bare => (bare, waits) = (false, true),
                _ => return Err(unexpected(at)),
            }
        }
        if signed.is_some() || waits || sexagesimal.last.is_none() {
            return Err(unexpected(part.1));
        }
        let degrees = sexagesimal.degrees()?;
        let negative = sign == Some(true) || letter.is_some_and(|letter| letter.is_negative);
        Ok(Self {
            degrees: select(negative, -degrees, degrees),
            letter,
        })
    }
}

/// Degrees, minutes and seconds, as far as they are given.
struct Sexagesimal<T> {
    degrees: T,
    minutes: T,
    seconds: T,
    /// The unit of the last number; none before the first.
    last: Option<Unit>,
    /// Whether the last number has a decimal point.
    point: bool,
}

impl<T: Real> Sexagesimal<T> {
    fn new() -> Self {
        let zero = T::ZERO;
        Self {
            degrees: zero,
            minutes: zero,
            seconds: zero,
            last: None,
            point: false,
        }
    }

    fn place(&mut self, unit: Unit) -> &mut T {
        match unit {
            Unit::Degrees => &mut self.degrees,
            Unit::Minutes => &mut self.minutes,
            Unit::Seconds => &mut self.seconds,
        }
    }

    /// Takes a number of the next unit; false after seconds, and after a number with a point.
    fn push(&mut self, number: T, point: bool) -> bool {
        let unit = match self.last {
            _ if self.point => return false,
            None => Unit::Degrees,
            Some(Unit::Degrees) => Unit::Minutes,
            Some(Unit::Minutes) => Unit::Seconds,
            Some(Unit::Seconds) => return false,
        };
        *self.place(unit) = number;
        (self.last, self.point) = (Some(unit), point);
        true
    }

    /// Makes the last number one of this unit, units before it being left out; false if it is of a smaller
    /// one.
    fn mark(&mut self, unit: Unit) -> bool {
        let Some(last) = self.last.filter(|&last| last <= unit) else {
            return false;
        };
        let number = core::mem::take(self.place(last));
        *self.place(unit) = number;
        self.last = Some(unit);
        true
    }

    /// The angle in degrees.
    fn degrees(&self) -> Result<T, ParseLatLonError<T>> {
        let sixty = T::of(60.0);
        for number in [self.minutes, self.seconds] {
            if !(number < sixty || (self.point && number == sixty)) {
                return Err(ParseLatLonError::NotBelow60(number));
            }
        }
        let minutes = self.degrees * sixty;
        Ok(match self.last {
            None | Some(Unit::Degrees) => self.degrees,
            Some(Unit::Minutes) => quotient(minutes, self.minutes, sixty),
            Some(Unit::Seconds) => quotient((minutes + self.minutes) * sixty, self.seconds, T::of(3600.0)),
        })
    }
}

/// (whole + last)/parts: one division of a sum, with what both lose.
pub(super) fn quotient<T: Real>(whole: T, last: T, parts: T) -> T {
    let (total, total_lost) = sum(whole, last);
    let angle = total / parts;
    let (back, back_lost) = product_of_any(angle, parts);
    let lost = ((total - back) - back_lost + total_lost) / parts;
    angle + select(lost.is_finite(), lost, T::ZERO)
}

/// Why a text was not parsed as a [`LatLon`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum ParseLatLonError<T> {
    /// A character that is not expected there, or the end of the text.
    Unexpected {
        /// The byte at which it begins.
        at: usize,
        /// The character; `None` at the end of the text.
        found: Option<char>,
    },
    /// The text does not say where the first angle ends and the second begins. Put a comma between them.
    Undivided,
    /// Both angles are latitudes (N, S), or both longitudes (E, W).
    SameAxis,
    /// A number of minutes or seconds that is 60 or more.
    NotBelow60(T),
    /// The latitude or longitude is out of range.
    OutOfRange(InvalidLatLon<T>),
}

impl<T: fmt::Debug> fmt::Display for ParseLatLonError<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unexpected { at, found: Some(found) } => {
                write!(f, "expected latitude and longitude, got {found:?} at byte {at}")
            }
            Self::Unexpected { at, found: None } => {
                write!(
                    f,
                    "expected latitude and longitude, got the end of the text at byte {at}"
                )
            }
            Self::Undivided => f.write_str("expected two angles with a comma between them"),
            Self::SameAxis => f.write_str("expected one of N, S and one of E, W, got two of the same"),
            Self::NotBelow60(number) => write!(f, "expected minutes and seconds below 60, got {number:?}"),
            Self::OutOfRange(error) => error.fmt(f),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for ParseLatLonError<T> {}
