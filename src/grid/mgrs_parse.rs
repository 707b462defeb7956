use core::fmt;
use core::str::FromStr;

use super::mgrs::{polar_range, rows_of, signed};
use super::mgrs_text::{LETTERS, POLAR_COLUMNS, ROWS};
use super::{Hemisphere, Mgrs, Zone};

/// Why a text is not an MGRS square.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ParseMgrsError {
    /// The zone's number is not 1 to 60. It is absent in the polar regions. Numbers are told up to 255.
    Zone(u8),
    /// The letter of the band is not one of C to X after a zone, or A, B, Y, Z without one; or it is I or O.
    Band(char),
    /// The first letter of the square is not one of the zone's columns; or it is I or O.
    Column(char),
    /// The second letter of the square is not one of the rows; or it is I or O.
    Row(char),
    /// The text ends before the two letters of the square.
    Unfinished,
    /// The square is not in the band: band and row.
    Inconsistent(char, char),
    /// There is not the same number of digits for easting and northing. The number of all digits.
    Odd(usize),
    /// There are more than 22 digits.
    TooLong(usize),
    /// A character that does not belong there.
    Character(char),
}

impl fmt::Display for ParseMgrsError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Zone(zone) => write!(f, "zone {zone} is not in 1 to 60"),
            Self::Band(letter) => write!(f, "{letter:?} is not the letter of a band"),
            Self::Column(letter) => write!(f, "{letter:?} is not a column of the zone"),
            Self::Row(letter) => write!(f, "{letter:?} is not a row of the zone"),
            Self::Unfinished => f.write_str("the letters of the square are missing"),
            Self::Inconsistent(band, row) => write!(f, "row {row} is not in band {band}"),
            Self::Odd(digits) => write!(f, "{digits} digits, not as many for easting as for northing"),
            Self::TooLong(digits) => write!(f, "{digits} digits, more than 22"),
            Self::Character(character) => write!(f, "unexpected {character:?}"),
        }
    }
}

impl core::error::Error for ParseMgrsError {}

/// Reads upper and lower case. Spaces may stand around the text, and between zone and band, letters of the
/// square, easting and northing, as in `4Q FJ 12345 67890`.
///
/// # Errors
/// [`ParseMgrsError`]: nothing is guessed.
impl FromStr for Mgrs {
    type Err = ParseMgrsError;

    fn from_str(text: &str) -> Result<Self, ParseMgrsError> {
        let text = text.trim_matches(' ');
        let after_zone = text.trim_start_matches(|c: char| c.is_ascii_digit());
        let zone = zone_of(text.get(..text.len() - after_zone.len()).unwrap_or_default())?;
        let mut letters = after_zone.chars();
        let band = next_letter(&mut letters)?;
        let after_band = letters.as_str().trim_start_matches(' ');
        let mut letters = after_band.chars();
        let [column, row] = [next_letter(&mut letters)?, next_letter(&mut letters)?];
        let (band, square) = match zone {
            Some(zone) => utm(zone, [band, column, row])?,
            None => polar([band, column, row])?,
        };
        let (precision, digits) = digits_of(letters.as_str().trim_start_matches(' '))?;
        Ok(Self {
            zone: zone.unwrap_or(Zone::POLAR),
            band,
            square,
            precision,
            digits,
        })
    }
}

/// The zone of its digits, of which there may be none.
fn zone_of(digits: &str) -> Result<Option<Zone>, ParseMgrsError> {
    if digits.is_empty() {
        return Ok(None);
    }
    let number = digits
        .bytes()
        .fold(0_u8, |sum, digit| sum.saturating_mul(10).saturating_add(digit - b'0'));
    match (number, digits.len()) {
        (1..=60, 1 | 2) => Ok(Some(Zone::within(number))),
        _ => Err(ParseMgrsError::Zone(number)),
    }
}

