use super::Karney;
use super::edge::Edge;
use super::polygon::PolygonArea;
use crate::geodesic::GeodesicError;
use crate::geodesic::angle::{Angle, longitude_difference};
use crate::geodesic::general::{Canonical, Course, Line, Place};
use crate::geodesic::series::{AreaSeries, Integrals};
use crate::geodesic::sphere::{arc_from_node, node};
use crate::latitude::UnsupportedFlattening;
use crate::math::{DoubleWord, select};
use crate::{Ellipsoid, LatLon, Real};

/// Areas of polygons of any size, and between a geodesic and the equator, on the ellipsoid.
///
/// [`Area::polygon`] starts a polygon. For fields of up to some hundred kilometres
/// [`PlanarArea`](crate::geodesic::PlanarArea) is cheaper, and in `f32` far more exact.
///
/// | worst error of the area under a line on the Earth | `f64` | `f32` |
/// |---|---|---|
/// | any line | 0.1 m² | 60 km² |
/// | lines under 1000 km | 0.02 m² and 5e-16 of the area | 0.2 km² and 5e-7 of the area |
///
/// The area under a line past a pole is large, however short the line. Between nearly antipodal places, whose
/// reduced length is under a tenth of the distance, the azimuths and with them the area are ill-conditioned:
/// errors up to 10⁴ m² were seen.
///
/// C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013), section 6.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "areaint", alias = "geod_polygonarea")]
pub struct Area<T> {
    pub(super) karney: Karney<T>,
    pub(super) series: AreaSeries<T>,
    /// The square of the authalic radius.
    pub(super) c2: T,
}

