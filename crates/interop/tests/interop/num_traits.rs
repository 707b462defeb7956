//! Code generic over num-traits, run on dual numbers.

use ::num_traits::{Bounded, Float, FloatConst, FromPrimitive, NumAssign, NumCast, Signed, ToPrimitive, Zero};
use num_complex::Complex;
use terrella::geodesic::{Geodesic, GreatCircle};
use terrella::{Dual, LatLon, Real};
use testkit::Worst;

/// Any function of the table by its name, in a user's words: nothing here knows of derivatives.
fn apply<F: Float>(name: &str, x: F, y: Option<F>, n: Option<i32>) -> F {
    let y = || y.unwrap();
    match name {
        "recip" => x.recip(),
        "sqrt" => x.sqrt(),
        "cbrt" => x.cbrt(),
        "exp" => x.exp(),
        "exp2" => x.exp2(),
        "exp_m1" => x.exp_m1(),
        "ln" => x.ln(),
        "ln_1p" => x.ln_1p(),
        "log2" => x.log2(),
        "log10" => x.log10(),
        "to_degrees" => x.to_degrees(),
        "to_radians" => x.to_radians(),
        "sin" => x.sin(),
        "cos" => x.cos(),
        "tan" => x.tan(),
        "asin" => x.asin(),
        "acos" => x.acos(),
        "atan" => x.atan(),
        "sinh" => x.sinh(),
        "cosh" => x.cosh(),
        "tanh" => x.tanh(),
        "asinh" => x.asinh(),
        "acosh" => x.acosh(),
        "atanh" => x.atanh(),
        "powf" => x.powf(y()),
        "log" => x.log(y()),
        "hypot" => x.hypot(y()),
        "atan2" => x.atan2(y()),
        "powi" => x.powi(n.unwrap()),
        _ => panic!("{name}"),
    }
}

/// The table's rows: each derivative within `bound` epsilons of itself, and the values those of the scalar.
/// Those in range are counted: a table that lost its rows would hold, too.
fn table_holds<T: Real + Float>(bound: f64, counted: usize) {
    let mut worst = Worst::default();
    let mut at = String::new();
    let mut compared = 0;
    for row in include_str!("../../../../tests/truth/derivatives.tsv").lines().skip(3) {
        let fields: Vec<&str> = row.split('\t').collect();
        let [name, x, y, by_x, by_y] = fields[..] else {
            panic!("{row}")
        };
        let number = |text: &str| T::of(text.parse().unwrap());
        let n = (name == "powi").then(|| y.parse().unwrap());
        let y = (n.is_none() && !y.is_empty()).then(|| number(y));
        let [dx, dy] = Dual::variables([number(x), y.unwrap_or(T::zero())]);
        let found = apply(name, dx, y.map(|_| dy), n);
        assert!(found.value() == apply(name, number(x), y, n), "{row}: {found}");
        for (found, truth) in found.slopes().into_iter().zip([by_x, by_y]) {
            let truth: f64 = if truth.is_empty() { 0.0 } else { truth.parse().unwrap() };
            let found: f64 = found.into();
            if truth == 0.0 || truth.abs() > T::max_value().into() {
                let limit: f64 = T::of(truth).into();
                assert_eq!(found, limit, "{row}");
                continue;
            }
            compared += 1;
            let ulp: f64 = T::EPSILON.into();
            if worst.add((found - truth).abs() / (ulp * truth.abs())) {
                at = row.to_owned();
            }
        }
    }
    assert!(worst.value() <= bound, "{worst:?} at {at}");
    assert_eq!(compared, counted);
}

#[test]
fn derivatives_are_those_of_the_table() {
    table_holds::<f64>(4.0, 481);
    table_holds::<f32>(4.0, 480);
}

type D = Dual<f64, 1>;

/// A function's value and derivative at a place.
fn at(f: impl Fn(D) -> D, x: f64) -> [f64; 2] {
    let [x] = Dual::variables([x]);
    let found = f(x);
    [found.value(), found.slopes()[0]]
}

/// Equal, or both NaN.
fn is<const N: usize>(found: [f64; N], expected: [f64; N]) {
    let same = found
        .iter()
        .zip(&expected)
        .all(|(a, b)| a == b || a.is_nan() && b.is_nan());
    assert!(same, "{found:?} is not {expected:?}");
}

const INFINITY: f64 = f64::INFINITY;
const NAN: f64 = f64::NAN;

