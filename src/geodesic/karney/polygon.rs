use super::Area;
use crate::geodesic::degrees::{Split, longitude_difference};
use crate::geodesic::sum::Sum;
use crate::{LatLon, Real};

/// A polygon of geodesics: add its corners in order, then ask for its area and perimeter.
///
/// Corners may coincide, and edges may cross; the ring may run round a pole any number of times. A pole has a
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
pub struct PolygonArea<'a, T> {
    area: &'a Area<T>,
    first: Option<LatLon<T>>,
    last: Option<LatLon<T>>,
    /// What lies to the left of the edges, less whole ellipsoids: in (−½, ½] of one.
    left: Sum<T>,
    perimeter: Sum<T>,
    /// Whether the edges have crossed the meridian 0 an odd number of times.
    odd: bool,
}

impl<'a, T: Real> PolygonArea<'a, T> {
    pub(super) fn new(area: &'a Area<T>) -> Self {
        Self {
            area,
            first: None,
            last: None,
            left: Sum::default(),
            perimeter: Sum::default(),
            odd: false,
        }
    }

    /// Adds a corner.
    pub fn add(&mut self, corner: LatLon<T>) {
        if let Some(last) = self.last {
            self.edge(last, corner);
        }
        self.first = self.first.or(Some(corner));
        self.last = Some(corner);
    }

    /// The area in m² to the left of the edges, less as many whole ellipsoids as bring it into (−½, ½] of
    /// one: positive if the corners run counter-clockwise round less than a half, negative for a hole, whose
    /// corners run clockwise, and positive for exactly a half. Of a ring that runs round several times each
    /// time counts.
    ///
    /// The errors are those of [`Area`], added up over the edges.
    #[must_use]
    pub fn area(&self) -> T {
        let mut closed = self.closed();
        // Round a pole the areas under the edges leave half of the ellipsoid out.
        let whole = self.area.whole();
        if closed.odd {
            add(&mut closed.left, whole.half());
            reduce(&mut closed.left, whole);
        }
        let Split { angle, rest } = whole.half();
        let (left, half) = (closed.left.value(), angle + rest);
        // A half but for rounding is a half.
        if left <= -half { half } else { left }
    }

    /// The length of all edges in metres, the closing one included.
    #[must_use]
    pub fn perimeter(&self) -> T {
        self.closed().perimeter.value()
    }

    fn closed(&self) -> Self {
        let mut closed = *self;
        if let (Some(last), Some(first)) = (self.last, self.first) {
            closed.edge(last, first);
        }
        closed
    }

    fn edge(&mut self, from: LatLon<T>, to: LatLon<T>) {
        let (distance, under) = self.area.edge(from, to);
        self.perimeter.add(distance);
        // Eastward the equator is to the right.
        add(&mut self.left, opposite(under));
        reduce(&mut self.left, self.area.whole());
        // East or west as the geodesic itself goes: the meridian 0 counts to the east.
        let east = longitude_difference(from, to).angle;
        self.odd ^= match (from.lon() < T::ZERO, to.lon() < T::ZERO) {
            (true, false) => east > T::ZERO,
            (false, true) => east < T::ZERO,
            _ => false,
        };
    }
}

/// Adds a number and its rest.
fn add<T: Real>(sum: &mut Sum<T>, value: Split<T>) {
    sum.add(value.angle);
    sum.low += value.rest;
}

/// A sum brought into (−½, ½] of a whole, from less than a whole outside.
fn reduce<T: Real>(sum: &mut Sum<T>, whole: Split<T>) {
    let half = whole.half();
    let over = (sum.high - half.angle) + (sum.low - half.rest);
    let under = (sum.high + half.angle) + (sum.low + half.rest);
    if over > T::ZERO {
        add(sum, opposite(whole));
    } else if under <= T::ZERO {
        add(sum, whole);
    }
}

fn opposite<T: Real>(value: Split<T>) -> Split<T> {
    Split {
        angle: -value.angle,
        rest: -value.rest,
    }
}
