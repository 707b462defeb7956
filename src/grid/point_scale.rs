use crate::math::{atan2_degrees, hypot, sin_cos_degrees};
use crate::{Dual, Ellipsoid, Real};

/// How a conformal map lies and how it stretches at a place.
///
/// Both come from the derivative of the projection along the meridian, by [`Dual`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PointScale<T> {
    /// The meridian convergence: the bearing of grid north in degrees clockwise from true north, in
    /// [−180, 180].
    pub convergence: T,
    /// The scale factor: a short line on the map, divided by its length on the ellipsoid.
    pub scale: T,
}

impl<T: Real> PointScale<T> {
    /// At a latitude in degrees, from x and y with their derivatives by it.
    pub(super) fn of(ellipsoid: Ellipsoid<T>, lat: T, [x, y]: [Dual<T, 1>; 2]) -> Self {
        let ([east], [north]) = (x.slopes(), y.slopes());
        let (sin, _) = sin_cos_degrees(lat);
        let e2 = ellipsoid.e2();
        let w2 = T::ONE - e2 * (sin * sin);
        // A degree of the meridian is πM/180, M = a(1 − e²)/W³.
        let degree = ellipsoid.a() * T::of(core::f64::consts::PI / 180.0) * (T::ONE - e2) / (w2 * w2.sqrt());
        Self {
            convergence: atan2_degrees(T::ZERO - east, north),
            scale: hypot(east, north) / degree,
        }
    }
}
