use core::fmt;

use crate::Real;

/// North or south of the equator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Hemisphere {
    /// The northern one, written `n`.
    North,
    /// The southern one, written `s`.
    South,
}

impl Hemisphere {
    /// Returns the hemisphere of a latitude: that of its sign, so that −0 is in the south.
    #[must_use]
    pub fn of<T: Real>(lat: T) -> Self {
        if T::ONE.copysign(lat) > T::ZERO {
            Self::North
        } else {
            Self::South
        }
    }

    /// 1 in the north, −1 in the south.
    #[inline(always)]
    pub(super) fn sign<T: Real>(self) -> T {
        match self {
            Self::North => T::ONE,
            Self::South => -T::ONE,
        }
    }
}

/// Writes `n` or `s`.
impl fmt::Display for Hemisphere {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::North => "n",
            Self::South => "s",
        })
    }
}
