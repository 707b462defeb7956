use core::fmt;
use core::iter::FusedIterator;

use super::Segment;
use crate::Real;
use crate::geodesic::Passage;

/// The most steps that a segment is divided into: all whole numbers to it are numbers of `f32`.
const MOST: u32 = 1 << 24;

/// Why a segment cannot be divided.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidStep<T> {
    /// The step or the tolerance is not a positive number of metres.
    NotPositive(T),
    /// The step or the tolerance makes more than 16 777 216 steps.
    TooSmall(T),
}

impl<T: fmt::Debug> fmt::Display for InvalidStep<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotPositive(metres) => write!(f, "{metres:?} is not a positive number of metres"),
            Self::TooSmall(metres) => write!(f, "{metres:?} metres make more than {MOST} steps"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidStep<T> {}

/// Whether metres are a positive number.
pub(super) fn positive<T: Real>(metres: T) -> Result<T, InvalidStep<T>> {
    if metres.is_finite() && metres > T::ZERO {
        Ok(metres)
    } else {
        Err(InvalidStep::NotPositive(metres))
    }
}

/// Points along a [`Segment`] from its first place to its second, from [`Segment::waypoints`],
/// [`parts`](Segment::parts) and [`chords`](Segment::chords). Of a segment without length it is one point.
#[derive(Clone, Debug)]
pub struct Waypoints<'a, T> {
    segment: &'a Segment<T>,
    step: T,
    next: u32,
    steps: u32,
    done: bool,
}

impl<'a, T: Real> Waypoints<'a, T> {
    pub(super) fn every(segment: &'a Segment<T>, step: T) -> Result<Self, InvalidStep<T>> {
        let step = positive(step)?;
        let steps = steps(segment.length() / step).ok_or(InvalidStep::TooSmall(step))?;
        Ok(Self::of(segment, step, steps))
    }

    /// Equal parts of at most this length, for a tolerance.
    pub(super) fn within(segment: &'a Segment<T>, tolerance: T, longest: T) -> Result<Self, InvalidStep<T>> {
        let tolerance = positive(tolerance)?;
        let count = steps(segment.length() / longest).ok_or(InvalidStep::TooSmall(tolerance))?;
        Ok(Self::parts(segment, count))
    }

    pub(super) fn parts(segment: &'a Segment<T>, count: u32) -> Self {
        let count = count.clamp(1, MOST);
        let step = segment.length() / T::whole(count.into());
        Self::of(segment, step, if step > T::ZERO { count } else { 0 })
    }

    fn of(segment: &'a Segment<T>, step: T, steps: u32) -> Self {
        Self {
            segment,
            step,
            next: 0,
            steps,
            done: false,
        }
    }
}

/// The smallest whole number that is not less, but for rounding, if it is not too large.
fn steps<T: Real>(exact: T) -> Option<u32> {
    let exact = exact - exact * T::of(4.0) * T::EPSILON;
    // Also for NaN.
    let few = exact <= T::whole(MOST.into());
    let whole = few.then(|| u32::try_from(exact.floor()).ok()).flatten()?;
    Some(if T::whole(whole.into()) < exact {
        whole + 1
    } else {
        whole
    })
}

impl<T: Real> Iterator for Waypoints<'_, T> {
    type Item = Passage<T>;

    fn next(&mut self) -> Option<Passage<T>> {
        if self.done {
            return None;
        }
        self.done = self.next >= self.steps;
        let distance = if self.done && self.steps > 0 {
            self.segment.length()
        } else {
            self.step * T::whole(self.next.into())
        };
        self.next = self.next.saturating_add(1);
        Some(self.segment.passage(distance))
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (self.len(), Some(self.len()))
    }
}

// Not by the default, whose assertion stays where the code is compiled for size.
impl<T: Real> ExactSizeIterator for Waypoints<'_, T> {
    fn len(&self) -> usize {
        // At most MOST and one, which any processor counts.
        let left = self.steps.saturating_sub(self.next).saturating_add(1);
        if self.done { 0 } else { left as usize }
    }
}
impl<T: Real> FusedIterator for Waypoints<'_, T> {}
