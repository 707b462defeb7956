//! Mipmap levels for a renderer's texture filter, from the footprint of a pixel in texels.
//!
//! Dimitrijević, Lambers & Rančić (2016), §3; OpenGL 4.6 §8.14 and its anisotropic filter
//! (`ARB_texture_filter_anisotropic`). "The paper" below is the former.

use crate::Real;
use crate::math::{log2, max, min, select};

/// Returns λ, the mipmap level for a pixel (paper 3.1).
///
/// `across` and `along` are the changes of the texture coordinates, in texels, for a step of one pixel to the
/// right and for a step of one pixel up. λ is log₂ of the longer of the two vectors: 0 if a texel is as large
/// as a pixel, 1 if it is half as large. It is −∞ if both vectors are zero.
///
/// ```
/// let level = terrella::distortion::texture::level([4.0_f32, 0.0], [0.0, 1.0]);
/// assert_eq!(level, 2.0);
/// ```
#[doc(alias = "mipmap level")]
#[doc(alias = "LOD")]
#[must_use]
#[inline]
pub fn level<T: Real>(across: [T; 2], along: [T; 2]) -> T {
    log2(max(length(across), length(along)))
}

/// The samples and the level that an anisotropic filter uses for a pixel: from [`anisotropic`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Anisotropic<T> {
    /// N: the number of samples, a whole number.
    pub samples: T,
    /// λ: the mipmap level that the samples are read from.
    pub level: T,
}

/// Returns N and λ of an anisotropic filter that takes at most `most` samples (paper 3.2, 3.3).
///
/// N = min(⌈P_max/P_min⌉, most) and λ = log₂(P_max/N), where P_max and P_min are the lengths of the longer
/// and the shorter side of the pixel's footprint, `across` and `along` (see [`level`]). If both are zero, N =
/// `most` and λ = −∞.
///
/// ```
/// use terrella::distortion::texture::anisotropic;
/// let filter = anisotropic([8.0_f64, 0.0], [0.0, 2.0], 16.0);
/// assert_eq!((filter.samples, filter.level), (4.0, 1.0));
/// assert_eq!(anisotropic([8.0_f64, 0.0], [0.0, 2.0], 2.0).level, 2.0);
/// ```
#[doc(alias = "anisotropic filtering")]
#[doc(alias = "EXT_texture_filter_anisotropic")]
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

/// Returns λ′, the mipmap level corrected for a texel's true size (paper 3.8). `level` is λ computed as if
/// every texel had the size of the central one.
///
/// λ′ = λ − ½ log₂ δ_area, where `area` is δ_area, the texel's Λx·Λy divided by that of the central one.
/// Where texels are smaller than the central one, a pixel covers more of them.
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
