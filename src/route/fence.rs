use super::{Crossing, EdgeCrossing, EdgeDistance, Side};
use crate::Real;
use crate::math::{max, min};

/// A fence of one ring or several, whose edges are shortest lines: says on which side places are.
///
/// A ring is a slice of corners. The last corner is joined to the first; a last one that repeats the first
/// changes nothing. Rings may run in either direction, round a pole and across the meridian of ±180°; corners
/// may coincide, rings may touch themselves and each other. A place is inside the fence if it is inside an
/// odd number of the rings: so a ring in another is a hole. Where a ring crosses itself, what it runs round
/// an even number of times is outside.
///
/// Inside is the smaller side of a ring. If both are equal, it is the one to the left of the edges. With
/// [`Fence::to_the_left`] it is the left one for all rings, which may then hold more than half of the Earth.
/// Of a ring that runs round the axis an even number of times, not 0, neither pole is inside.
///
/// | surface | place | edges | [`Side::Edge`] within |
/// |---|---|---|---|
/// | [`Karney`](crate::geodesic::Karney) | [`LatLon`](crate::LatLon) | geodesics | 15 nm (`f32`: below) |
/// | [`GreatCircle`](crate::geodesic::GreatCircle) | `LatLon` | great circles | 15 nm (`f32`: below) |
/// | [`Planar`](super::Planar) | east and north in metres | straight lines | rounding of the plane's numbers |
///
/// The number t of the table is for a body of the Earth's size, and changes with the size. A place is on an
/// edge of length s₁₂ if it is within t (1 + sin σ/sin σ₁₂) of it: σ₁₂ is s₁₂ in radii, and σ the distance to
/// one of the corners. For edges of up to 10 000 km that is 2 t at most. Between nearly antipodal corners it
/// is more, as the edge itself is not known better. In `f32` t is 2·10⁻⁶ of the distance to the corner and 6
/// µm, at most 10 m. Places farther away than that are always put on the right side. Which side of a ring is
/// smaller, and which is the left one of a ring that is not round a pole, is told by its area, with the
/// errors of [`Area`](crate::geodesic::Area): it may be wrong for a ring within 1 m² (`f32`: 1000 km²) of
/// one half, and to the left for one of less than that.
///
/// How it works: an edge crosses the meridian from the place to the north pole if its corners are on either
/// side of it, and if the edge leaves a corner farther to the north than the line from the corner to the
/// place. Shortest lines from a corner reach a meridian in the order of their azimuths, so this holds on any
/// ellipsoid, for edges of any length. Edges whose latitudes are far from the place's are not solved. The
/// number of crossings tells on which side of the ring the place is, relative to the pole; the turns and the
/// area of the ring tell on which side the pole is.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::{Fence, Side};
/// use terrella::{Ellipsoid, LatLon};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let at = |lat, lon| LatLon::<f64>::new(lat, lon);
/// // From Fiji to Samoa, with a hole.
/// let ring = [at(-20.0, 175.0)?, at(-20.0, -170.0)?, at(-10.0, -170.0)?, at(-10.0, 175.0)?];
/// let hole = [at(-18.0, 177.0)?, at(-18.0, 179.0)?, at(-17.0, 179.0)?, at(-17.0, 177.0)?];
/// let rings = [ring.as_slice(), &hole];
/// let fence = Fence::new(&earth, &rings);
/// assert_eq!(fence.side(at(-14.0, 180.0)?), Side::Inside);
/// assert_eq!(fence.side(at(-17.5, 178.0)?), Side::Outside);
/// assert_eq!(fence.side(at(-15.0, 175.0)?), Side::Edge);
/// // The southern edge runs 12 km south of the parallel.
/// assert_eq!(fence.side(at(-20.1, -177.5)?), Side::Inside);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias("point in polygon", "geofence", "contains", "covers", "ring"))]
#[derive(Debug)]
pub struct Fence<'a, G: EdgeCrossing<T>, T: Real> {
    ground: &'a G,
    rings: &'a [&'a [G::Place]],
    /// Whether the ends of the meridians are inside, in the north and in the south.
    ends: [bool; 2],
    /// All edges are between these northings.
    bounds: [T; 2],
}

impl<G: EdgeCrossing<T>, T: Real> Clone for Fence<'_, G, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<G: EdgeCrossing<T>, T: Real> Copy for Fence<'_, G, T> {}

/// From each corner to the next, and from the last to the first.
fn edges<P: Copy>(ring: &[P]) -> impl Iterator<Item = [P; 2]> {
    let next = ring.iter().skip(1).chain(ring.first());
    ring.iter().zip(next).map(|(&from, &to)| [from, to])
}

