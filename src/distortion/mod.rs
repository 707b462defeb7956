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
//! let ground = Ground::new(CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Geocentric, Outerra)?);
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
//! From surveys of the sphere; ε is the texture oversize, ω the largest angular deformation. Time is that of [`batch`](crate::batch), in `f64` with
//! AVX-512, in units of the tangential cube's, as measured for `docs/frontier`.
//!
//! | wanted | take | what it gives | and what it costs |
//! |---|---|---|---|
//! | the least texture memory for the worst texel | [`Balanced`](crate::cube::Balanced) | ε 1.405; the paper's best, [`Adjusted`](crate::cube::Adjusted), has 2.000 | to the cube by Newton's method, 5.1 times; back 1.1 times |
//! | equal areas | [`Vertex`](crate::cube::Vertex) | areas to rounding, ω 20.3°, creases of 5° | 3.5 and 3.1 times |
//! | equal areas, as others have them | [`Quadrilateralized`](crate::cube::Quadrilateralized), [`Healpix`](crate::cube::Healpix) | areas to rounding | ω 25.2° and 49.3°, creases on the diagonals; 1.6 to 2.4 and 1.9 to 4.2 times |
//! | nearly equal areas, cheaply | [`Algebraic`](crate::cube::Algebraic) | area ratio 1.268, closed form both ways | ε 2.71; 2.1 and 1.8 times |
//! | true angles | [`Conformal`](crate::cube::Conformal) | ω 0 | the scale vanishes at the corners; 10 and 5.8 times |
//! | small ω without that | [`Vertex`](crate::cube::Vertex) | 20.3°; no map that is smooth and symmetric about the diagonal can stay under 31.08°, since 90° become 120° at a corner | as above |
//! | square texels | [`Square`](crate::cube::Square) | aspect ratio 1.013, area ratio 2.23 (Outerra's: 3.57) | ω 33.5°; to the cube by Newton's method, 7 times; back 1.1 times |
//! | one function for each coordinate | [`Separable`](crate::cube::Separable) | ε 1.587, the least that such a map can have | atan and tan, 4.9 and 1.9 times |
//! | speed both ways | [`Tangential`](crate::cube::Tangential), then [`S2Quadratic`](crate::cube::S2Quadratic) | 1 and 1.4 to 2.3 times | ε 4.50 and 2.10 |
//! | a shader that goes from the map to the ground | [`Balanced`](crate::cube::Balanced), [`Square`](crate::cube::Square), [`Outerra`](crate::cube::Outerra) | `+ − × ÷`, one root, no transcendental function | forward, on the host, is the dear direction |
//! | a shader that goes both ways | [`S2Quadratic`](crate::cube::S2Quadratic), [`Algebraic`](crate::cube::Algebraic), [`Cartesian`](crate::cube::Cartesian) | `÷` and `√` only, no iteration | ε 2.10, 2.71, 3.00 |

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
