use core::fmt;

use super::Jacobian;
use super::jacobian::is_regular;
use crate::cube::{CubeMap, CubeProjection, Face, FacePoint};
use crate::latitude::{Turn, normal};
use crate::{Direction, Dual, Ellipsoid, Real, Shifted};

/// The map from the faces of a cube map to the ground (the ellipsoid), with its derivatives, in metres.
///
/// ```
/// use terrella::cube::{CubeMap, Face, FacePoint, Tangential};
/// use terrella::distortion::Ground;
/// use terrella::{Ellipsoid, Shift};
///
/// let sphere = Ellipsoid::sphere(6_371_000.0_f64)?;
/// let ground = Ground::new(CubeMap::new(sphere, Shift::Geodetic, Tangential)?);
/// let centre = ground.jacobian(FacePoint::new(Face::Front, 0.0, 0.0)?)?;
/// assert_eq!((centre.width(), centre.height()), (6_371_000.0, 6_371_000.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ground<T, P> {
    map: CubeMap<T, P>,
    lifted: Shifted<Dual<T, 2>>,
}

impl<T: Real, P: CubeProjection> Ground<T, P> {
    /// Creates the ground of a cube map.
    #[must_use]
    pub fn new(map: CubeMap<T, P>) -> Self {
        Self {
            map,
            lifted: map.shifted().map(Dual::constant),
        }
    }

    /// Returns the cube map.
    #[must_use]
    pub fn map(&self) -> CubeMap<T, P> {
        self.map
    }

    /// The map's step from sphere to ellipsoid, on dual numbers.
    pub(super) fn lifted(&self) -> &Shifted<Dual<T, 2>> {
        &self.lifted
    }

    /// Returns the ellipsoid.
    #[must_use]
    pub fn ellipsoid(&self) -> Ellipsoid<T> {
        self.map.shifted().ellipsoid()
    }

    /// Returns the derivative of the point on the ground with respect to the coordinates of the face,
    /// computed with dual numbers.
    ///
    /// On a crease (the diagonals of the quadrilateralized cube's faces) it is the derivative on one of the
    /// two sides. Slopes are within 2.2e-15 (`f64`) or 5e-7 (`f32`) of the longest slope; areas have a relative
    /// error of at most 3e-15 or 8e-7.
    ///
    /// # Errors
    /// [`Singular`] where the map has no derivative, or one that is not invertible: at the centre of the
    /// quadrilateralized cube's faces and of HEALPix's polar faces, and at the corners of the vertex and
    /// conformal cubes.
    #[doc(alias = "derivative")]
    #[doc(alias = "automatic differentiation")]
    pub fn jacobian(&self, point: FacePoint<T>) -> Result<Jacobian<T>, Singular<T>> {
        let variables = Dual::variables([point.x(), point.y()]);
        let direction = self.map.projection().vector(point.face(), variables);
        let [_, correction] = self.lifted.corrections();
        let jacobian = jacobian(self.lifted.ellipsoid(), &correction, direction);
        if is_regular(jacobian.area()) {
            Ok(jacobian)
        } else {
            Err(Singular(point))
        }
    }

    /// The outward normal at a point of a face, and the derivatives of the place by x and by y, in Earth axes.
    pub(super) fn slopes(&self, face: Face, point: [T; 2]) -> ([T; 3], [[T; 3]; 2]) {
        let [_, correction] = self.lifted.corrections();
        let direction = self.map.projection().vector(face, Dual::variables(point));
        tangents(self.lifted.ellipsoid(), &correction, direction)
    }

    /// Returns the derivative of the ground as central difference quotients: differences over 2 · `step`, as
    /// Dimitrijević, Lambers & Rančić (2016) compute them with a step of 10⁻⁶.
    ///
    /// `x`, `y` ∈ [−1, 1]. The points used may lie up to one step beyond the face; the face's own formula is
    /// continued there. Across a crease the result is the mean of both sides. The differences are chords: for
    /// that step they are shorter than the arcs by 4e-14 of their length.
    #[doc(alias = "finite differences")]
    #[doc(alias = "central differences")]
    #[must_use]
    pub fn differences(&self, face: Face, [x, y]: [T; 2], step: T) -> Jacobian<T> {
        let normal = |x: T, y: T| {
            let [x, y, z] = self.map.projection().vector(face, [x, y]);
            self.map.shifted().normal(Direction::within(x, y, z))
        };
        let place = |x: T, y: T| self.ellipsoid().foot(normal(x, y));
        let quotient = |from: [T; 3], to: [T; 3]| {
            let mut slope = to;
            for (end, begin) in slope.iter_mut().zip(from) {
                *end = (*end - begin) / (step + step);
            }
            slope
        };
        Jacobian::in_tangent_plane(
            normal(x, y).to_array(),
            [
                quotient(place(x - step, y), place(x + step, y)),
                quotient(place(x, y - step), place(x, y + step)),
            ],
        )
    }

    /// Returns Λ₀² of the paper: width times height of the texel in the middle of the front face, in square
    /// metres per unit of x and of y.
    ///
    /// Where creases meet in the middle, the texel lies across them.
    #[must_use]
    pub fn central_texel(&self) -> T {
        self.differences(Face::Front, [T::ZERO; 2], T::pick(1e-6, 1e-3)).sides()
    }
}

/// The derivative of the ground at a direction; it may be singular.
#[inline(always)]
pub(super) fn jacobian<T: Real>(
    ellipsoid: Ellipsoid<Dual<T, 2>>,
    correction: &impl Turn<Dual<T, 2>>,
    direction: [Dual<T, 2>; 3],
) -> Jacobian<T> {
    let (normal, slopes) = tangents(ellipsoid, correction, direction);
    Jacobian::in_tangent_plane(normal, slopes)
}

/// The outward normal of the ground at a direction, and the derivatives of the place.
#[inline(always)]
fn tangents<T: Real>(
    ellipsoid: Ellipsoid<Dual<T, 2>>,
    correction: &impl Turn<Dual<T, 2>>,
    [x, y, z]: [Dual<T, 2>; 3],
) -> ([T; 3], [[T; 3]; 2]) {
    let normal = normal(correction, Direction::within(x, y, z));
    (normal.to_array().map(Dual::value), slopes(ellipsoid.foot(normal)))
}

/// The derivatives of a vector's components with respect to each variable.
#[inline(always)]
fn slopes<T: Real>(vector: [Dual<T, 2>; 3]) -> [[T; 3]; 2] {
    let [[ax, ay], [bx, by], [cx, cy]] = vector.map(Dual::slopes);
    [[ax, bx, cx], [ay, by, cy]]
}

/// The error of [`Ground::jacobian`]: at this point the map has no derivative, or one that cannot be
/// inverted.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Singular<T>(pub FacePoint<T>);

impl<T: Real> fmt::Display for Singular<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(point) = self;
        write!(
            f,
            "the map is singular at ({}, {}) of face {}",
            point.x(),
            point.y(),
            point.face().index()
        )
    }
}

impl<T: Real> core::error::Error for Singular<T> {}
