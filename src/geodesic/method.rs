use core::fmt;
use core::str::FromStr;

use super::{
    Direct, Geodesic, GeodesicError, Inverse, andoyer, andoyer_second, bowring, flat, great_circle, haversine, karney,
    vincenty,
};
use crate::latitude::UnsupportedFlattening;
use crate::name::unknown;
use crate::{Ellipsoid, LatLon, Real};

macro_rules! methods {
    ($($module:ident::$variant:ident $name:literal |$ellipsoid:ident| $make:expr,)*) => {
        /// The methods of this crate, to pick one at run time.
        ///
        /// Code that knows its method names the type instead, and links nothing of the others.
        ///
        /// ```
        /// use terrella::geodesic::{Geodesic, Method};
        /// use terrella::{Ellipsoid, LatLon};
        /// let method: Method = "vincenty".parse().unwrap();
        /// let earth = method.on(Ellipsoid::WGS84).unwrap();
        /// let (pole, equator) = (LatLon::new(90.0, 0.0).unwrap(), LatLon::new(0.0, 0.0).unwrap());
        /// let quarter = earth.inverse(pole, equator).unwrap().distance;
        /// assert!((quarter - 10_001_965.729_3_f64).abs() < 1e-4);
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[non_exhaustive]
        pub enum Method {
            $(
                #[doc = concat!("[`", stringify!($variant), "`](super::", stringify!($variant), "), \"", $name, "\".")]
                $variant,
            )*
        }

        impl Method {
            /// All of them, roughly from the simplest to the most exact.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The name, in lower case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }

            /// The method on an ellipsoid; those of the sphere take the one of mean radius.
            ///
            /// # Errors
            /// [`UnsupportedFlattening`] if the method does not hold for this ellipsoid; never for those of
            /// the sphere.
            pub fn on<T: Real>(self, ellipsoid: Ellipsoid<T>) -> Result<AnyMethod<T>, UnsupportedFlattening<T>> {
                match self {
                    $(
                        Self::$variant => {
                            let $ellipsoid = ellipsoid;
                            $make.map(AnyMethod::$variant)
                        }
                    )*
                }
            }
        }

        /// A method that was picked at run time, by [`Method::on`].
        #[derive(Clone, Copy, Debug, PartialEq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[allow(clippy::large_enum_variant)] // nothing here allocates
        pub enum AnyMethod<T> {
            $(
                #[doc = concat!("\"", $name, "\".")]
                $variant($module::$variant<T>),
            )*
        }

        impl<T: Real> Geodesic<T> for AnyMethod<T> {
            fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
                match self {
                    $(Self::$variant(method) => method.inverse(from, to),)*
                }
            }

            fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
                match self {
                    $(Self::$variant(method) => method.direct(from, azimuth, distance),)*
                }
            }
        }
    };
}

methods! {
    haversine::Haversine "haversine" |e| Ok(haversine::Haversine::mean(e)),
    great_circle::GreatCircle "great-circle" |e| Ok(great_circle::GreatCircle::mean(e)),
    flat::Flat "flat" |e| flat::Flat::new(e),
    bowring::Bowring "bowring" |e| bowring::Bowring::new(e),
    andoyer::Andoyer "andoyer" |e| andoyer::Andoyer::new(e),
    andoyer_second::AndoyerSecond "andoyer-second" |e| andoyer_second::AndoyerSecond::new(e),
    vincenty::Vincenty "vincenty" |e| vincenty::Vincenty::new(e),
    karney::Karney "karney" |e| karney::Karney::new(e),
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

unknown!(UnknownMethod, "method", Method::ALL.iter());

impl FromStr for Method {
    type Err = UnknownMethod;

    fn from_str(name: &str) -> Result<Self, UnknownMethod> {
        Self::ALL
            .iter()
            .copied()
            .find(|m| m.name() == name)
            .ok_or_else(|| UnknownMethod::new(name))
    }
}
