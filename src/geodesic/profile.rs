//! What is known of a method, written once in its own file: [`Profile`], and the macro `profile!`.

/// What is known of a method: names, model, errors and cost.
///
/// Every figure is measured, and a test checks it.
///
/// ```
/// use terrella::geodesic::{Method, Surface};
/// let profile = Method::Bowring.profile();
/// assert_eq!(profile.title, "Bowring");
/// assert_eq!(profile.surface, Surface::Local);
/// // The distance, at 100 km: 1.1 mm.
/// let [distance, ..] = profile.worst_errors(45.0, 1e5).unwrap().double;
/// assert_eq!(distance.at(1e5), 1.1e-3);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Profile {
    /// The name in lower case, which [`Method`](super::Method) is parsed from.
    pub name: &'static str,
    /// The name as a heading.
    pub title: &'static str,
    /// The surface that the method measures on.
    pub surface: Surface,
    /// The least and the greatest flattening that the method takes. Methods of the sphere take any.
    pub flattenings: [f64; 2],
    /// The model of the Earth that the method computes on, in words.
    pub model: &'static str,
    /// The worst error of the distance on the Earth, in words.
    pub good_to: &'static str,
    /// Instructions of one inverse problem: distance and azimuths in `f64`, on x86-64 with SSE2, to two
    /// digits.
    pub instructions: u32,
    /// The worst errors by latitude and distance, in ascending order; empty if they depend on more than that.
    ///
    /// They are those on WGS 84. Those of a method of the sphere are on a sphere of 6400 km, against the
    /// exact great circle.
    pub errors: &'static [WorstErrors],
}

impl Profile {
    /// Returns the worst errors of lines that start at a latitude in degrees and are this many metres long,
    /// or `None` where nothing is claimed.
    #[must_use]
    pub fn worst_errors(&self, lat: f64, distance: f64) -> Option<WorstErrors> {
        let [lat, distance] = [lat.abs(), distance.abs()];
        let mut rows = self.errors.iter().copied();
        rows.find(|row| (row.latitudes[0]..=row.latitudes[1]).contains(&lat) && distance <= row.distance)
    }
}

/// The surface that a method measures on.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Surface {
    /// A plane or a sphere that fits the ellipsoid near the first place only.
    Local,
    /// The sphere.
    Sphere,
    /// The ellipsoid.
    Ellipsoid,
}

/// The worst errors of a method on some lines. There are three, in metres: of the distance, of the azimuths
/// times the reduced length, and of the position in the direct problem.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct WorstErrors {
    /// The latitudes of the first place, north or south, in degrees: from, to.
    pub latitudes: [f64; 2],
    /// The longest distance, in metres.
    pub distance: f64,
    /// In `f64`.
    pub double: [Linear; 3],
    /// The error that `f32` adds.
    pub single: [Linear; 3],
}

/// An error that grows with the distance: `constant` + `relative` × distance.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Linear {
    /// In metres.
    pub constant: f64,
    /// As part of the distance.
    pub relative: f64,
}

impl Linear {
    /// Returns the error in metres at a distance in metres.
    #[must_use]
    pub const fn at(self, distance: f64) -> f64 {
        self.constant + self.relative * distance
    }
}

/// Declares the [`Profile`] of a method as `PROFILE`, and its errors as a table for its documentation:
/// `table!()`.
///
/// An error is `[1e-3]` in metres, `[2e-9 s]` as part of the distance s, or `[2e-9 s + 1e-3]`.
macro_rules! profile {
    (
        name: $name:literal,
        title: $title:literal,
        surface: $surface:ident,
        flattenings: $flattenings:expr,
        model: $model:literal,
        good_to: $good_to:literal,
        instructions: $instructions:literal,
        errors: {
            $(
                latitudes $low:literal to $high:literal, f32 adds $s1:tt $s2:tt $s3:tt {
                    $($km:tt km: $d1:tt $d2:tt $d3:tt;)*
                }
            )*
        }
    ) => {
        pub(super) const PROFILE: $crate::geodesic::Profile = $crate::geodesic::Profile {
            name: $name,
            title: $title,
            surface: $crate::geodesic::Surface::$surface,
            flattenings: $flattenings,
            model: $model,
            good_to: $good_to,
            instructions: $instructions,
            errors: &[$($(
                $crate::geodesic::WorstErrors {
                    latitudes: [$low as f64, $high as f64],
                    distance: $crate::geodesic::profile::figure!(metres $km),
                    double: [
                        $crate::geodesic::profile::figure!($d1),
                        $crate::geodesic::profile::figure!($d2),
                        $crate::geodesic::profile::figure!($d3),
                    ],
                    single: [
                        $crate::geodesic::profile::figure!($s1),
                        $crate::geodesic::profile::figure!($s2),
                        $crate::geodesic::profile::figure!($s3),
                    ],
                },
            )*)*],
        };

        #[allow(unused_macros)] // not every page shows it
        macro_rules! table {
            () => {
                concat!(
                    "| from latitudes | distance s, up to | distance | azimuths × reduced length | position |\n",
                    "|---|---|---|---|---|\n",
                    $(
                        $(
                            "| ", $low, " to ", $high, "° | ", $crate::geodesic::profile::figure!(length $km), " | ",
                            $crate::geodesic::profile::figure!(text $d1), " | ",
                            $crate::geodesic::profile::figure!(text $d2), " | ",
                            $crate::geodesic::profile::figure!(text $d3), " |\n",
                        )*
                        "| | `f32` adds | ", $crate::geodesic::profile::figure!(text $s1), " | ",
                        $crate::geodesic::profile::figure!(text $s2), " | ",
                        $crate::geodesic::profile::figure!(text $s3), " |\n",
                    )*
                )
            };
        }
    };
}
pub(super) use profile;

/// A figure of a profile, as a number or as text.
macro_rules! figure {
    (text [$($figure:tt)*]) => {
        stringify!($($figure)*)
    };
    (length all) => {
        "any"
    };
    (length $km:literal) => {
        concat!($km, " km")
    };
    (metres all) => {
        f64::INFINITY
    };
    (metres $km:literal) => {
        1e3 * $km as f64
    };
    ([$constant:literal]) => {
        $crate::geodesic::Linear { constant: $constant, relative: 0.0 }
    };
    ([$relative:literal s]) => {
        $crate::geodesic::Linear { constant: 0.0, relative: $relative }
    };
    ([$relative:literal s + $constant:literal]) => {
        $crate::geodesic::Linear { constant: $constant, relative: $relative }
    };
}
pub(super) use figure;
