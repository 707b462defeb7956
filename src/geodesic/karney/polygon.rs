use super::Area;
use crate::geodesic::degrees::Split;
use crate::{LatLon, Real};

/// A polygon of geodesics: add its corners in order, then ask for its area and perimeter.
///
/// ```
/// use terrella::geodesic::Area;
/// use terrella::{Ellipsoid, LatLon};
///
/// let area = Area::new(Ellipsoid::wgs84()).unwrap();
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
    under: Sum<T>,
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
            under: Sum::default(),
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

    /// The area in m², positive if the corners run counter-clockwise, between plus and minus half of the ellipsoid's.
    #[must_use]
    pub fn area(&self) -> T {
        let mut closed = *self;
        if let (Some(last), Some(first)) = (self.last, self.first) {
            closed.edge(last, first);
        }
        let whole = T::of(4.0 * core::f64::consts::PI) * self.area.c2;
        let half = whole * T::of(0.5);
        let mut under = closed.under.value();
        // Around a pole the areas under the edges leave half of the ellipsoid out.
        if closed.odd {
            under += half.copysign(-under);
        }
        if under > half {
            under - whole
        } else if under < -half {
            under + whole
        } else {
            under
        }
    }

    /// The length of all edges in metres, the closing one included.
    #[must_use]
    pub fn perimeter(&self) -> T {
        let mut closed = *self;
        if let (Some(last), Some(first)) = (self.last, self.first) {
            closed.edge(last, first);
        }
        closed.perimeter.value()
    }

    fn edge(&mut self, from: LatLon<T>, to: LatLon<T>) {
        self.perimeter.add(self.area.karney.solve(from, to).inverse.distance);
        // Counter-clockwise about a region to the north of the equator runs east to west.
        self.under.add(-self.area.under(from, to));
        self.odd ^= crosses(from.lon(), to.lon());
    }
}

/// Whether the shortest way from one longitude to another crosses the meridian 0.
fn crosses<T: Real>(from: T, to: T) -> bool {
    let circle = T::of(360.0);
    let difference = to - from;
    let east = if difference > T::of(180.0) {
        difference - circle
    } else if difference <= T::of(-180.0) {
        difference + circle
    } else {
        difference
    };
    match (from < T::ZERO, to < T::ZERO) {
        (true, false) => east > T::ZERO,
        (false, true) => east < T::ZERO,
        _ => false,
    }
}

/// A sum that keeps what each addition lost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Sum<T> {
    high: T,
    low: T,
}

impl<T: Real> Sum<T> {
    fn add(&mut self, value: T) {
        let Split { angle, rest } = Split::sum(self.high, value);
        self.high = angle;
        self.low += rest;
    }

    fn value(self) -> T {
        self.high + self.low
    }
}
