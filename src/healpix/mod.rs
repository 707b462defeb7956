//! Standard HEALPix (Górski et al., ApJ 622, 2005): its pixels, numbered in the nested and in the ring scheme,
//! and its plane.
//!
//! HEALPix divides the sphere into twelve curved diamonds of equal area: four about each pole and four on the
//! equator. Each has 4^depth [`Pixel`]s of equal area. Their numbers are those of sky catalogues and maps
//! (FITS, MOC), and of healpy, astropy-healpix, cdshealpix and the C and C++ libraries.
//!
//! The latitude is that of a sphere, a declination in astronomy. [`OnEllipsoid`] takes the geodetic latitude
//! and keeps the areas equal. The longitude is a right ascension or any other longitude, in degrees; convert
//! one in [0, 360] with [`LatLon::new`](crate::LatLon::new).
//!
//! [`cube::Healpix`](crate::cube::Healpix) is something else: a cube made of the same projection. Its squares
//! are cut parallel to the equator, as rHEALPix's are, and turned by 45° of longitude; its
//! [`Tile`](crate::terrain::Tile)s are not these pixels.

mod neighbour;
mod nested;
mod on_ellipsoid;
mod plane;
mod ring;

pub use neighbour::{Corner, Side};
pub use nested::{InvalidPixel, InvalidPixelPlace, Pixel};
pub use on_ellipsoid::OnEllipsoid;
pub(crate) use plane::Facet;
pub use plane::{OutsidePlane, from_plane, to_plane};
