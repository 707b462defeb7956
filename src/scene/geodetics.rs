use core::marker::PhantomData;

use super::band::{e2, ulp};
use super::bounds::polar_radius;
use super::{Bound, Scene, SceneError};
use crate::{Ecef, Ellipsoid, Geodetic, GeodeticSeries, Real};

/// The ways to convert Earth-centred points to latitude, longitude and height, the cheapest first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Order {
    /// [`GeodeticSeries::second_order`].
    Second,
    /// [`GeodeticSeries::third_order`].
    Third,
    /// [`GeodeticSeries::fourth_order`].
    Fourth,
    /// The exact conversion: [`Ellipsoid::to_geodetic`].
    Full,
}

impl Order {
    /// All orders, the cheapest first.
    pub const ALL: [Self; 4] = [Self::Second, Self::Third, Self::Fourth, Self::Full];
}

/// The conversion of Earth-centred points of a scene, with its bound: from [`Scene::geodetics`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Geodetics<T> {
    order: Order,
    bound: f64,
    scene: Scene,
    scalar: PhantomData<T>,
}

impl Scene {
    /// Chooses the cheapest conversion of Earth-centred points at the scene's heights to latitude, longitude
    /// and height that keeps the scene's tolerance in the scalar `T`.
    ///
    /// With the lowest height h, the highest H and m = max(e², e²a/(b + h)), at most 1/75, the displacements
    /// are at most
    ///
    /// | order | error | where |
    /// |---|---|---|
    /// | second | 0.25 a e² m² | e² < 1/75 |
    /// | third | 0.2 a e² m³ | the same |
    /// | fourth | 0.145 a e² m⁵ | the same |
    /// | full | 0 | |
    ///
    /// and rounding: 10⁻¹⁵ (a + H) of the series and 4·10⁻¹⁶ (a + H) of the exact conversion in `f64`; in
    /// `f32`, 2.2·10⁻⁷ (a + H), and half a unit in the last place of each coordinate of the point.
    ///
    /// A [local](Self::local) scene has no Earth-centred points: nothing is accurate enough there.
    ///
    /// # Errors
    /// [`SceneError::OutOfReach`] with the smallest bound, if no order keeps the tolerance. Any other
    /// [`SceneError`] if the scene itself is refused.
    ///
    /// ```
    /// use terrella::scene::{Geodetics, Order, Scene};
    /// use terrella::{Ecef, Ellipsoid};
    /// const AIR: Scene = Scene::new(Ellipsoid::WGS84).heights(-500.0, 100_000.0).within(1.0);
    /// const FIXES: Geodetics<f64> = match AIR.geodetics() {
    ///     Ok(fixes) => fixes,
    ///     Err(_) => panic!("no conversion is accurate enough"), // would not compile
    /// };
    /// assert_eq!(FIXES.order(), Order::Second);
    /// assert!((FIXES.bound() - 0.48).abs() < 0.01);
    /// let greenwich = FIXES.solver().to_geodetic(Ecef::new(3_980_609.2, -102.5, 4_966_860.0)?);
    /// assert!((greenwich.height() - 45.0).abs() < 1.0);
    /// let order = |metres| AIR.within(metres).geodetics::<f64>().map(|fixes| fixes.order());
    /// assert_eq!([order(0.01)?, order(1e-6)?, order(1e-8)?], [Order::Third, Order::Fourth, Order::Full]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub const fn geodetics<T: Real>(&self) -> Result<Geodetics<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let bounds = self.geodetic_bounds(T::DIGITS < f64::MANTISSA_DIGITS);
        let (mut orders, mut rest) = (&Order::ALL as &[Order], &bounds as &[f64]);
        let mut least = f64::INFINITY;
        while let ([order, orders_left @ ..], [bound, bounds_left @ ..]) = (orders, rest) {
            if *bound <= self.tolerance {
                return Ok(Geodetics::of(*order, *bound, *self));
            }
            least = least.min(*bound);
            (orders, rest) = (orders_left, bounds_left);
        }
        Err(SceneError::OutOfReach(Bound {
            distance: least,
            azimuth: f64::INFINITY,
        }))
    }

    /// Takes an order, whatever the tolerance. Its [`bound`](Geodetics::bound) in this scene is infinite where
    /// the order does not hold.
    ///
    /// # Errors
    /// A [`SceneError`] if the scene itself is refused.
    pub const fn geodetics_by<T: Real>(&self, order: Order) -> Result<Geodetics<T>, SceneError> {
        if let Some(error) = self.fault() {
            return Err(error);
        }
        let [second, third, fourth, full] = self.geodetic_bounds(T::DIGITS < f64::MANTISSA_DIGITS);
        let bound = match order {
            Order::Second => second,
            Order::Third => third,
            Order::Fourth => fourth,
            Order::Full => full,
        };
        Ok(Geodetics::of(order, bound, *self))
    }

    /// Of all orders.
    const fn geodetic_bounds(&self, single: bool) -> [f64; 4] {
        if self.local {
            return [f64::INFINITY; 4];
        }
        let (ellipsoid, [low, high]) = (self.ellipsoid, self.heights);
        let (a, e2) = (ellipsoid.a(), e2(ellipsoid));
        let far = a + high.abs();
        let (rounding, full) = if single {
            // Half of the diagonal of a cube.
            let rounding = 2.2e-7 * far + 0.8661 * ulp(far);
            (rounding, rounding)
        } else {
            (1e-15 * far, 4e-16 * far)
        };
        let most = 1.0 / 75.0;
        if e2 >= most {
            return [f64::INFINITY, f64::INFINITY, f64::INFINITY, full];
        }
        // Nearer to the centre the exact conversion is taken.
        let m = (e2 * a / (polar_radius(ellipsoid) + low)).min(most).max(e2);
        let square = a * e2 * m * m;
        [
            0.25 * square + rounding,
            0.2 * square * m + rounding,
            0.145 * square * m * m * m + rounding,
            full,
        ]
    }
}

