//! Elementary functions for every [`Real`]: `f32`, `f64` and [`Dual`](crate::Dual).
//!
//! They are written from `+ − × ÷ √` alone, so every machine computes the same bits, without `std` too. They
//! have no branch that depends on the data, so a loop over them vectorises. The square root, the absolute
//! value and the sign are methods of [`Real`].
//!
//! | function | domain | worst error, f64 | f32 | worst of all f32 |
//! |---|---|---|---|---|
//! | [`sin_cos`] | \|x\| ≤ 10⁵ (f64), 100 (f32) rad | 0.8 ulp | 0.81 ulp | 0.803, cosine of 0.79641944 |
//! | [`sin_cos_degrees`] | \|x\| ≤ 10⁹ (f64), 10⁶ (f32) ° | 0.8 ulp | 0.8 ulp | 0.795, sine of 44.61437 |
//! | [`tan`] | \|x\| ≤ π/4 | 1.2 ulp | 1.2 ulp | 1.119, of 0.7853317 |
//! | [`atan`], [`atan2`] | finite | 0.85 ulp | 0.85 ulp | 0.794, of 1.4487356 |
//! | [`atan2_degrees`] | finite | 0.85 ulp | 0.85 ulp | |
//! | [`cbrt`] | normal | 1 ulp | 1 ulp | 0.955, of 4.9008295·10⁻³⁸ |
//! | [`exp_m1`] | all | 0.75 ulp | 0.75 ulp | 0.707, of −16.982107 |
//! | [`log2`] | all | 0.85 ulp | 0.85 ulp | 0.828, of 1.41193 |
//!
//! The table's last column is measured: `cargo test --release --test every_f32 -- --ignored --nocapture`
//! compares every `f32` in the domain.

mod asin;
mod atan;
mod cbrt;
mod complex;
pub(crate) mod conformal;
mod double_word;
mod exp_m1;
mod extremes;
pub(crate) mod geodesic;
mod gudermannian;
mod hypot;
mod interleave;
pub(crate) mod kruger;
pub(crate) mod latitude;
mod log2;
mod minimax;
mod polynomial;
pub(crate) mod rhumb;
mod sin_cos;
mod tan;

pub(crate) use asin::doubled_arc;
pub use atan::{atan, atan2, atan2_degrees};
pub(crate) use atan::{atan2_eighth, octant, octant_degrees, octant_radians, turned_degrees};
pub use cbrt::cbrt;
pub(crate) use complex::Complex;
pub(crate) use double_word::{DoubleWord, hypotenuse, product, product_of_any, sum};
pub use exp_m1::exp_m1;
pub use extremes::{max, min};
pub(crate) use gudermannian::{gudermannian, inverse_gudermannian};
pub(crate) use hypot::{grown, grown_square, hypot, shrunk_root, shrunk_square};
pub(crate) use interleave::{gathered, spread};
pub use log2::log2;
pub(crate) use minimax::{
    ADJUSTED_U, ADJUSTED_X, CREASELESS_BOW, CREASELESS_CUBIC, CREASELESS_W, EQUI_EDGE_U, EQUI_EDGE_X, LAMBERS_U,
    LAMBERS_X, POWER_IM, POWER_RE, QUAD_COS, QUAD_M, QUAD_SIN, ROOT_IM, ROOT_RE, SEPARABLE_U, SEPARABLE_X, TANH_U,
    TANH_X, UNICUBE_U, UNICUBE_X, VERTEX_T, VERTEX_TAU, ZUCKER_HIGASHI_U, ZUCKER_HIGASHI_X,
};
pub(crate) use polynomial::{halves, odd_unit};
pub use sin_cos::{sin_cos, sin_cos_degrees};
pub(crate) use sin_cos::{sin_cos_degrees_with_rest, sin_cos_eighth, sin_cos_quarter, sin_cos_small};
pub use tan::tan;

use crate::Real;
pub use crate::real::Polynomial;
pub(crate) use crate::real::repeat;

/// One of two values by a condition: a select, not a branch, once compiled.
#[inline(always)]
pub(crate) fn select<V>(condition: bool, then: V, otherwise: V) -> V {
    if condition { then } else { otherwise }
}

/// A number, or 0: a mask on any machine, never a branch.
#[inline(always)]
pub(crate) fn either<T: Real>(condition: bool, then: T) -> T {
    select(condition, then, T::ZERO)
}

/// One of two finite numbers by a condition, without a branch on any machine; −0 becomes 0.
#[inline(always)]
pub(crate) fn choose<T: Real>(condition: bool, then: T, otherwise: T) -> T {
    if cfg!(small) {
        return select(condition, then, otherwise) + T::ZERO;
    }
    either(condition, then) + either(!condition, otherwise)
}

/// A number, or its negative by a condition, without a branch on any machine.
#[inline(always)]
pub(crate) fn negated<T: Real>(condition: bool, x: T) -> T {
    if cfg!(small) {
        return select(condition, -x, x);
    }
    (T::ONE - either(condition, T::of(2.0))) * x
}

/// A number, or by a condition what it lacks of another, without a branch on any machine; −0 becomes 0.
#[inline(always)]
pub(crate) fn mirrored<T: Real>(condition: bool, whole: T, x: T) -> T {
    if cfg!(small) {
        return select(condition, whole - x, x) + T::ZERO;
    }
    either(condition, whole) + negated(condition, x)
}

/// −1 if a > b, otherwise 1, where b is not −0: from the sign of the difference, and so without a branch on
/// any machine. Where two angles are computed side by side, the compiler branches on a comparison.
#[inline(always)]
pub(crate) fn descent<T: Real>(a: T, b: T) -> T {
    if cfg!(small) {
        return select(a > b, -T::ONE, T::ONE);
    }
    T::ONE.copysign(b - a)
}
