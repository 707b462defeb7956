use crate::Real;
use crate::cube::FacePoint;
use crate::math::{max, min, select};

/// The number of partial results that are kept side by side, so that the loop vectorises and gives the same
/// bits on every machine.
const LANES: usize = 8;

/// An accumulator of values at points of the cube: minimum and maximum with their points, mean, and root mean
/// square deviation from an ideal value.
///
/// ```
/// use terrella::cube::{Face, FacePoint};
/// use terrella::distortion::Statistic;
///
/// let mut aspect = Statistic::about(1.0_f64);
/// aspect.include(FacePoint::new(Face::Front, 0.0, 0.0)?, 1.0);
/// aspect.include(FacePoint::new(Face::Front, 1.0, 0.0)?, 1.2);
/// assert_eq!((aspect.min(), aspect.max(), aspect.mean()), (1.0, 1.2, 1.1));
/// assert_eq!(aspect.max_at().map(|point| point.x()), Some(1.0));
/// assert!((aspect.rmsd() - 0.2 * 0.5_f64.sqrt()).abs() < 1e-15);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Statistic<T> {
    ideal: T,
    smallest: Option<Extreme<T>>,
    largest: Option<Extreme<T>>,
    count: u64,
    deviations: Sum<T>,
    squares: Sum<T>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Extreme<T> {
    value: T,
    at: FacePoint<T>,
}

impl<T: Real> Statistic<T> {
    /// Creates an empty accumulator; deviations are measured from `ideal`.
    #[must_use]
    pub fn about(ideal: T) -> Self {
        Self {
            ideal,
            smallest: None,
            largest: None,
            count: 0,
            deviations: Sum::default(),
            squares: Sum::default(),
        }
    }

    /// Includes a value and its point. A NaN is never the minimum or maximum; it makes the mean NaN.
    #[inline(always)]
    pub fn include(&mut self, at: FacePoint<T>, value: T) {
        self.extend(Extreme { value, at });
        self.count += 1;
        let deviation = value - self.ideal;
        self.deviations.add(deviation);
        self.squares.add(deviation * deviation);
    }

    /// Includes the values of points side by side; `at` returns the point of an x.
    #[inline(always)]
    pub(super) fn include_row(&mut self, at: impl Fn(T) -> FacePoint<T>, xs: &[T], values: &[T]) {
        let infinity = T::of(f64::INFINITY);
        let [mut deviations, mut squares] = [[T::ZERO; LANES]; 2];
        let (mut least, mut most) = ([infinity; LANES], [-infinity; LANES]);
        let groups = values.chunks_exact(LANES);
        let (grouped, rest) = (values.len() - groups.remainder().len(), groups.remainder());
        for group in groups {
            let lanes = deviations.iter_mut().zip(&mut squares).zip(&mut least).zip(&mut most);
            for ((((deviations, squares), least), most), &value) in lanes.zip(group) {
                let deviation = value - self.ideal;
                *deviations += deviation;
                *squares += deviation * deviation;
                *least = min(*least, value);
                *most = max(*most, value);
            }
        }
        let sum = |lanes: [T; LANES]| lanes.into_iter().fold(T::ZERO, |sum, lane| sum + lane);
        self.count += grouped as u64;
        self.deviations.add(sum(deviations));
        self.squares.add(sum(squares));

        let least = least.into_iter().fold(infinity, min);
        let most = most.into_iter().fold(-infinity, max);
        let new_least = least < self.smallest.map_or(infinity, |old| old.value);
        let new_most = most > self.largest.map_or(-infinity, |old| old.value);
        if new_least | new_most {
            for (&x, &value) in xs.iter().zip(values) {
                self.extend(Extreme { value, at: at(x) });
            }
        }
        for (&x, &value) in xs.iter().skip(grouped).zip(rest) {
            self.include(at(x), value);
        }
    }

    /// Includes all values that another accumulator has. Both must have the same ideal value.
    pub fn merge(&mut self, other: &Self) {
        for extreme in other.smallest.into_iter().chain(other.largest) {
            self.extend(extreme);
        }
        self.count += other.count;
        for part in [other.deviations.total, other.deviations.carry] {
            self.deviations.add(part);
        }
        for part in [other.squares.total, other.squares.carry] {
            self.squares.add(part);
        }
    }

    /// Updates the minimum and the maximum.
    #[inline(always)]
    fn extend(&mut self, new: Extreme<T>) {
        let infinity = T::of(f64::INFINITY);
        let below = new.value < self.smallest.map_or(infinity, |old| old.value);
        self.smallest = select(below, Some(new), self.smallest);
        let above = new.value > self.largest.map_or(-infinity, |old| old.value);
        self.largest = select(above, Some(new), self.largest);
    }

    /// Returns the smallest value, or NaN if there are no values.
    #[must_use]
    pub fn min(&self) -> T {
        self.smallest.map_or(T::of(f64::NAN), |extreme| extreme.value)
    }

    /// Returns the largest value, or NaN if there are no values.
    #[must_use]
    pub fn max(&self) -> T {
        self.largest.map_or(T::of(f64::NAN), |extreme| extreme.value)
    }

    /// Returns the point at which the smallest value was first seen, or `None` if there are no values.
    #[must_use]
    pub fn min_at(&self) -> Option<FacePoint<T>> {
        self.smallest.map(|extreme| extreme.at)
    }

    /// Returns the point at which the largest value was first seen, or `None` if there are no values.
    #[must_use]
    pub fn max_at(&self) -> Option<FacePoint<T>> {
        self.largest.map(|extreme| extreme.at)
    }

    /// Returns the largest value divided by the smallest value.
    #[must_use]
    pub fn ratio(&self) -> T {
        self.max() / self.min()
    }

    /// Returns the number of values.
    #[must_use]
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Returns the arithmetic mean, or NaN if there are no values.
    #[must_use]
    pub fn mean(&self) -> T {
        self.ideal + self.deviations.total / T::whole(self.count)
    }

    /// Returns the root mean square deviation from the ideal value, or NaN if there are no values.
    #[doc(alias = "RMS")]
    #[doc(alias = "root mean square deviation")]
    #[must_use]
    pub fn rmsd(&self) -> T {
        (self.squares.total / T::whole(self.count)).sqrt()
    }
}

/// A compensated sum: it carries the rounding error to the next addition (Kahan, with Knuth's exact sum), so
/// that millions of `f32` add up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
struct Sum<T> {
    total: T,
    carry: T,
}

impl<T: Real> Sum<T> {
    #[inline(always)]
    fn add(&mut self, value: T) {
        let value = value + self.carry;
        let sum = self.total + value;
        let part = sum - self.total;
        self.carry = (self.total - (sum - part)) + (value - part);
        self.total = sum;
    }
}
