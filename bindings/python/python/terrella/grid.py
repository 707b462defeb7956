"""UTM, UPS and MGRS."""

from __future__ import annotations

import warnings
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _terrella
from .arrays import RefusedWarning, ellipsoid_of, flat, plain, results
from .position import Place


class Utm(NamedTuple):
    """A position of UTM, or of UPS where the zone is 0, in metres."""

    zone: NDArray | int
    northern: NDArray | bool
    easting: NDArray | float
    northing: NDArray | float


class MgrsGrid:
    """Zones of UTM and UPS, and the squares of MGRS in them.

    >>> MgrsGrid().square(lat=21.3088, lon=-157.8261, precision=4)
    '04QFJ21755677'
    """

    def __init__(self, ellipsoid: str | tuple[float, float] = "wgs84") -> None:
        self.ellipsoid = ellipsoid_of(ellipsoid)

    def utm(self, *, lat: ArrayLike, lon: ArrayLike) -> Utm:
        """Zones, hemispheres, eastings and northings, to 5 nm."""
        shape, places = flat([lat, lon], [np.float64] * 2)
        zone, northern, easting, northing = results(shape, [np.uint8, np.uint8, np.float64, np.float64], None)
        bytes_, metres = ([array.reshape(-1) for array in pair] for pair in ((zone, northern), (easting, northing)))
        self._warn(_terrella.utm(self.ellipsoid, places, bytes_, metres), places)
        return Utm(plain(zone), plain(northern.astype(bool)), plain(easting), plain(northing))

    def place(self, *, zone: ArrayLike, northern: ArrayLike, easting: ArrayLike, northing: ArrayLike) -> Place:
        """Places of positions of UTM and UPS."""
        dtypes = [np.uint8, np.uint8, np.float64, np.float64]
        shape, (zones, norths, *metres) = flat([zone, northern, easting, northing], dtypes)
        made = results(shape, [np.float64] * 2, None)
        columns = [array.reshape(-1) for array in made]
        self._warn(_terrella.from_utm(self.ellipsoid, [zones, norths], metres, columns), metres)
        return Place(*map(plain, made))

    def square(self, *, lat: float, lon: float, precision: int = 5) -> str:
        """The text of the square of a place, with 0 to 11 digits for each direction."""
        return _terrella.mgrs(self.ellipsoid, float(lat), float(lon), precision)

    def middle(self, square: str) -> Place:
        """The middle of a square."""
        return Place(*_terrella.from_mgrs(self.ellipsoid, square))

    @staticmethod
    def _warn(refused: int, given: list[NDArray]) -> None:
        missing = np.count_nonzero(np.logical_or.reduce([np.isnan(array) for array in given]))
        if refused > missing:
            warnings.warn(f"{refused} elements are refused", RefusedWarning, stacklevel=3)
