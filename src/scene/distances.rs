use core::marker::PhantomData;

use super::bounds::Models;
use super::{AnyModel, Bound, Model, Scene, SceneError};
use crate::Real;
use crate::geodesic::{Andoyer, Flat, GreatCircle, Karney, Plane};

/// A scene's model of distances and azimuths: from [`Scene::distances`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Distances<T> {
    model: Model,
    scene: Scene,
    scalar: PhantomData<T>,
}

impl Scene {
    /// The cheapest model of distances and azimuths that keeps the tolerances in a scalar.
    ///
    /// For distances to s, σ = s/b, x = max(0, 2σ/π − 1), r = a(1 − f)², latitudes within δ radians of their middle, φ the farthest from the equator and φ₀ the nearest, the
    /// errors of the models are at most
    ///
    /// | model | of a distance | of an azimuth | where |
    /// |---|---|---|---|
    /// | [`Flat`] | 1.25 s³/(24r²) (0.26 + 1.13 tan²φ) | 1.25 s²/r² (0.033 + 0.027 tan²φ) | s ≤ 0.5 r, s tan φ ≤ 0.5 r |
    /// | [`Plane`] | s ε more, ε = 1.1 δ³/6 (tan φ + 6e² + δ/4) | ε + s/r δ³/12 more | as [`Flat`], δ ≤ 0.3 |
    /// | [`GreatCircle`] of radius (M + N)/2 | s (N − M)/(2M), M that of φ₀, N that of φ + s/2r | 1.2 f cos²φ₀ (1 + 1.45 x²/(π − σ)) | |
    /// | [`Andoyer`] | 1.2 a f² (σ/8 + 1.08x/(π − σ)), 2af if less | 1.2 f² (0.33 + 2.9 (σ/π)²/(π − σ)²) | |
    /// | [`Karney`] | 7·10⁻⁹ m on the Earth | rounding | |
    ///
    /// and rounding. Of a distance that is 2·10⁻¹⁵ s in `f64`, and for [`Andoyer`] 3 nm more; in `f32` 7·10⁻⁷
    /// s, for [`Karney`] 10⁻⁶ s, at most 1.5·10⁻⁷ s + 4 m, 33 m half way round where f > 1/150, and the
    /// places' own: half a unit of each latitude and longitude, 1.9 m at the equator; about an origin 2⁻²³ of
    /// the way to it. Lengths are the Earth's, and in proportion elsewhere. An azimuth is off by 2·10⁻¹⁵ or
    /// 10⁻⁶, and by the places' rounding, or 15 nm, over the reduced length.
    ///
    /// The sphere's is a theorem: no curve is longer on the ellipsoid than N/R, or shorter than M/R, times as long as on the sphere. A place
    /// reached by [`Geodesic::direct`](crate::geodesic::Geodesic::direct) is within the bound of the distance, and s times that of the azimuth,
    /// of the true one.
    ///
    /// # Errors
    /// [`SceneError::OutOfReach`] with the bound of the best model in this scalar; the others if the scene is none.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::scene::{Distances, Model, Scene, SceneError};
    /// let leg = Scene::new(Ellipsoid::WGS84).up_to(9_000_000.0);
    /// let model = |tolerance| leg.within(tolerance).distances().map(|way: Distances<f64>| way.model());
    /// assert_eq!(model(50_000.0), Ok(Model::Sphere));
    /// assert_eq!(model(20.0), Ok(Model::Andoyer));
    /// assert_eq!(model(1e-3), Ok(Model::Karney));
    /// assert!(matches!(model(1e-10), Err(SceneError::OutOfReach(reached)) if reached.distance < 2e-8));
    /// ```
    pub const fn distances<T: Real>(&self) -> Result<Distances<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let models = Models::of(self, T::DIGITS < f64::MANTISSA_DIGITS);
        let free = self.azimuth == f64::INFINITY;
        let (mut best, mut least) = (Model::Plane, f64::INFINITY);
        let mut rest: &[Model] = &Model::ALL;
        while let [model, dearer @ ..] = rest {
            let distance = models.distance(*model);
            if distance <= self.tolerance && (free || models.azimuth(*model) <= self.azimuth) {
                return Ok(Distances::of(*model, *self));
            }
            if distance < least {
                (best, least) = (*model, distance);
            }
            rest = dearer;
        }
        Err(SceneError::OutOfReach(models.bound(best)))
    }

    /// A model of distances and azimuths, whatever the tolerances: its [`bound`](Distances::bound) in this scene, infinite where the model is none.
    ///
    /// # Errors
    /// If the scene is none.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::scene::{Distances, Model, Scene};
    /// let tropics = Scene::new(Ellipsoid::WGS84).latitudes(-23.4, 23.4).up_to(1e6);
    /// let sphere: Distances<f64> = tropics.distances_by(Model::Sphere)?;
    /// assert!((sphere.bound().distance - 3740.0).abs() < 1.0);
    /// # Ok::<(), terrella::scene::SceneError>(())
    /// ```
    pub const fn distances_by<T: Real>(&self, model: Model) -> Result<Distances<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        Ok(Distances::of(model, *self))
    }
}

impl<T: Real> Distances<T> {
    const fn of(model: Model, scene: Scene) -> Self {
        Self {
            model,
            scene,
            scalar: PhantomData,
        }
    }

    const fn models(&self) -> Models {
        Models::of(&self.scene, T::DIGITS < f64::MANTISSA_DIGITS)
    }

    /// The model.
    #[must_use]
    pub const fn model(&self) -> Model {
        self.model
    }

    /// What no error exceeds between places of the scene.
    #[must_use]
    pub const fn bound(&self) -> Bound {
        self.models().bound(self.model)
    }

    /// The model, ready.
    #[must_use]
    #[inline(always)]
    pub fn method(&self) -> AnyModel<T> {
        let ellipsoid = self.scene.ellipsoid.rounded();
        match self.model {
            Model::Plane => {
                let [south, north] = self.scene.latitudes;
                let lat = T::of(0.5 * (south + north));
                let middle = if self.scene.local { T::ZERO } else { lat };
                AnyModel::Plane(Plane::within(ellipsoid, lat, middle))
            }
            Model::Flat => AnyModel::Flat(Flat::within(ellipsoid)),
            Model::Sphere => {
                let [radius, _] = self.models().sphere();
                AnyModel::Sphere(GreatCircle::within(T::of(radius)))
            }
            Model::Andoyer => AnyModel::Andoyer(Andoyer::within(ellipsoid)),
            Model::Karney => AnyModel::Karney(Karney::within(ellipsoid)),
        }
    }
}
