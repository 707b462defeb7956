//! Pixels of HEALPix that contain places, and the centres of pixels.

use core::fmt;
use core::marker::PhantomData;

use super::InvalidBatch;
use super::engine::{refuse_all, solve_by};
use super::position::Places;
use crate::healpix::{Facet, InvalidPixel, OnEllipsoid, Pixel};
use crate::latitude::{Turn, with_correction};
use crate::math::{atan2_degrees, sin_cos_degrees};
use crate::simd::{Behind, Door, Kernel, lanes};
use crate::{InvalidLatLon, LatLon, Real};

/// Why an element has no pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidPixelled<T> {
    /// There is no such place.
    Place(InvalidLatLon<T>),
    /// The depth is above 29, for all elements.
    Pixel(InvalidPixel),
}

impl<T: fmt::Debug> fmt::Display for InvalidPixelled<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Place(why) => why.fmt(f),
            Self::Pixel(why) => why.fmt(f),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidPixelled<T> {}

/// From a place to the number of its pixel at a depth.
#[derive(Clone, Copy)]
struct Containing<C>(C, u8);

impl<T: Real, C: Turn<T>> Kernel<[T; 2]> for Containing<C> {
    type Output = [u64; 1];

    #[inline(always)]
    fn apply(&self, [lat, lon]: [T; 2]) -> [u64; 1] {
        let facet = Facet::of(self.0.turn(sin_cos_degrees(lat)), lon);
        [Pixel::of(facet, self.1).number()]
    }
}

/// Pixels of a depth, by their numbers.
#[derive(Clone, Copy)]
struct Pixels(u8);

impl Door<[u64; 1]> for Pixels {
    type Error = InvalidPixel;

    #[inline(always)]
    fn keeps(&self, [number]: [u64; 1]) -> bool {
        Pixel::new(self.0, number).is_ok()
    }

    fn admit(&self, [number]: [u64; 1]) -> Result<[u64; 1], InvalidPixel> {
        Pixel::new(self.0, number).map(|pixel| [pixel.number()])
    }
}

/// From the number of a pixel of a depth to its centre.
#[derive(Clone, Copy)]
struct Centre<T, C>(C, u8, PhantomData<T>);

impl<T: Real, C: Turn<T>> Kernel<[u64; 1]> for Centre<T, C> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, [number]: [u64; 1]) -> [T; 2] {
        let spot = Pixel::numbered(self.1, number).middle();
        let (sin, cos) = self.0.turn(spot.latitude);
        [atan2_degrees(sin, cos), spot.lon]
    }
}

/// Finds the pixels of a depth that contain geodetic latitudes and longitudes in degrees: numbers in the
/// nested scheme, those of [`OnEllipsoid::containing`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element: its number is 0. If
/// the depth is above 29, all elements are refused.
///
/// ```
/// use terrella::healpix::OnEllipsoid;
/// use terrella::{Ellipsoid, batch::healpix};
/// let earth = OnEllipsoid::new(Ellipsoid::<f64>::WGS84)?;
/// let mut numbers = [0; 2];
/// healpix::containing(&earth, 12, [&[59.91, -33.5], &[10.75, 450.25]], &mut numbers)?;
/// assert_eq!(numbers, [12_427_310, 84_096_905]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "ang2pix")]
pub fn containing<T: Real>(
    surface: &OnEllipsoid<T>,
    depth: u8,
    places: [&[T]; 2],
    numbers: &mut [u64],
) -> Result<(), InvalidBatch<InvalidPixelled<T>>> {
    if depth > Pixel::MAX_DEPTH {
        let why = InvalidPixelled::Pixel(InvalidPixel::Depth(depth));
        return refuse_all(places, [numbers], why);
    }
    let result = solve_by(
        places,
        [numbers],
        |[lat, lon]| Ok([Pixel::of(surface.facet(LatLon::new(lat, lon)?), depth).number()]),
        |places, numbers, tally| {
            let [correction, _] = surface.shifted().corrections();
            with_correction!(&correction, turn => {
                lanes(Behind(Places, Containing(*turn, depth)), places, numbers, tally);
            });
        },
    );
    result.map_err(|invalid| invalid.map(InvalidPixelled::Place))
}

/// Finds the geodetic latitudes and longitudes, in degrees, of the centres of pixels of a depth, given by
/// their numbers in the nested scheme, with the bits of [`OnEllipsoid::centre`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`Pixel::new`] refuses an element.
///
/// ```
/// use terrella::healpix::OnEllipsoid;
/// use terrella::{Ellipsoid, batch::healpix};
/// let earth = OnEllipsoid::new(Ellipsoid::<f64>::WGS84)?;
/// let (mut lat, mut lon) = ([0.0; 2], [0.0; 2]);
/// healpix::centre(&earth, 0, &[4, 7], [&mut lat, &mut lon])?;
/// assert_eq!((lat, lon), ([0.0, 0.0], [0.0, -90.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "pix2ang")]
pub fn centre<T: Real>(
    surface: &OnEllipsoid<T>,
    depth: u8,
    numbers: &[u64],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidPixel>> {
    if depth > Pixel::MAX_DEPTH {
        return refuse_all([numbers], places, InvalidPixel::Depth(depth));
    }
    solve_by(
        [numbers],
        places,
        |[number]| {
            let centre = surface.centre(Pixel::new(depth, number)?);
            Ok([centre.lat(), centre.lon()])
        },
        |numbers, places, tally| {
            let [_, correction] = surface.shifted().corrections();
            with_correction!(&correction, turn => {
                lanes(Behind(Pixels(depth), Centre(*turn, depth, PhantomData)), numbers, places, tally);
            });
        },
    )
}
