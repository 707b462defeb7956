use core::fmt;

use super::Heights;
use super::bilinear::{mean, weights};

/// The heights above the ellipsoid, one for each corner of a tile, to which the corners of its patch are
/// lifted in double precision. Between the corners they are interpolated bilinearly.
///
/// A vertex stores its height above this base in single precision. Choose a base near the ground: at most
/// some hundred metres from it in tiles next to the eye. There are three ways:
///
/// * The middle of a tile's height range ([`From<Heights>`](Heights)): a level base. Tiles of different bases
///   agree along a common edge within rounding only; a skirt hides the gap.
/// * The heights of the ground at the corners ([`new`](Self::new)): two tiles that share an edge and a level
///   have the same base along it, with identical bits.
/// * The ellipsoid itself ([`default`](Self::default)): for water, and where millimetres do not matter. At a
///   height of 8 km, `f32` has steps of half a millimetre.
///
/// ```
/// use terrella::terrain::{Base, Heights};
/// let level = Base::from(Heights::new(4_000.0, 4_400.0)?);
/// assert_eq!(level.at([3, 5], 9), 4_200.0);
/// // Counter-clockwise from the corner of largest x and y.
/// let sloping = Base::new([4_400.0, 4_300.0, 4_100.0, 4_200.0])?;
/// let corners = [[8, 8], [0, 8], [0, 0], [8, 0]].map(|node| sloping.at(node, 9));
/// assert_eq!((corners, sloping.at([4, 4], 9)), (sloping.corners(), 4_250.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Base {
    corners: [f64; 4],
}

impl Base {
    /// Creates a base from the heights at the corners, in metres, in the order of
    /// [`Corner::ALL`](crate::cube::Corner::ALL): counter-clockwise from the corner of largest x and y.
    ///
    /// # Errors
    /// [`InvalidBase`] if a height is infinite or NaN.
    pub fn new(corners: [f64; 4]) -> Result<Self, InvalidBase> {
        match corners.iter().find(|height| !height.is_finite()) {
            Some(&height) => Err(InvalidBase(height)),
            None => Ok(Self { corners }),
        }
    }

    /// Returns the heights at the corners, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn corners(self) -> [f64; 4] {
        self.corners
    }

    /// Returns the height of the base in column m and row n of a grid of `samples` × `samples`, in metres.
    /// Subtract it from a vertex's height above the ellipsoid. The result is within 2 ulps of the largest of
    /// the four heights.
    #[must_use]
    #[inline]
    pub fn at(self, [m, n]: [u32; 2], samples: u32) -> f64 {
        let last = samples.saturating_sub(1).max(1);
        let place = [m.min(last), n.min(last)].map(f64::from);
        mean(self.corners, weights(place, last.into()))
    }
}

/// A level base in the middle of the range.
impl From<Heights<f64>> for Base {
    fn from(heights: Heights<f64>) -> Self {
        Self {
            corners: [0.5 * heights.low() + 0.5 * heights.high(); 4],
        }
    }
}

/// The error of [`Base::new`]: this height is infinite or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidBase(pub f64);

impl fmt::Display for InvalidBase {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "height {:?} is not finite", self.0)
    }
}

impl core::error::Error for InvalidBase {}
