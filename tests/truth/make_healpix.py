#!/usr/bin/env python3
"""Writes healpix_pixels.tsv, healpix_places.tsv: pixels of standard HEALPix and its plane. Needs mpmath, healpy and cdshealpix; see README.md."""

import random
import struct

import healpy
import numpy
from cdshealpix.nested import healpix_to_lonlat, lonlat_to_healpix
from astropy.coordinates import Latitude, Longitude
from mpmath import asin, degrees, floor, mp, mpf, nstr, radians, sin, sqrt

mp.dps = 60
DEPTH = 29


def plane(lat, lon):
    """Calabretta & Roukema 2007, in units of pi/4; x in [0, 8)."""
    z, x = sin(radians(mpf(lat))), (mpf(lon) % 360) / 45
    if abs(lat) == 90:
        z = mpf(lat) / 90
    if abs(z) <= mpf(2) / 3:
        return x, 3 * z / 2
    sigma = sqrt(3 * (1 - abs(z)))
    tip = 2 * floor(x / 2) + 1  # on a meridian between two quarters, the eastern one
    return tip + (x - tip) * sigma, (2 - sigma) * (1 if z > 0 else -1)


def interleaved(x, y):
    return sum((x >> k & 1) << 2 * k | (y >> k & 1) << 2 * k + 1 for k in range(DEPTH))


def pixel(lat, lon):
    """The pixel, and how far the place is from its edges, in pixels."""
    x, y = plane(lat, lon)
    for base in range(12):
        row, column = divmod(base, 4)
        cx, cy = (2 * column + (row != 1), 1 - row)
        dx = (x - cx + 4) % 8 - 4
        a, b = (dx + (y - cy) + 1) / 2, (-dx + (y - cy) + 1) / 2
        # A cap's quarter is its base pixel's, edges included; elsewhere western and southern edges are.
        cap = abs(y) > 1
        if 0 <= a < 1 and 0 <= b < 1 if not cap else (row, column) == (0 if y > 0 else 2, int(x // 2)):
            a, b = a * 2**DEPTH, b * 2**DEPTH
            margin = min(abs(v - mp.nint(v)) for v in (a, b))
            a, b = (max(0, min(2**DEPTH - 1, int(floor(v)))) for v in (a, b))
            return base << 2 * DEPTH | interleaved(a, b), margin
    raise ValueError((lat, lon))


def place(number, depth, dx, dy):
    base, rest = divmod(number, 4**depth)
    a, b = (sum((rest >> 2 * k + s & 1) << k for k in range(depth)) for s in (0, 1))
    a, b = ((i + mpf(d)) / 2**depth for i, d in ((a, dx), (b, dy)))
    row, column = divmod(base, 4)
    x, y = 2 * column + (row != 1) + a - b, 1 - row + a + b - 1
    if abs(y) <= 1:
        lat, lon = asin(2 * y / 3), x * 45
    else:
        sigma = 2 - abs(y)
        # 1 - sigma^2 / 3 by its complement: asin has not the digits near 1.
        lat = (mp.pi / 2 - 2 * asin(sigma / sqrt(mpf(6)))) * (1 if y > 0 else -1)
        tip = 2 * column + 1
        lon = 45 * (tip + ((x - tip) / sigma if sigma else 0))
    lon = lon % 360
    return degrees(lat), lon if lon <= 180 else lon - 360


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def rows():
    rng = random.Random(1616)
    anywhere = lambda: float(degrees(asin(mpf(rng.uniform(-1, 1)))))
    lon = lambda: rng.uniform(-180, 180)
    sign = lambda: rng.choice((-1, 1))
    for keep, mark in ((float, ""), (single, "_f32")):
        for _ in range(400):
            yield keep(anywhere()), keep(lon()), "anywhere" + mark
        for _ in range(200):
            yield keep(sign() * (90 - 10 ** rng.uniform(-12, 0))), keep(lon()), "pole" + mark
        for _ in range(100):
            yield keep(anywhere()), keep(rng.choice((-180, -90, 0, 90, 180)) + sign() * 10 ** rng.uniform(-12, 0)), "meridian" + mark
        for _ in range(100):
            yield keep(sign() * (41.8103148957786 + rng.gauss(0, 1e-3))), keep(lon()), "zones" + mark
        for _ in range(100):
            yield keep(sign() * 10 ** rng.uniform(-12, 0)), keep(lon()), "equator" + mark


def wrapped(lat, lon, name):
    return lat, (lon + 180) % 360 - 180 if abs(lon) > 180 else lon, name


with open("healpix_pixels.tsv", "w") as out:
    out.write("# Pixels of standard HEALPix, nested, of depth 29, and its plane in units of pi/4. Inputs are binary64, degrees on the sphere; 25 digits of truth.\n")
    out.write("# margin: from the pixel's edges, in pixels of depth 29. Made by make_healpix.py (mpmath, 60 working digits; healpy and cdshealpix agree).\n")
    out.write("lat\tlon\tpixel\tmargin\tx\ty\tclass\n")
    for lat, lon, name in (wrapped(*row) for row in rows() if abs(row[0]) < 90):
        number, margin = pixel(lat, lon)
        # Others to the depth that their rounding leaves; both take 1 - |z| of a place near the pole with its own rounding.
        if margin > 0.4 and "pole" not in name:
            for depth, up in ((20, 18), (12, 34)):
                theirs = healpy.ang2pix(2**depth, lon, lat, lonlat=True, nest=True)
                cds = lonlat_to_healpix(Longitude(lon, "deg"), Latitude(lat, "deg"), depth)[0]
                if number >> up not in (theirs, cds):
                    print("differ", lat, lon, depth, number >> up, theirs, cds)
        x, y = plane(lat, lon)
        text = [repr(lat), repr(lon), str(number), nstr(margin, 5), nstr(x, 25), nstr(y, 25), name]
        out.write("\t".join(text) + "\n")

with open("healpix_places.tsv", "w") as out:
    out.write("# Places in pixels of standard HEALPix, nested: dx toward the eastern corner, dy toward the western one. 25 digits of truth, degrees on the sphere.\n")
    out.write("# Made by make_healpix.py (mpmath, 60 working digits; cdshealpix agrees).\n")
    out.write("depth\tpixel\tdx\tdy\tlat\tlon\tclass\n")
    rng = random.Random(1617)
    for count in range(1200):
        depth = rng.randrange(30)
        last = 4**depth - 1
        rest = rng.choice((0, last, rng.randint(0, last), rng.randint(0, last), max(0, last - rng.randint(0, 5))))
        number = rng.randrange(12) * 4**depth + rest
        dx, dy = (rng.choice((0.0, 0.5, 1.0, rng.randrange(2**20) / 2**20)) for _ in range(2))
        lat, lon = place(number, depth, dx, dy)
        if dx < 1 and dy < 1:
            clon, clat = healpix_to_lonlat(numpy.array([number], dtype=numpy.uint64), depth, dx, dy)
            clon, clat = clon.deg[0], clat.deg[0]
            turn = abs((clon - float(lon) + 180) % 360 - 180) * float(mp.cos(radians(lat)))
            if abs(clat - lat) > 1e-7 or turn > 1e-7:
                print("differ", depth, number, dx, dy, nstr(lat, 15), nstr(lon, 15), clat, clon)
        name = "pole" if abs(lat) > 89.9 else "anywhere"
        out.write("\t".join([str(depth), str(number), repr(dx), repr(dy), nstr(lat, 25), nstr(lon, 25), name]) + "\n")
