use crate::Real;

/// A surface with straight edges, on which a [`Fence`](super::Fence) can stand:
/// [`Karney`](crate::geodesic::Karney)'s ellipsoid, the sphere of
/// [`GreatCircle`](crate::geodesic::GreatCircle), or [`Planar`](super::Planar).
///
/// From each place a ray goes north: along the meridian to the north pole, in the plane without an end.
pub trait EdgeCrossing<T: Real> {
    /// A place on the surface.
    type Place: Copy;

    /// How far north a place is: its latitude in degrees, in the plane metres.
    fn northing(&self, place: Self::Place) -> T;

    /// The northings between which an edge runs, with room for its tolerance. They may be farther apart than
    /// need be.
    fn northings(&self, from: Self::Place, to: Self::Place) -> [T; 2];

    /// What an edge is to a place and its ray. Where the ray runs along an edge, or meets a corner, it counts
    /// as one that is a little farther east.
    fn crossing(&self, place: Self::Place, from: Self::Place, to: Self::Place) -> Crossing;

    /// Whether the northern and the southern ends of all meridians are inside a ring of edges: on its smaller
    /// side, or with `left` to the left of the edges.
    fn ends(&self, edges: impl Iterator<Item = [Self::Place; 2]>, left: bool) -> [bool; 2];
}

/// A [`EdgeCrossing`] that measures how far a place is from an edge.
pub trait EdgeDistance<T: Real>: EdgeCrossing<T> {
    /// The distance in metres of a place from the edge between two corners.
    fn edge_distance(&self, place: Self::Place, from: Self::Place, to: Self::Place) -> T;

    /// A distance in metres that [`edge_distance`](Self::edge_distance) is not below. It is cheap: edges that are
    /// farther than another are skipped by it. By default 0.
    fn edge_at_least(&self, _place: Self::Place, _from: Self::Place, _to: Self::Place) -> T {
        T::ZERO
    }
}

/// What an edge is to a place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Crossing {
    /// The edge does not meet the place's ray.
    Apart,
    /// The edge crosses the place's ray.
    Across,
    /// The place is on the edge, within its tolerance.
    Touching,
}
