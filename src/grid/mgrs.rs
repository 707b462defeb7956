use core::fmt;

use super::utm::{FALSE_NORTHING, band_in};
use super::{GridPosition, Hemisphere, MgrsText, OutsideMgrs, UtmUps, Zone};
use crate::{LatLon, Real};

/// A square of the Military Grid Reference System, as text such as `33XVG7459643593` names it.
///
/// The precision is the number of digits for each direction, 0 to 11: with 0 the square is 100 km wide, with 5
/// one metre, with 11 a micrometre.
///
/// * [`of`](Self::of) gives the square that contains a place, [`new`](Self::new) that of a position in a zone
///   that need not be the place's own.
/// * [`centre`](Self::centre) and [`south_west`](Self::south_west) give positions, and
///   [`UtmUps::inverse`] their places.
/// * [`text`](Self::text) and [`Display`](core::fmt::Display) write it, without allocation;
///   [`str::parse`] reads it.
///
/// Digits are cut, never rounded. They are those of the position in the scalar: `f32` has eastings to 0.03 m and
/// northings to 0.5 m. A position that is the scalar nearest to a multiple of the digits' unit counts as that
/// multiple. So the corner of a square is in that square.
///
/// Letters are those of WGS 84, for every ellipsoid. Limits, those of GeographicLib's `MGRS`: eastings 100 000
/// to 900 000 m; northings up to 9 500 000 m in the north, from 1 000 000 m in the south; in UPS 1 300 000 to
/// 2 700 000 m in the north, 800 000 to 3 200 000 m in the south. A position on the upper limit belongs to the
/// last square: so does the equator, if it is given in the south.
///
/// NGA.STND.0037, *Universal Grids and Grid Reference Systems* (2014), chapters 10 to 12.
///
/// ```
/// use terrella::grid::{Mgrs, UtmUps};
/// use terrella::{Ellipsoid, LatLon};
/// let grid = UtmUps::new(Ellipsoid::<f64>::WGS84)?;
/// let honolulu = LatLon::new(21.3088, -157.8261)?;
/// let square = Mgrs::of(&grid, honolulu, 4)?;
/// assert_eq!(square.to_string(), "04QFJ21755677");
/// let same: Mgrs = "4Q FJ 2175 5677".parse()?;
/// assert_eq!(same, square);
/// let place = grid.inverse(same.centre())?;
/// assert!((place.lat() - 21.3088).abs() < 1e-4);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "USNG")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mgrs {
    pub(super) zone: Zone,
    /// −10 to 9 in UTM; −1 and 0 in UPS.
    pub(super) band: i8,
    /// Of the square of 100 km: easting and northing in such units, with false origins.
    pub(super) square: [u8; 2],
    pub(super) precision: u8,
    /// Easting and northing in the square, in units of the precision.
    pub(super) digits: [u64; 2],
}

/// Metres across a square of two letters.
const SQUARE: u64 = 100_000;

impl Mgrs {
    /// The largest number of digits for each direction: micrometres.
    pub const MAX_PRECISION: u8 = 11;

    /// Returns the square that contains a place, in the place's own zone.
    ///
    /// # Errors
    /// [`OutsideMgrs::Precision`] if the precision is above 11. Nothing else on ellipsoids like the Earth's.
    pub fn of<T: Real>(grid: &UtmUps<T>, place: LatLon<T>, precision: u8) -> Result<Self, OutsideMgrs<T>> {
        let position = grid.forward(place).map_err(OutsideMgrs::Grid)?;
        Self::new(position, place.lat(), precision)
    }

