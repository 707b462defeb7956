//! What rounding loses, kept as a second number (Dekker, Numer. Math. 18, 1971; Knuth).

use super::select;
use crate::Real;

/// a + b as a rounded sum and what the rounding lost.
#[inline(always)]
pub(crate) fn sum<T: Real>(a: T, b: T) -> (T, T) {
    let sum = a + b;
    let part = sum - a;
    let lost = (a - (sum - part)) + (b - part);
    (sum, lost)
}

/// a·b as a rounded product and what the rounding lost, for numbers far from the largest.
#[inline(always)]
pub(crate) fn product<T: Real>(a: T, b: T) -> (T, T) {
    let product = a * b;
    let ((ah, al), (bh, bl)) = (a.split(), b.split());
    (product, ((ah * bh - product) + (ah * bl + al * bh)) + al * bl)
}

/// The same for any numbers; nothing is kept where splitting overflows.
#[inline(always)]
pub(crate) fn product_of_any<T: Real>(a: T, b: T) -> (T, T) {
    let (product, lost) = product(a, b);
    (product, select(lost.is_finite(), lost, T::ZERO))
}

/// √(x² + y²) and what its rounding lost.
#[inline(always)]
pub(crate) fn hypotenuse<T: Real>(x: T, y: T) -> (T, T) {
    let (xx, xx_lost) = product(x, x);
    let (yy, yy_lost) = product(y, y);
    let (square, square_lost) = sum(xx, yy);
    let root = square.sqrt();
    let (back, back_lost) = product(root, root);
    let rest = (square - back) + (square_lost + xx_lost + yy_lost - back_lost);
    (root, select(root > T::ZERO, rest / (root + root), T::ZERO))
}
