//! Web Mercator (EPSG:3857): the plane and the tiles of web maps.
//!
//! The sphere's formula of Mercator is applied to geodetic latitudes, with the radius 6 378 137 m. So the map
//! is not conformal: on WGS 84, it stretches what is small by up to 0.67 % more to the north than to the east
//! (at the equator, none at the poles), which turns directions by up to 0.19°. And its y is up to 43 km
//! larger than that of Mercator on the ellipsoid (EPSG:3395).
//!
//! The tile of zoom z, column x and row y is a square of the plane between −π and π times the radius: 2ᶻ
//! columns from −180° to the east and 2ᶻ rows from [`LATITUDE_LIMIT`] to the south.
//!
//! ```
//! use terrella::LatLon;
//! use terrella::grid::web_mercator::{self, Tile};
//! let berlin = LatLon::new(52.516_27_f64, 13.377_70)?;
//! let tile = Tile::containing(berlin, 14)?;
//! assert_eq!(tile.to_string(), "14/8800/5373");
//! assert_eq!(tile.quadkey().to_string(), "12021023322202");
//! let [x, y] = web_mercator::to_plane(berlin);
//! assert!((x - 1_489_198.752).abs() < 1e-3 && (y - 6_894_017.444).abs() < 1e-3);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

use core::fmt;
use core::str::FromStr;

use super::OutsideMap;
use super::halves::{eastern, part};
use crate::math::{gudermannian, inverse_gudermannian, sin_cos_degrees};
use crate::{LatLon, Real};

/// The latitude in degrees up to which there are tiles, atan sinh π: to the north and to the south.
pub const LATITUDE_LIMIT: f64 = 85.051_128_779_806_59;

/// The radius of the sphere in metres.
const RADIUS: f64 = 6_378_137.0;

/// Pixels along a side of a tile.
const PIXELS: f64 = 256.0;

/// Returns x to the east and y to the north in metres (EPSG:3857); y is infinite at a pole.
///
/// The worst error is 1.5·10⁻⁸ m for tiles' places (`f32`: 4 m).
#[must_use]
pub fn to_plane<T: Real>(place: LatLon<T>) -> [T; 2] {
    let radians = T::of(core::f64::consts::PI / 180.0);
    [
        place.lon() * radians * T::of(RADIUS),
        isometric(place.lat()) * T::of(RADIUS),
    ]
}

/// Returns the place at x to the east and y to the north in metres (EPSG:3857). x goes round the Earth any
/// number of times.
///
/// The worst error is 3·10⁻⁹ m on the ground (`f32`: 1.5 m).
///
/// # Errors
/// [`OutsideMap`] if x is infinite or NaN, or y NaN.
pub fn from_plane<T: Real>([x, y]: [T; 2]) -> Result<LatLon<T>, OutsideMap<T>> {
    let degrees = T::of(180.0 / core::f64::consts::PI);
    let lat = gudermannian(y / T::of(RADIUS)) * degrees;
    LatLon::new(lat, x / T::of(RADIUS) * degrees).map_err(|_| OutsideMap { x, y })
}

/// ψ of a latitude in degrees, on the sphere.
fn isometric<T: Real>(lat: T) -> T {
    inverse_gudermannian(sin_cos_degrees(lat))
}

/// Returns the metres on the equator of the sphere that a pixel of 256 × 256 of a zoom's tiles shows, times
/// the cosine of the latitude: what a map's scale bar shows there, up to 0.7 % on the ellipsoid.
#[must_use]
pub fn resolution<T: Real>(zoom: u8, lat: T) -> T {
    let (_, cos) = sin_cos_degrees(lat);
    let across = T::of(2.0 * core::f64::consts::PI * RADIUS / PIXELS);
    (0..zoom.min(Tile::MAX_ZOOM)).fold(across * cos, |size, _| size * T::of(0.5))
}

/// A tile of web maps: zoom, column from the west, row from the north.
///
/// Its text is `zoom/x/y`; [`quadkey`](Self::quadkey) writes Bing's.
#[doc(alias("XYZ", "slippy map", "zxy"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tile {
    zoom: u8,
    x: u32,
    y: u32,
}

impl Tile {
    /// The largest zoom: tiles of 37 mm.
    pub const MAX_ZOOM: u8 = 30;

