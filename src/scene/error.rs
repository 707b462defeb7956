use core::fmt;

use super::Bound;
use crate::geodesic::Method;

/// Why a question about a scene has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SceneError {
    /// The flattening is not in [0, 1/100].
    Flattening(f64),
    /// The latitudes of south and north, in degrees: −90 ≤ south ≤ north ≤ 90 does not hold.
    Latitudes([f64; 2]),
    /// The nearest and the farthest distance, in metres: 0 ≤ nearest ≤ farthest < ∞ does not hold.
    Distances([f64; 2]),
    /// The lowest and the highest height, in metres: −b/2 ≤ lowest ≤ highest ≤ b does not hold, with the
    /// polar semi-axis b.
    Heights([f64; 2]),
    /// A tolerance that is negative or NaN, in metres or radians.
    Tolerance(f64),
    /// [`Scene::METHODS`](super::Scene::METHODS) has no such method, because no bound of its error is known.
    NoBound(Method),
    /// No method is accurate enough. The bound is that of the method with the smallest error of a distance or
    /// a position.
    OutOfReach(Bound),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flattening(flattening) => write!(f, "flattening {flattening} is not in [0, 1/100]"),
            Self::Latitudes(band) => write!(f, "latitudes {band:?}: expected -90 <= south <= north <= 90"),
            Self::Distances(distances) => {
                write!(
                    f,
                    "distances {distances:?}: expected 0 <= nearest <= farthest < infinity"
                )
            }
            Self::Heights(heights) => write!(
                f,
                "heights {heights:?}: expected -b/2 <= lowest <= highest <= b, with the polar semi-axis b"
            ),
            Self::Tolerance(tolerance) => write!(f, "tolerance {tolerance}: expected 0 or a positive number"),
            Self::NoBound(method) => write!(f, "no bound is known for the method {method}"),
            Self::OutOfReach(Bound { distance, azimuth }) => write!(
                f,
                "no method is accurate enough; the best one reaches {distance:e} m and {azimuth:e} rad"
            ),
        }
    }
}

impl core::error::Error for SceneError {}
