//! NumPy's arrays as slices. The package hands over arrays of one dimension, contiguous, of one length.

use numpy::{Element, PyReadonlyArray1, PyReadwriteArray1};
use pyo3::prelude::*;

pub type Given<'py, T> = PyReadonlyArray1<'py, T>;
pub type Made<'py, T> = PyReadwriteArray1<'py, T>;

/// The slices of arrays.
pub fn slices<'a, T: Element, const N: usize>(arrays: &'a [Given<'_, T>; N]) -> PyResult<[&'a [T]; N]> {
    let mut slices = [&[][..]; N];
    for (slice, array) in slices.iter_mut().zip(arrays) {
        *slice = array.as_slice()?;
    }
    Ok(slices)
}

/// The slices of arrays for results.
pub fn slices_mut<'a, T: Element, const N: usize>(arrays: &'a mut [Made<'_, T>; N]) -> PyResult<[&'a mut [T]; N]> {
    let mut slices: [&mut [T]; N] = std::array::from_fn(|_| Default::default());
    for (slice, array) in slices.iter_mut().zip(arrays) {
        *slice = array.as_slice_mut()?;
    }
    Ok(slices)
}
