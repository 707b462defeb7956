use super::angle::{latitude_difference, longitude_step};
use super::great_circle::Delambre;
use super::half_angle::HalfAngle;
use super::half_arc::HalfArc;
use super::profile::profile;
use super::{Direct, Geodesic, GeodesicError, GreatCircle, Inverse};
use crate::math::{grown_square, max, sin_cos_quarter};
use crate::{Ellipsoid, InvalidEllipsoid, LatLon, Real};

profile! {
    name: "haversine",
    title: "Haversine",
    surface: Sphere,
    flattenings: [f64::NEG_INFINITY, f64::INFINITY],
    model: "sphere",
    good_to: "rounding on the sphere, half of the digits near the antipode; as the Earth 0.56 %",
    instructions: 780,
    errors: {
        latitudes 0 to 90, f32 adds [4.2e-7 s] [2.24] [6e-8 s + 3.84] {
            10000 km: [8e-16 s] [3.84e-9] [1e-16 s + 7.04e-9];
        }
        latitudes 0 to 90, f32 adds [23.0] [2.24] [6e-8 s + 3.84] {
            18980 km: [4.3e-8] [3.84e-9] [1e-16 s + 7.04e-9];
        }
        latitudes 0 to 90, f32 adds [6400.0] [2.24] [6e-8 s + 3.84] {
            all km: [0.28] [3.84e-9] [1e-16 s + 7.04e-9];
        }
    }
}

/// The great circle by the haversine formula, as most programs compute it. Use it to reproduce their figures.
///
/// sin²(σ/2) = sin²(Δφ/2) + cos φ₁ cos φ₂ sin²(Δλ/2), clamped to 1 (Sinnott, 1984). The formula is good
/// between neighbours. Near the antipode 1 − sin²(σ/2) is lost to rounding, and with it half of the digits.
/// [`GreatCircle`] costs no more and is exact there, too.
///
/// Worst error on a sphere of 6400 km, in metres. It is proportional to the radius; 18 980 km end 10° short of
/// the antipode:
///
#[doc = table!()]
///
/// Azimuths and the direct problem are those of [`GreatCircle`]. The inverse problem never fails, and is
/// never NaN.
///
/// ```
/// use terrella::LatLon;
/// use terrella::geodesic::{Geodesic, Haversine, Inverse};
/// let sphere = Haversine::new(6_371_000.0)?;
/// let way: Inverse<f64> = sphere.inverse(LatLon::new(59.91, 10.75)?, LatLon::new(52.52, 13.40)?)?;
/// assert_eq!(format!("{:.1}", way.distance), "837735.1");
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[doc(alias = "hav", alias = "hversine")]
pub struct Haversine<T> {
    sphere: GreatCircle<T>,
}

impl<T: Real> Haversine<T> {
    /// Makes the method for a sphere of this radius in metres.
    ///
    /// # Errors
    /// [`InvalidEllipsoid::SemiMajorAxis`] unless 10⁻¹⁵ ≤ radius ≤ 10¹⁵.
    pub fn new(radius: T) -> Result<Self, InvalidEllipsoid<T>> {
        GreatCircle::new(radius).map(|sphere| Self { sphere })
    }

    /// For the sphere of an ellipsoid's mean radius.
    pub(super) fn mean(ellipsoid: Ellipsoid<T>) -> Self {
        Self {
            sphere: GreatCircle::mean(ellipsoid),
        }
    }
}

impl<T: Real> Geodesic<T> for Haversine<T> {
    /// Never fails.
    // Inlined for size: who takes the distance alone does not pay for the azimuths.
    #[cfg_attr(small, inline(always))]
    #[cfg_attr(not(small), inline)]
    fn inverse(&self, from: LatLon<T>, to: LatLon<T>) -> Result<Inverse<T>, GeodesicError<T>> {
        Ok(self.fast_inverse(from, to).0)
    }

    /// # Errors
    /// [`GeodesicError::Azimuth`] or [`GeodesicError::Distance`] for a value that is infinite or NaN.
    #[inline]
    fn direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> Result<Direct<T>, GeodesicError<T>> {
        self.sphere.direct(from, azimuth, distance)
    }

    #[inline(always)]
    fn fast_inverse(&self, from: LatLon<T>, to: LatLon<T>) -> (Inverse<T>, bool) {
        let angle = side(from, to).angle();
        let (azimuth1, azimuth2) = Delambre::between(from, to).azimuths();
        let distance = angle * self.sphere.radius();
        (
            Inverse {
                distance,
                azimuth1,
                azimuth2,
            },
            true,
        )
    }

    #[inline(always)]
    fn fast_distance(&self, from: LatLon<T>, to: LatLon<T>) -> (T, bool) {
        (side(from, to).0, true)
    }

    #[inline(always)]
    fn finish_distance(&self, side: T) -> T {
        self.sphere.finish_distance(side)
    }

    #[inline(always)]
    fn fast_direct(&self, from: LatLon<T>, azimuth: T, distance: T) -> (Direct<T>, bool) {
        self.sphere.fast_direct(from, azimuth, distance)
    }
}

/// The side by its haversine alone.
#[inline(always)]
fn side<T: Real>(from: LatLon<T>, to: LatLon<T>) -> HalfArc<T> {
    let (_, cos1) = sin_cos_quarter(from.lat().abs());
    let (_, cos2) = sin_cos_quarter(to.lat().abs());
    let (lat, _) = HalfAngle::of_difference(latitude_difference(from, to)).grown_squares();
    let (lon, _) = HalfAngle::of_difference(longitude_step(from, to)).grown_squares();
    let haversine = lat + cos1 * cos2 * lon;
    HalfArc::new(haversine, max(grown_square(T::ONE) - haversine, T::ZERO))
}
