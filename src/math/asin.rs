use super::minimax::ARC;
use super::{halves, shrunk_root, shrunk_square};
use crate::Real;

/// Twice the arc sine of the root of at most ½, which is given as the square of a number
/// [`grown`](super::grown).
#[inline(always)]
pub(crate) fn doubled_arc<T: Real>(square: T) -> T {
    let (chord, h) = (shrunk_root(square) * T::of(2.0), shrunk_square(square));
    chord + chord * h * halves(h, T::terms(ARC.f64.len(), ARC.f32.len()), |i| T::coefficient(&ARC, i))
}
