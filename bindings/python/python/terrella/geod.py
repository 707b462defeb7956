"""pyproj's ``Geod``: its methods, with its arguments in its order, and its results."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from .arrays import ellipsoid_of
from .geodesic import Area, Geodesic

#: PROJ's names of ellipsoids, and ours.
NAMES = {
    "WGS84": "wgs84",
    "GRS80": "grs80",
    "clrk66": "clarke1866",
    "intl": "international1924",
    "airy": "airy1830",
    "mod_airy": "airy-modified",
    "bessel": "bessel1841",
    "krass": "krassovsky1940",
}


class GeodIntermediateReturn(NamedTuple):
    """Places along a line: how many, how far apart in metres, the whole distance, and the places."""

    npts: int
    del_s: float
    dist: float
    lons: Any
    lats: Any
    azis: Any


class Geod:
    """Geodesics with the interface of ``pyproj.Geod``: longitude first, by position; the azimuth back.

    >>> geod = Geod(ellps="clrk66")
    >>> az12, az21, dist = geod.inv(-71.11666, 42.25, -123.68333, 45.51667)
    >>> f"{az12:.3f} {az21:.3f} {dist:.3f}"
    '-66.531 75.654 4164192.869'

    An ellipsoid is one of PROJ's names (``ellps="WGS84"``), or ``a`` with one of ``b``, ``f``, ``rf`` and ``es``.
    """

    def __init__(self, initstring: str | None = None, **kwargs: Any) -> None:
        if initstring is not None:
            for word in initstring.split():
                name, _, value = word.removeprefix("+").partition("=")
                kwargs.setdefault(name, value if name == "ellps" else float(value or "nan"))
        self.a, self.f = _ellipsoid(kwargs)
        self.b = self.a * (1 - self.f)
        self.es = self.f * (2 - self.f)
        self.sphere = self.f == 0
        self.initstring = f"+a={self.a} +f={self.f}"
        self._geodesic = Geodesic((self.a, self.f))
        self._area = Area((self.a, self.f))

    def __repr__(self) -> str:
        return f"Geod({self.initstring!r})"

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Geod) and (self.a, self.f) == (other.a, other.f)

    __hash__ = None  # as pyproj's

    def fwd(
        self,
        lons: Any,
        lats: Any,
        az: Any,
        dist: Any,
        radians: bool = False,
        inplace: bool = False,
        return_back_azimuth: bool = True,
    ) -> tuple[Any, Any, Any]:
        """Longitudes, latitudes and azimuths back of the ends of lines."""
        degrees = _degrees(radians)
        end = self._geodesic.direct(lat=degrees(lats), lon=degrees(lons), azimuth=degrees(az), distance=dist)
        azimuth = _back(end.azimuth) if return_back_azimuth else end.azimuth
        return _like([lons, lats, az], [_angle(part, radians) for part in (end.lon, end.lat, azimuth)], inplace)

    def inv(
        self,
        lons1: Any,
        lats1: Any,
        lons2: Any,
        lats2: Any,
        radians: bool = False,
        inplace: bool = False,
        return_back_azimuth: bool = True,
    ) -> tuple[Any, Any, Any]:
        """Azimuths forward and back, and distances."""
        degrees = _degrees(radians)
        line = self._geodesic.inverse(
            lat1=degrees(lats1), lon1=degrees(lons1), lat2=degrees(lats2), lon2=degrees(lons2)
        )
        azimuth2 = _back(line.azimuth2) if return_back_azimuth else line.azimuth2
        parts = [_angle(line.azimuth1, radians), _angle(azimuth2, radians), line.distance]
        return _like([lons1, lats1, lons2], parts, inplace)

    def npts(
        self,
        lon1: float,
        lat1: float,
        lon2: float,
        lat2: float,
        npts: int,
        radians: bool = False,
        initial_idx: int = 1,
        terminus_idx: int = 1,
    ) -> list[tuple[float, float]]:
        """Longitudes and latitudes of places between two, at equal distances."""
        points = self.inv_intermediate(
            lon1, lat1, lon2, lat2, npts, initial_idx=initial_idx, terminus_idx=terminus_idx, radians=radians
        )
        return list(zip(points.lons.tolist(), points.lats.tolist()))

    def inv_intermediate(
        self,
        lon1: float,
        lat1: float,
        lon2: float,
        lat2: float,
        npts: int = 0,
        del_s: float = 0,
        initial_idx: int = 1,
        terminus_idx: int = 1,
        radians: bool = False,
        return_back_azimuth: bool = True,
    ) -> GeodIntermediateReturn:
        """Places between two: so many, or as many as fit best into steps of ``del_s`` metres, which are made equal then."""
        azimuth, _, dist = self.inv(lon1, lat1, lon2, lat2, radians=radians)
        if npts == 0:
            if not del_s > 0:
                raise ValueError(f"expected npts, or del_s above 0, got {npts} and {del_s}")
            npts = int(np.floor(dist / del_s - initial_idx - terminus_idx + 1 + 0.5))
        step = dist / (npts + initial_idx + terminus_idx - 1)
        points = self.fwd_intermediate(
            lon1, lat1, azimuth, npts, step, initial_idx, terminus_idx, radians, return_back_azimuth
        )
        return points._replace(dist=dist)

    def fwd_intermediate(
        self,
        lon1: float,
        lat1: float,
        azi1: float,
        npts: int,
        del_s: float,
        initial_idx: int = 1,
        terminus_idx: int = 1,
        radians: bool = False,
        return_back_azimuth: bool = True,
    ) -> GeodIntermediateReturn:
        """Places at steps of ``del_s`` metres along a line."""
        degrees = _degrees(radians)
        distances = (initial_idx + np.arange(npts)) * del_s
        points = self._geodesic.along(
            lat=float(degrees(lat1)), lon=float(degrees(lon1)), azimuth=float(degrees(azi1)), distance=distances
        )
        azimuth = _back(points.azimuth) if return_back_azimuth else points.azimuth
        lons, lats, azis = (_angle(part, radians) for part in (points.lon, points.lat, azimuth))
        dist = del_s * (npts + initial_idx + terminus_idx - 1)
        return GeodIntermediateReturn(npts, del_s, dist, lons, lats, azis)

    def line_length(self, lons: Any, lats: Any, radians: bool = False) -> float:
        """The length of a line through places."""
        return float(np.sum(self._legs(lons, lats, radians)))

    def line_lengths(self, lons: Any, lats: Any, radians: bool = False) -> Any:
        """The lengths of the legs of a line through places."""
        return _like([lons], [self._legs(lons, lats, radians)], False)[0]

    def _legs(self, lons: Any, lats: Any, radians: bool) -> np.ndarray:
        degrees = _degrees(radians)
        lon, lat = np.atleast_1d(degrees(lons)), np.atleast_1d(degrees(lats))
        return self._geodesic.distance(lat1=lat[:-1], lon1=lon[:-1], lat2=lat[1:], lon2=lon[1:])

    def polygon_area_perimeter(self, lons: Any, lats: Any, radians: bool = False) -> tuple[float, float]:
        """The area, positive counter-clockwise, and the perimeter of a ring."""
        degrees = _degrees(radians)
        area, perimeter = self._area.ring(lat=degrees(lats), lon=degrees(lons))
        return float(area), float(perimeter)

    def geometry_length(self, geometry: Any, radians: bool = False) -> float:
        """The length of a geometry of shapely: of its lines, and of its rings."""
        if hasattr(geometry, "geoms"):
            return sum(self.geometry_length(part, radians) for part in geometry.geoms)
        if hasattr(geometry, "exterior"):
            return self.geometry_length(geometry.exterior, radians)
        if geometry.geom_type == "Point":
            return 0.0
        return self.line_length(*_xy(geometry), radians)

    def geometry_area_perimeter(self, geometry: Any, radians: bool = False) -> tuple[float, float]:
        """The area and the perimeter of a geometry of shapely, without its holes."""
        if hasattr(geometry, "geoms"):
            parts = [self.geometry_area_perimeter(part, radians) for part in geometry.geoms]
            return sum(area for area, _ in parts), sum(perimeter for _, perimeter in parts)
        if hasattr(geometry, "exterior"):
            area, perimeter = self.polygon_area_perimeter(*_xy(geometry.exterior), radians)
            # A hole runs the other way round its own area.
            holes = [self.polygon_area_perimeter(*_xy(hole), radians)[0] for hole in geometry.interiors]
            return area - np.copysign(sum(map(abs, holes)), area), perimeter
        return 0.0, self.geometry_length(geometry, radians)


def _ellipsoid(given: dict[str, Any]) -> tuple[float, float]:
    if "ellps" in given:
        name = given["ellps"]
        return ellipsoid_of(NAMES.get(name, name))
    if "a" not in given:
        raise ValueError('expected ellps="…", or a with one of b, f, rf and es')
    a = float(given["a"])
    if "b" in given:
        return a, (a - float(given["b"])) / a
    if "f" in given:
        return a, float(given["f"])
    if "rf" in given:
        return a, 1 / float(given["rf"])
    if "es" in given:
        return a, 1 - np.sqrt(1 - float(given["es"]))
    return a, 0.0


def _degrees(radians: bool) -> Any:
    return (lambda angle: np.rad2deg(np.asarray(angle, float))) if radians else (lambda angle: np.asarray(angle, float))


def _angle(degrees: Any, radians: bool) -> Any:
    return np.deg2rad(degrees) if radians else degrees


def _back(azimuth: Any) -> Any:
    return azimuth + np.where(np.asarray(azimuth) > 0, -180.0, 180.0)


def _xy(line: Any) -> Sequence[Any]:
    coordinates = np.asarray(line.coords, float)
    return coordinates[:, 0], coordinates[:, 1]


def _like(given: Sequence[Any], made: Sequence[Any], inplace: bool) -> tuple[Any, ...]:
    """Results in the kind of what was given: floats, lists, tuples or arrays; into the arrays given if in place."""

    def like(given: Any, made: Any) -> Any:
        if inplace and isinstance(given, np.ndarray):
            given[...] = made
            return given
        if isinstance(given, (list, tuple)):
            return type(given)(np.asarray(made).tolist())
        return float(made) if np.ndim(made) == 0 else np.asarray(made)

    return tuple(like(one, other) for one, other in zip(given, made))
