//! A lower bound of the distance from a place to a leg, from three unit vectors.

use crate::math::{max, min};
use crate::{Ellipsoid, LatLon, Real};

/// What [`Legs::at_least`](super::Legs::at_least) returns on an ellipsoid.
///
/// The radii of curvature are between a²/b and b²/a, and so a distance is between these numbers times the
/// angle between the two normals (for the lengths of the lines of one surface are lengths of lines of the
/// other). By the triangle inequality no point of a leg is nearer than half of what both ends are apart from
/// the place, less the leg's length.
pub(super) fn at_least<T: Real>(ellipsoid: Ellipsoid<T>, place: LatLon<T>, start: LatLon<T>, end: LatLon<T>) -> T {
    let (a, b) = (ellipsoid.a(), ellipsoid.b());
    let (one, two) = (a * (a / b), b * (b / a));
    let (shortest, longest) = (min(one, two), max(one, two));
    let [place, start, end] = [place, start, end].map(|place| place.to_direction().to_array());
    let apart = |[x, y, z]: [T; 3], [u, v, w]: [T; 3]| {
        let (dx, dy, dz) = (x - u, y - v, z - w);
        T::of(0.5) * (dx * dx + dy * dy + dz * dz).sqrt()
    };
    // x + x³/6 ≤ arc sine x ≤ x + (π/2 − 1)x³: all terms of its series are positive.
    let cubed = |x: T, part: T| x + part * x * x * x;
    let sixth = T::of(1.0 / 6.0);
    let ends = cubed(apart(place, start), sixth) + cubed(apart(place, end), sixth);
    let leg = cubed(apart(start, end), T::of(core::f64::consts::FRAC_PI_2 - 1.0));
    // Distances as computed may be shorter than they are: in f32 by 7e-7 of them and four metres on the
    // Earth.
    let slack = T::pick(1e-12, 4e-6) * longest;
    max(shortest * ends - longest * leg - slack, T::ZERO)
}
