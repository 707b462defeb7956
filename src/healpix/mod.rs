//! Standard HEALPix (Górski et al., ApJ 622, 2005) on the sphere: its pixels, and its plane.
//!
//! Twelve curved diamonds of equal area, four about each pole and four on the equator, each of 4^depth
//! [`Pixel`]s of equal area: what catalogues and maps of the sky (FITS, MOC) and healpy, astropy-healpix,
//! cdshealpix and the C and C++ libraries call by these numbers.
//!
//! The latitude is that of a sphere: in astronomy a declination, on an ellipsoid the authalic latitude
//! ([`Shifted`](crate::Shifted)), for areas to stay equal. A longitude is a right ascension or any other in
//! degrees; one in [0, 360] goes through [`LatLon::new`](crate::LatLon::new).
//!
//! [`cube::Healpix`](crate::cube::Healpix) is another thing, a cube made of the same projection: its squares
//! are cut parallel to the equator, as rHEALPix's are, and turned by 45° of longitude; its
//! [`Tile`](crate::terrain::Tile)s are not these pixels.

mod nested;
mod plane;

pub use nested::{InvalidPixel, InvalidPixelPlace, Pixel};
pub use plane::{OutsidePlane, from_plane, to_plane};
