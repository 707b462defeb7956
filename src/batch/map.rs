//! Converts geodetic latitudes and longitudes to points of the cube's faces, and back, by a [`CubeMap`].

use super::InvalidBatch;
use super::admit::admit;
use super::cube::{Faces, Points, project_units, unproject_points};
use super::position::{Places, turn_to_direction, turn_to_lat_lon};
use crate::cube::{CubeMap, CubeProjection, Face, InvalidFacePoint, ProjectionTask};
use crate::latitude::{Turn, with_correction};
use crate::math::{atan2_degrees, sin_cos_degrees};
use crate::simd::{CHUNK, Kernel, front, sweep};
use crate::{InvalidLatLon, Real, Shifted};

/// Projects geodetic latitudes and longitudes in degrees to faces and their coordinates x and y in [−1, 1],
/// with the bits of [`CubeMap::project`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`](crate::LatLon::new) refuses an
/// element. Nothing is written then.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::{Ellipsoid, Shift, batch::map};
/// let earth = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized)?;
/// let (mut face, mut x, mut y) = ([Face::Front; 2], [0.0; 2], [0.0; 2]);
/// map::project(&earth, [&[59.91, 0.0], &[10.75, 180.0]], &mut face, [&mut x, &mut y])?;
/// assert_eq!((face, x[1], y[1]), ([Face::Top, Face::Back], 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn project<T: Real, P: CubeProjection>(
    map: &CubeMap<T, P>,
    places: [&[T]; 2],
    faces: &mut [Face],
    mut points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let lengths = [faces.len(), points[0].len(), points[1].len()];
    let mut faces = [faces];
    admit(&Places, places, &lengths, |length, places| {
        let [faces] = front(&mut faces, length);
        let points = front(&mut points, length);
        map.projection()
            .with(ProjectAll(map.shifted(), places, Faces { faces, points }));
    })
}

/// Projects latitudes and longitudes into faces and points.
struct ProjectAll<'a, T>(Shifted<T>, [&'a [T]; 2], Faces<&'a mut [Face], [&'a mut [T]; 2]>);

impl<T: Real> ProjectionTask for ProjectAll<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self(shifted, mut places, sink) = self;
        let [correction, _] = shifted.corrections();
        if P::TAKES_PLACES {
            with_correction!(&correction, turn => sweep(ProjectPlace(*turn, projection), places, sink));
            return;
        }
        let Faces { faces, mut points } = sink;
        let mut directions = [[T::ZERO; CHUNK]; 3];
        for faces in faces.chunks_mut(CHUNK) {
            let here = faces.len();
            let columns = directions
                .each_mut()
                .map(|column| column.get_mut(..here).unwrap_or_default());
            turn_to_direction(&correction, next(&mut places, here), columns);
            let columns = directions
                .each_ref()
                .map(|column| column.get(..here).unwrap_or_default());
            project_units(projection, columns, faces, front(&mut points, here));
        }
    }
}

struct ProjectPlace<C, P>(C, P);

impl<T: Real, C: Turn<T>, P: CubeProjection> Kernel<T, 2, 3> for ProjectPlace<C, P> {
    #[inline(always)]
    fn apply(&self, [lat, lon]: [T; 2]) -> [T; 3] {
        self.1.project_place(self.0.turn(sin_cos_degrees(lat)), lon)
    }
}

struct UnprojectPlace<C, P>(C, P);

impl<T: Real, C: Turn<T>, P: CubeProjection> Kernel<T, 3, 2> for UnprojectPlace<C, P> {
    #[inline(always)]
    fn apply(&self, point: [T; 3]) -> [T; 2] {
        let (latitude, lon) = self.1.unproject_place(point);
        let (sin, cos) = self.0.turn(latitude);
        [atan2_degrees(sin, cos), lon]
    }
}

/// Converts faces and their coordinates x and y in [−1, 1] to geodetic latitudes and longitudes in degrees,
/// with the bits of [`CubeMap::unproject`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`FacePoint::new`](crate::cube::FacePoint::new)
/// refuses an element. Nothing is written then.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Vertex};
/// use terrella::{Ellipsoid, Shift, batch::map};
/// let earth = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Vertex)?;
/// let (mut lat, mut lon) = ([0.0; 2], [0.0; 2]);
/// map::unproject(&earth, &[Face::Right, Face::Top], [&[0.0, 0.0], &[0.0, 0.0]], [&mut lat, &mut lon])?;
/// assert_eq!((lat[0], lon[0], lat[1]), (0.0, 90.0, 90.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn unproject<T: Real, P: CubeProjection>(
    map: &CubeMap<T, P>,
    faces: &[Face],
    points: [&[T]; 2],
    mut places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidFacePoint<T>>> {
    let lengths = [faces.len(), places[0].len(), places[1].len()];
    admit(&Points, points, &lengths, |length, points| {
        let places = front(&mut places, length);
        map.projection()
            .with(UnprojectAll(map.shifted(), Faces { faces, points }, places));
    })
}

/// Unprojects faces and points into latitudes and longitudes.
struct UnprojectAll<'a, T>(Shifted<T>, Faces<&'a [Face], [&'a [T]; 2]>, [&'a mut [T]; 2]);

impl<T: Real> ProjectionTask for UnprojectAll<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self(shifted, source, mut places) = self;
        let [_, correction] = shifted.corrections();
        if P::TAKES_PLACES {
            with_correction!(&correction, turn => sweep(UnprojectPlace(*turn, projection), source, places));
            return;
        }
        let Faces { faces, mut points } = source;
        let mut directions = [[T::ZERO; CHUNK]; 3];
        for faces in faces.chunks(CHUNK) {
            let here = faces.len();
            let columns = directions
                .each_mut()
                .map(|column| column.get_mut(..here).unwrap_or_default());
            unproject_points(projection, faces, next(&mut points, here), columns);
            let columns = directions
                .each_ref()
                .map(|column| column.get(..here).unwrap_or_default());
            turn_to_lat_lon(&correction, columns, front(&mut places, here));
        }
    }
}

/// Takes the first elements off each slice.
fn next<'a, T>(columns: &mut [&'a [T]; 2], length: usize) -> [&'a [T]; 2] {
    columns.each_mut().map(|column| {
        let (head, rest) = column.split_at_checked(length).unwrap_or_default();
        *column = rest;
        head
    })
}