#[test]
fn steps_have_no_slope() {
    for (x, [floor, ceil, round, trunc]) in [
        (2.5, [2.0, 3.0, 3.0, 2.0]),
        (-2.5, [-3.0, -2.0, -3.0, -2.0]),
        (1e300, [1e300; 4]),
    ] {
        is(at(Float::floor, x), [floor, 0.0]);
        is(at(Float::ceil, x), [ceil, 0.0]);
        is(at(Float::round, x), [round, 0.0]);
        is(at(Float::trunc, x), [trunc, 0.0]);
        is(at(Float::fract, x), [x.fract(), 1.0]);
        is(at(Float::signum, x), [x.signum(), 0.0]);
        is(at(Float::abs, x), [x.abs(), x.signum()]);
    }
    is(at(Float::abs, 0.0), [0.0, 1.0]);
    is(at(Float::abs, -0.0), [0.0, -1.0]);
}

#[test]
fn a_choice_has_the_slope_of_what_is_chosen() {
    let two = D::constant(2.0);
    is(at(|x| Float::max(x, two), 3.0), [3.0, 1.0]);
    is(at(|x| Float::max(two, x), 3.0), [3.0, 1.0]);
    is(at(|x| Float::min(x, two), 3.0), [2.0, 0.0]);
    is(at(|x| Float::min(two, x), 1.0), [1.0, 1.0]);
    for nan in [D::nan(), D::constant(NAN)] {
        is(at(|x| Float::max(x, nan), 3.0), [3.0, 1.0]);
        is(at(|x| Float::max(nan, x), 3.0), [3.0, 1.0]);
        is(at(|x| Float::min(x, nan), 3.0), [3.0, 1.0]);
        is(at(|x| Float::min(nan, x), 3.0), [3.0, 1.0]);
    }
    let within = |x: D| Float::clamp(x, -two, two);
    is(at(within, 1.5), [1.5, 1.0]);
    is(at(within, 2.5), [2.0, 0.0]);
    is(at(within, -2.5), [-2.0, 0.0]);
    assert!(at(within, NAN)[0].is_nan());
    is(at(|x| x.abs_sub(two), 3.0), [1.0, 1.0]);
    is(at(|x| two.abs_sub(x), 1.0), [1.0, -1.0]);
    is(at(|x| x.abs_sub(two), 1.0), [0.0, 0.0]);
    assert!(at(|x| x.abs_sub(two), NAN)[0].is_nan());
    is(at(|x| Float::copysign(x, -two), 3.0), [-3.0, -1.0]);
}

#[test]
fn at_the_ends_of_a_domain_a_slope_is_infinite_and_beyond_nan() {
    is(at(Float::sqrt, 0.0), [0.0, INFINITY]);
    is(at(Float::cbrt, 0.0), [0.0, INFINITY]);
    is(at(Float::asin, 1.0), [1.0.asin(), INFINITY]);
    is(at(Float::acos, -1.0), [(-1.0).acos(), -INFINITY]);
    is(at(Float::acosh, 1.0), [0.0, INFINITY]);
    is(at(Float::atanh, -1.0), [-INFINITY, INFINITY]);
    is(at(Float::ln, 0.0), [-INFINITY, INFINITY]);
    is(at(Float::log2, 0.0), [-INFINITY, INFINITY]);
    is(at(Float::log10, 0.0), [-INFINITY, INFINITY]);
    is(at(Float::ln_1p, -1.0), [-INFINITY, INFINITY]);
    is(at(Float::recip, 0.0), [INFINITY, -INFINITY]);
    for f in [
        Float::sqrt,
        Float::ln,
        Float::log2,
        Float::log10,
        Float::acosh,
        |x: D| Float::asin(x),
    ] {
        is(at(f, -2.0), [NAN, NAN]);
        is(at(f, NAN), [NAN, NAN]);
    }
    is(at(Float::acos, 1.5), [NAN, NAN]);
    is(at(Float::atanh, 1.5), [NAN, NAN]);
    is(at(Float::ln_1p, -1.5), [NAN, NAN]);
    for f in [Float::sin, Float::cos, Float::tan, |x: D| x.sin_cos().1] {
        is(at(f, INFINITY), [NAN, NAN]);
    }
    is(at(Float::sqrt, INFINITY), [INFINITY, 0.0]);
    is(at(Float::ln, INFINITY), [INFINITY, 0.0]);
    is(at(Float::exp, -INFINITY), [0.0, 0.0]);
    is(at(Float::exp_m1, -INFINITY), [-1.0, 0.0]);
    is(at(Float::atan, INFINITY), [INFINITY.atan(), 0.0]);
    is(at(Float::tanh, -INFINITY), [-1.0, 0.0]);
    is(at(Float::asinh, INFINITY), [INFINITY, 0.0]);
    is(at(Float::acosh, INFINITY), [INFINITY, 0.0]);
}

