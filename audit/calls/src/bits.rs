use terrella::cube::{Corner, Edge, Face, FacePoint, InvalidFace, InvalidFacePoint, InvalidNumbered, Neighbour};
use terrella::distortion::texture::Anisotropic;
use terrella::distortion::{Cells, Jacobian, Kinks, Singular, Statistic, Survey, Tissot};
use terrella::frame::{GeodeticOffset, InvalidEnu};
use terrella::geodesic::{Direct, GeodesicError, Inverse, LinePoint, Solution};
use terrella::latitude::{InvalidLatitude, UnsupportedFlattening};
use terrella::{
    Aer, Direction, Dual, Ecef, Ellipsoid, Enu, Geodetic, InvalidDirection, InvalidEcef, InvalidEllipsoid,
    InvalidHeight, InvalidLatLon, LatLon, Ned,
};

use crate::Scalar;

/// FNV-1a over bits.
pub struct Hash(u64);

impl Default for Hash {
    fn default() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }
}

impl Hash {
    /// Takes a word.
    pub fn add(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }

    /// The hash of what was taken.
    #[must_use]
    pub fn value(&self) -> u64 {
        self.0
    }
}

/// What has bits to be hashed. Every NaN counts as the same: which one an operation gives is the machine's choice.
pub trait Bits {
    /// Gives the bits to a hash.
    fn add_to(&self, hash: &mut Hash);
}

macro_rules! words {
    ($($integer:ty)*) => {$(
        impl Bits for $integer {
            fn add_to(&self, hash: &mut Hash) {
                hash.add(*self as u64);
            }
        }
    )*};
}

words! { bool u8 u32 u64 usize Face Edge Corner }

macro_rules! floats {
    ($($float:ident)*) => {$(
        impl Bits for $float {
            fn add_to(&self, hash: &mut Hash) {
                let number = if self.is_nan() { $float::NAN } else { *self };
                hash.add(number.to_bits().into());
            }
        }
    )*};
}

floats! { f32 f64 }

impl Bits for str {
    fn add_to(&self, hash: &mut Hash) {
        self.bytes().for_each(|byte| byte.add_to(hash));
    }
}

impl<B: Bits + ?Sized> Bits for &B {
    fn add_to(&self, hash: &mut Hash) {
        (**self).add_to(hash);
    }
}

impl<B: Bits, const N: usize> Bits for [B; N] {
    fn add_to(&self, hash: &mut Hash) {
        self.iter().for_each(|part| part.add_to(hash));
    }
}

impl Bits for () {
    fn add_to(&self, _: &mut Hash) {}
}

macro_rules! tuples {
    ($(($($name:ident)*))*) => {$(
        impl<$($name: Bits),*> Bits for ($($name,)*) {
            #[allow(non_snake_case)] // the types' names serve for the parts
            fn add_to(&self, hash: &mut Hash) {
                let ($($name,)*) = self;
                $($name.add_to(hash);)*
            }
        }
    )*};
}

tuples! { (A) (A B) (A B C) (A B C D) (A B C D E) }

impl<B: Bits> Bits for Option<B> {
    fn add_to(&self, hash: &mut Hash) {
        self.is_some().add_to(hash);
        if let Some(part) = self {
            part.add_to(hash);
        }
    }
}

impl<B: Bits, E: Bits> Bits for Result<B, E> {
    fn add_to(&self, hash: &mut Hash) {
        self.is_ok().add_to(hash);
        match self {
            Ok(part) => part.add_to(hash),
            Err(why) => why.add_to(hash),
        }
    }
}

/// A type by the parts that its own functions or fields give.
macro_rules! parts {
    ($($type:ident |$value:ident| $parts:expr;)*) => {$(
        impl<T: Scalar> Bits for $type<T> {
            fn add_to(&self, hash: &mut Hash) {
                let $value = self;
                $parts.add_to(hash);
            }
        }
    )*};
}
pub(crate) use parts;

