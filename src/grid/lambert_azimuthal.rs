use super::{NotOnMap, OutsideMap};
use crate::geodesic::{latitude_difference, longitude_step};
use crate::latitude::{Correction, Turn, UnsupportedFlattening};
use crate::math::{atan2_degrees, hypot, max, select, sin_cos_degrees, sin_cos_small};
use crate::{Ellipsoid, LatLon, Real, Shift, Shifted};

/// Lambert's azimuthal equal-area projection of the ellipsoid about a centre.
///
/// x is to the east and y to the north, in metres. Areas on the map are areas on the ellipsoid, everywhere. The
/// authalic latitude becomes that of the sphere; x and y are scaled by D and 1/D, so that the map is true to
/// scale at the centre.
///
/// Worst error on the Earth: of x and y 6·10⁻¹⁶ (`f32`: 4·10⁻⁷) of the distance from the centre and 1 nm
/// (0.5 mm), up to 120° from it; of a place 5 nm (2 m) up to 8000 km.
///
/// J. P. Snyder, *Map Projections: A Working Manual* (1987), eqs. 24-17 to 24-26; EPSG's method 9820.
///
/// ```
/// use terrella::grid::LambertAzimuthal;
/// use terrella::{Ellipsoid, LatLon};
/// // EPSG's guidance note 7-2, ETRS89-LAEA Europe: false easting 4 321 000 m, northing 3 210 000 m.
/// let europe = LambertAzimuthal::new(Ellipsoid::GRS80, LatLon::new(52.0_f64, 10.0)?)?;
/// let [x, y] = europe.forward(LatLon::new(50.0, 5.0)?)?;
/// assert_eq!(format!("{:.2} {:.2}", x + 4_321_000.0, y + 3_210_000.0), "3962799.45 2999718.85");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "laea")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct LambertAzimuthal<T> {
    ellipsoid: Ellipsoid<T>,
    centre: LatLon<T>,
    to_authalic: Correction<T>,
    to_geodetic: Correction<T>,
    /// Sine and cosine of the centre's authalic latitude.
    beta: (T, T),
    /// The authalic latitude less the geodetic one at the centre, in radians.
    beyond: T,
    radius: T,
    d: T,
}

impl<T: Real> LambertAzimuthal<T> {
    /// Makes the projection of an ellipsoid about a centre.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the third flattening is outside of ±1/19.
    pub fn new(ellipsoid: Ellipsoid<T>, centre: LatLon<T>) -> Result<Self, UnsupportedFlattening<T>> {
        let [to_authalic, to_geodetic] = Shifted::new(ellipsoid, Shift::Authalic)?.corrections();
        let (sin, cos) = sin_cos_degrees(centre.lat());
        // D is the limit at the poles, where it is 1.
        let cos = max(cos, T::pick(1e-150, 1e-18));
        let beta = to_authalic.turn((sin, cos));
        let radius = ellipsoid.authalic_radius();
        let e2 = ellipsoid.e2();
        let (_, cos_beta) = beta;
        Ok(Self {
            ellipsoid,
            centre,
            to_authalic,
            to_geodetic,
            beta,
            beyond: to_authalic.angle(doubled((sin, cos))),
            radius,
            d: ellipsoid.a() / radius * (cos / cos_beta) / (T::ONE - e2 * (sin * sin)).sqrt(),
        })
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.ellipsoid
    }

    /// Returns the centre.
    #[must_use]
    pub fn centre(&self) -> LatLon<T> {
        self.centre
    }

    /// Projects a place: x to the east and y to the north in metres.
    ///
    /// # Errors
    /// [`NotOnMap`] for the centre's antipode, which is a whole circle on the map, and places within 10⁻⁷
    /// (`f32`: 10⁻³) radians of it.
    #[inline]
    pub fn forward(&self, place: LatLon<T>) -> Result<[T; 2], NotOnMap<T>> {
        let (point, found) = self.project(&self.to_authalic, [place.lat(), place.lon()]);
        if found { Ok(point) } else { Err(NotOnMap(place)) }
    }

