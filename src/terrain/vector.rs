//! Vectors of three components.

use crate::Real;

#[inline(always)]
pub(super) fn dot<T: Real>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> T {
    ax * bx + ay * by + az * bz
}

#[inline(always)]
pub(super) fn cross<T: Real>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

#[inline(always)]
pub(super) fn difference<T: Real>([ax, ay, az]: [T; 3], [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ax - bx, ay - by, az - bz]
}

/// The point at a distance `way` from a point along an axis: a + way·b.
#[inline(always)]
pub(super) fn along<T: Real>([ax, ay, az]: [T; 3], way: T, [bx, by, bz]: [T; 3]) -> [T; 3] {
    [ax + way * bx, ay + way * by, az + way * bz]
}

#[inline(always)]
pub(super) fn normalised<T: Real>(vector: [T; 3]) -> [T; 3] {
    let length = dot(vector, vector).sqrt();
    vector.map(|v| v / length)
}
