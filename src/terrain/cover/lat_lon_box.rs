use core::fmt;

use super::boundary::{Margin, are_common, relation};
use super::{Region, Relation, Tile};
use crate::cube::{CubeMap, CubeProjection};
use crate::math::{max, min, sin_cos_degrees};
use crate::{Direction, InvalidLatLon, LatLon, Real};

/// The places between two parallels and between two meridians: from a western one eastward to an eastern one.
///
/// It may cross ±180°, hold a pole, or be a line or a point. As a [`Region`], its latitudes are geodetic, as
/// those of a [`CubeMap`] are.
///
/// A tile meets the box exactly if they have a place in common, to within 8 ulp of 1 radian: 11 nm on the
/// Earth in `f64`, 6 m in `f32`. So a tile that touches the box with an edge or a corner meets it.
///
/// ```
/// use terrella::cube::{CubeMap, S2Quadratic};
/// use terrella::terrain::{Covering, Hilbert, Key, LatLonBox};
/// use terrella::{Ellipsoid, LatLon, Shift};
///
/// let around = LatLonBox::new(36.9999, 126.9999, 37.0001, 127.0001)?;
/// assert!(around.contains(LatLon::new(37.0, 127.0)?));
/// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geodetic, S2Quadratic)?;
/// let mut keys: Vec<Key<Hilbert>> = Covering::new(map, around, 20)?.map(Key::from).collect();
/// keys.sort();
/// assert_eq!((keys.len(), keys[0].to_string().as_str()), (13, "357b3cd6f85"));
///
/// // Eastward from Fiji to Samoa, across ±180°.
/// let islands = LatLonBox::new(-20.0, 177.0, -13.0, -171.0)?;
/// assert_eq!(islands.width(), 12.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "bounding box")]
#[doc(alias = "S2LatLngRect")]
#[doc(alias = "bbox")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LatLonBox<T = f64> {
    south: T,
    west: T,
    north: T,
    east: T,
    /// From west to east, 0 to 360.
    width: T,
}

impl<T: Real> LatLonBox<T> {
    /// Creates the box between two latitudes and from a western longitude eastward to an eastern one, in
    /// degrees.
    ///
    /// Longitudes outside [−180, 180] are brought into it. If `east` is 360° or more above `west`, the box
    /// goes round the whole circle; from 180 to −180 it is a line.
    ///
    /// # Errors
    /// [`InvalidBox`] if a latitude is outside [−90, 90], a longitude is not finite, or `south` is above
    /// `north`; each for NaN too.
    pub fn new(south: T, west: T, north: T, east: T) -> Result<Self, InvalidBox<T>> {
        let corner = LatLon::new(south, west).map_err(InvalidBox::Corner)?;
        let other = LatLon::new(north, east).map_err(InvalidBox::Corner)?;
        if south > north {
            return Err(InvalidBox::Order { south, north });
        }
        let circle = T::of(360.0);
        if east - west >= circle {
            return Ok(Self::round(south, north));
        }
        let turn = other.lon() - corner.lon();
        Ok(Self {
            south,
            west: corner.lon(),
            north,
            east: other.lon(),
            width: if turn < T::ZERO { turn + circle } else { turn },
        })
    }

    /// The box between two latitudes round the whole circle.
    pub(super) fn round(south: T, north: T) -> Self {
        Self {
            south,
            west: T::of(-180.0),
            north,
            east: T::of(180.0),
            width: T::of(360.0),
        }
    }

    /// Returns the southern latitude, in degrees.
    #[must_use]
    pub const fn south(&self) -> T {
        self.south
    }

    /// Returns the western longitude, in degrees, in [−180, 180].
    #[must_use]
    pub const fn west(&self) -> T {
        self.west
    }

    /// Returns the northern latitude, in degrees.
    #[must_use]
    pub const fn north(&self) -> T {
        self.north
    }

    /// Returns the eastern longitude, in degrees, in [−180, 180]. It is below the western one if the box
    /// crosses ±180°.
    #[must_use]
    pub const fn east(&self) -> T {
        self.east
    }

    /// Returns the degrees of longitude from west to east, 0 to 360.
    #[must_use]
    pub const fn width(&self) -> T {
        self.width
    }

    /// Returns whether a place is in the box or on its edge. A pole is in it by its latitude alone.
    #[must_use]
    pub fn contains(&self, place: LatLon<T>) -> bool {
        let (lat, lon) = (place.lat(), place.lon());
        let circle = T::of(360.0);
        let between = (lat >= self.south) & (lat <= self.north);
        let round = self.width == circle || lat.abs() == T::of(90.0);
        let eastward = if self.west <= self.east {
            (lon >= self.west) & (lon <= self.east)
        } else {
            (lon >= self.west) | (lon <= self.east)
        };
        let limit = T::of(180.0);
        // 180° and −180° are one meridian.
        let at_limit = lon.abs() == limit && (self.west.abs() == limit || self.east.abs() == limit);
        between & (round | eastward | at_limit)
    }

