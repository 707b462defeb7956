//! The largest of many errors.

use core::fmt;

use crate::maximum;

/// The largest of many errors. It is NaN after any NaN, and where there was no error at all. Every comparison
/// with NaN is false, so `assert!(worst.value() <= bound)` fails for an error that is no number, and for a test
/// that compared nothing.
///
/// ```
/// let mut worst = testkit::Worst::default();
/// for (seen, expected) in [(1.0, 1.0), (2.0, 2.5), (3.0, 3.1)] {
///     worst.add(f64::abs(seen - expected));
/// }
/// assert_eq!(worst.value(), 0.5);
/// assert_eq!(testkit::Worst::of([1.0, 3.0, 2.0]), 3.0);
/// ```
#[derive(Clone, Copy, Default)]
pub struct Worst(Option<f64>);

impl Worst {
    /// Takes another error, and says whether it is the largest so far: the place where it was is then worth
    /// keeping. The first error is, and the first NaN.
    pub fn add(&mut self, error: impl Into<f64>) -> bool {
        let error = error.into();
        let before = self.0.replace(self.0.map_or(error, |worst| maximum(worst, error)));
        before.is_none_or(|before| error > before || error.is_nan() && !before.is_nan())
    }

    /// The largest; NaN if one was, or none was added.
    pub fn value(self) -> f64 {
        self.0.unwrap_or(f64::NAN)
    }

    /// The largest of several.
    pub fn of<E: Into<f64>>(errors: impl IntoIterator<Item = E>) -> f64 {
        let mut worst = Self::default();
        for error in errors {
            worst.add(error);
        }
        worst.value()
    }
}

impl fmt::Debug for Worst {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(worst) => worst.fmt(f),
            None => f.write_str("nothing compared"),
        }
    }
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::Worst;
    use std::format;

    const NAN: f64 = f64::NAN;

    #[test]
    fn a_nan_is_kept_wherever_it_comes() {
        for errors in [
            [NAN, 1.0, 2.0],
            [1.0, NAN, 2.0],
            [1.0, 2.0, NAN],
            [f64::INFINITY, NAN, 0.0],
        ] {
            assert!(Worst::of(errors).is_nan(), "{errors:?}");
        }
        assert!(Worst::of([1.0_f32, f32::NAN, 2.0]).is_nan());
        assert!(Worst::of([-NAN, 1.0]).is_nan());
    }

    #[test]
    fn nothing_compared_is_no_success() {
        assert!(Worst::default().value().is_nan());
        assert_eq!(format!("{:?}", Worst::default()), "nothing compared");
    }

    #[test]
    fn the_largest_of_zeros_and_negative_numbers() {
        assert_eq!(Worst::of([-0.0, 0.0]), 0.0);
        assert_eq!(Worst::of([-3.0, -2.0, -5.0]), -2.0);
        assert_eq!(Worst::of([-1.0, 0.25_f32, 0.125]), 0.25);
        assert_eq!(Worst::of([1.0, f64::INFINITY, 2.0]), f64::INFINITY);
    }

    #[test]
    fn says_what_is_worth_keeping() {
        let mut worst = Worst::default();
        let kept = [0.0, 1.0, 1.0, 0.5, 2.0, NAN, 3.0, NAN].map(|error| worst.add(error));
        assert_eq!(kept, [true, true, false, false, true, true, false, false]);
    }
}
