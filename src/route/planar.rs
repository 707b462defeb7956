use super::{Crossing, EdgeCrossing, EdgeDistance};
use crate::geodesic::{PlanarArea, Tangent};
use crate::latitude::UnsupportedFlattening;
use crate::math::{hypot, max, min};
use crate::{Ellipsoid, LatLon, Real};

/// The plane about an origin, for fences of some kilometres: in `f32` on a flight computer, without a
/// trigonometric function an edge.
///
/// Places are `[east, north]` in metres. [`Planar::place`] makes one of a latitude and longitude,
/// [`Planar::offset`] of an offset from the origin: `f32` holds offsets to 2⁻²⁴ of themselves, latitudes and
/// longitudes only to 0.4 m. Distances from the origin are true, as in the azimuthal equidistant projection:
/// to the third order in the distance.
///
/// | from the origin | a place, `f64` | `f32` by offset | an edge across, beside the geodesic |
/// |---|---|---|---|
/// | 5 km | 0.01 mm | 2 mm | 1 mm |
/// | 50 km | 1 cm | 2 cm | 0.5 m |
///
/// A place is on an edge ([`Side::Edge`](super::Side::Edge)) if the sign of the triangle's area is not
/// certain in the scalar: within 2.5 ε (|a_x b_y| + |a_y b_x|)/s of an edge of length s, where a and b are
/// the corners as seen from the place; less than 2 mm on a fence of 5 km in `f32`. So `f32` never puts a
/// place on the wrong side of the edge between the corners that it has.
///
/// ```
/// use terrella::route::{Fence, Planar, Side};
/// use terrella::{Ellipsoid, LatLon};
/// let home = LatLon::new(47.397_742_f32, 8.545_594)?;
/// let plane = Planar::about(Ellipsoid::WGS84, home)?;
/// // Offsets in degrees, from the difference in f64 or in whole numbers.
/// let corner = |north, east| LatLon::new(north, east).map(|offset| plane.offset(offset));
/// let field = [corner(-0.02, -0.03)?, corner(-0.02, 0.03)?, corner(0.02, 0.03)?, corner(0.02, -0.03)?];
/// let rings = [field.as_slice()];
/// let fence = Fence::new(&plane, &rings);
/// assert_eq!(fence.side([0.0, 0.0]), Side::Inside);
/// assert!((fence.distance([0.0, 0.0]) + 2223.7).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Planar<T> {
    origin: LatLon<T>,
    tangent: Tangent<T>,
}

impl<T: Real> Planar<T> {
    /// Makes the plane about a place.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if |f| > 1/60.
    pub fn about(ellipsoid: Ellipsoid<T>, origin: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let tangent = PlanarArea::new(ellipsoid)?.tangent(origin);
        Ok(Self { origin, tangent })
    }

    /// Returns the origin.
    #[must_use]
    pub const fn origin(&self) -> LatLon<T> {
        self.origin
    }

    /// Returns `[east, north]` of a place in metres.
    #[must_use]
    pub fn place(&self, place: LatLon<T>) -> [T; 2] {
        self.equidistant(self.tangent.seen(self.origin, place))
    }

    /// Returns `[east, north]` in metres of a place so many degrees north and east of the origin.
    #[must_use]
    pub fn offset(&self, offset: LatLon<T>) -> [T; 2] {
        let here = LatLon::within(T::ZERO, T::ZERO);
        self.equidistant(self.tangent.seen(here, offset))
    }

    /// From the tangent plane, in which distances are sines.
    fn equidistant(&self, [east, north]: [T; 2]) -> [T; 2] {
        // asin x = x (1 + x²/6 …); the tangent has an eighth of the curvature 1/R².
        let longer = self.tangent.curvature() * T::of(8.0 / 6.0) * (east * east + north * north);
        [east + east * longer, north + north * longer]
    }
}

/// Corners as seen from a place.
fn seen<T: Real>([x, y]: [T; 2], [east, north]: [T; 2]) -> [T; 2] {
    [east - x, north - y]
}

/// Edges are straight lines. Nothing far away is inside, unless the ring is asked for to the left and runs
/// clockwise.
impl<T: Real> EdgeCrossing<T> for Planar<T> {
    type Place = [T; 2];

    fn northing(&self, [_, north]: [T; 2]) -> T {
        north
    }

    fn northings(&self, [_, from]: [T; 2], [_, to]: [T; 2]) -> [T; 2] {
        [min(from, to), max(from, to)]
    }

    fn crossing(&self, place: [T; 2], from: [T; 2], to: [T; 2]) -> Crossing {
        let ([ax, ay], [bx, by]) = (seen(place, from), seen(place, to));
        let (one, two) = (ax * by, ay * bx);
        let area = one - two;
        // 1.5 ε of each product by the differences and the product itself, and ½ ε of the result.
        let uncertain = area.abs() <= T::of(2.5) * T::EPSILON * (one.abs() + two.abs());
        // Between the corners, or at one.
        if uncertain && (ax * bx <= T::ZERO) && (ay * by <= T::ZERO) {
            return Crossing::Touching;
        }
        let (west, east) = (ax < T::ZERO, bx < T::ZERO);
        // From west to east with the place to the right, or back with the place to the left.
        let across = (west & !east & (area < T::ZERO)) | (!west & east & (area > T::ZERO));
        if across { Crossing::Across } else { Crossing::Apart }
    }

    fn ends(&self, edges: impl Iterator<Item = [[T; 2]; 2]>, left: bool) -> [bool; 2] {
        let mut doubled = T::ZERO;
        let mut first = None;
        for [from, to] in edges {
            let first = *first.get_or_insert(from);
            let ([ax, ay], [bx, by]) = (seen(first, from), seen(first, to));
            doubled += ax * by - ay * bx;
        }
        [left && doubled < T::ZERO; 2]
    }
}

impl<T: Real> EdgeDistance<T> for Planar<T> {
    /// The worst error is 4 ε of the distance to the farther corner.
    fn edge_distance(&self, place: [T; 2], from: [T; 2], to: [T; 2]) -> T {
        let ([ax, ay], [bx, by]) = (seen(place, from), seen(place, to));
        let [dx, dy] = seen(from, to);
        let length = hypot(dx, dy);
        // How far along the edge the foot is, from either end.
        let (before, after) = (-(ax * dx + ay * dy), bx * dx + by * dy);
        if before > T::ZERO && after > T::ZERO {
            // By the nearer corner.
            let [x, y] = if before < after { [ax, ay] } else { [bx, by] };
            return (x * (dy / length) - y * (dx / length)).abs();
        }
        min(hypot(ax, ay), hypot(bx, by))
    }
}
