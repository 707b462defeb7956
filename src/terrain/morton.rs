use super::Curve;
use super::key::sealed::Order;
use crate::cube::Face;
use crate::math::{gathered, spread};

/// Morton's order (z-order): the bits of column and row alternate (Morton, IBM 1966). It uses this crate's
/// face numbers and axes.
///
/// It is cheaper to compute than [`Hilbert`](super::Hilbert)'s curve, and it visits the children of a tile in
/// the order of [`Tile::children`](super::Tile::children). Unlike on Hilbert's curve, two tiles with
/// consecutive keys may be far apart.
///
/// ```
/// use terrella::cube::Face;
/// use terrella::terrain::{Key, Morton, Tile};
/// let tile = Tile::new(Face::Back, 3, 0b101, 0b011)?;
/// assert_eq!(Key::<Morton>::from(tile).bits() >> 54, 0b010_01_10_11_1);
/// # Ok::<(), terrella::terrain::InvalidTile>(())
/// ```
#[doc(alias = "z-order")]
#[doc(alias = "Z-order curve")]
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
        Face::numbered(if number > 5 { 0 } else { number })
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
