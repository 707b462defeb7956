//! Projects places to maps of conformal and equal-area projections, and back.

use super::InvalidBatch;
use super::engine::{solve, solve_by};
use super::position::Places;
use crate::grid::{
    Hemisphere, LambertAzimuthal, NotOnMap, OutsideMap, PolarStereographic, TransverseMercator, shifted, unshifted,
};
use crate::latitude::{Turn, with_correction};
use crate::simd::{Behind, Door, Element, Kernel, lanes};
use crate::{InvalidLatLon, LatLon, Real};

/// A way from latitude and longitude to a map, and back, by the correction of latitudes.
trait Map<T: Real>: Copy {
    fn project(&self, turn: &impl Turn<T>, place: [T; 2]) -> [T; 2];
    fn unproject(&self, turn: &impl Turn<T>, point: [T; 2]) -> [T; 2];
    fn reaches(&self, point: [T; 2]) -> bool;
}

impl<T: Real> Map<T> for TransverseMercator<T> {
    #[inline(always)]
    fn project(&self, turn: &impl Turn<T>, place: [T; 2]) -> [T; 2] {
        TransverseMercator::project(self, turn, place)
    }

    #[inline(always)]
    fn unproject(&self, turn: &impl Turn<T>, point: [T; 2]) -> [T; 2] {
        TransverseMercator::unproject(self, turn, point)
    }

    #[inline(always)]
    fn reaches(&self, point: [T; 2]) -> bool {
        TransverseMercator::reaches(self, point)
    }
}

/// A zone of UTM: the projection with false origins.
#[derive(Clone, Copy)]
struct Zoned<T>(TransverseMercator<T>, Hemisphere);

impl<T: Real> Map<T> for Zoned<T> {
    #[inline(always)]
    fn project(&self, turn: &impl Turn<T>, place: [T; 2]) -> [T; 2] {
        shifted(self.1, self.0.project(turn, place))
    }

    #[inline(always)]
    fn unproject(&self, turn: &impl Turn<T>, point: [T; 2]) -> [T; 2] {
        self.0.unproject(turn, unshifted(self.1, point))
    }

    #[inline(always)]
    fn reaches(&self, point: [T; 2]) -> bool {
        self.0.reaches(unshifted(self.1, point))
    }
}

/// About a pole.
#[derive(Clone, Copy)]
struct Polar<T>(PolarStereographic<T>, Hemisphere);

impl<T: Real> Map<T> for Polar<T> {
    #[inline(always)]
    fn project(&self, turn: &impl Turn<T>, place: [T; 2]) -> [T; 2] {
        self.0.project(turn, self.1, place)
    }

    #[inline(always)]
    fn unproject(&self, turn: &impl Turn<T>, point: [T; 2]) -> [T; 2] {
        self.0.unproject(turn, self.1, point)
    }

    #[inline(always)]
    fn reaches(&self, point: [T; 2]) -> bool {
        self.0.reaches(point)
    }
}

#[derive(Clone, Copy)]
struct Forward<M, C>(M, C);

impl<T: Real, M: Map<T>, C: Turn<T>> Kernel<[T; 2]> for Forward<M, C> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, place: [T; 2]) -> [T; 2] {
        self.0.project(&self.1, place)
    }
}

#[derive(Clone, Copy)]
struct Backward<M, C>(M, C);

impl<T: Real, M: Map<T>, C: Turn<T>> Kernel<[T; 2]> for Backward<M, C> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, point: [T; 2]) -> [T; 2] {
        self.0.unproject(&self.1, point)
    }
}

/// Points that a map has places of.
#[derive(Clone, Copy)]
struct Reached<M>(M);

impl<T: Real, M: Map<T>> Door<[T; 2]> for Reached<M> {
    type Error = OutsideMap<T>;

    #[inline(always)]
    fn keeps(&self, point: [T; 2]) -> bool {
        self.0.reaches(point)
    }

    fn admit(&self, [x, y]: [T; 2]) -> Result<[T; 2], OutsideMap<T>> {
        if self.0.reaches([x, y]) {
            Ok([x, y])
        } else {
            Err(OutsideMap { x, y })
        }
    }
}

macro_rules! forward {
    ($map:expr, $correction:expr, $places:expr, $points:expr) => {{
        let (map, correction) = ($map, $correction);
        solve_by(
            $places,
            $points,
            |place| Ok(Map::project(&map, &correction, Places.admit(place)?)),
            |places, points, tally| {
                with_correction!(&correction, turn => {
                    lanes(Behind(Places, Forward(map, *turn)), places, points, tally);
                });
            },
        )
    }};
}

