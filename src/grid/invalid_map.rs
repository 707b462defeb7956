use core::fmt;

use crate::Real;
use crate::latitude::UnsupportedFlattening;

/// Why the constructor of a conformal projection refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidMap<T> {
    /// The flattening is out of the projection's range.
    Flattening(UnsupportedFlattening<T>),
    /// The scale is outside [10⁻³, 10³] or NaN.
    Scale(T),
    /// The longitude of the central meridian is infinite or NaN.
    Meridian(T),
}

impl<T: Real> InvalidMap<T> {
    /// Refuses a scale that projections do not take.
    pub(super) fn check_scale(scale: T) -> Result<(), Self> {
        let holds = (T::of(1e-3)..=T::of(1e3)).contains(&scale);
        if holds { Ok(()) } else { Err(Self::Scale(scale)) }
    }
}

impl<T> From<UnsupportedFlattening<T>> for InvalidMap<T> {
    fn from(why: UnsupportedFlattening<T>) -> Self {
        Self::Flattening(why)
    }
}

impl<T: fmt::Debug> fmt::Display for InvalidMap<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flattening(why) => why.fmt(f),
            Self::Scale(scale) => write!(f, "scale {scale:?} is not in [0.001, 1000]"),
            Self::Meridian(lon) => write!(f, "central meridian {lon:?} is not finite"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidMap<T> {}
