use core::fmt;

use crate::cube::Face;
use crate::math::{select, sin_cos_degrees};
use crate::{Direction, Real};

/// A rotation of the cube, for [`Turned`](super::Turned).
///
/// ```
/// use terrella::Direction;
/// use terrella::cube::{Face, Rotation};
/// // The two ways to turn the cube by a quarter to the east.
/// let east = Direction::new(0.0, 1.0, 0.0)?;
/// assert_eq!(Rotation::about_axis(90.0)?, Rotation::facing(Face::Front, east, 0.0)?);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "orientation")]
#[doc(alias = "lon_0")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Rotation {
    /// The cube's axes, along Earth axes.
    double: [[f64; 3]; 3],
    /// The same, rounded: `f32` then does no `f64` arithmetic.
    single: [[f32; 3]; 3],
}

impl Rotation {
    /// Creates the rotation of a matrix, which maps a vector along the cube's axes to the vector along Earth
    /// axes. The matrix is given by its rows; its columns are the cube's axes.
    ///
    /// A matrix that is a rotation to nine digits is improved to one within rounding.
    ///
    /// ```
    /// use terrella::cube::{InvalidRotation, Rotation};
    /// // The cube's x toward 0° N 90° E.
    /// const EAST: [[f64; 3]; 3] = [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
    /// const ROTATION: Rotation = match Rotation::new(EAST) {
    ///     Ok(rotation) => rotation,
    ///     Err(_) => panic!(),
    /// };
    /// assert_eq!(ROTATION.matrix(), EAST);
    ///
    /// let mirror = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// assert_eq!(Rotation::new(mirror), Err(InvalidRotation { departure: 2.0 }));
    /// ```
    ///
    /// # Errors
    /// [`InvalidRotation`] if the matrix departs from a rotation by more than 10⁻⁹.
    pub const fn new(matrix: [[f64; 3]; 3]) -> Result<Self, InvalidRotation> {
        let [a, b, c] = transposed(matrix);
        let departure = departure(a, b, c);
        if departure <= 1e-9 {
            // One step of the Newton–Schulz iteration, M(3I − MᵀM)/2: it squares the departure.
            let columns = [nearer(a, b, c), nearer(b, c, a), nearer(c, a, b)];
            Ok(Self {
                double: columns,
                single: narrow(columns),
            })
        } else {
            Err(InvalidRotation { departure })
        }
    }

    /// Creates the rotation about the Earth's axis by an angle in degrees, eastward if positive: the front
    /// face is then centred on that longitude.
    ///
    /// −10 is the cube of GEOS and FV3; 45 makes [`Healpix`](crate::cube::Healpix) PROJ's `rhealpix`.
    ///
    /// # Errors
    /// [`InvalidRotation`] if the angle is not finite, or larger than 10⁹.
    pub fn about_axis(degrees: f64) -> Result<Self, InvalidRotation> {
        let (sin, cos) = sin_cos_degrees(degrees);
        Self::new([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])
    }

    /// Creates the rotation that brings the centre of a face to a place, so that the face's upward axis points
    /// along a heading there: degrees clockwise from north.
    ///
    /// At a pole, north is the direction away from longitude 0. So a heading of 0 at the face's own place
    /// changes nothing. For a place on an ellipsoid, the direction is that of
    /// [`Shifted::to_direction`](crate::Shifted::to_direction).
    ///
    /// ```
    /// use terrella::LatLon;
    /// use terrella::cube::{CubeProjection, Face, Rotation, Tangential, Turned};
    /// let zurich = LatLon::new(47.4, 8.5)?.to_direction();
    /// let turned = Turned::new(Tangential, Rotation::facing(Face::Top, zurich, 30.0)?);
    /// let point = turned.project(zurich);
    /// assert_eq!(point.face(), Face::Top);
    /// assert!(point.x().abs() < 1e-15 && point.y().abs() < 1e-15);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidRotation`] if the heading is not finite, or larger than 10⁹.
    pub fn facing(face: Face, place: Direction<f64>, heading: f64) -> Result<Self, InvalidRotation> {
        let [x, y, z] = place.to_array();
        let axial = (x * x + y * y).sqrt();
        let [a, b] = select(axial > 0.0, [x / axial, y / axial], [1.0, 0.0]);
        let (east, north) = ([-b, a, 0.0], [-z * a, -z * b, axial]);
        let (sin, cos) = sin_cos_degrees(heading);
        let [right, up] = [[cos, -sin], [sin, cos]].map(|[e, n]| combined([e, n, 0.0], [east, north, [0.0; 3]]));
        let column = |axis| combined(face.to_local(axis), [right, up, [x, y, z]]);
        let columns = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(column);
        Self::new(transposed(columns))
    }

