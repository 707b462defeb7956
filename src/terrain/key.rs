use core::fmt;
use core::ops::RangeInclusive;
use core::str::FromStr;

use super::Tile;

/// How the tiles of all faces and levels are laid on a line: [`Morton`](super::Morton) or
/// [`Hilbert`](super::Hilbert). Sealed.
pub trait Curve: sealed::Order {}

pub(super) mod sealed {
    use core::fmt::Debug;
    use core::hash::Hash;

    use crate::cube::Face;

    /// A curve through the faces, and through the 2³⁰ × 2³⁰ squares of each.
    pub trait Order: Copy + Debug + Default + Ord + Hash {
        /// The number of a face, 0 to 5.
        fn number(face: Face) -> u8;

        /// The face of a number; any face above 5.
        fn face(number: u8) -> Face;

        /// The place of column i and row j along the curve in a face. The first 2L of 60 bits depend on the
        /// first L of 30.
        fn place(face: Face, i: u32, j: u32) -> u64;

        /// The column and row of a place.
        fn square(face: Face, place: u64) -> (u32, u32);
    }
}

/// A tile as one number, in the order of a curve.
///
/// Three bits of face, then two for each level, then a one, then zeros: the layout of S2's cell ids (Google,
/// `s2cell_id.h`). A tile's descendants are a range, and so every ancestor's, with which a sorted table or a
/// tree finds them; the tile itself is in the middle of it. Numbers next to each other are near on the
/// ground, the more so along [`Hilbert`](super::Hilbert)'s curve, with which a key is the id of S2's cell:
/// [`s2_leaf`](Key::s2_leaf) is that of a direction.
///
/// Written and parsed as S2's token: the digits in base 16 without the zeros at the end, fit for the name of
/// a file; of keys of one level tokens sort as the keys do.
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
#[doc(alias = "S2CellId")]
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Key<C> {
    bits: u64,
    curve: C,
}

/// Two bits of every pair.
const PAIRS: u64 = 0x1555_5555_5555_5555;
/// Bits below those of the face.
const BELOW_FACE: u32 = 61;

impl<C: Curve> Key<C> {
    /// The key of a number.
    ///
    /// ```
    /// use terrella::terrain::{InvalidKey, Key, Morton};
    /// assert_eq!(Key::<Morton>::new(0x5000_0000_0000_0000)?.level(), 0);
    /// assert_eq!(Key::<Morton>::new(0x5000_0000_0000_0002), Err(InvalidKey(0x5000_0000_0000_0002)));
    /// # Ok::<(), InvalidKey>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidKey`] if the first three bits are above 5, or the last one that is set is not where a level's
    /// is.
    #[inline]
    pub fn new(bits: u64) -> Result<Self, InvalidKey> {
        if bits >> BELOW_FACE < 6 && bits & bits.wrapping_neg() & PAIRS != 0 {
            Ok(Self::within(bits))
        } else {
            Err(InvalidKey(bits))
        }
    }

    #[inline(always)]
    fn within(bits: u64) -> Self {
        Self {
            bits,
            curve: C::default(),
        }
    }

    /// The number.
    #[must_use]
    #[inline(always)]
    pub const fn bits(self) -> u64 {
        self.bits
    }

    /// The tile's level.
    #[must_use]
    #[inline]
    pub const fn level(self) -> u8 {
        Tile::MAX_LEVEL - (self.bits.trailing_zeros() / 2) as u8
    }

    /// The bit that ends the number.
    #[inline(always)]
    const fn end(self) -> u64 {
        self.bits & self.bits.wrapping_neg()
    }

    /// The key of the tile of a coarser level, or the same, that holds this one; none for a finer level.
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

    /// The keys of the tile and all its descendants, to the finest level: from the smallest to the largest.
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

    /// Whether the other key is this one's or that of a descendant.
    #[must_use]
    #[inline]
    pub const fn contains(self, other: Self) -> bool {
        self.bits.abs_diff(other.bits) < self.end()
    }
}

/// The bit that ends a key of a level.
#[inline(always)]
const fn end_of(level: u8) -> u64 {
    1 << (2 * (Tile::MAX_LEVEL - level))
}

impl<C: Curve> From<Tile> for Key<C> {
    #[inline]
    fn from(Tile { face, level, i, j }: Tile) -> Self {
        let up = Tile::MAX_LEVEL - level;
        let place = u64::from(C::number(face)) << (BELOW_FACE - 1) | C::place(face, i << up, j << up);
        let end = end_of(level);
        Self::within((place << 1) & (end << 1).wrapping_neg() | end)
    }
}

impl<C: Curve> From<Key<C>> for Tile {
    #[inline]
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

    /// From 1 to 16 digits in base 16, those that are left out being zeros at the end.
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

/// A number that is not a [`Key`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidKey(pub u64);

impl fmt::Display for InvalidKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:#018x} is not the key of a tile", self.0)
    }
}

impl core::error::Error for InvalidKey {}

/// Why a text is not a [`Key`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidToken {
    /// Its length in bytes, which is not in 1 to 16.
    Length(usize),
    /// A character that is not a digit in base 16.
    Digit(char),
    /// The number is not a key.
    Key(InvalidKey),
}

impl fmt::Display for InvalidToken {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "expected a token of 1 to 16 bytes, got {length}"),
            Self::Digit(character) => write!(f, "{character:?} is not a digit in base 16"),
            Self::Key(key) => key.fmt(f),
        }
    }
}

impl core::error::Error for InvalidToken {}
