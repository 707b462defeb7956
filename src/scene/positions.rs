use core::marker::PhantomData;

use super::band::{Band, root, ulp};
use super::bounds::{middle_rounded, places_rounded, polar_radius, smallest};
use super::{Bound, Expansion, Scene, SceneError};
use crate::{Enu, Geodetic, LocalFrame, Real};

/// The models of positions about an origin, from the cheapest to the dearest.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum View {
    /// [`Expansion::first_order`].
    Linear,
    /// [`Expansion::second_order`].
    Quadratic,
    /// [`LocalFrame::geodetic_to_enu`].
    Full,
}

impl View {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Linear, Self::Quadratic, Self::Full];
}

/// A scene's model of positions: from [`Scene::positions`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Positions<T> {
    view: View,
    bound: f64,
    scene: Scene,
    scalar: PhantomData<T>,
}

impl Scene {
    /// The cheapest model of positions, as [`Enu`] of an origin in the scene, that keeps the tolerance in a scalar.
    ///
    /// For positions to r from the origin along the ellipsoid, heights over a range Δ and up to H from the ellipsoid, latitudes up to φ, t = tan φ and
    /// q = (r/ρ)(1 + H/b), ρ = a(1 − f)², the errors are at most
    ///
    /// | model | error | where |
    /// |---|---|---|
    /// | linear | 1.1 q (ρ q √(t²/3 + 1/4) + Δ) | r ≤ 0.2 ρ, r tan φ ≤ 0.4 ρ |
    /// | quadratic | 1.25 q² (ρ q (0.25 + 0.26 t²) + Δ √(t²/3 + 1/4)) | the same |
    /// | full | none | |
    ///
    /// and rounding: the terms of the next order of the series, the largest over all azimuths, and room for the rest. Rounding is 2·10⁻¹⁵ (r + Δ) in `f64`; in `f32` 5·10⁻⁷ (r + Δ)
    /// and that of the places, as for [`distances`](Self::distances).
    ///
    /// # Errors
    /// [`SceneError::OutOfReach`] with what the best model reaches in this scalar; the others if the scene is none.
    ///
    /// ```
    /// use terrella::scene::{Positions, Scene, View};
    /// use terrella::{Ellipsoid, Geodetic, LatLon};
    /// const FIELD: Scene = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0).up_to(1000.0).heights(400.0, 550.0).local().within(0.05);
    /// let positions: Positions<f32> = FIELD.positions()?;
    /// assert_eq!(positions.view(), View::Quadratic);
    /// let about = positions.about(Geodetic::new(LatLon::new(47.4, 8.55)?, 430.0)?);
    /// let drone = about.enu(Geodetic::new(LatLon::new(0.001, 0.002)?, 60.0)?);
    /// assert!((drone.north - 111.189).abs() < 0.05);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn positions<T: Real>(&self) -> Result<Positions<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let [linear, quadratic, full] = self.position_bounds(T::DIGITS < f64::MANTISSA_DIGITS);
        if linear <= self.tolerance {
            Ok(Positions::of(View::Linear, linear, *self))
        } else if quadratic <= self.tolerance {
            Ok(Positions::of(View::Quadratic, quadratic, *self))
        } else if full <= self.tolerance {
            Ok(Positions::of(View::Full, full, *self))
        } else {
            Err(SceneError::OutOfReach(Bound {
                distance: linear.min(quadratic).min(full),
                azimuth: f64::INFINITY,
            }))
        }
    }

    /// A model of positions, whatever the tolerance: its [`bound`](Positions::bound) in this scene, infinite where the model is none.
    ///
    /// # Errors
    /// If the scene is none.
    pub const fn positions_by<T: Real>(&self, view: View) -> Result<Positions<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let [linear, quadratic, full] = self.position_bounds(T::DIGITS < f64::MANTISSA_DIGITS);
        let bound = match view {
            View::Linear => linear,
            View::Quadratic => quadratic,
            View::Full => full,
        };
        Ok(Positions::of(view, bound, *self))
    }

    /// Of all three models.
    const fn position_bounds(&self, single: bool) -> [f64; 3] {
        let ([_, far], [low, high]) = (self.distances, self.heights);
        let (range, height) = (high - low, low.abs().max(high.abs()));
        let (band, r) = (Band::new(self.latitudes), smallest(self.ellipsoid));
        let (tan, arc) = (band.tan(), far / r);
        let relative = if single { 5e-7 } else { 2e-15 };
        let rounding = relative * (far + range)
            + match (single, self.local) {
                (false, _) => 0.0,
                (true, true) => middle_rounded(band) * far,
                (true, false) => places_rounded(self.ellipsoid, band, height) + ulp(height),
            };
        let full = if self.local { f64::INFINITY } else { rounding };
        if arc > 0.2 || arc * tan > 0.4 {
            return [f64::INFINITY, f64::INFINITY, full];
        }
        let q = arc * (1.0 + height / polar_radius(self.ellipsoid));
        let bend = root(tan * tan / 3.0 + 0.25);
        [
            1.1 * q * (r * q * bend + range) + rounding,
            1.25 * q * q * (r * q * (0.25 + 0.26 * tan * tan) + range * bend) + rounding,
            full,
        ]
    }
}

impl<T: Real> Positions<T> {
    const fn of(view: View, bound: f64, scene: Scene) -> Self {
        Self {
            view,
            bound,
            scene,
            scalar: PhantomData,
        }
    }

    /// The model.
    #[must_use]
    pub const fn view(&self) -> View {
        self.view
    }

    /// What no error exceeds for positions of the scene: the length of the difference, metres.
    #[must_use]
    pub const fn bound(&self) -> f64 {
        self.bound
    }

    /// The model about an origin in the scene.
    #[must_use]
    #[inline(always)]
    pub fn about(&self, origin: Geodetic<T>) -> AnyView<T> {
        let ellipsoid = self.scene.ellipsoid.rounded();
        let make = if self.scene.local {
            Expansion::local
        } else {
            Expansion::new
        };
        match self.view {
            View::Linear => AnyView::Linear(make(ellipsoid, origin)),
            View::Quadratic => AnyView::Quadratic(make(ellipsoid, origin)),
            View::Full => AnyView::Full(LocalFrame::new(ellipsoid, origin)),
        }
    }
}

/// The model that a scene chose, about an origin: [`Positions::about`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AnyView<T> {
    /// [`View::Linear`].
    Linear(Expansion<T>),
    /// [`View::Quadratic`].
    Quadratic(Expansion<T>),
    /// [`View::Full`].
    Full(LocalFrame<T>),
}

impl<T: Real> AnyView<T> {
    /// East, north and up of the origin; of a [local](Scene::local) scene the position is given as degrees and metres from there.
    #[must_use]
    #[inline(always)]
    pub fn enu(&self, position: Geodetic<T>) -> Enu<T> {
        match self {
            Self::Linear(expansion) => expansion.first_order(position),
            Self::Quadratic(expansion) => expansion.second_order(position),
            Self::Full(frame) => frame.geodetic_to_enu(position),
        }
    }
}
