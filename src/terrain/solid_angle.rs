use super::Tile;
use super::vector::{cross, difference, dot};
use crate::Real;
use crate::cube::CubeProjection;
use crate::math::atan2;

impl Tile {
    /// Returns the solid angle, in steradians, of the spherical quadrangle whose corners are those of the
    /// tile and whose sides are great circles. It is positive for corners in counter-clockwise order.
    ///
    /// This is S2's `ExactArea` of a cell. It is the area of the tile itself if the lines of constant x and y
    /// are great circles, as those of [`S2Quadratic`](crate::cube::S2Quadratic) and
    /// [`Tangential`](crate::cube::Tangential) are. Multiply it by the square of a radius to get an area on a
    /// sphere.
    ///
    /// The worst error, from the rounding of the corners, is 2·10⁻¹⁶ (`f64`) or 2.4·10⁻⁷ (`f32`, to level 25)
    /// times 2^level of the angle; for a face it is half an ulp.
    ///
    /// ```
    /// use terrella::cube::{Face, S2Quadratic};
    /// use terrella::terrain::Tile;
    /// let face: f64 = Tile::root(Face::Top).solid_angle(S2Quadratic);
    /// assert!((face - 4.0 * std::f64::consts::PI / 6.0).abs() < 1e-15);
    /// ```
    #[doc(alias = "ExactArea")]
    #[doc(alias = "cell area")]
    #[must_use]
    pub fn solid_angle<T: Real>(self, projection: impl CubeProjection) -> T {
        let [a, b, c, d] = self
            .corners::<T>()
            .map(|corner| projection.unproject(corner).to_array());
        triangle(a, b, c) + triangle(a, c, d)
    }
}

/// Van Oosterom & Strackee (IEEE Trans. Biomed. Eng. 30, 1983). The triple product is computed from
/// differences, which are small if the triangle is small.
///
/// The vectors have unit length within rounding, and the triple product is sensitive to that: lengths of 1 +
/// δ are corrected to first order.
fn triangle<T: Real>(a: [T; 3], b: [T; 3], c: [T; 3]) -> T {
    let excess = |v: [T; 3]| (dot(v, v) - T::ONE) * T::of(0.5);
    let (da, db, dc) = (excess(a), excess(b), excess(c));
    let (ab, bc, ca) = (dot(a, b), dot(b, c), dot(c, a));
    let longer = (da + db + dc) + (ab * dc + bc * da + ca * db);
    let volume = dot(a, cross(difference(b, a), difference(c, a)));
    T::of(2.0) * atan2(volume, (T::ONE + ab + bc + ca) + longer)
}
