//! Bilinear interpolation whose results have the symmetries of the square, bit for bit.

use crate::Real;

/// The weights of the four corners, in the order of [`Corner::ALL`](crate::cube::Corner::ALL), at (s, t) =
/// (m, n)/count.
#[inline(always)]
pub(super) fn weights<T: Real>([m, n]: [T; 2], count: T) -> [T; 4] {
    let ([left, right], [down, up]) = ([(count - m) / count, m / count], [(count - n) / count, n / count]);
    [right * up, left * up, left * down, right * down]
}

/// The weighted mean of four numbers. Opposite corners are added first: a mirrored or transposed square then
/// has the same sums, and on an edge the order of its ends does not matter.
#[inline(always)]
pub(super) fn mean<T: Real>([a, b, c, d]: [T; 4], [wa, wb, wc, wd]: [T; 4]) -> T {
    (a * wa + c * wc) + (b * wb + d * wd)
}

/// The weighted mean of four vectors.
#[inline(always)]
pub(super) fn blend<T: Real>([a, b, c, d]: [[T; 3]; 4], weights: [T; 4]) -> [T; 3] {
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]) = (a, b, c, d);
    [
        mean([ax, bx, cx, dx], weights),
        mean([ay, by, cy, dy], weights),
        mean([az, bz, cz, dz], weights),
    ]
}
