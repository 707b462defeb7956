use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;
use crate::math::{atan, tan};

/// The gnomonic (tangential) cube, TSC: x = u.
///
/// Great circles are straight lines. Area ratio 5.196, aspect ratio 2.
/// Dimitrijević, Lambers & Rančić (2016) §4.1.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Tangential;

impl CubeProjection for Tangential {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [right / outward, up / outward]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        from_gnomonic(point)
    }
}

/// x = atan(u·tan θ)/θ in each coordinate: θ → 0 is the gnomonic cube, θ = π/4 the adjusted one.
///
/// The quotients make the edge exact: both halves send 1 to 1 whatever the rounding of θ.
macro_rules! tangent {
    ($(#[$doc:meta])* $name:ident, $theta:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name;

        impl CubeProjection for $name {
            #[inline(always)]
            fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
                let scale = tan(T::of($theta));
                let unit = atan(scale);
                [
                    atan(right / outward * scale) / unit,
                    atan(up / outward * scale) / unit,
                ]
            }

            #[inline(always)]
            fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
                let theta = T::of($theta);
                let unit = tan(theta);
                from_gnomonic([tan(x * theta) / unit, tan(y * theta) / unit])
            }
        }
    };
}

tangent! {
    /// The adjusted cube, ASC: x = 4/π·atan u. Also known as equi-angular cube map, S2's "tan" and Lerbour's.
    ///
    /// Equal angles along the midlines. Area ratio √2, aspect ratio 2.
    /// Dimitrijević, Lambers & Rančić (2016) §4.2.
    Adjusted, core::f64::consts::FRAC_PI_4
}

tangent! {
    /// The equi-edge cube of FV3: u = √2·tan(x·atan(1/√2)).
    ///
    /// Equal angles along the cube's edges.
    EquiEdge, 0.615_479_708_670_387_3
}

tangent! {
    /// The best map that treats the two coordinates apart: u = tan(θx)/tan θ with θ = acos(2^(−5/12)).
    ///
    /// Aspect ratio and area ratio are both 2^(2/3), and no map u = w(x), v = w(y) has the larger of them smaller.
    Separable, 0.724_013_050_605_694
}
