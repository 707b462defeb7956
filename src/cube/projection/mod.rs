//! The projections, one file each. To add one, write its file and its line in the list below.

mod catalogue;
mod cube_projection;
mod decay;
mod edge_keeping;
mod faces;
mod odd;
mod profile;
mod quad_cube;
mod vector;

pub use catalogue::UnknownProjection;
use catalogue::projections;
pub use cube_projection::{CubeProjection, ProjectionTask};
pub(crate) use decay::Decay;
pub use faces::Faces;
pub use profile::{Evaluation, Formula, Kept, Profile};
pub use quad_cube::QuadCube;
pub(crate) use vector::on_face;
use vector::{at_edge, from_gnomonic, newton, normalise};

use super::Face;
use crate::{Direction, Real};

projections! {
    tangential::Tangential,
    adjusted::Adjusted,
    outerra::Outerra,
    cobe::Cobe,
    cobe_exact::CobeExact,
    quadrilateralized::Quadrilateralized,
    cartesian::Cartesian,
    healpix::Healpix,
    s2_quadratic::S2Quadratic,
    equi_edge::EquiEdge,
    algebraic::Algebraic,
    vertex::Vertex,
    conformal::Conformal,
    balanced::Balanced,
    square::Square,
    separable::Separable,
    everitt::Everitt,
    zucker_higashi::ZuckerHigashi,
    lambers::Lambers,
    #[cfg_attr(feature = "serde", serde(rename = "polynomial-5"))]
    polynomial_5::Polynomial5,
    tanh::Tanh,
    unicube::Unicube,
    continuous::Continuous,
    arvo::Arvo,
    hybrid_equi_angular::HybridEquiAngular,
    cobe_refit::CobeRefit,
    even::Even,
    creaseless::Creaseless,
    compact::Compact,
}
