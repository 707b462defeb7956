use core::ffi::c_char;

use terrella::batch::ellipsoid::InvalidGeodetic;
use terrella::batch::geodesic::InvalidProblem;
use terrella::cube::{InvalidFace, InvalidFacePoint};
use terrella::frame::InvalidEnu;
use terrella::geodesic::GeodesicError;
use terrella::latitude::UnsupportedFlattening;
use terrella::terrain::{InvalidKey, InvalidTile};
use terrella::{InvalidDirection, InvalidEcef, InvalidEllipsoid, InvalidHeight, InvalidLatLon};

macro_rules! statuses {
    ($($name:ident = $number:literal $text:literal;)*) => {
        /// What a function returns: 0 if all is well, or one number for each refusal. Nothing is written then. Numbers are
        /// never used again for something else.
        #[repr(i32)]
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum terrella_status {
            $(
                #[doc = concat!(" Status: ", $text, ".")]
                $name = $number,
            )*
        }

        /// Returns what a status means, in English, for whatever number it is.
        #[unsafe(no_mangle)]
        pub extern "C" fn terrella_status_text(status: i32) -> *const c_char {
            let text = match status {
                $($number => concat!($text, "\0"),)*
                _ => "no status of this library\0",
            };
            text.as_ptr().cast()
        }
    };
}

statuses! {
    TERRELLA_OK = 0 "all is well";
    TERRELLA_LATITUDE = 1 "a latitude is not in [-90, 90] degrees";
    TERRELLA_LONGITUDE = 2 "a longitude is not finite";
    TERRELLA_HEIGHT = 3 "a height is not finite";
    TERRELLA_POINT = 4 "a point is not finite";
    TERRELLA_DIRECTION = 5 "a vector has no direction";
    TERRELLA_SEMI_MAJOR_AXIS = 6 "a semi-major axis is not in [1e-15, 1e15] metres";
    TERRELLA_FLATTENING = 7 "a flattening is not in [-1000, 1)";
    TERRELLA_UNSUPPORTED_FLATTENING = 8 "the flattening is outside the range in which this formula is accurate";
    TERRELLA_AZIMUTH = 9 "an azimuth is not finite";
    TERRELLA_DISTANCE = 10 "a distance is not finite";
    TERRELLA_TOO_FAR = 11 "a distance is longer than this method allows";
    TERRELLA_NOT_CONVERGED = 12 "the method does not converge between these places";
    TERRELLA_FRACTION = 13 "a fraction makes no finite distance";
    TERRELLA_FACE = 14 "a face is not in 0 to 5";
    TERRELLA_FACE_POINT = 15 "a point of a face is not in [-1, 1]";
    TERRELLA_LEVEL = 16 "a level is not in 0 to 30";
    TERRELLA_COLUMN_OR_ROW = 17 "a column or row is not in 0 to 2^level - 1";
    TERRELLA_KEY = 18 "a number is not the key of a tile";
    TERRELLA_UNKNOWN = 19 "there is no such projection, shift or ellipsoid";
    TERRELLA_NULL = 20 "a pointer is NULL that may not be";
    TERRELLA_ELEMENTS = 21 "elements of the arrays were refused: their results are NaN, and all others are written";
    TERRELLA_NOT_MADE = 22 "a handle was not made, or its init was refused";
    TERRELLA_OVERLAP = 23 "an array for results overlaps another in part; it may be one that is given, or apart from all";
}

use terrella_status::*;

macro_rules! by_number {
    ($($error:ty: $why:pat => $status:expr;)*) => {$(
        impl From<$error> for terrella_status {
            fn from($why: $error) -> Self {
                $status
            }
        }
    )*};
}

by_number! {
    InvalidFace: _ => TERRELLA_FACE;
    InvalidKey: _ => TERRELLA_KEY;
    InvalidTile: why => match why {
        InvalidTile::Level(_) => TERRELLA_LEVEL,
        _ => TERRELLA_COLUMN_OR_ROW,
    };
}

macro_rules! by_scalar {
    ($($error:ident: $why:pat => $status:expr;)*) => {$(
        impl<T> From<$error<T>> for terrella_status {
            fn from($why: $error<T>) -> Self {
                $status
            }
        }
    )*};
}

by_scalar! {
    InvalidDirection: _ => TERRELLA_DIRECTION;
    InvalidEcef: _ => TERRELLA_POINT;
    InvalidEnu: _ => TERRELLA_POINT;
    InvalidFacePoint: _ => TERRELLA_FACE_POINT;
    InvalidHeight: _ => TERRELLA_HEIGHT;
    UnsupportedFlattening: _ => TERRELLA_UNSUPPORTED_FLATTENING;
    InvalidEllipsoid: why => match why {
        InvalidEllipsoid::SemiMajorAxis(_) => TERRELLA_SEMI_MAJOR_AXIS,
        InvalidEllipsoid::Flattening(_) => TERRELLA_FLATTENING,
    };
    InvalidLatLon: why => match why {
        InvalidLatLon::Latitude(_) => TERRELLA_LATITUDE,
        InvalidLatLon::Longitude(_) => TERRELLA_LONGITUDE,
    };
    InvalidGeodetic: why => match why {
        InvalidGeodetic::LatLon(why) => why.into(),
        InvalidGeodetic::Height(why) => why.into(),
    };
    InvalidProblem: why => match why {
        InvalidProblem::LatLon(why) => why.into(),
        InvalidProblem::Geodesic(why) => why.into(),
    };
    GeodesicError: why => match why {
        GeodesicError::Azimuth(_) => TERRELLA_AZIMUTH,
        GeodesicError::Distance(_) => TERRELLA_DISTANCE,
        GeodesicError::TooFar { .. } => TERRELLA_TOO_FAR,
        GeodesicError::Fraction(_) => TERRELLA_FRACTION,
        _ => TERRELLA_NOT_CONVERGED,
    };
}

/// The status of what a function does.
pub fn status(body: impl FnOnce() -> Result<(), terrella_status>) -> terrella_status {
    match body() {
        Ok(()) => TERRELLA_OK,
        Err(why) => why,
    }
}
