use super::vector::{along, difference};
use super::{Camera, Horizon};
use crate::cube::{CubeMap, CubeProjection, FacePoint};
use crate::{Direction, Dual, Ecef, Real, Shifted};

/// The footprint of a pixel on a face of the cube: the inverse of the derivative of the map from the face to
/// the picture.
pub(super) struct Footprint<T, P> {
    projection: P,
    lifted: Shifted<Dual<T, 2>>,
    eye: [Dual<T, 2>; 3],
    rows: [[T; 4]; 3],
    half: [T; 2],
    height: Dual<T, 2>,
}

impl<T: Real, P: CubeProjection> Footprint<T, P> {
    /// Creates it for ground at a constant height, in metres.
    pub(super) fn new(map: &CubeMap<T, P>, camera: &Camera<T>, height: T) -> Self {
        let (rows, half) = camera.rows();
        Self {
            projection: map.projection(),
            lifted: map.shifted().map(Dual::constant),
            eye: camera.eye().to_array().map(Dual::constant),
            rows,
            half,
            height: Dual::constant(height),
        }
    }

    /// Returns how x and y of the face change for a step of one pixel to the right and for a step of one
    /// pixel up. Returns `None` if the ground there is behind the eye, is hidden by the planet, or the map
    /// has no invertible derivative.
    ///
    /// Ground above the eye is treated as seen from below; its area is negative, like that of all ground in a
    /// mirrored picture.
    pub(super) fn at(&self, point: FacePoint<T>, horizon: &Horizon<T>) -> Option<[[T; 2]; 2]> {
        let variables = Dual::variables([point.x(), point.y()]);
        let [x, y, z] = self.projection.vector(point.face(), variables);
        let normal = self.lifted.normal(Direction::within(x, y, z));
        let ground = along(self.lifted.ellipsoid().foot(normal), self.height, normal.to_array());
        let [x, y, z] = ground.map(Dual::value);
        if horizon.hides(Ecef::within(x, y, z)) {
            return None;
        }
        let [x, y, z] = difference(ground, self.eye);
        let [right, up, w] = self.rows.map(|row| {
            let [a, b, c, d] = row.map(Dual::constant);
            a * x + b * y + c * z + d
        });
        if w.value() <= T::ZERO {
            return None;
        }
        let [width, height] = self.half;
        let [a, b] = (right / w).slopes().map(|slope| slope * width);
        let [c, d] = (up / w).slopes().map(|slope| slope * height);
        let inverse = T::ONE / (a * d - b * c);
        inverse
            .is_finite()
            .then(|| [[d * inverse, -c * inverse], [-b * inverse, a * inverse]])
    }
}
