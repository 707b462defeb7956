use core::fmt;
use core::str::FromStr;

use super::halves::{boundary, eastern, part};
use crate::{LatLon, Real};

/// A cell of geohash: latitude and longitude halved in turn, five times a letter (Niemeyer 2008).
///
/// It has 1 to 12 letters. With 12 it is 0.17 m high and 0.34·cos φ times 0.11 m wide. A place belongs to the
/// cell north and east of a boundary, exactly; the north pole belongs to the northernmost cells, and
/// longitude 180 is −180.
///
/// The text form is in lower case. Parsing accepts upper case, too, and refuses the letters a, i, l and o.
///
/// ```
/// use terrella::LatLon;
/// use terrella::grid::Geohash;
/// let cell = Geohash::containing(LatLon::new(57.649_11_f64, 10.407_44)?, 11)?;
/// assert_eq!(cell.to_string(), "u4pruydqqvj");
/// let [south, west, north, east] = "ezs42".parse::<Geohash>()?.bounds::<f64>();
/// assert_eq!([south, west, north, east], [42.583_007_812_5, -5.625, 42.626_953_125, -5.581_054_687_5]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Geohash {
    /// Counted from the south.
    row: u32,
    /// Counted from −180°.
    column: u32,
    length: u8,
}

const LETTERS: [u8; 32] = *b"0123456789bcdefghjkmnpqrstuvwxyz";

impl Geohash {
    /// The largest number of letters.
    pub const MAX_LENGTH: u8 = 12;

    /// Returns the cell of a number of letters that contains a place.
    ///
    /// # Errors
    /// [`InvalidGeohash::Length`] unless there are 1 to 12 letters.
    #[doc(alias = "encode")]
    pub fn containing<T: Real>(place: LatLon<T>, length: u8) -> Result<Self, InvalidGeohash> {
        if !(1..=Self::MAX_LENGTH).contains(&length) {
            return Err(InvalidGeohash::Length(length.into()));
        }
        let [rows, columns] = bits(length);
        Ok(Self {
            row: part(place.lat(), 90, rows),
            column: part(eastern(place.lon()), 180, columns),
            length,
        })
    }

    /// Returns the number of letters.
    #[must_use]
    pub const fn length(self) -> u8 {
        self.length
    }

    /// Returns south, west, north and east of the cell in degrees: exactly in `f64`.
    #[must_use]
    #[doc(alias = "decode")]
    pub fn bounds<T: Real>(self) -> [T; 4] {
        let [rows, columns] = bits(self.length);
        let (row, column) = (i64::from(self.row), i64::from(self.column));
        [
            boundary(row, 90, rows),
            boundary(column, 180, columns),
            boundary(row + 1, 90, rows),
            boundary(column + 1, 180, columns),
        ]
    }

    /// Returns the middle of the cell in latitude and longitude: exactly in `f64`.
    #[must_use]
    #[doc(alias = "decode")]
    pub fn centre<T: Real>(self) -> LatLon<T> {
        let [rows, columns] = bits(self.length);
        let middle = |number: u32| 2 * i64::from(number) + 1;
        LatLon::within(
            boundary(middle(self.row), 90, rows + 1),
            boundary(middle(self.column), 180, columns + 1),
        )
    }

    /// Returns the cell with one letter less around this one; none of one letter.
    #[must_use]
    pub fn parent(self) -> Option<Self> {
        let length = self.length.checked_sub(1).filter(|&length| length > 0)?;
        let ([rows, columns], [fewer, less]) = (bits(self.length), bits(length));
        Some(Self {
            row: self.row >> (rows - fewer),
            column: self.column >> (columns - less),
            length,
        })
    }

    /// Returns the cell so many rows to the north and columns to the east; none beyond a pole. Columns go on
    /// across 180°.
    #[must_use]
    pub fn neighbour(self, north: i32, east: i32) -> Option<Self> {
        let [rows, columns] = bits(self.length);
        let row = i64::from(self.row) + i64::from(north);
        let column = (i64::from(self.column) + i64::from(east)) & ((1 << columns) - 1);
        (0..1 << rows).contains(&row).then_some(Self {
            row: row as u32,
            column: column as u32,
            length: self.length,
        })
    }

    /// Returns the eight cells around: north, north-east, and on clockwise; none beyond a pole.
    #[must_use]
    pub fn neighbours(self) -> [Option<Self>; 8] {
        [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]
            .map(|(north, east)| self.neighbour(north, east))
    }

    /// The five bits of a letter.
    fn letter(self, index: u8) -> usize {
        let [rows, columns] = bits(self.length);
        (0..5).fold(0, |letter, k| {
            let bit = 5 * index + k;
            // Longitude first.
            let set = if bit % 2 == 0 {
                self.column >> (columns - 1 - bit / 2)
            } else {
                self.row >> (rows - 1 - bit / 2)
            };
            letter << 1 | (set & 1) as usize
        })
    }
}

/// The bits of row and column.
const fn bits(length: u8) -> [u8; 2] {
    [5 * length / 2, (5 * length).div_ceil(2)]
}

impl fmt::Display for Geohash {
    /// Writes the letters in lower case.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = [0; Self::MAX_LENGTH as usize];
        for (index, slot) in (0..self.length).zip(&mut text) {
            *slot = LETTERS.get(self.letter(index)).copied().unwrap_or_default();
        }
        let text = text.get(..usize::from(self.length)).unwrap_or_default();
        f.pad(core::str::from_utf8(text).unwrap_or_default())
    }
}

impl FromStr for Geohash {
    type Err = InvalidGeohash;

    /// Parses 1 to 12 letters.
    ///
    /// # Errors
    /// [`InvalidGeohash`] with the letter and its index, or the number of letters.
    fn from_str(text: &str) -> Result<Self, InvalidGeohash> {
        let (mut row, mut column, mut length) = (0_u32, 0_u32, 0_u8);
        for (at, found) in text.char_indices() {
            let lower = found.to_ascii_lowercase();
            let letter = LETTERS.iter().position(|&letter| char::from(letter) == lower);
            let letter = letter.ok_or(InvalidGeohash::Letter { at, found })?;
            if length == Self::MAX_LENGTH {
                return Err(InvalidGeohash::Length(text.len()));
            }
            for k in (0..5).rev() {
                let bit = (letter >> k & 1) as u32;
                // An odd letter begins with the latitude.
                if (k + usize::from(length)) % 2 == 0 {
                    column = column << 1 | bit;
                } else {
                    row = row << 1 | bit;
                }
            }
            length += 1;
        }
        if length == 0 {
            return Err(InvalidGeohash::Length(0));
        }
        Ok(Self { row, column, length })
    }
}

/// Why a geohash was refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidGeohash {
    /// The number of letters is not in 1 to 12.
    Length(usize),
    /// A character is none of the 32 letters.
    Letter {
        /// The byte at which it begins: its index among letters.
        at: usize,
        /// The character.
        found: char,
    },
}

impl fmt::Display for InvalidGeohash {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "a geohash has 1 to 12 letters, not {length}"),
            Self::Letter { at, found } => write!(f, "{found:?} at index {at} is no letter of geohashes"),
        }
    }
}

impl core::error::Error for InvalidGeohash {}
