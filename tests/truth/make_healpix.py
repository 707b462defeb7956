#!/usr/bin/env python3
"""Writes healpix_pixels.tsv, healpix_places.tsv: pixels of standard HEALPix and its plane. Needs mpmath, healpy and cdshealpix; see README.md."""

import random
import struct

import healpy
import numpy
from cdshealpix.nested import healpix_to_lonlat, lonlat_to_healpix
from astropy.coordinates import Latitude, Longitude
from mpmath import asin, degrees, mp, mpf, nstr, radians

from healpix import pixel, place, plane


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