    /// The longitude in the middle.
    fn middle(&self) -> T {
        self.west + T::of(0.5) * self.width
    }
}

impl<T: Real> Region<T> for LatLonBox<T> {
    fn relation<P: CubeProjection>(&self, map: &CubeMap<T, P>, tile: Tile) -> Relation {
        let margin = Sides::new(self, map);
        let half = T::of(0.5);
        let (lat, lon) = (half * (self.south + self.north), self.middle());
        let turned = if lon > T::ZERO {
            lon - T::of(180.0)
        } else {
            lon + T::of(180.0)
        };
        let lon = if lon > T::of(180.0) { lon - T::of(360.0) } else { lon };
        let pole = |lat: f64| LatLon::within(T::of(lat), T::ZERO);
        let opposite = LatLon::within(lat, turned);
        let outside = [pole(90.0), pole(-90.0), opposite];
        relation(map, tile, &margin, [&[LatLon::within(lat, lon)], &outside])
    }
}

/// The four sides of a box, and the half of the sphere about its middle, as functions on the sphere.
struct Sides<T> {
    south: (T, T),
    north: (T, T),
    west: (T, T),
    east: (T, T),
    middle: (T, T),
    width: T,
}

impl<T: Real> Sides<T> {
    fn new<P: CubeProjection>(of: &LatLonBox<T>, map: &CubeMap<T, P>) -> Self {
        let shifted = map.shifted();
        Self {
            south: shifted.latitude(of.south),
            north: shifted.latitude(of.north),
            west: sin_cos_degrees(of.west),
            east: sin_cos_degrees(of.east),
            middle: sin_cos_degrees(of.middle()),
            width: of.width,
        }
    }
}

impl<T: Real> Margin<T, 5> for Sides<T> {
    /// The sines of the angles to the parallels, and the distances from the planes of the meridians.
    #[inline(always)]
    fn numbers(&self, place: Direction<T>) -> [T; 5] {
        let [x, y, z] = place.to_array();
        let axial = (x * x + y * y).sqrt();
        let ((south, at_south), (north, at_north)) = (self.south, self.north);
        let ((west, at_west), (east, at_east)) = (self.west, self.east);
        let (middle, at_middle) = self.middle;
        [
            z * at_south - axial * south,
            axial * north - z * at_north,
            y * at_west - x * west,
            x * east - y * at_east,
            x * at_middle + y * middle,
        ]
    }

    #[inline(always)]
    fn depth(&self, [south, north, west, east, middle]: [T; 5]) -> T {
        let between = min(south, north);
        if self.width >= T::of(360.0) {
            return between;
        }
        if self.width > T::of(180.0) {
            return min(between, max(west, east));
        }
        min(between, min(middle, min(west, east)))
    }

    #[inline(always)]
    fn may_enter(&self, ends: [[T; 5]; 2], bends: [T; 5]) -> bool {
        let [south, north, west, east, middle] = lines(ends, bends, self.rounding());
        if self.width >= T::of(360.0) {
            return are_common([south, north]);
        }
        if self.width > T::of(180.0) {
            return are_common([south, north, west]) || are_common([south, north, east]);
        }
        are_common([south, north, west, east, middle])
    }

    #[inline(always)]
    fn may_leave(&self, [from, to]: [[T; 5]; 2], bends: [T; 5]) -> bool {
        // Negative numbers are outside; so are the places where they are, the other way round, positive. Twice
        // the rounding is allowed, as edges of tiles are often those of the box.
        let ends = [from, to].map(|end| end.map(|number| -number));
        let [south, north, west, east, middle] = lines(ends, bends, -self.rounding() - self.rounding());
        let any = |line| are_common([line]);
        let beyond = any(south) || any(north);
        if self.width >= T::of(360.0) {
            return beyond;
        }
        if self.width > T::of(180.0) {
            return beyond || are_common([west, east]);
        }
        beyond || any(west) || any(east) || any(middle)
    }

    fn rounding(&self) -> T {
        T::of(8.0) * T::EPSILON
    }
}

/// Of each function the straight line between two places, raised by its bend and a rounding.
#[inline(always)]
fn lines<T: Real>([from, to]: [[T; 5]; 2], bends: [T; 5], rounding: T) -> [[T; 2]; 5] {
    let mut lines = [[T::ZERO; 2]; 5];
    for (line, ((from, to), bend)) in lines.iter_mut().zip(from.into_iter().zip(to).zip(bends)) {
        *line = [from, to].map(|end| end + bend + rounding);
    }
    lines
}

/// The error of creating a [`LatLonBox`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidBox<T> {
    /// A corner has no such latitude or longitude.
    Corner(InvalidLatLon<T>),
    /// The southern latitude is above the northern one.
    Order {
        /// The southern latitude.
        south: T,
        /// The northern latitude.
        north: T,
    },
}

impl<T: fmt::Debug> fmt::Display for InvalidBox<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Corner(corner) => corner.fmt(f),
            Self::Order { south, north } => {
                write!(
                    f,
                    "the southern latitude {south:?} is above the northern one, {north:?}"
                )
            }
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidBox<T> {}
