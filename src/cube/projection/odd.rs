//! Maps of each coordinate by an odd function, both ways as polynomials.

/// x = f(u) and u = g(x) in each coordinate, where f(1) = g(1) = 1: exact on the edges whatever the
/// polynomials, which are those of [`odd_unit`](crate::math::odd_unit).
macro_rules! odd {
    ($name:ident, $forward:ident, $inverse:ident) => {
        impl $crate::cube::CubeProjection for $name {
            #[inline(always)]
            fn forward<T: $crate::Real>(&self, _: $crate::cube::Face, [right, up, outward]: [T; 3]) -> [T; 2] {
                let along = |v: T| $crate::math::odd_unit(v / outward, &$crate::math::$forward);
                [along(right), along(up)]
            }

            #[inline(always)]
            fn inverse<T: $crate::Real>(&self, _: $crate::cube::Face, [x, y]: [T; 2]) -> [T; 3] {
                let along = |v: T| $crate::math::odd_unit(v, &$crate::math::$inverse);
                $crate::cube::projection::from_gnomonic([along(x), along(y)])
            }
        }
    };
}
pub(super) use odd;
