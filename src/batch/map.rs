//! Converts geodetic latitudes and longitudes to points of the cube's faces, and back, by a [`CubeMap`].

use super::cube::{InvalidPoint, Point, Points, ProjectInLanes, UnprojectInLanes, face_point, numbered};
use super::engine::solve_by;
use super::face_number::Faces;
use super::position::{Places, Vectors, to_direction_in_lanes, to_lat_lon_in_lanes};
use super::{FaceNumber, InvalidBatch};
use crate::cube::{CubeMap, CubeProjection, ProjectionTask};
use crate::latitude::{Turn, with_correction};
use crate::math::{atan2_degrees, sin_cos_degrees};
use crate::simd::{Behind, CHUNK, Kernel, Tally, front, head, lanes};
use crate::{InvalidLatLon, LatLon, Real, Shifted};

/// Projects geodetic latitudes and longitudes in degrees to faces and their coordinates x and y in [−1, 1],
/// with the bits of [`CubeMap::project`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an
/// element.
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
pub fn project<T: Real, P: CubeProjection, F: FaceNumber>(
    map: &CubeMap<T, P>,
    places: [&[T]; 2],
    faces: &mut [F],
    points: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    solve_by(
        places,
        (Faces::new(faces), points),
        |[lat, lon]| Ok(numbered(map.project(LatLon::new(lat, lon)?))),
        |places, points, tally| {
            map.projection().with(ProjectAll {
                shifted: map.shifted(),
                places,
                points,
                tally,
            });
        },
    )
}

/// Projects latitudes and longitudes into faces and points: at once, or by way of directions.
pub(super) struct ProjectAll<'a, 't, T, F> {
    pub(super) shifted: Shifted<T>,
    pub(super) places: [&'a [T]; 2],
    pub(super) points: (Faces<&'a mut [F], T>, [&'a mut [T]; 2]),
    pub(super) tally: &'t mut Tally<InvalidLatLon<T>>,
}

impl<T: Real, F: FaceNumber> ProjectionTask for ProjectAll<'_, '_, T, F> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self {
            shifted,
            mut places,
            points,
            tally,
        } = self;
        let [correction, _] = shifted.corrections();
        if P::TAKES_PLACES {
            with_correction!(&correction, turn => {
                lanes(Behind(Places, ProjectPlace(*turn, projection)), places, points, tally);
            });
            return;
        }
        let (mut faces, mut points) = points;
        let mut directions = [[T::ZERO; CHUNK]; 3];
        while let here @ 1.. = places[0].len().min(CHUNK) {
            let places = head(&mut places, here);
            let columns = directions
                .each_mut()
                .map(|column| column.get_mut(..here).unwrap_or_default());
            to_direction_in_lanes(&correction, places, columns, tally);
            ProjectInLanes {
                vectors: Vectors { known: true },
                directions: directions
                    .each_ref()
                    .map(|column| column.get(..here).unwrap_or_default()),
                points: (faces.front(here), front(&mut points, here)),
                tally: &mut Tally::new(),
            }
            .run(projection);
        }
    }
}

#[derive(Clone, Copy)]
struct ProjectPlace<C, P>(C, P);

impl<T: Real, C: Turn<T>, P: CubeProjection> Kernel<[T; 2]> for ProjectPlace<C, P> {
    type Output = (T, [T; 2]);

    #[inline(always)]
    fn apply(&self, [lat, lon]: [T; 2]) -> (T, [T; 2]) {
        let [number, x, y] = self.1.project_place(self.0.turn(sin_cos_degrees(lat)), lon);
        (number, [x, y])
    }
}

#[derive(Clone, Copy)]
struct UnprojectPlace<C, P>(C, P);

impl<T: Real, C: Turn<T>, P: CubeProjection> Kernel<Point<T>> for UnprojectPlace<C, P> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, ([x, y], number): Point<T>) -> [T; 2] {
        let (latitude, lon) = self.1.unproject_place([number, x, y]);
        let (sin, cos) = self.0.turn(latitude);
        [atan2_degrees(sin, cos), lon]
    }
}

/// Converts faces and their coordinates x and y in [−1, 1] to geodetic latitudes and longitudes in degrees,
/// with the bits of [`CubeMap::unproject`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`FacePoint::new`](crate::cube::FacePoint::new)
/// refuses an element.
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
pub fn unproject<T: Real, P: CubeProjection, F: FaceNumber>(
    map: &CubeMap<T, P>,
    faces: &[F],
    points: [&[T]; 2],
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<InvalidPoint<T>>> {
    solve_by(
        (points, Faces::new(faces)),
        places,
        |point| {
            let place = map.unproject(face_point(point)?);
            Ok([place.lat(), place.lon()])
        },
        |points, places, tally| {
            map.projection().with(UnprojectAll {
                shifted: map.shifted(),
                points,
                places,
                tally,
            });
        },
    )
}

/// Unprojects faces and points into latitudes and longitudes: at once, or by way of directions.
pub(super) struct UnprojectAll<'a, 't, T, F> {
    pub(super) shifted: Shifted<T>,
    pub(super) points: ([&'a [T]; 2], Faces<&'a [F], T>),
    pub(super) places: [&'a mut [T]; 2],
    pub(super) tally: &'t mut Tally<InvalidPoint<T>>,
}

impl<T: Real, F: FaceNumber> ProjectionTask for UnprojectAll<'_, '_, T, F> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self {
            shifted,
            points,
            mut places,
            tally,
        } = self;
        let [_, correction] = shifted.corrections();
        if P::TAKES_PLACES {
            with_correction!(&correction, turn => {
                lanes(Behind(Points, UnprojectPlace(*turn, projection)), points, places, tally);
            });
            return;
        }
        let (mut points, mut faces) = points;
        let mut directions = [[T::ZERO; CHUNK]; 3];
        while let here @ 1.. = points[0].len().min(CHUNK) {
            let points = head(&mut points, here);
            UnprojectInLanes {
                points: (points, faces.head(here)),
                directions: directions
                    .each_mut()
                    .map(|column| column.get_mut(..here).unwrap_or_default()),
                tally: &mut *tally,
            }
            .run(projection);
            let columns = directions
                .each_ref()
                .map(|column| column.get(..here).unwrap_or_default());
            let known = Vectors { known: true };
            to_lat_lon_in_lanes(&correction, known, columns, front(&mut places, here), &mut Tally::new());
        }
    }
}
