//! Headings: wraps are exact, differences and means as accurate as claimed.

use fastrand::Rng;
use terrella::Real;
use terrella::route::heading::{UndefinedMean, difference, mean, to_circle, to_half_circles};

#[test]
fn wraps_are_half_open() {
    for (heading, circle, half) in [
        (0.0, 0.0, 0.0),
        (-0.0, 0.0, 0.0),
        (180.0, 180.0, -180.0),
        (-180.0, 180.0, -180.0),
        (360.0, 0.0, 0.0),
        (-360.0, 0.0, 0.0),
        (539.5, 179.5, 179.5),
        (-539.5, 180.5, -179.5),
        (1e9, 280.0, -80.0),
        (-90.0, 270.0, -90.0),
        (-1e-30, 0.0, -1e-30),
    ] {
        assert_eq!(
            (to_circle(heading), to_half_circles(heading)),
            (circle, half),
            "{heading}"
        );
        assert!(to_circle::<f64>(heading).is_sign_positive());
        let single = heading as f32;
        assert_eq!(
            (to_circle(single), to_half_circles(single)),
            (circle as f32, half as f32),
            "{heading}"
        );
    }
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert!(to_circle(bad).is_nan() && to_half_circles(bad).is_nan() && difference(bad, 1.0).is_nan());
    }
}

/// The remainders of integers: 2⁻²⁰ of a degree each.
#[test]
fn differences_are_exact() {
    let mut rng = Rng::with_seed(21);
    let unit = 1.0 / f64::from(1 << 20);
    let circle = 360_i64 << 20;
    for _ in 0..100_000 {
        let [a, b] = [(); 2].map(|()| rng.i64(-(1 << 50)..1 << 50) >> rng.u8(0..40));
        let turn = (b - a + circle / 2).rem_euclid(circle) - circle / 2;
        assert_eq!(
            difference(a as f64 * unit, b as f64 * unit),
            turn as f64 * unit,
            "{a} {b}"
        );
        assert_eq!(
            to_half_circles(a as f64 * unit),
            ((a + circle / 2).rem_euclid(circle) - circle / 2) as f64 * unit
        );
        assert_eq!(to_circle(a as f64 * unit), a.rem_euclid(circle) as f64 * unit);
    }
    assert_eq!(difference(0.0, 180.0), -180.0);
    assert_eq!(difference(180.0, 0.0), -180.0);
    // 180 less what is below a rounding.
    assert_eq!(difference(1e-20, 180.0), 180.0);
    assert_eq!(difference(-1e-20, 180.0), -180.0);
    assert_eq!(difference(-1e-20, -179.0_f32), -179.0);
}

#[test]
fn means() {
    fn hold<T: Real>(tolerance: f64) {
        let of = |headings: &[f64]| mean(&headings.iter().map(|&heading| T::of(heading)).collect::<Vec<_>>());
        for (headings, expected) in [
            (&[350.0, 10.0][..], 0.0),
            (&[10.0, 350.0], 0.0),
            (&[0.0, 90.0], 45.0),
            (&[90.0, 0.0, 45.0], 45.0),
            (&[-90.0], 270.0),
            (&[270.0, 180.0], 225.0),
            (&[179.0, -179.0], 180.0),
            (&[725.0], 5.0),
        ] {
            let found: f64 = of(headings).unwrap().into();
            assert!((found - expected).abs() <= tolerance, "{headings:?} {found}");
        }
        assert_eq!(of(&[]), Err(UndefinedMean::Empty));
        for headings in [&[0.0, 180.0][..], &[90.0, -90.0], &[10.0, 130.0, 250.0], &[17.0, 197.0]] {
            assert_eq!(of(headings), Err(UndefinedMean::Balanced), "{headings:?}");
        }
        let Err(UndefinedMean::Heading { index: 1, heading }) = of(&[1.0, f64::NAN]) else {
            panic!("NaN has a mean");
        };
        assert!(Into::<f64>::into(heading).is_nan());
    }
    hold::<f64>(1.2e-13);
    hold::<f32>(6e-5);
}

#[test]
fn errors_say_what_is_wrong() {
    assert_eq!(UndefinedMean::<f64>::Empty.to_string(), "no headings have no mean");
    let heading = UndefinedMean::Heading {
        index: 3,
        heading: f32::INFINITY,
    };
    assert_eq!(heading.to_string(), "heading inf at index 3 is not finite");
    assert_eq!(
        UndefinedMean::<f64>::Balanced.to_string(),
        "opposite headings have no mean"
    );
}
