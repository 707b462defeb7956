use terrella::math::{self, Polynomial};
use terrella::{Dual, Real};

use crate::{Arguments, Function, Scalar, Visitor};

const COSINE: Polynomial<5, 3> = Polynomial {
    f64: [1.0, -0.5, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40_320.0],
    f32: [1.0, -0.5, 1.0 / 24.0],
};

const THIRDS: Polynomial<4, 4> = Polynomial::rounded([1.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0, 0.125]);

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let unit = Arguments::unit::<T>;
    let two = Arguments::units::<T, 2>;
    visitor.function::<T, _, _>("math::sin_cos", unit, |x| math::sin_cos(x * T::of(90.0)));
    visitor.function::<T, _, _>("math::sin_cos_degrees", unit, |x| {
        math::sin_cos_degrees(x * T::of(720.0))
    });
    visitor.function::<T, _, _>("math::tan", unit, |x| math::tan(x * T::of(0.75)));
    visitor.function::<T, _, _>("math::atan", two, |[x, y]| math::atan(x / y));
    visitor.function::<T, _, _>("math::atan2", two, |[x, y]| math::atan2(y, x));
    visitor.function::<T, _, _>("math::atan2_degrees", two, |[x, y]| math::atan2_degrees(y, x));
    visitor.function::<T, _, _>("math::cbrt", unit, |x| math::cbrt(x));
    visitor.function::<T, _, _>("math::exp_m1", unit, |x| math::exp_m1(x));
    visitor.function::<T, _, _>("math::log2", unit, |x| math::log2(x));
    scalar::<T, V>(visitor);
    dual::<T, V>(visitor);
}

fn scalar<T: Scalar, V: Visitor>(visitor: &mut V) {
    let unit = Arguments::unit::<T>;
    let two = Arguments::units::<T, 2>;
    visitor.function::<T, _, _>("Real::sqrt", unit, |x| Real::sqrt(Real::abs(x)));
    visitor.function::<T, _, _>("Real::remainder", two, |[x, y]| Real::remainder(x * T::of(1e5), y));
    visitor.function::<T, _, _>("Real::round", unit, |x| Real::round(x * T::of(1e6)));
    visitor.function::<T, _, _>("Real::quarters", two, |[x, y]| {
        Real::quarters(Real::round(x * T::of(1e3)), (x, y))
    });
    visitor.function::<T, _, _>("Real::split", unit, |x| Real::split(x));
    visitor.function::<T, _, _>("Real, signs", two, |[x, y]| {
        let signs = [
            Real::copysign(x, y),
            Real::signed_like(x, y),
            Real::vanish(x),
            Real::abs(x),
        ];
        (signs, Real::is_finite(x / y))
    });
    visitor.function::<T, _, _>("Real::polynomial", two, |[x, y]| {
        (Real::polynomial(x, &COSINE), T::complex_polynomial([x, y], &COSINE))
    });
    visitor.function::<T, _, _>("Real::floor", unit, |x| {
        let bytes = u32::from(Real::to_byte(T::from_byte(200)));
        (Real::floor(x * T::of(1e3)).cast_unsigned(), bytes)
    });
    visitor.function::<T, _, _>("Real, by precision", unit, |x| {
        let counts = [T::terms(7, 3), T::steps(7, 3)];
        let numbers = [
            Real::plain(x),
            Real::from_plain(x),
            T::pick(1e-200, 1e-20),
            T::whole(16_777_217),
        ];
        let rest = [
            T::of(0.1),
            T::coefficient(&COSINE, 3),
            Real::cbrt_guess(Real::abs(x)),
            Real::exponent(Real::abs(x)),
            T::power_of_two(Real::round(x)),
            T::from_byte(200),
        ];
        (counts, numbers, rest, T::all(&THIRDS))
    });
}

/// The same generic code on numbers with derivatives.
fn dual<T: Scalar, V: Visitor>(visitor: &mut V) {
    let two = Arguments::units::<T, 2>;
    visitor.function::<T, _, _>("Dual, arithmetic", two, |[x, y]| {
        let [x, y] = Dual::variables([x, y]);
        let mut sum = x + Dual::constant(T::ONE) - y * x / -y;
        sum += x;
        sum -= Dual::new(y.value(), [T::ONE, T::ZERO]);
        sum *= y;
        (sum, sum < x, sum == x, Dual::<T, 2>::default())
    });
    visitor.function::<T, _, _>("Dual, functions", two, |[x, y]| {
        let [x, y] = Dual::variables([x, y]);
        let roots = [Real::sqrt(Real::abs(x)), math::cbrt(x), math::exp_m1(x), math::log2(x)];
        let angles = [
            math::atan2(y, x),
            math::atan2_degrees(y, x),
            math::tan(x),
            math::atan(x),
        ];
        let rests = [
            Real::remainder(x, y),
            Real::round(x),
            Real::copysign(x, y),
            Real::signed_like(x, y),
        ];
        (roots, angles, rests, math::sin_cos(x), math::sin_cos_degrees(x))
    });
    visitor.visit::<T, _, _>(Function::of("Dual", "the scalar's constants"), two, |[x, y]| {
        let [x, y] = Dual::variables([x, y]);
        let numbers: [Dual<T, 2>; 4] = [
            Dual::of(0.1),
            Dual::pick(1.0, 2.0),
            Dual::whole(3),
            Dual::from_plain(Real::plain(x)),
        ];
        let polynomials = (Real::polynomial(x, &COSINE), Dual::complex_polynomial([x, y], &COSINE));
        let rest = (
            Real::split(x),
            Real::vanish(y),
            Real::cbrt_guess(Real::abs(x)),
            Real::is_finite(x),
        );
        (
            numbers,
            polynomials,
            rest,
            Dual::<T, 2>::all(&THIRDS),
            Dual::<T, 2>::steps(3, 2),
        )
    });
}
