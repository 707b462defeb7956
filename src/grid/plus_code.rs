use core::fmt;
use core::str::FromStr;

use crate::{LatLon, Real};

/// A full plus code (Open Location Code): a cell of latitude and longitude, with 2, 4, 6, 8 or 10 to 15
/// digits.
///
/// Ten digits are 1/8000 of a degree: 14 m. Digits are written in upper case, and read in any case. Digits
/// after the 15th are read and count for nothing, as the specification has it.
///
/// The latitude times 25 000 000 and the longitude times 8 192 000 are rounded to the scalar, and then down
/// to a whole number, as the reference does it in `f64`. So a decimal number of degrees on the boundary of a
/// cell may fall into the cell below, if it is not exact in the scalar.
///
/// [Specification](https://github.com/google/open-location-code), in its folder `Documentation`.
///
/// ```
/// use terrella::LatLon;
/// use terrella::grid::PlusCode;
/// let merlion = LatLon::new(1.286_785, 103.854_503)?;
/// let code = PlusCode::containing(merlion, 10)?;
/// assert_eq!(code.to_string(), "6PH57VP3+PR");
/// // Near enough to a place, the rest will do.
/// let city = LatLon::new(1.3_f64, 103.8)?;
/// let short = code.shortened(city).unwrap();
/// assert_eq!(short.to_string(), "7VP3+PR");
/// assert_eq!(PlusCode::recovered("7VP3+PR", city), Ok(code));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias("OLC", "OpenLocationCode"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PlusCode {
    /// South and west of the cell, from −90 and −180, in the finest units.
    corner: [i64; 2],
    length: u8,
}

/// The end of a [`PlusCode`], enough near a place: from [`PlusCode::shortened`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ShortPlusCode {
    code: PlusCode,
    /// How many digits are left out: 4, 6 or 8.
    omitted: u8,
}

const DIGITS: [u8; 20] = *b"23456789CFGHJMPQRVWX";
/// The finest units of a degree of latitude and longitude: 20³ of them, and 5⁵ and 4⁵ in these.
const UNITS: [i64; 2] = [25_000_000, 8_192_000];
const PAIRS: u8 = 10;
const SEPARATOR: u8 = 8;

impl PlusCode {
    /// The largest number of digits.
    pub const MAX_LENGTH: u8 = 15;

    /// Returns the code of a number of digits whose cell contains a place. More than 15 digits count as 15.
    ///
    /// The north pole belongs to the northernmost cells.
    ///
    /// # Errors
    /// [`InvalidPlusCode::Length`] unless there are 2, 4, 6, 8, 10 or more digits.
    #[doc(alias = "encode")]
    pub fn containing<T: Real>(place: LatLon<T>, length: u8) -> Result<Self, InvalidPlusCode> {
        if length < 2 || (length < PAIRS && length % 2 == 1) {
            return Err(InvalidPlusCode::Length(length));
        }
        Ok(Self::of(units(place), length.min(Self::MAX_LENGTH)))
    }

    /// The code of finest units, of any longitude.
    fn of([lat, lon]: [i64; 2], length: u8) -> Self {
        let size = size(length);
        let lat = lat.clamp(0, 180 * UNITS[0] - 1);
        let lon = lon.rem_euclid(360 * UNITS[1]);
        Self {
            corner: [
                lat - lat.checked_rem(size[0]).unwrap_or_default(),
                lon - lon.checked_rem(size[1]).unwrap_or_default(),
            ],
            length,
        }
    }

    /// Returns the number of digits.
    #[must_use]
    pub const fn length(self) -> u8 {
        self.length
    }

    /// Returns south, west, north and east of the cell in degrees.
    #[must_use]
    #[doc(alias = "decode")]
    pub fn bounds<T: Real>(self) -> [T; 4] {
        let ([south, west], [height, width]) = (self.corner, size(self.length));
        [
            degrees(2 * south, 0),
            degrees(2 * west, 1),
            degrees(2 * (south + height), 0),
            degrees(2 * (west + width), 1),
        ]
    }

