use core::marker::PhantomData;

use super::band::{Band, DEGREE, Parallel, e2, hypot};
use super::bounds::{middle_rounded, places_rounded, polar_radius, smallest};
use super::{Bound, Scene, SceneError};
use crate::geodesic::{Area, Karney, PlanarArea};
use crate::{LatLon, Real};

/// The surfaces on which a scene measures areas, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Surface {
    /// A plane about the origin: [`PlanarArea`].
    Plane,
    /// The ellipsoid: [`Area`].
    Ellipsoid,
}

impl Surface {
    /// All surfaces, the cheapest first.
    pub const ALL: [Self; 2] = [Self::Plane, Self::Ellipsoid];
}

/// The surface for the areas of a scene, with its bound: from [`Scene::areas`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Areas<T> {
    surface: Surface,
    bound: f64,
    scene: Scene,
    scalar: PhantomData<T>,
}

impl Scene {
    /// Chooses the cheapest surface whose areas of polygons keep the scene's tolerance in the scalar `T`.
    ///
    /// The tolerance is in metres. An area keeps it if its error in m² is at most the tolerance times the
    /// perimeter, as if the boundary were drawn that far off. The farthest distance of the scene is that
    /// between any two corners; the nearest is the length of the shortest edge, which only the ellipsoid
    /// needs.
    ///
    /// For distances from n to s, σ = s/r, r = a(1 − f)² and latitudes up to φ, the errors are at most the
    /// perimeter times
    ///
    /// | surface | metres | where |
    /// |---|---|---|
    /// | plane | s (0.038 e²σ² + 0.032 σ⁴) | σ ≤ 0.2 |
    /// | ellipsoid | 10⁻¹⁵ a/cos(φ + σ/2) + 0.02 f m²/n, at most 0.1 m²/n | s ≤ 0.9 πb; beyond, 10⁴ m²/n |
    ///
    /// and rounding:
    ///
    /// * On the plane, 3·10⁻¹⁶ s in `f64` and 1.2·10⁻⁷ s in `f32`.
    /// * On the ellipsoid in `f32`, the constants of the table are 6·10⁻⁷, 10⁷ m² and 6·10⁷ m², and there is
    ///   no bound beyond 0.9 πb.
    /// * In `f32`, the corners' own rounding: half a unit of latitude and longitude, 0.95 m at the equator;
    ///   about an origin, 2⁻²⁴ of the distance from it.
    ///
    /// Areas are the Earth's, and in proportion elsewhere.
    ///
    /// # Errors
    /// [`SceneError::OutOfReach`] with the smaller bound, if neither surface keeps the tolerance. Any other
    /// [`SceneError`] if the scene itself is refused.
    ///
    /// ```
    /// use terrella::scene::{Areas, Scene, Surface};
    /// use terrella::{Ellipsoid, LatLon};
    /// // A kilometre about a farm, its boundaries to a millimetre, in f32 as degrees from its middle.
    /// const FARM: Scene = Scene::around(Ellipsoid::WGS84, 52.0, 1000.0).local().within(0.001);
    /// const AREAS: Areas<f32> = match FARM.areas() {
    ///     Ok(areas) => areas,
    ///     Err(_) => panic!("no model is good enough"), // would not compile
    /// };
    /// assert_eq!(AREAS.surface(), Surface::Plane);
    /// let corners = [(0.0, 0.0), (0.0, 0.001), (0.001, 0.001), (0.001, 0.0)];
    /// let corners = corners.map(|(north, east)| LatLon::new(north, east).unwrap());
    /// assert!((AREAS.solver().area(corners) - 7641.537).abs() < 0.005);
    /// // Countries, their boundaries to 10 micrometres, no edge shorter than 10 km.
    /// let countries = Scene::new(Ellipsoid::WGS84).latitudes(-60.0, 75.0).between(1e4, 1e7).within(1e-5);
    /// assert_eq!(countries.areas::<f64>()?.surface(), Surface::Ellipsoid);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn areas<T: Real>(&self) -> Result<Areas<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let [plane, ellipsoid] = self.area_bounds(T::DIGITS < f64::MANTISSA_DIGITS);
        if plane <= self.tolerance {
            Ok(Areas::of(Surface::Plane, plane, *self))
        } else if ellipsoid <= self.tolerance {
            Ok(Areas::of(Surface::Ellipsoid, ellipsoid, *self))
        } else {
            Err(SceneError::OutOfReach(Bound {
                distance: plane.min(ellipsoid),
                azimuth: f64::INFINITY,
            }))
        }
    }

    /// Takes a surface, whatever the tolerance. Its [`bound`](Areas::bound) in this scene is infinite where
    /// the surface does not hold.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene itself is refused.
    pub const fn areas_by<T: Real>(&self, surface: Surface) -> Result<Areas<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let [plane, ellipsoid] = self.area_bounds(T::DIGITS < f64::MANTISSA_DIGITS);
        let bound = match surface {
            Surface::Plane => plane,
            Surface::Ellipsoid => ellipsoid,
        };
        Ok(Areas::of(surface, bound, *self))
    }

    /// Of both surfaces: metres, to be multiplied with the perimeter.
    const fn area_bounds(&self, single: bool) -> [f64; 2] {
        let (ellipsoid, band, [near, far]) = (self.ellipsoid, Band::new(self.latitudes), self.distances);
        let a = ellipsoid.a();
        // An area is at most 0.29 of perimeter and diameter; a corner is moved by half of what two places
        // are.
        let input = match (single, self.local) {
            (false, _) => 0.0,
            (true, true) => {
                let reach = hypot(a / (1.0 - ellipsoid.f()) * band.half, far);
                0.5 * reach * f32::EPSILON as f64 + 0.29 * middle_rounded(band) * far
            }
            (true, false) => 0.5 * places_rounded(ellipsoid, band, 0.0),
        };
        let arc = far / smallest(ellipsoid);
        let square = arc * arc;
        let plane = if arc <= 0.2 {
            let rounding = if single { 1.2e-7 } else { 3e-16 };
            far * (0.038 * e2(ellipsoid) * square + 0.032 * square * square + rounding) + input
        } else {
            f64::INFINITY
        };
        // Of an edge in m²: of any, of a short one, and for each metre of the area under it, most where it is
        // nearest to a pole.
        let [any, short, under] = if single { [6e7, 1e7, 6e-7] } else { [0.1, 0.02, 1e-15] };
        let (scale, half_circle) = (a / 6_378_137.0, core::f64::consts::PI * polar_radius(ellipsoid));
        let nearest = Parallel::new((band.steepest.degrees + 0.5 * arc / DEGREE).min(90.0));
        let per_metre = scale * scale / near.abs();
        let short = if ellipsoid.f() > 0.0 {
            short * ellipsoid.f() * per_metre
        } else {
            0.0
        };
        let edge = if self.local || (single && far > 0.9 * half_circle) {
            f64::INFINITY
        } else if far > 0.9 * half_circle {
            1e4 * per_metre
        } else {
            (any * per_metre).min(short + under * a / nearest.cos)
        };
        [plane, edge + input]
    }
}

