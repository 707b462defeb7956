use super::Ellipsoid;
use crate::math::{
    atan2, atan2_degrees, cbrt, hypotenuse, max, min, product, product_of_any, select, sin_cos,
    sin_cos_degrees_with_rest, sum, turned_degrees,
};
use crate::position::angle_degrees;
use crate::{Direction, Ecef, Geodetic, LatLon, Real};

impl<T: Real> Ellipsoid<T> {
    /// Returns the Earth-centred point at a geodetic latitude, longitude and height.
    ///
    /// X = (N + h) cos φ cos λ, Y = (N + h) cos φ sin λ, Z = ((1 − e²)N + h) sin φ with N = a/√(1 − e² sin²
    /// φ).
    ///
    /// Worst error on the Earth (everywhere at most 0.82 units in the last place of the radius):
    ///
    /// | height | `f64` | `f32` |
    /// |---|---|---|
    /// | below 100 km | 0.95 nm | 0.5 m |
    /// | 50 000 km | 6 nm | 3.2 m |
    ///
    /// The poles lie exactly on the axis, and multiples of 90° of longitude exactly on the axes and planes.
    ///
    /// ```
    /// use terrella::{Ellipsoid, Geodetic, LatLon};
    /// let greenwich = Geodetic::new(LatLon::new(51.477_811, -0.001_475)?, 45.0)?;
    /// let [x, y, z] = Ellipsoid::WGS84.to_ecef(greenwich).to_array();
    /// assert!((x - 3_980_609.0_f64).abs() < 1.0 && (y + 102.0).abs() < 1.0);
    /// assert!((z - 4_966_860.0).abs() < 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "geodetic2ecef", alias = "lla2ecef")]
    #[must_use]
    #[inline]
    pub fn to_ecef(self, position: Geodetic<T>) -> Ecef<T> {
        self.to_ecef_inline(position)
    }

    /// [`Self::to_ecef`], for loops.
    #[inline(always)]
    pub(crate) fn to_ecef_inline(self, position: Geodetic<T>) -> Ecef<T> {
        let [(sin, cos), (sin_rest, cos_rest)] = sin_cos_degrees_with_rest(position.lat());
        let [(sin_lon, cos_lon), (sin_lon_rest, cos_lon_rest)] = sin_cos_degrees_with_rest(position.lon());
        let e2 = self.e2();
        // N = a + excess, and the excess is small: a + h is what rounds, and what it loses is kept.
        let w = (T::ONE - e2 * sin * sin).sqrt();
        let excess = self.a * e2 * sin * sin / (w * (T::ONE + w));
        let (base, lost) = sum(self.a, position.height());
        let (along, along_lost) = sum(base, excess);
        let (axial, axial_lost) = sum(base, excess - e2 * (self.a + excess));
        let (rho, rho_lost) = product_of_any(along, cos);
        let rho_lost = rho_lost + (along_lost + lost) * cos + along * cos_rest;
        Ecef::within(
            long_product((rho, rho_lost), (cos_lon, cos_lon_rest)),
            long_product((rho, rho_lost), (sin_lon, sin_lon_rest)),
            long_product((axial, axial_lost + lost), (sin, sin_rest)),
        )
    }