    /// Returns the square that contains a position, of which the latitude is known: its band of eight degrees
    /// is part of the text.
    ///
    /// # Errors
    /// [`OutsideMgrs`] if easting or northing is outside the limits, the latitude's band is not that of the
    /// northing, or the precision is above 11.
    pub fn new<T: Real>(position: GridPosition<T>, lat: T, precision: u8) -> Result<Self, OutsideMgrs<T>> {
        if precision > Self::MAX_PRECISION {
            return Err(OutsideMgrs::Precision(precision));
        }
        let GridPosition {
            zone, mut hemisphere, ..
        } = position;
        let (easting, mut northing) = (position.easting, position.northing);
        let ranges = if zone == Zone::POLAR {
            let range = polar_range(hemisphere);
            [range, range]
        } else {
            let equator = T::of(FALSE_NORTHING);
            if hemisphere == Hemisphere::North && northing < T::ZERO {
                (hemisphere, northing) = (Hemisphere::South, northing + equator);
            }
            if hemisphere == Hemisphere::South && northing > equator {
                (hemisphere, northing) = (Hemisphere::North, northing - equator);
            }
            match hemisphere {
                Hemisphere::North => [[1, 9], [0, 95]],
                Hemisphere::South => [[1, 9], [10, 100]],
            }
        };
        let [east, north] = ranges;
        let (column, easting) = cut(easting, east, precision).ok_or(OutsideMgrs::Easting(easting))?;
        let (row, northing) = cut(northing, north, precision).ok_or(OutsideMgrs::Northing(northing))?;
        let band = match (zone, hemisphere) {
            (Zone::POLAR, Hemisphere::North) => 0,
            (Zone::POLAR, Hemisphere::South) => -1,
            _ => band_in(hemisphere, lat),
        };
        let square = [column, row];
        if zone != Zone::POLAR && !rows_of(band, column).contains(&signed(band, row)) {
            return Err(OutsideMgrs::Latitude(lat));
        }
        Ok(Self {
            zone,
            band,
            square,
            precision,
            digits: [easting, northing],
        })
    }

    /// Returns the zone.
    #[must_use]
    pub const fn zone(self) -> Zone {
        self.zone
    }

    /// Returns the hemisphere that [`centre`](Self::centre) and [`south_west`](Self::south_west) are counted in.
    #[must_use]
    pub const fn hemisphere(self) -> Hemisphere {
        if self.band < 0 {
            Hemisphere::South
        } else {
            Hemisphere::North
        }
    }

    /// Returns the number of digits for each direction, 0 to 11.
    #[must_use]
    pub const fn precision(self) -> u8 {
        self.precision
    }

    /// Returns the square of less precision that this one is in; itself if the precision is not smaller.
    ///
    /// ```
    /// use terrella::grid::Mgrs;
    /// let metre: Mgrs = "33XVG7459643593".parse()?;
    /// assert_eq!(metre.coarser(2).to_string(), "33XVG7443");
    /// # Ok::<(), terrella::grid::ParseMgrsError>(())
    /// ```
    #[must_use]
    pub const fn coarser(self, precision: u8) -> Self {
        if precision >= self.precision {
            return self;
        }
        let [east, north] = self.digits;
        let unit = power(self.precision - precision);
        Self {
            precision,
            digits: [east / unit, north / unit],
            ..self
        }
    }

    /// Returns the width of the square in metres.
    #[must_use]
    pub fn width<T: Real>(self) -> T {
        T::whole(SQUARE) / T::whole(power(self.precision))
    }

    /// Returns the position of the square's south-western corner. In UPS this is the corner of least easting and
    /// northing.
    #[must_use]
    pub fn south_west<T: Real>(self) -> GridPosition<T> {
        self.position(0)
    }

    /// Returns the position of the square's centre.
    #[must_use]
    pub fn centre<T: Real>(self) -> GridPosition<T> {
        self.position(1)
    }

    /// The position of the corner, and half a square beyond or not.
    fn position<T: Real>(self, half: u64) -> GridPosition<T> {
        let ([column, row], [east, north]) = (self.square, self.digits);
        let metres = |square: u8, digits: u64| metres(square, 2 * digits + half, 2 * power(self.precision));
        GridPosition::new(self.zone, self.hemisphere(), metres(column, east), metres(row, north))
    }

    /// Returns the text. It has no spaces: `33XVG7459643593`.
    #[must_use]
    pub fn text(self) -> MgrsText {
        MgrsText::of(self)
    }
}

/// Writes the text, without spaces. Zones have two digits, as GEOTRANS and GeographicLib write them.
impl fmt::Display for Mgrs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.text().as_str())
    }
}

