use core::convert::Infallible;

use crate::Real;
use crate::batch::InvalidBatch;
use crate::batch::cube::UnprojectInLanes;
use crate::batch::face_number::Faces;
use crate::batch::map::UnprojectAll;
use crate::cube::{CubeMap, CubeProjection, FacePoint};
use crate::simd::{CHUNK, Sink, Tally, front};
use crate::terrain::Tile;

/// The samples of a tile that are still to come, row by row from below.
struct Samples<T> {
    tile: Tile,
    count: u32,
    column: u32,
    row: u32,
    y: T,
}

impl<T: Real> Samples<T> {
    fn new(tile: Tile, samples: u32) -> Self {
        let count = samples.saturating_sub(1);
        Self {
            tile,
            count,
            column: 0,
            row: 0,
            y: tile.coordinate(tile.j(), 0, count),
        }
    }

    /// The coordinates of the next sample.
    #[inline(always)]
    fn next(&mut self) -> [T; 2] {
        let Self { tile, count, .. } = *self;
        if self.column > count {
            (self.column, self.row) = (0, self.row + 1);
            self.y = tile.coordinate(tile.j(), self.row, count);
        }
        let x = tile.coordinate(tile.i(), self.column, count);
        self.column += 1;
        [x, self.y]
    }
}

/// Fills columns with what becomes of the samples: of a few at a time by `lanes`, or of one by `one`.
fn fill<T: Real, const N: usize>(
    tile: Tile,
    samples: u32,
    mut columns: [&mut [T]; N],
    one: impl Fn(FacePoint<T>) -> [T; N],
    in_lanes: impl Fn([&[T]; 2], &[u8], [&mut [T]; N]),
) -> Result<(), InvalidBatch<Infallible>> {
    let edge = usize::try_from(samples).unwrap_or(usize::MAX);
    let first = edge.saturating_mul(edge);
    if let Some(other) = columns.other_length(first) {
        return Err(InvalidBatch::Lengths { first, other });
    }
    let mut rest = Samples::new(tile, samples);
    if !cfg!(lanes) {
        for _ in 0..first {
            let [x, y] = rest.next();
            columns.push(one(FacePoint::within(tile.face(), x, y)));
        }
        return Ok(());
    }
    let faces = [tile.face().index(); CHUNK];
    let mut points = [[T::ZERO; CHUNK]; 2];
    while let here @ 1.. = columns.first().map_or(0, |column| column.len()).min(CHUNK) {
        let [x, y] = &mut points;
        for (x, y) in x.iter_mut().zip(y).take(here) {
            [*x, *y] = rest.next();
        }
        let points = points.each_ref().map(|column| column.get(..here).unwrap_or_default());
        in_lanes(points, faces.get(..here).unwrap_or_default(), front(&mut columns, here));
    }
    Ok(())
}

/// Returns the geodetic latitudes and longitudes in degrees of the samples of a tile, with the bits of
/// [`CubeMap::unproject`] of [`Tile::node`].
///
/// There are `samples` × `samples` of them, row by row from below: sample (m, n) is at (s, t) =
/// (m, n)/(`samples` − 1), so the first and the last of a row lie on the tile's edges. A single sample is the
/// lower left corner. For points above the ellipsoid in Earth axes, pass the places with heights to
/// [`batch::ellipsoid::to_ecef`](crate::batch::ellipsoid::to_ecef).
///
/// # Errors
/// [`InvalidBatch::Lengths`] if a slice does not have `samples`² elements. No element is refused.
///
/// ```
/// use terrella::cube::{Balanced, CubeMap, Face};
/// use terrella::terrain::Tile;
/// use terrella::{Ellipsoid, Shift, batch::terrain};
/// let earth = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Balanced)?;
/// let (mut lat, mut lon) = ([0.0; 9], [0.0; 9]);
/// terrain::sample_places(&earth, Tile::root(Face::Right), 3, [&mut lat, &mut lon])?;
/// assert_eq!((lat[4], lon[4], lon[3], lon[5]), (0.0, 90.0, 45.0, 135.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_places<T: Real, P: CubeProjection>(
    map: &CubeMap<T, P>,
    tile: Tile,
    samples: u32,
    places: [&mut [T]; 2],
) -> Result<(), InvalidBatch<Infallible>> {
    fill(
        tile,
        samples,
        places,
        |point| {
            let place = map.unproject(point);
            [place.lat(), place.lon()]
        },
        |points, faces, places| {
            map.projection().with(UnprojectAll {
                shifted: map.shifted(),
                points: (points, Faces::new(faces)),
                places,
                tally: &mut Tally::new(),
            });
        },
    )
}

/// Returns the directions, on the sphere, of the samples of a tile, with the bits of
/// [`CubeProjection::unproject`] of [`Tile::node`]. The samples are those of [`sample_places`].
///
/// # Errors
/// [`InvalidBatch::Lengths`] if a slice does not have `samples`² elements. No element is refused.
///
/// ```
/// use terrella::batch::terrain;
/// use terrella::cube::{Balanced, Face};
/// use terrella::terrain::Tile;
/// let (mut x, mut y, mut z) = ([0.0; 9], [0.0; 9], [0.0; 9]);
/// terrain::sample_directions(Balanced, Tile::root(Face::Right), 3, [&mut x, &mut y, &mut z])?;
/// assert_eq!((x[4], y[4], z[4]), (0.0, 1.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn sample_directions<T: Real, P: CubeProjection>(
    projection: P,
    tile: Tile,
    samples: u32,
    directions: [&mut [T]; 3],
) -> Result<(), InvalidBatch<Infallible>> {
    fill(
        tile,
        samples,
        directions,
        |point| projection.unproject(point).to_array(),
        |points, faces, directions| {
            projection.with(UnprojectInLanes {
                points: (points, Faces::new(faces)),
                directions,
                tally: &mut Tally::new(),
            });
        },
    )
}
