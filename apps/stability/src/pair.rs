//! Pairs of places, and the distance between them that everything is measured against.

use geographiclib_rs::{DirectGeodesic, Geodesic, InverseGeodesic};

/// What a method computes with.
#[derive(Clone, Copy, PartialEq)]
pub enum Scalar {
    F64,
    F32,
}

impl Scalar {
    pub const ALL: [Self; 2] = [Self::F64, Self::F32];

    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
        }
    }

    /// The nearest number of this precision.
    pub fn round(self, x: f64) -> f64 {
        match self {
            Self::F64 => x,
            Self::F32 => f64::from(x as f32),
        }
    }
}

/// A latitude and a longitude in degrees.
#[derive(Clone, Copy)]
pub struct Place {
    pub lat: f64,
    pub lon: f64,
}

impl Place {
    /// Anywhere on Earth, all areas alike.
    pub fn anywhere(rng: &mut fastrand::Rng) -> Self {
        Self {
            lat: (2.0 * rng.f64() - 1.0).asin().to_degrees(),
            lon: 360.0 * rng.f64() - 180.0,
        }
    }

    pub fn antipode(self) -> Self {
        Self {
            lat: -self.lat,
            lon: if self.lon > 0.0 {
                self.lon - 180.0
            } else {
                self.lon + 180.0
            },
        }
    }

    fn rounded(self, scalar: Scalar) -> Self {
        Self {
            lat: scalar.round(self.lat),
            lon: scalar.round(self.lon),
        }
    }
}

/// Two places.
#[derive(Clone, Copy)]
pub struct Pair {
    pub from: Place,
    pub to: Place,
}

impl Pair {
    /// The pair that a method of this precision is given.
    pub fn rounded(self, scalar: Scalar) -> Self {
        Self {
            from: self.from.rounded(scalar),
            to: self.to.rounded(scalar),
        }
    }
}

/// GeographicLib, on an ellipsoid or a sphere.
pub struct Truth(Geodesic);

impl Truth {
    pub fn earth() -> Self {
        Self(Geodesic::wgs84())
    }

    pub fn sphere(radius: f64) -> Self {
        Self(Geodesic::new(radius, 0.0))
    }

    /// In metres.
    pub fn distance(&self, pair: Pair) -> f64 {
        let Pair { from, to } = pair;
        self.0.inverse(from.lat, from.lon, to.lat, to.lon)
    }

    /// Where an azimuth in degrees and a distance in metres lead.
    pub fn destination(&self, from: Place, azimuth: f64, distance: f64) -> Place {
        let (lat, lon) = self.0.direct(from.lat, from.lon, azimuth, distance);
        Place { lat, lon }
    }
}
