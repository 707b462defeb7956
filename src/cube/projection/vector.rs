//! What several projections share.

use crate::Real;
use crate::math::{either, max, min, select};

/// Coordinates that rounding has not led off the face.
#[inline(always)]
pub(crate) fn on_face<T: Real>(coordinates: [T; 2]) -> [T; 2] {
    coordinates.map(|v| max(min(v, T::ONE), -T::ONE))
}

/// A coordinate of a component of a vector: to the last bit ±1 where that is the outward one, with the derivatives of
/// the formula. −0 stays, which tells longitude −180 from 180.
#[inline(always)]
pub(super) fn at_edge<T: Real>(x: T, component: T, outward: T) -> T {
    x - either(
        component.abs() == outward,
        x - (T::ONE.copysign(component) + x.vanish()),
    )
}

/// A step of Newton's method for two equations: from the derivatives by x and y of each, and what each lacks.
#[inline(always)]
pub(super) fn newton<T: Real>([[ux, uy], [vx, vy]]: [[T; 2]; 2], [du, dv]: [T; 2]) -> [T; 2] {
    let inverse = T::ONE / (ux * vy - uy * vx);
    [(du * vy - dv * uy) * inverse, (dv * ux - du * vx) * inverse]
}

/// The unit vector of gnomonic coordinates (u, v).
#[inline(always)]
pub(super) fn from_gnomonic<T: Real>([u, v]: [T; 2]) -> [T; 3] {
    let inverse = reciprocal_root(u * u + v * v + T::ONE);
    [u * inverse, v * inverse, inverse]
}

/// The unit vector of a vector in a face's frame, whose squares neither vanish nor overflow.
///
/// On a cube's edge two components agree; the order of the sum keeps the result the same from both faces.
#[inline(always)]
pub(super) fn normalise<T: Real>([x, y, z]: [T; 3]) -> [T; 3] {
    let aside = x * x + y * y;
    let inverse = reciprocal_root(aside + z * z);
    let outward = z * inverse;
    // The middle of a face is on the axis, to the last bit; its derivatives stay.
    let outward = select(aside == T::ZERO, T::ONE + outward.vanish(), outward);
    [x * inverse, y * inverse, outward]
}

/// 1/√n: the root after the division, as it halves what that lost. What both lose changes a vector's length alone.
#[inline(always)]
fn reciprocal_root<T: Real>(n: T) -> T {
    (T::ONE / n).sqrt()
}