#[test]
fn what_depends_on_nothing_has_no_slope() {
    let zero = D::constant(0.0);
    for f in [Float::sqrt, Float::cbrt, Float::ln, |x: D| x.recip()] {
        assert_eq!(f(zero).slopes(), [0.0]);
    }
    assert_eq!(Float::hypot(zero, zero).slopes(), [0.0]);
    assert_eq!(Float::atan2(zero, zero).slopes(), [0.0]);
    // Where a norm is 0 it has no slope.
    is(at(|x| x.hypot(zero), 0.0), [0.0, NAN]);
    is(at(|x| x.atan2(zero), 0.0), [0.0, NAN]);
    is(at(|x| x.hypot(zero), 2.0), [2.0, 1.0]);
}

#[test]
fn powers_at_their_corners() {
    let y = |y: f64| move |x: D| x.powf(D::constant(y));
    is(at(y(2.0), -2.0), [4.0, -4.0]);
    is(at(y(3.0), -2.0), [-8.0, 12.0]);
    is(at(y(0.5), -2.0), [NAN, NAN]);
    is(at(y(2.0), 0.0), [0.0, 0.0]);
    is(at(y(1.0), 0.0), [0.0, 1.0]);
    is(at(y(0.5), 0.0), [0.0, INFINITY]);
    is(at(y(0.0), 0.0), [1.0, 0.0]);
    is(at(y(0.0), 7.0), [1.0, 0.0]);
    is(at(y(-1.0), 0.0), [INFINITY, -INFINITY]);
    let x = |x: f64| move |y: D| D::constant(x).powf(y);
    is(at(x(0.0), 2.0), [0.0, 0.0]);
    is(at(x(1.0), 5.0), [1.0, 0.0]);
    is(at(x(-2.0), 2.0), [4.0, NAN]);
    let n = |n: i32| move |x: D| x.powi(n);
    is(at(n(0), 0.0), [1.0, 0.0]);
    is(at(n(1), 0.0), [0.0, 1.0]);
    is(at(n(2), 0.0), [0.0, 0.0]);
    is(at(n(-1), 0.0), [INFINITY, -INFINITY]);
    is(at(n(3), -2.0), [-8.0, 12.0]);
    is(at(n(i32::MIN), 1.0), [1.0, i32::MIN.into()]);
    is(at(n(i32::MAX), -1.0), [-1.0, i32::MAX.into()]);
    assert!(at(n(0), NAN)[1] == 0.0);
}

#[test]
fn sums_of_products() {
    let [x, y, z] = Dual::variables([2.0, 3.0, 5.0]);
    let sum = x.mul_add(y, z);
    assert_eq!((sum.value(), sum.slopes()), (11.0, [3.0, 2.0, 1.0]));
    let rest = z % x;
    assert_eq!((rest.value(), rest.slopes()), (1.0, [-2.0, 0.0, 1.0]));
    let sum: Dual<f64, 3> = [x, y, z].into_iter().sum();
    assert_eq!((sum.value(), sum.slopes()), (10.0, [1.0; 3]));
    let product: Dual<f64, 3> = [x, y, z].into_iter().product();
    assert_eq!((product.value(), product.slopes()), (30.0, [15.0, 10.0, 6.0]));
}

#[test]
fn second_derivatives() {
    type Second = Dual<Dual<f64, 1>, 1>;
    fn second(f: impl Fn(Second) -> Second, x: f64) -> f64 {
        let [x] = Dual::variables(Dual::variables([x]));
        f(x).slopes()[0].slopes()[0]
    }
    let near = |found: f64, truth: f64| assert!((found - truth).abs() <= 1e-15, "{found} is not {truth}");
    near(second(Float::sin, 0.5), -0.5.sin());
    near(second(Float::ln, 0.5), -4.0);
    near(second(Float::atan, 0.5), -0.64);
    near(second(|x| x.powi(3), 0.5), 3.0);
    near(second(|x| x.powf(Second::of(3.0)), 0.5), 3.0);
    near(second(|x| x.hypot(Second::of(1.0)), 0.0), 1.0);
    // The inner slope is 0 here, and its own is not.
    near(second(|x| (x * x).exp(), 0.0), 2.0);
    near(second(|x| (x * x).tan(), 0.0), 2.0);
    near(second(|x| x.powi(2), 0.0), 2.0);
}

