"""Distances, azimuths, destinations and areas."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _terrella
from .arrays import call, ellipsoid_of, flat, plain, results, threads_for, warn


class Inverse(NamedTuple):
    """The line between two places."""

    #: In metres.
    distance: NDArray | float
    #: At the first place, in degrees clockwise from north.
    azimuth1: NDArray | float
    #: At the second place, in the direction of travel.
    azimuth2: NDArray | float


class Direct(NamedTuple):
    """The end of a line."""

    lat: NDArray | float
    lon: NDArray | float
    #: In the direction of travel, in degrees clockwise from north.
    azimuth: NDArray | float


class Geodesic:
    """Distances, azimuths and destinations on an ellipsoid, by one of ``METHODS``.

    ``"karney"`` is exact to 7 nm between any two places on the Earth (C. F. F. Karney, J. Geodesy 87, 2013). Methods that
    hold about a place only (``"plane"``) take it as ``about=(lat, lon)``.

    >>> earth = Geodesic("wgs84")
    >>> round(float(earth.distance(lat1=40.6, lon1=-73.8, lat2=51.6, lon2=-0.5)), 3)
    5551759.4

    Raises ``ValueError`` for a name that is not known, and for a flattening outside the range of the method.
    """

    def __init__(
        self,
        ellipsoid: str | tuple[float, float] = "wgs84",
        *,
        method: str = "karney",
        about: tuple[float, float] | None = None,
    ) -> None:
        self.ellipsoid = ellipsoid_of(ellipsoid)
        self.method = method
        self._solver = _terrella.Solver(method, *self.ellipsoid, about)

    def __repr__(self) -> str:
        return f"Geodesic({self.ellipsoid}, method={self.method!r})"

    def inverse(
        self,
        *,
        lat1: ArrayLike,
        lon1: ArrayLike,
        lat2: ArrayLike,
        lon2: ArrayLike,
        out: Sequence[NDArray] | None = None,
        threads: int | None = None,
    ) -> Inverse:
        """Distances in metres and azimuths in degrees at both ends. Arrays broadcast; ``out`` is three arrays."""
        return Inverse(*call("inverse", [self._solver], [lat1, lon1, lat2, lon2], 3, out=out, threads=threads))

    def distance(
        self,
        *,
        lat1: ArrayLike,
        lon1: ArrayLike,
        lat2: ArrayLike,
        lon2: ArrayLike,
        out: NDArray | None = None,
        threads: int | None = None,
    ) -> NDArray | float:
        """Distances alone, in metres, which takes less time."""
        given = [lat1, lon1, lat2, lon2]
        return call("distance", [self._solver], given, 1, out=None if out is None else [out], threads=threads)[0]

    def direct(
        self,
        *,
        lat: ArrayLike,
        lon: ArrayLike,
        azimuth: ArrayLike,
        distance: ArrayLike,
        out: Sequence[NDArray] | None = None,
        threads: int | None = None,
    ) -> Direct:
        """Where one comes from places at azimuths in degrees after distances in metres."""
        return Direct(*call("direct", [self._solver], [lat, lon, azimuth, distance], 3, out=out, threads=threads))

    def along(
        self, *, lat: float, lon: float, azimuth: float, distance: ArrayLike, threads: int | None = None
    ) -> Direct:
        """Places of one geodesic, Karney's, at distances in metres from its start."""
        start = (float(lat), float(lon), float(azimuth))
        return Direct(*call("along", [self.ellipsoid, start], [distance], 3, threads=threads, scalar=np.float64))


class Area:
    """Areas and perimeters of rings whose edges are geodesics of an ellipsoid. The last corner is joined to the first.

    >>> round(float(Area("wgs84").ring(lat=[0, 0, 90], lon=[0, 90, 0])[0] / 1e9), 3)  # an eighth of the Earth
    63758.203
    """

    def __init__(self, ellipsoid: str | tuple[float, float] = "wgs84") -> None:
        self.ellipsoid = ellipsoid_of(ellipsoid)

    def rings(
        self, *, lat: ArrayLike, lon: ArrayLike, offsets: ArrayLike, threads: int | None = None
    ) -> tuple[NDArray, NDArray]:
        """Areas in m², positive counter-clockwise, and perimeters in metres of rings in flat arrays.

        Ring r has the corners ``offsets[r]`` up to ``offsets[r + 1]``, as GeoArrow and ``shapely.to_ragged_array`` have them.
        """
        _, corners = flat([lat, lon], [np.float64] * 2)
        shape, (bounds,) = flat([offsets], [np.int64])
        if len(shape) != 1 or bounds.size == 0:
            raise ValueError(f"expected offsets of one dimension, at least one, got shape {shape}")
        made = results((bounds.size - 1,), [np.float64] * 2, None)
        refused = _terrella.rings_f64(self.ellipsoid, threads_for(corners[0].size, threads), bounds, corners, made)
        warn(refused, [np.zeros(bounds.size - 1)], made)
        return made[0], made[1]

    def ring(self, *, lat: ArrayLike, lon: ArrayLike) -> tuple[float, float]:
        """Area in m² and perimeter in metres of one ring."""
        areas, perimeters = self.rings(lat=lat, lon=lon, offsets=[0, np.size(lat)])
        return plain(areas[0]), plain(perimeters[0])