    /// Returns the middle of the cell in latitude and longitude.
    #[must_use]
    #[doc(alias = "decode")]
    pub fn centre<T: Real>(self) -> LatLon<T> {
        let [lat, lon] = self.doubled_centre();
        LatLon::within(degrees(lat, 0), degrees(lon, 1))
    }

    /// The middle of the cell in halves of units.
    fn doubled_centre(self) -> [i64; 2] {
        let ([south, west], [height, width]) = (self.corner, size(self.length));
        [2 * south + height, 2 * west + width]
    }

    /// Returns the code without its first 8, 6 or 4 digits, as many as the distance from a place allows: it
    /// is at most 0.3 of the cells of what is left out, in latitude and in longitude. None if the place is
    /// too far, or the code has fewer than 8 digits.
    #[must_use]
    pub fn shortened<T: Real>(self, near: LatLon<T>) -> Option<ShortPlusCode> {
        if self.length < SEPARATOR {
            return None;
        }
        let (centre, place) = (self.doubled_centre(), units(near));
        let lat = (centre[0] - 2 * place[0]).abs();
        let circle = 720 * UNITS[1];
        let lon = (centre[1] - 2 * place[1]).rem_euclid(circle);
        let lon = lon.min(circle - lon);
        let omitted = [8, 6, 4].into_iter().find(|&omitted| {
            let [height, width] = size(omitted);
            // Something is left, and 20 ranges are 0.3 · 2 · 10 cells.
            omitted < self.length && 10 * lat < 6 * height && 10 * lon < 6 * width
        })?;
        Some(ShortPlusCode { code: self, omitted })
    }

    /// Returns the full code of a short one: the one nearest to a place. A full code is returned as it is.
    ///
    /// # Errors
    /// [`InvalidPlusCode`] if the text is neither.
    pub fn recovered<T: Real>(text: &str, near: LatLon<T>) -> Result<Self, InvalidPlusCode> {
        let parsed = Parsed::new(text)?;
        let missing = SEPARATOR - parsed.separator;
        if missing == 0 {
            return parsed.full();
        }
        let [lat, lon] = units(near);
        let place = [lat, lon.rem_euclid(360 * UNITS[1])];
        let cell = size(missing);
        let first = Self::of(place, missing).corner;
        let corner = [first[0] + parsed.value[0], first[1] + parsed.value[1]];
        let code = Self {
            corner,
            length: parsed.length,
        };
        let centre = code.doubled_centre();
        let doubled = [2 * place[0], 2 * place[1]];
        let mut moved = corner;
        for (axis, moved) in moved.iter_mut().enumerate() {
            let (Some(centre), Some(doubled), Some(cell)) = (centre.get(axis), doubled.get(axis), cell.get(axis))
            else {
                continue;
            };
            // Not beyond a pole.
            let inside = |centre: i64| axis == 1 || (0..=360 * UNITS[0]).contains(&centre);
            if doubled + cell < *centre && inside(centre - 2 * cell) {
                *moved -= cell;
            } else if doubled - cell > *centre && inside(centre + 2 * cell) {
                *moved += cell;
            }
        }
        Ok(Self::of(moved, parsed.length))
    }

    /// The digits, as their values.
    fn digits(self) -> [u8; Self::MAX_LENGTH as usize] {
        let mut digits = [0; Self::MAX_LENGTH as usize];
        let [mut lat, mut lon] = self.corner;
        for (index, digit) in digits.iter_mut().enumerate().rev() {
            if index >= usize::from(PAIRS) {
                *digit = (lat % 5 * 4 + lon % 4) as u8;
                (lat, lon) = (lat / 5, lon / 4);
            } else if index % 2 == 1 {
                *digit = (lon % 20) as u8;
                lon /= 20;
            } else {
                *digit = (lat % 20) as u8;
                lat /= 20;
            }
        }
        digits
    }

