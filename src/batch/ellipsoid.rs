//! Converts geodetic latitude, longitude and height to Earth-centred coordinates, and back.

use core::fmt;

use super::InvalidBatch;
use super::admit::{Constructor, admit};
use crate::math::select;
use crate::simd::{BLOCK, Kernel, Sink, front, store, sweep};
use crate::{Ecef, Ellipsoid, Geodetic, InvalidEcef, InvalidHeight, InvalidLatLon, LatLon, Real};

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
struct Geodetics;

impl<T: Real> Constructor<T, 3> for Geodetics {
    type Error = InvalidGeodetic<T>;

    #[inline(always)]
    fn keeps(&self, [lat, lon, height]: [T; 3]) -> bool {
        (lat.abs() <= T::of(90.0)) & (lon.abs() <= T::of(180.0)) & height.is_finite()
    }

    fn admit(&self, [lat, lon, height]: [T; 3]) -> Result<[T; 3], Self::Error> {
        let place = LatLon::new(lat, lon).map_err(InvalidGeodetic::LatLon)?;
        let place = Geodetic::new(place, height).map_err(InvalidGeodetic::Height)?;
        Ok([place.lat(), place.lon(), place.height()])
    }
}

/// Earth-centred coordinates.
struct Ecefs;

impl<T: Real> Constructor<T, 3> for Ecefs {
    type Error = InvalidEcef<T>;

    #[inline(always)]
    fn keeps(&self, [x, y, z]: [T; 3]) -> bool {
        x.is_finite() & y.is_finite() & z.is_finite()
    }

    fn admit(&self, [x, y, z]: [T; 3]) -> Result<[T; 3], Self::Error> {
        Ecef::new(x, y, z).map(Ecef::to_array)
    }
}

struct ToEcef<T>(Ellipsoid<T>);

impl<T: Real> Kernel<T, 3, 3> for ToEcef<T> {
    #[inline(always)]
    fn apply(&self, [lat, lon, height]: [T; 3]) -> [T; 3] {
        self.0
            .to_ecef_inline(Geodetic::within(LatLon::within(lat, lon), height))
            .to_array()
    }
}

/// The formula without branches, and 1 for the points for which it holds.
struct ToGeodetic<T>(Ellipsoid<T>);

impl<T: Real> Kernel<T, 3, 4> for ToGeodetic<T> {
    #[inline(always)]
    fn apply(&self, [x, y, z]: [T; 3]) -> [T; 4] {
        let point = Ecef::within(x, y, z);
        let place = self.0.to_geodetic_ordinary(point);
        let ordinary = select(self.0.is_ordinary(point), T::ONE, T::ZERO);
        [place.lat(), place.lon(), place.height(), ordinary]
    }
}

/// Stores places. Those for which the formula without branches does not hold are computed again.
struct Mended<'a, T> {
    ellipsoid: Ellipsoid<T>,
    points: [&'a [T]; 3],
    places: [&'a mut [T]; 3],
}

impl<T: Real> Sink<T, 4> for Mended<'_, T> {
    #[inline(always)]
    fn store(&mut self, [lat, lon, height, ordinary]: &[[T; BLOCK]; 4]) {
        if ordinary.iter().fold(true, |all, &flag| all & (flag == T::ONE)) {
            let [a, b, c] = &mut self.places;
            store(a, lat);
            store(b, lon);
            store(c, height);
            for column in &mut self.points {
                *column = column.get(BLOCK..).unwrap_or_default();
            }
        } else {
            self.mend([lat, lon, height], ordinary);
        }
    }
}

impl<T: Real> Mended<'_, T> {
    #[cold]
    #[inline(never)]
    fn mend(&mut self, [lat, lon, height]: [&[T; BLOCK]; 3], ordinary: &[T; BLOCK]) {
        let (mut lat, mut lon, mut height) = (*lat, *lon, *height);
        let [x, y, z] = self.points;
        let points = x.iter().zip(y).zip(z);
        let places = lat.iter_mut().zip(&mut lon).zip(&mut height);
        for ((((x, y), z), ((lat, lon), height)), ordinary) in points.zip(places).zip(ordinary) {
            if *ordinary != T::ONE {
                let place = self.ellipsoid.to_geodetic(Ecef::within(*x, *y, *z));
                (*lat, *lon, *height) = (place.lat(), place.lon(), place.height());
            }
        }
        self.store(&[lat, lon, height, [T::ONE; BLOCK]]);
    }
}

/// Converts geodetic latitudes and longitudes in degrees and heights in metres to Earth-centred coordinates
/// in metres, with the bits of [`Ellipsoid::to_ecef`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Geodetic::new`] refuses an
/// element. Nothing is written then.
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
    mut points: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    let lengths = points.each_ref().map(|column| column.len());
    admit(&Geodetics, places, &lengths, |length, places| {
        sweep(ToEcef(ellipsoid), places, front(&mut points, length));
    })
}

/// Converts Earth-centred coordinates in metres to geodetic latitudes and longitudes in degrees and heights
/// in metres, with the bits of [`Ellipsoid::to_geodetic`].
///
/// Points near the centre, on the axis and very far away take its slower way, one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Ecef::new`] refuses an element. Nothing is written
/// then.
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
    mut places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    let lengths = places.each_ref().map(|column| column.len());
    admit(&Ecefs, points, &lengths, |length, points| {
        let places = front(&mut places, length);
        sweep(
            ToGeodetic(ellipsoid),
            points,
            Mended {
                ellipsoid,
                points,
                places,
            },
        );
    })
}