macro_rules! inverse {
    ($map:expr, $correction:expr, $points:expr, $places:expr) => {{
        let (map, correction) = ($map, $correction);
        solve_by(
            $points,
            $places,
            |point| Ok(Map::unproject(&map, &correction, Reached(map).admit(point)?)),
            |points, places, tally| {
                with_correction!(&correction, turn => {
                    lanes(Behind(Reached(map), Backward(map, *turn)), points, places, tally);
                });
            },
        )
    }};
}

/// Projects latitudes and longitudes in degrees by transverse Mercator: x and y in metres, with the bits of
/// [`TransverseMercator::forward`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element.
///
/// ```
/// use terrella::{Ellipsoid, batch, grid::TransverseMercator};
/// let map = TransverseMercator::new(Ellipsoid::<f64>::WGS84, 0.9996, 9.0)?;
/// let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
/// batch::grid::transverse_mercator(&map, [&[59.91, 0.0], &[10.75, 9.0]], [&mut x, &mut y])?;
/// assert_eq!((x[0].round(), y[0].round(), x[1]), (97_868.0, 6_642_682.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn transverse_mercator<T: Real>(
    map: &TransverseMercator<T>,
    places: [&[T]; 2],
    points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let [correction, _] = map.corrections();
    forward!(*map, correction, places, points)
}

/// Finds latitudes and longitudes, in degrees, of points of transverse Mercator: x and y in metres, with the
/// bits of [`TransverseMercator::inverse`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is outside the map.
pub fn transverse_mercator_inverse<T: Real>(
    map: &TransverseMercator<T>,
    points: [&[T]; 2],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<OutsideMap<T>>> {
    let [_, correction] = map.corrections();
    inverse!(*map, correction, points, places)
}

/// Projects latitudes and longitudes in degrees to one zone of UTM, given by
/// [`Utm::zone`](crate::grid::Utm::zone), and one hemisphere: eastings and northings in metres.
///
/// There are no limits of easting and northing. Within those of [`Utm`](crate::grid::Utm) the bits are those of
/// [`Utm::in_zone`](crate::grid::Utm::in_zone).
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element.
///
/// ```
/// use terrella::grid::{Hemisphere, Utm, Zone};
/// use terrella::{Ellipsoid, batch};
/// let utm = Utm::new(Ellipsoid::<f64>::WGS84)?;
/// let zone = utm.zone(Zone::new(32)?).ok_or("no zone of UTM")?;
/// let (mut easting, mut northing) = ([0.0; 2], [0.0; 2]);
/// batch::grid::utm(&zone, Hemisphere::North, [&[59.91, 0.0], &[10.75, 9.0]], [&mut easting, &mut northing])?;
/// assert_eq!((easting[0].round(), easting[1], northing[1]), (597_868.0, 500_000.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn utm<T: Real>(
    zone: &TransverseMercator<T>,
    hemisphere: Hemisphere,
    places: [&[T]; 2],
    positions: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let [correction, _] = zone.corrections();
    forward!(Zoned(*zone, hemisphere), correction, places, positions)
}

/// Finds latitudes and longitudes, in degrees, of eastings and northings of one zone of UTM and one hemisphere:
/// the inverse of [`utm`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is outside the map.
pub fn utm_inverse<T: Real>(
    zone: &TransverseMercator<T>,
    hemisphere: Hemisphere,
    positions: [&[T]; 2],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<OutsideMap<T>>> {
    let [_, correction] = zone.corrections();
    inverse!(Zoned(*zone, hemisphere), correction, positions, places)
}

/// Projects latitudes and longitudes in degrees by polar stereographic about one pole: x and y in metres, with
/// the bits of [`PolarStereographic::forward`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an element.
///
/// ```
/// use terrella::grid::{Hemisphere, PolarStereographic};
/// use terrella::{Ellipsoid, batch};
/// let map = PolarStereographic::new(Ellipsoid::<f64>::WGS84, 1.0)?;
/// let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
/// let places: [&[f64]; 2] = [&[90.0, 89.0], &[0.0, 90.0]];
/// batch::grid::polar_stereographic(&map, Hemisphere::North, places, [&mut x, &mut y])?;
/// assert_eq!((x[0], x[1].round(), y[1].round()), (0.0, 111_697.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn polar_stereographic<T: Real>(
    map: &PolarStereographic<T>,
    about: Hemisphere,
    places: [&[T]; 2],
    points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let [correction, _] = map.corrections();
    forward!(Polar(*map, about), correction, places, points)
}

