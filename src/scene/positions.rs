use core::marker::PhantomData;

use super::band::{Band, root, ulp};
use super::bounds::{middle_rounded, places_rounded, polar_radius, smallest};
use super::{Bound, Expansion, Scene, SceneError};
use crate::{Enu, Geodetic, LocalFrame, Real};

/// The ways to express a position as east, north and up of an origin, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum View {
    /// A series of the first order: [`Expansion::first_order`].
    Linear,
    /// A series of the second order: [`Expansion::second_order`].
    Quadratic,
    /// The exact conversion: [`LocalFrame::geodetic_to_enu`].
    Full,
}

impl View {
    /// All views, the cheapest first.
    pub const ALL: [Self; 3] = [Self::Linear, Self::Quadratic, Self::Full];
}

/// The view for the positions of a scene, with its bound: from [`Scene::positions`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Positions<T> {
    view: View,
    bound: f64,
    scene: Scene,
    scalar: PhantomData<T>,
}

impl Scene {
    /// Chooses the cheapest view whose positions, as [`Enu`] of an origin in the scene, keep the scene's
    /// tolerance in the scalar `T`.
    ///
    /// For positions to r from the origin along the ellipsoid, heights over a range Δ and up to H from the
    /// ellipsoid, latitudes up to φ, t = tan φ and q = (r/ρ)(1 + H/b), ρ = a(1 − f)², the errors are at most
    ///
    /// | view | error | where |
    /// |---|---|---|
    /// | linear | 1.1 q (ρ q √(t²/3 + 1/4) + Δ) | r ≤ 0.2 ρ, r tan φ ≤ 0.4 ρ |
    /// | quadratic | 1.25 q² (ρ q (0.25 + 0.26 t²) + Δ √(t²/3 + 1/4)) | the same |
    /// | full | 0 | |
    ///
    /// and rounding: 2·10⁻¹⁵ (r + Δ) in `f64`; in `f32`, 5·10⁻⁷ (r + Δ) and the rounding of the places, as in
    /// [`METHODS`](Self::METHODS). The formulas are the terms of the next order of the series, the largest
    /// over all azimuths, with room for the rest.
    ///
    /// # Errors
    /// [`SceneError::OutOfReach`] with the smallest bound, if no view keeps the tolerance. Any other
    /// [`SceneError`] if the scene itself is refused.
    ///
    /// ```
    /// use terrella::scene::{Positions, Scene, View};
    /// use terrella::{Ellipsoid, Geodetic, LatLon};
    /// const FIELD: Scene = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0)
    ///     .up_to(1000.0)
    ///     .heights(400.0, 550.0)
    ///     .local()
    ///     .within(0.05);
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

    /// Takes a view, whatever the tolerance. Its [`bound`](Positions::bound) in this scene is infinite where
    /// the view does not hold.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene itself is refused.
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

    /// Returns the view.
    #[must_use]
    pub const fn view(&self) -> View {
        self.view
    }

    /// Returns the bound in metres: no position of the scene is farther than this from its true one.
    #[must_use]
    pub const fn bound(&self) -> f64 {
        self.bound
    }

    /// Creates the view about an origin in the scene. In a constant scene, only this view is linked.
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

/// The view that a scene chose, about an origin: from [`Positions::about`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AnyView<T> {
    /// Of [`View::Linear`].
    Linear(Expansion<T>),
    /// Of [`View::Quadratic`].
    Quadratic(Expansion<T>),
    /// Of [`View::Full`].
    Full(LocalFrame<T>),
}

impl<T: Real> AnyView<T> {
    /// Returns the position as metres east, north and up of the origin.
    ///
    /// In a [local](Scene::local) scene, pass the position as degrees north and east, and metres up, of the
    /// origin.
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
