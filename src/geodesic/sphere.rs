//! Bessel's auxiliary sphere. Every geodesic of the ellipsoid is a great circle on this sphere, between the
//! parametric latitudes and with the same azimuths; distance and longitude on the ellipsoid follow from the
//! arc by two integrals ([`series`](super::series)).
//!
//! Symbols as in C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013), section 2: φ latitude, β
//! parametric latitude, α azimuth, α₀ that at the node (the equator), σ arc from the node, ω longitude on the
//! sphere, λ longitude on the ellipsoid; 1 and 2 are the ends. σₘ is the middle of the arc (Vincenty 1975).

use super::angle::Angle;
use crate::Real;
use crate::math::{hypot, sin_cos_degrees, sin_cos_quarter};

/// β of a latitude φ in degrees, tan β = (1 − f) tan φ, and √(cos²φ + (1 − f)² sin²φ).
#[inline(always)]
pub fn parametric<T: Real>(lat: T, axes: T) -> (Angle<T>, T) {
    let (sin, cos) = sin_cos_degrees(lat);
    let sin = sin * axes;
    let divisor = (sin * sin + cos * cos).sqrt();
    let beta = Angle {
        sin: sin / divisor,
        cos: cos / divisor,
    };
    (beta, divisor)
}

/// β and 1/√(cos²φ + (1 − f)² sin²φ), as [`parametric`] but by one division: cheaper, and a rounding less
/// exact.
#[cfg_attr(not(small), inline(always))]
pub fn parametric_by_reciprocal<T: Real>(lat: T, axes: T) -> (Angle<T>, T) {
    let (sin, cos) = sin_cos_quarter(lat.abs());
    let sin = (sin * axes).copysign(lat);
    let inverse = T::ONE / (sin * sin + cos * cos).sqrt();
    let beta = Angle {
        sin: sin * inverse,
        cos: cos * inverse,
    };
    (beta, inverse)
}

/// α₀ of the great circle through β with the azimuth α (Karney 5 and 10).
#[inline(always)]
pub fn node<T: Real>(alpha: Angle<T>, beta: Angle<T>) -> Angle<T> {
    Angle {
        sin: alpha.sin * beta.cos,
        cos: hypot(alpha.cos, alpha.sin * beta.sin),
    }
}

/// σ of the point at β of the great circle with the azimuth α there (Karney 11).
#[inline(always)]
pub fn arc_from_node<T: Real>(alpha: Angle<T>, beta: Angle<T>) -> Angle<T> {
    Angle::of(beta.sin, alpha.cos * beta.cos)
}

/// The spherical triangle of the north pole and two points.
///
/// Seen from point 1, `side` is 1. Between places more than 90° apart no digit is lost if they are seen from
/// the antipode of point 1: `side` is −1, and π − ω₁₂ stands for ω₁₂.
#[derive(Clone, Copy)]
pub struct Triangle<T> {
    /// sin σ₁₂ times sine and cosine of α₁.
    pub course1: Angle<T>,
    /// sin σ₁₂ times sine and cosine of α₂.
    pub course2: Angle<T>,
    /// sin β₁ sin β₂, and cos β₁ cos β₂ cos ω₁₂: the terms of cos σ₁₂.
    pub sines: T,
    pub cosines: T,
}

impl<T: Real> Triangle<T> {
    /// The triangle for one ω₁₂, whose versine is 1 − cos ω₁₂. `rise` is sin(β₂ − β₁), from the antipode
    /// sin(β₂ + β₁): in its terms nothing cancels between neighbours (Karney 49 to 51, written with the
    /// versine).
    #[inline(always)]
    pub fn new(side: T, [beta1, beta2]: [Angle<T>; 2], rise: T, omega: Angle<T>, versine: T) -> Self {
        Self {
            course1: Angle {
                sin: beta2.cos * omega.sin,
                cos: rise + side * (beta1.sin * beta2.cos * versine),
            },
            course2: Angle {
                sin: beta1.cos * omega.sin,
                cos: side * (rise - beta2.sin * beta1.cos * versine),
            },
            sines: beta1.sin * beta2.sin,
            cosines: side * (beta1.cos * beta2.cos * omega.cos),
        }
    }

    /// cos σ₁₂.
    #[inline(always)]
    pub fn cos_sigma(&self) -> T {
        self.sines + self.cosines
    }
}

/// A great circle from a point along an azimuth.
#[derive(Clone, Copy)]
pub struct Start<T> {
    pub beta1: Angle<T>,
    pub alpha1: Angle<T>,
    /// cos β₁ cos α₁ = cos α₀ cos σ₁; and sin β₁ = cos α₀ sin σ₁ (Karney 11).
    pub along: T,
    pub sin_alpha0: T,
    pub cos2_alpha0: T,
}

impl<T: Real> Start<T> {
    #[inline(always)]
    pub fn new(beta1: Angle<T>, alpha1: Angle<T>) -> Self {
        let across = alpha1.sin * beta1.sin;
        Self {
            beta1,
            alpha1,
            along: beta1.cos * alpha1.cos,
            sin_alpha0: beta1.cos * alpha1.sin,
            cos2_alpha0: alpha1.cos * alpha1.cos + across * across,
        }
    }
}
