//! Numbers of twice the digits of `f64`: sums of two, the second below half an ulp of the first (Dekker 1971).

use core::ops::{Add, Div, Mul, Neg, Sub};

#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Double {
    pub high: f64,
    pub low: f64,
}

pub const PI: Double = Double {
    high: core::f64::consts::PI,
    low: 1.224_646_799_147_353_2e-16,
};

pub const fn of(value: f64) -> Double {
    Double { high: value, low: 0.0 }
}

/// a + b, rounded, and what that lost (Knuth).
fn sum(a: f64, b: f64) -> Double {
    let high = a + b;
    let part = high - a;
    let low = (a - (high - part)) + (b - part);
    Double { high, low }
}

impl Add for Double {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let (high, low) = (sum(self.high, other.high), sum(self.low, other.low));
        let first = sum(high.high, high.low + low.high);
        sum(first.high, first.low + low.low)
    }
}

impl Neg for Double {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for Double {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Double {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let product = self.high * other.high;
        let lost = self.high.mul_add(other.high, -product);
        sum(product, lost + (self.high * other.low + self.low * other.high))
    }
}

impl Div for Double {
    type Output = Self;
    fn div(self, by: Self) -> Self {
        let digits = |rest: Self| rest.high / by.high;
        let first = digits(self);
        let rest = self - by * of(first);
        let second = digits(rest);
        let third = digits(rest - by * of(second));
        sum(first, second) + of(third)
    }
}

impl Double {
    pub fn abs(self) -> Self {
        if self.high < 0.0 { -self } else { self }
    }

    pub fn sqrt(self) -> Self {
        if self.high == 0.0 {
            return self;
        }
        let root = of(self.high.sqrt());
        // One step of Newton's method doubles the digits.
        root + of((self - root * root).high / (2.0 * root.high))
    }

    /// Sine and cosine of an angle of at most 1, by their series.
    pub fn sin_cos(self) -> (Self, Self) {
        let (mut sin, mut cos, mut term) = (self, of(1.0), self);
        for n in 2..32 {
            term = term * self / of(f64::from(n));
            let signed = if n % 4 < 2 { term } else { -term };
            if n % 2 == 0 {
                cos = cos + signed
            } else {
                sin = sin + signed
            }
        }
        (sin, cos)
    }

    pub fn tan(self) -> Self {
        let (sin, cos) = self.sin_cos();
        sin / cos
    }
}

/// Sine and cosine of an angle in degrees.
pub fn sin_cos_degrees(degrees: f64) -> (Double, Double) {
    let quarters = (degrees / 90.0).round();
    let rest = degrees - 90.0 * quarters;
    let (sin, cos) = (of(rest) * PI / of(180.0)).sin_cos();
    match quarters.rem_euclid(4.0) as u8 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}
