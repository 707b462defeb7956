//! Where something is: [`LatLon`] in degrees, [`Direction`] as a unit vector, and the way between them.

mod direction;
mod lat_lon;

pub use direction::{Direction, InvalidDirection};
pub use lat_lon::{InvalidLatLon, LatLon};
