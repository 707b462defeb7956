//! No more than the scene needs: the cheapest model that keeps a tolerance, chosen before anything is computed.
//!
//! A [`Scene`] is what a caller knows: an ellipsoid, latitudes, distances, heights and the error that does no harm. Each question has an answer with a bound
//! that holds, or an error with what would be reached:
//!
//! | question | answers, the cheapest first |
//! |---|---|
//! | [`Scene::distances`] | [`Plane`](crate::geodesic::Plane), [`Flat`](crate::geodesic::Flat), the sphere of the best radius, [`Andoyer`](crate::geodesic::Andoyer), [`Vincenty`](crate::geodesic::Vincenty), [`Karney`](crate::geodesic::Karney) |
//! | [`Scene::positions`] | [`Expansion`] of the first order, of the second, [`LocalFrame`](crate::LocalFrame) |
//! | [`Scene::scalar`] | `f32`, `f32` about an origin, `f64` |
//! | [`Scene::figure`] | a sphere without a shift, a sphere with one, the ellipsoid |
//! | [`Scene::tiles`] | from which level a tile is its four corners, a plane or a series |
//!
//! Every question is a `const fn`. A constant scene is answered by the compiler: a scene that nothing can serve does not compile, and what was not chosen is
//! not linked.
//!
//! ```
//! use terrella::geodesic::Geodesic;
//! use terrella::scene::{Distances, Model, Scene};
//! use terrella::{Ellipsoid, LatLon};
//!
//! // A kilometre about the field, to five centimetres.
//! const FENCE: Scene = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0).local().within(0.05);
//! const WAY: Distances<f32> = match FENCE.distances() {
//!     Ok(way) => way,
//!     Err(_) => panic!("no model is good enough"),
//! };
//! assert!(matches!(WAY.model(), Model::Plane));
//! let plane = WAY.method();
//! // Places are degrees north and east of the middle of the field.
//! let way = plane.inverse(LatLon::new(0.0, 0.0)?, LatLon::new(0.004_5, -0.006)?)?;
//! assert!((way.distance - 675.70).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Bounds are formulas, stated where they are used: from Taylor's theorem and the metric where that is short, else the form that theory gives with factors from
//! `tests/scene/fit.rs`, which searches for the largest error and fails where a fifth more than it is not covered. They hold for spheres and oblate ellipsoids to f = 1/100 of any
//! size; others are refused. `tests/scene` draws scenes and places in them: no bound is exceeded, and half of them are less than four times the largest error.

mod band;
mod bounds;
mod distances;
mod error;
mod expansion;
mod figure;
mod model;
mod positions;
mod scalar;
mod tiles;

pub use distances::Distances;
pub use error::SceneError;
pub use expansion::Expansion;
pub use figure::Figure;
pub use model::{Bound, Method, Model};
pub use positions::{Positions, View, Views};
pub use scalar::Scalar;
pub use tiles::Tiles;

use crate::Ellipsoid;
use band::{DEGREE, radii};

/// What is known of a scene, and what harms it.
///
/// All of the ellipsoid, to begin with: every latitude, any two places, no heights; no tolerance in metres, any in azimuths. What is wrong with it the questions say.
///
/// ```
/// use terrella::Ellipsoid;
/// use terrella::scene::Scene;
/// // Europe, from 100 m to 5000 km, to a metre, and to a minute of arc in azimuth.
/// const EUROPE: Scene = Scene::new(Ellipsoid::WGS84)
///     .latitudes(35.0, 71.0)
///     .between(100.0, 5_000_000.0)
///     .within(1.0)
///     .azimuths(2.9e-4);
/// assert!(EUROPE.distances::<f64>().is_ok());
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene {
    ellipsoid: Ellipsoid<f64>,
    /// South and north, degrees.
    latitudes: [f64; 2],
    /// Nearest and farthest, metres.
    distances: [f64; 2],
    /// Lowest and highest, metres.
    heights: [f64; 2],
    local: bool,
    /// Metres.
    tolerance: f64,
    /// Radians.
    azimuth: f64,
}

