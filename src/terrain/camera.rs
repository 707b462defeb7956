use core::fmt;

use super::OrientedBox;
use super::vector::{along, cross, difference, dot};
use crate::math::{max, min, select};
use crate::{Ecef, Real};

/// A view of the planet: where the eye is, the renderer's matrix, and the pixels of the picture.
///
/// The matrix takes a point in metres, relative to the eye and along Earth axes, to clip coordinates: a
/// column vector (X, Y, Z, 1) to (x, y, z, w), with what is seen at −w ≤ x ≤ w and −w ≤ y ≤ w, where w > 0. z
/// is not looked at, so that any convention of depth will do. y may be up or down, and the picture mirrored.
///
/// Lines of sight meet in the centre of projection, where x = y = w = 0: at the eye if the matrix has zeros
/// in its last column, elsewhere if not, and for a parallel projection, whose last row is 0, 0, 0, 1,
/// infinitely far away. Parallel lines of sight come to the planet from the side on which the eye is: of the
/// two directions, which the matrix does not tell apart, the one that leads down to the planet at the eye.
/// Nothing is behind a parallel projection's eye: of all places on a line of sight the first is seen.
///
/// ```
/// use terrella::Ecef;
/// use terrella::terrain::Camera;
///
/// // From above 0° N 0° E straight down, north up, 90° wide and high.
/// let eye = Ecef::new(7_000_000.0_f64, 0.0, 0.0)?;
/// let matrix = [[0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0; 4], [-1.0, 0.0, 0.0, 0.0]];
/// let camera = Camera::new(eye, matrix, [1024.0, 1024.0])?;
/// assert_eq!(camera.pixel(Ecef::new(6_000_000.0, 500_000.0, 0.0)?), Some([256.0, 0.0]));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Camera<T> {
    eye: [T; 3],
    /// The rows for x, y and w.
    rows: [[T; 4]; 3],
    pixels: [T; 2],
}

impl<T: Real> Camera<T> {
    /// From an eye, a matrix row by row, and the width and height of the picture in pixels.
    ///
    /// # Errors
    /// [`InvalidCamera`] if a number of the matrix is infinite or NaN, or a number of pixels is not positive and finite.
    pub fn new(eye: Ecef<T>, matrix: [[T; 4]; 4], pixels: [T; 2]) -> Result<Self, InvalidCamera<T>> {
        if let Some(&entry) = matrix.iter().flatten().find(|entry| !entry.is_finite()) {
            return Err(InvalidCamera::Matrix(entry));
        }
        if let Some(&count) = pixels.iter().find(|&&count| !(count > T::ZERO && count.is_finite())) {
            return Err(InvalidCamera::Pixels(count));
        }
        let [x, y, _, w] = matrix;
        Ok(Self {
            eye: eye.to_array(),
            rows: [x, y, w],
            pixels,
        })
    }

    /// Where the eye is, in metres.
    #[must_use]
    #[inline]
    pub fn eye(&self) -> Ecef<T> {
        let [x, y, z] = self.eye;
        Ecef::within(x, y, z)
    }

    /// Where a point is in the picture, in pixels from its middle, to the right and up; none for a point that
    /// is not before the eye, where w ≤ 0.
    #[must_use]
    #[inline]
    pub fn pixel(&self, point: Ecef<T>) -> Option<[T; 2]> {
        let [x, y, w] = self.clip(difference(point.to_array(), self.eye), T::ONE);
        (w > T::ZERO).then(|| self.on_picture([x, y, w]))
    }

    /// Whether any of a box may be in the picture: of its slices along the third axis one that is not all
    /// behind the eye or beyond one side of the view, for boxes that are far from it a safe guess.
    #[must_use]
    #[inline]
    pub fn sees(&self, bounds: &OrientedBox<T>) -> bool {
        self.slices(bounds, T::ONE).is_some()
    }

