"""Earth axes, local frames and latitudes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from numpy.typing import ArrayLike, NDArray

from .arrays import call, ellipsoid_of


class Place(NamedTuple):
    """In degrees."""

    lat: NDArray | float
    lon: NDArray | float


class Geodetic(NamedTuple):
    """In degrees, and metres above the ellipsoid."""

    lat: NDArray | float
    lon: NDArray | float
    height: NDArray | float


class Ecef(NamedTuple):
    """In metres: x toward 0° N 0° E, y toward 0° N 90° E, z toward the north pole."""

    x: NDArray | float
    y: NDArray | float
    z: NDArray | float


class Enu(NamedTuple):
    """In metres."""

    east: NDArray | float
    north: NDArray | float
    up: NDArray | float


class Ned(NamedTuple):
    """In metres."""

    north: NDArray | float
    east: NDArray | float
    down: NDArray | float


class Aer(NamedTuple):
    """Azimuth in degrees clockwise from north, elevation in degrees, range in metres."""

    azimuth: NDArray | float
    elevation: NDArray | float
    range: NDArray | float


def geodetic_to_ecef(
    *,
    lat: ArrayLike,
    lon: ArrayLike,
    height: ArrayLike = 0.0,
    ellipsoid: str | tuple[float, float] = "wgs84",
    out: Sequence[NDArray] | None = None,
    threads: int | None = None,
) -> Ecef:
    """Earth-centred, Earth-fixed coordinates of places, to 1 nm below 100 km.

    >>> geodetic_to_ecef(lat=0, lon=90).y
    np.float64(6378137.0)
    """
    return Ecef(*call("to_ecef", [ellipsoid_of(ellipsoid)], [lat, lon, height], 3, out=out, threads=threads))


def ecef_to_geodetic(
    *,
    x: ArrayLike,
    y: ArrayLike,
    z: ArrayLike,
    ellipsoid: str | tuple[float, float] = "wgs84",
    out: Sequence[NDArray] | None = None,
    threads: int | None = None,
) -> Geodetic:
    """Latitudes, longitudes and heights of points, to 2.2 nm below 100 km and down to the centre."""
    return Geodetic(*call("to_geodetic", [ellipsoid_of(ellipsoid)], [x, y, z], 3, out=out, threads=threads))


def convert_latitude(
    latitude: ArrayLike,
    *,
    source: str,
    target: str,
    ellipsoid: str | tuple[float, float] = "wgs84",
    threads: int | None = None,
) -> NDArray | float:
    """From one of ``LATITUDES`` to another, in degrees.

    >>> round(float(convert_latitude(45.0, source="geodetic", target="authalic")), 6)
    44.871703
    """
    return call("latitude", [ellipsoid_of(ellipsoid), source, target], [latitude], 1, threads=threads)[0]


class LocalFrame:
    """Axes about an origin: ``enu``, ``ned`` or ``aer``.

    >>> seen = LocalFrame(lat=52, lon=8, height=110).to_aer(lat=52.1, lon=8.3, height=10_000)
    >>> [round(float(part), 1) for part in seen]
    [61.5, 22.8, 25417.3]
    """

    def __init__(
        self, *, lat: float, lon: float, height: float = 0.0, ellipsoid: str | tuple[float, float] = "wgs84"
    ) -> None:
        self.ellipsoid = ellipsoid_of(ellipsoid)
        self.origin = (float(lat), float(lon), float(height))
        self.to_enu(lat=lat, lon=lon, height=height)

    def _call(self, way: str, given: Sequence[ArrayLike], threads: int | None) -> list[NDArray | float]:
        return call("frame", [way, self.ellipsoid, self.origin], given, 3, threads=threads)

    def to_enu(self, *, lat: ArrayLike, lon: ArrayLike, height: ArrayLike = 0.0, threads: int | None = None) -> Enu:
        """East, north and up of places."""
        return Enu(*self._call("to_enu", [lat, lon, height], threads))

    def to_ned(self, *, lat: ArrayLike, lon: ArrayLike, height: ArrayLike = 0.0, threads: int | None = None) -> Ned:
        """North, east and down of places."""
        return Ned(*self._call("to_ned", [lat, lon, height], threads))

    def to_aer(self, *, lat: ArrayLike, lon: ArrayLike, height: ArrayLike = 0.0, threads: int | None = None) -> Aer:
        """Azimuth, elevation and range of places."""
        return Aer(*self._call("to_aer", [lat, lon, height], threads))

    def from_enu(self, *, east: ArrayLike, north: ArrayLike, up: ArrayLike, threads: int | None = None) -> Geodetic:
        """Places of east, north and up."""
        return Geodetic(*self._call("from_enu", [east, north, up], threads))

    def from_ned(self, *, north: ArrayLike, east: ArrayLike, down: ArrayLike, threads: int | None = None) -> Geodetic:
        """Places of north, east and down."""
        return Geodetic(*self._call("from_ned", [north, east, down], threads))

    def from_aer(
        self, *, azimuth: ArrayLike, elevation: ArrayLike, range: ArrayLike, threads: int | None = None
    ) -> Geodetic:
        """Places of azimuth, elevation and range."""
        return Geodetic(*self._call("from_aer", [azimuth, elevation, range], threads))
