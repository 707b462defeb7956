#!/usr/bin/env python3
"""Writes healpix_pixels_wgs84.tsv, healpix_places_wgs84.tsv: HEALPix on the ellipsoid, by the authalic latitude. Needs mpmath; see README.md."""

import random
import struct

from mpmath import asin, atanh, degrees, mp, mpf, nstr, radians, sin, sqrt

from healpix import pixel, place, plane

F = 1 / mpf("298.257223563")
E2 = F * (2 - F)
E = sqrt(E2)


def zone(sine):
    """The area from the equator to the latitude of this sine, but for a factor (Snyder 1987, equation 3-12)."""
    return (1 - E2) * (sine / (1 - E2 * sine * sine) + atanh(E * sine) / E)


def authalic(lat):
    return degrees(asin(zone(sin(radians(mpf(lat)))) / zone(mpf(1))))


def geodetic(lat):
    if abs(lat) == 90 or lat == 0:
        return lat
    # The derivative is of the size of the distance from the pole: a step of half the digits, then the rest.
    target, sine = sin(radians(lat)) * zone(mpf(1)), sin(radians(lat))
    with mp.workdps(140):
        for _ in range(9):
            slope = 2 * (1 - E2) / (1 - E2 * sine * sine) ** 2
            sine -= (zone(sine) - target) / slope
    return degrees(asin(sine))


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def latitudes(rng):
    sign = rng.choice((-1, 1))
    yield float(degrees(asin(mpf(rng.uniform(-1, 1))))), "anywhere"
    yield sign * (90 - 10 ** rng.uniform(-12, 0)), "pole"
    yield sign * (41.937857 + rng.gauss(0, 1e-3)), "zones"
    yield sign * 10 ** rng.uniform(-12, 0), "equator"


with open("healpix_pixels_wgs84.tsv", "w") as out:
    out.write("# Pixels of HEALPix on WGS 84, nested, of depth 29, and its plane in units of pi/4, by the authalic latitude. Inputs are binary64, degrees, latitudes geodetic; 25 digits of truth.\n")
    out.write("# margin: from the pixel's edges, in pixels of depth 29. Made by make_healpix_ellipsoid.py (mpmath, 60 working digits).\n")
    out.write("lat\tlon\tpixel\tmargin\tx\ty\tclass\n")
    rng = random.Random(1919)
    for keep, mark in ((float, ""), (single, "_f32")):
        for _ in range(100):
            for lat, name in latitudes(rng):
                lat, lon = keep(lat), keep(rng.uniform(-180, 180))
                if abs(lat) < 90:
                    shifted = authalic(lat)
                    number, margin = pixel(shifted, lon)
                    x, y = plane(shifted, lon)
                    text = [repr(lat), repr(lon), str(number), nstr(margin, 5), nstr(x, 25), nstr(y, 25), name + mark]
                    out.write("\t".join(text) + "\n")

with open("healpix_places_wgs84.tsv", "w") as out:
    out.write("# Places in pixels of HEALPix on WGS 84, nested: dx toward the eastern corner, dy toward the western one. 25 digits of truth, degrees, latitudes geodetic.\n")
    out.write("# Made by make_healpix_ellipsoid.py (mpmath, 60 working digits).\n")
    out.write("depth\tpixel\tdx\tdy\tlat\tlon\tclass\n")
    rng = random.Random(1920)
    for _ in range(600):
        depth = rng.randrange(30)
        last = 4**depth - 1
        rest = rng.choice((0, last, rng.randint(0, last), rng.randint(0, last), max(0, last - rng.randint(0, 5))))
        number = rng.randrange(12) * 4**depth + rest
        dx, dy = (rng.choice((0.0, 0.5, 1.0, rng.randrange(2**20) / 2**20)) for _ in range(2))
        lat, lon = place(number, depth, dx, dy)
        back = geodetic(lat)
        assert abs(authalic(back) - lat) < mpf(10) ** -35, (lat, back)
        name = "pole" if abs(lat) > 89.9 else "anywhere"
        out.write("\t".join([str(depth), str(number), repr(dx), repr(dy), nstr(back, 25), nstr(lon, 25), name]) + "\n")
