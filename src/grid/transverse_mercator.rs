use super::kruger::{self, Coefficients};
use super::{InvalidMap, OutsideMap, PointScale};
use crate::geodesic::{longitude_step, nearly_round};
use crate::latitude::{Correction, Turn};
use crate::math::{
    Polynomial, atan2, atan2_degrees, exp_m1, hypot, inverse_gudermannian, max, select, sin_cos, sin_cos_degrees,
    sin_cos_small,
};
use crate::{Dual, Ellipsoid, LatLon, Real, Shift, Shifted};

/// The ellipsoidal transverse Mercator projection: conformal, and true to scale along its central meridian
/// times a factor.
///
/// Distances are in metres: x to the east of the central meridian, y to the north of the equator. There are no
/// false origins; [`Utm`](super::Utm) has them. National grids add theirs.
///
/// By Krüger's series in the third flattening, to the eighth order (`f32`: the fourth). Worst error on the
/// Earth in metres, of x and y and, as a distance, of the latitude and longitude of [`inverse`](Self::inverse):
///
/// | from the central meridian | `f64` | `f32` |
/// |---|---|---|
/// | 400 km, 3.5° on the equator | 5 nm | 1.9 m |
/// | 3900 km, 35° | 5 nm | 1.9 m |
/// | 6000 km, 52° | 5 nm | 2.2 m |
/// | 8500 km, 65° | 40 nm | 2.2 m |
/// | 10 000 km, 71° | 3 µm | 2.2 m |
///
/// Farther away, next to the equator, the series has no meaning: the exact projection has a branch point at
/// 82.6°. On flatter ellipsoids errors grow sooner: for |f| = 1/60 they are 10 µm (`f32`: 2.2 m) to 45°. In `f32`
/// easting and northing are rounded to 2⁻²⁴ of themselves, which is 0.03 m for 400 km and 0.5 m for 9000 km.
///
/// C. F. F. Karney, *Transverse Mercator with an accuracy of a few nanometers*, J. Geodesy 85 (2011), section 4.
///
/// ```
/// use terrella::grid::TransverseMercator;
/// use terrella::{Ellipsoid, LatLon};
/// // Germany's old grid, third strip, without its false easting.
/// let strip = TransverseMercator::new(Ellipsoid::BESSEL1841, 1.0, 9.0)?;
/// let [x, y] = strip.forward(LatLon::new(50.0_f64, 10.5)?);
/// assert_eq!(format!("{x:.3} {y:.3}"), "107528.402 5541357.896");
/// let place = strip.inverse([x, y])?;
/// assert!((place.lon() - 10.5).abs() < 1e-13);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "Gauss-Krueger")]
#[doc(alias = "etmerc")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TransverseMercator<T> {
    ellipsoid: Ellipsoid<T>,
    scale: T,
    meridian: T,
    /// The scale times the rectifying radius.
    radius: T,
    to_conformal: Correction<T>,
    to_geodetic: Correction<T>,
    alpha: Coefficients<T>,
    beta: Coefficients<T>,
}

/// sinh x = x + x³p(x²) for |x| ≤ 0.12: the next term is 2e-19 of x (`f32`: 4e-11).
const SMALL_SINH: Polynomial<5, 2> = Polynomial {
    f64: [
        1.0 / 6.0,
        1.0 / 120.0,
        1.0 / 5040.0,
        1.0 / 362_880.0,
        1.0 / 39_916_800.0,
    ],
    f32: [1.0 / 6.0, 1.0 / 120.0],
};

/// cosh x − 1 = x²p(x²): the next term is 2e-18 (`f32`: 2e-10).
const SMALL_COSH: Polynomial<5, 2> = Polynomial {
    f64: [1.0 / 2.0, 1.0 / 24.0, 1.0 / 720.0, 1.0 / 40_320.0, 1.0 / 3_628_800.0],
    f32: [1.0 / 2.0, 1.0 / 24.0],
};

