use core::fmt;
use core::ops::RangeInclusive;
use core::str::FromStr;

use super::Tile;

/// A space-filling curve that numbers the tiles of all faces and levels: [`Morton`](super::Morton) or
/// [`Hilbert`](super::Hilbert).
///
/// This trait is sealed: other crates cannot implement it.
pub trait Curve: sealed::Order {}

pub(super) mod sealed {
    use core::fmt::Debug;
    use core::hash::Hash;

    use crate::cube::Face;

    /// A curve through the six faces and through the 2³⁰ × 2³⁰ finest squares of each face.
    pub trait Order: Copy + Debug + Default + Ord + Hash {
        /// Returns the number of a face on the curve, 0 to 5.
        fn number(face: Face) -> u8;

        /// Returns the face that has this number; returns some face for a number above 5.
        fn face(number: u8) -> Face;

        /// Returns the position of column i and row j along the curve within a face, a number of 60 bits. i
        /// and j have 30 bits each; the first 2L bits of the position depend only on the first L bits of i
        /// and j.
        fn place(face: Face, i: u32, j: u32) -> u64;

        /// Returns the column and row of a position along the curve: the inverse of [`place`](Self::place).
        fn square(face: Face, place: u64) -> (u32, u32);
    }
}

/// A quadtree tile as one 64-bit number; the numbers follow the order of a space-filling curve.
///
/// The layout is that of S2's cell ids (Google, `s2cell_id.h`): three bits for the face, two bits for each
/// level, then a one, then zeros. The keys of a tile and of all its descendants form one contiguous
/// [`range`](Self::range), with the tile's own key in its middle. A sorted table or a tree can therefore look
/// up a whole subtree as one range. Tiles with consecutive keys are near each other on the ground, more so on
/// [`Hilbert`](super::Hilbert)'s curve than on [`Morton`](super::Morton)'s. On Hilbert's curve a key is the
/// id of S2's cell; [`s2_leaf`](Key::s2_leaf) returns the key of a direction.
///
/// The text form ([`Display`](fmt::Display), [`FromStr`]) is S2's token: the hexadecimal digits without
/// trailing zeros, suitable for a file name. Tokens of one level sort in the same order as their keys.
///
/// ```
/// use std::collections::BTreeMap;
/// use terrella::cube::Face;
/// use terrella::terrain::{Hilbert, Key, Tile};
///
/// let tile = Tile::new(Face::Right, 2, 1, 3)?;
/// let key = Key::<Hilbert>::from(tile);
/// assert_eq!((key.bits(), key.to_string().as_str()), (0x3900_0000_0000_0000, "39"));
/// assert_eq!(("39".parse(), Tile::from(key)), (Ok(key), tile));
///
/// let mut loaded = BTreeMap::from([(key, "a texture")]);
/// let face = Key::<Hilbert>::from(Tile::root(Face::Right));
/// assert_eq!(loaded.range(face.range()).count(), 1);
/// # Ok::<(), terrella::terrain::InvalidTile>(())
/// ```
#[doc(alias = "quadkey")]
#[doc(alias = "space-filling curve")]
#[doc(alias = "S2CellId")]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Key<C> {
    bits: u64,
    curve: C,
}

/// The lower bit of every pair of bits: the possible positions of the bit that ends a key.
const PAIRS: u64 = 0x1555_5555_5555_5555;
/// The number of bits below the three bits of the face.
const BELOW_FACE: u32 = 61;

impl<C: Curve> Key<C> {
    /// Creates a key from its number.
    ///
    /// ```
    /// use terrella::terrain::{InvalidKey, Key, Morton};
    /// assert_eq!(Key::<Morton>::new(0x5000_0000_0000_0000)?.level(), 0);
    /// assert_eq!(Key::<Morton>::new(0x5000_0000_0000_0002), Err(InvalidKey(0x5000_0000_0000_0002)));
    /// # Ok::<(), InvalidKey>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidKey`] if the face, in the highest three bits, is above 5, or if the lowest bit that is set is
    /// not at the position where a key of some level ends (an even position, 0 to 60).
    #[inline]
    pub fn new(bits: u64) -> Result<Self, InvalidKey> {
        if Self::is_key(bits) {
            Ok(Self::within(bits))
        } else {
            Err(InvalidKey(bits))
        }
    }

    /// Whether a key has this number.
    #[inline(always)]
    pub(crate) const fn is_key(bits: u64) -> bool {
        (bits >> BELOW_FACE < 6) & (bits & bits.wrapping_neg() & PAIRS != 0)
    }

    /// Creates a key from a number that is known to be one.
    #[inline(always)]
    pub(crate) fn within(bits: u64) -> Self {
        Self {
            bits,
            curve: C::default(),
        }
    }

    /// Returns the number.
    #[must_use]
    #[inline(always)]
    pub const fn bits(self) -> u64 {
        self.bits
    }

    /// Returns the tile's level, 0 to 30.
    #[must_use]
    #[inline(always)]
    pub const fn level(self) -> u8 {
        Tile::MAX_LEVEL - (self.bits.trailing_zeros() / 2) as u8
    }

    /// The lowest bit that is set: it ends the number and marks the level.
    #[inline(always)]
    const fn end(self) -> u64 {
        self.bits & self.bits.wrapping_neg()
    }