impl<T: Real> Areas<T> {
    const fn of(surface: Surface, bound: f64, scene: Scene) -> Self {
        Self {
            surface,
            bound,
            scene,
            scalar: PhantomData,
        }
    }

    /// Returns the surface.
    #[must_use]
    pub const fn surface(&self) -> Surface {
        self.surface
    }

    /// Returns the bound in metres: the error of an area in m² never exceeds the bound times the perimeter.
    #[must_use]
    pub const fn bound(&self) -> f64 {
        self.bound
    }

    /// Returns what measures areas on the surface, ready to use.
    ///
    /// In a constant scene, only this one is linked.
    #[must_use]
    #[inline(always)]
    pub fn solver(&self) -> AnyArea<T> {
        let ellipsoid = self.scene.ellipsoid.rounded();
        match self.surface {
            Surface::Plane => {
                let [south, north] = self.scene.latitudes;
                let origin = if self.scene.local {
                    T::of(0.5 * (south + north))
                } else {
                    T::ZERO
                };
                AnyArea::Plane(PlanarArea::within(ellipsoid, origin))
            }
            Surface::Ellipsoid => AnyArea::Ellipsoid(Area::within(Karney::within(ellipsoid))),
        }
    }
}

/// The surface that a scene chose, ready to use: from [`Areas::solver`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[allow(clippy::large_enum_variant)] // nothing here allocates
#[non_exhaustive]
pub enum AnyArea<T> {
    /// Of [`Surface::Plane`].
    Plane(PlanarArea<T>),
    /// Of [`Surface::Ellipsoid`].
    Ellipsoid(Area<T>),
}

impl<T: Real> AnyArea<T> {
    /// Returns the area of a polygon in m², positive if its corners run counter-clockwise.
    ///
    /// In a [local](Scene::local) scene, pass the corners as degrees north and east of the origin.
    #[must_use]
    #[inline(always)]
    pub fn area(&self, corners: impl IntoIterator<Item = LatLon<T>>) -> T {
        match self {
            Self::Plane(area) => {
                let mut polygon = area.polygon();
                corners.into_iter().for_each(|corner| polygon.add(corner));
                polygon.area()
            }
            Self::Ellipsoid(area) => {
                let mut polygon = area.polygon();
                corners.into_iter().for_each(|corner| polygon.add(corner));
                polygon.area()
            }
        }
    }
}
