"""Shapes: any arrays to flat ones of one length, and results back."""

from __future__ import annotations

import os
import warnings
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _terrella

#: From this many elements on the work is shared by threads, if none are asked for.
SHARED = 50_000

#: More threads than this are refused.
MOST_THREADS = 1024


class RefusedWarning(RuntimeWarning):
    """Elements were refused, and their results are NaN."""


def threads_for(count: int, threads: int | None) -> int:
    """The threads for so many elements: those asked for, or as many as this process may use if it pays."""
    if threads is None:
        return _processors() if count >= SHARED else 1
    if not 1 <= threads <= MOST_THREADS:
        raise ValueError(f"expected 1 to {MOST_THREADS} threads, got {threads}")
    return threads


def _processors() -> int:
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def scalar_of(given: Sequence[ArrayLike]) -> type:
    """``float32`` if NumPy's result of all of them is, else ``float64``. Python's own numbers have no say."""
    arrays = [array for array in given if type(array) not in (int, float, bool)]
    return np.float32 if arrays and np.result_type(*map(np.asarray, arrays)) == np.float32 else np.float64


def flat(given: Sequence[ArrayLike], dtypes: Sequence[DTypeLike]) -> tuple[tuple[int, ...], list[NDArray]]:
    """The common shape of arrays, and each as a contiguous array of one dimension. Masked elements become NaN."""
    whole = np.broadcast_arrays(*(_numbers(array, np.dtype(dtype)) for array, dtype in zip(given, dtypes)))
    return whole[0].shape, [np.require(array, requirements="CA").reshape(-1) for array in whole]


def _numbers(given: ArrayLike, dtype: np.dtype) -> NDArray:
    """An array of a type; refused if that would change a number by more than rounding."""
    array = np.ma.asarray(given) if np.ma.isMaskedArray(given) else np.asarray(given)
    if array.dtype.kind not in "biuf":
        raise TypeError(f"expected real numbers, got {array.dtype}")
    if dtype.kind == "f":
        array = array.astype(dtype, copy=False)
        return array.filled(np.nan) if np.ma.isMaskedArray(array) else array
    if array.dtype.kind == "f" and array.size:
        raise TypeError(f"expected whole numbers, got {array.dtype}")
    if np.ma.is_masked(array):
        raise ValueError("whole numbers may not be masked")
    limits = np.iinfo(dtype)
    wrong = array[(array < limits.min) | (array > limits.max)] if array.dtype.kind in "iu" else array[:0]
    if wrong.size:
        raise ValueError(f"{wrong.flat[0]} is not in {limits.min} to {limits.max}")
    return np.asarray(array).astype(dtype, copy=False)


def results(shape: tuple[int, ...], dtypes: Sequence[DTypeLike], out: Sequence[NDArray] | None) -> list[NDArray]:
    """Arrays for results: the caller's if they are given, else new ones."""
    if out is None:
        return [np.empty(shape, dtype) for dtype in dtypes]
    if len(out) != len(dtypes):
        raise ValueError(f"expected {len(dtypes)} arrays for results, got {len(out)}")
    for array, dtype in zip(out, dtypes):
        if array.shape != shape or array.dtype != dtype or not array.flags.c_contiguous or not array.flags.writeable:
            raise ValueError(
                f"expected contiguous, writeable arrays of shape {shape} and type {np.dtype(dtype)} for results, "
                f"got one of shape {array.shape} and type {array.dtype}"
            )
    return list(out)


def warn(refused: tuple[int, int, str] | None, given: Sequence[NDArray], made: Sequence[NDArray]) -> None:
    """Warns of refused elements, unless what was given of each has a NaN. Their results are NaN, or 0 in whole numbers."""
    if refused is None:
        return
    missing = np.zeros(given[0].shape, bool)
    for array in given:
        if array.dtype.kind == "f":
            missing |= np.isnan(array)
    _, first, why = refused
    floats = [array for array in made if array.dtype.kind == "f"]
    none = np.isnan(floats[0]) if floats else made[0] == 0
    count = np.count_nonzero(none & ~missing)
    if count:
        if missing[first]:
            first = int(np.argmax(none & ~missing))
            why = ", ".join(str(array[first]) for array in given)
        warnings.warn(f"{count} elements are refused; the first is element {first}: {why}", RefusedWarning, stacklevel=4)


def plain(array: NDArray) -> NDArray | float:
    """Arrays without a dimension as NumPy's own functions return them."""
    return array[()]


def call(
    name: str,
    leading: Sequence[object],
    given: Sequence[ArrayLike],
    outputs: int,
    *,
    out: Sequence[NDArray] | None = None,
    threads: int | None = None,
    scalar: type | None = None,
) -> list[NDArray | float]:
    """Calls a function of the module about arrays of one scalar."""
    scalar = scalar or scalar_of(given)
    shape, columns = flat(given, [scalar] * len(given))
    made = results(shape, [scalar] * outputs, out)
    function: Callable = getattr(_terrella, f"{name}_{'f32' if scalar is np.float32 else 'f64'}")
    number = threads_for(columns[0].size, threads)
    into = [array.reshape(-1) for array in made]
    warn(function(*leading, number, columns, into), columns, into)
    return [plain(array) for array in made]


def ellipsoid_of(ellipsoid: str | tuple[float, float]) -> tuple[float, float]:
    """Semi-major axis in metres and flattening of an ellipsoid of a name of ``ELLIPSOIDS``, or as they are."""
    return _terrella.ellipsoid(ellipsoid) if isinstance(ellipsoid, str) else (float(ellipsoid[0]), float(ellipsoid[1]))
