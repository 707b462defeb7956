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
    visitor.function::<T, _, _>("math::min and max", two, |[x, y]| [math::min(x, y), math::max(x, y)]);
    visitor.function::<T, _, _>("Polynomial::at", unit, |x| Polynomial::at(&COSINE, x));
    scalar::<T, V>(visitor);
    dual::<T, V>(visitor);
}

fn scalar<T: Scalar, V: Visitor>(visitor: &mut V) {
    let unit = Arguments::unit::<T>;
    let two = Arguments::units::<T, 2>;
    visitor.function::<T, _, _>("Real::sqrt", unit, |x| Real::sqrt(Real::abs(x)));
    visitor.function::<T, _, _>("Real, signs", two, |[x, y]| {
        ([Real::copysign(x, y), Real::abs(x)], Real::is_finite(x / y))
    });
    visitor.function::<T, _, _>("Real, conversions", unit, |x| {
        [Real::plain(x), Real::from_plain(x), T::of(0.1), T::whole(16_777_217)]
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
        let rests = [x % y, Polynomial::at(&THIRDS, x), Real::copysign(x, y), math::max(x, y)];
        (roots, angles, rests, math::sin_cos(x), math::sin_cos_degrees(x))
    });
    visitor.function::<T, _, _>("Dual, more arithmetic", two, |[x, y]| {
        let [x, y] = Dual::variables([x, y]);
        let terms = [x, y, x / y, x % y];
        let (mut quotient, mut rest) = (x, x);
        quotient /= y;
        rest %= y;
        let sum: Dual<T, 2> = terms.into_iter().sum();
        let product: Dual<T, 2> = terms.into_iter().product();
        (quotient, rest, sum, product)
    });
    visitor.visit::<T, _, _>(Function::of("Dual", "the scalar's constants"), two, |[x, y]| {
        let [x, y] = Dual::variables([x, y]);
        let numbers: [Dual<T, 2>; 3] = [Dual::of(0.1), Dual::whole(3), Dual::from_plain(Real::plain(x))];
        (numbers, Polynomial::at(&COSINE, x * y), Real::is_finite(x))
    });
}
