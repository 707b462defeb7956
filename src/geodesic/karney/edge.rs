use super::Area;
use super::area::turned_back;
use crate::geodesic::angle::{Angle, longitude_difference};
use crate::geodesic::general::Canonical;
use crate::geodesic::series::cosines;
use crate::math::{DoubleWord, select};
use crate::{LatLon, Real};

/// An edge of a polygon.
#[derive(Clone, Copy)]
pub(crate) struct Edge<T> {
    /// Its length in metres.
    pub(super) length: T,
    /// The area between it and the equator, in m².
    pub(super) under: DoubleWord<T>,
    /// Whether it crosses the meridian 0.
    pub(super) crosses: bool,
}

impl<T: Real> Edge<T> {
    #[inline(always)]
    pub(super) fn new(from: LatLon<T>, to: LatLon<T>, length: T, under: DoubleWord<T>) -> Self {
        // East or west as the geodesic itself goes: the meridian 0 counts to the east.
        let east = longitude_difference(from, to).high;
        let (from, to) = (from.lon() < T::ZERO, to.lon() < T::ZERO);
        Self {
            length,
            under,
            crosses: (from & !to & (east > T::ZERO)) | (!from & to & (east < T::ZERO)),
        }
    }

    /// As numbers, for a batch.
    #[inline(always)]
    pub(crate) fn row(self) -> [T; 4] {
        let crosses = select(self.crosses, T::ONE, T::ZERO);
        [self.length, self.under.high, self.under.low, crosses]
    }

    /// From [`Self::row`].
    #[inline(always)]
    pub(crate) fn of([length, high, low, crosses]: [T; 4]) -> Self {
        Self {
            length,
            under: DoubleWord { high, low },
            crosses: crosses != T::ZERO,
        }
    }
}

/// Terms of the area's series in `f64` on the Earth, the most that are taken here.
const TERMS: usize = 6;

/// The same in `f32`, too.
#[inline(always)]
fn terms<T: Real>() -> usize {
    T::terms(TERMS, 3)
}

/// Edges of polygons, without a branch that depends on the places.
#[derive(Clone, Copy)]
pub(crate) struct Edges<T> {
    area: Area<T>,
    /// C₄ₗ/ε^l by powers of ε; those that the ellipsoid does not need are 0.
    c4: [[T; TERMS]; TERMS],
    exact: bool,
}

impl<T: Real> Edges<T> {
    pub(crate) fn new(area: &Area<T>) -> Self {
        let all = area.karney.integrals().order() <= terms::<T>();
        Self {
            area: *area,
            c4: area.series.first_rows(),
            exact: all & area.karney.fast.exact(),
        }
    }

    /// The edge, and whether it is that of [`Area::edge`], bit for bit: not between nearly antipodal places,
    /// nor on ellipsoids far flatter than the Earth.
    #[inline(always)]
    pub(crate) fn edge(&self, from: LatLon<T>, to: LatLon<T>) -> (Edge<T>, bool) {
        let karney = &self.area.karney;
        let (outcome, same) = karney.fast.near_outcome(from, to);
        let problem = Canonical::new(&karney.general, from, to);
        let course = problem.course(outcome.inverse, outcome.growth);
        let solved = (&problem, &course);
        let along = self.area.along_meridian(from, to, solved);
        let beside = self
            .area
            .beside_meridian(solved, |alpha0, sigmas| self.beyond_sphere(alpha0, sigmas));
        let under = DoubleWord {
            high: select(course.meridional, along.high, beside.high),
            low: select(course.meridional, along.low, beside.low),
        };
        let under = turned_back(&problem, under);
        let unless_same = |value| select(same, T::ZERO, value);
        let under = DoubleWord {
            high: unless_same(under.high),
            low: unless_same(under.low),
        };
        let edge = Edge::new(from, to, unless_same(outcome.inverse.distance), under);
        (edge, (same | outcome.found) & self.exact)
    }

    /// The edge in any case.
    pub(crate) fn any_edge(&self, from: LatLon<T>, to: LatLon<T>) -> Edge<T> {
        self.area.edge(from, to)
    }

    #[inline(always)]
    fn beyond_sphere(&self, alpha0: Angle<T>, [sigma1, sigma2]: [Angle<T>; 2]) -> T {
        let epsilon = self.area.epsilon(alpha0);
        let mut power = T::ONE;
        let c4 = self.c4.map(|row| {
            let row = row.iter().take(terms::<T>()).rev();
            let value = power * row.fold(T::ZERO, |sum, &c| sum * epsilon + c);
            power *= epsilon;
            value
        });
        let c4 = c4.get(..terms::<T>()).unwrap_or(&c4);
        let integral = cosines(c4, sigma2) - cosines(c4, sigma1);
        self.area.oblateness(alpha0, integral)
    }
}
