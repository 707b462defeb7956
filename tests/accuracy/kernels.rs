//! The kernels of `math`: against the truth, and in `f32` over many arguments against `f64`.

use terrella::{Real, math};
use testkit::{Worst, maximum};

use testkit::table::hold;
use testkit::truth::{Scalar, Truth, ulps_between};

/// A function of `math`, its truth file with the columns of arguments and results, and arguments to try at random.
trait Kernel {
    const NAME: &str;
    const FILE: &str;
    const ARGUMENTS: &[&str];
    const RESULTS: &[&str];
    /// The largest argument in `f32`.
    const LIMIT: f64 = f64::INFINITY;
    fn call<T: Real>(arguments: &[T]) -> Vec<T>;
    fn arguments(rng: &mut fastrand::Rng) -> Vec<f32>;
}

/// The largest error in ulp over the truth file.
fn against_truth<K: Kernel, T: Scalar>() -> f64 {
    let truth = Truth::read(K::FILE);
    let limit = if T::NAME == "f32" { K::LIMIT } else { f64::INFINITY };
    let mut worst = Worst::default();
    for row in truth.exact_in::<T>(K::ARGUMENTS) {
        if row.value(K::ARGUMENTS[0]).abs() <= limit {
            let arguments: Vec<T> = K::ARGUMENTS.iter().map(|column| row.input(column)).collect();
            for (column, result) in K::RESULTS.iter().zip(K::call(&arguments)) {
                worst.add(row.ulps(column, result));
            }
        }
    }
    worst.value()
}

/// The largest error in ulp of `f32` against `f64` over many arguments.
fn against_double<K: Kernel>() -> f64 {
    let mut rng = fastrand::Rng::with_seed(1);
    let mut worst = Worst::default();
    for _ in 0..300_000 {
        let single = K::arguments(&mut rng);
        let double: Vec<f64> = single.iter().copied().map(f64::from).collect();
        for (s, d) in K::call(&single).into_iter().zip(K::call(&double)) {
            worst.add(ulps_between(s, d));
        }
    }
    worst.value()
}

/// Whatever argument is no number, no result is one: a comparison drops a NaN where it is not looked for.
fn not_a_number<K: Kernel, T: Scalar>() {
    let mut rng = fastrand::Rng::with_seed(2);
    let nan = T::of(f64::NAN);
    let special = [0.0, -0.0, 1.0, -1.0, 1e-30, 3e38].map(T::of);
    for _ in 0..1000 {
        let mut arguments: Vec<T> = K::arguments(&mut rng).into_iter().map(|x| T::of(x.into())).collect();
        if rng.bool() {
            arguments.fill_with(|| *rng.choice(&special).unwrap());
        }
        for i in 0..arguments.len() {
            for nan in [nan, -nan] {
                let mut given = arguments.clone();
                given[i] = nan;
                let found = K::call(&given);
                assert!(
                    found.iter().all(|x| (*x).into().is_nan()),
                    "{} of {given:?}: {found:?}",
                    K::NAME
                );
            }
        }
    }
}

fn signed(rng: &mut fastrand::Rng) -> f32 {
    2.0 * rng.f32() - 1.0
}

macro_rules! kernel {
    ($kernel:ident($($argument:literal),+) -> $results:expr, $file:literal, $(limit $limit:literal,)?
     |$x:ident| $call:expr, |$rng:ident| $random:expr) => {
        #[test]
        fn $kernel() {
            struct Here;
            impl Kernel for Here {
                const NAME: &str = concat!("math::", stringify!($kernel));
                const FILE: &str = $file;
                const ARGUMENTS: &[&str] = &[$($argument),+];
                const RESULTS: &[&str] = &$results;
                $(const LIMIT: f64 = $limit;)?
                fn call<T: Real>($x: &[T]) -> Vec<T> {
                    $call.into()
                }
                fn arguments($rng: &mut fastrand::Rng) -> Vec<f32> {
                    $random.into()
                }
            }
            let single = maximum(against_truth::<Here, f32>(), against_double::<Here>());
            hold(Here::NAME, [against_truth::<Here, f64>(), single]);
            not_a_number::<Here, f64>();
            not_a_number::<Here, f32>();
        }
    };
}

