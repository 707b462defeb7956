//! No more than the scene needs: the cheapest model that keeps a tolerance, chosen before anything is computed.
//!
//! A [`Scene`] is what a caller knows: an ellipsoid, latitudes, distances, heights and the error that does no harm. Each question has an answer with a bound
//! that holds, or an error with what would be reached:
//!
//! | question | answers, the cheapest first |
//! |---|---|
//! | [`Scene::distances`] | [`Plane`](crate::geodesic::Plane), [`Flat`](crate::geodesic::Flat), the sphere of the best radius, [`Andoyer`](crate::geodesic::Andoyer), [`Karney`](crate::geodesic::Karney) |
//! | [`Scene::areas`] | [`PlanarArea`](crate::geodesic::PlanarArea), [`Area`](crate::geodesic::Area) |
//! | [`Scene::positions`] | [`Expansion`] of the first order, of the second, [`LocalFrame`](crate::LocalFrame) |
//! | [`Scene::scalar`] | `f32`, `f32` about an origin, `f64` |
//! | [`Scene::figure`] | a sphere without a shift, a sphere with one, the ellipsoid |
//! | [`Scene::tiles`] | from which level a tile is its four corners, or a series |
//!
//! Every question is a `const fn` and takes some 70 to 110 ns at run time (`scalar`, which asks three times, 200). A constant scene is answered by the compiler: a scene that nothing can serve does not compile, and
//! what was not chosen is not linked.
//!
//! **A quadcopter's geofence**: a kilometre about the field, five centimetres, single precision. Differences from the field's middle in degrees fit it, and a plane.
//!
//! ```
//! use terrella::geodesic::{Geodesic, Method};
//! use terrella::scene::{Distances, Positions, Scalar, Scene, View};
//! use terrella::{Ellipsoid, Geodetic, LatLon};
//!
//! const FIELD: Scene = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0).heights(400.0, 550.0).within(0.05);
//! assert_eq!(FIELD.scalar()?, Scalar::Local); // degrees in f32 are up to 0.9 m off
//! const WAY: Distances<f32> = match FIELD.local().distances() {
//!     Ok(way) => way,
//!     Err(_) => panic!("no model is good enough"), // would not compile
//! };
//! assert_eq!(WAY.method(), Method::Plane);
//! assert!(WAY.bound().distance < 0.002);
//! let fence = WAY.solver();
//! let (home, drone) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.004_5, -0.006)?);
//! assert!((fence.inverse(home, drone)?.distance - 674.850).abs() < 0.002);
//!
//! // East, north and up of the field.
//! let positions: Positions<f32> = FIELD.local().up_to(1000.0).positions()?;
//! assert_eq!(positions.view(), View::Quadratic);
//! let about = positions.about(Geodetic::new(LatLon::new(47.4, 8.55)?, 430.0)?);
//! assert!((about.enu(Geodetic::new(drone, 60.0)?).up - 59.964).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **An airliner's leg**: 9000 km, any latitude. What ten metres need is good for a millimetre, too; twenty are cheaper.
//!
//! ```
//! use terrella::geodesic::{Geodesic, Method};
//! use terrella::scene::{Distances, Scene};
//! use terrella::{Ellipsoid, LatLon};
//!
//! const LEG: Scene = Scene::new(Ellipsoid::WGS84).up_to(9_000_000.0);
//! let method = |metres| LEG.within(metres).distances::<f64>().map(|leg| leg.method());
//! assert_eq!([method(20.0)?, method(10.0)?, method(0.001)?], [Method::Andoyer, Method::Karney, Method::Karney]);
//! let leg: Distances<f64> = LEG.within(0.001).distances()?;
//! let (zurich, johannesburg) = (LatLon::new(47.458, 8.548)?, LatLon::new(-26.139, 28.246)?);
//! let way = leg.solver().inverse(zurich, johannesburg)?;
//! assert_eq!(format!("{:.3}", way.distance), "8386734.099");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A planet renderer's view**: pixels of half a milliradian, and what one of them hides.
//!
//! ```
//! use terrella::Ellipsoid;
//! use terrella::cube::Projection;
//! use terrella::scene::{Figure, Scene, Tiles};
//!
//! const EARTH: Scene = Scene::new(Ellipsoid::WGS84).heights(-11_000.0, 9_000.0);
//! let from = |metres| EARTH.within_pixels(1.0, 5e-4, metres);
//! // The ellipsoid is a sphere from beyond 50 000 km, with the geocentric shift from half as far.
//! assert!(matches!(from(50e6).figure()?, Figure::Sphere { .. }));
//! assert!(matches!(from(25e6).figure()?, Figure::Shifted { .. }));
//! assert!(matches!(from(20e6).figure()?, Figure::Ellipsoid { .. }));
//! // Tiles seen from no nearer than 1000 km are their four corners from level 7 on, from 1 km from level 12.
//! let tiles = |metres| from(metres).tiles(Projection::Adjusted).map(|tiles| (tiles.plain, tiles.series));
//! assert_eq!(tiles(1e6)?, (Some(7), Some(5)));
//! assert_eq!(tiles(1e3)?, (Some(12), Some(9)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! Bounds are formulas, stated with the questions: from Taylor's theorem and the metric where that is short, else the form that theory gives, with the factors of a search (`tests/scene/search.rs`) and a fifth or a quarter more. They
//! hold for spheres and oblate ellipsoids to f = 1/100 of any size; others are refused. `cargo test --release --test scene -- --ignored --nocapture` draws a million scenes of each kind and places in
//! them: no bound is exceeded, half of the bounds are less than 1.4 times the largest error (of distances in `f64`), and where a cheaper model's error is less than a quarter of the tolerance it was taken in 97 of 100.

mod areas;
mod band;
mod bounds;
mod distances;
mod error;
mod expansion;
mod figure;
mod methods;
mod positions;
mod scalar;
mod tiles;

pub use areas::{AnyArea, Areas, Surface};
pub use bounds::Bound;
pub use distances::Distances;
pub use error::SceneError;
pub use expansion::Expansion;
pub use figure::Figure;
pub use positions::{AnyView, Positions, View};
pub use scalar::Scalar;
pub use tiles::Tiles;

use crate::Ellipsoid;
use band::{DEGREE, Parallel};

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
        let nearest = (latitude.abs() - radius / (ellipsoid.a() * DEGREE)).clamp(0.0, 90.0);
        let reach = radius / (Parallel::new(nearest).along(ellipsoid) * DEGREE);
        // A clamp keeps what is not a number, to be refused.
        Self::new(ellipsoid)
            .latitudes(
                (latitude - reach).clamp(-90.0, 90.0),
                (latitude + reach).clamp(-90.0, 90.0),
            )
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
        let polar = bounds::polar_radius(self.ellipsoid);
        if !(self.ellipsoid.f() >= 0.0 && self.ellipsoid.f() <= 0.01) {
            Some(SceneError::Flattening(self.ellipsoid.f()))
        } else if !ordered(self.latitudes, -90.0, 90.0) {
            Some(SceneError::Latitudes(self.latitudes))
        } else if !ordered(self.distances, 0.0, f64::MAX) {
            Some(SceneError::Distances(self.distances))
        } else if !ordered(self.heights, -0.5 * polar, polar) {
            Some(SceneError::Heights(self.heights))
        } else if !ordered([self.tolerance; 2], 0.0, f64::INFINITY) {
            Some(SceneError::Tolerance(self.tolerance))
        } else if !ordered([self.azimuth; 2], 0.0, f64::INFINITY) {
            Some(SceneError::Tolerance(self.azimuth))
        } else {
            None
        }
    }
}