parts! {
    LatLon |p| (LatLon::lat(*p), LatLon::lon(*p));
    Direction |d| (Direction::to_array(*d), Direction::x(*d), Direction::y(*d), Direction::z(*d));
    Geodetic |p| (Geodetic::lat_lon(*p), Geodetic::lat(*p), Geodetic::lon(*p), Geodetic::height(*p));
    Ecef |p| (Ecef::to_array(*p), Ecef::x(*p), Ecef::y(*p), Ecef::z(*p));
    Ellipsoid |e| (Ellipsoid::a(*e), Ellipsoid::f(*e));
    Enu |p| [p.east, p.north, p.up];
    Ned |p| [p.north, p.east, p.down];
    GeodeticOffset |p| [p.lat, p.lon, p.height];
    InvalidEnu |why| [why.east, why.north, why.up];
    Aer |p| [p.azimuth, p.elevation, p.range];
    FacePoint |p| (FacePoint::face(*p), FacePoint::x(*p), FacePoint::y(*p));
    Inverse |line| [line.distance, line.azimuth1, line.azimuth2];
    Direct |end| (end.position, end.azimuth);
    Solution |s| (s.inverse, [s.arc, s.reduced_length, s.scale12, s.scale21], s.evaluations);
    LinePoint |p| (p.position, [p.azimuth, p.arc, p.reduced_length, p.scale12, p.scale21]);
    Jacobian |j| (j.by_x, j.by_y);
    Anisotropic |a| [a.samples, a.level];
    Singular |why| why.0;
    InvalidDirection |why| [why.x, why.y, why.z];
    InvalidEcef |why| [why.x, why.y, why.z];
    InvalidHeight |why| why.height;
    InvalidFacePoint |why| [why.x, why.y];
    InvalidLatitude |why| why.0;
    UnsupportedFlattening |why| why.0;
    Tissot |t| (
        [t.meridian, t.parallel, t.graticule_angle],
        [t.major, t.minor, t.azimuth, t.areal, t.deformation],
    );
    Statistic |s| (
        [Statistic::min(s), Statistic::max(s), Statistic::ratio(s), Statistic::mean(s), Statistic::rmsd(s)],
        Statistic::min_at(s),
        Statistic::max_at(s),
        Statistic::count(s),
    );
    Survey |s| (
        [Survey::aspect(s), Survey::sides(s), Survey::area(s), Survey::deformation(s)],
        Survey::oversize(s),
        Survey::skipped(s),
    );
    Cells |c| (
        [Cells::area(c), Cells::edge(c), Cells::diagonal(c), Cells::span(c)],
        [Cells::edge_aspect(c), Cells::diagonal_aspect(c), Cells::compactness(c), Cells::spacing(c)],
    );
    Kinks |k| (
        [Kinks::edges(k), Kinks::diagonals(k), Kinks::midlines(k)],
        Kinks::skipped(k),
    );
    InvalidLatLon |why| match why {
        InvalidLatLon::Latitude(lat) => (false, *lat),
        InvalidLatLon::Longitude(lon) => (true, *lon),
    };
    InvalidEllipsoid |why| match why {
        InvalidEllipsoid::SemiMajorAxis(a) => (false, *a),
        InvalidEllipsoid::Flattening(f) => (true, *f),
    };
    InvalidNumbered |why| match why {
        InvalidNumbered::Face(face) => (Some(*face), None),
        InvalidNumbered::Point(point) => (None, Some(*point)),
    };
    GeodesicError |why| match why {
        GeodesicError::Azimuth(azimuth) => (Some((false, *azimuth)), None, None),
        GeodesicError::Distance(distance) => (Some((true, *distance)), None, None),
        GeodesicError::NotConverged(from, to) => (None, Some((*from, *to)), None),
        GeodesicError::TooFar { distance, limit } => (None, None, Some([*distance, *limit])),
        GeodesicError::Fraction(fraction) => (None, None, Some([*fraction; 2])),
        _ => (None, None, None),
    };
}

impl Bits for InvalidFace {
    fn add_to(&self, hash: &mut Hash) {
        self.0.add_to(hash);
    }
}

impl Bits for Neighbour {
    fn add_to(&self, hash: &mut Hash) {
        (self.face, self.edge, self.turns).add_to(hash);
    }
}

impl<T: Scalar, const N: usize> Bits for Dual<T, N> {
    fn add_to(&self, hash: &mut Hash) {
        (Dual::value(*self), Dual::slopes(*self)).add_to(hash);
    }
}
