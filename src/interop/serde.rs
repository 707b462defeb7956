//! Deserialisation through the same doors as `new`: what a constructor refuses is refused here.

use serde::de::{Deserialize, Deserializer, Error};

use crate::cube::{Face, FacePoint};
use crate::terrain::Tile;
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
