use super::{Hemisphere, InvalidMap, OutsideMap, PointScale};
use crate::latitude::{Correction, Turn};
use crate::math::{atan2_degrees, exp_m1, hypot, max, select, sin_cos_degrees};
use crate::{Dual, Ellipsoid, LatLon, Real, Shift, Shifted};

/// The polar stereographic projection of the ellipsoid: conformal, about a pole.
///
/// Distances are in metres from the pole. About the north pole y runs along the meridian of 180°, about the
/// south pole along that of 0°; x runs along that of 90° E. There are no false origins; [`Ups`](super::Ups) has
/// them.
///
/// Worst error on the Earth: 2 nm (`f32`: 1.2 m) up to 2000 km from the pole, 4·10⁻¹⁶ (2·10⁻⁷) of the distance
/// from it farther out; the other way 3 nm (1.5 m) on the ground.
///
/// J. P. Snyder, *Map Projections: A Working Manual* (1987), eqs. 21-30 to 21-40.
///
/// ```
/// use terrella::grid::{Hemisphere, PolarStereographic};
/// use terrella::{Ellipsoid, LatLon};
/// // Snyder's example (page 315): true to scale at 71° S, so 0.97277 at the pole; 150° E less 100° W.
/// let map = PolarStereographic::new(Ellipsoid::<f64>::INTERNATIONAL1924, 0.972_769_012_89)?;
/// let [x, y] = map.forward(Hemisphere::South, LatLon::new(-75.0, 250.0)?);
/// assert_eq!(format!("{x:.0} {y:.0}"), "-1540034 -560526");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "stere")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PolarStereographic<T> {
    ellipsoid: Ellipsoid<T>,
    scale: T,
    /// The distance from the pole, divided by tan(π/4 − χ/2).
    radius: T,
    to_conformal: Correction<T>,
    to_geodetic: Correction<T>,
}

impl<T: Real> PolarStereographic<T> {
    /// Makes the projection of an ellipsoid, with the scale at the pole.
    ///
    /// # Errors
    /// [`InvalidMap`] if the third flattening is outside of ±1/19, or the scale is not in [10⁻³, 10³].
    pub fn new(ellipsoid: Ellipsoid<T>, scale: T) -> Result<Self, InvalidMap<T>> {
        Shifted::new(ellipsoid, Shift::Conformal)?;
        InvalidMap::check_scale(scale)?;
        Ok(Self::within(ellipsoid, scale))
    }

