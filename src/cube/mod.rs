//! The cube around the sphere: its [`Face`]s, points on them, and the projections of the sphere onto them.
//!
//! * [`CubeMap`] converts geodetic latitude and longitude on an ellipsoid to a [`FacePoint`], and back.
//! * Each projection is a type that implements [`CubeProjection`]; its page says when to take it.
//!   [`Projection`] is the list of them, to choose one at run time, and [`Profile`] holds their figures.
//! * [`Turned`] and [`Stretched`] are cubes that face other places, and that are finer around one of them.
//! * [`Cell`] is a cell of a face that is divided into n × n, for any n.
//! * [`Numbering`] converts to the faces and axes of S2, OpenGL and FITS.
//!
//! If you have no reason for another, take [`Compact`] for the least texture memory, [`Vertex`] for equal
//! areas, [`S2Quadratic`] or [`Algebraic`] for speed.

mod cell;
mod face;
mod face_point;
mod map;
mod numbering;
mod orientation;
mod projection;

pub(crate) use cell::beyond;
pub use cell::{Cell, InvalidCell};
pub use face::{Corner, Edge, Face, InvalidFace, Neighbour, UnknownFace};
pub use face_point::{FacePoint, InvalidFacePoint};
pub use map::CubeMap;
pub use numbering::{InvalidNumbered, Numbering};
pub use orientation::{InvalidRotation, InvalidStretch, Rotation, Stretched, Turned};
pub use projection::*;
pub(crate) use projection::{Decay, on_face};
