//! Auxiliary latitudes, and the step from the ellipsoid to the sphere.
//!
//! An auxiliary latitude is an angle that takes the place of the geodetic latitude in a formula, because it
//! keeps a property: areas (authalic), angles (conformal), lengths of meridians (rectifying).
//!
//! * [`Conversion`] converts an angle from one [`Latitude`] to another.
//! * [`Shifted`] converts geodetic latitude and longitude on an ellipsoid to a unit vector on the sphere, and
//!   back; [`Shift`] says which auxiliary latitude becomes the sphere's latitude.
//!
//! [`batch::latitude`](crate::batch::latitude) does both for whole slices.

use core::fmt;

use crate::name::by_name;

mod conversion;
mod correction;
mod shifted;

pub(crate) use conversion::{Angle, Degrees, Radians, conformal, corrected, isometric};
pub use conversion::{Conversion, InvalidLatitude};
pub(crate) use correction::{
    Correction, SineSeries, Turn, Unturned, coefficients, is_short, supported, terms, with_correction,
};
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
            #[doc = concat!("Every ", $what, ", in the order of the list.")]
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Returns the name, in lower case. [`Display`](core::fmt::Display) writes it, and [`str::parse`]
            /// reads it.
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
    /// A kind of latitude: the geodetic latitude or an auxiliary one.
    ///
    /// φ is the geodetic latitude, f the flattening and e² = f(2 − f) the eccentricity squared. Each latitude
    /// is 0 at the equator and, except the isometric latitude, ±90° at the poles.
    #[doc(alias("auxiliary latitude"))]
    Latitude, UnknownLatitude, "latitude":
    /// φ, the geodetic latitude: the angle between the ellipsoid's normal and the equatorial plane. Maps and
    /// satellite receivers use it.
    #[doc(alias("geographic latitude"))]
    Geodetic "geodetic",
    /// θ, the geocentric latitude: the angle between the line to the Earth's centre and the equatorial plane,
    /// of a point on the ellipsoid. tan θ = (1 − e²) tan φ.
    #[doc(alias("geocentric latitude"))]
    Geocentric "geocentric",
    /// β, the parametric or reduced latitude: tan β = (1 − f) tan φ.
    #[doc(alias("reduced latitude", "parametric latitude"))]
    Parametric "parametric",
    /// ξ, the authalic latitude: the area between the equator and the parallel is the same on the sphere of
    /// equal total area as on the ellipsoid.
    #[doc(alias("authalic latitude"))]
    Authalic "authalic",
    /// χ, the conformal latitude: with it as the sphere's latitude, the map from the ellipsoid to the sphere
    /// keeps angles.
    #[doc(alias("conformal latitude"))]
    Conformal "conformal",
    /// μ, the rectifying latitude: proportional to the distance from the equator along the meridian.
    #[doc(alias("rectifying latitude"))]
    Rectifying "rectifying",
    /// ψ, the isometric latitude: the ordinate of Mercator's map on an ellipsoid of a = 1. It has no unit,
    /// and is infinite at the poles.
    #[doc(alias("isometric latitude", "Mercator"))]
    Isometric "isometric",
}

names! {
    /// Auxiliary latitude used as the sphere's latitude.
    ///
    /// The default is authalic, for the sake of the equal-area projections. PROJ's `qsc` and `s2` use the
    /// geocentric latitude. The longitude stays the same.
    Shift, UnknownShift, "shift":
    /// The geodetic latitude, unchanged: the outward normal of the ellipsoid becomes the direction on the
    /// sphere.
    Geodetic "geodetic",
    /// The geocentric latitude: every point of the ellipsoid stays on its ray from the centre.
    Geocentric "geocentric",
    /// The parametric (reduced) latitude: the ellipsoid is stretched along its axis until it is a sphere.
    Parametric "parametric",
    /// The authalic latitude: an equal-area projection of the sphere becomes an equal-area projection of the
    /// ellipsoid.
    Authalic "authalic",
    /// The conformal latitude: a conformal projection of the sphere becomes a conformal projection of the
    /// ellipsoid.
    Conformal "conformal",
    /// The rectifying latitude: equal distances along a meridian of the ellipsoid are equal on the sphere.
    Rectifying "rectifying",
}

#[allow(clippy::derivable_impls)] // the macro's enums have no default of their own
impl Default for Shift {
    /// Returns [`Shift::Authalic`], for the sake of the equal-area projections.
    fn default() -> Self {
        Self::Authalic
    }
}

impl From<Shift> for Latitude {
    /// Returns the latitude that the shift uses.
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

/// The error for a flattening f outside the range in which a formula keeps its accuracy.
///
/// | formula | range |
/// |---|---|
/// | geodetic latitude | any f |
/// | geocentric and parametric latitudes | −1 ≤ f ≤ ½ |
/// | authalic, conformal, rectifying and isometric latitudes | −1/9 ≤ f ≤ 1/10 |
/// | [`Karney`](crate::geodesic::Karney) and [`Area`](crate::geodesic::Area) | −1/9 ≤ f ≤ 1/10 |
/// | [`Rhumb`](crate::route::Rhumb) | −1/9 ≤ f ≤ 1/10 |
/// | [`Vincenty`](crate::geodesic::Vincenty) | 0 ≤ f ≤ 1/293 |
/// | the other methods on the ellipsoid; transverse Mercator, UTM and UPS | −1/60 ≤ f ≤ 1/60 |
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct UnsupportedFlattening<T>(pub T);

impl<T: fmt::Debug> fmt::Display for UnsupportedFlattening<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "flattening {:?} is outside the range in which this formula is accurate",
            self.0
        )
    }
}

impl<T: fmt::Debug> core::error::Error for UnsupportedFlattening<T> {}
