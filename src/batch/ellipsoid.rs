//! Converts geodetic latitude, longitude and height to Earth-centred coordinates, and back.

use core::fmt;

use super::InvalidBatch;
use super::engine::{solve, solve_by};
use crate::simd::{Behind, Door, Element, Kernel, lanes};
use crate::{Ecef, Ellipsoid, Geodetic, GeodeticSeries, InvalidEcef, InvalidHeight, InvalidLatLon, LatLon, Real};

/// Why an element with a latitude, a longitude and a height was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidGeodetic<T> {
    /// [`LatLon::new`] refuses the latitude or longitude.
    LatLon(InvalidLatLon<T>),
    /// [`Geodetic::new`] refuses the height.
    Height(InvalidHeight<T>),
}

impl<T: fmt::Debug> fmt::Display for InvalidGeodetic<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::LatLon(why) => why.fmt(f),
            Self::Height(why) => why.fmt(f),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidGeodetic<T> {}

/// Latitudes, longitudes and heights.
#[derive(Clone, Copy)]
pub(super) struct Geodetics;

impl<T: Real> Door<[T; 3]> for Geodetics {
    type Error = InvalidGeodetic<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon, height]: [T; 3]) -> bool {
        (lat.abs() <= T::of(90.0)) & (lon.abs() <= T::of(180.0)) & height.is_finite()
    }

    #[inline(always)]
    fn mend(&self, [lat, lon, height]: [T; 3]) -> [T; 3] {
        [lat, LatLon::turned(lon), height]
    }

    fn admit(&self, [lat, lon, height]: [T; 3]) -> Result<[T; 3], Self::Error> {
        let place = LatLon::new(lat, lon).map_err(InvalidGeodetic::LatLon)?;
        let place = Geodetic::new(place, height).map_err(InvalidGeodetic::Height)?;
        Ok([place.lat(), place.lon(), place.height()])
    }
}

/// Points in Earth axes.
#[derive(Clone, Copy)]
pub(super) struct Points;

impl<T: Real> Door<[T; 3]> for Points {
    type Error = InvalidEcef<T>;

    #[inline(always)]
    fn keeps(&self, [x, y, z]: [T; 3]) -> bool {
        x.is_finite() & y.is_finite() & z.is_finite()
    }

    fn admit(&self, [x, y, z]: [T; 3]) -> Result<[T; 3], Self::Error> {
        Ecef::new(x, y, z).map(Ecef::to_array)
    }
}

#[derive(Clone, Copy)]
struct ToEcef<T>(Ellipsoid<T>);

impl<T: Real> Kernel<[T; 3]> for ToEcef<T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, [lat, lon, height]: [T; 3]) -> [T; 3] {
        self.0
            .to_ecef_inline(Geodetic::within(LatLon::within(lat, lon), height))
            .to_array()
    }
}

/// The formula without branches; the other points are computed one by one.
#[derive(Clone, Copy)]
struct ToGeodetic<T>(Ellipsoid<T>);

impl<T: Real> Element<[T; 3]> for ToGeodetic<T> {
    type Output = [T; 3];
    type Error = InvalidEcef<T>;

    #[inline(always)]
    fn keeps(&self, point: [T; 3]) -> bool {
        Points.keeps(point)
    }

    #[inline(always)]
    fn fast(&self, [x, y, z]: [T; 3]) -> ([T; 3], bool) {
        let point = Ecef::within(x, y, z);
        let place = self.0.to_geodetic_ordinary(point);
        ([place.lat(), place.lon(), place.height()], self.0.is_ordinary(point))
    }

    fn one(&self, [x, y, z]: [T; 3]) -> Result<[T; 3], InvalidEcef<T>> {
        let place = self.0.to_geodetic(Ecef::new(x, y, z)?);
        Ok([place.lat(), place.lon(), place.height()])
    }
}

/// A series; where it does not hold, points are computed one by one.
#[derive(Clone, Copy)]
struct Series<T, const ORDER: usize>(GeodeticSeries<T>);

impl<T: Real, const ORDER: usize> Element<[T; 3]> for Series<T, ORDER> {
    type Output = [T; 3];
    type Error = InvalidEcef<T>;

    #[inline(always)]
    fn keeps(&self, point: [T; 3]) -> bool {
        Points.keeps(point)
    }

    #[inline(always)]
    fn fast(&self, [x, y, z]: [T; 3]) -> ([T; 3], bool) {
        let point = Ecef::within(x, y, z);
        let place = self.0.series::<ORDER>(point);
        ([place.lat(), place.lon(), place.height()], self.0.holds(point))
    }

