use crate::Real;
use crate::math::{atan2_degrees, min, select};

/// The derivative of the point on the ground with respect to the coordinates of a face: how far a step of x
/// and a step of y lead to the east and to the north, in metres per unit.
///
/// It comes from [`Ground::jacobian`](super::Ground::jacobian) or
/// [`Ground::differences`](super::Ground::differences).
///
/// ```
/// use terrella::distortion::Jacobian;
/// // A step of x leads 3 m to the east, one of y 2 m to the north and 1 m to the east.
/// let texel = Jacobian { by_x: [3.0_f64, 0.0], by_y: [1.0, 2.0] };
/// assert_eq!(texel.area(), 6.0);
/// assert_eq!(texel.sides(), 3.0 * 5.0_f64.sqrt());
/// assert!((texel.grid_angle() - 63.434_948_822_922_01).abs() < 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Jacobian<T> {
    /// The derivative with respect to x: metres to the east and to the north, per unit of x.
    pub by_x: [T; 2],
    /// The derivative with respect to y: metres to the east and to the north, per unit of y.
    pub by_y: [T; 2],
}

impl<T: Real> Jacobian<T> {
    /// Creates it from derivatives along Earth axes at a point with this outward normal. At a pole, north is
    /// the direction away from longitude 0.
    #[inline(always)]
    pub(super) fn in_tangent_plane([x, y, z]: [T; 3], slopes: [[T; 3]; 2]) -> Self {
        let axial = (x * x + y * y).sqrt();
        let polar = axial == T::ZERO;
        let axial = select(polar, T::ONE, axial);
        let (cos, sin) = (select(polar, T::ONE, x / axial), select(polar, T::ZERO, y / axial));
        let [by_x, by_y] = slopes.map(|[a, b, c]| {
            let outward = a * cos + b * sin;
            [b * cos - a * sin, c * axial - outward * z]
        });
        Self { by_x, by_y }
    }

    /// Returns Λx: the length on the ground of a step of x, in metres per unit.
    #[must_use]
    #[inline(always)]
    pub fn width(&self) -> T {
        length(self.by_x)
    }

    /// Returns Λy: the length on the ground of a step of y, in metres per unit.
    #[must_use]
    #[inline(always)]
    pub fn height(&self) -> T {
        length(self.by_y)
    }

    /// Returns the aspect ratio δ_aspect = Λx/Λy.
    #[must_use]
    #[inline(always)]
    pub fn aspect(&self) -> T {
        self.width() / self.height()
    }

    /// Returns Λx·Λy, the product of a texel's sides, in square metres per unit of x and of y.
    ///
    /// Divided by [`Ground::central_texel`](super::Ground::central_texel) it is the paper's δ_area. It
    /// ignores that the grid lines may not be perpendicular; [`area`](Self::area) takes that into account.
    #[must_use]
    #[inline(always)]
    pub fn sides(&self) -> T {
        self.width() * self.height()
    }

    /// Returns the area on the ground (the determinant), in square metres per unit of x and of y.
    #[doc(alias = "determinant")]
    #[must_use]
    #[inline(always)]
    pub fn area(&self) -> T {
        let [a, b] = self.by_x;
        let [c, d] = self.by_y;
        a * d - b * c
    }

    /// Returns the angle on the ground between the directions of x and y, in degrees, in [0, 180].
    #[must_use]
    #[inline]
    pub fn grid_angle(&self) -> T {
        let [a, b] = self.by_x;
        let [c, d] = self.by_y;
        atan2_degrees(self.area().abs(), a * c + b * d)
    }

    /// Returns Tissot's ω, the maximum angular deformation: the largest change of an angle between two
    /// directions, in degrees, in [0, 180].
    ///
    /// sin(ω/2) = (a − b)/(a + b) for the semi-axes a and b of Tissot's indicatrix. The formula used does not
    /// subtract a and b, so a conformal map has 0 within rounding.
    #[doc(alias = "angular distortion")]
    #[doc(alias = "maximum angular deformation")]
    #[must_use]
    #[inline(always)]
    pub fn deformation(&self) -> T {
        let sine = self.sine();
        T::of(2.0) * atan2_degrees(sine, ((T::ONE - sine) * (T::ONE + sine)).sqrt())
    }

    /// Returns a/b, the ratio of the semi-axes of Tissot's indicatrix: the largest scale divided by the
    /// smallest, at least 1.
    ///
    /// It is D_I, the isotropy distortion of Lambers (2019). It is 1 where angles are true.
    #[doc(alias = "anisotropy")]
    #[must_use]
    #[inline(always)]
    pub fn isotropy(&self) -> T {
        let sine = self.sine();
        (T::ONE + sine) / (T::ONE - sine)
    }

    /// sin(ω/2) = (a − b)/(a + b), at most 1.
    #[inline(always)]
    fn sine(&self) -> T {
        // For the ellipse that by_x and by_y span, with semi-axes p ≥ q: the root below is p² − q², and `sum`
        // is (p + q)².
        let [a, b] = self.by_x;
        let [c, d] = self.by_y;
        let two = T::of(2.0);
        let (slant, stretch) = (two * (a * c + b * d), (a * a + b * b) - (c * c + d * d));
        let sum = (a * a + b * b) + (c * c + d * d) + two * self.area().abs();
        min((slant * slant + stretch * stretch).sqrt() / sum, T::ONE)
    }

    /// Returns the smallest and the largest length on the ground of a unit step in any direction of the face
    /// (the singular values), in metres per unit.
    #[doc(alias = "singular values")]
    #[must_use]
    #[inline]
    pub fn extremes(&self) -> [T; 2] {
        let [a, b] = self.by_x;
        let [c, d] = self.by_y;
        // Half of the sum and half of the difference of the singular values.
        let half = T::of(0.5);
        let sum = half * length([a + d, b - c]);
        let difference = half * length([a - d, b + c]);
        [(sum - difference).abs(), sum + difference]
    }
}

/// Whether a derivative with this area is invertible.
#[inline(always)]
pub(super) fn is_regular<T: Real>(area: T) -> bool {
    (area > T::ZERO) & area.is_finite()
}

#[inline(always)]
fn length<T: Real>([a, b]: [T; 2]) -> T {
    (a * a + b * b).sqrt()
}
