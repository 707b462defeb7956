use super::vector::{along, difference, dot};
use super::{Camera, OrientedBox};
use crate::math::{max, min};
use crate::{Ecef, Real};

/// The part of a tile's bounding box that stands for its ground, if the box is higher than it is wide.
///
/// The ground of a box that is 10 m wide and 10 km high is somewhere in the box, but does not fill it. It is
/// assumed to be no steeper than 45°, so that a box as high as it is wide contains it. Of all such boxes that
/// may be in the picture, this is the one nearest to the eye.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slab<T> {
    pub(super) bounds: OrientedBox<T>,
    /// The height of its middle above the middle of the whole box, in metres.
    pub(super) above: T,
    /// Its distance from the centre of projection, in metres; `None` for a parallel projection.
    pub(super) away: Option<T>,
}

impl<T: Real> Slab<T> {
    /// Creates the slab of a box; `point` is the centre of projection, or `None` for a parallel projection.
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
            // The slices whose middle is in the picture; if there are none, those of which any part is.
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
