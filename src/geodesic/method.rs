use core::fmt;

use super::{AnyMethod, Geodesic, Method};
use crate::latitude::UnsupportedFlattening;
use crate::name::by_name;
use crate::{Ellipsoid, LatLon, Real};

/// Makes modules, [`Method`], [`AnyMethod`] and their functions of a list. One line a method:
/// `module::Type |ellipsoid| constructor`, or `|ellipsoid, place|`.
macro_rules! methods {
    ($(
        $module:ident::$variant:ident |$ellipsoid:ident $(, $place:ident)?| $make:expr;
    )*) => {
        $(
            mod $module;
            pub use $module::$variant;
        )*

        /// The methods of this crate, to choose one by name or at run time.
        ///
        /// Code that always uses the same method names its type, for example [`Karney`], and
        /// then links no other method. [`Scene::distances`](crate::scene::Scene::distances) chooses for you.
        ///
        /// ```
        /// use terrella::geodesic::{Geodesic, Method};
        /// use terrella::{Ellipsoid, LatLon};
        /// let method: Method = "vincenty".parse()?;
        /// let earth = method.on(Ellipsoid::WGS84)?;
        /// let (pole, equator) = (LatLon::new(90.0, 0.0)?, LatLon::new(0.0, 0.0)?);
        /// let quarter: f64 = earth.inverse(pole, equator)?.distance;
        /// assert!((quarter - 10_001_965.729_3).abs() < 1e-4);
        /// # Ok::<(), Box<dyn std::error::Error>>(())
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum Method {
            $(
                #[doc = concat!("[`", stringify!($variant), "`](struct@", stringify!($variant), ").")]
                $variant,
            )*
        }

        impl Method {
            /// All methods, in the order of [`instructions`](Self::instructions): the cheapest first.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// Returns the name, in lower case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => const { $module::PROFILE.name },)*
                }
            }

            /// Returns the number of instructions of one inverse problem: distance and azimuths in `f64`, on
            /// x86-64 with SSE2, to two digits.
            ///
            /// `benches/instructions/run` counts them.
            #[must_use]
            pub const fn instructions(self) -> u32 {
                match self {
                    $(Self::$variant => const { $module::PROFILE.instructions },)*
                }
            }

            /// Returns what is known of the method.
            #[must_use]
            pub const fn profile(self) -> &'static Profile {
                match self {
                    $(Self::$variant => &$module::PROFILE,)*
                }
            }

            /// Returns whether the method holds about one place only, so that [`about`](Self::about) makes
            /// it, and [`on`](Self::on) refuses.
            #[must_use]
            pub const fn needs_place(self) -> bool {
                match self {
                    $(Self::$variant => methods!(@place $($place)?),)*
                }
            }

            /// Creates the method on an ellipsoid, about a place.
            ///
            /// Only methods that [need a place](Self::needs_place) use it; the others hold everywhere.
            /// Methods of the sphere take the mean radius of the ellipsoid.
            ///
            /// # Errors
            /// [`UnsupportedFlattening`] if the method does not hold for this ellipsoid. The methods of the
            /// sphere always hold.
            ///
            /// ```
            /// use terrella::geodesic::{AnyMethod, Geodesic, Method};
            /// use terrella::{Ellipsoid, LatLon};
            /// let (zurich, bern) = (LatLon::new(47.377, 8.541)?, LatLon::new(46.948, 7.447)?);
            /// let plane = Method::Plane.about(Ellipsoid::<f64>::WGS84, zurich)?;
            /// let exact = Method::Karney.about(Ellipsoid::<f64>::WGS84, zurich)?;
            /// let metres = |by: AnyMethod<_>| by.inverse(zurich, bern).map(|line| line.distance);
            /// assert!((metres(plane)? - metres(exact)?).abs() < 5.0);
            /// # Ok::<(), Box<dyn std::error::Error>>(())
            /// ```
            pub fn about<T: Real>(
                self,
                ellipsoid: Ellipsoid<T>,
                place: LatLon<T>,
            ) -> Result<AnyMethod<T>, UnsupportedFlattening<T>> {
                match self {
                    $(
                        Self::$variant => {
                            let $ellipsoid = ellipsoid;
                            $(let $place = place;)?
                            $make.map(AnyMethod::$variant)
                        }
                    )*
                }
            }
        }

        /// A method that was chosen at run time, ready to use: from [`Method::on`], [`Method::about`] or
        /// [`Distances::solver`](crate::scene::Distances::solver).
        ///
        /// Each call finds out which method it is. Use [`visit`](Self::visit) to do that once, before a loop.
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[allow(clippy::large_enum_variant)] // nothing here allocates
        #[non_exhaustive]
        pub enum AnyMethod<T> {
            $(
                #[doc = concat!("Of [`Method::", stringify!($variant), "`].")]
                $variant($module::$variant<T>),
            )*
        }

        impl<T: Real> AnyMethod<T> {
            /// Calls `visitor` with the method as its own type, and returns what it returns.
            ///
            /// ```
            /// use terrella::geodesic::{Geodesic, Method, Visitor};
            /// use terrella::{Ellipsoid, LatLon};
            ///
            /// /// The length of a way through places.
            /// struct Length<'a>(&'a [LatLon<f64>]);
            ///
            /// impl Visitor<f64> for Length<'_> {
            ///     type Output = f64;
            ///
            ///     fn visit<M: Geodesic<f64>>(self, method: M) -> f64 {
            ///         let legs = self.0.windows(2);
            ///         legs.filter_map(|leg| Some(method.inverse(leg[0], leg[1]).ok()?.distance)).sum()
            ///     }
            /// }
            ///
            /// let way = [LatLon::new(0.0, 0.0)?, LatLon::new(0.0, 90.0)?, LatLon::new(0.0, 180.0)?];
            /// let sphere = Method::GreatCircle.on(Ellipsoid::sphere(1.0)?)?;
            /// assert!((sphere.visit(Length(&way)) - core::f64::consts::PI).abs() < 1e-15);
            /// # Ok::<(), Box<dyn std::error::Error>>(())
            /// ```
            #[inline(always)]
            pub fn visit<V: Visitor<T>>(self, visitor: V) -> V::Output {
                match self {
                    $(Self::$variant(method) => visitor.visit(method),)*
                }
            }
        }

        impl<T: Real> Geodesic<T> for AnyMethod<T> {
            #[inline(always)]
            fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
                match self {
                    $(Self::$variant(method) => method.inverse(from, to),)*
                }
            }

            #[inline(always)]
            fn distance(&self, from: LatLon<T>, to: LatLon<T>) -> Result<T, GeodesicError<T>> {
                match self {
                    $(Self::$variant(method) => method.distance(from, to),)*
                }
            }

            #[inline(always)]
            fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
                match self {
                    $(Self::$variant(method) => method.direct(from, azimuth, distance),)*
                }
            }

            #[inline(always)]
            fn with<W: GeodesicTask<T>>(&self, task: W) -> W::Output {
                match self {
                    $(Self::$variant(method) => task.run(method),)*
                }
            }
        }
    };
    (@place) => { false };
    (@place $place:ident) => { true };
}
pub(super) use methods;

