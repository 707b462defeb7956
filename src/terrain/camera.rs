use core::fmt;

use super::OrientedBox;
use super::vector::{difference, dot};
use crate::math::select;
use crate::{Ecef, Real};

/// A view of the planet: where the eye is, the renderer's matrix, and the pixels of the picture.
///
/// The matrix takes a point in metres, relative to the eye and along Earth axes, to clip coordinates: a column vector (X, Y, Z, 1) to (x, y, z, w), with
/// what is seen at −w ≤ x ≤ w and −w ≤ y ≤ w. z is not looked at, so that any convention of depth will do.
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

    /// Where a point is in the picture, in pixels from its middle, to the right and up; none for a point that is not before the eye.
    #[must_use]
    #[inline]
    pub fn pixel(&self, point: Ecef<T>) -> Option<[T; 2]> {
        let [x, y, w] = self.clip(difference(point.to_array(), self.eye), T::ONE);
        (w > T::ZERO).then(|| self.on_picture([x, y, w]))
    }

    /// Whether any of a box may be in the picture: it is not all beyond one side of the view, for boxes that are far from it a safe guess.
    #[must_use]
    #[inline]
    pub fn sees(&self, bounds: &OrientedBox<T>) -> bool {
        let [centre, axes @ ..] = self.clip_box(bounds);
        // How far inside each side is the corner that is farthest inside.
        let side = |sign: T, k: usize| {
            let inside = |[x, y, w]: [T; 3]| w + sign * select(k == 0, x, y);
            axes.iter().fold(inside(centre), |sum, &axis| sum + inside(axis).abs())
        };
        let sides = [side(T::ONE, 0), side(-T::ONE, 0), side(T::ONE, 1), side(-T::ONE, 1)];
        sides.into_iter().all(|inside| inside >= T::ZERO)
    }

    /// How many pixels a box covers, whether they are in the picture or beyond its sides; infinitely many if it is not all before the eye.
    ///
    /// The area of the convex hull of its eight corners. Every line of sight to the box meets two of its faces: the hull is half the
    /// sum of their six pictures.
    #[must_use]
    pub fn coverage(&self, bounds: &OrientedBox<T>) -> T {
        let [centre, axes @ ..] = self.clip_box(bounds);
        let [_, _, nearest] = centre;
        let nearest = axes.iter().fold(nearest, |sum, &[_, _, w]| sum - w.abs());
        let mut corner = 0;
        let [a, b, c, d, e, f, g, h] = [centre; 8].map(|mut point| {
            for (bit, axis) in axes.into_iter().enumerate() {
                let sign = select(corner >> bit & 1 == 0, -T::ONE, T::ONE);
                for (sum, part) in point.iter_mut().zip(axis) {
                    *sum += sign * part;
                }
            }
            corner += 1;
            self.on_picture(point)
        });
        // Corners by their bits: a face has those of one bit, and their diagonals.
        let faces = [
            [a, g, c, e],
            [b, h, d, f],
            [a, f, b, e],
            [c, h, d, g],
            [a, d, b, c],
            [e, h, f, g],
        ];
        let twice = faces.into_iter().fold(T::ZERO, |sum, [from, to, left, right]| {
            let (x, y) = (to[0] - from[0], to[1] - from[1]);
            let (u, v) = (right[0] - left[0], right[1] - left[1]);
            sum + (x * v - y * u).abs()
        });
        select(nearest > T::ZERO, T::of(0.25) * twice, T::of(f64::INFINITY))
    }

    /// x, y and w of a point relative to the eye, or of a vector, for which `one` is 0.
    #[inline(always)]
    pub(super) fn clip(&self, [x, y, z]: [T; 3], one: T) -> [T; 3] {
        self.rows.map(|[a, b, c, d]| dot([a, b, c], [x, y, z]) + d * one)
    }

    /// The rows for x, y and w, and half of the picture's size.
    #[inline(always)]
    pub(super) fn rows(&self) -> ([[T; 4]; 3], [T; 2]) {
        (self.rows, self.pixels.map(|count| T::of(0.5) * count))
    }

    /// x, y and w of a box's centre and of its half axes.
    #[inline(always)]
    fn clip_box(&self, bounds: &OrientedBox<T>) -> [[T; 3]; 4] {
        let [right, up, out] = bounds.axes;
        let [width, height, depth] = bounds.half;
        let half = |axis: [T; 3], length: T| self.clip(axis.map(|v| v * length), T::ZERO);
        [
            self.clip(difference(bounds.centre, self.eye), T::ONE),
            half(right, width),
            half(up, height),
            half(out, depth),
        ]
    }

    #[inline(always)]
    fn on_picture(&self, [x, y, w]: [T; 3]) -> [T; 2] {
        let [width, height] = self.pixels;
        let half = T::of(0.5);
        [x / w * (half * width), y / w * (half * height)]
    }
}

/// Why [`Camera::new`] refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidCamera<T> {
    /// A number of the matrix is infinite or NaN.
    Matrix(T),
    /// A number of pixels is not positive and finite.
    Pixels(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidCamera<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Matrix(entry) => write!(f, "the matrix has {entry:?} in it"),
            Self::Pixels(count) => write!(f, "{count:?} is no number of pixels"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidCamera<T> {}