kernel!(sin_cos("x") -> ["sin", "cos"], "kernel_sin_cos", limit 100.0,
    |x| <[T; 2]>::from(math::sin_cos(x[0])), |rng| [100.0 * signed(rng)]);
kernel!(sin_cos_degrees("x") -> ["sin", "cos"], "kernel_sin_cos_degrees",
    |x| <[T; 2]>::from(math::sin_cos_degrees(x[0])), |rng| [720.0 * signed(rng)]);
kernel!(tan("x") -> ["tan"], "kernel_tan",
    |x| [math::tan(x[0])], |rng| [core::f32::consts::FRAC_PI_4 * signed(rng)]);
kernel!(atan("x") -> ["atan"], "kernel_atan",
    |x| [math::atan(x[0])], |rng| [signed(rng) / (rng.f32() + 1e-6)]);
kernel!(atan2("y", "x") -> ["atan2_radians"], "kernel_atan2",
    |x| [math::atan2(x[0], x[1])], |rng| [signed(rng), signed(rng)]);
kernel!(atan2_degrees("y", "x") -> ["atan2_degrees"], "kernel_atan2",
    |x| [math::atan2_degrees(x[0], x[1])], |rng| [signed(rng), signed(rng)]);
kernel!(cbrt("x") -> ["cbrt"], "kernel_cbrt",
    |x| [math::cbrt(x[0])], |rng| [8.0 * signed(rng)]);
kernel!(exp_m1("x") -> ["exp_m1"], "kernel_exp_m1", limit 88.5,
    |x| [math::exp_m1(x[0])], |rng| [88.5 * signed(rng) * rng.f32() * rng.f32()]);
kernel!(log2("x") -> ["log2"], "kernel_log2",
    |x| [math::log2(x[0])],
    |rng| [if rng.bool() { 0.5 + 1.5 * rng.f32() } else { f32::from_bits(rng.u32(0x80_0000..0x7F80_0000)) }]);

#[test]
fn degrees_are_exact_where_the_result_is() {
    fn check<T: Scalar>() {
        for quarter in -8..=8_i32 {
            let x = T::of(f64::from(quarter) * 90.0);
            let (sin, cos) = math::sin_cos_degrees(x);
            let expected = [(0.0, 1.0), (1.0, 0.0), (0.0, -1.0), (-1.0, 0.0)][quarter.rem_euclid(4) as usize];
            assert_eq!((sin.into(), cos.into()), expected, "{x:?}");
            for (offset, at) in [(30.0, [0.5, 3f64.sqrt() / 2.0]), (60.0, [3f64.sqrt() / 2.0, 0.5])] {
                let (sin, cos) = math::sin_cos_degrees(x + T::of(offset));
                // Turned back to the first quadrant, the half is exact.
                let (s, c) = match quarter.rem_euclid(4) {
                    0 => (sin, cos),
                    1 => (-cos, sin),
                    2 => (-sin, -cos),
                    _ => (cos, -sin),
                };
                let half = if offset == 30.0 { s } else { c };
                assert_eq!(half, T::of(0.5), "{x:?} + {offset}");
                assert!((s.into() - at[0]).abs() < 1e-7 && (c.into() - at[1]).abs() < 1e-7);
            }
        }
        for (y, x, degrees) in [
            (1.0, 1.0, 45.0),
            (1.0, -1.0, 135.0),
            (-2.0, 0.0, -90.0),
            (0.0, -3.0, 180.0),
        ] {
            assert_eq!(math::atan2_degrees(T::of(y), T::of(x)), T::of(degrees));
        }
        assert_eq!(
            T::ONE.copysign(math::sin_cos_degrees(T::of(-180.0)).0),
            -T::ONE,
            "the sine of −180 is −0"
        );
    }
    check::<f64>();
    check::<f32>();
}

