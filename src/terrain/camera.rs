use core::fmt;

use super::OrientedBox;
use super::vector::{along, cross, difference, dot};
use crate::math::{max, min, select};
use crate::{Ecef, Ray, Real};

/// A view of the planet: the position of the eye, the renderer's view-projection matrix, and the size of the
/// picture in pixels.
///
/// The matrix maps a point in metres, relative to the eye and along Earth axes, to clip coordinates: the
/// column vector (X, Y, Z, 1) to (x, y, z, w). A point is in the view if w > 0, −w ≤ x ≤ w and −w ≤ y ≤ w. z
/// is not used, so any depth convention will do. y may point up or down, and the picture may be mirrored.
///
/// All lines of sight meet in the centre of projection, where x = y = w = 0. It is at the eye if the last
/// column of the matrix is zero, and elsewhere if not. For a parallel projection, whose last row is 0, 0, 0,
/// 1, it is infinitely far away. The matrix does not tell from which of two sides parallel lines of sight
/// come; the side of the eye is taken: of the two directions, the one that leads down to the planet at the
/// eye. Nothing is behind the eye of a parallel projection: of all points on a line of sight, the first one
/// is visible.
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
#[doc(alias = "view-projection matrix")]
#[doc(alias = "frustum")]
#[doc(alias = "view frustum")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Camera<T> {
    eye: [T; 3],
    /// The rows of the matrix for x, y and w.
    rows: [[T; 4]; 3],
    pixels: [T; 2],
}

impl<T: Real> Camera<T> {
    /// Creates a camera from the position of the eye, the matrix row by row, and the width and height of the
    /// picture in pixels.
    ///
    /// # Errors
    /// [`InvalidCamera`] if an element of the matrix is infinite or NaN, or if the width or height is not
    /// positive and finite.
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

    /// Returns the position of the eye, in metres.
    #[must_use]
    #[inline]
    pub fn eye(&self) -> Ecef<T> {
        let [x, y, z] = self.eye;
        Ecef::within(x, y, z)
    }

    /// Returns the position of a point in the picture, in pixels to the right of the middle and above it
    /// (along the matrix's x and y). Returns `None` for a point that is not in front of the eye (w ≤ 0).
    #[must_use]
    #[inline]
    pub fn pixel(&self, point: Ecef<T>) -> Option<[T; 2]> {
        let [x, y, w] = self.clip(difference(point.to_array(), self.eye), T::ONE);
        (w > T::ZERO).then(|| self.on_picture([x, y, w]))
    }

    /// Returns the ray that is seen at a position in the picture, in pixels to the right of the middle and
    /// above it: the inverse of [`pixel`](Self::pixel). Returns `None` if no ray leads there, which is only
    /// so for a matrix that cannot be inverted, or for a position that is not finite.
    ///
    /// With a perspective matrix the ray starts at the centre of projection. With a parallel one it starts
    /// beside the eye, and leads away from a viewer to whom the picture is not mirrored.
    /// [`Ellipsoid::meet`](crate::Ellipsoid::meet) tells where it meets the ground.
    ///
    /// ```
    /// use terrella::terrain::Camera;
    /// use terrella::{Ecef, Ellipsoid};
    ///
    /// // From 621.863 km above 0° N 0° E straight down, north up.
    /// let eye = Ecef::new(7_000_000.0_f64, 0.0, 0.0)?;
    /// let matrix = [[0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0], [0.0; 4], [-1.0, 0.0, 0.0, 0.0]];
    /// let camera = Camera::new(eye, matrix, [1024.0, 1024.0])?;
    /// let ray = camera.ray([0.0, 0.0]).ok_or("no ray")?;
    /// let distance = Ellipsoid::WGS84.meet(&ray, 0.0).distance().ok_or("past the Earth")?;
    /// assert!((distance - 621_863.0).abs() < 1e-8);
    /// let corner = camera.ray([512.0, 512.0]).ok_or("no ray")?;
    /// let ground = Ellipsoid::WGS84.meet(&corner, 0.0).distance().map(|distance| corner.at(distance));
    /// let [x, y] = ground.and_then(|ground| camera.pixel(ground)).ok_or("not seen")?;
    /// assert!((x - 512.0).abs() < 1e-9 && (y - 512.0).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "unproject")]
    #[doc(alias = "pick")]
    #[must_use]
    pub fn ray(&self, [right, above]: [T; 2]) -> Option<Ray<T>> {
        let half = T::of(0.5);
        let [width, height] = self.pixels;
        let [x, y, w] = self.rows;
        // Two planes with the ray in both.
        let plane = |row: [T; 4], place: T| {
            let mut plane = row;
            for (entry, w) in plane.iter_mut().zip(w) {
                *entry -= place * w;
            }
            plane
        };
        let [a, b] = [plane(x, right / (half * width)), plane(y, above / (half * height))];
        let ([ax, ay, az, a_rest], [bx, by, bz, b_rest]) = (a, b);
        let (across, up) = ([ax, ay, az], [bx, by, bz]);
        let [wx, wy, wz, _] = w;
        let line = cross(across, up);
        let ahead = dot([wx, wy, wz], line);
        let way = line.map(|v| select(ahead > T::ZERO, v, -v));
        let start = match self.point() {
            Some(centre) => centre,
            None => {
                // The point of the line nearest to the eye.
                let square = dot(line, line);
                let to = along(cross(up, line).map(|v| -(a_rest * v)), -b_rest, cross(line, across));
                let [x, y, z] = along(self.eye, T::ONE / square, to);
                Ecef::new(x, y, z).ok()?
            }
        };
        Ray::new(start, way).ok()
    }

