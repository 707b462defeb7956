//! The family u = tan(θx)/tan θ, in each coordinate.

/// x = atan(u·tan θ)/θ in each coordinate: θ → 0 is the gnomonic cube, θ = π/4 the adjusted one.
///
/// The quotients make the edge exact: both halves send 1 to 1 whatever the rounding of θ.
macro_rules! tangent {
    ($name:ident, $theta:expr) => {
        impl $crate::cube::CubeProjection for $name {
            #[inline(always)]
            fn forward<T: $crate::Real>(&self, _: $crate::cube::Face, [right, up, outward]: [T; 3]) -> [T; 2] {
                let scale = $crate::math::tan(T::of($theta));
                let unit = $crate::math::atan(scale);
                [
                    $crate::math::atan(right / outward * scale) / unit,
                    $crate::math::atan(up / outward * scale) / unit,
                ]
            }

            #[inline(always)]
            fn inverse<T: $crate::Real>(&self, _: $crate::cube::Face, [x, y]: [T; 2]) -> [T; 3] {
                let theta = T::of($theta);
                let unit = $crate::math::tan(theta);
                $crate::cube::projection::from_gnomonic([
                    $crate::math::tan(x * theta) / unit,
                    $crate::math::tan(y * theta) / unit,
                ])
            }
        }
    };
}
pub(super) use tangent;
