use super::boundary::{Margin, relation};
use super::{InvalidRadius, Region, Relation, Tile};
use crate::cube::{CubeMap, CubeProjection};
use crate::math::{max, min};
use crate::{Direction, LatLon, Real, Shifted};

/// The places up to a distance from something, by a function that returns the distance of a place: a polyline
/// with a width, several caps, a polygon and its surroundings.
///
/// The function returns metres, and its slope is nowhere above 1, as a distance's. For a polygon it may be
/// negative inside: its least distance from an edge. NaN stands for a place that may be near or not.
///
/// `inside` has a place in each separate part of the region, and `outside` a place in each separate part of
/// the rest, such as the holes. They are needed only for parts that are smaller than a tile.
///
/// ```
/// use terrella::cube::{CubeMap, S2Quadratic};
/// use terrella::geodesic::{Geodesic, Karney};
/// use terrella::terrain::{Covering, Near};
/// use terrella::{Ellipsoid, LatLon, Shift};
///
/// let earth = Ellipsoid::<f64>::WGS84;
/// let karney = Karney::new(earth)?;
/// let towns = [LatLon::new(59.91, 10.75)?, LatLon::new(60.39, 5.32)?, LatLon::new(63.43, 10.40)?];
/// let to_town = |place| {
///     let distances = towns.iter().filter_map(|&town| karney.distance(town, place).ok());
///     distances.fold(f64::INFINITY, f64::min)
/// };
/// let near = Near::new(to_town, 20_000.0, &towns, &[])?;
/// let map = CubeMap::new(earth, Shift::Geodetic, S2Quadratic)?;
/// assert_eq!(Covering::new(map, near, 8)?.count(), 12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// A polyline with a width, and a polygon with geodesic edges:
///
/// ```
/// use terrella::cube::{CubeMap, S2Quadratic};
/// use terrella::geodesic::Karney;
/// use terrella::route::{Fence, Legs};
/// use terrella::terrain::{Covering, Near};
/// use terrella::{Ellipsoid, LatLon, Shift};
///
/// let earth = Ellipsoid::<f64>::WGS84;
/// let karney = Karney::new(earth)?;
/// let map = CubeMap::new(earth, Shift::Geodetic, S2Quadratic)?;
/// let corners = [LatLon::new(59.91, 10.75)?, LatLon::new(60.39, 5.32)?, LatLon::new(63.43, 10.40)?];
/// let to_path = |place| karney.closest_of_path(place, corners).map_or(f64::NAN, |found| found.closest.distance);
/// let corridor = Near::new(to_path, 5_000.0, &corners, &[])?;
/// let rings = [corners.as_slice()];
/// let fence = Fence::new(&karney, &rings);
/// let polygon = Near::new(|place| fence.distance(place), 0.0, &corners, &[])?;
/// assert_eq!(Covering::new(map, corridor, 8)?.count(), 30);
/// assert_eq!(Covering::new(map, polygon, 8)?.inner().count(), 27);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "buffer")]
#[doc(alias = "corridor")]
#[derive(Clone, Copy, Debug)]
pub struct Near<'a, T, D> {
    distance: D,
    radius: T,
    inside: &'a [LatLon<T>],
    outside: &'a [LatLon<T>],
}

impl<'a, T: Real, D: Fn(LatLon<T>) -> T> Near<'a, T, D> {
    /// Creates the region of the places whose distance is at most a radius in metres.
    ///
    /// # Errors
    /// [`InvalidRadius`] if the radius is negative or NaN.
    pub fn new(
        distance: D,
        radius: T,
        inside: &'a [LatLon<T>],
        outside: &'a [LatLon<T>],
    ) -> Result<Self, InvalidRadius<T>> {
        if radius >= T::ZERO {
            Ok(Self {
                distance,
                radius,
                inside,
                outside,
            })
        } else {
            Err(InvalidRadius(radius))
        }
    }
}

impl<T: Real, D: Fn(LatLon<T>) -> T> Region<T> for Near<'_, T, D> {
    fn relation<P: CubeProjection>(&self, map: &CubeMap<T, P>, tile: Tile) -> Relation {
        let margin = Within {
            shifted: map.shifted(),
            distance: &self.distance,
            radius: self.radius,
        };
        relation(map, tile, &margin, [self.inside, self.outside])
    }
}

/// The places within a radius, by a distance in metres.
pub(super) struct Within<T, D> {
    pub shifted: Shifted<T>,
    pub distance: D,
    pub radius: T,
}

impl<T: Real, D: Fn(LatLon<T>) -> T> Margin<T, 1> for Within<T, D> {
    /// Of the squares of radius and distance, as that of a distance from a place is smooth there. A negative
    /// distance keeps its sign.
    fn numbers(&self, place: Direction<T>) -> [T; 1] {
        let distance = (self.distance)(self.shifted.to_lat_lon(place));
        let squares = if distance > T::ZERO {
            (self.radius - distance) * (self.radius + distance)
        } else {
            self.radius * self.radius + distance * distance
        };
        [squares]
    }

    fn depth(&self, [depth]: [T; 1]) -> T {
        depth
    }

    fn may_enter(&self, [[from], [to]]: [[T; 1]; 2], [bend]: [T; 1]) -> bool {
        let beyond = max(from, to) + bend < -self.rounding();
        !beyond
    }

    fn may_leave(&self, [[from], [to]]: [[T; 1]; 2], [bend]: [T; 1]) -> bool {
        let rounding = self.rounding();
        let within = min(from, to) - bend >= -rounding - rounding;
        !within
    }

    fn rounding(&self) -> T {
        let rounding = T::of(8.0) * T::EPSILON * self.shifted.ellipsoid().a();
        rounding * (self.radius + self.radius + rounding)
    }
}
