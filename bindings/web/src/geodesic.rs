//! Distances, azimuths and destinations by Karney's method.

use terrella::batch::geodesic::{InvalidProblem, along, direct, inverse};
use terrella::geodesic::{GeodesicError, Karney, Line};
use terrella::{Ellipsoid, LatLon};

use crate::columns::through;
use crate::current::Current;
use crate::refusal::{Refusal, Value, or_words, refusals, refused};

static KARNEY: Current<Karney<f64>> = Current::none();
static LINE: Current<Line<f64>> = Current::none();

/// Calls are about this ellipsoid from now on, or words.
#[unsafe(no_mangle)]
extern "C" fn geodesic(a: f64, f: f64) -> bool {
    let karney = || or_words(Karney::new(or_words(Ellipsoid::new(a, f))?));
    KARNEY.put(karney())
}

/// Columns lat1, lon1, lat2, lon2 → distance, azimuth1, azimuth2.
#[unsafe(no_mangle)]
extern "C" fn geodesic_inverse(count: usize) -> usize {
    refused(through(count, |[lat1, lon1, lat2, lon2], lines| {
        inverse(KARNEY.get(), [lat1, lon1], [lat2, lon2], lines)
    }))
}

/// Columns lat1, lon1, azimuth1, distance → lat2, lon2, azimuth2.
#[unsafe(no_mangle)]
extern "C" fn geodesic_direct(count: usize) -> usize {
    refused(through(count, |[lat, lon, azimuth, distance], ends| {
        direct(KARNEY.get(), [lat, lon], azimuth, distance, ends)
    }))
}

/// Calls are about this line from now on, of the ellipsoid of [`geodesic`], or words.
#[unsafe(no_mangle)]
extern "C" fn line(lat: f64, lon: f64, azimuth: f64) -> bool {
    let line = || or_words(KARNEY.get().line(or_words(LatLon::new(lat, lon))?, azimuth));
    LINE.put(line())
}

/// Column distance → lat, lon, azimuth.
#[unsafe(no_mangle)]
extern "C" fn line_at(count: usize) -> usize {
    refused(through(count, |[distance], points| along(LINE.get(), distance, points)))
}

refusals! {
    InvalidProblem { LatLon(refusal) Geodesic(refusal) }
}

impl Refusal for GeodesicError<f64> {
    type Words = GeodesicError<Value>;

    fn words(self) -> Self::Words {
        match self {
            Self::Azimuth(azimuth) => GeodesicError::Azimuth(Value(azimuth)),
            Self::Distance(distance) => GeodesicError::Distance(Value(distance)),
            Self::Fraction(fraction) => GeodesicError::Fraction(Value(fraction)),
            Self::TooFar { distance, limit } => GeodesicError::TooFar {
                distance: Value(distance),
                limit: Value(limit),
            },
            // Karney's method always converges; the places are not kept.
            _ => GeodesicError::Distance(Value(f64::NAN)),
        }
    }
}