    /// Returns the latitude and longitude of the nearest point of the ellipsoid, and the signed distance from
    /// it as height.
    ///
    /// It finds the nearest point for every input: the geocentre, the axis, the plane of the equator, and
    /// inside the evolute (the surface of the centres of curvature, within 43 km of the Earth's centre).
    /// Inputs from the smallest to the largest numbers are allowed. A height too large for the scalar is
    /// returned as its largest number.
    ///
    /// If several points are equally near, it returns
    ///
    /// * on an oblate ellipsoid, in the plane of the equator inside the evolute: the northern one. So the
    ///   geocentre is at latitude 90 and height −b.
    /// * on a prolate ellipsoid, on the axis inside the evolute: the one at longitude 0. So the geocentre is
    ///   at 0° N, 0° E and height −a.
    /// * at the centre of a sphere: the one at latitude 90.
    ///
    /// On the axis, the longitude is 0.
    ///
    /// Worst error on the Earth, as a displacement of the point:
    ///
    /// | where | `f64` | `f32` |
    /// |---|---|---|
    /// | below 100 km, down to the geocentre | 2.2 nm | 1.2 m |
    /// | at 50 000 km | 16 nm | 8.5 m |
    /// | height alone, between −100 km and 100 km | 10 pm | 5 mm |
    /// | place on the ground, within 60 km of the centre | 5 nm | 3.5 m |
    ///
    /// Most of it is the last place of the angles. The height alone is within 1.2 ulp elsewhere. On the
    /// evolute itself, any error moves the latitude by its square root, but the point found is as near as the
    /// nearest. These errors hold for axes within a factor of 100 of each other.
    ///
    /// A series in e²a/r and one step of Newton's method, in a straight line, lead from the geocentric to the
    /// geodetic latitude. Where they are not enough (within 75 e²a of the Earth's centre, which is half of its
    /// radius; on the axis; and everywhere for ellipsoids flatter than about 1/150), the quartic of Vermeille
    /// (J. Geodesy 76, 2002; 85, 2011) as solved by Karney is used instead, out of line and twice as slow.
    ///
    /// ```
    /// use terrella::{Ecef, Ellipsoid};
    /// let earth = Ellipsoid::<f64>::WGS84;
    /// let moon = earth.to_geodetic(Ecef::new(363_300e3, 0.0, 0.0)?);
    /// assert_eq!((moon.lat(), moon.lon(), moon.height()), (0.0, 0.0, 356_921_863.0));
    /// let centre = earth.to_geodetic(Ecef::new(0.0, 0.0, 0.0)?);
    /// assert_eq!((centre.lat(), centre.height()), (90.0, -earth.b()));
    /// # Ok::<(), terrella::InvalidEcef<f64>>(())
    /// ```
    #[doc(alias = "ecef2geodetic", alias = "ecef2lla")]
    #[must_use]
    #[inline]
    pub fn to_geodetic(self, point: Ecef<T>) -> Geodetic<T> {
        if self.is_ordinary(point) {
            self.to_geodetic_ordinary(point)
        } else {
            self.to_geodetic_rare(point)
        }
    }

    /// Whether the straight line holds for a point: e² and e²a/r are at most 1/75.
    #[inline(always)]
    pub(crate) fn is_ordinary(self, point: Ecef<T>) -> bool {
        let [x, y, z] = point.to_array();
        let across = x * x + y * y;
        let square = across + z * z;
        let most = T::of(75.0);
        let inner = self.e2() * self.a * most;
        (square > inner * inner)
            & (self.e2().abs() * most < T::ONE)
            & (across > T::pick(1e-250, 1e-30))
            & (square < T::pick(1e300, 1e36))
    }

    /// [`Self::to_geodetic`] in a straight line.
    ///
    /// With r, S, C the distance from the centre, the sine and cosine of the geocentric latitude, and T the
    /// tangent of the geodetic less the geocentric latitude: T = εpq/√(1 + T² − e²p²), where ε = e²a/r, p = S +
    /// CT and q = C − ST. All but S and C is small: the terms to the third order in ε and e², then one step of
    /// Newton's method.
    #[inline(always)]
    pub(crate) fn to_geodetic_ordinary(self, point: Ecef<T>) -> Geodetic<T> {
        let [x, y, z] = point.to_array();
        let (one, two, half) = (T::ONE, T::of(2.0), T::of(0.5));
        let e2 = self.e2();
        let [(xx, xx_lost), (yy, yy_lost), (zz, zz_lost)] = [x, y, z].map(|v| product(v, v));
        let (across, across_lost) = sum(xx, yy);
        let (square, square_lost) = sum(across, zz);
        let rho = across.sqrt();
        let r = square.sqrt();
        let inverse = one / r;
        // Northern: the latitude takes the sign of z at the end.
        let (s, c) = (z.abs() * inverse, rho * inverse);
        let epsilon = e2 * self.a * inverse;
        let (ss, cc, m) = (zz / square, c * c, s * c);
        let (d, mm) = (cc - ss, m * m);

        // w = √(1 − e² sin²) of the geocentric latitude.
        let squeeze = e2 * ss;
        let w = (one - squeeze).sqrt();
        let v = one / w;
        let vv = v * v;

        let ed = epsilon * d;
        let third =
            epsilon * (ed * d - T::of(1.5) * epsilon * mm + d * squeeze + e2 * mm) + T::of(0.375) * squeeze * squeeze;
        let t = epsilon * m * (one + ((ed + half * squeeze) + third));
        // g(T) − T and g′(T).
        let n = m + t * (d - m * t);
        let pc = m + cc * t;
        let rest = t * (t - e2 * (m + pc)) * vv;
        let u = v - v * rest * (half - T::of(0.375) * rest);
        let g = epsilon * n * u;
        let slope = epsilon * u * ((d - two * m * t) - m * (t - e2 * pc));
        let t1 = t + (g - t) / (one - slope);
        let tt = t1 * t1;
        let turn = t1 - t1 * tt * (T::of(1.0 / 3.0) - T::of(0.2) * tt);
        let [lat, lon] = [turned_degrees(z, rho, turn), turned_degrees(y, x, T::ZERO)];

        // h = r cos δ − a√(1 − e² sin²φ), and an error of T counts by its square.
        let (back, back_lost) = product(r, r);
        let lost = (square - back) + (square_lost + across_lost + (xx_lost + yy_lost + zz_lost) - back_lost);
        let tt = t * t;
        let sag = tt * (half - tt * (T::of(0.375) - T::of(0.3125) * tt));
        let shift = e2 * vv * (t * (m + m + d * t)) * (one - tt * (one - tt));
        let bend = w * shift * (half + shift * (T::of(0.125) + T::of(0.0625) * shift));
        let drop = self.a * (squeeze / (one + w) + bend) - r * sag;
        let height = (r - self.a) + (drop + lost * (half * inverse));
        Geodetic::within(LatLon::within(lat, lon), height)
    }