impl<T: Real> TransverseMercator<T> {
    /// Makes the projection of an ellipsoid, with the scale on the central meridian, and that meridian's
    /// longitude in degrees. A longitude is brought into range as [`LatLon::new`] does it.
    ///
    /// # Errors
    /// [`InvalidMap`] if |f| > 1/60, the scale is not in [10⁻³, 10³], or the longitude is
    /// infinite or NaN.
    pub fn new(ellipsoid: Ellipsoid<T>, scale: T, meridian: T) -> Result<Self, InvalidMap<T>> {
        let ellipsoid = nearly_round(ellipsoid)?;
        InvalidMap::check_scale(scale)?;
        match LatLon::new(T::ZERO, meridian) {
            Ok(place) => Ok(Self::within(ellipsoid, scale, place.lon())),
            Err(_) => Err(InvalidMap::Meridian(meridian)),
        }
    }

    /// For parameters known to be valid.
    pub(super) fn within(ellipsoid: Ellipsoid<T>, scale: T, meridian: T) -> Self {
        let [to_conformal, to_geodetic] = Shifted::within(ellipsoid, Shift::Conformal).corrections();
        Self {
            ellipsoid,
            scale,
            meridian,
            radius: scale * kruger::rectifying_radius(ellipsoid),
            to_conformal,
            to_geodetic,
            alpha: kruger::forward(ellipsoid),
            beta: kruger::inverse(ellipsoid),
        }
    }

