//! Distortion of shapes and of texels by a projection, at a point and over whole faces.
//!
//! [`Ground`] maps the faces of a [`CubeMap`](crate::cube::CubeMap) to the planet. Its [`Jacobian`] at a
//! point is the derivative of the projection's own code, run on [`Dual`](crate::Dual) numbers; this works for
//! a projection that you write, too. The measures of a texel and [`Tissot`]'s indicatrix follow from it, and
//! a [`Survey`] finds the worst values on a face. [`Cells`] measures whole cells, and [`Kinks`] the turns of
//! lines at creases. [`texture`] computes the mipmap levels that a renderer
//! needs.
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
//! # Criteria
//!
//! | criterion | function |
//! |---|---|
//! | texture oversize ε, aspect, Λx·Λy: Dimitrijević, Lambers & Rančić (2016) | [`Survey::oversize`], [`Survey::aspect`], [`Survey::sides`] |
//! | D_A, areal scale, and D_I, isotropy: Lambers (2019) | [`Survey::scale`], [`Survey::isotropy`] |
//! | evenness of areas: Zucker & Higashi (2018) | [`Statistic::rmsd`] of [`Survey::area`] |
//! | Tissot's ω | [`Survey::deformation`] |
//! | any of these on land only | [`Survey::face_where`] |
//! | area, edge, diagonal, angle span: S2's cell metrics | [`Cells`] |
//! | compactness, spacing of neighbours | [`Cells::compactness`], [`Cells::spacing`] |
//! | kinks at edges, diagonals and midlines | [`Kinks`] |
//!
//! # Which projection for what
//!
//! The figures come from surveys of the sphere. ε is the texture oversize, ω the maximum angular deformation.
//! Times are those of [`batch`](crate::batch) in `f64` with AVX-512, relative to the tangential cube, as
//! measured for `docs/frontier`: first from the planet to the cube, then back.
//!
//! * **The least texture memory for the worst texel:** [`Compact`] has ε 1.355, [`Balanced`] 1.405; the
//!   paper's best, [`Adjusted`], has 2.000. Balanced goes to the cube by Newton's method, at 5.1 times the
//!   cost, and back at 1.1 times.
//! * **Equal areas:** [`Vertex`] keeps areas to rounding, with ω 20.3° and creases of 5°, at 3.5 and 3.1
//!   times the cost.
//! * **Equal areas, as others define them:** [`Quadrilateralized`] has ω 25.2°, at 2.4 and 1.6 times the
//!   cost; [`Healpix`] has ω 49.3°, at 4.2 and 1.9 times. Both keep areas to rounding and have creases on the
//!   diagonals.
//! * **Nearly equal areas, cheaply:** [`Algebraic`] has an area ratio of 1.268 and closed forms both ways; ε
//!   is 2.71, at 2.1 and 1.8 times the cost.
//! * **True angles:** [`Conformal`] has ω 0. Its scale vanishes at the corners; the cost is 10 and 5.8 times.
//! * **Small ω without a vanishing scale:** [`Vertex`], with 20.3°. A map that is smooth and symmetric about
//!   the diagonal cannot stay under 31.08°, since angles of 90° become 120° at a corner.
//! * **Square texels:** [`Square`] has an aspect ratio of 1.013 and an area ratio of 2.23 (Outerra's: 3.57);
//!   ω is 33.5°. It goes to the cube by Newton's method, at 7 times the cost, and back at 1.1 times.
//! * **One function for each coordinate:** [`Separable`] has ε 1.587, the least that such a map can have. It
//!   uses atan and tan, at 4.9 and 1.9 times the cost.
//! * **Speed both ways:** [`Tangential`], at 1 times the cost and ε 4.50; then [`S2Quadratic`], at 2.3 and
//!   1.4 times the cost and ε 2.10.
//! * **A shader that goes from the map to the ground:** [`Balanced`], [`Square`] and [`Outerra`] need only `+
//!   − × ÷` and one square root in this direction, no transcendental function. Their expensive direction,
//!   from the planet to the cube, runs on the host.
//! * **A shader that goes both ways:** [`S2Quadratic`], [`Algebraic`] and [`Cartesian`] use only `÷` and `√`,
//!   without iteration; ε is 2.10, 2.71 and 3.00.
//!
//! [`Balanced`]: crate::cube::Balanced
//! [`Compact`]: crate::cube::Compact
//! [`Adjusted`]: crate::cube::Adjusted
//! [`Vertex`]: crate::cube::Vertex
//! [`Quadrilateralized`]: crate::cube::Quadrilateralized
//! [`Healpix`]: crate::cube::Healpix
//! [`Algebraic`]: crate::cube::Algebraic
//! [`Conformal`]: crate::cube::Conformal
//! [`Square`]: crate::cube::Square
//! [`Separable`]: crate::cube::Separable
//! [`Tangential`]: crate::cube::Tangential
//! [`S2Quadratic`]: crate::cube::S2Quadratic
//! [`Outerra`]: crate::cube::Outerra
//! [`Cartesian`]: crate::cube::Cartesian

mod cell;
mod cells;
mod ground;
mod jacobian;
mod kinks;
mod statistic;
mod strips;
mod survey;
pub mod texture;
mod tissot;
mod unfolded;

pub use cells::Cells;
pub use ground::{Ground, Singular};
pub use jacobian::Jacobian;
pub use kinks::Kinks;
pub use statistic::Statistic;
pub use survey::Survey;
pub use tissot::Tissot;
