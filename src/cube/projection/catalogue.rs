//! The list of projections, as a type that picks one at run time.

use super::Projection;
use crate::name::by_name;

/// Declares a module for each projection of a list, and [`Projection`] with its functions.
macro_rules! projections {
    ($($(#[$attribute:meta])* $module:ident::$variant:ident,)*) => {
        $(
            mod $module;
            pub use $module::$variant;
        )*

        /// The projections of this crate, to choose one by name or at run time.
        ///
        /// Code that always uses the same projection names its type, for example
        /// [`Vertex`](struct@Vertex), and then links no other.
        ///
        /// ```
        /// use terrella::{Direction, cube::{CubeProjection, Projection}};
        /// let projection: Projection = "quadrilateralized".parse().unwrap();
        /// let p = projection.project(Direction::new(0.0, 0.0, 1.0).unwrap());
        /// assert_eq!((p.x(), p.y()), (0.0, 0.0));
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
        #[non_exhaustive]
        pub enum Projection {
            $(
                #[doc = concat!("[`", stringify!($variant), "`](struct@", stringify!($variant), ").")]
                $(#[$attribute])*
                $variant,
            )*
        }

        impl Projection {
            /// All projections, in the order in which they were added.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Returns the name, in lower case, with `-` between words. [`Display`](core::fmt::Display)
            /// writes it, and [`str::parse`] reads it.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => const { $module::$variant::PROFILE.name },)*
                }
            }

            /// Returns what is known of the projection: names, origin, distortion, errors and cost.
            #[must_use]
            pub const fn profile(self) -> &'static Profile {
                match self {
                    $(Self::$variant => &$module::$variant::PROFILE,)*
                }
            }

            /// How the errors of simplified tiles shrink with the level, without the rest of the profile.
            pub(crate) const fn tiles(self) -> [Decay; 2] {
                match self {
                    $(Self::$variant => const { $module::$variant::PROFILE.tiles },)*
                }
            }
        }

        // Not inlined: each function is as long as all projections together.
        impl CubeProjection for Projection {
            fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
                match self {
                    $(Self::$variant => $module::$variant.forward(face, local),)*
                }
            }

            fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
                match self {
                    $(Self::$variant => $module::$variant.inverse(face, point),)*
                }
            }

            fn with<W: ProjectionTask>(self, task: W) -> W::Output {
                match self {
                    $(Self::$variant => task.run($module::$variant),)*
                }
            }

            fn faces(&self) -> Faces {
                match self {
                    $(Self::$variant => $module::$variant.faces(),)*
                }
            }

            fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
                match self {
                    $(Self::$variant => $module::$variant.is_polar(direction),)*
                }
            }
        }
    };
}
pub(super) use projections;

by_name!(Projection, UnknownProjection, "projection");
