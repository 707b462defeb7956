use crate::Real;
use crate::math::{atan2, cbrt, hypot, sin_cos};

/// The positive root κ of κ⁴ + 2κ³ − (x² + y² − 1)κ² − 2y²κ − y² = 0 (Karney 55), by Ferrari's method: the
/// normal to an astroid through the point (x, y).
pub(super) fn astroid<T: Real>(x: T, y: T) -> T {
    let (p, q) = (x * x, y * y);
    let r = (p + q - T::ONE) / T::of(6.0);
    if q == T::ZERO && r <= T::ZERO {
        return T::ZERO; // y = 0 with |x| ≤ 1: the caller keeps away from it
    }
    let s = p * q / T::of(4.0);
    let r2 = r * r;
    let r3 = r * r2;
    let discriminant = s * (s + T::of(2.0) * r3);
    let u = if discriminant >= T::ZERO {
        // The sign of the root that adds to S + r³.
        let t3 = s + r3;
        let root = discriminant.sqrt();
        let t = cbrt(if t3 < T::ZERO { t3 - root } else { t3 + root });
        r + t + if t == T::ZERO { T::ZERO } else { r2 / t }
    } else {
        let angle = atan2((-discriminant).sqrt(), -(s + r3));
        let (_, cos) = sin_cos(angle / T::of(3.0));
        r + T::of(2.0) * r * cos
    };
    let v = hypot(u, y);
    let uv = if u < T::ZERO { q / (v - u) } else { u + v };
    let w = (uv - q) / (T::of(2.0) * v);
    uv / ((uv + w * w).sqrt() + w)
}
