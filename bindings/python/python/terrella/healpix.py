"""Pixels of standard HEALPix."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _terrella
from .arrays import ellipsoid_of, flat, plain, results, threads_for, warn
from .position import Place


class Healpix:
    """HEALPix of a depth, nside = 2^depth, in the nested scheme; on an ellipsoid by the authalic latitude.

    >>> int(Healpix(12).pixel(lat=59.91, lon=10.75))
    12427310
    """

    def __init__(self, depth: int, *, ellipsoid: str | tuple[float, float] = "wgs84") -> None:
        if not 0 <= depth <= 29:
            raise ValueError(f"depth {depth} is not in 0 to 29")
        self.depth, self.ellipsoid = depth, ellipsoid_of(ellipsoid)

    def pixel(
        self, *, lat: ArrayLike, lon: ArrayLike, threads: int | None = None
    ) -> NDArray[np.uint64] | np.uint64:
        """Numbers of the pixels that contain places; 0 where there is no place."""
        shape, places = flat([lat, lon], [np.float64] * 2)
        (numbers,) = results(shape, [np.uint64], None)
        number = threads_for(numbers.size, threads)
        made = [numbers.reshape(-1)]
        warn(_terrella.healpix_containing(self.ellipsoid, self.depth, number, places, made), places, made)
        return plain(numbers)

    def centre(self, pixel: ArrayLike, *, threads: int | None = None) -> Place:
        """Centres of pixels."""
        shape, numbers = flat([pixel], [np.uint64])
        made = results(shape, [np.float64] * 2, None)
        number = threads_for(numbers[0].size, threads)
        columns = [array.reshape(-1) for array in made]
        warn(_terrella.healpix_centre(self.ellipsoid, self.depth, number, numbers, columns), numbers, columns)
        return Place(*map(plain, made))
