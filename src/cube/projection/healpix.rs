use core::f64::consts::FRAC_PI_4;

use super::{CubeProjection, Face};
use crate::math::{atan, select, tan};
use crate::{Direction, Real};

/// HEALPix on a cube: equal-area, side faces for |sin φ| < ⅔ and polar faces of four triangles.
///
/// Górski et al. (2005), arranged as in Dimitrijević, Lambers & Rančić (2016) §4.7; the polar triangles are centred on
/// longitudes 0°, 90°, 180°, 270°. The side faces are Lambert's cylindrical equal-area projection.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Healpix;

/// 4/π·atan t for |t| ≤ 1, exact at ±1.
#[inline(always)]
fn share<T: Real>(t: T) -> T {
    atan(t) / T::of(FRAC_PI_4)
}

/// tan(πx/4), exact at ±1.
#[inline(always)]
fn ratio<T: Real>(x: T) -> T {
    let quarter = T::of(FRAC_PI_4);
    tan(x * quarter) / tan(quarter)
}

impl CubeProjection for Healpix {
    #[inline(always)]
    fn face<T: Real>(&self, direction: Direction<T>) -> Face {
        let [x, y, z] = direction.to_array();
        select(
            T::of(3.0) * z.abs() < T::of(2.0),
            Face::equatorial(x, y),
            Face::polar(z),
        )
    }

    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let polar = face.is_polar();
        let length = (right * right + up * up + outward * outward).sqrt();
        // Within the quarter of longitude: on a side face from its centre, on a polar one from the triangle's.
        let steep = polar & (up.abs() > right.abs());
        let major = select(polar, select(steep, up, right), outward);
        let minor = select(steep | !polar, right, up);
        let t = minor / select(major == T::ZERO, T::ONE, major);
        let longitude = share(t);
        // √(3(1 − z)) without the difference.
        let sigma = major * (T::of(3.0) * (T::ONE + t * t) / (length * (length + outward))).sqrt();
        let side = [longitude, T::of(1.5) * up / length];
        let cap = select(steep, [sigma * longitude, sigma], [sigma, sigma * longitude]);
        select(polar, cap, side)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, face: Face, [x, y]: [T; 2]) -> [T; 3] {
        let polar = face.is_polar();
        let steep = y.abs() > x.abs();
        let sigma = select(steep, y, x);
        let along = select(steep, x, y) / select(sigma == T::ZERO, T::ONE, sigma);
        let t = ratio(select(polar, along, x));
        let cosine = T::ONE / (T::ONE + t * t).sqrt();

        let height = y * T::of(2.0 / 3.0);
        let radius = (T::ONE - height * height).sqrt() * cosine;
        let side = [t * radius, height, radius];

        let square = sigma * sigma;
        let major = sigma * (T::of(6.0) - square).sqrt() * T::of(1.0 / 3.0) * cosine;
        let minor = t * major;
        let outward = T::ONE - square * T::of(1.0 / 3.0);
        let [right, up] = select(steep, [minor, major], [major, minor]);
        select(polar, [right, up, outward], side)
    }
}