impl<T: Real> Geodetics<T> {
    const fn of(order: Order, bound: f64, scene: Scene) -> Self {
        Self {
            order,
            bound,
            scene,
            scalar: PhantomData,
        }
    }

    /// Returns the order.
    #[must_use]
    pub const fn order(&self) -> Order {
        self.order
    }

    /// Returns the bound in metres: no point of the scene is converted to a place farther than this from it.
    #[must_use]
    pub const fn bound(&self) -> f64 {
        self.bound
    }

    /// Returns the conversion, ready to use. In a constant scene, only this one is linked.
    #[must_use]
    #[inline(always)]
    pub fn solver(&self) -> AnyOrder<T> {
        let ellipsoid = self.scene.ellipsoid.rounded();
        let series = GeodeticSeries::new(ellipsoid);
        match self.order {
            Order::Second => AnyOrder::Second(series),
            Order::Third => AnyOrder::Third(series),
            Order::Fourth => AnyOrder::Fourth(series),
            Order::Full => AnyOrder::Full(ellipsoid),
        }
    }
}

/// The conversion that a scene chose, ready to use: from [`Geodetics::solver`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum AnyOrder<T> {
    /// Of [`Order::Second`].
    Second(GeodeticSeries<T>),
    /// Of [`Order::Third`].
    Third(GeodeticSeries<T>),
    /// Of [`Order::Fourth`].
    Fourth(GeodeticSeries<T>),
    /// Of [`Order::Full`].
    Full(Ellipsoid<T>),
}

impl<T: Real> AnyOrder<T> {
    /// Returns the latitude, longitude and height of an Earth-centred point.
    #[must_use]
    #[inline(always)]
    pub fn to_geodetic(&self, point: Ecef<T>) -> Geodetic<T> {
        match self {
            Self::Second(series) => series.second_order(point),
            Self::Third(series) => series.third_order(point),
            Self::Fourth(series) => series.fourth_order(point),
            Self::Full(ellipsoid) => ellipsoid.to_geodetic(point),
        }
    }
}
