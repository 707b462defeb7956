use core::f64::consts::FRAC_PI_3;

use super::plane::{Facet, Spot, point, spot};
use super::{InvalidPixel, InvalidPixelPlace, OutsidePlane, Pixel};
use crate::latitude::UnsupportedFlattening;
use crate::{Ellipsoid, LatLon, Real, Shift, Shifted};

/// Standard HEALPix on an ellipsoid: pixels of equal area there.
///
/// Latitudes are geodetic. The authalic latitude becomes that of the sphere, as in PROJ's `healpix`. On a
/// sphere the results are those of [`Pixel`]'s functions, in every bit.
///
/// ```
/// use terrella::healpix::{OnEllipsoid, Pixel};
/// use terrella::{Ellipsoid, LatLon};
///
/// let earth = OnEllipsoid::new(Ellipsoid::WGS84)?;
/// let oslo = LatLon::new(59.91, 10.75)?;
/// let pixel = earth.containing(oslo, 12)?;
/// assert_eq!(pixel, Pixel::new(12, 12_427_310)?);
/// assert_ne!(pixel, Pixel::containing(oslo, 12)?); // the latitude as that of a sphere
/// assert_eq!(earth.containing(earth.centre(pixel), 12)?, pixel);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ellipsoidal HEALPix")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct OnEllipsoid<T> {
    shifted: Shifted<T>,
}

impl<T: Real> OnEllipsoid<T> {
    /// Creates it for an ellipsoid.
    ///
    /// # Errors
    /// [`UnsupportedFlattening`] if the third flattening is outside of ±1/19, as for every authalic latitude.
    pub fn new(ellipsoid: Ellipsoid<T>) -> Result<Self, UnsupportedFlattening<T>> {
        Ok(Self {
            shifted: Shifted::new(ellipsoid, Shift::Authalic)?,
        })
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.shifted.ellipsoid()
    }

    /// Returns the area of a pixel, in the square of the unit of the ellipsoid's axis: a twelfth of the
    /// ellipsoid, divided by 4^depth.
    ///
    /// ```
    /// use terrella::healpix::{OnEllipsoid, Pixel};
    /// let earth = OnEllipsoid::new(terrella::Ellipsoid::<f64>::WGS84)?;
    /// let hectares = earth.area(Pixel::new(16, 0)?) / 1e4;
    /// assert!((hectares - 0.99).abs() < 0.01);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn area(&self, pixel: Pixel) -> T {
        let side = self.ellipsoid().authalic_radius() / T::whole(1 << pixel.depth());
        T::of(FRAC_PI_3) * (side * side)
    }

    /// Returns the pixel of a depth that contains a place: [`Pixel::containing`] on the ellipsoid.
    ///
    /// The pixel is correct if the place is farther from the pixel's edges than rounding: on the Earth 12 nm
    /// in `f64` and 1.7 m in `f32`.
    ///
    /// # Errors
    /// [`InvalidPixel::Depth`] if the depth is above 29.
    #[inline]
    pub fn containing(&self, place: LatLon<T>, depth: u8) -> Result<Pixel, InvalidPixel> {
        Pixel::checked(self.facet(place), depth)
    }

    /// Returns the centre of a pixel: [`Pixel::centre`] on the ellipsoid.
    #[must_use]
    #[inline]
    pub fn centre(&self, pixel: Pixel) -> LatLon<T> {
        self.ground(pixel.middle())
    }

    /// Returns the corners of a pixel, south, east, north, west: [`Pixel::corners`] on the ellipsoid.
    #[must_use]
    #[inline]
    pub fn corners(&self, pixel: Pixel) -> [LatLon<T>; 4] {
        pixel.tips().map(|corner| self.ground(corner))
    }

    /// Returns the place at (dx, dy) ∈ [0, 1]² in a pixel: [`Pixel::place`] on the ellipsoid.
    ///
    /// The worst error on an ellipsoid like the Earth's is 4.7·10⁻¹⁶ (`f64`) or 2.5·10⁻⁷
    /// (`f32`) radians, including the rounding of latitude and longitude.
    ///
    /// # Errors
    /// [`InvalidPixelPlace`] if dx or dy is outside [0, 1] or NaN.
    #[inline]
    pub fn place(&self, pixel: Pixel, inside: [T; 2]) -> Result<LatLon<T>, InvalidPixelPlace<T>> {
        Ok(self.ground(pixel.spot(inside)?))
    }

    /// Projects a place to HEALPix's plane: [`to_plane`](super::to_plane) on the ellipsoid.
    ///
    /// The worst error on an ellipsoid like the Earth's is 9.3·10⁻¹⁶ (`f64`) or 5·10⁻⁷ (`f32`) of a unit.
    #[must_use]
    #[inline]
    pub fn to_plane(&self, place: LatLon<T>) -> [T; 2] {
        point(self.facet(place), place.lon())
    }

    /// Returns the place of a point of HEALPix's plane: [`from_plane`](super::from_plane) on the ellipsoid. Its
    /// worst error is that of [`place`](Self::place).
    ///
    /// # Errors
    /// [`OutsidePlane`] if the point is outside the plane.
    #[inline]
    pub fn from_plane(&self, point: [T; 2]) -> Result<LatLon<T>, OutsidePlane<T>> {
        Ok(self.ground(spot(point)?))
    }

    /// The step from the ellipsoid to the sphere.
    pub(crate) fn shifted(&self) -> &Shifted<T> {
        &self.shifted
    }

    #[inline(always)]
    pub(crate) fn facet(&self, place: LatLon<T>) -> Facet<T> {
        Facet::of(self.shifted.latitude(place.lat()), place.lon())
    }

    #[inline(always)]
    fn ground(&self, spot: Spot<T>) -> LatLon<T> {
        LatLon::within(self.shifted.geodetic(spot.latitude), spot.lon)
    }
}
