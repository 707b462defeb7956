//! Routes and fields: legs, closest points, intersections, rhumb lines, rings and fences.
//!
//! Latitudes, longitudes and azimuths are in degrees, lengths in metres.
//!
//! | question | item |
//! |---|---|
//! | How far is a place beside a leg, and how far along? Which point of a route is closest? | [`Legs`] |
//! | Where do two lines cross? | [`Intersections`] |
//! | Where does a line cross a parallel or a meridian, and where is it northernmost? | [`Segment`] |
//! | Which places divide a line, every so many metres or to a tolerance? | [`Segment`], [`Waypoints`], [`Densified`] |
//! | Is a place inside a fence, and how far from its edge? | [`Fence`] |
//! | How long is an arc about a centre? Which polygon is a circle, or a route with a width? | [`Arc`], [`Corridor`] |
//! | What is the course with a constant azimuth? | [`Rhumb`] |
//! | What is the difference or the mean of headings? | [`heading`] |
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

mod arc;
mod bound;
mod closest;
mod corridor;
mod densified;
mod edge;
mod fence;
mod globe;
pub mod heading;
mod intersection;
mod legs;
mod on_ellipsoid;
mod on_plane;
mod on_sphere;
mod path;
mod planar;
mod rhumb;
mod segment;
mod side;
mod waypoints;

pub use arc::{Arc, InvalidArc, Turn};
pub use closest::{Closest, OnPath, Reach, Track};
pub use corridor::{Corridor, Outline};
pub use densified::Densified;
pub use edge::{Crossing, EdgeCrossing, EdgeDistance};
pub use fence::Fence;
pub use intersection::{Intersection, Intersections, IntersectionsWithin, Overlap};
pub use legs::Legs;
pub use on_plane::{PlaneLeg, TangentPlane};
pub use on_sphere::SphereLeg;
pub use planar::Planar;
pub use rhumb::{Rhumb, RhumbEnd, RhumbInverse, RhumbLine};
pub use segment::Segment;
pub use side::Side;
pub use waypoints::{InvalidStep, Waypoints};