    /// Returns the place of a point: the inverse of [`forward`](Self::forward).
    ///
    /// # Errors
    /// [`OutsideMap`] if the point is outside the map, whose edge is nearly a circle of two authalic radii.
    #[inline]
    pub fn inverse(&self, [x, y]: [T; 2]) -> Result<LatLon<T>, OutsideMap<T>> {
        let ([lat, lon], found) = self.unproject(&self.to_geodetic, [x, y]);
        if found {
            Ok(LatLon::within(lat, lon))
        } else {
            Err(OutsideMap { x, y })
        }
    }

    /// The corrections to the authalic latitude, and from it.
    pub(crate) fn corrections(&self) -> [Correction<T>; 2] {
        [self.to_authalic, self.to_geodetic]
    }

    /// x and y of a latitude and a longitude, and whether the map has them.
    #[inline(always)]
    pub(crate) fn project(&self, to_authalic: &impl Turn<T>, [lat, lon]: [T; 2]) -> ([T; 2], bool) {
        let two = T::of(2.0);
        let place = LatLon::within(lat, lon);
        let latitude = sin_cos_degrees(lat);
        let (sin_beta, cos_beta) = to_authalic.turn(latitude);
        let (sin_beta0, cos_beta0) = self.beta;
        let (sin_half, cos_half) = longitude_step(self.centre, place).half().sin_cos_degrees();
        // The difference of the authalic latitudes from that of the geodetic ones: next to the centre no digits
        // are lost.
        let (sin, cos) = latitude_difference(self.centre, place).sin_cos_degrees();
        let (sine, cosine) = sin_cos_small(to_authalic.angle(doubled(latitude)) - self.beyond);
        let versine = sine * sine / (T::ONE + cosine);
        let sin = sin + (cos * sine - sin * versine);
        // 1 + cos c = (1 − cos(β + β₀)) + 2 cos β₀ cos β cos² λ/2, without a difference of numbers that are nearly
        // equal.
        let (product, sum) = (cos_beta * cos_beta0, sin_beta * sin_beta0);
        let (p, q) = (product - sum, sin_beta * cos_beta0 + cos_beta * sin_beta0);
        let upper = p > T::ZERO;
        let versed = select(upper, q * q, T::ONE - p) / select(upper, T::ONE + p, T::ONE);
        let more = versed + two * product * (cos_half * cos_half);
        let found = more > T::pick(1e-14, 1e-6);
        let b = self.radius * (two / select(found, more, T::ONE)).sqrt();
        let x = cos_beta * (two * sin_half * cos_half);
        let y = sin + two * sin_beta0 * cos_beta * (sin_half * sin_half);
        ([b * self.d * x, b / self.d * y], found)
    }

    /// Latitude and longitude of a point, and whether the map has it.
    #[inline(always)]
    pub(crate) fn unproject(&self, to_geodetic: &impl Turn<T>, [x, y]: [T; 2]) -> ([T; 2], bool) {
        let half = T::of(0.5) / self.radius;
        // x and y on the sphere in diameters: sin c/2 is their length.
        let (x, y) = (x / self.d * half, y * self.d * half);
        let square = x * x + y * y;
        let found = square <= T::ONE;
        let square = select(found, square, T::ONE);
        let cos_half = (T::ONE - square).sqrt();
        let (cos_c, twice) = (T::ONE - (square + square), cos_half + cos_half);
        let (sin_beta0, cos_beta0) = self.beta;
        let sin_beta = cos_c * sin_beta0 + y * twice * cos_beta0;
        let (east, toward) = (x * twice, cos_beta0 * cos_c - y * twice * sin_beta0);
        let (sin, cos) = to_geodetic.turn((sin_beta, hypot(east, toward)));
        let lon = self.centre.lon() + atan2_degrees(east, toward);
        let over = select(lon.abs() > T::of(180.0), T::of(360.0), T::ZERO);
        ([atan2_degrees(sin, max(cos, T::ZERO)), lon - over.copysign(lon)], found)
    }
}

/// Sine and cosine of twice a latitude.
#[inline(always)]
fn doubled<T: Real>((sin, cos): (T, T)) -> (T, T) {
    (T::of(2.0) * sin * cos, (cos - sin) * (cos + sin))
}