    /// Returns the matrix, by its rows: see [`new`](Self::new).
    #[must_use]
    pub const fn matrix(&self) -> [[f64; 3]; 3] {
        transposed(self.double)
    }

    /// The cube's axes, along Earth axes.
    #[inline(always)]
    fn axes<T: Real>(self) -> [[T; 3]; 3] {
        let vector = |[a, b, c]: [f64; 3], [d, e, f]: [f32; 3]| [T::pick(a, d), T::pick(b, e), T::pick(c, f)];
        let ([a, b, c], [d, e, f]) = (self.double, self.single);
        [vector(a, d), vector(b, e), vector(c, f)]
    }

    /// A vector along Earth axes, as one along the cube's axes.
    #[inline(always)]
    pub(super) fn to_cube<T: Real>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        self.axes().map(|[a, b, c]: [T; 3]| a * x + b * y + c * z)
    }

    /// A vector along the cube's axes, as one along Earth axes: by the transposed matrix, which is the
    /// inverse.
    #[inline(always)]
    pub(super) fn to_earth<T: Real>(self, vector: [T; 3]) -> [T; 3] {
        combined(vector, self.axes())
    }
}

/// The sum of vectors, each times a number.
#[inline(always)]
fn combined<T: Real>([x, y, z]: [T; 3], [a, b, c]: [[T; 3]; 3]) -> [T; 3] {
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a, b, c);
    [
        ax * x + bx * y + cx * z,
        ay * x + by * y + cy * z,
        az * x + bz * y + cz * z,
    ]
}

const fn transposed([[a, b, c], [d, e, f], [g, h, i]]: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    [[a, d, g], [b, e, h], [c, f, i]]
}

const fn narrow([[a, b, c], [d, e, f], [g, h, i]]: [[f64; 3]; 3]) -> [[f32; 3]; 3] {
    [
        [a as f32, b as f32, c as f32],
        [d as f32, e as f32, f as f32],
        [g as f32, h as f32, i as f32],
    ]
}

const fn dot([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    ax * bx + ay * by + az * bz
}

/// How far three vectors are from unit vectors at right angles, right-handed: of the products of two of them,
/// and of the third from their cross product. NaN if there is one.
const fn departure(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a, b, c);
    let mut worst = (dot(a, a) - 1.0).abs();
    worst = larger(worst, dot(b, b) - 1.0);
    worst = larger(worst, dot(a, b));
    worst = larger(worst, ay * bz - az * by - cx);
    worst = larger(worst, az * bx - ax * bz - cy);
    larger(worst, ax * by - ay * bx - cz)
}

/// The larger of a number and the absolute value of another; NaN if either is.
const fn larger(a: f64, b: f64) -> f64 {
    if b.abs() <= a || a.is_nan() { a } else { b.abs() }
}

/// A column a of the matrix with columns a, b, c after the step: a(3 − a·a)/2 − b(a·b)/2 − c(a·c)/2.
const fn nearer(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> [f64; 3] {
    let ([ax, ay, az], [bx, by, bz], [cx, cy, cz]) = (a, b, c);
    let (p, q, r) = (1.5 - 0.5 * dot(a, a), -0.5 * dot(a, b), -0.5 * dot(a, c));
    [
        ax * p + bx * q + cx * r,
        ay * p + by * q + cy * r,
        az * p + bz * q + cz * r,
    ]
}

/// The error for a matrix that is no rotation, or for an angle that gives none.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidRotation {
    /// The largest departure of a scalar product of the first two columns from 1 or 0, or of a component of
    /// the third column from their cross product. It is 2 for a mirror, and NaN if the angle or a component is
    /// not finite.
    pub departure: f64,
}

impl fmt::Display for InvalidRotation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "expected a rotation, got a matrix that departs from one by {:?}",
            self.departure
        )
    }
}

impl core::error::Error for InvalidRotation {}
