#!/usr/bin/env python3
"""Writes enu_reverse.tsv: where a vector in the frame of a geodetic position leads. Needs mpmath; see README.md."""

import random
import struct

from mpmath import mp, mpf, cos, sin, sqrt, atan2, degrees, radians, nstr

mp.dps = 60
ELLIPSOIDS = {
    "wgs84": (mpf(6378137), 1 / mpf("298.257223563")),
    "moon": (mpf(1737400), mpf(0)),
    "oblate10": (mpf(6400000), mpf(1) / 10),
    "prolate150": (mpf(6400000), mpf(-1) / 150),
}


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def quarter(angle):
    """Sine and cosine of degrees, exact where they are 0 or 1."""
    s, c = sin(radians(mpf(angle))), cos(radians(mpf(angle)))
    return tuple(mpf(0) if abs(x) < mpf(10) ** -45 else x for x in (s, c))


def ecef(a, e2, lat, lon, h):
    (s, c), (sl, cl) = quarter(lat), quarter(lon)
    n = a / sqrt(1 - e2 * s**2)
    return (n + h) * c * cl, (n + h) * c * sl, (n * (1 - e2) + h) * s


def geodetic(a, e2, x, y, z):
    rho = sqrt(x * x + y * y)
    phi = atan2(z, rho * (1 - e2))
    for _ in range(150):
        n = a / sqrt(1 - e2 * sin(phi) ** 2)
        phi = atan2(z + e2 * n * sin(phi), rho)
    # h = rho cos + z sin - a W holds on the axis too.
    h = rho * cos(phi) + z * sin(phi) - a * sqrt(1 - e2 * sin(phi) ** 2)
    return degrees(phi), degrees(atan2(y, x)), h


def row(a, e2, origin, enu):
    lat, lon, h = origin
    (s, c), (sl, cl) = quarter(lat), quarter(lon)
    e, n, u = map(mpf, enu)
    out = c * u - s * n
    move = (cl * out - sl * e, sl * out + cl * e, s * u + c * n)
    point = [p + d for p, d in zip(ecef(a, e2, lat, lon, h), move)]
    there = geodetic(a, e2, *point)
    back = ecef(a, e2, *there)
    assert sqrt(sum((p - q) ** 2 for p, q in zip(point, back))) < mpf(10) ** -40
    turned = there[1] - mpf(lon)
    turned -= 360 * mp.nint(turned / 360)
    return there + (there[0] - mpf(lat), turned, there[2] - mpf(h))


def rows(a):
    rng = random.Random(5204)
    earth = a / 6400000
    height = lambda: rng.uniform(-10e3, 100e3)
    lon = lambda: rng.uniform(-180, 180)
    sign = lambda: rng.choice((-1, 1))

    def vector(reach):
        v = [rng.gauss(0, 1) for _ in range(3)]
        scale = reach / sum(x * x for x in v) ** 0.5
        return tuple(x * scale for x in v)

    for mark in ("", "_f32"):
        for reach in (1, 100, 1e3, 1e4, 1e5, 1e6):
            for _ in range(8):
                yield (rng.uniform(-90, 90), lon(), height()), vector(reach * float(earth)), f"within_{reach:g}_m{mark}"
        for _ in range(8):
            near = (sign() * (90 - 10 ** rng.uniform(-6, 0)), lon(), height())
            yield near, vector(10 ** rng.uniform(0, 5)), "polar" + mark
            yield (sign() * 90, lon(), height()), vector(10 ** rng.uniform(0, 6)), "pole" + mark
            line = (rng.uniform(-80, 80), sign() * (180 - rng.uniform(0, 0.01)), height())
            yield line, vector(10 ** rng.uniform(2, 5)), "dateline" + mark
            # Through the Earth to the other side, and out to the Moon.
            far = vector(10 ** rng.uniform(-1, 4))
            yield (rng.uniform(-90, 90), lon(), height()), far[:2] + (-2 * float(a) + far[2],), "antipode" + mark
            yield (rng.uniform(-90, 90), lon(), height()), vector(float(a) * 10 ** rng.uniform(1, 2)), "space" + mark


with open("enu_reverse.tsv", "w") as out:
    out.write("# Vectors in the frame east, north, up of a geodetic position: where they lead, and how far that is from the origin. Degrees, metres.\n")
    out.write("# Made by make_offset.py (mpmath, 60 working digits); inputs are binary64 or binary32, 25 digits of truth.\n")
    out.write("ellipsoid\tlat1\tlon1\th1\teast\tnorth\tup\tlat\tlon\th\tdlat\tdlon\tdh\tclass\n")
    for name, (a, f) in ELLIPSOIDS.items():
        for origin, enu, mark in rows(a):
            keep = single if mark.endswith("_f32") else float
            origin, enu = tuple(map(keep, origin)), tuple(map(keep, enu))
            truth = row(a, f * (2 - f), origin, enu)
            text = [name] + [repr(x) for x in origin + enu] + [nstr(x, 25) for x in truth]
            out.write("\t".join(text + [mark]) + "\n")