/// In the scope of both traits, every name of `Float` but four is `Float`'s: this compiles.
#[allow(clippy::too_many_lines)]
fn both<T: Real + Float + FloatConst + NumAssign + FromPrimitive>(x: T, y: T) -> Vec<T> {
    let questions = [
        x.is_nan(),
        x.is_infinite(),
        x.is_normal(),
        x.is_subnormal(),
        x.is_sign_positive(),
        x.is_sign_negative(),
        x.is_zero(),
    ];
    assert_eq!(questions, [false, false, true, false, true, false, false]);
    let (sin, cos) = x.sin_cos();
    let mut sum = T::zero() + T::one() + T::PI() + T::from_f64(0.5).unwrap() + T::of(0.5);
    sum += x;
    sum -= y;
    sum *= x;
    sum /= y;
    sum %= y;
    vec![
        x.floor(),
        x.ceil(),
        x.round(),
        x.trunc(),
        x.fract(),
        x.signum(),
        x.mul_add(y, y),
        x.recip(),
        x.powi(2),
        x.powf(y),
        x.exp(),
        x.exp2(),
        x.ln(),
        x.log(y),
        x.log2(),
        x.log10(),
        x.to_degrees(),
        x.to_radians(),
        x.max(y),
        x.min(y),
        x.clamp(y, y),
        x.cbrt(),
        x.hypot(y),
        sin,
        cos,
        x.tan(),
        x.asin(),
        x.acos(),
        x.atan(),
        x.atan2(y),
        x.exp_m1(),
        x.ln_1p(),
        x.sinh(),
        x.cosh(),
        x.tanh(),
        x.asinh(),
        x.acosh(),
        x.atanh(),
        T::epsilon(),
        T::nan(),
        sum,
        Float::sqrt(x),
        Float::abs(x),
        Float::copysign(x, y),
        Real::sqrt(x),
        Real::abs(x),
        Real::copysign(x, y),
    ]
}

#[test]
fn names_are_not_ambiguous() {
    let plain = both(0.75, 2.5);
    let [x, y] = Dual::<f64, 2>::variables([0.75, 2.5]);
    let dual = both(x, y);
    for (plain, dual) in plain.into_iter().zip(dual) {
        is([plain], [dual.value()]);
    }
    // Both traits are in scope here, too.
    assert_eq!(2.5_f64.round(), 3.0);
    assert_eq!((-0.5_f32).floor(), -1.0);
    assert_eq!((6.25_f64.sqrt(), (-1.0_f64).abs()), (2.5, 1.0));
}

#[test]
fn conversions_are_of_the_value() {
    let [x] = Dual::<f32, 1>::variables([2.75]);
    assert_eq!((x.to_i8(), x.to_u64(), x.to_f64()), (Some(2), Some(2), Some(2.75)));
    assert_eq!((-x).to_u8(), None);
    let from: Option<Dual<f32, 1>> = NumCast::from(7_i64);
    let seven = from.unwrap();
    assert_eq!((seven.value(), seven.slopes()), (7.0, [0.0]));
    assert_eq!(<Dual<f32, 1> as FromPrimitive>::from_u8(200).unwrap().value(), 200.0);
    let parsed: Dual<f64, 2> = ::num_traits::Num::from_str_radix("1.5", 10).unwrap();
    assert_eq!(parsed.value(), 1.5);
    assert_eq!(<D as Bounded>::max_value().value(), f64::MAX);
    assert_eq!(<D as Float>::neg_zero().value().to_bits(), (-0.0_f64).to_bits());
    assert!(D::constant(0.0).is_zero() && Signed::is_negative(&-seven));
    assert_eq!(x.integer_decode(), 2.75_f32.integer_decode());
    assert_eq!((D::PI().value(), D::TAU().value()), (f64::PI(), f64::TAU()));
}

/// What a user may have: a root by Newton's method, for any `Float`.
fn kepler<F: Float>(mean: F, eccentricity: F) -> F {
    let mut anomaly = mean;
    for _ in 0..8 {
        let (sin, cos) = anomaly.sin_cos();
        anomaly = anomaly - (anomaly - eccentricity * sin - mean) / (F::one() - eccentricity * cos);
    }
    anomaly
}

