use super::{CubeProjection, Face, normalise};
use crate::Real;
use crate::math::{CONFORMAL_TO_PLANE, CONFORMAL_TO_SPHERE, Complex, INVERSE_I, cbrt, max, select};

/// The conformal cube of Rančić, Purser & Mesinger (1996): no angular deformation but at the corners, where the scale goes to 0.
///
/// About the nearest corner, with w the stereographic coordinate of the sphere (the next corner at 1) and z the face's (its edge as
/// unit), z⁴ = K·W·S(W)⁴ with W = w³. Series of 28 terms this way, and of 20 the other way.
///
/// Near a corner z goes with the ¾th power of the distance on the sphere: an error of one rounding there, 1.1e-16 rad, is 1e-12 in
/// x and y. That is the map's own conditioning.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Conformal;

const SQRT_3: f64 = 1.732_050_807_568_877_2;

impl CubeProjection for Conformal {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let steep = up.abs() > right.abs();
        let major = select(steep, up, right).abs();
        let minor = select(steep, right, up).abs();
        // Stereographic projection about the corner (1, 1, 1)/√3; the differences are exact near it.
        let length = (minor * minor + major * major + outward * outward).sqrt();
        let third = T::of(1.0 / SQRT_3);
        let height = length + (minor + major + outward) * third;
        let w = Complex {
            re: ((major - minor) + (outward - minor)) * third / height,
            im: (outward - major) / height,
        };
        let cube = w * w * w;
        let root = w.sqrt();
        // w^¾ by two square roots, of arguments up to 60° and 90°.
        let z = (w * root).sqrt() * cube.polynomial(&CONFORMAL_TO_PLANE) * T::of(INVERSE_I);
        let two = T::of(2.0);
        let (long, short) = (T::ONE - two * z.im, T::ONE - two * z.re);
        let [x, y] = select(steep, [short, long], [long, short]);
        [x.copysign(right), y.copysign(up)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let steep = y.abs() > x.abs();
        let half = T::of(0.5);
        let z = Complex {
            re: half * (T::ONE - select(steep, x, y).abs()),
            im: half * (T::ONE - select(steep, y, x).abs()),
        };
        let square = z * z;
        let w = z * cube_root(z) * (square * square).polynomial(&CONFORMAL_TO_SPHERE);
        let two = T::of(2.0);
        let center = two - (w.re * w.re + w.im * w.im);
        let slant = T::of(2.0 * SQRT_3) * w.im;
        let minor = center - T::of(4.0) * w.re;
        let edge = center + two * w.re;
        let [right, up] = select(steep, [minor, edge - slant], [edge - slant, minor]);
        normalise([right.copysign(x), up.copysign(y), edge + slant])
    }
}

/// The cube root of z, 0 ≤ arg z ≤ 45°, |z| < 1.
#[inline(always)]
fn cube_root<T: Real>(z: Complex<T>) -> Complex<T> {
    // A corner's own z = 0 takes any root: the caller multiplies it by z.
    let tiny = T::pick(1e-300, 1e-36);
    let re = max(z.re, tiny);
    let t = z.im / re;
    let one = Complex { re: T::ONE, im: t };
    // (1 + it)^⅓ within 1e-3, then Halley's iteration.
    let mut root = Complex {
        re: T::ONE + t * t * T::of(0.11 - 0.025 * 1.0),
        im: t * (T::of(1.0 / 3.0) - T::of(0.051) * t * t),
    };
    for _ in 0..T::terms(3, 2) {
        let cube = root * root * root;
        root = root + root * ((one - cube) / (cube + cube + one));
    }
    root * cbrt(re)
}
