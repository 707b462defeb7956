#!/usr/bin/env python3
"""Writes enu_wgs84.tsv: one geodetic position seen from another. Needs mpmath; see README.md."""

import random
import struct

from mpmath import mp, mpf, cos, sin, sqrt, atan2, degrees, radians, nstr

mp.dps = 60
A, F = mpf(6378137), 1 / mpf("298.257223563")
E2 = F * (2 - F)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def ecef(lat, lon, h):
    phi, lam = radians(mpf(lat)), radians(mpf(lon))
    n = A / sqrt(1 - E2 * sin(phi) ** 2)
    return ((n + h) * cos(phi) * cos(lam), (n + h) * cos(phi) * sin(lam), (n * (1 - E2) + h) * sin(phi))


def enu(origin, target):
    d = [mpf(t) - mpf(o) for t, o in zip(ecef(*target), ecef(*origin))]
    phi, lam = radians(mpf(origin[0])), radians(mpf(origin[1]))
    rows = (
        (-sin(lam), cos(lam), 0),
        (-sin(phi) * cos(lam), -sin(phi) * sin(lam), cos(phi)),
        (cos(phi) * cos(lam), cos(phi) * sin(lam), sin(phi)),
    )
    # 60 digits of working precision leave rounding dust of the sines of 180 degrees.
    e, n, u = (sum(r * x for r, x in zip(row, d)) for row in rows)
    e, n, u = (mpf(0) if abs(x) < mpf(10) ** -45 else x for x in (e, n, u))
    assert abs(e * e + n * n + u * u - sum(x * x for x in d)) < mpf(10) ** -40
    return e, n, u


def rows():
    rng = random.Random(5203)
    wrap = lambda lon: lon - 360 if lon > 180 else lon + 360 if lon < -180 else lon
    place = lambda: (rng.uniform(-89, 89), rng.uniform(-180, 180), rng.uniform(-100, 9000))
    for name, keep in (("", float), ("_f32", single)):
        for reach in (1e-4, 1e-2, 1):
            for _ in range(60):
                o = tuple(keep(x) for x in place())
                t = (o[0] + rng.gauss(0, reach), wrap(o[1] + rng.gauss(0, reach)), o[2] + rng.gauss(0, 1e5 * reach))
                yield o, tuple(keep(x) for x in t), f"within_{reach:g}_deg{name}"
        for _ in range(60):
            o, t = place(), place()
            yield tuple(map(keep, o)), tuple(map(keep, t[:2] + (10 ** rng.uniform(0, 7.6),))), "global" + name
        for _ in range(30):
            o = tuple(keep(x) for x in (rng.uniform(-80, 80), 180 - rng.uniform(0, 0.01), 0))
            t = (o[0] + rng.gauss(0, 0.01), -180 + rng.uniform(0, 0.01), rng.uniform(0, 500))
            yield o, tuple(keep(x) for x in t), "dateline" + name
        for _ in range(30):
            sign = rng.choice((-1, 1))
            o = tuple(keep(x) for x in (sign * (90 - 10 ** rng.uniform(-4, 0)), rng.uniform(-180, 180), 0))
            t = (sign * (90 - 10 ** rng.uniform(-4, 0)), rng.uniform(-180, 180), rng.uniform(0, 500))
            yield o, tuple(keep(x) for x in t), "polar" + name
    for o in ((90.0, 0.0, 0.0), (-90.0, 30.0, 10.0), (0.0, 0.0, 0.0), (45.0, -180.0, 100.0)):
        for t in ((0.0, 0.0, 0.0), (90.0, 90.0, 0.0), (-45.0, 180.0, 1000.0), (45.0, 180.0, 110.0)):
            yield o, t, "special"


with open("enu_wgs84.tsv", "w") as out:
    out.write("# Geodetic positions in the frame east, north, up of another; WGS84, f = 1/298.257223563 exactly. Degrees, metres.\n")
    out.write("# Made by make_enu.py (mpmath, 60 working digits); inputs are binary64, 25 digits of truth.\n")
    out.write("lat1\tlon1\th1\tlat2\tlon2\th2\teast\tnorth\tup\tazimuth\televation\trange\tclass\n")
    for o, t, name in rows():
        e, n, u = enu(o, t)
        r = sqrt(e * e + n * n + u * u)
        aer = (degrees(atan2(e, n)), degrees(atan2(u, sqrt(e * e + n * n))), r) if r else (0, 0, 0)
        text = [repr(x) for x in o + t] + [nstr(mpf(x), 25) for x in (e, n, u) + aer]
        out.write("\t".join(text + [name]) + "\n")