/// 10ⁿ, n ≤ 11. Never 0, as the compiler can see: so no division checks for it.
#[allow(clippy::indexing_slicing)] // the index is bounded
pub(super) const fn power(n: u8) -> u64 {
    const POWERS: [u64; 16] = {
        let mut powers = [1; 16];
        let mut n = 1;
        while n < powers.len() {
            powers[n] = 10 * powers[n - 1];
            n += 1;
        }
        powers
    };
    let power = POWERS[(n & 15) as usize];
    if power == 0 { 1 } else { power }
}

/// The squares of 100 km of UPS, from the first to that after the last, in either direction.
pub(super) const fn polar_range(hemisphere: Hemisphere) -> [u8; 2] {
    match hemisphere {
        Hemisphere::North => [13, 27],
        Hemisphere::South => [8, 32],
    }
}

/// So many parts of 100 km from the border of a square, in metres.
fn metres<T: Real>(square: u8, digits: u64, parts: u64) -> T {
    let parts = parts.max(1);
    // Whole metres apart, which are exact.
    let scaled = |number: u64| {
        let whole = number * SQUARE;
        (whole / parts, whole % parts)
    };
    if parts <= SQUARE {
        let (whole, rest) = scaled(digits);
        return T::whole(u64::from(square) * SQUARE + whole) + T::whole(rest) / T::whole(parts);
    }
    let unit = parts / SQUARE;
    T::whole(u64::from(square) * SQUARE + digits / unit) + T::whole(digits % unit) / T::whole(unit)
}

/// The square of 100 km that a number of metres is in, and its digits there, if it is in the range of squares.
fn cut<T: Real>(number: T, [from, to]: [u8; 2], precision: u8) -> Option<(u8, u64)> {
    let edge = |square: u8| T::whole(u64::from(square) * SQUARE);
    let inside = number >= edge(from) && number <= edge(to);
    if !inside {
        return None;
    }
    if number == edge(to) {
        return Some((to - 1, power(precision) - 1));
    }
    let whole = u64::from(number.floor().unsigned_abs());
    let (square, within) = ((whole / SQUARE) as u8, whole % SQUARE);
    if precision <= 5 {
        return Some((square, within / power(5 - precision)));
    }
    let unit = power(precision - 5);
    let rest = (number - T::whole(whole)) * T::whole(unit);
    // Less than a unit, whatever the rounding.
    let least = u64::from(rest.floor().unsigned_abs()).min(unit - 1);
    let digits = within * unit + least;
    let next: T = metres(square, digits + 1, power(precision));
    Some((square, digits + u64::from(next == number && least + 1 < unit)))
}

/// The row counted from the equator, negative in the south.
pub(super) const fn signed(band: i8, row: u8) -> i8 {
    let row = row as i8;
    if band < 0 { row - 100 } else { row }
}

/// The rows, counted from the equator, whose square in a column reaches into a band: those that the band's text
/// may have. The last ones go on to the limits.
pub(super) fn rows_of(band: i8, column: u8) -> core::ops::RangeInclusive<i8> {
    // Southern bands are mirror images of northern ones.
    let mirrored = if band < 0 { -1 - band } else { band };
    let first = borders(mirrored, column).0;
    let last = match band {
        9 => 94,
        -10 => 89,
        _ => borders(mirrored + 1, column).1,
    };
    if band < 0 { -1 - last..=-1 - first } else { first..=last }
}

/// The rows of the squares in a column that the parallel at the foot of a northern band runs through: the lowest,
/// where it starts near the central meridian, and the highest.
fn borders(band: i8, column: u8) -> (i8, i8) {
    // The northing of 8°, 16° … 72° on the central meridian in 100 km. Away from it a parallel bends to the north:
    // those of 64° and 72° into the next square.
    let rows = [-1, 8, 17, 26, 35, 44, 53, 62, 70, 79];
    let row = rows.get(band as usize).copied().unwrap_or(0);
    // Squares between the central meridian and this one, 0 to 3.
    let beyond = if column < 5 { 4 - column } else { column - 5 };
    match (band, beyond) {
        (0, _) => (0, -1),
        (8, 0) => (row, row),
        (8, 1) => (row, row + 1),
        (8, _) => (row + 1, row + 1),
        (9, 2) => (row, row + 1),
        (9, 3..) => (row + 1, row + 1),
        _ => (row, row),
    }
}
