use core::marker::PhantomData;

use super::bounds::Models;
use super::{Bound, Scene, SceneError};
use crate::Real;
use crate::geodesic::Method;

/// The method for the distances and azimuths of a scene, with its bound: from [`Scene::distances`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Distances<T> {
    pub(super) method: Method,
    pub(super) scene: Scene,
    scalar: PhantomData<T>,
}

impl Scene {
    /// Chooses the cheapest method whose distances and azimuths keep the scene's tolerances in the scalar
    /// `T`.
    ///
    /// [`Scene::METHODS`] lists the methods and their errors. A place reached by
    /// [`Geodesic::direct`](crate::geodesic::Geodesic::direct) is off by at most the bound of the distance,
    /// plus the distance times the bound of the azimuth.
    ///
    /// # Errors
    /// [`SceneError::OutOfReach`] with the smallest bound that a method reaches in this scalar, if none keeps
    /// the tolerances. Any other [`SceneError`] if the scene itself is refused.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::geodesic::Method;
    /// use terrella::scene::{Distances, Scene, SceneError};
    /// let leg = Scene::new(Ellipsoid::WGS84).up_to(9_000_000.0);
    /// let method = |tolerance| leg.within(tolerance).distances().map(|way: Distances<f64>| way.method());
    /// assert_eq!(method(50_000.0), Ok(Method::GreatCircle));
    /// assert_eq!(method(20.0), Ok(Method::Andoyer));
    /// assert_eq!(method(1e-3), Ok(Method::Karney));
    /// assert!(matches!(method(1e-10), Err(SceneError::OutOfReach(reached)) if reached.distance < 2e-8));
    /// ```
    pub const fn distances<T: Real>(&self) -> Result<Distances<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let models = Models::of(self, T::DIGITS < f64::MANTISSA_DIGITS);
        let free = self.azimuth == f64::INFINITY;
        let (mut best, mut least) = (Method::Plane, f64::INFINITY);
        let mut rest = Self::METHODS;
        while let [method, dearer @ ..] = rest {
            let distance = models.distance(*method);
            if distance <= self.tolerance && (free || models.azimuth(*method) <= self.azimuth) {
                return Ok(Distances::of(*method, *self));
            }
            if distance < least {
                (best, least) = (*method, distance);
            }
            rest = dearer;
        }
        Err(SceneError::OutOfReach(models.bound(best)))
    }

    /// Takes a method of [`Scene::METHODS`], whatever the tolerances. Its [`bound`](Distances::bound) in this
    /// scene is infinite where the method does not hold.
    ///
    /// # Errors
    /// [`SceneError::NoBound`] if the method is not one of [`Scene::METHODS`]. Any other [`SceneError`] if
    /// the scene itself is refused.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::geodesic::Method;
    /// use terrella::scene::{Distances, Scene};
    /// let tropics = Scene::new(Ellipsoid::WGS84).latitudes(-23.4, 23.4).up_to(1e6);
    /// let sphere: Distances<f64> = tropics.distances_by(Method::GreatCircle)?;
    /// assert!((sphere.bound().distance - 3740.0).abs() < 1.0);
    /// # Ok::<(), terrella::scene::SceneError>(())
    /// ```
    pub const fn distances_by<T: Real>(&self, method: Method) -> Result<Distances<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        if !Models::known(method) {
            return Err(SceneError::NoBound(method));
        }
        Ok(Distances::of(method, *self))
    }
}

impl<T: Real> Distances<T> {
    const fn of(method: Method, scene: Scene) -> Self {
        Self {
            method,
            scene,
            scalar: PhantomData,
        }
    }

    pub(super) const fn models(&self) -> Models {
        Models::of(&self.scene, T::DIGITS < f64::MANTISSA_DIGITS)
    }

    /// Returns the name of the method; [`solver`](Self::solver) returns the method itself.
    #[must_use]
    pub const fn method(&self) -> Method {
        self.method
    }

    /// Returns the errors that the method never exceeds between places of the scene.
    #[must_use]
    pub const fn bound(&self) -> Bound {
        self.models().bound(self.method)
    }
}