#[test]
fn out_of_domain_is_not_a_number() {
    assert!(math::sin_cos(1e6_f64).0.is_nan() && math::sin_cos(101.0_f32).1.is_nan());
    assert!(math::sin_cos_degrees(1e10_f64).0.is_nan() && math::sin_cos_degrees(f32::INFINITY).1.is_nan());
    assert_eq!(
        (math::cbrt(0.0_f64), math::cbrt(-8.0_f32), math::cbrt(f64::INFINITY)),
        (0.0, -2.0, f64::INFINITY)
    );
}

#[test]
fn cube_roots_next_to_the_largest() {
    for part in [1.0, 0.93, 0.5, 0.34, 0.33, 0.1, 1e-30] {
        let (x, single) = (part * f64::MAX, part as f32 * f32::MAX);
        assert!((math::cbrt(x) / x.cbrt() - 1.0).abs() <= f64::EPSILON, "{x:e}");
        assert!(
            (math::cbrt(-single) / (-single).cbrt() - 1.0).abs() <= f32::EPSILON,
            "{single:e}"
        );
    }
}

/// NaN of any bits: their integer is no number to count on with.
#[test]
fn no_number_has_no_sine() {
    for bits in [u32::MAX, 0x7FC0_0000, 0x7F80_0001, f32::INFINITY.to_bits()] {
        let x = f32::from_bits(bits);
        assert!(
            math::sin_cos(x).0.is_nan() && math::sin_cos_degrees(x).1.is_nan(),
            "{bits:x}"
        );
    }
    for bits in [u64::MAX, f64::NAN.to_bits(), f64::INFINITY.to_bits()] {
        let x = f64::from_bits(bits);
        assert!(
            math::sin_cos(x).0.is_nan() && math::sin_cos_degrees(x).1.is_nan(),
            "{bits:x}"
        );
    }
}

#[test]
fn logarithm_and_exponential_at_the_ends() {
    fn check<T: Scalar>(least: f64, overflows: f64, digits: f64) {
        let of = |value: f64| T::lift(value).unwrap_or_else(|| T::of(value));
        let (infinity, nan) = (of(f64::INFINITY), of(f64::NAN));
        assert_eq!(math::exp_m1(infinity), infinity);
        assert_eq!(math::exp_m1(of(overflows)), infinity);
        assert!(math::exp_m1(of(overflows - 0.01)).is_finite());
        for far in [f64::NEG_INFINITY, -1e30, -1000.0, -709.0, -100.0, -87.0, -45.0] {
            assert_eq!(math::exp_m1(of(far)), -T::ONE, "{far}");
        }
        // A number as small as this is its own result; a zero keeps its sign.
        for tiny in [0.0, least, 3.0 * least, 1e10 * least] {
            for tiny in [tiny, -tiny] {
                let result: f64 = math::exp_m1(of(tiny)).into();
                assert_eq!(result.to_bits(), tiny.to_bits(), "{tiny:e}");
            }
        }
        assert_eq!(math::log2(infinity), infinity);
        assert_eq!((math::log2(T::ZERO), math::log2(-T::ZERO)), (-infinity, -infinity));
        for out in [
            math::exp_m1(nan),
            math::log2(nan),
            math::log2(-T::ONE),
            math::log2(-infinity),
        ] {
            assert!(out.into().is_nan());
        }
        // Every power of two, the subnormal ones too.
        let mut power = least;
        for k in -digits as i32..=-(digits as i32) + 60 {
            assert_eq!(math::log2(of(power)), of(f64::from(k)));
            power *= 2.0;
        }
    }
    check::<f64>(5e-324, 709.79, 1074.0);
    check::<f32>(f64::from(f32::from_bits(1)), 88.73, 149.0);
    // Subnormal numbers that are no powers of two.
    assert_eq!(math::log2(f64::from_bits(3)), -1072.415037499279);
    assert_eq!(math::log2(f32::from_bits(3)), -147.41504);
}
