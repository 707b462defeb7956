use super::Area;
use super::edge::Edge;
use crate::math::DoubleWord;
use crate::{LatLon, Real};

/// Area and perimeter of a polygon whose edges are geodesics, from [`Area::polygon`]: add its corners in
/// order, then ask.
///
/// Corners may coincide, edges may cross, and the ring may run round a pole any number of times. A pole has a
/// longitude: between two corners at the same pole the edge turns there. Between opposite meridians the edge
/// goes over the pole that [`Karney::solve`](super::Karney::solve) takes.
///
/// ```
/// use terrella::geodesic::Area;
/// use terrella::{Ellipsoid, LatLon};
///
/// let area = Area::new(Ellipsoid::WGS84).unwrap();
/// let mut octant = area.polygon();
/// for (lat, lon) in [(0.0, 0.0), (0.0, 90.0), (90.0, 0.0)] {
///     octant.add(LatLon::new(lat, lon).unwrap());
/// }
/// assert!((octant.area() - 510_065_621_724_088.44_f64 / 8.0).abs() < 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "geod_polygon", alias = "geod_polygon_init")]
pub struct PolygonArea<'a, T> {
    area: &'a Area<T>,
    first: Option<LatLon<T>>,
    last: Option<LatLon<T>>,
    /// What lies to the left of the edges, less whole ellipsoids: in (−½, ½] of one.
    left: DoubleWord<T>,
    perimeter: DoubleWord<T>,
    /// Whether the edges have crossed the meridian 0 an odd number of times.
    odd: bool,
}

impl<'a, T: Real> PolygonArea<'a, T> {
    pub(super) fn new(area: &'a Area<T>) -> Self {
        Self {
            area,
            first: None,
            last: None,
            left: DoubleWord::default(),
            perimeter: DoubleWord::default(),
            odd: false,
        }
    }

    /// Adds a corner. The edge from the last corner to it is the shortest line.
    pub fn add(&mut self, corner: LatLon<T>) {
        if let Some(last) = self.last {
            self.edge(last, corner);
        }
        self.first = self.first.or(Some(corner));
        self.last = Some(corner);
    }

    /// Returns the area in m² to the left of the edges; 0 without corners.
    ///
    /// It is positive if the corners run counter-clockwise round less than half of the ellipsoid, negative if
    /// they run clockwise, as round a hole, and positive for exactly a half: as many whole ellipsoids are
    /// subtracted as bring it into (−½, ½] of one. If a ring runs round several times, each time counts. The
    /// errors of the edges, those of [`Area`], add up.
    #[must_use]
    pub fn area(&self) -> T {
        self.closed().enclosed()
    }

    /// The area of a ring that is closed.
    fn enclosed(mut self) -> T {
        // Round a pole the areas under the edges leave half of the ellipsoid out.
        let whole = self.area.whole();
        if self.odd {
            self.left.add_double(whole.half());
            reduce(&mut self.left, whole);
        }
        let (left, half) = (self.left.value(), whole.half().value());
        // A half but for rounding is a half.
        if left <= -half { half } else { left }
    }

    /// Returns the length of all edges in metres, with the closing one. The errors of the distances add up.
    #[must_use]
    pub fn perimeter(&self) -> T {
        self.closed().perimeter.value()
    }

    /// [`Self::area`] and [`Self::perimeter`]; the ring is closed once.
    pub(crate) fn area_and_perimeter(&self) -> [T; 2] {
        let closed = self.closed();
        [closed.enclosed(), closed.perimeter.value()]
    }

    fn closed(&self) -> Self {
        let mut closed = *self;
        if let (Some(last), Some(first)) = (self.last, self.first) {
            closed.edge(last, first);
        }
        closed
    }

    fn edge(&mut self, from: LatLon<T>, to: LatLon<T>) {
        self.join(self.area.edge(from, to));
    }

    /// Adds an edge by itself.
    pub(crate) fn join(&mut self, edge: Edge<T>) {
        self.perimeter.add(edge.length);
        // Eastward the equator is to the right.
        self.left.add_double(edge.under.negated());
        reduce(&mut self.left, self.area.whole());
        self.odd ^= edge.crosses;
    }
}

/// A sum brought into (−½, ½] of a whole, from less than a whole outside.
fn reduce<T: Real>(sum: &mut DoubleWord<T>, whole: DoubleWord<T>) {
    let half = whole.half();
    let over = (sum.high - half.high) + (sum.low - half.low);
    let under = (sum.high + half.high) + (sum.low + half.low);
    if over > T::ZERO {
        sum.add_double(whole.negated());
    } else if under <= T::ZERO {
        sum.add_double(whole);
    }
}