/// Finds latitudes and longitudes, in degrees, of points of polar stereographic about one pole: x and y in
/// metres, with the bits of [`PolarStereographic::inverse`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is outside the map.
pub fn polar_stereographic_inverse<T: Real>(
    map: &PolarStereographic<T>,
    about: Hemisphere,
    points: [&[T]; 2],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<OutsideMap<T>>> {
    let [_, correction] = map.corrections();
    inverse!(Polar(*map, about), correction, points, places)
}

/// Why an element has no point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidMapped<T> {
    /// There is no such place.
    Place(InvalidLatLon<T>),
    /// The map does not have it.
    Map(NotOnMap<T>),
}

impl<T: core::fmt::Debug + core::fmt::Display> core::fmt::Display for InvalidMapped<T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Place(why) => why.fmt(f),
            Self::Map(why) => why.fmt(f),
        }
    }
}

impl<T: core::fmt::Debug + core::fmt::Display> core::error::Error for InvalidMapped<T> {}

#[derive(Clone, Copy)]
struct EqualArea<T, C>(LambertAzimuthal<T>, C);

impl<T: Real, C: Turn<T>> Element<[T; 2]> for EqualArea<T, C> {
    type Output = [T; 2];
    type Error = InvalidMapped<T>;

    #[inline(always)]
    fn keeps(&self, place: [T; 2]) -> bool {
        Places.keeps(place)
    }

    #[inline(always)]
    fn mend(&self, place: [T; 2]) -> [T; 2] {
        Places.mend(place)
    }

    #[inline(always)]
    fn fast(&self, place: [T; 2]) -> ([T; 2], bool) {
        self.0.project(&self.1, place)
    }

    fn one(&self, [lat, lon]: [T; 2]) -> Result<[T; 2], InvalidMapped<T>> {
        let place = LatLon::new(lat, lon).map_err(InvalidMapped::Place)?;
        self.0.forward(place).map_err(InvalidMapped::Map)
    }
}

#[derive(Clone, Copy)]
struct EqualAreaBack<T, C>(LambertAzimuthal<T>, C);

impl<T: Real, C: Turn<T>> Element<[T; 2]> for EqualAreaBack<T, C> {
    type Output = [T; 2];
    type Error = OutsideMap<T>;

    #[inline(always)]
    fn keeps(&self, _: [T; 2]) -> bool {
        true
    }

    #[inline(always)]
    fn fast(&self, point: [T; 2]) -> ([T; 2], bool) {
        self.0.unproject(&self.1, point)
    }

    fn one(&self, point: [T; 2]) -> Result<[T; 2], OutsideMap<T>> {
        self.0.inverse(point).map(|place| [place.lat(), place.lon()])
    }
}

/// Projects latitudes and longitudes in degrees by Lambert's azimuthal equal-area projection: x and y in metres,
/// with the bits of [`LambertAzimuthal::forward`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, [`LatLon::new`] refuses an element, or the map does not have
/// it.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, batch, grid::LambertAzimuthal};
/// let europe = LambertAzimuthal::new(Ellipsoid::GRS80, LatLon::new(52.0_f64, 10.0)?)?;
/// let (mut x, mut y) = ([0.0; 2], [0.0; 2]);
/// batch::grid::lambert_azimuthal(&europe, [&[50.0, 52.0], &[5.0, 10.0]], [&mut x, &mut y])?;
/// assert_eq!((x[0].round(), y[0].round(), x[1], y[1]), (-358_201.0, -210_281.0, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn lambert_azimuthal<T: Real>(
    map: &LambertAzimuthal<T>,
    places: [&[T]; 2],
    points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidMapped<T>>> {
    let [correction, _] = map.corrections();
    with_correction!(&correction, turn => solve(EqualArea(*map, *turn), places, points))
}

/// Finds latitudes and longitudes, in degrees, of points of Lambert's azimuthal equal-area projection: x and y in
/// metres, with the bits of [`LambertAzimuthal::inverse`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or a point is outside the map.
pub fn lambert_azimuthal_inverse<T: Real>(
    map: &LambertAzimuthal<T>,
    points: [&[T]; 2],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<OutsideMap<T>>> {
    let [_, correction] = map.corrections();
    with_correction!(&correction, turn => solve(EqualAreaBack(*map, *turn), points, places))
}
