//! What is known of a projection, written once in its own file: [`Profile`], and the macro `projection!`.

use super::decay::Decay;

/// What is known of a projection: names, origin, distortion on the sphere, errors and cost.
///
/// Every figure is measured, and a test checks it. The distortion is that of the whole cube on the sphere.
///
/// ```
/// use terrella::cube::{Balanced, Kept, Projection};
/// assert_eq!(Balanced::PROFILE.oversize, 1.405);
/// let of_equal_area = Projection::ALL.iter().filter(|p| p.profile().keeps == Some(Kept::Areas));
/// let names: Vec<_> = of_equal_area.map(|p| p.name()).collect();
/// assert_eq!(names, ["quadrilateralized", "healpix", "vertex", "arvo", "creaseless"]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Profile {
    /// The name in lower case: the one that [`Projection`](super::Projection) is parsed from.
    pub name: &'static str,
    /// The name as a heading.
    pub title: &'static str,
    /// Other names, separated by commas; empty if there are none.
    pub also: &'static str,
    /// How the projection works.
    pub idea: &'static str,
    /// Who published it, and who uses it.
    pub origin: &'static str,
    /// The property that the projection keeps exactly, or `None`.
    pub keeps: Option<Kept>,
    /// The largest area of a cell on the sphere, divided by the smallest; infinite for
    /// [`Conformal`](super::Conformal).
    pub area_ratio: f64,
    /// The largest ratio of a cell's width to its height, divided by the smallest.
    pub aspect_ratio: f64,
    /// Texture oversize ε of Dimitrijević, Lambers & Rančić (2016), eq. 3.9: the larger of the aspect ratio
    /// and the largest product of a cell's width and height, divided by the smallest.
    pub oversize: f64,
    /// The largest angular deformation ω in degrees: how much the angle between two lines can change.
    pub deformation: f64,
    /// Formula, error and cost from the sphere to the cube. The error is that of x and y.
    pub forward: Evaluation,
    /// Formula, error and cost from the cube to the sphere. The error is that of the direction, in radians.
    pub inverse: Evaluation,
    /// How the errors of simplified tiles shrink with the level: see
    /// [`Scene::tiles`](crate::scene::Scene::tiles).
    pub(crate) tiles: [Decay; 2],
}

/// A property that a projection keeps exactly.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Kept {
    /// Cells of equal size in x and y have equal areas on the sphere.
    Areas,
    /// Angles are the same on the face as on the sphere, except at the corners of the cube.
    Angles,
    /// Great circles are straight lines on a face.
    GreatCircles,
}

/// How a projection is computed in one direction (to the cube or to the sphere), with its error and cost.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Evaluation {
    /// The kind of formula.
    pub formula: Formula,
    /// The largest error, in `f64` and in `f32`.
    pub worst_error: [f64; 2],
    /// The number of instructions for one point, in `f64` and in `f32`, on x86-64 with SSE2 and without
    /// batches, to two digits.
    pub instructions: [u32; 2],
}

/// A kind of formula.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Formula {
    /// Arithmetic and square roots.
    Algebraic,
    /// Trigonometric functions.
    Trigonometric,
    /// A polynomial with fitted coefficients.
    Polynomial,
    /// A power series.
    Series,
    /// A fixed number of steps of Newton's method.
    Iteration,
}

impl Formula {
    /// Returns the name, in lower case.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Algebraic => "algebraic",
            Self::Trigonometric => "trigonometric",
            Self::Polynomial => "polynomial",
            Self::Series => "series",
            Self::Iteration => "iteration",
        }
    }
}