    /// Returns the key of the tile of `level` that contains this tile (the tile itself for its own level).
    /// Returns `None` if `level` is finer than this tile's level.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::{Hilbert, Key, Tile};
    /// let key = Key::<Hilbert>::from(Tile::new(Face::Top, 9, 100, 200)?);
    /// assert_eq!(key.ancestor(0), Some(Tile::root(Face::Top).into()));
    /// assert_eq!(key.ancestor(10), None);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn ancestor(self, level: u8) -> Option<Self> {
        (level <= self.level()).then(|| {
            let end = end_of(level);
            Self::within(self.bits & end.wrapping_neg() | end)
        })
    }

    /// Returns the key of the finest tile that contains this tile and another, or `None` if they are on
    /// different faces.
    ///
    /// ```
    /// use terrella::terrain::{Hilbert, Key};
    /// let key = |token: &str| token.parse::<Key<Hilbert>>();
    /// assert_eq!(key("357b3cd6f85")?.common_ancestor(key("357b3cd6ff3")?), Some(key("357b3cd6fc")?));
    /// # Ok::<(), terrella::terrain::InvalidToken>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn common_ancestor(self, other: Self) -> Option<Self> {
        let coarser = if self.end() < other.end() {
            other.end()
        } else {
            self.end()
        };
        // The highest bit that differs, or that ends a key, belongs to the first level that differs.
        let length = u64::BITS - ((self.bits ^ other.bits) | coarser).leading_zeros();
        let end = 1_u64.checked_shl(2 * (length / 2)).filter(|_| length <= BELOW_FACE)?;
        Some(Self::within(self.bits & end.wrapping_neg() & !end | end))
    }

    /// Returns the range of keys of this tile and all its descendants down to level 30, from the smallest key
    /// to the largest.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::{Key, Morton, Tile};
    /// let key = Key::<Morton>::from(Tile::new(Face::Front, 29, 1, 0)?);
    /// assert_eq!((key.range().start().bits(), key.range().end().bits()), (0b1001, 0b1111));
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    #[inline]
    pub fn range(self) -> RangeInclusive<Self> {
        let half = self.end() - 1;
        Self::within(self.bits - half)..=Self::within(self.bits + half)
    }

    /// Returns whether `other` is this key or the key of a descendant.
    #[must_use]
    #[inline]
    pub const fn contains(self, other: Self) -> bool {
        self.bits.abs_diff(other.bits) < self.end()
    }
}

/// The bit that ends a key of this level.
#[inline(always)]
const fn end_of(level: u8) -> u64 {
    1 << (2 * (Tile::MAX_LEVEL - level))
}

impl<C: Curve> From<Tile> for Key<C> {
    #[cfg_attr(not(small), inline(always))]
    fn from(Tile { face, level, i, j }: Tile) -> Self {
        let up = Tile::MAX_LEVEL - level;
        let place = u64::from(C::number(face)) << (BELOW_FACE - 1) | C::place(face, i << up, j << up);
        let end = end_of(level);
        Self::within((place << 1) & (end << 1).wrapping_neg() | end)
    }
}

impl<C: Curve> From<Key<C>> for Tile {
    #[cfg_attr(not(small), inline(always))]
    fn from(key: Key<C>) -> Self {
        let level = key.level();
        let face = C::face((key.bits >> BELOW_FACE) as u8);
        let place = (key.bits ^ key.end()) >> 1 & ((1 << (BELOW_FACE - 1)) - 1);
        let (i, j) = C::square(face, place);
        let up = Self::MAX_LEVEL - level;
        Self::within(face, level, i >> up, j >> up)
    }
}

impl<C: Curve> fmt::Display for Key<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let zeros = self.bits.trailing_zeros() / 4;
        let digits = 16 - zeros as usize;
        write!(f, "{:0digits$x}", self.bits >> (4 * zeros))
    }
}

impl<C: Curve> fmt::Debug for Key<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?}({self})", self.curve)
    }
}

#[cfg(feature = "defmt")]
impl<C: Curve> defmt::Format for Key<C> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{=u64:016x}", self.bits);
    }
}

impl<C: Curve> FromStr for Key<C> {
    type Err = InvalidToken;

    /// Parses 1 to 16 hexadecimal digits; digits that are left out at the end are zeros.
    ///
    /// # Errors
    /// [`InvalidToken`] if the text has another length, contains another character, or is not the number of a
    /// tile.
    fn from_str(token: &str) -> Result<Self, InvalidToken> {
        let length = token.len();
        if !(1..=16).contains(&length) {
            return Err(InvalidToken::Length(length));
        }
        let mut bits = 0;
        for character in token.chars() {
            let digit = character.to_digit(16).ok_or(InvalidToken::Digit(character))?;
            bits = bits << 4 | u64::from(digit);
        }
        Self::new(bits << (4 * (16 - length))).map_err(InvalidToken::Key)
    }
}

/// The error of [`Key::new`]: this number is not the key of any tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidKey(pub u64);

impl fmt::Display for InvalidKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#018x} is not the key of a tile", self.0)
    }
}

impl core::error::Error for InvalidKey {}

/// The error of parsing a [`Key`] from text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidToken {
    /// The length in bytes; it is not 1 to 16.
    Length(usize),
    /// The first character that is not a hexadecimal digit.
    Digit(char),
    /// The number that was parsed is not a key.
    Key(InvalidKey),
}

impl fmt::Display for InvalidToken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "expected a token of 1 to 16 bytes, got {length}"),
            Self::Digit(character) => write!(f, "{character:?} is not a hexadecimal digit"),
            Self::Key(key) => key.fmt(f),
        }
    }
}

impl core::error::Error for InvalidToken {}
