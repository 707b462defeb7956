//! What the bounds take of a scene's latitudes, from `+ − × ÷` alone: constant functions have no others.

use crate::Ellipsoid;

pub(super) const DEGREE: f64 = core::f64::consts::PI / 180.0;

/// A latitude of 0 to 90 degrees. Sine and cosine are up to 6·10⁻⁸ too small.
#[derive(Clone, Copy)]
pub(super) struct Parallel {
    pub degrees: f64,
    pub sin: f64,
    pub cos: f64,
}

/// The latitudes of a scene.
#[derive(Clone, Copy)]
pub(super) struct Band {
    /// The farthest from the equator and the nearest to it.
    pub steepest: Parallel,
    pub flattest: Parallel,
    /// Half of the width, in radians.
    pub half: f64,
}

impl Band {
    pub const fn new([south, north]: [f64; 2]) -> Self {
        let straddles = south <= 0.0 && north >= 0.0;
        let flattest = if straddles { 0.0 } else { south.abs().min(north.abs()) };
        Self {
            steepest: Parallel::new(south.abs().max(north.abs())),
            flattest: Parallel::new(flattest),
            half: 0.5 * (north - south) * DEGREE,
        }
    }

    /// Not less than the tangent of the farthest latitude; infinite at a pole.
    pub const fn tan(self) -> f64 {
        (self.steepest.sin + 1e-7) / self.steepest.cos
    }
}

impl Parallel {
    pub const fn new(degrees: f64) -> Self {
        Self {
            degrees,
            sin: sine(degrees * DEGREE),
            cos: sine((90.0 - degrees) * DEGREE),
        }
    }

    /// e² sin²φ.
    const fn squeeze(self, ellipsoid: Ellipsoid<f64>) -> f64 {
        e2(ellipsoid) * self.sin * self.sin
    }

    /// The radius of curvature across the meridian, N, in metres.
    pub const fn across(self, ellipsoid: Ellipsoid<f64>) -> f64 {
        ellipsoid.a() * inverse_root(self.squeeze(ellipsoid))
    }

    /// The radius of curvature along the meridian, M, in metres.
    pub const fn along(self, ellipsoid: Ellipsoid<f64>) -> f64 {
        let n = inverse_root(self.squeeze(ellipsoid));
        ellipsoid.a() * (1.0 - e2(ellipsoid)) * n * n * n
    }

    /// From the centre to the tangent plane, in metres.
    pub const fn support(self, ellipsoid: Ellipsoid<f64>) -> f64 {
        let x = self.squeeze(ellipsoid);
        ellipsoid.a() * (1.0 - x) * inverse_root(x)
    }

    /// From the centre to the place, in metres.
    pub const fn radius(self, ellipsoid: Ellipsoid<f64>) -> f64 {
        let x = self.squeeze(ellipsoid);
        let y = x * (1.0 - e2(ellipsoid)) / (1.0 - x);
        ellipsoid.a() * (1.0 - y) * inverse_root(y)
    }
}

pub(super) const fn e2(ellipsoid: Ellipsoid<f64>) -> f64 {
    ellipsoid.f() * (2.0 - ellipsoid.f())
}

/// Six terms of the sine on [0, π/2].
const fn sine(x: f64) -> f64 {
    let y = x * x;
    let tail = 1.0 / 362_880.0 - y * (1.0 / 39_916_800.0);
    x * (1.0 - y * (1.0 / 6.0 - y * (1.0 / 120.0 - y * (1.0 / 5040.0 - y * tail))))
}

/// 1/√(1 − x) for x up to 0.02, within 10⁻¹¹: the binomial series.
const fn inverse_root(x: f64) -> f64 {
    1.0 + x * (0.5 + x * (0.375 + x * (0.3125 + x * (35.0 / 128.0 + x * (63.0 / 256.0)))))
}

/// The square root of a number that is not negative, within a few ulps: Heron's from half of the exponent.
pub(super) const fn root(x: f64) -> f64 {
    if !x.is_finite() || x < f64::MIN_POSITIVE {
        return if x < f64::MIN_POSITIVE { 0.0 } else { x };
    }
    let mut y = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    let mut step = 0;
    while step < 4 {
        y = 0.5 * (y + x / y);
        step += 1;
    }
    y
}

/// √(x² + y²), up to 8 % more.
pub(super) const fn hypot(x: f64, y: f64) -> f64 {
    x.max(y) + 0.4143 * x.min(y)
}

/// The distance between neighbours of a number of degrees in single precision, 2⁻²³ of the power of two at or
/// below it.
pub(super) const fn ulp(degrees: f64) -> f64 {
    f64::from_bits(degrees.to_bits() & 0x7ff0_0000_0000_0000) * f32::EPSILON as f64
}
