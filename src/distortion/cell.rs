//! The measures of one cell, from the places of its corners, of its centre and of its neighbours' centres.

use crate::Real;
use crate::math::{atan2, max, min};
use crate::simd::Kernel;

/// The numbers that a place has in a row.
type Place<T> = [T; 3];

/// The kernel that measures a cell. Places are in units of the authalic radius, and lengths are arcs of the
/// sphere with this radius: on a sphere they are exact.
#[derive(Clone, Copy)]
pub(super) struct ToCell<T> {
    /// The side of a square that has the mean area, in the same unit.
    pub(super) side: T,
}

/// The number of measures of a cell.
pub(super) const MEASURES: usize = 13;

impl<T: Real> Kernel<[T; 27]> for ToCell<T> {
    /// The area; four edges, two diagonals, two spans; the aspect of the edges and of the diagonals; the
    /// compactness; the spacing.
    type Output = [T; MEASURES];

    #[inline(always)]
    #[rustfmt::skip]
    fn apply(
        &self,
        [
            // The corners, counter-clockwise from the lowest x and y.
            ax, ay, az, bx, by, bz, cx, cy, cz, dx, dy, dz,
            // The centre, and those to the right, above, to the left and below.
            mx, my, mz, ex, ey, ez, nx, ny, nz, wx, wy, wz, sx, sy, sz,
        ]: [T; 27],
    ) -> [T; MEASURES] {
        let (a, b, c, d) = ([ax, ay, az], [bx, by, bz], [cx, cy, cz], [dx, dy, dz]);
        let (down, right, up, left) = (minus(b, a), minus(c, b), minus(d, c), minus(a, d));
        let (rising, falling) = (minus(c, a), minus(d, b));
        let squares = [square(down), square(right), square(up), square(left)];
        let edges = squares.map(arc);
        let across = square(rising);
        let diagonals = [across, square(falling)].map(arc);
        let [p, q, r, s] = squares;
        let area = triangle(down, rising, [p, q, across]) + triangle(rising, left, [r, s, across]);
        let spans = [
            angle(cross(a, left), cross(right, b)),
            angle(cross(down, a), cross(d, up)),
        ];
        let perimeter = sum(edges);
        let m = [mx, my, mz];
        let neighbours = [[ex, ey, ez], [nx, ny, nz], [wx, wy, wz], [sx, sy, sz]];
        let distances = neighbours.map(|next| arc(square(minus(next, m))));

        let [w, x, y, z] = edges.map(|edge| edge / self.side);
        let [g, h] = diagonals.map(|diagonal| diagonal / self.side);
        let [i, j] = spans.map(|span| span / self.side);
        [
            area / (self.side * self.side), w, x, y, z, g, h, i, j,
            ratio(edges), ratio(diagonals),
            area * (T::of(4.0 * core::f64::consts::PI) - area) / (perimeter * perimeter),
            ratio(distances),
        ]
    }
}

#[inline(always)]
fn minus<T: Real>([a, b, c]: Place<T>, [x, y, z]: Place<T>) -> Place<T> {
    [a - x, b - y, c - z]
}

#[inline(always)]
fn dot<T: Real>([a, b, c]: Place<T>, [x, y, z]: Place<T>) -> T {
    a * x + b * y + c * z
}

#[inline(always)]
fn square<T: Real>(v: Place<T>) -> T {
    dot(v, v)
}

#[inline(always)]
fn cross<T: Real>([a, b, c]: Place<T>, [x, y, z]: Place<T>) -> Place<T> {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

#[inline(always)]
fn sum<T: Real>([a, b, c, d]: [T; 4]) -> T {
    (a + b) + (c + d)
}

/// The largest divided by the smallest.
#[inline(always)]
fn ratio<T: Real, const N: usize>(lengths: [T; N]) -> T {
    let infinity = T::of(f64::INFINITY);
    lengths.into_iter().fold(-infinity, max) / lengths.into_iter().fold(infinity, min)
}

/// The arc of a chord, from the chord's square.
#[inline(always)]
fn arc<T: Real>(square: T) -> T {
    T::of(2.0) * atan2(square.sqrt(), max(T::of(4.0) - square, T::ZERO).sqrt())
}

/// The angle between two vectors.
#[inline(always)]
fn angle<T: Real>(from: Place<T>, to: Place<T>) -> T {
    atan2(square(cross(from, to)).sqrt(), dot(from, to))
}

/// The area of the spherical triangle with these sides: chords a and b, and the squares of all three.
///
/// tan(E/2) = V/(1 + cos α + cos β + cos γ) with V the volume that the corners span (Eriksson 1990). By the
/// chords alone, V² = |a × b|² − a²b²c²/4, and the sum of cosines is 3 less half of the sum of their squares.
#[inline(always)]
fn triangle<T: Real>(a: Place<T>, b: Place<T>, [p, q, r]: [T; 3]) -> T {
    let volume = max(square(cross(a, b)) - T::of(0.25) * p * q * r, T::ZERO).sqrt();
    T::of(2.0) * atan2(volume, T::of(4.0) - T::of(0.5) * (p + q + r))
}
