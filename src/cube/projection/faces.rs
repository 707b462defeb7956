//! How the six faces of a projection relate to each other.

use crate::cube::{Edge, Face};

/// The symmetries of the faces, and whether they agree along the edges of the cube.
///
/// Every face is symmetric about its midlines: −x is the mirror image of x, and −y of y.
///
/// ```
/// use terrella::cube::{CubeProjection, Edge, Face, Faces, Projection};
/// assert_eq!(Projection::Healpix.faces(), Faces::SideAndPolar);
/// let agree = |p: &&Projection| p.faces().agree(Face::Right, Edge::Up);
/// assert!(Projection::ALL.iter().filter(|p| !agree(p)).eq(&[Projection::Arvo]));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Faces {
    /// All faces are alike, and x and y are alike on each: a face has the eight symmetries of the square.
    Alike,
    /// The four side faces are alike, and so are the two polar ones. x and y are alike on a polar face, and
    /// differ on a side face.
    SideAndPolar,
    /// All faces are alike, but x and y differ.
    Oblong,
    /// All faces are alike, but x and y differ, and faces disagree along four of the twelve edges: those of
    /// the top and of the bottom face with the left and the right one. A place on such an edge has another
    /// coordinate along the edge on one face than on the other.
    Apart,
}

impl Faces {
    /// Returns whether x and y are alike on a face: swapping right and up swaps x and y.
    #[must_use]
    pub const fn are_square(self, face: Face) -> bool {
        match self {
            Self::Alike => true,
            Self::SideAndPolar => face.is_polar(),
            Self::Oblong | Self::Apart => false,
        }
    }

    /// Returns whether a face and its neighbour beyond an edge agree there: a place on the edge has the same
    /// coordinate along the edge on both.
    #[must_use]
    pub const fn agree(self, face: Face, edge: Edge) -> bool {
        let beside = matches!(edge, Edge::Right | Edge::Left);
        match face {
            _ if !matches!(self, Self::Apart) => true,
            Face::Front | Face::Back => true,
            Face::Right | Face::Left => beside,
            Face::Top | Face::Bottom => !beside,
        }
    }
}