    /// For parameters known to be valid.
    pub(super) fn within(ellipsoid: Ellipsoid<T>, scale: T) -> Self {
        let [to_conformal, to_geodetic] = Shifted::within(ellipsoid, Shift::Conformal).corrections();
        // 2k₀a/√((1 + e)¹⁺ᵉ(1 − e)¹⁻ᵉ) = 2k₀a exp(−e atanh e)/(1 − f).
        let e2 = ellipsoid.e2();
        let terms = (0..T::terms(22, 9)).rev();
        let ratio = terms.fold(T::ZERO, |sum, k| sum * e2 + T::ONE / T::whole(2 * k as u64 + 1));
        let radius = T::of(2.0) * scale * ellipsoid.a() / (T::ONE - ellipsoid.f());
        Self {
            ellipsoid,
            scale,
            radius: radius + radius * exp_m1(-(e2 * ratio)),
            to_conformal,
            to_geodetic,
        }
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Returns the scale at the pole.
    #[must_use]
    pub fn scale(&self) -> T {
        self.scale
    }

    /// Projects a place about the pole of a hemisphere: x and y in metres.
    ///
    /// The place may be in the other hemisphere too. The other pole is infinitely far; its result is finite and
    /// has no meaning.
    #[must_use]
    #[inline]
    pub fn forward(&self, about: Hemisphere, place: LatLon<T>) -> [T; 2] {
        self.project(&self.to_conformal, about, [place.lat(), place.lon()])
    }

    /// Returns the place of a point about the pole of a hemisphere: the inverse of [`forward`](Self::forward).
    /// The longitude of the pole itself is 0.
    ///
    /// # Errors
    /// [`OutsideMap`] unless |x| and |y| are at most 10¹⁴ (`f32`: 10⁸) times the axis and the scale.
    #[inline]
    pub fn inverse(&self, about: Hemisphere, [x, y]: [T; 2]) -> Result<LatLon<T>, OutsideMap<T>> {
        if !self.reaches([x, y]) {
            return Err(OutsideMap { x, y });
        }
        let [lat, lon] = self.unproject(&self.to_geodetic, about, [x, y]);
        Ok(LatLon::within(lat, lon))
    }

    /// Returns the convergence of meridians and the scale at a place. Worst error 10⁻¹³ (`f32`: 2·10⁻⁵) degrees
    /// and 10⁻¹⁵ (5·10⁻⁷) within 2000 km of the pole.
    ///
    /// About the north pole the convergence is the longitude, about the south pole the longitude the other way
    /// round; at a pole, that of the meridian that is given with it.
    #[must_use]
    pub fn point_scale(&self, about: Hemisphere, place: LatLon<T>) -> PointScale<T> {
        let [lat] = Dual::variables([place.lat()]);
        let dual = Dual::constant;
        let map = PolarStereographic {
            ellipsoid: self.ellipsoid.map(dual),
            scale: dual(self.scale),
            radius: dual(self.radius),
            to_conformal: self.to_conformal.map(dual),
            to_geodetic: self.to_geodetic.map(dual),
        };
        let point = map.project(&map.to_conformal, about, [lat, dual(place.lon())]);
        PointScale::of(self.ellipsoid, place.lat(), point)
    }

    /// The corrections to the conformal latitude, and from it.
    pub(crate) fn corrections(&self) -> [Correction<T>; 2] {
        [self.to_conformal, self.to_geodetic]
    }

    /// Whether a point has a place.
    #[inline(always)]
    pub(crate) fn reaches(&self, [x, y]: [T; 2]) -> bool {
        let limit = T::pick(5e13, 5e7) * self.radius;
        (x.abs() <= limit) & (y.abs() <= limit)
    }

    /// x and y of a latitude and a longitude.
    #[inline(always)]
    pub(crate) fn project(&self, to_conformal: &impl Turn<T>, about: Hemisphere, [lat, lon]: [T; 2]) -> [T; 2] {
        let sign = about.sign::<T>();
        let (sin, cos) = to_conformal.turn(sin_cos_degrees(lat * sign));
        let (sin_lon, cos_lon) = sin_cos_degrees(lon);
        // tan(π/4 − χ/2) = cos χ/(1 + sin χ), on the other hemisphere (1 − sin χ)/cos χ.
        let near = sin >= T::ZERO;
        let more = T::ONE + sin.abs();
        // The other pole stays as far as the inverse goes.
        let cos = select(near, cos, max(cos, T::pick(4e-14, 4e-8)));
        let rho = self.radius * (select(near, cos, more) / select(near, more, cos));
        [rho * sin_lon, -(rho * cos_lon * sign)]
    }

    /// Latitude and longitude of a point that the map [`reaches`](Self::reaches).
    #[inline(always)]
    pub(crate) fn unproject(&self, to_geodetic: &impl Turn<T>, about: Hemisphere, [x, y]: [T; 2]) -> [T; 2] {
        let sign = about.sign::<T>();
        let t = hypot(x / self.radius, y / self.radius);
        let square = t * t;
        let more = T::ONE + square;
        let (sin, cos) = to_geodetic.turn(((T::ONE - t) * (T::ONE + t) / more, (t + t) / more));
        [
            atan2_degrees(sin, max(cos, T::ZERO)) * sign,
            // At the pole itself −y may be −0, whose angle is 180.
            atan2_degrees(x, T::ZERO - y * sign),
        ]
    }
}
