//! Chooses the cheapest formula that keeps a tolerance, before anything is computed.
//!
//! A [`Scene`] describes a task: an ellipsoid, latitudes, distances, heights, and the error that does no
//! harm. Each question returns an answer with a bound of its error, or an error with the bound that could be
//! reached:
//!
//! | question | possible answers, the cheapest first |
//! |---|---|
//! | [`Scene::distances`] | the methods in [`Scene::METHODS`], from `Plane` to `Karney` |
//! | [`Scene::areas`] | [`PlanarArea`](crate::geodesic::PlanarArea), [`Area`](crate::geodesic::Area) |
//! | [`Scene::positions`] | [`Expansion`] of the first or second order, [`LocalFrame`](crate::LocalFrame) |
//! | [`Scene::geodetics`] | orders of [`GeodeticSeries`](crate::GeodeticSeries), [`Ellipsoid::to_geodetic`] |
//! | [`Scene::scalar`] | `f32`, `f32` about an origin, `f64` |
//! | [`Scene::figure`] | a sphere without a shift, a sphere with one, the ellipsoid |
//! | [`Scene::tiles`] | the level from which a tile is its four corners, or a series |
//!
//! Every question is a `const fn`. At run time it takes 70 to 110 ns (`scalar`, which asks three times, 200
//! ns). For a constant scene the compiler answers: a scene that no formula can serve does not compile, and
//! formulas that were not chosen are not linked.
//!
//! **A quadcopter's geofence**: a kilometre about the field, five centimetres, single precision. A plane is
//! enough, if places are given as degrees from the middle of the field.
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
//!     Err(_) => panic!("no method is accurate enough"), // would not compile
//! };
//! assert_eq!(WAY.method(), Method::Plane);
//! assert!(WAY.bound().distance < 0.002);
//! let fence = WAY.solver();
//! let (home, drone) = (LatLon::new(0.0, 0.0)?, LatLon::new(0.004_5, -0.006)?);
//! assert!((fence.inverse(home, drone)?.distance - 674.850).abs() < 0.002);
//!
//! // East, north and up of the field's middle.
//! let positions: Positions<f32> = FIELD.local().up_to(1000.0).positions()?;
//! assert_eq!(positions.view(), View::Quadratic);
//! let about = positions.about(Geodetic::new(LatLon::new(47.4, 8.55)?, 430.0)?);
//! assert!((about.enu(Geodetic::new(drone, 60.0)?).up - 59.964).abs() < 0.05);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **An airliner's leg**: 9000 km, any latitude. A tolerance of ten metres already needs the exact method;
//! one of twenty metres does not.
//!
//! ```
//! use terrella::geodesic::{Geodesic, Method};
//! use terrella::scene::{Distances, Scene};
//! use terrella::{Ellipsoid, LatLon};
//!
//! const LEG: Scene = Scene::new(Ellipsoid::WGS84).up_to(9_000_000.0);
//! let method = |metres| LEG.within(metres).distances::<f64>().map(|leg| leg.method());
//! assert_eq!([method(20.0)?, method(10.0)?], [Method::Andoyer, Method::Karney]);
//! let leg: Distances<f64> = LEG.within(0.001).distances()?;
//! let (zurich, johannesburg) = (LatLon::new(47.458, 8.548)?, LatLon::new(-26.139, 28.246)?);
//! let way = leg.solver().inverse(zurich, johannesburg)?;
//! assert_eq!(format!("{:.3}", way.distance), "8386734.099");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! **A planet renderer's view**: the tolerance is one pixel of half a milliradian.
//!
//! ```
//! use terrella::Ellipsoid;
//! use terrella::cube::Projection;
//! use terrella::scene::{Figure, Scene, Tiles};
//!
//! const EARTH: Scene = Scene::new(Ellipsoid::WGS84).heights(-11_000.0, 9_000.0);
//! let from = |metres| EARTH.within_pixels(1.0, 5e-4, metres);
//! // From 50 000 km the ellipsoid looks like a sphere; from half as far, like one with the geocentric shift.
//! assert!(matches!(from(50e6).figure()?, Figure::Sphere { .. }));
//! assert!(matches!(from(25e6).figure()?, Figure::Shifted { .. }));
//! assert!(matches!(from(20e6).figure()?, Figure::Ellipsoid { .. }));
//! // Seen from 1000 km, tiles of level 7 need only their four corners; seen from 1 km, those of level 12.
//! let tiles = |metres| from(metres).tiles(Projection::Adjusted).map(|tiles| (tiles.plain, tiles.series));
//! assert_eq!(tiles(1e6)?, (Some(7), Some(5)));
//! assert_eq!(tiles(1e3)?, (Some(12), Some(9)));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The bounds are formulas, which each question states. Where Taylor's theorem and the metric give a short
//! one, it is proved; elsewhere the theory gives the form, a search (`tests/scene/search.rs`) the factors,
//! and the formula adds a fifth or a quarter. They hold for spheres and for oblate ellipsoids of any size
//! with f ≤ 1/100; others are refused.
//!
//! `cargo test --release --test scene -- --ignored --nocapture` draws a million scenes of each kind, and
//! places in them. No bound is exceeded. Half of the bounds are less than 1.4 times the largest error (of
//! distances in `f64`). Where a cheaper method's error is less than a quarter of the tolerance, the scene
//! takes it in 97 of 100 cases.

