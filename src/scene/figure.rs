use super::band::{Band, e2, root};
use super::{Scene, SceneError};
use crate::latitude::{Shift, Shifted};
use crate::{Ellipsoid, Real};

/// The shape by which the ground may be replaced: from [`Scene::figure`] or [`Scene::figures`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Figure {
    /// A sphere with the geodetic latitude as its latitude: no shift.
    #[non_exhaustive]
    Sphere {
        /// The radius in metres.
        radius: f64,
        /// The bound in metres: no place is farther from its true position.
        bound: f64,
    },
    /// A sphere with the geocentric latitude as its latitude: places stand in their true directions.
    #[non_exhaustive]
    Shifted {
        /// The radius in metres.
        radius: f64,
        /// The ellipsoid whose latitudes are shifted.
        ellipsoid: Ellipsoid<f64>,
        /// The bound in metres: no place is farther from its true position.
        bound: f64,
    },
    /// The ellipsoid.
    #[non_exhaustive]
    Ellipsoid {
        /// The ellipsoid of the scene.
        ellipsoid: Ellipsoid<f64>,
    },
}

impl Scene {
    /// Chooses the simplest ground on which no place is farther from its true position than the scene's
    /// tolerance.
    ///
    /// With h = √(a² cos²φ + b² sin²φ), a sphere without shift is off by (h₀ − h₁)/2 up and by (a² − b²)|sin
    /// φ cos φ|/h across, at any height, since normals are kept. With the geocentric shift, a place at the
    /// radius ρ is off by (ρ₀ − ρ₁)/2 along it, and heights by the lean of their normals, at most e²/(2 − e²)
    /// of them.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene itself is refused. A tolerance of 0 gives [`Figure::Ellipsoid`].
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::scene::{Figure, Scene};
    /// let earth = Scene::new(Ellipsoid::WGS84).heights(-11_000.0, 9_000.0);
    /// // From a million kilometres, in pixels of a milliradian, half a minute of arc, a tenth of that.
    /// let figure = |radians| earth.within_pixels(0.5, radians, 1e9).figure();
    /// assert!(matches!(figure(1e-3)?, Figure::Sphere { .. }));
    /// assert!(matches!(figure(2.5e-5)?, Figure::Shifted { .. }));
    /// assert!(matches!(figure(2.5e-6)?, Figure::Ellipsoid { .. }));
    /// # Ok::<(), terrella::scene::SceneError>(())
    /// ```
    pub const fn figure(&self) -> Result<Figure, SceneError> {
        match self.figures() {
            Ok([sphere, _]) if sphere.bound() <= self.tolerance => Ok(sphere),
            Ok([_, shifted]) if shifted.bound() <= self.tolerance => Ok(shifted),
            Ok(_) => Ok(Figure::Ellipsoid {
                ellipsoid: self.ellipsoid,
            }),
            Err(error) => Err(error),
        }
    }

    /// Returns both spheres, without and with the geocentric shift, whatever the tolerance.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene itself is refused.
    pub const fn figures(&self) -> Result<[Figure; 2], SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let (ellipsoid, Band { steepest, flattest, .. }) = (self.ellipsoid, Band::new(self.latitudes));
        let [low, high] = self.heights;
        let (a, squeeze) = (ellipsoid.a(), e2(ellipsoid));
        let [h0, h1] = [flattest.support(ellipsoid), steepest.support(ellipsoid)];
        let product = if flattest.degrees <= 45.0 && steepest.degrees >= 45.0 {
            0.5
        } else {
            (flattest.sin * flattest.cos).max(steepest.sin * steepest.cos)
        };
        let (up, across) = (0.5 * (h0 - h1), a * a * squeeze * product / h1);
        let [r0, r1] = [flattest.radius(ellipsoid), steepest.radius(ellipsoid)];
        let lean = low.abs().max(high.abs()) * squeeze / (2.0 - squeeze);
        // Sines and cosines are up to 6e-8 too small, roots up to 1e-11 off.
        let slack = a * (4e-7 * squeeze + 2e-11);
        Ok([
            Figure::Sphere {
                radius: 0.5 * (h0 + h1),
                bound: root(up * up + across * across) + slack,
            },
            Figure::Shifted {
                radius: 0.5 * (r0 + r1),
                ellipsoid: self.ellipsoid,
                bound: 0.5 * (r0 - r1) + lean + slack,
            },
        ])
    }
}

impl Figure {
    /// Returns the bound in metres: no place is farther from its true position. It is 0 for the ellipsoid,
    /// apart from rounding.
    #[must_use]
    pub const fn bound(&self) -> f64 {
        match self {
            Self::Sphere { bound, .. } | Self::Shifted { bound, .. } => *bound,
            Self::Ellipsoid { .. } => 0.0,
        }
    }

    /// Returns the ground as an ellipsoid; a sphere is one with f = 0.
    #[must_use]
    pub fn ground<T: Real>(&self) -> Ellipsoid<T> {
        match self {
            Self::Sphere { radius, .. } | Self::Shifted { radius, .. } => Ellipsoid::within(T::of(*radius), T::ZERO),
            Self::Ellipsoid { ellipsoid } => ellipsoid.rounded(),
        }
    }

    /// Returns the step from latitude and longitude to the sphere: no shift, the geocentric shift, or, for
    /// the ellipsoid, `shift`.
    #[must_use]
    pub fn shifted<T: Real>(&self, shift: Shift) -> Shifted<T> {
        match self {
            Self::Sphere { .. } => Shifted::within(self.ground(), Shift::Geodetic),
            Self::Shifted { ellipsoid, .. } => Shifted::within(ellipsoid.rounded(), Shift::Geocentric),
            Self::Ellipsoid { ellipsoid } => Shifted::within(ellipsoid.rounded(), shift),
        }
    }
}
