use core::fmt;

use super::Bound;

/// Why a question about a scene has no answer.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SceneError {
    /// The flattening is not in [0, 1/100].
    Flattening(f64),
    /// The southern and the northern latitude are not in this order in [−90, 90].
    Latitudes([f64; 2]),
    /// The nearest and the farthest distance are not in this order, not negative and finite.
    Distances([f64; 2]),
    /// The lowest and the highest height are not in this order, from minus a half to the whole of the polar radius.
    Heights([f64; 2]),
    /// A tolerance that is negative or not a number.
    Tolerance(f64),
    /// No model is good enough. This is what the one of the smallest error of distances or positions reaches.
    OutOfReach(Bound),
}

impl fmt::Display for SceneError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flattening(flattening) => write!(f, "flattening {flattening} is not in [0, 1/100]"),
            Self::Latitudes(band) => write!(f, "latitudes {band:?} are not in order in [-90, 90]"),
            Self::Distances(distances) => write!(f, "distances {distances:?} are not in order and finite"),
            Self::Heights(heights) => write!(f, "heights {heights:?} are not in order, or too far from the ellipsoid"),
            Self::Tolerance(tolerance) => write!(f, "tolerance {tolerance} is negative or not a number"),
            Self::OutOfReach(Bound { distance, azimuth }) => {
                write!(
                    f,
                    "no model is good enough: {distance:e} m and {azimuth:e} rad can be had"
                )
            }
        }
    }
}

impl core::error::Error for SceneError {}
