use crate::Ecef;

/// A point in double precision as the sum of two points in single precision, for a shader that draws fixed
/// vertices seen by a moving camera.
///
/// The sum of the two parts differs from each coordinate by at most 2⁻⁴⁹ of it, or by 2⁻¹²⁵ m where that is
/// larger, for coordinates up to 10³⁸ m. On the Earth's surface that is 6 nm; single precision alone has 0.25
/// m. (Ohlarik, *Precisions, precisions*, 2008.)
///
/// ```
/// use terrella::Ecef;
/// use terrella::terrain::Split;
/// let point = Ecef::new(4_201_987.123_456_789, 173_546.5, -4_780_234.25)?;
/// let split = Split::new(point);
/// assert_eq!(split.high()[0], 4_201_987.0);
/// assert!((split.low()[0] - 0.123_456_789).abs() < 1e-8);
/// let camera = Split::new(Ecef::new(4_201_986.0, 173_546.0, -4_780_234.0)?);
/// let [x, y, z] = split.seen_from(camera);
/// assert!((x - 1.123_456_789).abs() < 1e-7 && (y, z) == (0.5, -0.25));
/// # Ok::<(), terrella::InvalidEcef<f64>>(())
/// ```
#[doc(alias = "emulated double")]
#[doc(alias = "double-single")]
#[doc(alias = "RTE")]
#[doc(alias = "relative-to-eye")]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Split {
    high: [f32; 3],
    low: [f32; 3],
}

impl Split {
    /// Splits a point, in metres.
    #[must_use]
    #[inline(always)]
    pub fn new(point: Ecef<f64>) -> Self {
        let point = point.to_array();
        Self {
            high: point.map(|v| v as f32),
            low: point.map(|v| (v - f64::from(v as f32)) as f32),
        }
    }

    /// Returns the high part: the nearest `f32` of each coordinate, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn high(self) -> [f32; 3] {
        self.high
    }

    /// Returns the low part: the rest of each coordinate, rounded to `f32`, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn low(self) -> [f32; 3] {
        self.low
    }

    /// Returns the point relative to a camera, in metres, computed in single precision: the difference of the
    /// high parts plus the difference of the low parts.
    ///
    /// Each coordinate is within 2⁻²³ of itself, plus 2⁻⁴⁵ of the larger of the two points' coordinates (0.2
    /// µm on the Earth).
    #[must_use]
    #[inline(always)]
    pub fn seen_from(self, camera: Self) -> [f32; 3] {
        let ([hx, hy, hz], [lx, ly, lz]) = (self.high, self.low);
        let ([cx, cy, cz], [dx, dy, dz]) = (camera.high, camera.low);
        [(hx - cx) + (lx - dx), (hy - cy) + (ly - dy), (hz - cz) + (lz - dz)]
    }
}
