use super::Ellipsoid;
use crate::math::octant_degrees;
use crate::{Ecef, Geodetic, LatLon, Real};

/// Converts Earth-centred points near the surface to latitude, longitude and height by a series: cheaper than
/// [`Ellipsoid::to_geodetic`], and less exact.
///
/// The unknown is the tangent T of the geodetic less the geocentric latitude. With ε = e²a/r, and with the sine
/// S and the cosine C of the geocentric latitude, T = εpq/√(1 + T² − e²p²), where p = S + CT and q = C − ST.
/// The orders are those of T in ε and e².
///
/// Worst error from −0.5 km to 100 km of height, as a displacement of the point:
///
/// | order | Earth, `f64` | of it in height | Mars, `f64` | Earth, `f32` |
/// |---|---|---|---|---|
/// | second | 0.4 m | 0.6 mm | 1.2 m | 1.3 m |
/// | third | 2.5 mm | 3 µm | 11 mm | 1.3 m |
/// | fourth | 0.1 µm | 15 nm | 1.1 µm | 1.3 m |
///
/// What the orders leave grows with the next power of the flattening. Points within 75 e²a of the centre (half
/// of the Earth's radius), on the axis, or beyond squares of the scalar, and all points of ellipsoids with
/// |f| > 1/150, are converted by [`Ellipsoid::to_geodetic`]: the series do not hold there.
///
/// [`batch::ellipsoid`](crate::batch::ellipsoid) has the three orders over slices, and
/// [`Scene::geodetics`](crate::scene::Scene::geodetics) says which is enough.
///
/// ```
/// use terrella::{Ecef, Ellipsoid, GeodeticSeries};
/// let series = GeodeticSeries::new(Ellipsoid::<f64>::WGS84);
/// let greenwich = series.second_order(Ecef::new(3_980_609.2, -102.5, 4_966_860.0)?);
/// assert!((greenwich.lat() - 51.477_81).abs() < 1e-5 && (greenwich.lon() + 0.001_475).abs() < 1e-6);
/// assert!((greenwich.height() - 45.0).abs() < 1.0);
/// # Ok::<(), terrella::InvalidEcef<f64>>(())
/// ```
#[doc(alias = "ecef2geodetic", alias = "ecef2lla")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct GeodeticSeries<T> {
    ellipsoid: Ellipsoid<T>,
}

impl<T: Real> GeodeticSeries<T> {
    /// Creates the series of an ellipsoid.
    #[must_use]
    #[inline(always)]
    pub fn new(ellipsoid: Ellipsoid<T>) -> Self {
        Self { ellipsoid }
    }

    /// Converts a point by the terms of the first and second order.
    #[must_use]
    #[inline]
    pub fn second_order(&self, point: Ecef<T>) -> Geodetic<T> {
        self.convert::<2>(point)
    }

    /// Converts a point by the terms up to the third order.
    #[must_use]
    #[inline]
    pub fn third_order(&self, point: Ecef<T>) -> Geodetic<T> {
        self.convert::<3>(point)
    }

    /// Converts a point by the terms up to the third order and a step toward the solution.
    #[must_use]
    #[inline]
    pub fn fourth_order(&self, point: Ecef<T>) -> Geodetic<T> {
        self.convert::<4>(point)
    }

    /// The conversion of an order.
    #[inline(always)]
    pub(crate) fn convert<const ORDER: usize>(&self, point: Ecef<T>) -> Geodetic<T> {
        if self.holds(point) {
            self.series::<ORDER>(point)
        } else {
            self.ellipsoid.to_geodetic(point)
        }
    }

    /// Whether the series hold for a point.
    #[inline(always)]
    pub(crate) fn holds(&self, point: Ecef<T>) -> bool {
        self.ellipsoid.is_ordinary(point)
    }

    /// The series, for points for which they [hold](Self::holds).
    #[inline(always)]
    pub(crate) fn series<const ORDER: usize>(&self, point: Ecef<T>) -> Geodetic<T> {
        let [x, y, z] = point.to_array();
        let (a, e2) = (self.ellipsoid.a(), self.ellipsoid.e2());
        let (one, half) = (T::ONE, T::of(0.5));
        let across = x * x + y * y;
        let square = across + z * z;
        let (rho, r) = (across.sqrt(), square.sqrt());
        let inverse = one / r;
        // Northern: the latitude takes the sign of z at the end.
        let (s, c) = (z.abs() * inverse, rho * inverse);
        let epsilon = e2 * a * inverse;
        let (ss, cc, m) = (s * s, c * c, s * c);
        let d = cc - ss;
        let squeeze = e2 * ss;
        let ed = epsilon * d;
        let mut sum = ed + half * squeeze;
        if ORDER > 2 {
            let mm = m * m;
            sum += epsilon * (ed * d - T::of(1.5) * epsilon * mm + d * squeeze + e2 * mm)
                + T::of(0.375) * squeeze * squeeze;
        }
        let first = epsilon * m;
        let mut t = first + first * sum;
        if ORDER > 3 {
            let n = m + t * (d - m * t);
            let w = t * (e2 * (m + m + cc * t) - t) + squeeze;
            let u = one + w * (half + w * (T::of(0.375) + w * (T::of(0.3125) + w * T::of(35.0 / 128.0))));
            t += (epsilon * n * u - t) * (one + ed);
        }

        // h = r cos δ − a√(1 − e² sin²φ), and an error of T counts by its square.
        let tt = t * t;
        let q = squeeze + e2 * (t * (m + m + d * t)) * (one - tt);
        let mut tail = T::of(0.0625);
        if ORDER > 3 {
            tail += q * (T::of(5.0 / 128.0) + q * T::of(7.0 / 256.0));
        } else if ORDER > 2 {
            tail += q * T::of(5.0 / 128.0);
        }
        let drop = a * (q * (half + q * (T::of(0.125) + q * tail)));
        let height = (r - a) + (drop - r * tt * (half - T::of(0.375) * tt));

        let lat = octant_degrees(s + c * t, c - s * t).copysign(z);
        let lon = octant_degrees(y.abs(), x).copysign(y);
        Geodetic::within(LatLon::within(lat, lon), height)
    }
}
