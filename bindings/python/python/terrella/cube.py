"""Cube maps: places to points of the faces of a cube, and back."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _terrella
from .arrays import ellipsoid_of, flat, plain, results, scalar_of, threads_for, warn
from .position import Place


class FacePoint(NamedTuple):
    """A face, 0 front (0° N 0° E), 1 right, 2 back, 3 left, 4 top, 5 bottom, as ``uint8``; x and y in [−1, 1]."""

    face: NDArray | int
    x: NDArray | float
    y: NDArray | float


class CubeMap:
    """A map of the ellipsoid onto the faces of a cube: one of ``PROJECTIONS``, behind one of ``SHIFTS``.

    >>> s2 = CubeMap("s2-quadratic", shift="geodetic")
    >>> int(s2.project(lat=0, lon=100).face)
    1
    """

    def __init__(
        self, projection: str, *, shift: str = "authalic", ellipsoid: str | tuple[float, float] = "wgs84"
    ) -> None:
        self.projection, self.shift, self.ellipsoid = projection, shift, ellipsoid_of(ellipsoid)
        self._map = _terrella.Map(*self.ellipsoid, shift, projection)

    def __repr__(self) -> str:
        return f"CubeMap({self.projection!r}, shift={self.shift!r}, ellipsoid={self.ellipsoid})"

    def project(self, *, lat: ArrayLike, lon: ArrayLike, threads: int | None = None) -> FacePoint:
        """Points of the faces for places."""
        scalar = scalar_of([lat, lon])
        shape, places = flat([lat, lon], [scalar] * 2)
        face, x, y = results(shape, [np.uint8, scalar, scalar], None)
        project = _terrella.project_f32 if scalar is np.float32 else _terrella.project_f64
        made = [array.reshape(-1) for array in (x, y)]
        warn(project(self._map, threads_for(face.size, threads), places, face.reshape(-1), made), places, made)
        return FacePoint(plain(face), plain(x), plain(y))

    def unproject(self, *, face: ArrayLike, x: ArrayLike, y: ArrayLike, threads: int | None = None) -> Place:
        """Places of points of the faces."""
        scalar = scalar_of([x, y])
        shape, (faces, *points) = flat([face, x, y], [np.uint8, scalar, scalar])
        lat, lon = results(shape, [scalar] * 2, None)
        unproject = _terrella.unproject_f32 if scalar is np.float32 else _terrella.unproject_f64
        made = [array.reshape(-1) for array in (lat, lon)]
        warn(unproject(self._map, threads_for(lat.size, threads), faces, points, made), points, made)
        return Place(plain(lat), plain(lon))