impl<T: Real> Area<T> {
    /// Makes the area measure of an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] unless −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        Karney::new(ellipsoid).map(Self::within)
    }

    /// For the ellipsoid of these geodesics.
    pub(crate) fn within(karney: Karney<T>) -> Self {
        Self {
            karney,
            series: AreaSeries::new(karney.ellipsoid(), karney.integrals()),
            c2: karney.ellipsoid().authalic_radius_squared(),
        }
    }

    /// Returns the area in m² between the geodesic from one place to another and the equator. It is positive
    /// if the quadrilateral from – (0, longitude of from) – (0, longitude of to) – to runs counter-clockwise:
    /// for instance if the geodesic runs eastward, north of the equator.
    ///
    /// Between opposite meridians the geodesic goes over the pole that [`Karney::solve`] takes: eastward to a
    /// longitude that is 180° more, westward to one that is 180° less. A pole has a longitude: between two
    /// places at the same pole the area is that of the lune between their meridians, from the pole to the
    /// equator.
    #[must_use]
    pub fn under(&self, from: LatLon<T>, to: LatLon<T>) -> T {
        self.edge(from, to).under.value()
    }

    /// The geodesic from one place to another as an edge of a polygon.
    pub(super) fn edge(&self, from: LatLon<T>, to: LatLon<T>) -> Edge<T> {
        let Karney { general, fast } = &self.karney;
        if fast.exact() {
            if let Some(found) = fast.outcome(from, to) {
                let problem = Canonical::new(general, from, to);
                let course = problem.course(found.inverse, found.growth);
                let under = self.under_course(from, to, (&problem, &course));
                return Edge::new(from, to, found.inverse.distance, under);
            }
        }
        let (line, problem, segment) = general.inverse(from, to);
        let under = self.under_course(from, to, (&problem, &segment.course()));
        Edge::new(from, to, line.distance, under)
    }

    fn under_course(&self, from: LatLon<T>, to: LatLon<T>, solved: Solved<'_, T>) -> DoubleWord<T> {
        let (problem, course) = solved;
        let area = if course.meridional {
            self.along_meridian(from, to, solved)
        } else {
            self.beside_meridian(solved, |alpha0, sigmas| self.beyond_sphere(alpha0, sigmas))
        };
        turned_back(problem, area)
    }

    /// All of the turn is at a pole, in the south if it is not said to be in the north: a lune, exactly a
    /// quarter of the ellipsoid between opposite meridians.
    #[cfg_attr(not(small), inline(always))]
    pub(super) fn along_meridian(
        &self,
        from: LatLon<T>,
        to: LatLon<T>,
        (problem, course): Solved<'_, T>,
    ) -> DoubleWord<T> {
        // Between opposite places over either pole; else over the one in the south, or from a pole.
        let opposite = (problem.lambda12.sin == T::ZERO) & (problem.lambda12.cos < T::ZERO);
        let north = opposite & (course.alpha1.cos > T::ZERO);
        let difference = longitude_difference(from, to);
        let east = T::ONE.copysign(difference.high);
        let (angle, rest) = (difference.high * east, difference.low * east);
        let two_circles = select(north, T::of(720.0), T::of(-720.0));
        let part = angle / two_circles;
        // With what the quotient has lost, for lunes round a pole to fill a hemisphere.
        let back = DoubleWord::product(part, two_circles);
        let lost = ((angle - back.high) + (rest - back.low)) / two_circles;
        let whole = self.whole();
        let area = DoubleWord::product(whole.high, part);
        DoubleWord {
            low: area.low + (whole.low * part + whole.high * lost),
            ..area
        }
    }

    /// `beyond_sphere` is [`Self::beyond_sphere`], of σ₁ and σ₂.
    #[cfg_attr(not(small), inline(always))]
    pub(super) fn beside_meridian(
        &self,
        (problem, course): Solved<'_, T>,
        beyond_sphere: impl Fn(Angle<T>, [Angle<T>; 2]) -> T,
    ) -> DoubleWord<T> {
        let (beta1, beta2) = (problem.beta1, problem.beta2);
        let &Course {
            alpha1,
            alpha2,
            omega12,
            ..
        } = course;
        let alpha0 = node(alpha1, beta1);
        let sigmas = [arc_from_node(alpha1, beta1), arc_from_node(alpha2, beta2)];
        let round = (alpha0.sin == T::ZERO) | (alpha0.cos == T::ZERO);
        let oblateness = select(round, T::ZERO, beyond_sphere(alpha0, sigmas));
        // tan(α₁₂/2) from half angles (Karney 63).
        let (d1, d2) = (T::ONE + beta1.cos, T::ONE + beta2.cos);
        let sin = omega12.sin * (beta1.sin * d2 + beta2.sin * d1);
        let obtuse = omega12.cos < T::ZERO;
        let versine = select(
            obtuse,
            omega12.sin * omega12.sin / (T::ONE - omega12.cos),
            T::ONE + omega12.cos,
        );
        let half = Angle {
            sin,
            cos: versine * (beta1.sin * beta2.sin + d1 * d2),
        };
        let halved = (omega12.cos > T::of(-0.95)) & (beta2.sin - beta1.sin < T::of(1.75));
        let turn = select(halved, half, alpha2.minus(alpha1)).to_radians();
        self.with_sphere(select(halved, T::of(2.0), T::ONE) * turn, oblateness)
    }

    /// Returns the area in m² between the equator and the geodesic that starts at a place, at an azimuth in
    /// degrees, and ends after a distance in metres; less whole ellipsoids. The sign is that of
    /// [`under`](Self::under). Over a pole the line goes eastward for the azimuths 0 and 180, westward for −0
    /// and −180.
    ///
    /// # Errors
    /// [`GeodesicError::Azimuth`] if the azimuth is infinite or NaN, and those of
    /// [`Line::at`](crate::geodesic::Line::at).
    pub fn under_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<T, GeodesicError<T>> {
        let line = self.karney.line(from, azimuth)?;
        let place = line.place(distance)?;
        Ok(self.under_line(&line, &place).value() + T::ZERO)
    }

    /// The edge of a line from its start to a place of it, and where it ends.
    pub(super) fn direct_edge(
        &self,
        from: LatLon<T>,
        azimuth: T,
        distance: T,
    ) -> Result<(Edge<T>, LatLon<T>), GeodesicError<T>> {
        let line = self.karney.line(from, azimuth)?;
        let place = line.place(distance)?;
        let to = place.point.position;
        let [_, lon] = line.unrolled_to(&place);
        let circles = (lon - to.lon()) / T::of(360.0);
        let odd = circles.round_ties_even().remainder(T::of(2.0)) != T::ZERO;
        let edge = Edge {
            length: distance,
            under: self.under_line(&line, &place),
            crosses: odd ^ (from.lon() < T::ZERO) ^ (to.lon() < T::ZERO),
        };
        Ok((edge, to))
    }

    fn under_line(&self, line: &Line<T>, place: &Place<T>) -> DoubleWord<T> {
        let (alpha0, sigma1, sigma2) = (line.alpha0(), line.sigma1(), place.sigma2);
        let meridional = alpha0.sin == T::ZERO || alpha0.cos == T::ZERO;
        let turn = if meridional {
            place.alpha2.minus(line.alpha1)
        } else {
            let (sin, cos) = (place.sigma12.sin, place.sigma12.cos);
            let along = if cos <= T::ZERO {
                sigma1.cos * (T::ONE - cos) + sin * sigma1.sin
            } else {
                sin * (sigma1.cos * sin / (T::ONE + cos) + sigma1.sin)
            };
            Angle {
                sin: alpha0.cos * alpha0.sin * along,
                cos: alpha0.sin * alpha0.sin + alpha0.cos * alpha0.cos * sigma1.cos * sigma2.cos,
            }
        };
        let oblateness = if meridional {
            T::ZERO
        } else {
            self.beyond_sphere(alpha0, [sigma1, sigma2])
        };
        self.with_sphere(turn.to_radians(), oblateness)
    }

    /// c²·excess + oblateness: near a pole the first is the area of a wide triangle, however short the line.
    #[inline(always)]
    fn with_sphere(&self, excess: T, oblateness: T) -> DoubleWord<T> {
        let sphere = DoubleWord::product(self.c2, excess);
        DoubleWord {
            low: sphere.low + oblateness,
            ..sphere
        }
    }

    /// 4πc², the area of the ellipsoid.
    #[inline(always)]
    pub(super) fn whole(&self) -> DoubleWord<T> {
        let sphere = DoubleWord::product(self.c2, T::of(4.0 * core::f64::consts::PI));
        // What 4π is more than its nearest number.
        let rest = self.c2 * T::pick(4.898_587_196_589_413e-16, -3.496_911e-7);
        DoubleWord {
            low: sphere.low + rest,
            ..sphere
        }
    }

    /// e²a² cos α₀ sin α₀ (I₄(σ₂) − I₄(σ₁)) (Karney 59).
    fn beyond_sphere(&self, alpha0: Angle<T>, [sigma1, sigma2]: [Angle<T>; 2]) -> T {
        let c4 = self.series.c4(self.epsilon(alpha0));
        let integral = self.series.cosines(&c4, sigma2) - self.series.cosines(&c4, sigma1);
        self.oblateness(alpha0, integral)
    }

    #[inline(always)]
    pub(super) fn epsilon(&self, alpha0: Angle<T>) -> T {
        Integrals::epsilon(alpha0.cos * alpha0.cos * self.karney.ellipsoid().ep2())
    }

    #[inline(always)]
    pub(super) fn oblateness(&self, alpha0: Angle<T>, integral: T) -> T {
        let ellipsoid = self.karney.ellipsoid();
        ellipsoid.a() * ellipsoid.a() * ellipsoid.e2() * (alpha0.cos * alpha0.sin) * integral
    }

    /// Makes a polygon without corners; [`PolygonArea::add`] adds them one by one.
    #[must_use]
    pub fn polygon(&self) -> PolygonArea<'_, T> {
        PolygonArea::new(self)
    }
}

/// A canonical problem and its solution.
pub(super) type Solved<'a, T> = (&'a Canonical<T>, &'a Course<T>);

/// The area of the problem as it was put.
#[inline(always)]
pub(super) fn turned_back<T: Real>(problem: &Canonical<T>, area: DoubleWord<T>) -> DoubleWord<T> {
    let sign = problem.area_sign();
    DoubleWord {
        high: area.high * sign + T::ZERO,
        low: area.low * sign + T::ZERO,
    }
}
