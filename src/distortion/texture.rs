//! What a renderer's texture filter asks: from the footprint of a pixel to a level of the map's pyramid.
//!
//! Dimitrijević, Lambers & Rančić (2016), §3; OpenGL 4.6 §8.14 and its anisotropic filter (`ARB_texture_filter_anisotropic`).

use crate::Real;
use crate::math::{log2, max, min, select};

/// λ: the level of the pyramid for a pixel whose step to the right moves the texture coordinates by `across`, and whose step
/// upward by `along`, in texels (paper 3.1).
///
/// λ = log₂ of the longer; 0 where a texel is a pixel, 1 where it is half of one. −∞ for a footprint of no extent.
///
/// ```
/// let level = terrella::distortion::texture::level([4.0_f32, 0.0], [0.0, 1.0]);
/// assert_eq!(level, 2.0);
/// ```
#[must_use]
#[inline]
pub fn level<T: Real>(across: [T; 2], along: [T; 2]) -> T {
    log2(max(length(across), length(along)))
}

/// What an anisotropic filter does with a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Anisotropic<T> {
    /// N: how many samples it takes, a whole number.
    pub samples: T,
    /// λ: from which level.
    pub level: T,
}

/// N and λ of an anisotropic filter that takes at most `most` samples (paper 3.2, 3.3).
///
/// N = min(⌈P_max/P_min⌉, most), λ = log₂(P_max/N), with P_max and P_min the longer and the shorter of the footprint's two sides. A footprint of no
/// extent has N = `most` and λ = −∞.
///
/// ```
/// use terrella::distortion::texture::anisotropic;
/// let filter = anisotropic([8.0_f64, 0.0], [0.0, 2.0], 16.0);
/// assert_eq!((filter.samples, filter.level), (4.0, 1.0));
/// assert_eq!(anisotropic([8.0_f64, 0.0], [0.0, 2.0], 2.0).level, 2.0);
/// ```
#[must_use]
#[inline]
pub fn anisotropic<T: Real>(across: [T; 2], along: [T; 2], most: T) -> Anisotropic<T> {
    let (p, q) = (length(across), length(along));
    let longer = max(p, q);
    let ratio = min(longer / min(p, q), most);
    let whole = ratio.round_ties_even();
    let samples = whole + select(whole < ratio, T::ONE, T::ZERO);
    Anisotropic {
        samples,
        level: log2(longer / samples),
    }
}

/// λ′: the level that a texel's true size asks for, when λ was found as if every texel had the size of the central one (paper 3.8).
///
/// λ′ = λ − ½ log₂ δ_area, with δ_area the texel's Λx·Λy over the central one's: where texels are smaller than there, a pixel covers more
/// of them.
///
/// ```
/// let level = terrella::distortion::texture::corrected(3.0_f64, 0.25);
/// assert_eq!(level, 4.0);
/// ```
#[must_use]
#[inline]
pub fn corrected<T: Real>(level: T, area: T) -> T {
    level - T::of(0.5) * log2(area)
}

#[inline(always)]
fn length<T: Real>([u, v]: [T; 2]) -> T {
    (u * u + v * v).sqrt()
}
