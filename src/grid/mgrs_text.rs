use core::fmt;

use super::mgrs::{polar_range, power};
use super::{Hemisphere, Mgrs, Zone};

/// The text of an [`Mgrs`] square, of at most 27 characters, from [`Mgrs::text`]. It has no spaces.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct MgrsText {
    bytes: [u8; LONGEST],
    length: usize,
}

/// `60XZV` and two times 11 digits.
const LONGEST: usize = 27;

/// The letters of columns and rows: the alphabet without I and O.
pub(super) const LETTERS: &[u8; 24] = b"ABCDEFGHJKLMNPQRSTUVWXYZ";

/// The letters of the columns of the polar regions, where three letters more are left out.
pub(super) const POLAR_COLUMNS: &[u8; 18] = b"ABCFGHJKLPQRSTUXYZ";

/// UTM's letters of rows begin anew after so many.
pub(super) const ROWS: u8 = 20;

impl MgrsText {
    pub(super) fn of(square: Mgrs) -> Self {
        let mut text = Self {
            bytes: [0; LONGEST],
            length: 0,
        };
        let zone = square.zone.number();
        if zone > 0 {
            text.push(b'0' + zone / 10);
            text.push(b'0' + zone % 10);
        }
        for letter in letters(square) {
            text.push(letter);
        }
        for digits in square.digits {
            for place in (0..square.precision).rev() {
                text.push(b'0' + (digits / power(place) % 10) as u8);
            }
        }
        text
    }

    fn push(&mut self, byte: u8) {
        if let Some(slot) = self.bytes.get_mut(self.length) {
            *slot = byte;
            self.length += 1;
        }
    }

    /// Returns the text.
    #[must_use]
    pub fn as_str(&self) -> &str {
        let written = self.bytes.get(..self.length).unwrap_or_default();
        // All bytes are letters and digits.
        core::str::from_utf8(written).unwrap_or_default()
    }
}

/// The letters of the band, the column and the row.
fn letters(square: Mgrs) -> [u8; 3] {
    let [column, row] = square.square;
    let letter = |letters: &[u8], at: u8| letters.get(usize::from(at)).copied().unwrap_or(b'?');
    let zone = square.zone.number();
    if square.zone != Zone::POLAR {
        // C to X; three sets of eight columns; rows that begin with A or F.
        let band = letter(LETTERS, (square.band + 12) as u8);
        let set = (zone + 2) % 3;
        let shift = if zone % 2 == 0 { 5 } else { 0 };
        return [
            band,
            letter(LETTERS, 8 * set + (column - 1)),
            letter(LETTERS, (row + shift) % ROWS),
        ];
    }
    let hemisphere = square.hemisphere();
    let [first, _] = polar_range(hemisphere);
    let east = column >= 20;
    let band = match (hemisphere, east) {
        (Hemisphere::South, false) => b'A',
        (Hemisphere::South, true) => b'B',
        (Hemisphere::North, false) => b'Y',
        (Hemisphere::North, true) => b'Z',
    };
    // From the pole to the east the letters begin with A; to the west they end with Z.
    let at = if east { column - 20 } else { column - 2 };
    [band, letter(POLAR_COLUMNS, at), letter(LETTERS, row - first)]
}

impl AsRef<str> for MgrsText {
    fn as_ref(&self) -> &str {
        self.as_str()
    }
}

impl fmt::Display for MgrsText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

impl fmt::Debug for MgrsText {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.as_str().fmt(f)
    }
}

#[cfg(feature = "defmt")]
impl defmt::Format for MgrsText {
    fn format(&self, f: defmt::Formatter<'_>) {
        self.as_str().format(f);
    }
}
