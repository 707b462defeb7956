//! Dual numbers: the kernels' slopes against their known derivatives, signs of zero, second derivatives.

use terrella::math::{atan, atan2, atan2_degrees, cbrt, exp_m1, log2, sin_cos, sin_cos_degrees, tan};
use terrella::{Dual, Real};
use testkit::maximum;

fn slope(f: impl Fn(Dual<f64, 1>) -> Dual<f64, 1>, x: f64) -> f64 {
    let [x] = Dual::variables([x]);
    let [slope] = f(x).slopes();
    slope
}

fn near(a: f64, b: f64, what: &str) {
    assert!(
        (a - b).abs() <= 4e-15 * maximum(b.abs(), 1.0),
        "{what}: {a:e} is not {b:e}"
    );
}

#[test]
fn kernels_have_their_derivatives() {
    let mut random = fastrand::Rng::with_seed(7);
    for _ in 0..20_000 {
        let x = random.f64() * 20.0 - 10.0;
        near(slope(|x| sin_cos(x).0, x), x.cos(), "sin");
        near(slope(|x| sin_cos(x).1, x), -x.sin(), "cos");
        let degrees = x * 100.0;
        let radians = degrees.to_radians();
        near(
            slope(|x| sin_cos_degrees(x).0, degrees),
            radians.cos().to_radians(),
            "sin of degrees",
        );
        near(
            slope(|x| sin_cos_degrees(x).1, degrees),
            -radians.sin().to_radians(),
            "cos of degrees",
        );
        near(slope(atan, x), 1.0 / (1.0 + x * x), "atan");
        let y = random.f64() * 20.0 - 10.0;
        let square = x * x + y * y;
        near(slope(|x| atan2(Dual::constant(y), x), x), -y / square, "atan2 by x");
        near(slope(|y| atan2(y, Dual::constant(x)), y), x / square, "atan2 by y");
        near(
            slope(|y| atan2_degrees(y, Dual::constant(x)), y),
            (x / square).to_degrees(),
            "atan2 in degrees",
        );
        let small = x * 0.078;
        near(slope(tan, small), 1.0 + small.tan().powi(2), "tan");
        near(slope(cbrt, x), 1.0 / (3.0 * x.cbrt().powi(2)), "cbrt");
        let positive = x.abs();
        near(slope(Real::sqrt, positive), 0.5 / positive.sqrt(), "sqrt");
        near(slope(log2, positive), std::f64::consts::LOG2_E / positive, "log2");
        near(slope(exp_m1, -positive), (-positive).exp(), "exp_m1");
        near(slope(|x| x % Dual::of(0.75), x), 1.0, "remainder");
        near(
            slope(|x| Dual::of(7.5) % x, positive),
            -(7.5 / positive).trunc(),
            "remainder by the divisor",
        );
    }
}

#[test]
fn values_are_those_of_the_plain_scalar() {
    let mut random = fastrand::Rng::with_seed(8);
    for _ in 0..20_000 {
        let (x, y) = (random.f64() * 200.0 - 100.0, random.f64() * 200.0 - 100.0);
        let [dx, dy] = Dual::variables([x, y]);
        assert_eq!(sin_cos(dx).0.value().to_bits(), sin_cos(x).0.to_bits());
        assert_eq!(atan2(dy, dx).value().to_bits(), atan2(y, x).to_bits());
        assert_eq!((dx / dy).value().to_bits(), (x / y).to_bits());
        assert_eq!((dx % dy).value().to_bits(), (x % y).to_bits());
        assert_eq!(f64::from(dx), x);
    }
}

#[test]
fn signs_of_zero_keep_their_side() {
    let [zero] = Dual::variables([0.0_f64]);
    let [below] = Dual::variables([-0.0_f64]);
    assert_eq!(zero.abs().slopes(), [1.0]);
    assert_eq!(below.abs().slopes(), [-1.0]);
    assert_eq!(zero.copysign(below).slopes(), [-1.0]);
    assert_eq!(atan(below).slopes(), [1.0]);
    assert!(atan(below).value().is_sign_negative());
}

#[test]
fn a_dual_of_a_dual_has_second_derivatives() {
    // The Hessian of atan2(y, x).
    let (x, y) = (3.0_f64, 4.0_f64);
    let [inner_y, inner_x] = Dual::variables([y, x]);
    let [dy, dx] = Dual::variables([inner_y, inner_x]);
    let [by_y, by_x] = atan2(dy, dx).slopes();
    let square = (x * x + y * y).powi(2);
    let expected = [[-2.0 * x * y, y * y - x * x], [y * y - x * x, 2.0 * x * y]];
    for (row, expected) in [by_y, by_x].into_iter().zip(expected) {
        for (second, expected) in row.slopes().into_iter().zip(expected) {
            near(second, expected / square, "second derivative");
        }
    }
}

#[test]
fn it_shows_itself() {
    let [x, _] = Dual::variables([1.5_f32, 2.0]);
    assert_eq!(format!("{x:.2}"), "1.50 (1.00, 0.00)");
    assert_eq!(Dual::<f64, 2>::default(), Dual::ZERO);
}
