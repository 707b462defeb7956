use super::Curve;
use super::key::sealed::Order;
use crate::cube::Face;
use crate::math::{gathered, spread};

/// Morton's order: the bits of column and row in turn (Morton, IBM 1966), with this crate's faces and axes.
///
/// Cheaper than [`Hilbert`](super::Hilbert)'s, and the children of a tile are in the order of [`Tile::children`](super::Tile::children); but from one to the
/// next it may be far.
///
/// ```
/// use terrella::cube::Face;
/// use terrella::terrain::{Key, Morton, Tile};
/// let tile = Tile::new(Face::Back, 3, 0b101, 0b011)?;
/// assert_eq!(Key::<Morton>::from(tile).bits() >> 54, 0b010_01_10_11_1);
/// # Ok::<(), terrella::terrain::InvalidTile>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Morton;

impl Curve for Morton {}

impl Order for Morton {
    #[inline(always)]
    fn number(face: Face) -> u8 {
        face.index()
    }

    #[inline(always)]
    fn face(number: u8) -> Face {
        Face::from_index(number).unwrap_or(Face::Front)
    }

    #[inline(always)]
    fn place(_: Face, i: u32, j: u32) -> u64 {
        spread(i) | spread(j) << 1
    }

    #[inline(always)]
    fn square(_: Face, place: u64) -> (u32, u32) {
        (gathered(place), gathered(place >> 1))
    }
}