    /// The direction to P from the centre of curvature that belongs to a latitude (Bowring, Survey Review 23,
    /// 1976): Newton's method, were it for one unknown.
    #[inline(always)]
    fn step(self, rho: T, z: T, (sin, cos): (T, T)) -> (T, T) {
        let axes = T::ONE - self.f;
        let reach = self.e2() * self.a;
        // Parametric latitude β; the centre of curvature is (e²a cos³ β, −e²a²/b sin³ β).
        let sin = sin * axes;
        let inverse = T::ONE / (sin * sin + cos * cos).sqrt();
        let (s, c) = (sin * inverse, cos * inverse);
        (z + reach / axes * (s * s * s), rho - reach * (c * c * c))
    }

    /// Latitude in degrees and height, from the sine and cosine of the latitude but for a common factor.
    ///
    /// h = ρ cos φ + z sin φ − a√(1 − e² sin² φ): an error of φ counts by its square, and what each operation
    /// on large numbers loses is added back.
    #[inline(always)]
    fn settle(self, (rho, rho_lost): (T, T), z: T, sin: T, cos: T) -> (T, T) {
        let lat = atan2_degrees(sin, cos);
        let inverse = T::ONE / (sin * sin + cos * cos).sqrt();
        let (s, c) = (sin * inverse, cos * inverse);
        // (c, s) has the length 1 + d/2.
        let (cc, cc_lost) = product(c, c);
        let (ss, ss_lost) = product(s, s);
        let (one, one_lost) = sum(cc, ss);
        let d = (one - T::ONE) + (one_lost + cc_lost + ss_lost);
        let (out, out_lost) = product(rho, c);
        let (rise, rise_lost) = product(z, s);
        let (reach, reach_lost) = sum(out, rise);
        let lost = reach_lost + out_lost + rise_lost + rho_lost * c - T::of(0.5) * d * reach;
        let e2ss = self.e2() * (ss - ss * d);
        let w = (T::ONE - e2ss).sqrt();
        let height = (reach - self.a) + (self.a * e2ss / (T::ONE + w) + lost);
        (lat, height)
    }