    /// Writes the code without its first digits.
    fn write(self, omitted: u8, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = [0; Self::MAX_LENGTH as usize + 1];
        let digits = self.digits();
        let digit = |index: u8| {
            let value = digits.get(usize::from(index)).copied().unwrap_or_default();
            DIGITS.get(usize::from(value)).copied().unwrap_or_default()
        };
        let mut end = 0;
        let mut put = |byte: u8| {
            if let Some(slot) = text.get_mut(end) {
                *slot = byte;
                end += 1;
            }
        };
        for index in omitted..self.length.max(SEPARATOR) {
            if index == SEPARATOR {
                put(b'+');
            }
            put(if index < self.length { digit(index) } else { b'0' });
        }
        if self.length <= SEPARATOR {
            put(b'+');
        }
        f.pad(core::str::from_utf8(text.get(..end).unwrap_or_default()).unwrap_or_default())
    }
}

/// The finest units of a place: from −90 and −180 up. As in the reference, the products are rounded.
fn units<T: Real>(place: LatLon<T>) -> [i64; 2] {
    let whole = |angle: T, units: T| {
        let product = angle * units;
        // In two parts, for it has more than 31 bits.
        let high = (product * T::of(1.0 / 65536.0)).floor();
        let low = (product - integer::<T>(high) * T::of(65536.0)).floor();
        i64::from(high) * 65536 + i64::from(low)
    };
    [
        whole(place.lat(), T::of(25e6)) + 90 * UNITS[0],
        whole(place.lon(), T::of(8_192_000.0)) + 180 * UNITS[1],
    ]
}

/// The scalar of an integer.
fn integer<T: Real>(integer: i32) -> T {
    let size = T::whole(integer.unsigned_abs().into());
    if integer < 0 { -size } else { size }
}

/// Degrees of a number of halves of the finest units.
fn degrees<T: Real>(halves: i64, axis: usize) -> T {
    let (unit, quarter) = if axis == 0 { (UNITS[0], 90) } else { (UNITS[1], 180) };
    let from = halves - 2 * quarter * unit;
    let size = T::whole(from.unsigned_abs()) / T::whole(2 * unit.unsigned_abs());
    if from < 0 { -size } else { size }
}

/// Height and width of a cell in the finest units.
fn size(length: u8) -> [i64; 2] {
    let pairs = length.min(PAIRS) / 2;
    let mut size = [20 * UNITS[0], 20 * UNITS[1]];
    for _ in 1..pairs {
        size = [size[0] / 20, size[1] / 20];
    }
    for _ in PAIRS..length {
        size = [size[0] / 5, size[1] / 4];
    }
    size
}

impl fmt::Display for PlusCode {
    /// Writes `8FWC2345+G6`, or `8FWC0000+` with zeros for what is not given.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.write(0, f)
    }
}

impl fmt::Display for ShortPlusCode {
    /// Writes `2345+G6`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.code.write(self.omitted, f)
    }
}

impl FromStr for PlusCode {
    type Err = InvalidPlusCode;

    /// Parses a full code.
    ///
    /// # Errors
    /// [`InvalidPlusCode`] if the text is none: [`InvalidPlusCode::Short`] of a short code, which
    /// [`PlusCode::recovered`] takes.
    fn from_str(text: &str) -> Result<Self, InvalidPlusCode> {
        Parsed::new(text)?.full()
    }
}

/// What a text says, full or short.
struct Parsed {
    /// How many digits stand before the plus sign: even, at most 8.
    separator: u8,
    /// The number of digits of the full code, at most 15.
    length: u8,
    /// The digits that are given, in the finest units.
    value: [i64; 2],
}