mod areas;
mod band;
mod bounds;
mod distances;
mod error;
mod expansion;
mod figure;
mod geodetics;
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
pub use geodetics::{AnyOrder, Geodetics, Order};
pub use positions::{AnyView, Positions, View};
pub use scalar::Scalar;
pub use tiles::Tiles;

use crate::Ellipsoid;
use band::{DEGREE, Parallel};

/// A task: where the places are, and which error does no harm.
///
/// [`Scene::new`] describes the whole ellipsoid: every latitude, any two places, height 0, a tolerance of 0
/// m, and any error of azimuths. The other functions narrow it. They accept any number; each question checks
/// the scene first, and refuses a wrong one with a [`SceneError`].
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
    /// Creates the scene of a whole ellipsoid.
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

    /// Creates the scene of the places within a radius in metres of a place at a latitude in degrees.
    /// Distances are those between any two of them.
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

    /// Sets the southernmost and the northernmost latitude, in degrees.
    #[must_use]
    pub const fn latitudes(self, south: f64, north: f64) -> Self {
        Self {
            latitudes: [south, north],
            ..self
        }
    }

    /// Sets the farthest distance between two places, or from the origin, in metres along the ellipsoid.
    #[must_use]
    pub const fn up_to(self, farthest: f64) -> Self {
        let [nearest, _] = self.distances;
        self.between(nearest, farthest)
    }

    /// Sets the nearest and the farthest distance between two places, in metres.
    ///
    /// Bounds of azimuths need a nearest distance in single precision, and for the more exact methods:
    /// between nearer places, rounding turns the azimuth.
    #[must_use]
    pub const fn between(self, nearest: f64, farthest: f64) -> Self {
        Self {
            distances: [nearest, farthest],
            ..self
        }
    }

    /// Sets the lowest and the highest height over the ellipsoid, in metres.
    #[must_use]
    pub const fn heights(self, lowest: f64, highest: f64) -> Self {
        Self {
            heights: [lowest, highest],
            ..self
        }
    }

    /// Says that places are given as degrees north and east, and metres up, of an origin in the middle of the
    /// latitudes.
    ///
    /// In single precision such a difference is off by 2⁻²⁴ of itself, where a latitude or longitude is off
    /// by up to 0.9 m.
    #[must_use]
    pub const fn local(self) -> Self {
        Self { local: true, ..self }
    }

    /// Sets the tolerance: the error in metres that does no harm.
    #[must_use]
    pub const fn within(self, metres: f64) -> Self {
        Self {
            tolerance: metres,
            ..self
        }
    }

    /// Sets the tolerance to a number of pixels, from the angle of a pixel in radians and the distance in
    /// metres from which it is seen.
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

    /// Sets the tolerance of azimuths, in radians.
    #[must_use]
    pub const fn azimuths(self, radians: f64) -> Self {
        Self {
            azimuth: radians,
            ..self
        }
    }

    /// What is wrong with the scene. Comparisons are written so that NaN is refused.
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
