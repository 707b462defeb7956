//! Earth axes, and the local frame about an origin.

use terrella::batch::ellipsoid::{InvalidGeodetic, to_ecef, to_geodetic};
use terrella::batch::frame as batch;
use terrella::frame::InvalidEnu;
use terrella::{Ellipsoid, Geodetic, InvalidEcef, InvalidHeight, LatLon, LocalFrame};

use crate::columns::through;
use crate::current::Current;
use crate::refusal::{Refusal, Value, or_words, refusals, refused};

static ELLIPSOID: Current<Ellipsoid> = Current::none();
static FRAME: Current<LocalFrame<f64>> = Current::none();

/// Calls are about this ellipsoid from now on, or words.
#[unsafe(no_mangle)]
extern "C" fn ellipsoid(a: f64, f: f64) -> bool {
    ELLIPSOID.put(or_words(Ellipsoid::new(a, f)))
}

/// Columns lat, lon, height → x, y, z.
#[unsafe(no_mangle)]
extern "C" fn ellipsoid_to_ecef(count: usize) -> usize {
    refused(through(count, |places, points| {
        to_ecef(*ELLIPSOID.get(), places, points)
    }))
}

/// Columns x, y, z → lat, lon, height.
#[unsafe(no_mangle)]
extern "C" fn ellipsoid_to_geodetic(count: usize) -> usize {
    refused(through(count, |points, places| {
        to_geodetic(*ELLIPSOID.get(), points, places)
    }))
}

/// Calls are about the frame at this origin on the ellipsoid from now on, or words.
#[unsafe(no_mangle)]
extern "C" fn frame(lat: f64, lon: f64, height: f64) -> bool {
    let frame = || {
        let origin = or_words(Geodetic::new(or_words(LatLon::new(lat, lon))?, height))?;
        Some(LocalFrame::new(*ELLIPSOID.get(), origin))
    };
    FRAME.put(frame())
}

/// Functions of three columns to three in the frame.
macro_rules! in_frame {
    ($($export:ident $batch:ident;)*) => {$(
        #[unsafe(no_mangle)]
        extern "C" fn $export(count: usize) -> usize {
            refused(through(count, |given, made| batch::$batch(FRAME.get(), given, made)))
        }
    )*};
}

in_frame! {
    frame_to_enu geodetic_to_enu;
    frame_to_ned geodetic_to_ned;
    frame_to_aer geodetic_to_aer;
    frame_from_enu enu_to_geodetic;
    frame_from_ned ned_to_geodetic;
    frame_from_aer aer_to_geodetic;
}

refusals! {
    InvalidGeodetic { LatLon(refusal) Height(refusal) }
}

impl Refusal for InvalidHeight<f64> {
    type Words = InvalidHeight<Value>;

    fn words(self) -> Self::Words {
        InvalidHeight {
            height: Value(self.height),
        }
    }
}

impl Refusal for InvalidEcef<f64> {
    type Words = InvalidEcef<Value>;

    fn words(self) -> Self::Words {
        let [x, y, z] = [self.x, self.y, self.z].map(Value);
        InvalidEcef { x, y, z }
    }
}

impl Refusal for InvalidEnu<f64> {
    type Words = InvalidEnu<Value>;

    fn words(self) -> Self::Words {
        let [east, north, up] = [self.east, self.north, self.up].map(Value);
        InvalidEnu { east, north, up }
    }
}
