use super::vector::{along, difference, dot};
use super::{Camera, OrientedBox};
use crate::math::{max, min};
use crate::{Ecef, Real};

/// Where a tile's ground is taken to be when its box is higher than it is wide.
///
/// Ground in a box that is 10 m wide and 10 km high is somewhere in it, and not everywhere: it is taken to be
/// no steeper than 45°, so that there is a box as high as wide around it. Of all such, the one that is
/// nearest to the eye among those that may be in the picture.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slab<T> {
    pub(super) bounds: OrientedBox<T>,
    /// How far its middle is above that of all heights, in metres.
    pub(super) above: T,
    /// How far it is from the centre of projection, in metres; none for parallel lines of sight.
    pub(super) away: Option<T>,
}

impl<T: Real> Slab<T> {
    /// Of a box, for an eye at a point or infinitely far away.
    pub(super) fn new(bounds: &OrientedBox<T>, camera: &Camera<T>, point: Option<Ecef<T>>) -> Self {
        let [width, height, depth] = bounds.half;
        let thick = min(depth, min(width, height));
        let room = depth - thick;
        let mut above = T::ZERO;
        if room > T::ZERO {
            let [_, _, upward] = bounds.axes;
            let nearest = point.map_or(T::ZERO, |point| {
                dot(difference(point.to_array(), bounds.centre), upward)
            });
            // Where its middle line is in the picture, or else any of it.
            let slices = camera.slices(bounds, T::ZERO).or_else(|| camera.slices(bounds, T::ONE));
            let [low, high] = slices.unwrap_or([-T::ONE, T::ONE]).map(|v| v * depth);
            above = min(max(min(max(nearest, low), high), -room), room);
        }
        let [first, second, upward] = bounds.axes;
        let bounds = OrientedBox {
            centre: along(bounds.centre, above, upward),
            axes: [first, second, upward],
            half: [width, height, thick],
        };
        let away = point.map(|point| bounds.distance(point));
        Self { bounds, above, away }
    }
}