    /// From which slice of a box to which, from −1 to 1 along its third axis, slices of so many times its
    /// width and height are not all beyond one side of the view.
    #[inline]
    pub(super) fn slices(&self, bounds: &OrientedBox<T>, size: T) -> Option<[T; 2]> {
        let [first, second, upward] = bounds.axes;
        let [width, height, depth] = bounds.half;
        let half = |axis: [T; 3], length: T| insides(self.clip(axis.map(|v| v * length), T::ZERO));
        let (across, along, rise) = (
            half(first, size * width),
            half(second, size * height),
            half(upward, depth),
        );
        let way = difference(bounds.centre, self.eye);
        let inside = insides(self.clip(way, T::ONE));
        // What rounding may have done to that.
        let [x, y, w] = self.rows.map(|[a, b, c, d]| {
            let [x, y, z] = way.map(T::abs);
            dot([a.abs(), b.abs(), c.abs()], [x, y, z]) + d.abs()
        });
        let rest = [w, w + x, w + x, w + y, w + y];
        let few = T::of(8.0) * T::EPSILON;
        let (mut low, mut high) = (-T::ONE - few, T::ONE + few);
        for ((((inside, rest), across), along), rise) in inside.into_iter().zip(rest).zip(across).zip(along).zip(rise) {
            // How far inside this side of the view the middle slice is with the corner that is farthest
            // inside.
            let reach = inside + across.abs() + along.abs() + few * rest;
            let bound = -(reach / rise);
            if rise > T::ZERO {
                low = max(low, bound);
            } else if rise < T::ZERO {
                high = min(high, bound);
            } else if reach < T::ZERO {
                return None;
            }
        }
        (low <= high).then_some([low, high])
    }

    /// x, y and w of a point relative to the eye, or of a vector, for which `one` is 0.
    #[inline(always)]
    pub(super) fn clip(&self, [x, y, z]: [T; 3], one: T) -> [T; 3] {
        self.rows.map(|[a, b, c, d]| dot([a, b, c], [x, y, z]) + d * one)
    }

    /// The centre of projection from the eye, times its weight, and the weight: 0 for one that is infinitely
    /// far away; all 0 where there is none.
    ///
    /// Where three rows are 0: the determinants of their columns but one.
    #[inline]
    pub(super) fn centre(&self) -> ([T; 3], T) {
        // The scale of a row does not count, and products of small numbers could be nothing.
        let rows = self.rows.map(|row| {
            let largest = row.iter().fold(T::ZERO, |most, entry| max(most, entry.abs()));
            let scale = select(largest > T::ZERO, largest, T::ONE);
            row.map(|entry| entry / scale)
        });
        let [[ax, ay, az, a], [bx, by, bz, b], [cx, cy, cz, c]] = rows;
        let [ab, bc, ca] = [
            cross([ax, ay, az], [bx, by, bz]),
            cross([bx, by, bz], [cx, cy, cz]),
            cross([cx, cy, cz], [ax, ay, az]),
        ];
        let way = along(along(bc.map(|v| -(a * v)), -b, ca), -c, ab);
        (way, dot([ax, ay, az], bc))
    }

    /// The centre of projection, in metres; none for parallel lines of sight.
    #[inline]
    pub(super) fn point(&self) -> Option<Ecef<T>> {
        let (way, weight) = self.centre();
        let [x, y, z] = along(self.eye, T::ONE, way.map(|v| v / weight));
        let point = Ecef::within(x, y, z);
        (x.is_finite() & y.is_finite() & z.is_finite()).then_some(point)
    }

    /// The rows for x, y and w, and half of the picture's size.
    #[inline(always)]
    pub(super) fn rows(&self) -> ([[T; 4]; 3], [T; 2]) {
        (self.rows, self.pixels.map(|count| T::of(0.5) * count))
    }

    #[inline(always)]
    pub(super) fn on_picture(&self, [x, y, w]: [T; 3]) -> [T; 2] {
        let [width, height] = self.pixels;
        let half = T::of(0.5);
        [x / w * (half * width), y / w * (half * height)]
    }
}

/// How far x, y and w are inside: before the eye, and of each side of the view.
#[inline(always)]
fn insides<T: Real>([x, y, w]: [T; 3]) -> [T; 5] {
    [w, w + x, w - x, w + y, w - y]
}

/// Why [`Camera::new`] refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidCamera<T> {
    /// A number of the matrix is infinite or NaN.
    Matrix(T),
    /// A number of pixels is not positive and finite.
    Pixels(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidCamera<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Matrix(entry) => write!(f, "expected a matrix of finite numbers, got {entry:?}"),
            Self::Pixels(count) => write!(f, "expected a positive, finite number of pixels, got {count:?}"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidCamera<T> {}
