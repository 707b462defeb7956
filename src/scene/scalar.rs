use super::{Scene, SceneError};

/// How numbers are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Scalar {
    /// Latitudes, longitudes and heights in `f32`.
    Single,
    /// Their differences from an origin in `f32`: [`Scene::local`].
    Local,
    /// In `f64`.
    Double,
}

impl Scene {
    /// The least of the scalars in which [`distances`](Self::distances) has an answer.
    ///
    /// # Errors
    /// Those of the last, `f64`.
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