impl<'a, G: EdgeCrossing<T>, T: Real> Fence<'a, G, T> {
    /// Makes a fence of rings. Inside a ring is its smaller side.
    #[must_use]
    pub fn new(ground: &'a G, rings: &'a [&'a [G::Place]]) -> Self {
        Self::with(ground, rings, false)
    }

    /// Makes a fence of rings. Inside a ring is to the left of its edges: a ring that runs counter-clockwise
    /// holds what it runs round, one that runs clockwise holds all the rest.
    ///
    /// ```
    /// use terrella::geodesic::GreatCircle;
    /// use terrella::route::{Fence, Side};
    /// use terrella::LatLon;
    /// let sphere = GreatCircle::new(6_371_000.0)?;
    /// let clockwise = [LatLon::new(0.0, 0.0)?, LatLon::new(10.0, 0.0)?, LatLon::new(0.0, 10.0)?];
    /// let rings = [clockwise.as_slice()];
    /// let [smaller, left] = [Fence::new(&sphere, &rings), Fence::to_the_left(&sphere, &rings)];
    /// let (near, far) = (LatLon::new(2.0, 2.0)?, LatLon::new(-50.0, 100.0)?);
    /// assert_eq!([smaller.side(near), smaller.side(far)], [Side::Inside, Side::Outside]);
    /// assert_eq!([left.side(near), left.side(far)], [Side::Outside, Side::Inside]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn to_the_left(ground: &'a G, rings: &'a [&'a [G::Place]]) -> Self {
        Self::with(ground, rings, true)
    }

    fn with(ground: &'a G, rings: &'a [&'a [G::Place]], left: bool) -> Self {
        let mut ends = [false; 2];
        let mut bounds = None;
        for ring in rings {
            let [north, south] = ground.ends(edges(ring), left);
            let [in_north, in_south] = ends;
            ends = [in_north ^ north, in_south ^ south];
            for [from, to] in edges(ring) {
                let [low, high] = ground.northings(from, to);
                let [south, north] = bounds.unwrap_or([low, high]);
                bounds = Some([min(south, low), max(north, high)]);
            }
        }
        Self {
            ground,
            rings,
            ends,
            bounds: bounds.unwrap_or([T::ZERO; 2]),
        }
    }

    /// Returns the side that a place is on.
    #[must_use]
    pub fn side(&self, place: G::Place) -> Side {
        let side = |inside| if inside { Side::Inside } else { Side::Outside };
        let northing = self.ground.northing(place);
        let ([south, north], [in_north, in_south]) = (self.bounds, self.ends);
        if northing > north {
            return side(in_north);
        }
        if northing < south {
            return side(in_south);
        }
        let mut inside = in_north;
        for ring in self.rings {
            for [from, to] in edges(ring) {
                match self.ground.crossing(place, from, to) {
                    Crossing::Apart => (),
                    Crossing::Across => inside = !inside,
                    Crossing::Touching => return Side::Edge,
                }
            }
        }
        side(inside)
    }

    /// Returns whether a place is inside or on an edge.
    #[must_use]
    pub fn contains(&self, place: G::Place) -> bool {
        self.side(place) != Side::Outside
    }
}

impl<G: EdgeDistance<T>, T: Real> Fence<'_, G, T> {
    /// Returns the distance in metres of a place to the nearest edge: negative inside, 0 on an edge. Without
    /// an edge it is infinite.
    ///
    /// ```
    /// use terrella::route::{Fence, Planar};
    /// use terrella::{Ellipsoid, LatLon};
    /// let plane = Planar::about(Ellipsoid::WGS84, LatLon::new(47.4_f32, 8.5)?)?;
    /// let square = [[0.0, 0.0], [100.0, 0.0], [100.0, 100.0], [0.0, 100.0]];
    /// let rings = [square.as_slice()];
    /// let fence = Fence::new(&plane, &rings);
    /// assert_eq!(fence.distance([30.0, 60.0]), -30.0);
    /// assert_eq!(fence.distance([103.0, 104.0]), 5.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn distance(&self, place: G::Place) -> T {
        let mut nearest = T::ONE / T::ZERO;
        for [from, to] in self.rings.iter().flat_map(|ring| edges(ring)) {
            if self.ground.edge_at_least(place, from, to) < nearest {
                nearest = min(nearest, self.ground.edge_distance(place, from, to));
            }
        }
        match self.side(place) {
            Side::Inside => -nearest,
            Side::Outside => nearest,
            Side::Edge => T::ZERO,
        }
    }
}