    /// What [`Self::to_geodetic`] leaves: near the centre, on the axis, very far, or where squares leave the
    /// scalar's range.
    #[cold]
    #[inline(never)]
    fn to_geodetic_rare(self, point: Ecef<T>) -> Geodetic<T> {
        let [x, y, z] = point.to_array();
        let lon = angle_degrees(y, x);
        let north = Direction::within(T::ZERO, T::ZERO, T::ONE);
        let largest = T::pick(f64::MAX, f32::MAX);
        // In units of a, where its powers leave the scalar's range.
        let bounds = T::pick(1e60, 1e9);
        let sane = (self.a < bounds) & (self.a * bounds > T::ONE);
        let metre = select(sane, T::ONE, self.a);
        let unit = Self {
            a: self.a / metre,
            f: self.f,
        };
        let [u, v, w] = [x / metre, y / metre, z / metre];
        let extent = max(max(u.abs(), v.abs()), w.abs());
        let sized = extent <= unit.a * T::pick(1e20, 1e8);
        if !sized {
            // Seen from there the ellipsoid is a point. Halved, the distance does not overflow.
            let half = T::of(0.5);
            let d = Direction::new(x, y, z).unwrap_or(north);
            let distance = x * half * d.x() + y * half * d.y() + z * half * d.z();
            let height = min(distance, largest * half) * T::of(2.0);
            return Geodetic::within(LatLon::within(atan2_degrees(d.z(), d.cos_lat()), lon), height);
        }
        let (rho, rho_lost) = hypotenuse(u, v);
        let square = rho * rho + w * w;
        let (sin, cos) = if self.e2().abs() < T::EPSILON * T::of(0.0625) {
            // A sphere, or nothing that could be told from one.
            let d = Direction::new(u, v, w).unwrap_or(north);
            (d.z(), d.cos_lat())
        } else {
            let exact = unit.normal_by_quartic(rho, w);
            let polished = unit.step(rho, w, exact);
            let reach = unit.a * self.e2().abs() / min(T::ONE, T::ONE - self.f);
            let outside = square > T::of(16.0) * reach * reach;
            select(outside & (square > T::pick(1e-250, 1e-30)), polished, exact)
        };
        let (lat, height) = unit.settle((rho, rho_lost), w, sin, cos);
        let height = max(min(height * metre, largest), -largest);
        Geodetic::within(LatLon::within(lat, lon), height)
    }

    /// Sine and cosine of the latitude but for a common factor, inside the evolute or not.
    fn normal_by_quartic(self, rho: T, z: T) -> (T, T) {
        let axes = T::ONE - self.f;
        let oblate = self.f > T::ZERO;
        let reach = self.a * self.e2().abs();
        // In units of the evolute, whose cusps are then at 1; x along the axis on which feet tie.
        let (x, y) = (rho / reach, axes * z.abs() / reach);
        let (x, y) = select(oblate, (x, y), (y, x));
        let (p, q) = (x * x, y * y);
        let (sin, cos) = if q < T::pick(1e-290, 1e-30) && x <= T::ONE {
            let across = ((T::ONE - x) * (T::ONE + x)).sqrt();
            select(oblate, (across / axes, x), (x / axes, across))
        } else {
            let k = astroid(p, q);
            // Far away, z k would leave the scalar's range.
            let part = k / (k + T::ONE);
            select(oblate, (z.abs(), rho * part), (z.abs() * part, rho))
        };
        (select(z < T::ZERO, -sin, sin), cos)
    }
}

/// The positive root of k⁴ + 2k³ − (p + q − 1)k² − 2qk − q = 0, by its resolvent cubic (Karney, Algorithms
/// for geodesics, 2013, Eq. 55 and appendix B, where it solves another problem); the cubic is scaled so that
/// nothing overflows.
fn astroid<T: Real>(p: T, q: T) -> T {
    let scale = max(max(p, q), T::ONE);
    let (ps, qs) = (p / scale, q / scale);
    let r = (ps + qs - T::ONE / scale) / T::of(6.0);
    let s = T::of(0.25) * ps * qs / scale;
    let r3 = r * r * r;
    let discriminant = s * (r3 + r3 + s);
    let u = if discriminant >= T::ZERO {
        // One real root; the sign that does not cancel.
        let t3 = s + r3;
        let t = cbrt(t3 + discriminant.sqrt().copysign(t3));
        r + select(t == T::ZERO, T::ZERO, t + r * r / t)
    } else {
        let angle = atan2((-discriminant).sqrt(), -(s + r3));
        let (_, cos) = sin_cos(angle / T::of(3.0));
        r + T::of(2.0) * r * cos
    };
    let v = (u * u + qs / scale).sqrt();
    let sum = if u < T::ZERO { qs / scale / (v - u) } else { u + v };
    let w = max(T::ZERO, (sum - qs) / (v + v));
    let sum = sum * scale;
    sum / ((sum + w * w).sqrt() + w)
}

/// The product of two numbers, each a sum of two.
#[inline(always)]
fn long_product<T: Real>((value, low): (T, T), (factor, rest): (T, T)) -> T {
    let (high, rounding) = product_of_any(value, factor);
    high + (rounding + (low * factor + value * rest))
}
