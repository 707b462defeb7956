use super::degrees::Split;
use crate::Real;

/// A sum that keeps what each addition lost.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Sum<T> {
    pub high: T,
    pub low: T,
}

impl<T: Real> Sum<T> {
    pub fn add(&mut self, value: T) {
        let Split { angle, rest } = Split::sum(self.high, value);
        self.high = angle;
        self.low += rest;
    }

    pub fn value(self) -> T {
        self.high + self.low
    }
}
