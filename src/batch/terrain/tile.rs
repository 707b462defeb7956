use core::fmt;

use crate::Real;
use crate::batch::cube::{InvalidPoint, Points, face_point};
use crate::batch::engine::{refuse_all, solve_by};
use crate::batch::face_number::Faces;
use crate::batch::{FaceNumber, InvalidBatch};
use crate::simd::{Behind, Kernel, lanes};
use crate::terrain::{InvalidTile, Tile};

/// Why an element has no tile: of what it is made, `E` says.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidTiled<E> {
    /// There is no such place.
    Place(E),
    /// The level is above 30, for all elements.
    Tile(InvalidTile),
}

impl<E: fmt::Display> fmt::Display for InvalidTiled<E> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Place(why) => why.fmt(f),
            Self::Tile(why) => why.fmt(f),
        }
    }
}

impl<E: fmt::Debug + fmt::Display> core::error::Error for InvalidTiled<E> {}

/// Column and row of a point at a level.
#[derive(Clone, Copy)]
struct Square(u8);

impl<T: Real> Kernel<([T; 2], T)> for Square {
    type Output = [u32; 2];

    #[inline(always)]
    fn apply(&self, (point, _): ([T; 2], T)) -> [u32; 2] {
        point.map(|x| Tile::index(x, self.0))
    }
}

/// Finds the tiles of a level that contain points of the cube: columns and rows, with the bits of
/// [`Tile::containing`]. Faces are those of the points.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`FacePoint::new`](crate::cube::FacePoint::new)
/// refuses an element: its column and row are 0. If the level is above 30, all elements are refused.
///
/// ```
/// use terrella::batch::terrain;
/// use terrella::cube::Face;
/// let (mut i, mut j) = ([0; 2], [0; 2]);
/// terrain::containing(3, &[Face::Top, Face::Left], [&[0.3, -1.0], &[-0.4, 0.0]], [&mut i, &mut j])?;
/// assert_eq!((i, j), ([5, 0], [2, 4]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn containing<T: Real, F: FaceNumber>(
    level: u8,
    faces: &[F],
    points: [&[T]; 2],
    squares: [&mut [u32]; 2],
) -> Result<(), InvalidBatch<InvalidTiled<InvalidPoint<T>>>> {
    let source = (points, Faces::new(faces));
    if level > Tile::MAX_LEVEL {
        return refuse_all(source, squares, InvalidTiled::Tile(InvalidTile::Level(level)));
    }
    let result = solve_by(
        source,
        squares,
        |point| {
            let point = face_point(point)?;
            Ok([point.x(), point.y()].map(|x| Tile::index(x, level)))
        },
        |points, squares, tally| lanes(Behind(Points, Square(level)), points, squares, tally),
    );
    result.map_err(|invalid| invalid.map(InvalidTiled::Place))
}
