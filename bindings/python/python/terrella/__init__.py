"""Geodesics, Earth axes, cube maps and terrain tiles on the ellipsoid: exact and fast, over NumPy arrays.

Functions broadcast as NumPy's do, and take latitude and longitude by keyword, so that nobody exchanges them. Angles are in
degrees, azimuths clockwise from north, lengths in metres. Where an element is NaN, so is its result. An element that is
refused for another reason (a latitude of 95) also gives NaN, and a ``RefusedWarning`` says how many there are and why the
first was. Arrays of ``float32`` are computed in single precision, all others in double.
"""

from ._terrella import ELLIPSOIDS, LATITUDES, METHODS, PROJECTIONS, SHIFTS
from .arrays import RefusedWarning
from .cube import CubeMap, FacePoint
from .geod import Geod
from .geodesic import Area, Direct, Geodesic, Inverse
from .grid import MgrsGrid, Utm
from .healpix import Healpix
from .position import Aer, Ecef, Enu, Geodetic, LocalFrame, Ned, Place, convert_latitude, ecef_to_geodetic, geodetic_to_ecef
from .tile import Tile, Tiles

__all__ = [
    "ELLIPSOIDS",
    "LATITUDES",
    "METHODS",
    "PROJECTIONS",
    "SHIFTS",
    "Aer",
    "Area",
    "CubeMap",
    "Direct",
    "Ecef",
    "Enu",
    "FacePoint",
    "Geod",
    "Geodesic",
    "Geodetic",
    "Healpix",
    "Inverse",
    "LocalFrame",
    "MgrsGrid",
    "Ned",
    "Place",
    "RefusedWarning",
    "Tile",
    "Tiles",
    "Utm",
    "convert_latitude",
    "ecef_to_geodetic",
    "geodetic_to_ecef",
]
