use super::{max, select};
use crate::Real;

/// √(x² + y²), of numbers whose squares underflow too; not of numbers whose squares overflow.
#[cfg_attr(not(small), inline(always))]
#[cfg_attr(small, inline(never))]
pub(crate) fn hypot<T: Real>(x: T, y: T) -> T {
    let small = max(x.abs(), y.abs()) < T::pick(3.054_936_363_499_605e-151, 8.673_617_4e-19);
    // 2^±600 and 2^±100.
    let grow = select(small, T::pick(4.149_515_568_880_993e180, 1.267_650_6e30), T::ONE);
    let shrink = select(small, T::pick(2.409_919_865_102_884e-181, 7.888_609e-31), T::ONE);
    scaled(x, y, grow, shrink)
}

/// The same of numbers of at most 1 in size, with half of the arithmetic.
#[inline(always)]
pub(crate) fn hypot_of_sines<T: Real>(x: T, y: T) -> T {
    // 2^±510 and 2^±62.
    let grow = T::pick(3.351_951_982_485_649_3e153, 4.611_686e18);
    let shrink = T::pick(2.983_336_292_480_083e-154, 2.168_404_3e-19);
    scaled(x, y, grow, shrink)
}

/// By squares of the numbers times `grow`; `shrink` is its reciprocal.
#[inline(always)]
fn scaled<T: Real>(x: T, y: T, grow: T, shrink: T) -> T {
    let (x, y) = (x * grow, y * grow);
    (x * x + y * y).sqrt() * shrink
}