impl Scene {
    /// All of an ellipsoid.
    #[must_use]
    pub const fn new(ellipsoid: Ellipsoid<f64>) -> Self {
        Self {
            ellipsoid,
            latitudes: [-90.0, 90.0],
            distances: [0.0, core::f64::consts::PI * ellipsoid.a()],
            heights: [0.0, 0.0],
            local: false,
            tolerance: 0.0,
            azimuth: f64::INFINITY,
        }
    }

    /// The places within a radius in metres of one at a latitude in degrees: any two of them.
    #[must_use]
    pub const fn around(ellipsoid: Ellipsoid<f64>, latitude: f64, radius: f64) -> Self {
        let [m, _] = radii(ellipsoid, (latitude.abs() - radius / (ellipsoid.a() * DEGREE)).max(0.0));
        let reach = radius / (m * DEGREE);
        Self::new(ellipsoid)
            .latitudes((latitude - reach).max(-90.0), (latitude + reach).min(90.0))
            .up_to(2.0 * radius)
    }

    /// Between these latitudes in degrees.
    #[must_use]
    pub const fn latitudes(self, south: f64, north: f64) -> Self {
        Self {
            latitudes: [south, north],
            ..self
        }
    }

    /// Places at most this far apart, or from the origin: metres along the ellipsoid.
    #[must_use]
    pub const fn up_to(self, farthest: f64) -> Self {
        let [nearest, _] = self.distances;
        self.between(nearest, farthest)
    }

    /// Places no nearer to each other, and no farther apart: metres. Azimuths in single precision, and those of the dearer models, need a nearest distance: nearer, rounding turns them.
    #[must_use]
    pub const fn between(self, nearest: f64, farthest: f64) -> Self {
        Self {
            distances: [nearest, farthest],
            ..self
        }
    }

    /// Heights over the ellipsoid, in metres.
    #[must_use]
    pub const fn heights(self, lowest: f64, highest: f64) -> Self {
        Self {
            heights: [lowest, highest],
            ..self
        }
    }

    /// Places are given as degrees north and east, and metres up, of an origin in the middle of the latitudes: exact differences, in single precision 2⁻²⁴ of themselves off.
    #[must_use]
    pub const fn local(self) -> Self {
        Self { local: true, ..self }
    }

    /// The tolerance: an error in metres that does no harm.
    #[must_use]
    pub const fn within(self, metres: f64) -> Self {
        Self {
            tolerance: metres,
            ..self
        }
    }

    /// The tolerance in pixels, each of so many radians, seen from so far in metres.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::scene::Scene;
    /// let earth = Scene::new(Ellipsoid::WGS84);
    /// assert_eq!(earth.within_pixels(1.0, 1e-3, 20_000.0), earth.within(20.0));
    /// ```
    #[must_use]
    pub const fn within_pixels(self, pixels: f64, radians: f64, distance: f64) -> Self {
        self.within(pixels * radians * distance)
    }

    /// The tolerance of azimuths, in radians.
    #[must_use]
    pub const fn azimuths(self, radians: f64) -> Self {
        Self {
            azimuth: radians,
            ..self
        }
    }

    /// What is wrong with the scene. Comparisons are written so that NaN is.
    const fn fault(&self) -> Option<SceneError> {
        const fn ordered([low, high]: [f64; 2], least: f64, most: f64) -> bool {
            least <= low && low <= high && high <= most
        }
        let polar = self.ellipsoid.a() * (1.0 - self.ellipsoid.f());
        if !(self.ellipsoid.f() >= 0.0 && self.ellipsoid.f() <= 0.01) {
            Some(SceneError::Flattening(self.ellipsoid.f()))
        } else if !ordered(self.latitudes, -90.0, 90.0) {
            Some(SceneError::Latitudes(self.latitudes))
        } else if !ordered(self.distances, 0.0, f64::MAX) {
            Some(SceneError::Distances(self.distances))
        } else if !ordered(self.heights, -0.5 * polar, polar) {
            Some(SceneError::Heights(self.heights))
        } else if !(self.tolerance >= 0.0) {
            Some(SceneError::Tolerance(self.tolerance))
        } else if !(self.azimuth >= 0.0) {
            Some(SceneError::Tolerance(self.azimuth))
        } else {
            None
        }
    }
}
