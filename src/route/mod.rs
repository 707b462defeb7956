//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.

pub mod heading;
mod rhumb;

pub use rhumb::{Rhumb, RhumbEnd, RhumbInverse, RhumbLine};
//!
//! A leg is the shortest line between two places. The trait [`Legs`] finds its closest point to a place, and
//! how far a place is beside it. Polylines and rings are written once, for every surface that has legs:
//!
//! | surface | legs | take it for |
//! |---|---|---|
//! | [`Karney`](crate::geodesic::Karney) | geodesics of the ellipsoid | all, in `f64` to nanometres |
//! | [`GreatCircle`](crate::geodesic::GreatCircle) | great circles of the sphere | speed; up to 0.56 % off |
//! | [`TangentPlane`] | geodesics of some ten kilometres | fields and fences in `f32`, to a centimetre |
//!
//! ```
//! use terrella::geodesic::Karney;
//! use terrella::route::{Legs, Reach};
//! use terrella::{Ellipsoid, LatLon};
//!
//! let earth = Karney::new(Ellipsoid::<f64>::WGS84)?;
//! let path = [LatLon::new(59.9, 10.7)?, LatLon::new(55.7, 12.6)?, LatLon::new(52.5, 13.4)?];
//! let ship = LatLon::new(57.0, 11.5)?;
//! let found = earth.closest_of_path(ship, path).expect("a path has a place");
//! assert_eq!((found.leg, found.closest.reach), (0, Reach::Within));
//! assert_eq!(format!("{:.3}", found.closest.distance), "33060.323");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod bound;
mod closest;
mod legs;
mod on_ellipsoid;
mod on_plane;
mod on_sphere;
mod path;

pub use closest::{Closest, OnPath, Reach, Track};
pub use legs::Legs;
pub use on_ellipsoid::EllipsoidLeg;
pub use on_plane::{PlaneLeg, TangentPlane};
pub use on_sphere::SphereLeg;
mod arc;
mod corridor;
mod edge;
mod fence;
mod globe;
mod planar;
mod side;

pub use arc::{Arc, InvalidArc, Turn};
pub use corridor::{Corridor, Outline};
pub use edge::{Crossing, EdgeCrossing, EdgeDistance};
pub use fence::Fence;
pub use planar::Planar;
pub use side::Side;
