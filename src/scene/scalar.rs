use super::{Scene, SceneError};

/// The type of the numbers in which a scene keeps its places.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Scalar {
    /// Latitudes, longitudes and heights as `f32`.
    Single,
    /// Differences from an origin as `f32`: [`Scene::local`].
    Local,
    /// Latitudes, longitudes and heights as `f64`.
    Double,
}

impl Scene {
    /// Chooses the first scalar in which [`distances`](Self::distances) keeps the tolerances: `f32`, `f32`
    /// about an origin, or `f64`.
    ///
    /// # Errors
    /// The [`SceneError`] of [`distances`](Self::distances) in `f64`, if none does.
    ///
    /// ```
    /// use terrella::Ellipsoid;
    /// use terrella::scene::{Scalar, Scene};
    /// let field = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0);
    /// assert_eq!(field.within(5.0).scalar(), Ok(Scalar::Single)); // degrees in f32 are up to 0.9 m off
    /// assert_eq!(field.within(0.05).scalar(), Ok(Scalar::Local));
    /// assert_eq!(field.within(1e-5).scalar(), Ok(Scalar::Double));
    /// ```
    pub const fn scalar(&self) -> Result<Scalar, SceneError> {
        let absolute = Self { local: false, ..*self };
        if absolute.distances::<f32>().is_ok() {
            return Ok(Scalar::Single);
        }
        if absolute.local().distances::<f32>().is_ok() {
            return Ok(Scalar::Local);
        }
        match absolute.distances::<f64>() {
            Ok(_) => Ok(Scalar::Double),
            Err(error) => Err(error),
        }
    }
}
