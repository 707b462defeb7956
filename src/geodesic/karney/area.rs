use super::Karney;
use super::angle::{Angle, hypot};
use super::inverse::{Canonical, tiny};
use super::series::{AreaSeries, Series};
use crate::geodesic::GeodesicError;
use crate::geodesic::degrees::Split;
use crate::latitude::UnsupportedFlattening;
use crate::math::atan2;
use crate::{Ellipsoid, LatLon, Real};

/// Areas between geodesics and the equator, and of polygons.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Area<T> {
    karney: Karney<T>,
    series: AreaSeries<T>,
    /// The square of the authalic radius.
    c2: T,
}

impl<T: Real> Area<T> {
    /// For an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] outside −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let karney = Karney::new(ellipsoid)?;
        Ok(Self {
            karney,
            series: AreaSeries::new(ellipsoid, &karney.series),
            c2: ellipsoid.authalic_radius_squared(),
        })
    }

    /// The area in m² between the geodesic from one place to another and the equator, positive if the quadrilateral (from), (0, from's longitude),
    /// (0, to's longitude), (to) runs counter-clockwise.
    #[must_use]
    pub fn under(&self, from: LatLon<T>, to: LatLon<T>) -> T {
        let problem = Canonical::new(&self.karney, from, to);
        let arc = problem.solve(&self.karney);
        let (beta1, beta2) = (problem.beta1, problem.beta2);
        let (alpha1, alpha2) = (arc.alpha1, arc.alpha2);
        let alpha0 = Angle {
            sin: alpha1.sin * beta1.cos,
            cos: hypot(alpha1.cos, alpha1.sin * beta1.sin),
        };
        let oblateness = if alpha0.sin == T::ZERO || alpha0.cos == T::ZERO {
            T::ZERO
        } else {
            let sigma1 = Angle::of(beta1.sin, alpha1.cos * beta1.cos);
            let sigma2 = Angle::of(beta2.sin, alpha2.cos * beta2.cos);
            self.beyond_sphere(alpha0, sigma1, sigma2)
        };
        let near = |omega: &Angle<T>| omega.cos > T::of(-0.95) && beta2.sin - beta1.sin < T::of(1.75);
        let excess = match arc.omega.filter(near) {
            // tan(α₁₂/2) from half angles (Karney 63).
            Some(omega) => {
                let (d1, d2) = (T::ONE + beta1.cos, T::ONE + beta2.cos);
                let sin = omega.sin * (beta1.sin * d2 + beta2.sin * d1);
                let versine = if omega.cos < T::ZERO {
                    omega.sin * omega.sin / (T::ONE - omega.cos)
                } else {
                    T::ONE + omega.cos
                };
                let cos = versine * (beta1.sin * beta2.sin + d1 * d2);
                T::of(2.0) * atan2(sin, cos)
            }
            None => {
                let mut turn = alpha2.minus(alpha1);
                // A half turn whose sign is lost: that of the way out.
                if turn.sin == T::ZERO && turn.cos < T::ZERO {
                    turn = Angle {
                        sin: tiny::<T>() * alpha1.cos,
                        cos: -T::ONE,
                    };
                }
                turn.to_radians()
            }
        };
        self.with_sphere(excess, oblateness) * problem.area_sign() + T::ZERO
    }

    /// The same for the geodesic that leaves a place at an azimuth in degrees and ends after a distance in metres.
    ///
    /// # Errors
    /// As for [`Line::at`](super::Line::at).
    pub fn under_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<T, GeodesicError<T>> {
        let line = self.karney.line(from, azimuth)?;
        let place = line.place(distance)?;
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
            self.beyond_sphere(alpha0, sigma1, sigma2)
        };
        Ok(self.with_sphere(turn.to_radians(), oblateness) + T::ZERO)
    }

    /// c²·excess + oblateness, rounded once: near a pole the first is the area of a wide triangle, however short the line.
    fn with_sphere(&self, excess: T, oblateness: T) -> T {
        let product = self.c2 * excess;
        let (ch, cl) = self.c2.split();
        let (eh, el) = excess.split();
        let lost = ((ch * eh - product) + ch * el + cl * eh) + cl * el;
        product + (lost + oblateness)
    }

    /// e²a² cos α₀ sin α₀ (I₄(σ₂) − I₄(σ₁)) (Karney 59).
    fn beyond_sphere(&self, alpha0: Angle<T>, sigma1: Angle<T>, sigma2: Angle<T>) -> T {
        let ellipsoid = self.karney.ellipsoid;
        let epsilon = Series::epsilon(alpha0.cos * alpha0.cos * ellipsoid.ep2());
        let c4 = self.series.c4(epsilon);
        let integral = self.series.cosines(&c4, sigma2) - self.series.cosines(&c4, sigma1);
        ellipsoid.a() * ellipsoid.a() * ellipsoid.e2() * (alpha0.cos * alpha0.sin) * integral
    }

    /// A polygon whose corners are added one by one.
    #[must_use]
    pub fn polygon(&self) -> PolygonArea<'_, T> {
        PolygonArea {
            area: self,
            first: None,
            last: None,
            under: Sum::default(),
            perimeter: Sum::default(),
            crossings: 0,
        }
    }
}

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
    /// How often the edges have crossed the meridian 0, counted with sign.
    crossings: i32,
}

impl<T: Real> PolygonArea<'_, T> {
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
        if closed.crossings % 2 != 0 {
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
        self.crossings += crossing(from.lon(), to.lon());
    }
}

/// 1 or −1 if the shortest way from one longitude to another crosses the meridian 0 eastward or westward.
fn crossing<T: Real>(from: T, to: T) -> i32 {
    let circle = T::of(360.0);
    let difference = to - from;
    let east = if difference > T::of(180.0) {
        difference - circle
    } else if difference <= T::of(-180.0) {
        difference + circle
    } else {
        difference
    };
    if from < T::ZERO && to >= T::ZERO && east > T::ZERO {
        1
    } else if from >= T::ZERO && to < T::ZERO && east < T::ZERO {
        -1
    } else {
        0
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
