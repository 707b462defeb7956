use super::boundary::range;
use super::{LatLonBox, Tile};
use crate::cube::{CubeMap, CubeProjection};
use crate::math::{max, min, sin_cos_degrees};
use crate::{LatLon, Real};

impl<T: Real> LatLonBox<T> {
    /// Returns the box of a tile: the least and the greatest latitude and longitude of its places, widened by
    /// what they are rounded.
    ///
    /// The latitudes are geodetic and in [−90, 90]. A tile that holds a pole inside has all longitudes, −180
    /// to 180; one with a pole at a corner has those of its edges. If the tile crosses ±180°, the eastern
    /// longitude is below the western one. In `f64` a place of the tile is within 3e-13° of arc of each
    /// parallel, and within 1e-12° of each meridian; in `f32` the box holds the tile, and is larger by some
    /// roundings.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Face, S2Quadratic};
    /// use terrella::terrain::{LatLonBox, Tile};
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geodetic, S2Quadratic)?;
    /// let front = LatLonBox::of_tile(&map, Tile::root(Face::Front));
    /// assert!((front.north() - 45.0).abs() < 1e-12 && (front.east() - 45.0).abs() < 1e-12);
    /// let top = LatLonBox::of_tile(&map, Tile::root(Face::Top));
    /// assert_eq!((top.north(), top.width()), (90.0, 360.0));
    /// assert!((top.south() - 35.264_389_682_754_654).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "GetRectBound")]
    #[must_use]
    pub fn of_tile<P: CubeProjection>(map: &CubeMap<T, P>, tile: Tile) -> Self {
        let (quarter, half, circle) = (T::of(90.0), T::of(180.0), T::of(360.0));
        let (projection, shifted) = (map.projection(), map.shifted());
        let rounding = T::of(2.0) * quarter * T::EPSILON;
        let lat = |place| shifted.to_lat_lon(place).lat();
        let Some([south, north]) = range(projection, tile, lat, rounding) else {
            return Self::round(-quarter, quarter);
        };
        let (south, north) = (
            max(south - rounding - rounding, -quarter),
            min(north + rounding + rounding, quarter),
        );
        // Whether a pole is inside, and not at the edge.
        let [to_north, to_south] = [quarter, -quarter].map(|lat| {
            let place = tile.place(map.project(LatLon::within(lat, T::ZERO)));
            let inside = |s: T| s > T::ZERO && s < T::ONE;
            place.is_some_and(|[s, t]| inside(s) && inside(t))
        });
        if to_north | to_south {
            let south = if to_south { -quarter } else { south };
            return Self::round(south, if to_north { quarter } else { north });
        }
        let centre = projection.unproject(tile.centre::<T>()).lon();
        let wrapped = |lon: T| {
            let turned = if lon > half { lon - circle } else { lon };
            if turned < -half { turned + circle } else { turned }
        };
        let pole = T::of(4.0) * T::EPSILON;
        let lon = |place: crate::Direction<T>| {
            let beside = wrapped(place.lon() - centre);
            if place.cos_lat() > pole {
                beside
            } else {
                T::of(f64::NAN)
            }
        };
        // The cosine of the latitude nearest to a pole, which may be at a corner.
        let (_, cos) = sin_cos_degrees(max(north, -south));
        let rounding = T::of(2.0) * half * T::EPSILON / max(cos, T::of(1e-3));
        let Some([west, east]) = range(projection, tile, lon, rounding) else {
            return Self::round(south, north);
        };
        let (west, east) = (west - rounding - rounding, east + rounding + rounding);
        let near = |lon: T| {
            let lon = wrapped(centre + lon);
            let far = half - lon.abs() <= T::of(4.0) * rounding;
            (lon, far)
        };
        let ((first, at_first), (last, at_last)) = (near(west), near(east));
        let west = if at_first { -half } else { first };
        let east = if at_last { half } else { last };
        Self::new(south, west, north, east).unwrap_or(Self::round(south, north))
    }
}