/// Declares the type of a projection, with its [`Profile`] and its page of documentation.
macro_rules! projection {
    (
        $(#[$attribute:meta])*
        $variant:ident $name:literal {
            title: $title:literal,
            also: $also:literal,
            summary: $summary:literal,
            idea: $idea:literal,
            origin: $origin:literal,
            choose: $choose:literal,
            keeps: $keeps:expr,
            area_ratio: $area:tt,
            aspect_ratio: $aspect:literal,
            oversize: $oversize:tt,
            deformation: $deformation:literal,
            forward: $forward:ident, error [$xy64:literal, $xy32:literal],
                instructions [$to64:literal, $to32:literal];
            inverse: $inverse:ident, error [$rad64:literal, $rad32:literal],
                instructions [$from64:literal, $from32:literal];
            tiles: $tiles:expr,
        }
    ) => {
        #[doc = $summary]
        ///
        #[doc = $idea]
        ///
        #[doc = concat!("**Origin.** ", $origin)]
        ///
        #[doc = concat!("**Choice.** ", $choose)]
        ///
        #[doc = concat!("**Name.** `", $name, "`, for [`Projection`](crate::cube::Projection).")]
        ///
        #[doc = include_str!(concat!("pictures/", $name, ".svg"))]
        ///
        /// | [largest area over smallest] | [aspect ratio] | [texture oversize ε] | [angular deformation ω] |
        /// |---|---|---|---|
        #[doc = concat!(
            "| ", $crate::cube::projection::profile::figure!(text $area), " | ", $aspect, " | ",
            $crate::cube::projection::profile::figure!(text $oversize), " | ", $deformation, "° |"
        )]
        ///
        /// [largest area over smallest]: crate::cube::Profile::area_ratio
        /// [aspect ratio]: crate::cube::Profile::aspect_ratio
        /// [texture oversize ε]: crate::cube::Profile::oversize
        /// [angular deformation ω]: crate::cube::Profile::deformation
        ///
        /// | | formula | worst error, `f64` | `f32` | instructions for one point, `f64` | `f32` |
        /// |---|---|---|---|---|---|
        #[doc = concat!(
            "| to the cube | ", stringify!($forward), " | ", stringify!($xy64), " of x and y | ",
            stringify!($xy32), " | ", $to64, " | ", $to32, " |"
        )]
        #[doc = concat!(
            "| to the sphere | ", stringify!($inverse), " | ", stringify!($rad64), " rad | ",
            stringify!($rad32), " rad | ", $from64, " | ", $from32, " |"
        )]
        ///
        /// ```
        #[doc = concat!("use terrella::cube::{CubeProjection, ", stringify!($variant), "};")]
        /// use terrella::Direction;
        /// let direction = Direction::new(0.3_f64, 0.9, -0.2)?;
        #[doc = concat!("let point = ", stringify!($variant), ".project(direction);")]
        #[doc = concat!("let back = ", stringify!($variant), ".unproject(point);")]
        /// assert!((back.x() - direction.x()).abs() < 1e-3);
        /// # Ok::<(), terrella::InvalidDirection<f64>>(())
        /// ```
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $variant;

        impl $variant {
            /// Names, origin, distortion, errors and cost of the projection, as data.
            pub const PROFILE: $crate::cube::Profile = $crate::cube::Profile {
                name: $name,
                title: $title,
                also: $also,
                idea: $idea,
                origin: $origin,
                keeps: $keeps,
                area_ratio: $crate::cube::projection::profile::figure!($area),
                aspect_ratio: $aspect,
                oversize: $crate::cube::projection::profile::figure!($oversize),
                deformation: $deformation,
                forward: $crate::cube::Evaluation {
                    formula: $crate::cube::Formula::$forward,
                    worst_error: [$xy64, $xy32],
                    instructions: [$to64, $to32],
                },
                inverse: $crate::cube::Evaluation {
                    formula: $crate::cube::Formula::$inverse,
                    worst_error: [$rad64, $rad32],
                    instructions: [$from64, $from32],
                },
                tiles: $tiles,
            };
        }
    };
}
pub(super) use projection;

/// A figure of a profile, as a number or as text: `infinite` stands for ∞.
macro_rules! figure {
    (text infinite) => {
        "∞"
    };
    (text $figure:literal) => {
        $figure
    };
    (infinite) => {
        f64::INFINITY
    };
    ($figure:literal) => {
        $figure
    };
}
pub(super) use figure;
