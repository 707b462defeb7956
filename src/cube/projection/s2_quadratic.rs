use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;

/// The quadratic cube of the S2 library: u = x(2 + |x|)/3 in each coordinate.
///
/// No transcendental function; area ratio 2.10. Faces and axes are this crate's: see [`Numbering`](crate::cube::Numbering) for
/// those of S2, and [`Key::s2_leaf`](crate::terrain::Key::s2_leaf) for S2's own cell of a direction.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct S2Quadratic;

impl CubeProjection for S2Quadratic {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [coordinate(right / outward), coordinate(up / outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        from_gnomonic([gnomonic(x), gnomonic(y)])
    }
}

/// √(1 + 3u) − 1 without the difference.
#[inline(always)]
fn coordinate<T: Real>(u: T) -> T {
    let three = T::of(3.0);
    three * u / (T::ONE + (T::ONE + three * u.abs()).sqrt())
}

#[inline(always)]
fn gnomonic<T: Real>(x: T) -> T {
    x * (T::of(2.0) + x.abs()) / T::of(3.0)
}
