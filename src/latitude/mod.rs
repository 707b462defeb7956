//! Auxiliary latitudes: [`Conversion`] from one to another, and [`Shifted`], the step from ellipsoid to sphere.

use core::fmt;

use crate::name::by_name;

mod conversion;
mod correction;
mod shifted;

pub(crate) use conversion::{Angle, Degrees, Radians, conformal, corrected, isometric};
pub use conversion::{Conversion, InvalidLatitude};
pub(crate) use correction::{Correction, Turn, Unturned, with_correction};
pub use shifted::Shifted;
pub(crate) use shifted::normal;

macro_rules! names {
    ($(#[$doc:meta])* $kind:ident, $unknown:ident, $what:literal: $($(#[$variant_doc:meta])* $variant:ident $name:literal,)*) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
        pub enum $kind {
            $($(#[$variant_doc])* $variant,)*
        }

        impl $kind {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The name, in lower case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }

        by_name!($kind, $unknown, $what);
    };
}

names! {
    /// A kind of latitude.
    Latitude, UnknownLatitude, "latitude":
    /// φ: the angle between the ellipsoid's normal and the equatorial plane. What maps and receivers give.
    Geodetic "geodetic",
    /// θ: the angle between the radius and the equatorial plane, tan θ = (1 − e²) tan φ.
    Geocentric "geocentric",
    /// β, also called reduced: tan β = (1 − f) tan φ.
    Parametric "parametric",
    /// ξ: that of the sphere of equal area.
    Authalic "authalic",
    /// χ: that of the conformal map onto the sphere.
    Conformal "conformal",
    /// μ: proportional to the distance from the equator along the meridian.
    Rectifying "rectifying",
    /// ψ: the ordinate of Mercator's map in radians; infinite at the poles.
    Isometric "isometric",
}

names! {
    /// Which latitude is taken for that of the sphere.
    ///
    /// Authalic keeps areas, conformal keeps angles; geocentric is what PROJ's `qsc` and `s2` do.
    Shift, UnknownShift, "shift":
    /// The geodetic latitude itself.
    Geodetic "geodetic",
    /// The geocentric latitude: every point stays on its ray from the centre.
    Geocentric "geocentric",
    /// The parametric latitude.
    Parametric "parametric",
    /// The authalic latitude: an equal-area projection of the sphere is one of the ellipsoid.
    Authalic "authalic",
    /// The conformal latitude: a conformal projection of the sphere is one of the ellipsoid.
    Conformal "conformal",
    /// The rectifying latitude: equal steps along a meridian stay equal.
    Rectifying "rectifying",
}

#[allow(clippy::derivable_impls)] // the macro's enums have no default of their own
impl Default for Shift {
    /// Authalic, for the sake of the equal-area projections.
    fn default() -> Self {
        Self::Authalic
    }
}

impl From<Shift> for Latitude {
    fn from(shift: Shift) -> Self {
        match shift {
            Shift::Geodetic => Self::Geodetic,
            Shift::Geocentric => Self::Geocentric,
            Shift::Parametric => Self::Parametric,
            Shift::Authalic => Self::Authalic,
            Shift::Conformal => Self::Conformal,
            Shift::Rectifying => Self::Rectifying,
        }
    }
}

/// A flattening outside the range in which a formula keeps its accuracy.
///
/// That is −1/9 ≤ f ≤ 1/10 for the series of the authalic, conformal, rectifying and isometric latitudes, and −1 ≤ f ≤ ½ for the
/// geocentric and parametric ones; the geodetic latitude needs no formula. [`Karney`](crate::geodesic::Karney)'s geodesics hold for −1/9 ≤ f ≤ 1/10,
/// the other methods on the ellipsoid for |f| ≤ 1/60.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UnsupportedFlattening<T>(pub T);

impl<T: fmt::Debug> fmt::Display for UnsupportedFlattening<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "flattening {:?} is out of range for this formula", self.0)
    }
}

impl<T: fmt::Debug> core::error::Error for UnsupportedFlattening<T> {}