    /// Makes the tile of a zoom, a column and a row.
    ///
    /// # Errors
    /// [`InvalidTile`] unless the zoom is at most 30, and x and y below 2 to its power.
    pub fn new(zoom: u8, x: u32, y: u32) -> Result<Self, InvalidTile> {
        if zoom <= Self::MAX_ZOOM && (x | y) >> zoom == 0 {
            Ok(Self { zoom, x, y })
        } else {
            Err(InvalidTile { zoom, x, y })
        }
    }

    /// Returns the tile that contains a place. A zoom above 30 counts as 30.
    ///
    /// Columns are exact: a boundary belongs to the tile east of it, and longitude 180 is −180. Rows are
    /// those of [`to_plane`], with its error.
    ///
    /// # Errors
    /// [`BeyondTiles`] if the latitude is beyond [`LATITUDE_LIMIT`].
    pub fn containing<T: Real>(place: LatLon<T>, zoom: u8) -> Result<Self, BeyondTiles<T>> {
        let lat = place.lat();
        if lat.abs() > T::of(LATITUDE_LIMIT) {
            return Err(BeyondTiles(lat));
        }
        let zoom = zoom.min(Self::MAX_ZOOM);
        let half = 0.5 / core::f64::consts::PI;
        let down = T::of(0.5) - isometric(lat) * T::of(half);
        let rows = T::whole(1 << zoom);
        let last = (1_u32 << zoom) - 1;
        let y = (down * rows).floor().max(0).unsigned_abs().min(last);
        Ok(Self {
            zoom,
            x: part(eastern(place.lon()), 180, zoom),
            y,
        })
    }

    /// Returns the zoom.
    #[must_use]
    pub const fn zoom(self) -> u8 {
        self.zoom
    }

    /// Returns the column, counted from −180°.
    #[must_use]
    pub const fn x(self) -> u32 {
        self.x
    }

    /// Returns the row, counted from the north.
    #[must_use]
    pub const fn y(self) -> u32 {
        self.y
    }

    /// Returns south, west, north and east of the tile in degrees.
    #[must_use]
    pub fn bounds<T: Real>(self) -> [T; 4] {
        let Self { zoom, x, y } = self;
        [
            self.latitude(y + 1),
            super::halves::boundary(x.into(), 180, zoom),
            self.latitude(y),
            super::halves::boundary(i64::from(x) + 1, 180, zoom),
        ]
    }

    /// The latitude north of a row.
    fn latitude<T: Real>(self, row: u32) -> T {
        let rows = 1_i64 << self.zoom;
        let up = rows - 2 * i64::from(row);
        let psi = T::whole(up.unsigned_abs()) * T::of(core::f64::consts::PI) / T::whole(rows.unsigned_abs());
        let lat = gudermannian(psi) * T::of(180.0 / core::f64::consts::PI);
        if up < 0 { -lat } else { lat }
    }

    /// Returns the tile of the zoom before around this one; none of the whole map.
    #[must_use]
    pub fn parent(self) -> Option<Self> {
        let zoom = self.zoom.checked_sub(1)?;
        Some(Self {
            zoom,
            x: self.x >> 1,
            y: self.y >> 1,
        })
    }

    /// Returns the four tiles of the next zoom inside, north-west, north-east, south-west, south-east; none
    /// at the largest zoom.
    #[must_use]
    pub fn children(self) -> Option<[Self; 4]> {
        let zoom = (self.zoom < Self::MAX_ZOOM).then_some(self.zoom + 1)?;
        let child = |east: u32, south: u32| Self {
            zoom,
            x: self.x << 1 | east,
            y: self.y << 1 | south,
        };
        Some([child(0, 0), child(1, 0), child(0, 1), child(1, 1)])
    }

    /// Returns the quadkey: a digit 0 to 3 for each zoom, 1 for the east and 2 for the south.
    ///
    /// The whole map's is empty.
    #[must_use]
    pub const fn quadkey(self) -> Quadkey {
        Quadkey(self)
    }
}

/// The text of a [`Tile`] as digits 0 to 3, from [`Tile::quadkey`]. It parses, and its field is the tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Quadkey(pub Tile);

