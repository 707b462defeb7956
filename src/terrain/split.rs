use crate::Ecef;

/// A point in double precision as two in single precision: what a shader takes of fixed vertices that a moving camera sees.
///
/// The sum of the two is within 2⁻⁴⁹ of the larger of each coordinate and 2⁻¹²⁵ m, for coordinates up to 10³⁸ m: 6 nm on the Earth's surface, where single precision
/// alone has 0.25 m. (Ohlarik, *Precisions, precisions*, 2008.)
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
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Split {
    high: [f32; 3],
    low: [f32; 3],
}

impl Split {
    /// From a point in metres.
    #[must_use]
    #[inline(always)]
    pub fn new(point: Ecef<f64>) -> Self {
        let point = point.to_array();
        Self {
            high: point.map(|v| v as f32),
            low: point.map(|v| (v - f64::from(v as f32)) as f32),
        }
    }

    /// The nearest numbers of single precision, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn high(self) -> [f32; 3] {
        self.high
    }

    /// What they leave, in metres.
    #[must_use]
    #[inline(always)]
    pub const fn low(self) -> [f32; 3] {
        self.low
    }

    /// From a camera, in metres, in single precision: the difference of the large parts and that of the small ones.
    ///
    /// Each coordinate is within 2⁻²³ of itself and 2⁻⁴⁵ of the larger of the two points' (0.2 µm on the Earth).
    #[must_use]
    #[inline(always)]
    pub fn seen_from(self, camera: Self) -> [f32; 3] {
        let ([hx, hy, hz], [lx, ly, lz]) = (self.high, self.low);
        let ([cx, cy, cz], [dx, dy, dz]) = (camera.high, camera.low);
        [(hx - cx) + (lx - dx), (hy - cy) + (ly - dy), (hz - cz) + (lz - dz)]
    }
}
