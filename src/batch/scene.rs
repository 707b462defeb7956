//! Runs what a [`Scene`](crate::scene::Scene) chose. The choice is made once for a call, and not for each
//! element.
//!
//! A scene's other answers are what the batches take already: the ellipsoid and the shift of a
//! [`Figure`](crate::scene::Figure), and levels of tiles.

use super::InvalidBatch;
use super::area::{InvalidRing, fields, polygon_areas};
use super::ellipsoid::{self, Geodetics, InvalidGeodetic};
use super::engine::solve_by;
use super::frame::geodetic_to_enu;
use super::geodesic::{self, InvalidProblem};
use crate::geodesic::{AnyMethod, Geodesic, Visitor};
use crate::scene::{AnyArea, AnyOrder, AnyView, Expansion};
use crate::simd::{Behind, Door, Kernel, lanes};
use crate::{Enu, Geodetic, InvalidEcef, LatLon, Real};

type Inverted<T> = Result<(), InvalidBatch<InvalidProblem<T>>>;

struct Inverse<'a, T> {
    from: [&'a [T]; 2],
    to: [&'a [T]; 2],
    lines: [&'a mut [T]; 3],
}

impl<T: Real> Visitor<T> for Inverse<'_, T> {
    type Output = Inverted<T>;

    fn visit<M: Geodesic<T>>(self, method: M) -> Inverted<T> {
        geodesic::inverse(&method, self.from, self.to, self.lines)
    }
}

struct Direct<'a, T> {
    from: [&'a [T]; 2],
    azimuth: &'a [T],
    distance: &'a [T],
    ends: [&'a mut [T]; 3],
}

impl<T: Real> Visitor<T> for Direct<'_, T> {
    type Output = Inverted<T>;

    fn visit<M: Geodesic<T>>(self, method: M) -> Inverted<T> {
        geodesic::direct(&method, self.from, self.azimuth, self.distance, self.ends)
    }
}

/// Solves the inverse problem by the method of [`Distances::solver`](crate::scene::Distances::solver), as
/// [`geodesic::inverse`] does.
///
/// # Errors
/// Those of [`geodesic::inverse`].
///
/// ```
/// use terrella::scene::{Distances, Scene};
/// use terrella::{Ellipsoid, batch::scene};
/// let legs: Distances<f64> = Scene::new(Ellipsoid::WGS84).up_to(9e6).within(20.0).distances()?;
/// let (mut distance, mut there, mut back) = ([0.0; 2], [0.0; 2], [0.0; 2]);
/// let from: [&[f64]; 2] = [&[0.0, 40.6], &[0.0, -73.8]];
/// let to: [&[f64]; 2] = [&[0.0, 51.6], &[1.0, -0.5]];
/// scene::inverse(legs.solver(), from, to, [&mut distance, &mut there, &mut back])?;
/// assert!((distance[1] - 5_551_759.4).abs() < 20.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[inline(always)]
pub fn inverse<T: Real>(
    method: AnyMethod<T>,
    from: [&[T]; 2],
    to: [&[T]; 2],
    lines: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.visit(Inverse { from, to, lines })
}

/// Solves the direct problem by the method of [`Distances::solver`](crate::scene::Distances::solver), as
/// [`geodesic::direct`] does.
///
/// # Errors
/// Those of [`geodesic::direct`].
#[inline(always)]
pub fn direct<T: Real>(
    method: AnyMethod<T>,
    from: [&[T]; 2],
    azimuth: &[T],
    distance: &[T],
    ends: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidProblem<T>>> {
    method.visit(Direct {
        from,
        azimuth,
        distance,
        ends,
    })
}

#[derive(Clone, Copy)]
struct First<'a, T>(&'a Expansion<T>);

impl<T: Real> Kernel<[T; 3]> for First<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, place: [T; 3]) -> [T; 3] {
        row(self.0.first_order(geodetic(place)))
    }
}

#[derive(Clone, Copy)]
struct Second<'a, T>(&'a Expansion<T>);

impl<T: Real> Kernel<[T; 3]> for Second<'_, T> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, place: [T; 3]) -> [T; 3] {
        row(self.0.second_order(geodetic(place)))
    }
}

#[inline(always)]
fn geodetic<T: Real>([lat, lon, height]: [T; 3]) -> Geodetic<T> {
    Geodetic::within(LatLon::within(lat, lon), height)
}

#[inline(always)]
fn row<T>(Enu { east, north, up }: Enu<T>) -> [T; 3] {
    [east, north, up]
}

