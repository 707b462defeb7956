//! The family u = tan(θx)/tan θ, in each coordinate.

use crate::Real;
use crate::math::{atan2_eighth, either};

/// x = atan(u·tan θ)/θ in each coordinate: θ → 0 is the gnomonic cube, θ = π/4 the adjusted one.
///
/// The edge is exact, whatever the rounding of θ: x is 1 there, with the derivatives of the formula, and back,
/// the vector's components are equal.
macro_rules! tangent {
    ($name:ident, $theta:expr) => {
        impl $crate::cube::CubeProjection for $name {
            #[inline(always)]
            fn forward<T: $crate::Real>(&self, _: $crate::cube::Face, [right, up, outward]: [T; 3]) -> [T; 2] {
                let scale = $crate::math::tan(T::of($theta));
                let inverse = T::ONE / $crate::math::atan(scale);
                [
                    $crate::cube::projection::tangent::along(right, outward, scale, inverse),
                    $crate::cube::projection::tangent::along(up, outward, scale, inverse),
                ]
            }

            #[inline(always)]
            fn inverse<T: $crate::Real>(&self, _: $crate::cube::Face, [x, y]: [T; 2]) -> [T; 3] {
                let theta = T::of($theta);
                let unit = $crate::math::tan(theta);
                $crate::cube::projection::normalise([$crate::math::tan(x * theta), $crate::math::tan(y * theta), unit])
            }
        }
    };
}
pub(super) use tangent;

/// One coordinate of a face from the same of a vector, tan θ and 1/θ.
#[inline(always)]
pub(super) fn along<T: Real>(v: T, outward: T, scale: T, inverse: T) -> T {
    let x = atan2_eighth(v * scale, outward) * inverse;
    // To the last bit, the edge is the edge; and −0 stays, which tells longitude −180 from 180.
    x - either(v.abs() == outward, x - (T::ONE.copysign(v) + x.vanish()))
}
