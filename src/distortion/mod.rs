//! What a projection does to shapes and to texels, at a point and over whole faces.
//!
//! [`Ground`] is the planet under the faces of a [`CubeMap`](crate::cube::CubeMap); its [`Jacobian`] at a point is the derivative of the
//! very code that projects, run on [`Dual`](crate::Dual) numbers, for a projection that a user writes too. From it follow the measures of a
//! texel, [`Tissot`]'s indicatrix, and by a [`Survey`] what is worst on a face. [`texture`] has what a renderer asks of them.
//!
//! ```
//! use terrella::cube::{CubeMap, Face, FacePoint, Outerra};
//! use terrella::distortion::{Ground, Survey};
//! use terrella::{Ellipsoid, Shift};
//!
//! let ground = Ground::new(CubeMap::new(Ellipsoid::<f64>::wgs84(), Shift::Geocentric, Outerra)?);
//! let corner = ground.jacobian(FacePoint::new(Face::Front, 1.0, 1.0)?)?;
//! assert!((corner.aspect() - 1.0).abs() < 1e-2);
//!
//! let mut survey = Survey::new(ground.central_texel());
//! survey.face(&ground, Face::Front, 99);
//! assert!(survey.aspect().ratio() < 1.02);
//! assert!(survey.sides().ratio() > 3.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which projection for what
//!
//! | wanted | take | because |
//! |---|---|---|

mod ground;
mod jacobian;
mod statistic;
mod survey;
pub mod texture;
mod tissot;

pub use ground::{Ground, Singular};
pub use jacobian::Jacobian;
pub use statistic::Statistic;
pub use survey::Survey;
pub use tissot::Tissot;