impl Parsed {
    fn new(text: &str) -> Result<Self, InvalidPlusCode> {
        let separator = text.find('+').ok_or(InvalidPlusCode::Separator { at: text.len() })?;
        let misplaced = InvalidPlusCode::Separator { at: separator };
        if separator > usize::from(SEPARATOR) || separator % 2 == 1 || text.len() < 2 {
            return Err(misplaced);
        }
        let separator = separator as u8;
        let mut place = SEPARATOR - separator;
        let mut parsed = Self {
            separator,
            length: 0,
            value: [0; 2],
        };
        let mut zeros = None;
        for (at, found) in text.char_indices() {
            let unexpected = InvalidPlusCode::Digit { at, found };
            if found == '+' {
                if at != usize::from(separator) {
                    return Err(InvalidPlusCode::Separator { at });
                }
                continue;
            }
            let upper = found.to_ascii_uppercase();
            if found == '0' {
                // From an even place on to the plus sign of a full code, which is then the last.
                let first = *zeros.get_or_insert(place);
                if separator < SEPARATOR || first == 0 || first % 2 == 1 || at > usize::from(separator) {
                    return Err(InvalidPlusCode::Padding { at });
                }
                place = place.saturating_add(1);
                continue;
            }
            let digit = DIGITS.iter().position(|&digit| char::from(digit) == upper);
            let digit = digit.ok_or(unexpected)? as i64;
            if zeros.is_some() {
                return Err(InvalidPlusCode::Padding { at });
            }
            if place < PlusCode::MAX_LENGTH {
                let [height, width] = size(if place < PAIRS { place / 2 * 2 + 2 } else { place + 1 });
                let [lat, lon] = &mut parsed.value;
                if place >= PAIRS {
                    *lat += digit / 4 * height;
                    *lon += digit % 4 * width;
                } else if place % 2 == 0 {
                    *lat += digit * height;
                } else {
                    *lon += digit * width;
                }
            }
            place = place.saturating_add(1);
        }
        // A digit after the plus sign has another one beside it.
        if place == SEPARATOR + 1 {
            return Err(InvalidPlusCode::Length(place));
        }
        parsed.length = zeros.unwrap_or(place).min(PlusCode::MAX_LENGTH);
        Ok(parsed)
    }

    fn full(self) -> Result<PlusCode, InvalidPlusCode> {
        if self.separator < SEPARATOR {
            return Err(InvalidPlusCode::Short);
        }
        let [lat, lon] = self.value;
        if lat >= 180 * UNITS[0] || lon >= 360 * UNITS[1] {
            return Err(InvalidPlusCode::OutOfRange);
        }
        Ok(PlusCode {
            corner: self.value,
            length: self.length,
        })
    }
}

/// Why a plus code was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidPlusCode {
    /// There are no codes of so many digits.
    Length(u8),
    /// A plus sign is missing, is the second one, or stands after an odd number of digits or more than 8.
    Separator {
        /// The byte at which it is, or the length of the text.
        at: usize,
    },
    /// A zero, or a digit after one: zeros fill a full code from an even place on to its plus sign.
    Padding {
        /// The byte at which it is.
        at: usize,
    },
    /// A character is none of the 20 digits.
    Digit {
        /// The byte at which it begins.
        at: usize,
        /// The character.
        found: char,
    },
    /// The code is a short one: [`PlusCode::recovered`] takes it.
    Short,
    /// The first digits lead beyond a pole or 180°.
    OutOfRange,
}

impl fmt::Display for InvalidPlusCode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "there are no plus codes of {length} digits"),
            Self::Separator { at } => write!(f, "the plus sign is missing or misplaced at index {at}"),
            Self::Padding { at } => write!(f, "no zeros may stand there, nor digits after them: index {at}"),
            Self::Digit { at, found } => write!(f, "{found:?} at index {at} is no digit of plus codes"),
            Self::Short => f.write_str("a short plus code needs a place to which it is near"),
            Self::OutOfRange => f.write_str("the plus code lies beyond a pole or 180 degrees"),
        }
    }
}

impl core::error::Error for InvalidPlusCode {}