impl fmt::Display for Quadkey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Tile { zoom, x, y } = self.0;
        let mut text = [0; Tile::MAX_ZOOM as usize];
        for (bit, slot) in (0..zoom).rev().zip(&mut text) {
            *slot = b'0' + ((y >> bit & 1) << 1 | (x >> bit & 1)) as u8;
        }
        f.pad(core::str::from_utf8(text.get(..zoom.into()).unwrap_or_default()).unwrap_or_default())
    }
}

impl FromStr for Quadkey {
    type Err = ParseTileError;

    /// Parses up to 30 digits.
    ///
    /// # Errors
    /// [`ParseTileError`] with the character that is none of 0 to 3, or one too many.
    fn from_str(text: &str) -> Result<Self, ParseTileError> {
        let mut tile = Tile { zoom: 0, x: 0, y: 0 };
        for (at, found) in text.char_indices() {
            let digit = found.to_digit(4).filter(|_| tile.zoom < Tile::MAX_ZOOM);
            let digit = digit.ok_or(ParseTileError::Unexpected { at, found: Some(found) })?;
            tile = Tile {
                zoom: tile.zoom + 1,
                x: tile.x << 1 | digit & 1,
                y: tile.y << 1 | digit >> 1,
            };
        }
        Ok(Self(tile))
    }
}

impl fmt::Display for Tile {
    /// Writes `zoom/x/y`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { zoom, x, y } = self;
        write!(f, "{zoom}/{x}/{y}")
    }
}

impl FromStr for Tile {
    type Err = ParseTileError;

    /// Parses `zoom/x/y`: three numbers of digits alone.
    ///
    /// # Errors
    /// [`ParseTileError`] with what is wrong.
    fn from_str(text: &str) -> Result<Self, ParseTileError> {
        let mut numbers = [0_u32; 3];
        let mut at = 0;
        for (index, slot) in numbers.iter_mut().enumerate() {
            let rest = text.get(at..).unwrap_or_default();
            let length = rest.bytes().take_while(u8::is_ascii_digit).count();
            let unexpected = |at: usize| ParseTileError::Unexpected {
                at,
                found: text.get(at..).and_then(|rest| rest.chars().next()),
            };
            let number = rest.get(..length).and_then(|digits| digits.parse().ok());
            *slot = number.ok_or(unexpected(at))?;
            at += length;
            let next = text.get(at..).and_then(|rest| rest.chars().next());
            if next != (index < 2).then_some('/') {
                return Err(unexpected(at));
            }
            at += 1;
        }
        let [zoom, x, y] = numbers;
        let invalid = InvalidTile {
            zoom: u8::try_from(zoom).unwrap_or(u8::MAX),
            x,
            y,
        };
        Self::new(invalid.zoom, x, y).map_err(ParseTileError::Invalid)
    }
}

/// The error for a tile that there is not.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidTile {
    /// The zoom, at most 30 of a tile.
    pub zoom: u8,
    /// The column, below 2 to the power of the zoom.
    pub x: u32,
    /// The row, below 2 to the power of the zoom.
    pub y: u32,
}

impl fmt::Display for InvalidTile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { zoom, x, y } = self;
        write!(f, "there is no tile in column {x} and row {y} of zoom {zoom}")
    }
}

impl core::error::Error for InvalidTile {}

/// Why a text is no [`Tile`] or [`Quadkey`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum ParseTileError {
    /// A character that is not expected there, a number that is too large, or the end of the text.
    Unexpected {
        /// The byte at which it begins.
        at: usize,
        /// The character; `None` at the end of the text.
        found: Option<char>,
    },
    /// There is no such tile.
    Invalid(InvalidTile),
}

impl fmt::Display for ParseTileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unexpected { at, found: Some(found) } => write!(f, "expected a tile, got {found:?} at byte {at}"),
            Self::Unexpected { at, found: None } => write!(f, "expected a tile, got the end of the text at byte {at}"),
            Self::Invalid(why) => why.fmt(f),
        }
    }
}

impl core::error::Error for ParseTileError {}

/// The error for a latitude in degrees beyond the tiles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct BeyondTiles<T>(pub T);

impl<T: fmt::Debug> fmt::Display for BeyondTiles<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "latitude {:?} is beyond the tiles, which end at {LATITUDE_LIMIT}",
            self.0
        )
    }
}

impl<T: fmt::Debug> core::error::Error for BeyondTiles<T> {}