/// Converts latitudes and longitudes in degrees and heights in metres to metres east, north and up of an
/// origin, with the bits of [`AnyView::enu`]. In a [local](crate::scene::Scene::local) scene, pass degrees
/// north and east, and metres up, of the origin.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] or [`Geodetic::new`] refuses an
/// element.
///
/// ```
/// use terrella::scene::{Positions, Scene};
/// use terrella::{Ellipsoid, Geodetic, LatLon, batch::scene};
/// let field = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0).up_to(1000.0).heights(400.0, 550.0).local();
/// let positions: Positions<f32> = field.within(0.05).positions()?;
/// let about = positions.about(Geodetic::new(LatLon::new(47.4, 8.55)?, 430.0)?);
/// let (mut east, mut north, mut up) = ([0.0], [0.0], [0.0]);
/// scene::enu(&about, [&[0.001], &[0.002], &[60.0]], [&mut east, &mut north, &mut up])?;
/// assert!((north[0] - 111.189).abs() < 0.05);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[inline(always)]
pub fn enu<T: Real>(
    view: &AnyView<T>,
    positions: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    match view {
        AnyView::Linear(series) => expand(First(series), positions, enu),
        AnyView::Quadratic(series) => expand(Second(series), positions, enu),
        AnyView::Full(frame) => geodetic_to_enu(frame, positions, enu),
    }
}

fn expand<T: Real, K: Kernel<[T; 3], Output = [T; 3]> + Copy>(
    kernel: K,
    positions: [&[T]; 3],
    enu: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidGeodetic<T>>> {
    solve_by(
        positions,
        enu,
        |position| Geodetics.admit(position).map(|position| kernel.apply(position)),
        |positions, enu, tally| lanes(Behind(Geodetics, kernel), positions, enu, tally),
    )
}

/// Converts Earth-centred coordinates in metres to geodetic latitudes and longitudes in degrees and heights
/// in metres by what [`Geodetics::solver`](crate::scene::Geodetics::solver) returns, with the bits of
/// [`AnyOrder::to_geodetic`].
///
/// # Errors
/// Those of [`ellipsoid::to_geodetic`].
///
/// ```
/// use terrella::scene::{Geodetics, Scene};
/// use terrella::{Ellipsoid, batch::scene};
/// let air = Scene::new(Ellipsoid::WGS84).heights(-500.0, 100_000.0).within(1.0);
/// let fixes: Geodetics<f64> = air.geodetics()?;
/// let (mut lat, mut lon, mut height) = ([0.0], [0.0], [0.0]);
/// let points: [&[f64]; 3] = [&[3_980_609.2], &[-102.5], &[4_966_860.0]];
/// scene::to_geodetic(fixes.solver(), points, [&mut lat, &mut lon, &mut height])?;
/// assert!((lat[0] - 51.477_81).abs() < 1e-5 && (height[0] - 45.0).abs() < 1.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[inline(always)]
pub fn to_geodetic<T: Real>(
    order: AnyOrder<T>,
    points: [&[T]; 3],
    places: [&mut [T]; 3],
) -> Result<(), InvalidBatch<InvalidEcef<T>>> {
    match order {
        AnyOrder::Second(series) => ellipsoid::second_order(series, points, places),
        AnyOrder::Third(series) => ellipsoid::third_order(series, points, places),
        AnyOrder::Fourth(series) => ellipsoid::fourth_order(series, points, places),
        AnyOrder::Full(exact) => ellipsoid::to_geodetic(exact, points, places),
    }
}

/// Measures rings by what [`Areas::solver`](crate::scene::Areas::solver) returns: areas in m², with the bits
/// of [`AnyArea::area`]. [`area`](super::area) says how rings are given. In a
/// [local](crate::scene::Scene::local) scene, pass the corners as degrees north and east of the origin.
///
/// # Errors
/// Those of [`area::fields`](super::area::fields).
///
/// ```
/// use terrella::scene::{Areas, Scene};
/// use terrella::{Ellipsoid, batch::scene};
/// let farm: Areas<f32> = Scene::around(Ellipsoid::WGS84, 52.0, 1000.0).local().within(0.001).areas()?;
/// let (north, east) = ([0.0, 0.0, 0.001, 0.001], [0.0, 0.001, 0.001, 0.0]);
/// let mut areas = [0.0];
/// scene::areas(&farm.solver(), &[0, 4], [&north, &east], &mut areas)?;
/// assert!((areas[0] - 7641.537).abs() < 0.005);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[inline(always)]
pub fn areas<T: Real, O: Copy + TryInto<usize>>(
    area: &AnyArea<T>,
    offsets: &[O],
    corners: [&[T]; 2],
    areas: &mut [T],
) -> Result<(), InvalidBatch<InvalidRing<T>>> {
    match area {
        AnyArea::Plane(area) => fields(area, offsets, corners, areas),
        AnyArea::Ellipsoid(area) => polygon_areas(area, offsets, corners, areas),
    }
}