    /// Returns whether any part of a box may be in the picture (frustum culling).
    ///
    /// The answer is `true` if some slice of the box along its third axis is not entirely behind the eye or
    /// entirely beyond one side of the view. It is never `false` for a box that is partly in the picture; for
    /// a box outside the picture it may be `true`.
    #[doc(alias = "frustum culling")]
    #[doc(alias = "view culling")]
    #[must_use]
    #[inline]
    pub fn sees(&self, bounds: &OrientedBox<T>) -> bool {
        self.slices(bounds, T::ONE).is_some()
    }

    /// Returns the range of slices of a box, from −1 to 1 along its third axis, that are not entirely beyond
    /// one side of the view. Each slice is taken `size` times as wide and high as the box. Returns `None` if
    /// there is no such slice.
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
        // The scale of the rounding error of `inside`.
        let [x, y, w] = self.rows.map(|[a, b, c, d]| {
            let [x, y, z] = way.map(T::abs);
            dot([a.abs(), b.abs(), c.abs()], [x, y, z]) + d.abs()
        });
        let rest = [w, w + x, w + x, w + y, w + y];
        let few = T::of(8.0) * T::EPSILON;
        let (mut low, mut high) = (-T::ONE - few, T::ONE + few);
        let sides = inside.into_iter().zip(rest).zip(across).zip(along).zip(rise);
        for ((((inside, rest), across), along), rise) in sides {
            // How far the corner of the middle slice that is farthest inside this side of the view is inside
            // it.
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

    /// x, y and w of a point relative to the eye (`one` = 1), or of a vector (`one` = 0).
    #[inline(always)]
    pub(super) fn clip(&self, [x, y, z]: [T; 3], one: T) -> [T; 3] {
        self.rows.map(|[a, b, c, d]| dot([a, b, c], [x, y, z]) + d * one)
    }

    /// The centre of projection relative to the eye in homogeneous coordinates: the vector times its weight,
    /// and the weight. The weight is 0 for a parallel projection; all four numbers are 0 if there is no
    /// centre.
    ///
    /// It is where all three rows are 0: its coordinates are the determinants of three columns each.
    #[inline]
    pub(super) fn centre(&self) -> ([T; 3], T) {
        // Rows are scaled to avoid underflow of products; the scale of a row does not change the centre.
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

    /// The centre of projection, in metres; `None` for a parallel projection.
    #[inline]
    pub(super) fn point(&self) -> Option<Ecef<T>> {
        let (way, weight) = self.centre();
        let [x, y, z] = along(self.eye, T::ONE, way.map(|v| v / weight));
        let point = Ecef::within(x, y, z);
        (x.is_finite() & y.is_finite() & z.is_finite()).then_some(point)
    }

    /// The rows of the matrix for x, y and w, and half of the picture's width and height in pixels.
    #[inline(always)]
    pub(super) fn rows(&self) -> ([[T; 4]; 3], [T; 2]) {
        (self.rows, self.pixels.map(|count| T::of(0.5) * count))
    }

    /// The position in the picture of clip coordinates, in pixels from the middle.
    #[inline(always)]
    pub(super) fn on_picture(&self, [x, y, w]: [T; 3]) -> [T; 2] {
        let [width, height] = self.pixels;
        let half = T::of(0.5);
        [x / w * (half * width), y / w * (half * height)]
    }
}

/// How far x, y and w are in front of the eye, and inside each of the four sides of the view.
#[inline(always)]
fn insides<T: Real>([x, y, w]: [T; 3]) -> [T; 5] {
    [w, w + x, w - x, w + y, w - y]
}

/// The error of [`Camera::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum InvalidCamera<T> {
    /// An element of the matrix is infinite or NaN.
    Matrix(T),
    /// The width or height in pixels is not positive and finite.
    Pixels(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidCamera<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Matrix(entry) => write!(f, "expected a matrix of finite numbers, got {entry:?}"),
            Self::Pixels(count) => write!(f, "expected a positive, finite size in pixels, got {count:?}"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidCamera<T> {}
