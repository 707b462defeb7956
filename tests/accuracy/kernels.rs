//! The kernels of `math` against the truth.

use terrella::math;

use crate::table::hold;
use crate::truth::{Row, Scalar, Truth};

/// The largest error in ulp over a file: `compute` gives the columns and values of a row.
fn worst<T: Scalar>(file: &str, inputs: &[&str], compute: impl Fn(Row) -> Vec<(&'static str, T)>) -> f64 {
    let truth = Truth::read(file);
    let errors = truth.exact_in::<T>(inputs).into_iter().flat_map(|row| {
        compute(row).into_iter().map(move |(column, value)| {
            let e = row.ulps(column, value);
            if std::env::var("SHOW").is_ok() && e > 1.0 {
                println!(
                    "{file} {} {:?} {column} {value:?} {e}",
                    T::NAME,
                    inputs.iter().map(|c| row.text(c)).collect::<Vec<_>>()
                );
            }
            e
        })
    });
    errors.fold(0.0, f64::max)
}

macro_rules! kernel {
    ($test:ident, $claim:literal, $file:literal, $inputs:expr, $compute:expr) => {
        #[test]
        fn $test() {
            fn of<T: Scalar>() -> f64 {
                worst::<T>($file, &$inputs, $compute)
            }
            hold($claim, of::<f64>(), of::<f32>());
        }
    };
}

kernel!(sin_cos, "sin_cos", "kernel_sin_cos", ["x"], |row| {
    let x: T = row.input("x");
    if x.abs() > T::of(100.0) && T::NAME == "f32" {
        return vec![];
    }
    let (sin, cos) = math::sin_cos(x);
    vec![("sin", sin), ("cos", cos)]
});
kernel!(
    sin_cos_degrees,
    "sin_cos_degrees",
    "kernel_sin_cos_degrees",
    ["x"],
    |row| {
        let (sin, cos) = math::sin_cos_degrees(row.input::<T>("x"));
        vec![("sin", sin), ("cos", cos)]
    }
);
kernel!(tan, "tan", "kernel_tan", ["x"], |row| vec![(
    "tan",
    math::tan(row.input::<T>("x"))
)]);
kernel!(atan, "atan", "kernel_atan", ["x"], |row| vec![(
    "atan",
    math::atan(row.input::<T>("x"))
)]);
kernel!(atan2, "atan2", "kernel_atan2", ["y", "x"], |row| {
    vec![("atan2_radians", math::atan2(row.input::<T>("y"), row.input("x")))]
});
kernel!(atan2_degrees, "atan2_degrees", "kernel_atan2", ["y", "x"], |row| {
    vec![(
        "atan2_degrees",
        math::atan2_degrees(row.input::<T>("y"), row.input("x")),
    )]
});
kernel!(cbrt, "cbrt", "kernel_cbrt", ["x"], |row| vec![(
    "cbrt",
    math::cbrt(row.input::<T>("x"))
)]);
