//! What a scene knows of each method: when it holds, its errors, and how the scene makes it.

use super::bounds::Models;
use super::{Distances, Scene};
use crate::Real;
use crate::geodesic::{Andoyer, AnyMethod, Flat, Gauss, GreatCircle, Karney, Method, Plane};

const PI: f64 = core::f64::consts::PI;

/// One block a method, the cheapest first. A method without a block has no bound, and no scene chooses it.
macro_rules! methods {
    ($(
        #[doc = $row:literal]
        $method:ident |$models:ident, $way:ident, $ellipsoid:ident| {
            holds: $holds:expr,
            distance: $distance:expr,
            azimuth: $azimuth:expr,
            rounding: [$double:expr, $single:expr],
            across: $across:expr,
            solver: $solver:expr,
        }
    )*) => {
        impl Scene {
            /// The methods that [`Scene::distances`] chooses from, the cheapest first.
            ///
            /// [`Haversine`](crate::geodesic::Haversine), [`AndoyerSecond`](crate::geodesic::AndoyerSecond) and
            /// [`Vincenty`](crate::geodesic::Vincenty) are not among them: each takes more instructions than a
            /// method with a smaller error, and [`Vincenty`] does not answer everywhere. Nor is
            /// [`Bowring`](crate::geodesic::Bowring), which takes nearly as many as [`Karney`]. The bound of
            /// [`Gauss`] is that of its direct problem, which is Bowring's; its distances are nearer.
            ///
            /// Let s be a distance, σ = s/b, x = max(0, 2σ/π − 1), r = a(1 − f)², u = s/r, δ the half width of
            /// the band of latitudes in radians, φ its latitude farthest from the equator and φ₀ the nearest.
            /// Let t = tan φ, p = max(0.0009 + 0.0037 t², 0.00053 t⁴), q = 0.0007 + 0.00055 t⁴ and ε = 1.1
            /// δ³/6 (t + 6e² + δ/4). M is the radius of curvature in the meridian at φ₀, and N is that across
            /// it at φ + s/2r; the sphere of [`GreatCircle`] has the radius (M + N)/2. The errors of the methods
            /// are at most
            ///
            /// | method | of a distance | of an azimuth | where |
            /// |---|---|---|---|
            $(#[doc = $row])*
            ///
            /// and rounding:
            ///
            /// * In `f64`, 2·10⁻¹⁵ s, and 3 nm more for [`Andoyer`].
            /// * In `f32`, 7·10⁻⁷ s. For [`Karney`], 10⁻⁶ s, but at most 1.5·10⁻⁷ s + 4 m; 33 m half way
            ///   round where f > 1/150.
            /// * In `f32`, the rounding of the places: half a unit of each latitude and longitude, 1.9 m at
            ///   the equator; about an origin, 2⁻²³ of the distance from it.
            /// * An azimuth is off by 2·10⁻¹⁵ (`f64`) or 10⁻⁶ (`f32`) radians, and by the places' rounding,
            ///   or 15 nm, divided by the reduced length.
            ///
            /// Lengths are the Earth's, and in proportion elsewhere. The sphere's error is a theorem: no
            /// curve is longer on the ellipsoid than N/R, or shorter than M/R, times as long as on the sphere
            /// of radius R.
            ///
            /// [`Vincenty`]: crate::geodesic::Vincenty
            pub const METHODS: &[Method] = &[$(Method::$method),*];
        }

        #[allow(unused_variables)] // not every formula takes all
        impl Models {
            /// Whether there is a bound for the method.
            pub const fn known(method: Method) -> bool {
                matches!(method, $(Method::$method)|*)
            }

            /// Whether the method holds in the scene at all.
            #[inline(always)]
            pub const fn holds(&self, method: Method) -> bool {
                match method {
                    $(Method::$method => { let $models = self; $holds })*
                    _ => false,
                }
            }

            /// The error of the method's formulas: of a distance, in metres.
            #[inline(always)]
            pub const fn distance_truncated(&self, method: Method) -> f64 {
                match method {
                    $(Method::$method => { let $models = self; $distance })*
                    _ => f64::INFINITY,
                }
            }

            /// The error of the method's formulas: of an azimuth, in radians.
            #[inline(always)]
            pub const fn azimuth_truncated(&self, method: Method) -> f64 {
                match method {
                    $(Method::$method => { let $models = self; $azimuth })*
                    _ => f64::INFINITY,
                }
            }

            /// The error of the arithmetic: of a distance, in metres.
            #[inline(always)]
            pub const fn rounding(&self, method: Method) -> f64 {
                match (method, self.single) {
                    $(
                        (Method::$method, false) => { let $models = self; $double }
                        (Method::$method, true) => { let $models = self; $single }
                    )*
                    _ => f64::INFINITY,
                }
            }

            /// How far the end of a line is off across it in `f64`, in metres.
            #[inline(always)]
            pub const fn across(&self, method: Method) -> f64 {
                match method {
                    $(Method::$method => { let $models = self; $across })*
                    _ => f64::INFINITY,
                }
            }
        }

        #[allow(unused_variables)]
        impl<T: Real> Distances<T> {
            /// Returns the method for the scene's ellipsoid, ready to use.
            ///
            /// In a constant scene, only this method is linked.
            #[must_use]
            #[inline(always)]
            pub fn solver(&self) -> AnyMethod<T> {
                let ellipsoid = self.scene.ellipsoid.rounded();
                match self.method {
                    $(
                        Method::$method => {
                            let ($way, $ellipsoid) = (self, ellipsoid);
                            AnyMethod::$method($solver)
                        }
                    )*
                    // Without a bound there are no distances.
                    _ => AnyMethod::Karney(Karney::within(ellipsoid)),
                }
            }
        }
    };
}

methods! {
    /// | [`Plane`] | s ε more than [`Flat`] | ε + s/r δ³/12 more | as [`Flat`], δ ≤ 0.3 |
    Plane |m, way, ellipsoid| {
        holds: m.flat_holds() && m.band.half <= 0.3,
        distance: m.flat() + m.far * m.bent(),
        azimuth: {
            let half = m.band.half;
            m.flat_turned() + m.bent() + m.arc * half * half * half / 12.0
        },
        rounding: [2e-15 * m.far, 7e-7 * m.far],
        across: 0.0,
        solver: {
            let [south, north] = way.scene.latitudes;
            let lat = T::of(0.5 * (south + north));
            let middle = if way.scene.local { T::ZERO } else { lat };
            Plane::within(ellipsoid, lat, middle)
        },
    }
    /// | [`Flat`] | 1.25 s³/(24r²) (0.26 + 1.13 t²) | 1.25 s²/r² (0.033 + 0.027 t²) | s ≤ r/2, s t ≤ r/2 |
    Flat |m, way, ellipsoid| {
        holds: !m.local && m.flat_holds(),
        distance: m.flat(),
        azimuth: m.flat_turned(),
        rounding: [2e-15 * m.far, 7e-7 * m.far],
        across: 0.0,
        solver: Flat::within(ellipsoid),
    }
    /// | [`Gauss`] | 1.25 s u² (2f² + 0.14 f u + p u²) | 1.25 u² (0.24 f² + 0.045 f u + q u²) | as [`Flat`] |
    Gauss |m, way, ellipsoid| {
        holds: !m.local && m.flat_holds(),
        distance: m.gauss(),
        azimuth: m.gauss_turned(),
        rounding: [2e-15 * m.far, 7e-7 * m.far],
        across: 0.0,
        solver: Gauss::within(ellipsoid),
    }
    /// | [`GreatCircle`] | s (N − M)/(2M) | 1.2 f cos²φ₀ (1 + 1.45 x²/(π − σ)) | |
    GreatCircle |m, way, ellipsoid| {
        holds: !m.local,
        distance: {
            let [_, off] = m.sphere();
            off * m.far
        },
        azimuth: {
            let [_, beyond, short] = m.angle();
            let cos = m.band.flattest.cos + 1e-7;
            (1.2 * m.ellipsoid.f() * cos * cos * (1.0 + 1.45 * beyond * beyond / short)).min(PI)
        },
        rounding: [2e-15 * m.far, 7e-7 * m.far],
        across: 0.0,
        solver: {
            let [radius, _] = way.models().sphere();
            GreatCircle::within(T::of(radius))
        },
    }
    /// | [`Andoyer`] | 1.2 a f² (σ/8 + 1.08x/(π − σ)), 2af if less | 1.2 f² (0.33 + 2.9 (σ/π)²/(π − σ)²) | |
    Andoyer |m, way, ellipsoid| {
        holds: !m.local,
        distance: {
            let [sigma, beyond, short] = m.angle();
            let (a, f) = (m.ellipsoid.a(), m.ellipsoid.f());
            (1.2 * a * f * f * (0.125 * sigma + 1.08 * beyond / short)).min(2.0 * a * f)
        },
        azimuth: {
            let [sigma, _, short] = m.angle();
            let (f, turn) = (m.ellipsoid.f(), sigma / (PI * short));
            (1.2 * f * f * (0.33 + 2.9 * turn * turn)).min(PI)
        },
        rounding: [2e-15 * m.far + 3e-9 * m.size(), 7e-7 * m.far],
        across: 1.5e-8 * m.size(),
        solver: Andoyer::within(ellipsoid),
    }
    /// | [`Karney`] | 7·10⁻⁹ m on the Earth | 0 | |
    Karney |m, way, ellipsoid| {
        holds: !m.local,
        distance: 0.0,
        azimuth: 0.0,
        rounding: [
            if m.ellipsoid.f() <= 1.0 / 150.0 { 7e-9 * m.size() } else { 1.2e-8 * m.size() },
            // Half way round the equator, where the straight lines do not hold.
            if m.ellipsoid.f() > 1.0 / 150.0 && m.arc > 0.97 * PI {
                33.0 * m.size()
            } else {
                (1e-6 * m.far).min(1.5e-7 * m.far + 4.0 * m.size())
            }
        ],
        across: 1.5e-8 * m.size(),
        solver: Karney::within(ellipsoid),
    }
}
