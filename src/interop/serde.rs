//! Deserialisation through the constructors: what `new` refuses is refused here, with the same message.

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, Visitor};
use serde::ser::{Serialize, Serializer};

use crate::cube::{Face, FacePoint};
use crate::healpix::Pixel;
use crate::terrain::{Curve, Heights, Key, Tile};
use crate::{Direction, Ecef, Ellipsoid, Geodetic, LatLon, Real};

macro_rules! checked {
    ($name:ident { $($field:ident: $kind:ty),* }) => {
        impl<'de, T: Real + Deserialize<'de>> Deserialize<'de> for $name<T> {
            fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                #[derive(serde::Deserialize)]
                #[serde(bound(deserialize = "T: Real + serde::Deserialize<'de>"))]
                struct $name<T> {
                    $($field: $kind),*
                }
                let $name { $($field),* } = $name::deserialize(deserializer)?;
                Self::new($($field),*).map_err(D::Error::custom)
            }
        }
    };
}

checked!(LatLon { lat: T, lon: T });
checked!(Direction { x: T, y: T, z: T });
checked!(Geodetic { lat_lon: LatLon<T>, height: T });
checked!(Ecef { x: T, y: T, z: T });
checked!(Ellipsoid { a: T, f: T });
checked!(FacePoint { face: Face, x: T, y: T });
checked!(Heights { low: T, high: T });

impl<'de> Deserialize<'de> for Pixel {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        struct Pixel {
            depth: u8,
            number: u64,
        }
        let Pixel { depth, number } = Pixel::deserialize(deserializer)?;
        Self::new(depth, number).map_err(D::Error::custom)
    }
}

impl<C: Curve> Serialize for Key<C> {
    /// The token in formats that people read, the number in others.
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        if serializer.is_human_readable() {
            serializer.collect_str(self)
        } else {
            serializer.serialize_u64(self.bits())
        }
    }
}

impl<'de, C: Curve> Deserialize<'de> for Key<C> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Token<C>(PhantomData<C>);

        impl<C: Curve> Visitor<'_> for Token<C> {
            type Value = Key<C>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("the token of a tile")
            }

            fn visit_str<E: Error>(self, token: &str) -> Result<Key<C>, E> {
                token.parse().map_err(E::custom)
            }
        }

        if deserializer.is_human_readable() {
            deserializer.deserialize_str(Token(PhantomData))
        } else {
            Self::new(u64::deserialize(deserializer)?).map_err(D::Error::custom)
        }
    }
}

impl<'de> Deserialize<'de> for Tile {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(serde::Deserialize)]
        struct Tile {
            face: Face,
            level: u8,
            i: u32,
            j: u32,
        }
        let Tile { face, level, i, j } = Tile::deserialize(deserializer)?;
        Self::new(face, level, i, j).map_err(D::Error::custom)
    }
}