    /// The same projection about another meridian, with a longitude in [−180, 180].
    #[inline(always)]
    pub(super) fn about(&self, meridian: T) -> Self {
        Self { meridian, ..*self }
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Returns the scale on the central meridian.
    #[must_use]
    pub fn scale(&self) -> T {
        self.scale
    }

    /// Returns the longitude of the central meridian in degrees, in [−180, 180].
    #[must_use]
    pub fn meridian(&self) -> T {
        self.meridian
    }

    /// Projects a place: x to the east and y to the north in metres.
    ///
    /// Beyond 90° from the central meridian y runs on over the pole, up to half of a meridian on the other side.
    /// The result is finite everywhere.
    #[must_use]
    #[inline]
    pub fn forward(&self, place: LatLon<T>) -> [T; 2] {
        self.project(&self.to_conformal, [place.lat(), place.lon()])
    }

    /// Returns the place of a point: the inverse of [`forward`](Self::forward).
    ///
    /// # Errors
    /// [`OutsideMap`] unless |x| is at most 2 (on the Earth 12 700 km) and |y| at most 3.2 rectifying radii
    /// times the scale.
    #[inline]
    pub fn inverse(&self, [x, y]: [T; 2]) -> Result<LatLon<T>, OutsideMap<T>> {
        if !self.reaches([x, y]) {
            return Err(OutsideMap { x, y });
        }
        let [lat, lon] = self.unproject(&self.to_geodetic, [x, y]);
        Ok(LatLon::within(lat, lon))
    }

    /// Returns the convergence of meridians and the scale at a place, within 10⁻¹³ (`f32`: 2·10⁻⁵) degrees and
    /// 2·10⁻¹⁵ (6·10⁻⁷) up to 35° from the central meridian.
    ///
    /// At a pole the convergence is that of the meridian that is given with it.
    ///
    /// ```
    /// use terrella::grid::TransverseMercator;
    /// use terrella::{Ellipsoid, LatLon};
    /// let zone = TransverseMercator::new(Ellipsoid::WGS84, 0.9996, 3.0)?;
    /// let here = zone.point_scale(LatLon::new(50.0_f64, 5.0)?);
    /// assert_eq!(format!("{:.6} {:.9}", here.convergence, here.scale), "1.532348 0.999852313");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[doc(alias = "grid declination")]
    pub fn point_scale(&self, place: LatLon<T>) -> PointScale<T> {
        let [lat] = Dual::variables([place.lat()]);
        let dual = Dual::constant;
        let map = TransverseMercator {
            ellipsoid: self.ellipsoid.map(dual),
            scale: dual(self.scale),
            meridian: dual(self.meridian),
            radius: dual(self.radius),
            to_conformal: self.to_conformal.map(dual),
            to_geodetic: self.to_geodetic.map(dual),
            alpha: self.alpha.map(dual),
            beta: self.beta.map(dual),
        };
        let point = map.project(&map.to_conformal, [lat, dual(place.lon())]);
        PointScale::of(self.ellipsoid, place.lat(), point)
    }

    /// The corrections to the conformal latitude, and from it.
    pub(crate) fn corrections(&self) -> [Correction<T>; 2] {
        [self.to_conformal, self.to_geodetic]
    }

    /// Whether a point has a place.
    #[inline(always)]
    pub(crate) fn reaches(&self, [x, y]: [T; 2]) -> bool {
        (x.abs() <= T::of(2.0) * self.radius) & (y.abs() <= T::of(3.2) * self.radius)
    }

    /// x and y of a latitude and a longitude, for any of which the result is finite.
    #[inline(always)]
    pub(crate) fn project(&self, to_conformal: &impl Turn<T>, [lat, lon]: [T; 2]) -> [T; 2] {
        let (sin_chi, cos_chi) = to_conformal.turn(sin_cos_degrees(lat));
        let step = longitude_step(LatLon::within(T::ZERO, self.meridian), LatLon::within(lat, lon));
        let (sin, cos) = step.sin_cos_degrees();
        // On the sphere: ξ′ = atan2(s, c), tanh η′ = t, cosh² η′ = 1/h².
        let (s, c, t) = (sin_chi, cos_chi * cos, cos_chi * sin);
        // 0 at the two points that a sphere has no image of; so far out the series has no meaning.
        let h2 = max(s * s + c * c, T::pick(1e-24, 1e-8));
        let (two, r) = (T::of(2.0), T::ONE / h2);
        let beyond = kruger::sum(
            &self.alpha,
            (two * s * c * r, (c - s) * (c + s) * r),
            (two * t * r, (T::ONE + t * t) * r),
        );
        let xi = atan2(s, c) + beyond.re;
        let eta = inverse_gudermannian((t, h2.sqrt())) + beyond.im;
        [self.radius * eta, self.radius * xi]
    }

    /// Latitude and longitude of a point that the map [`reaches`](Self::reaches).
    #[inline(always)]
    pub(crate) fn unproject(&self, to_geodetic: &impl Turn<T>, [x, y]: [T; 2]) -> [T; 2] {
        let (two, half) = (T::of(2.0), T::of(0.5));
        let (eta, xi) = (x / self.radius, y / self.radius);
        let (s, c) = sin_cos(xi);
        let less = exp_m1(eta);
        let more = T::ONE + less;
        let sinh = half * (less + less / more);
        let versed = half * (less * less / more);
        let cosh = T::ONE + versed;
        let beyond = kruger::sum(
            &self.beta,
            (two * s * c, (c - s) * (c + s)),
            (two * sinh * cosh, T::ONE + two * sinh * sinh),
        );
        // ξ′ and η′ by turning ξ and η through the small differences.
        let (sine, cosine) = sin_cos_small(beyond.re);
        let versine = sine * sine / (T::ONE + cosine);
        let (sin, cos) = (s + (c * sine - s * versine), c - (s * sine + c * versine));
        let (small, square) = (beyond.im, beyond.im * beyond.im);
        let (u, v) = (
            small + small * (square * square.polynomial(&SMALL_SINH)),
            square * square.polynomial(&SMALL_COSH),
        );
        let (sinh, cosh) = (sinh + (cosh * u + sinh * v), cosh + (sinh * u + cosh * v));
        let (sin_phi, cos_phi) = to_geodetic.turn((sin / cosh, hypot(sinh, cos) / cosh));
        let lon = self.meridian + atan2_degrees(sinh, cos);
        let (half_circle, circle) = (T::of(180.0), T::of(360.0));
        let over = select(lon.abs() > half_circle, circle, T::ZERO);
        [atan2_degrees(sin_phi, max(cos_phi, T::ZERO)), lon - over.copysign(lon)]
    }
}
