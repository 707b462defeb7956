//! Both problems in straight lines, on an ellipsoid about as flat as the Earth.
//!
//! Every geodesic is a great circle on Bessel's auxiliary sphere, between the parametric latitudes; distance and longitude follow from its
//! arc σ by two integrals.
//!
//! Symbols and series as in C. F. F. Karney, *Algorithms for geodesics*, J. Geodesy 87 (2013). The middle of the arc, σₘ, counts from
//! the node; sums over sines run as Σ 2cₗ cos 2lσₘ sin lσ, so that nothing cancels between neighbours.

use super::karney::Series;
use crate::math::{Polynomial, halves, sin_cos_quarter};
use crate::{Ellipsoid, Real};

mod direct;
mod inverse;

pub(super) use direct::Start;
pub(super) use inverse::{Arc, Ends, Line};

/// An ellipsoid as the straight lines need it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Ordinary<T> {
    b: T,
    f: T,
    axes: T,
    /// ε/cos²α₀ by powers of cos²α₀.
    epsilon: [T; 7],
    /// A₃ by powers of ε.
    a3: [T; 5],
    /// 2A₃C₃ₗ/ε^l by powers of ε, l = 1, 2, 3, 4, one row after the other.
    c3: [T; 10],
}

/// The answer of a straight line, and whether it is one.
type Answer<A> = (A, bool);

/// ε/k² = 1/(1 + √(1 + k²))² by powers of k².
const EPSILON: Polynomial<7, 7> = Polynomial::rounded([
    1.0 / 4.0,
    -1.0 / 8.0,
    5.0 / 64.0,
    -7.0 / 128.0,
    21.0 / 512.0,
    -33.0 / 1024.0,
    429.0 / 16384.0,
]);

/// c₀ + c₁x + … of the first coefficients.
#[inline(always)]
fn series<T: Real>(x: T, coefficients: &[T], terms: usize) -> T {
    halves(x, terms, |i| coefficients.get(i).copied().unwrap_or(T::ZERO))
}

impl<T: Real> Ordinary<T> {
    /// From the ellipsoid and the series of its longitude.
    pub fn new(ellipsoid: Ellipsoid<T>, series: &Series<T>) -> Self {
        let (a3, c3) = series.low_orders();
        let ep2 = ellipsoid.ep2();
        let f = ellipsoid.f();
        // k² = e'² cos²α₀.
        let mut power = T::ONE;
        let epsilon = T::all(&EPSILON).map(|c| {
            power *= ep2;
            power * c
        });
        Self {
            b: ellipsoid.b(),
            f,
            axes: T::ONE - f,
            epsilon,
            a3,
            c3: c3.map(|c| c + c),
        }
    }

    /// Whether errors are those of rounding on this ellipsoid, not of the series.
    #[inline(always)]
    pub fn exact(&self) -> bool {
        // Room for the rounding of 1/150.
        self.f.abs() < T::of(1.0 / 149.0)
    }

    /// Whether a distance is at most 50 polar radii.
    #[inline(always)]
    pub fn reaches(&self, distance: T) -> bool {
        distance.abs() <= T::of(50.0) * self.b
    }

    /// A₃, and I₃ less A₃σ between the ends.
    #[cfg_attr(not(small), inline(always))]
    fn i3(&self, epsilon: T, [w1, w2, w3, w4, _]: [T; 5]) -> (T, T) {
        let [c11, c12, c13, c14, c22, c23, c24, c33, c34, c44] = self.c3;
        let sum = if T::terms(4, 2) == 4 {
            ((c44 * w4 + (c33 + epsilon * c34) * w3) + (c22 + epsilon * (c23 + epsilon * c24)) * w2)
                + (c11 + epsilon * (c12 + epsilon * (c13 + epsilon * c14))) * w1
        } else {
            (c11 + epsilon * c12) * w1
        };
        (series(epsilon, &self.a3, T::terms(5, 3)), sum)
    }
}

/// Sine and cosine of the parametric latitude, and 1/√(cos²φ + (1 − f)² sin²φ).
#[cfg_attr(not(small), inline(always))]
fn parametric<T: Real>(lat: T, axes: T) -> ((T, T), T) {
    let (sin, cos) = sin_cos_quarter(lat.abs());
    let sin = (sin * axes).copysign(lat);
    let inverse = T::ONE / (sin * sin + cos * cos).sqrt();
    ((sin * inverse, cos * inverse), inverse)
}

/// ε^l cos lμ sin lσ, l = 1, 2, …, from ε cos μ.
#[cfg_attr(not(small), inline(always))]
fn waves<T: Real>(epsilon: T, middle: T, (sin, cos): (T, T)) -> [T; 5] {
    let square = epsilon * epsilon;
    let (twice, twice_middle) = (cos + cos, middle + middle);
    let (s2, m2) = (twice * sin, twice_middle * middle - square);
    if T::terms(5, 2) == 2 {
        return [middle * sin, m2 * s2, T::ZERO, T::ZERO, T::ZERO];
    }
    let (s3, m3) = (twice * s2 - sin, twice_middle * m2 - square * middle);
    let (s4, m4) = (twice * s3 - s2, twice_middle * m3 - square * m2);
    let (s5, m5) = (twice * s4 - s3, twice_middle * m4 - square * m3);
    [middle * sin, m2 * s2, m3 * s3, m4 * s4, m5 * s5]
}

/// Sine and cosine of an angle, given so, and a small one in radians, below 0.03.
#[inline(always)]
pub(super) fn grow<T: Real>((sin, cos): (T, T), by: T) -> (T, T) {
    let of = T::of;
    let square = by * by;
    let (small_sin, small_versine) = if T::terms(3, 2) == 3 {
        (
            by - by * square * (of(1.0 / 6.0) - of(1.0 / 120.0) * square),
            square * (of(0.5) - square * (of(1.0 / 24.0) - of(1.0 / 720.0) * square)),
        )
    } else {
        (by - by * square * of(1.0 / 6.0), square * of(0.5))
    };
    (
        sin + (cos * small_sin - sin * small_versine),
        cos - (sin * small_sin + cos * small_versine),
    )
}
