use super::Karney;
use super::angle::Angle;
use super::inverse::{Arc, Canonical};
use super::polygon::PolygonArea;
use super::series::{AreaSeries, Series};
use crate::geodesic::GeodesicError;
use crate::geodesic::degrees::{Split, hypot, longitude_difference};
use crate::latitude::UnsupportedFlattening;
use crate::math::atan2;
use crate::{Ellipsoid, LatLon, Real};

/// Areas between geodesics and the equator, and of polygons. For fields in `f32` there is
/// [`PlanarArea`](crate::geodesic::PlanarArea).
///
/// On the Earth within 0.1 m², within 0.02 m² and 5e-16 of the area for lines under 1000 km (`f32`: 60 km², 0.2 km² and 5e-7; past
/// a pole the area is as large as for any line). Between nearly antipodal places, whose reduced
/// length is under a tenth of the distance, the azimuths and with them the area are ill-conditioned: up to 10⁴ m² was seen.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Area<T> {
    pub(super) karney: Karney<T>,
    series: AreaSeries<T>,
    /// The square of the authalic radius.
    pub(super) c2: T,
}

impl<T: Real> Area<T> {
    /// For an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] outside −1/9 ≤ f ≤ 1/10.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        Karney::new(ellipsoid).map(Self::within)
    }

    /// Under the geodesics of an ellipsoid that is checked with them.
    pub(crate) fn within(karney: Karney<T>) -> Self {
        Self {
            karney,
            series: AreaSeries::new(karney.ellipsoid, &karney.series),
            c2: karney.ellipsoid.authalic_radius_squared(),
        }
    }

    /// The area in m² between the geodesic from one place to another and the equator, positive if the
    /// quadrilateral (from), (0, from's longitude), (0, to's longitude), (to) runs counter-clockwise: where
    /// the geodesic runs eastward to the north of the equator.
    ///
    /// Between opposite meridians it goes over the pole that [`Karney::solve`] takes: eastward to the
    /// longitude that is 180° more, westward to that which is 180° less. A pole has a longitude: between two
    /// places there the area is that of the lune between their meridians, from the pole to the equator.
    #[must_use]
    pub fn under(&self, from: LatLon<T>, to: LatLon<T>) -> T {
        let (_, Split { angle, rest }) = self.edge(from, to);
        angle + rest
    }

    /// The length of a geodesic in metres and the area under it.
    pub(super) fn edge(&self, from: LatLon<T>, to: LatLon<T>) -> (T, Split<T>) {
        let (line, problem, arc) = self.karney.whole(from, to);
        let Split { angle, rest } = match arc.omega {
            Some(omega) => self.beside_meridian(&problem, &arc, omega),
            None => {
                // Between opposite places over either pole; else over the one in the south, or from a pole.
                let opposite = problem.lambda12.sin == T::ZERO && problem.lambda12.cos < T::ZERO;
                let north = opposite && arc.alpha1.cos > T::ZERO;
                self.along_meridian(longitude_difference(from, to), north)
            }
        };
        let sign = problem.area_sign();
        let area = Split {
            angle: angle * sign + T::ZERO,
            rest: rest * sign + T::ZERO,
        };
        (line.distance, area)
    }

    /// All of the turn is at a pole, in the south if it is not said to be in the north: a lune, exactly a
    /// quarter of the ellipsoid between opposite meridians.
    fn along_meridian(&self, difference: Split<T>, north: bool) -> Split<T> {
        let east = T::ONE.copysign(difference.angle);
        let (angle, rest) = (difference.angle * east, difference.rest * east);
        let two_circles = if north { T::of(720.0) } else { T::of(-720.0) };
        let part = angle / two_circles;
        // With what the quotient has lost, for lunes round a pole to fill a hemisphere.
        let back = product(part, two_circles);
        let lost = ((angle - back.angle) + (rest - back.rest)) / two_circles;
        let whole = self.whole();
        let area = product(whole.angle, part);
        Split {
            rest: area.rest + (whole.rest * part + whole.angle * lost),
            ..area
        }
    }

    fn beside_meridian(&self, problem: &Canonical<T>, arc: &Arc<T>, omega: Angle<T>) -> Split<T> {
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
        let excess = if omega.cos > T::of(-0.95) && beta2.sin - beta1.sin < T::of(1.75) {
            // tan(α₁₂/2) from half angles (Karney 63).
            let (d1, d2) = (T::ONE + beta1.cos, T::ONE + beta2.cos);
            let sin = omega.sin * (beta1.sin * d2 + beta2.sin * d1);
            let versine = if omega.cos < T::ZERO {
                omega.sin * omega.sin / (T::ONE - omega.cos)
            } else {
                T::ONE + omega.cos
            };
            let cos = versine * (beta1.sin * beta2.sin + d1 * d2);
            T::of(2.0) * atan2(sin, cos)
        } else {
            alpha2.minus(alpha1).to_radians()
        };
        self.with_sphere(excess, oblateness)
    }

    /// The same for the geodesic that leaves a place at an azimuth in degrees and ends after a distance in
    /// metres, less whole ellipsoids. Over a pole it goes eastward for the azimuths 0 and 180, westward for
    /// −0 and −180.
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
        let Split { angle, rest } = self.with_sphere(turn.to_radians(), oblateness);
        Ok((angle + rest) + T::ZERO)
    }

    /// c²·excess + oblateness: near a pole the first is the area of a wide triangle, however short the line.
    fn with_sphere(&self, excess: T, oblateness: T) -> Split<T> {
        let sphere = product(self.c2, excess);
        Split {
            rest: sphere.rest + oblateness,
            ..sphere
        }
    }

    /// 4πc², the area of the ellipsoid.
    pub(super) fn whole(&self) -> Split<T> {
        let sphere = product(self.c2, T::of(4.0 * core::f64::consts::PI));
        // What 4π is more than its nearest number.
        let rest = self.c2 * T::pick(4.898_587_196_589_413e-16, -3.496_911e-7);
        Split {
            rest: sphere.rest + rest,
            ..sphere
        }
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
        PolygonArea::new(self)
    }
}

/// The product of two numbers, exactly (Dekker).
fn product<T: Real>(x: T, y: T) -> Split<T> {
    let angle = x * y;
    let (xh, xl) = x.split();
    let (yh, yl) = y.split();
    Split {
        angle,
        rest: ((xh * yh - angle) + xh * yl + xl * yh) + xl * yl,
    }
}
