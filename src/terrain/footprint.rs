use super::vector::{along, difference};
use super::{Camera, Horizon};
use crate::cube::{CubeMap, CubeProjection, FacePoint};
use crate::{Direction, Dual, Ecef, Real, Shifted};

/// Pixels as places of a cube map: the derivative of the way from the face to the picture, inverted.
pub(super) struct Footprint<T, P> {
    projection: P,
    lifted: Shifted<Dual<T, 2>>,
    eye: [Dual<T, 2>; 3],
    rows: [[T; 4]; 3],
    half: [T; 2],
    height: Dual<T, 2>,
}

impl<T: Real, P: CubeProjection> Footprint<T, P> {
    /// Of the ground at a height.
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

    /// What a pixel to the right and a pixel up change x and y by; none where the ground is behind the eye,
    /// the planet itself hides it, or the map has no derivative.
    ///
    /// Ground above the eye is as if seen from below, and its area negative, as it is of all ground in a
    /// mirrored picture.
    pub(super) fn at(&self, point: FacePoint<T>, horizon: &Horizon<T>) -> Option<[[T; 2]; 2]> {
        let face = point.face();
        let variables = Dual::variables([point.x(), point.y()]);
        let [x, y, z] = face.to_earth(self.projection.inverse(face, variables));
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