impl Method {
    /// Creates the method on an ellipsoid. Methods of the sphere take its mean radius.
    ///
    /// # Errors
    /// [`InvalidMethod::Flattening`] if the method does not hold for this ellipsoid; the methods of the
    /// sphere always hold. [`InvalidMethod::PlaceNeeded`] for a method that holds about one place only:
    /// [`about`](Self::about) makes it.
    pub fn on<T: Real>(self, ellipsoid: Ellipsoid<T>) -> Result<AnyMethod<T>, InvalidMethod<T>> {
        if self.needs_place() {
            return Err(InvalidMethod::PlaceNeeded(self));
        }
        self.about(ellipsoid, LatLon::default())
            .map_err(InvalidMethod::Flattening)
    }
}

/// A computation for a method of any type: see [`AnyMethod::visit`].
pub trait Visitor<T: Real> {
    /// What is returned.
    type Output;

    /// Computes with a method.
    fn visit<M: Geodesic<T> + Copy + Send + Sync + 'static>(self, method: M) -> Self::Output;
}

/// Why [`Method::on`] refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidMethod<T> {
    /// The method does not hold for an ellipsoid of this flattening.
    Flattening(UnsupportedFlattening<T>),
    /// The method holds about one place only, and [`Method::about`] makes it.
    PlaceNeeded(Method),
}

impl<T: fmt::Debug> fmt::Display for InvalidMethod<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flattening(flattening) => fmt::Display::fmt(flattening, f),
            Self::PlaceNeeded(method) => write!(f, "the method {method} needs a place about which it holds"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidMethod<T> {}

by_name!(Method, UnknownMethod, "method");
