//! Vectors of three components, so exactly that the errors of `f64` show.

use crate::Worst;

/// a·b − c·d to within two roundings of the result (Kahan).
fn difference_of_products(a: f64, b: f64, c: f64, d: f64) -> f64 {
    let product = c * d;
    let lost = c.mul_add(-d, product);
    a.mul_add(b, -product) + lost
}

/// The length of a × b.
pub fn cross([ax, ay, az]: [f64; 3], [bx, by, bz]: [f64; 3]) -> f64 {
    let x = difference_of_products(ay, bz, az, by);
    let y = difference_of_products(az, bx, ax, bz);
    let z = difference_of_products(ax, by, ay, bx);
    length([x, y, z])
}

pub fn length(v: [f64; 3]) -> f64 {
    v.iter().map(|c| c * c).sum::<f64>().sqrt()
}

/// |v|² − 1 without rounding that counts.
pub fn excess(v: [f64; 3]) -> f64 {
    let (mut sum, mut low) = (-1.0, 0.0);
    for c in v {
        let square = c * c;
        low += c.mul_add(c, -square);
        let next = sum + square;
        let part = next - sum;
        low += (sum - (next - part)) + (square - part);
        sum = next;
    }
    sum + low
}

/// The angle between two vectors in radians, if it is small; else 4.
pub fn angle(a: [f64; 3], b: [f64; 3]) -> f64 {
    let product: f64 = (0..3).map(|i| a[i] * b[i]).sum();
    if product > 0.0 {
        cross(a, b) / (length(a) * length(b))
    } else {
        4.0
    }
}

/// The largest difference of a component.
pub fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    Worst::of((0..3).map(|i| (a[i] - b[i]).abs()))
}
