use super::Area;
use super::edge::Edge;
use crate::geodesic::GeodesicError;
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

    /// Adds an edge that leaves the last corner at an azimuth in degrees and is so many metres long, and
    /// returns the corner at its end. A negative length goes backwards, and counts as negative in the
    /// perimeter.
    ///
    /// The edge need not be the shortest line to its end: it may go more than half round the Earth, or round
    /// it several times. Over a pole it goes eastward for the azimuths 0 and 180, westward for −0 and −180.
    /// The closing edge is the shortest line. Without a corner nothing is added, and nothing returned.
    ///
    /// ```
    /// use terrella::geodesic::Area;
    /// use terrella::{Ellipsoid, LatLon};
    /// let area = Area::new(Ellipsoid::WGS84)?;
    /// let mut field = area.polygon();
    /// field.add(LatLon::new(47.0, 8.0)?);
    /// for (azimuth, length) in [(100.0, 250.0), (10.0, 120.0), (280.0, 250.0)] {
    ///     field.add_edge(azimuth, length)?;
    /// }
    /// assert!((field.area() - 29_998.6_f64).abs() < 0.1 && (field.perimeter() - 739.989).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] if the azimuth is infinite or NaN, and those of
    /// [`Line::at`](crate::geodesic::Line::at). Nothing is added then.
    #[doc(alias = "geod_polygon_addedge")]
    pub fn add_edge(&mut self, azimuth: T, length: T) -> Result<Option<LatLon<T>>, GeodesicError<T>> {
        let Some(last) = self.last else {
            return Ok(None);
        };
        let (edge, end) = self.area.direct_edge(last, azimuth, length)?;
        self.join(edge);
        self.last = Some(end);
        Ok(Some(end))
    }

    /// Closes the ring: corners that are added next belong to another one. Areas and perimeters of the rings
    /// add up. So a hole is a ring that runs the other way.
    ///
    /// ```
    /// use terrella::geodesic::Area;
    /// use terrella::{Ellipsoid, LatLon};
    /// let area = Area::new(Ellipsoid::WGS84)?;
    /// let mut polygon = area.polygon();
    /// let outer = [(0.0, 0.0), (0.0, 3.0), (3.0, 3.0), (3.0, 0.0)];
    /// let hole = [(1.0, 1.0), (2.0, 1.0), (2.0, 2.0), (1.0, 2.0)];
    /// for ring in [outer, hole] {
    ///     for (lat, lon) in ring {
    ///         polygon.add(LatLon::new(lat, lon)?);
    ///     }
    ///     polygon.close();
    /// }
    /// assert!((polygon.area() / 98_460_000_000.0_f64 - 1.0).abs() < 1e-3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn close(&mut self) {
        *self = self.closed();
        (self.first, self.last) = (None, None);
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

    /// Returns [`area`](Self::area) with the other sign: positive if the corners run clockwise. For exactly a
    /// half of the ellipsoid it is positive, too. GeographicLib calls this `reverse`.
    #[must_use]
    pub fn clockwise_area(&self) -> T {
        self.closed().reversed().enclosed()
    }

    /// Returns the area in m² to the left of the edges, as what may be more than half of the ellipsoid: as
    /// many whole ellipsoids are added as bring it into [0, 1) of one. For a ring of less than its rounding
    /// that may be a whole one. GeographicLib calls this an area without `sign`.
    ///
    /// ```
    /// use terrella::geodesic::Area;
    /// use terrella::{Ellipsoid, LatLon};
    /// let area = Area::new(Ellipsoid::WGS84)?;
    /// let mut ring = area.polygon();
    /// for lon in [0.0, -120.0, 120.0] {
    ///     ring.add(LatLon::new(60.0, lon)?);
    /// }
    /// let whole = 510_065_621_724_088.44_f64;
    /// assert!(ring.area() < 0.0 && (ring.left_area() - ring.area() - whole).abs() < 1.0);
    /// assert_eq!(ring.right_area(), -ring.area());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn left_area(&self) -> T {
        self.unsigned(self.area())
    }

    /// Returns the area in m² to the right of the edges, as [`left_area`](Self::left_area) does to the left.
    #[must_use]
    pub fn right_area(&self) -> T {
        self.unsigned(self.clockwise_area())
    }

    fn unsigned(&self, area: T) -> T {
        if area < T::ZERO {
            area + self.area.whole().value()
        } else {
            area
        }
    }

    fn reversed(mut self) -> Self {
        self.left = self.left.negated();
        // −½ of a whole is ½.
        reduce(&mut self.left, self.area.whole());
        self
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

    /// Returns the length of the edges in metres without the closing one: that of an open line.
    ///
    /// ```
    /// use terrella::geodesic::Area;
    /// use terrella::{Ellipsoid, LatLon};
    /// let area = Area::new(Ellipsoid::WGS84)?;
    /// let mut line = area.polygon();
    /// for lon in [0.0, 1.0, 2.0] {
    ///     line.add(LatLon::new(0.0, lon)?);
    /// }
    /// assert!((line.length() - 222_638.982_f64).abs() < 1e-3 && line.perimeter() > 445_277.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias = "polyline")]
    pub fn length(&self) -> T {
        self.perimeter.value()
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
