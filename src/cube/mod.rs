//! The cube: its [`Face`]s, points on them, and every projection of the sphere onto it.

mod face;
mod face_point;
mod map;
mod numbering;
mod projection;

pub use face::{Corner, Edge, Face, InvalidFace, Neighbour, UnknownFace};
pub use face_point::{FacePoint, InvalidFacePoint};
pub use map::CubeMap;
pub use numbering::{InvalidNumbered, Numbering};
pub use projection::*;
pub(crate) use projection::{Decay, on_face};