#[test]
fn a_users_solver_is_differentiated() {
    let [mean, eccentricity] = Dual::variables([1.0_f64, 0.25]);
    let anomaly = kepler(mean, eccentricity);
    assert_eq!(anomaly.value(), kepler(1.0, 0.25));
    // Of E − e sin E = M: dE = (dM + sin E de)/(1 − e cos E).
    let (sin, cos) = anomaly.value().sin_cos();
    let [by_mean, by_eccentricity] = anomaly.slopes();
    assert!((by_mean - 1.0 / (1.0 - 0.25 * cos)).abs() < 1e-15);
    assert!((by_eccentricity - sin / (1.0 - 0.25 * cos)).abs() < 1e-15);
}

/// The haversine distance of geo 0.32 in metres, as it is written there: degrees, for any float.
fn haversine<F: Float + FromPrimitive>([y1, x1]: [F; 2], [y2, x2]: [F; 2], radius: f64) -> F {
    let two = F::one() + F::one();
    let theta1 = y1.to_radians();
    let theta2 = y2.to_radians();
    let delta_theta = (y2 - y1).to_radians();
    let delta_lambda = (x2 - x1).to_radians();
    let a = (delta_theta / two).sin().powi(2) + theta1.cos() * theta2.cos() * (delta_lambda / two).sin().powi(2);
    let c = two * a.sqrt().asin();
    F::from(radius).unwrap() * c
}

#[test]
fn slopes_of_a_distance_are_azimuths() {
    const RADIUS: f64 = 6_371_008.8;
    let ours = GreatCircle::new(RADIUS).unwrap();
    let metres = RADIUS * 1_f64.to_radians();
    for [lat1, lon1, lat2, lon2] in [
        [59.9, 10.7, 52.5, 13.4],
        [-0.2, -78.5, 35.7, 139.7],
        [10.0, 20.0, -30.0, -40.0],
    ] {
        let [from, to] = [[lat1, lon1], [lat2, lon2]].map(|[lat, lon]| LatLon::new(lat, lon).unwrap());
        let line = ours.inverse(from, to).unwrap();
        let [y1, x1, y2, x2] = Dual::variables([lat1, lon1, lat2, lon2]);
        let found = haversine([y1, x1], [y2, x2], RADIUS);
        assert!((found.value() - line.distance).abs() < 1e-12 * line.distance);
        let (sin1, cos1) = line.azimuth1.to_radians().sin_cos();
        let (sin2, cos2) = line.azimuth2.to_radians().sin_cos();
        let expected = [
            -cos1,
            -sin1 * lat1.to_radians().cos(),
            cos2,
            sin2 * lat2.to_radians().cos(),
        ];
        for (slope, expected) in found.slopes().into_iter().zip(expected) {
            assert!((slope / metres - expected).abs() < 1e-12, "{slope} is not {expected}");
        }
    }
}

/// num-complex knows nothing of derivatives. Those of its functions are complex numbers: ∂f/∂x = f′, ∂f/∂y = if′.
#[test]
fn another_crates_functions_are_differentiated() {
    type D2 = Dual<f64, 2>;
    type Function<T> = fn(Complex<T>) -> Complex<T>;
    let functions: [(Function<D2>, Function<f64>); 9] = [
        (|z| z.exp(), |z| z.exp()),
        (|z| z.ln(), |z| z.inv()),
        (|z| z.sqrt(), |z| z.sqrt().inv() * 0.5),
        (|z| z.powi(3), |z| z * z * 3.0),
        (|z| z.sin(), |z| z.cos()),
        (|z| z.cosh(), |z| z.sinh()),
        (|z| z.tan(), |z| (z.cos() * z.cos()).inv()),
        (|z| z.atan(), |z| (z * z + 1.0).inv()),
        (|z| z.asinh(), |z| (z * z + 1.0).sqrt().inv()),
    ];
    let mut worst = Worst::default();
    for place in [[0.3, 0.4], [-1.2, 0.7], [2.0, -1.5]] {
        let [x, y] = Dual::variables(place);
        for (function, derivative) in &functions {
            let found = function(Complex::new(x, y));
            let expected = derivative(Complex::new(place[0], place[1]));
            let ([u_x, u_y], [v_x, v_y]) = (found.re.slopes(), found.im.slopes());
            for (a, b) in [
                (u_x, expected.re),
                (v_x, expected.im),
                (u_y, -expected.im),
                (v_y, expected.re),
            ] {
                worst.add((a - b).abs() / expected.norm());
            }
        }
    }
    assert!(worst.value() <= 1e-14, "{worst:?}");
}
