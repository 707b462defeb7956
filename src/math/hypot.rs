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
    let (x, y) = (x * grow, y * grow);
    (x * x + y * y).sqrt() * shrink
}

/// A number of at most 1 in size times 2⁵¹⁰ (2⁶²), so that its square underflows only where it does not
/// matter.
#[inline(always)]
pub(crate) fn grown<T: Real>(x: T) -> T {
    x * T::pick(3.351_951_982_485_649_3e153, 4.611_686e18)
}

/// The square of a number [`grown`], from the square of the number itself.
#[inline(always)]
pub(crate) fn grown_square<T: Real>(square: T) -> T {
    square * T::pick(1.123_558_209_288_947_4e307, 2.126_764_8e37)
}

/// The root of the square of a number [`grown`].
#[inline(always)]
pub(crate) fn shrunk_root<T: Real>(square: T) -> T {
    square.sqrt() * T::pick(2.983_336_292_480_083e-154, 2.168_404_3e-19)
}

/// The square of a number, from that of the number [`grown`].
#[inline(always)]
pub(crate) fn shrunk_square<T: Real>(square: T) -> T {
    square * T::pick(8.900_295_434_028_806e-308, 4.701_977_4e-38)
}
