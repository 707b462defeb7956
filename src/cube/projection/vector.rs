//! What several projections share.

use crate::Real;
use crate::math::{max, min};

/// Coordinates that rounding has not led off the face.
#[inline(always)]
pub(crate) fn on_face<T: Real>(coordinates: [T; 2]) -> [T; 2] {
    coordinates.map(|v| max(min(v, T::ONE), -T::ONE))
}

/// The unit vector of gnomonic coordinates (u, v).
#[inline(always)]
pub(super) fn from_gnomonic<T: Real>([u, v]: [T; 2]) -> [T; 3] {
    normalise([u, v, T::ONE])
}

/// The unit vector of a vector whose squares neither vanish nor overflow: one division, one square root, in this
/// order, as a root halves what was lost before it. What both lose changes the length alone.
///
/// On a cube's edge two components agree; the order of the sum keeps the result the same from both faces.
#[inline(always)]
pub(super) fn normalise<T: Real>([x, y, z]: [T; 3]) -> [T; 3] {
    let inverse = (T::ONE / (x * x + y * y + z * z)).sqrt();
    [x * inverse, y * inverse, z * inverse]
}
