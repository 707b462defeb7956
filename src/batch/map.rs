//! Geodetic latitudes and longitudes to points of the cube's faces and back, through a [`CubeMap`].

use super::InvalidBatch;
use super::block::{CHUNK, admit, front};
use super::cube::{Points, project_units, unproject_points};
use super::position::{Places, turn_to_direction, turn_to_lat_lon};
use crate::cube::{CubeMap, CubeProjection, Face, InvalidFacePoint};
use crate::{InvalidLatLon, Real};

/// Geodetic latitudes and longitudes (degrees) to their places on the cube: [`CubeMap::project`].
///
/// # Errors
/// [`InvalidBatch`] for unequal lengths, and for what [`LatLon::new`](crate::LatLon::new) refuses; nothing is written then.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::{Ellipsoid, Shift, batch::map};
/// let earth = CubeMap::new(Ellipsoid::wgs84(), Shift::Authalic, Quadrilateralized)?;
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
    let [correction, _] = map.shifted().corrections();
    let lengths = [faces.len(), points[0].len(), points[1].len()];
    let mut faces = [faces];
    admit(&Places, places, &lengths, |length, mut places| {
        let mut directions = [[T::ZERO; CHUNK]; 3];
        let mut left = length;
        while left > 0 {
            let here = left.min(CHUNK);
            let columns = directions
                .each_mut()
                .map(|column| column.get_mut(..here).unwrap_or_default());
            turn_to_direction(&correction, next(&mut places, here), columns);
            let columns = directions
                .each_ref()
                .map(|column| column.get(..here).unwrap_or_default());
            let [faces] = front(&mut faces, here);
            project_units(map.projection(), columns, faces, front(&mut points, here));
            left -= here;
        }
    })
}

/// Places on the cube to geodetic latitudes and longitudes (degrees): [`CubeMap::unproject`].
///
/// # Errors
/// [`InvalidBatch`] for unequal lengths, and for what [`FacePoint::new`](crate::cube::FacePoint::new) refuses; nothing is written then.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Vertex};
/// use terrella::{Ellipsoid, Shift, batch::map};
/// let earth = CubeMap::new(Ellipsoid::wgs84(), Shift::Authalic, Vertex)?;
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
    let [_, correction] = map.shifted().corrections();
    let lengths = [faces.len(), places[0].len(), places[1].len()];
    admit(&Points, points, &lengths, |_, mut points| {
        let mut directions = [[T::ZERO; CHUNK]; 3];
        for faces in faces.chunks(CHUNK) {
            let here = faces.len();
            let columns = directions
                .each_mut()
                .map(|column| column.get_mut(..here).unwrap_or_default());
            unproject_points(map.projection(), faces, next(&mut points, here), columns);
            let columns = directions
                .each_ref()
                .map(|column| column.get(..here).unwrap_or_default());
            turn_to_lat_lon(&correction, columns, front(&mut places, here));
        }
    })
}

/// The first elements of each slice, which goes past them.
fn next<'a, T>(columns: &mut [&'a [T]; 2], length: usize) -> [&'a [T]; 2] {
    columns.each_mut().map(|column| {
        let (head, rest) = column.split_at_checked(length).unwrap_or_default();
        *column = rest;
        head
    })
}