    fn one(&self, [x, y, z]: [T; 3]) -> Result<[T; 3], InvalidEcef<T>> {
        let place = self.0.convert::<ORDER>(Ecef::new(x, y, z)?);
        Ok([place.lat(), place.lon(), place.height()])
    }
}

/// Converts geodetic latitudes and longitudes in degrees and heights in metres to Earth-centred coordinates
/// in metres, with the bits of [`Ellipsoid::to_ecef`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Geodetic::new`] refuses an
/// element.
///
/// ```
/// use terrella::{Ellipsoid, batch::ellipsoid};
/// let (mut x, mut y, mut z) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let places: [&[f64]; 3] = [&[0.0, 90.0], &[90.0, 0.0], &[100.0, -100.0]];
/// ellipsoid::to_ecef(Ellipsoid::WGS84, places, [&mut x, &mut y, &mut z])?;
/// assert_eq!((x, y, z[0]), ([0.0, 0.0], [6_378_237.0, 0.0], 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "geodetic2ecef", alias = "lla2ecef")]
pub fn to_ecef<T: Real>(
    ellipsoid: Ellipsoid<T>,
    places: [&[T]; 3],
    points: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    solve_by(
        places,
        points,
        |place| {
            let [lat, lon, height] = Geodetics.admit(place)?;
            let place = Geodetic::within(LatLon::within(lat, lon), height);
            Ok(ellipsoid.to_ecef(place).to_array())
        },
        |places, points, tally| lanes(Behind(Geodetics, ToEcef(ellipsoid)), places, points, tally),
    )
}

/// Converts Earth-centred coordinates in metres to geodetic latitudes and longitudes in degrees and heights
/// in metres, with the bits of [`Ellipsoid::to_geodetic`].
///
/// Points near the centre, on the axis and very far away take its slower way, one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Ecef::new`] refuses an element.
///
/// ```
/// use terrella::{Ellipsoid, batch::ellipsoid};
/// let (mut lat, mut lon, mut height) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let points: [&[f64]; 3] = [&[0.0, 0.0], &[-7e6, 0.0], &[0.0, 0.0]];
/// ellipsoid::to_geodetic(Ellipsoid::WGS84, points, [&mut lat, &mut lon, &mut height])?;
/// assert_eq!((lat, lon, height[0]), ([0.0, 90.0], [-90.0, 0.0], 621_863.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ecef2geodetic", alias = "ecef2lla")]
pub fn to_geodetic<T: Real>(
    ellipsoid: Ellipsoid<T>,
    points: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(ToGeodetic(ellipsoid), points, places)
}

/// Converts Earth-centred coordinates in metres to geodetic latitudes and longitudes in degrees and heights
/// in metres, with the bits of [`GeodeticSeries::second_order`]: within 0.4 m on the Earth, from −0.5 km to
/// 100 km of height.
///
/// Points for which the series do not hold are converted by [`Ellipsoid::to_geodetic`], one by one.
///
/// # Errors
/// Those of [`to_geodetic`].
///
/// ```
/// use terrella::{Ellipsoid, GeodeticSeries, batch::ellipsoid};
/// let series = GeodeticSeries::new(Ellipsoid::WGS84);
/// let (mut lat, mut lon, mut height) = ([0.0_f64; 2], [0.0; 2], [0.0; 2]);
/// let points: [&[f64]; 3] = [&[3_980_609.2, 0.0], &[-102.5, 7e6], &[4_966_860.0, 0.0]];
/// ellipsoid::second_order(series, points, [&mut lat, &mut lon, &mut height])?;
/// assert!((lat[0] - 51.477_81).abs() < 1e-5 && (height[0] - 45.0).abs() < 1.0);
/// assert_eq!((lat[1], lon[1], height[1]), (0.0, 90.0, 621_863.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ecef2geodetic", alias = "ecef2lla")]
pub fn second_order<T: Real>(
    series: GeodeticSeries<T>,
    points: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(Series::<T, 2>(series), points, places)
}

/// As [`second_order`], with the bits of [`GeodeticSeries::third_order`]: within 2.5 mm.
///
/// # Errors
/// Those of [`to_geodetic`].
#[doc(alias = "ecef2geodetic", alias = "ecef2lla")]
pub fn third_order<T: Real>(
    series: GeodeticSeries<T>,
    points: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(Series::<T, 3>(series), points, places)
}

/// As [`second_order`], with the bits of [`GeodeticSeries::fourth_order`]: within 0.1 µm.
///
/// # Errors
/// Those of [`to_geodetic`].
#[doc(alias = "ecef2geodetic", alias = "ecef2lla")]
pub fn fourth_order<T: Real>(
    series: GeodeticSeries<T>,
    points: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    solve(Series::<T, 4>(series), points, places)
}