/// A letter in upper case.
fn next_letter(letters: &mut core::str::Chars<'_>) -> Result<char, ParseMgrsError> {
    match letters.next() {
        None => Err(ParseMgrsError::Unfinished),
        Some(letter) if letter.is_ascii_alphabetic() => Ok(letter.to_ascii_uppercase()),
        Some(' ') => Err(ParseMgrsError::Unfinished),
        Some(other) => Err(ParseMgrsError::Character(other)),
    }
}

/// The precision, easting and northing of digits, with or without spaces in the middle.
fn digits_of(text: &str) -> Result<(u8, [u64; 2]), ParseMgrsError> {
    if let Some(other) = text.chars().find(|c| !c.is_ascii_digit() && *c != ' ') {
        return Err(ParseMgrsError::Character(other));
    }
    let (count, spaces) = (text.bytes().filter(u8::is_ascii_digit).count(), text.contains(' '));
    if count > 2 * usize::from(Mgrs::MAX_PRECISION) {
        return Err(ParseMgrsError::TooLong(count));
    }
    let (easting, northing) = if spaces {
        text.split_once(' ').unwrap_or((text, ""))
    } else {
        text.split_at_checked(count / 2).unwrap_or((text, ""))
    };
    let northing = northing.trim_start_matches(' ');
    if northing.contains(' ') {
        return Err(ParseMgrsError::Character(' '));
    }
    if easting.len() != northing.len() {
        return Err(ParseMgrsError::Odd(count));
    }
    let number = |digits: &str| digits.bytes().fold(0, |sum, digit| 10 * sum + u64::from(digit - b'0'));
    Ok((easting.len() as u8, [number(easting), number(northing)]))
}

/// Where a letter stands in a list.
fn place(letters: &[u8], letter: char) -> Option<u8> {
    letters.iter().position(|&l| char::from(l) == letter).map(|at| at as u8)
}

/// The band and the square of UTM's letters.
fn utm(zone: Zone, [band, column, row]: [char; 3]) -> Result<(i8, [u8; 2]), ParseMgrsError> {
    let number = zone.number();
    // C to X.
    let place_of_band = place(LETTERS, band).filter(|at| (2..22).contains(at));
    let index = place_of_band.ok_or(ParseMgrsError::Band(band))? as i8 - 12;
    let set = (number + 2) % 3;
    let easting = place(LETTERS, column)
        .filter(|at| at / 8 == set)
        .ok_or(ParseMgrsError::Column(column))?
        % 8
        + 1;
    let shift = if number % 2 == 0 { 5 } else { 0 };
    let cycle = place(LETTERS, row)
        .filter(|&at| at < ROWS)
        .ok_or(ParseMgrsError::Row(row))?;
    let cycle = (cycle + ROWS - shift) % ROWS;
    // A band is not as high as the rows' cycle: at most one row fits.
    let fits = |&northing: &u8| rows_of(index, easting).contains(&signed(index, northing));
    let northing = (0..5).map(|turns| cycle + turns * ROWS).find(fits);
    let northing = northing.ok_or(ParseMgrsError::Inconsistent(band, row))?;
    Ok((index, [easting, northing]))
}

/// The band and the square of letters of the polar regions.
fn polar([band, column, row]: [char; 3]) -> Result<(i8, [u8; 2]), ParseMgrsError> {
    let (hemisphere, east) = match band {
        'A' => (Hemisphere::South, false),
        'B' => (Hemisphere::South, true),
        'Y' => (Hemisphere::North, false),
        'Z' => (Hemisphere::North, true),
        _ => return Err(ParseMgrsError::Band(band)),
    };
    let [first, end] = polar_range(hemisphere);
    let easting = place(POLAR_COLUMNS, column).map(|at| if east { at + 20 } else { at + 2 });
    let half = if east { 20..end } else { first..20 };
    let easting = easting
        .filter(|at| half.contains(at))
        .ok_or(ParseMgrsError::Column(column))?;
    let northing = place(LETTERS, row)
        .map(|at| at + first)
        .filter(|at| *at < end)
        .ok_or(ParseMgrsError::Row(row))?;
    let index = if hemisphere == Hemisphere::North { 0 } else { -1 };
    Ok((index, [easting, northing]))
}
