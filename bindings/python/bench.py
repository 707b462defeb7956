"""Times beside other packages: a million points, one thread, medians of rounds in which each has its turn.

Needs terrella, pyproj, geographiclib, pymap3d and healpy. Run it pinned: ``taskset --cpu-list 1 python bench.py``.
"""

import statistics
import time

import healpy
import numpy as np
import pymap3d
import pyproj
import terrella
from geographiclib.geodesic import Geodesic

COUNT, ROUNDS = 1_000_000, 5
RNG = np.random.default_rng(1)


def places():
    return np.degrees(np.arcsin(RNG.uniform(-1, 1, COUNT))), RNG.uniform(-180, 180, COUNT)


(lat1, lon1), (lat2, lon2) = places(), places()
height = RNG.uniform(0, 1e4, COUNT)
ours, theirs = terrella.Geodesic(), pyproj.Geod(ellps="WGS84")
line = ours.inverse(lat1=lat1, lon1=lon1, lat2=lat2, lon2=lon2)
point = terrella.geodetic_to_ecef(lat=lat1, lon=lon1, height=height)
transformer = pyproj.Transformer.from_crs(4979, 4978)
back = pyproj.Transformer.from_crs(4978, 4979)
sphere = terrella.Healpix(12, ellipsoid=(1.0, 0.0))
# 20 000 rings of 50 corners.
offsets = np.arange(0, COUNT + 1, 50)
middle = np.repeat(lat1[offsets[:-1]] * 0.9, 50), np.repeat(lon1[offsets[:-1]], 50)
turn = np.tile(np.linspace(0, 2 * np.pi, 50, endpoint=False), COUNT // 50)
ring_lat, ring_lon = middle[0] + 0.3 * np.sin(turn), middle[1] + 0.3 * np.cos(turn)


def haversine():
    a1, b1, a2, b2 = map(np.radians, (lat1, lon1, lat2, lon2))
    h = np.sin((a2 - a1) / 2) ** 2 + np.cos(a1) * np.cos(a2) * np.sin((b2 - b1) / 2) ** 2
    return 2 * 6371008.8 * np.arcsin(np.sqrt(h))


# By topic: names, bodies, and how many calls they make.
TOPICS = {
    "distance and azimuths": {
        "terrella": (lambda: ours.inverse(lat1=lat1, lon1=lon1, lat2=lat2, lon2=lon2, threads=1), COUNT),
        "pyproj": (lambda: theirs.inv(lon1, lat1, lon2, lat2), COUNT),
        "geographiclib": (lambda: [Geodesic.WGS84.Inverse(*row) for row in zip(lat1[:2000], lon1[:2000], lat2[:2000], lon2[:2000])], 2000),
        "NumPy's haversine, sphere": (haversine, COUNT),
    },
    "destination": {
        "terrella": (lambda: ours.direct(lat=lat1, lon=lon1, azimuth=line.azimuth1, distance=line.distance, threads=1), COUNT),
        "pyproj": (lambda: theirs.fwd(lon1, lat1, line.azimuth1, line.distance), COUNT),
    },
    "place to Earth axes": {
        "terrella": (lambda: terrella.geodetic_to_ecef(lat=lat1, lon=lon1, height=height, threads=1), COUNT),
        "pyproj": (lambda: transformer.transform(lat1, lon1, height), COUNT),
        "pymap3d": (lambda: pymap3d.geodetic2ecef(lat1, lon1, height), COUNT),
    },
    "Earth axes to place": {
        "terrella": (lambda: terrella.ecef_to_geodetic(**point._asdict(), threads=1), COUNT),
        "pyproj": (lambda: back.transform(*point), COUNT),
        "pymap3d": (lambda: pymap3d.ecef2geodetic(*point), COUNT),
    },
    "HEALPix number": {
        "terrella": (lambda: sphere.pixel(lat=lat1, lon=lon1, threads=1), COUNT),
        "healpy": (lambda: healpy.ang2pix(1 << 12, lon1, lat1, nest=True, lonlat=True), COUNT),
    },
    "area of a ring, a corner": {
        "terrella": (lambda: terrella.Area().rings(lat=ring_lat, lon=ring_lon, offsets=offsets, threads=1), COUNT),
        "pyproj's loop": (lambda: [theirs.polygon_area_perimeter(ring_lon[a : a + 50], ring_lat[a : a + 50]) for a in offsets[:1000]], 50_000),
    },
}

for topic, bodies in TOPICS.items():
    times = {name: [] for name in bodies}
    for _ in range(ROUNDS):
        for name, (body, calls) in bodies.items():
            start = time.perf_counter()
            body()
            times[name].append((time.perf_counter() - start) * 1e9 / calls)
    base = statistics.median(times["terrella"])
    for name, all_times in times.items():
        median = statistics.median(all_times)
        print(f"{topic}\t{name}\t{median:.0f} ns\t{median / base:.1f}")
