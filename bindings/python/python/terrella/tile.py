"""Tiles of a cube map: keys, boxes and coverings."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _terrella
from .arrays import ellipsoid_of, flat, plain, results, threads_for, warn


class Tile(NamedTuple):
    """A tile of a face: at a level, column i and row j are 0 to 2^level − 1."""

    face: NDArray | int
    level: NDArray | int
    i: NDArray | int
    j: NDArray | int


class Tiles:
    """Tiles of a cube map, with keys of 64 bits along Hilbert's curve.

    With the projection ``"s2-quadratic"`` and the shift ``"geodetic"`` keys are S2's cell ids.

    >>> s2 = Tiles("s2-quadratic", shift="geodetic")
    >>> hex(s2.key(lat=48.8566, lon=2.3522, level=12))
    '0x47e66e1000000000'
    """

    def __init__(
        self, projection: str, *, shift: str = "authalic", ellipsoid: str | tuple[float, float] = "wgs84"
    ) -> None:
        self.projection, self.shift, self.ellipsoid = projection, shift, ellipsoid_of(ellipsoid)
        self._map = _terrella.Map(*self.ellipsoid, shift, projection)

    def key(
        self, *, lat: ArrayLike, lon: ArrayLike, level: int, threads: int | None = None
    ) -> NDArray[np.uint64] | np.uint64:
        """Keys of the tiles of a level, 0 to 30, that contain places; 0 where there is no place."""
        shape, places = flat([lat, lon], [np.float64] * 2)
        (keys,) = results(shape, [np.uint64], None)
        made = [keys.reshape(-1)]
        warn(_terrella.keys(self._map, level, threads_for(keys.size, threads), places, made), places, made)
        return plain(keys)

    def of_key(self, key: ArrayLike, *, threads: int | None = None) -> Tile:
        """Tiles of keys. Raises ``ValueError`` for what is the key of no tile."""
        shape, keys = flat([key], [np.uint64])
        made = results(shape, [np.uint8, np.uint8, np.uint32, np.uint32], None)
        face, level, i, j = (array.reshape(-1) for array in made)
        refused = _terrella.keys_to_tiles(threads_for(keys[0].size, threads), keys, [face, level], [i, j])
        if refused:
            raise ValueError(f"element {refused[1]}: {refused[2]}")
        return Tile(*map(plain, made))

    def key_of(
        self, *, face: ArrayLike, level: ArrayLike, i: ArrayLike, j: ArrayLike, threads: int | None = None
    ) -> NDArray[np.uint64] | np.uint64:
        """Keys of tiles. Raises ``ValueError`` for what is no tile."""
        shape, (faces, levels, *squares) = flat([face, level, i, j], [np.uint8, np.uint8, np.uint32, np.uint32])
        (keys,) = results(shape, [np.uint64], None)
        number = threads_for(keys.size, threads)
        refused = _terrella.tiles_to_keys(number, [faces, levels], squares, [keys.reshape(-1)])
        if refused:
            raise ValueError(f"element {refused[1]}: {refused[2]}")
        return plain(keys)

    def bounds(self, key: int) -> tuple[float, float, float, float]:
        """South, west, north and east in degrees of a box that holds the tile; east < west if it crosses ±180°."""
        return _terrella.bounds(self._map, int(key))

    def cover(
        self,
        *,
        south: float,
        west: float,
        north: float,
        east: float,
        level: int,
        inner: bool = False,
        mixed: bool = False,
        limit: int = 1_000_000,
    ) -> NDArray[np.uint64]:
        """Keys, sorted, of the tiles of a level that cover a box.

        ``inner`` gives those inside it alone; ``mixed`` coarser ones where they are inside. More than ``limit`` are refused.
        """
        keys = _terrella.cover(self._map, south, west, north, east, level, inner, mixed, limit)
        return np.array(keys, np.uint64)
