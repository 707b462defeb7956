//! The family u = tan(θx)/tan θ, in each coordinate.

/// x = atan(u·tan θ)/θ in each coordinate: θ → 0 is the gnomonic cube, θ = π/4 the adjusted one.
///
/// The edge is exact, whatever the rounding of θ: the quotient of two equal arc tangents is 1, and back, the
/// vector's components are equal there.
macro_rules! tangent {
    ($name:ident, $theta:expr) => {
        impl $crate::cube::CubeProjection for $name {
            #[inline(always)]
            fn forward<T: $crate::Real>(&self, _: $crate::cube::Face, [right, up, outward]: [T; 3]) -> [T; 2] {
                let scale = $crate::math::tan(T::of($theta));
                let unit = $crate::math::atan(scale);
                [
                    $crate::math::atan_moderate(right / outward * scale) / unit,
                    $crate::math::atan_moderate(up / outward * scale) / unit,
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
