//! Cubes that are turned and stretched: any projection behind a map of the sphere onto itself.

mod rotation;
mod stretched;
mod turned;

pub use rotation::{InvalidRotation, Rotation};
pub use stretched::{InvalidStretch, Stretched};
pub use turned::Turned;
