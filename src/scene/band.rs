//! What the bounds take of a scene's latitudes, from `+ − × ÷` alone: constant functions have no others.

use crate::Ellipsoid;

pub(super) const DEGREE: f64 = core::f64::consts::PI / 180.0;

/// Latitudes, in degrees.
#[derive(Clone, Copy)]
pub(super) struct Band {
    /// The farthest from the equator and the nearest to it, not negative.
    pub steepest: f64,
    pub flattest: f64,
    pub middle: f64,
    /// Half of the width, in radians.
    pub half: f64,
}

impl Band {
    pub const fn new([south, north]: [f64; 2]) -> Self {
        let straddles = south <= 0.0 && north >= 0.0;
        Self {
            steepest: south.abs().max(north.abs()),
            flattest: if straddles { 0.0 } else { south.abs().min(north.abs()) },
            middle: 0.5 * (south + north),
            half: 0.5 * (north - south) * DEGREE,
        }
    }

    /// Not less than the square of the tangent of the farthest latitude; infinite at a pole.
    pub const fn tan2(self) -> f64 {
        let cos = cos(self.steepest);
        1.0 / (cos * cos) - 1.0
    }
}

/// The cosine of a latitude of 0 to 90 degrees, up to 6·10⁻⁸ too small: six terms of the sine of what lacks to 90.
pub(super) const fn cos(lat: f64) -> f64 {
    let x = (90.0 - lat) * DEGREE;
    let x2 = x * x;
    x * (1.0 - x2 / 6.0 * (1.0 - x2 / 20.0 * (1.0 - x2 / 42.0 * (1.0 - x2 / 72.0 * (1.0 - x2 / 110.0)))))
}

/// The square root of a number that is not negative, within a few ulps: Heron's from half of the exponent.
pub(super) const fn root(x: f64) -> f64 {
    if !x.is_finite() || x < f64::MIN_POSITIVE {
        return if x < f64::MIN_POSITIVE { 0.0 } else { x };
    }
    let mut y = f64::from_bits((x.to_bits() >> 1) + (1023 << 51));
    let mut step = 0;
    while step < 5 {
        y = 0.5 * (y + x / y);
        step += 1;
    }
    y
}

/// √(x² + y²).
pub(super) const fn hypot(x: f64, y: f64) -> f64 {
    root(x * x + y * y)
}

/// The radii of curvature M and N at a latitude of 0 to 90 degrees, in metres.
pub(super) const fn radii(ellipsoid: Ellipsoid<f64>, lat: f64) -> [f64; 2] {
    let e2 = ellipsoid.f() * (2.0 - ellipsoid.f());
    let c = cos(lat);
    let w2 = 1.0 - e2 * (1.0 - c * c);
    let n = ellipsoid.a() / root(w2);
    [n * (1.0 - e2) / w2, n]
}

/// The distance between neighbours of a number of degrees in single precision, 2⁻²³ of the power of two at or below it.
pub(super) const fn ulp(degrees: f64) -> f64 {
    f64::from_bits(degrees.to_bits() & 0x7ff0_0000_0000_0000) * f32::EPSILON as f64
}
