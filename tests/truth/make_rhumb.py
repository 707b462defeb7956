#!/usr/bin/env python3
"""Makes `rhumb_inverse.tsv` and `rhumb_direct.tsv`: rhumb lines with 40 digits, by the integrals that define them.

Meridians by elliptic integrals, the isometric latitude in closed form, the area by quadrature of the authalic latitude's
sine over the isometric latitude. No series, and differences of 80 digits. Most places and distances are numbers that `f32`
has too. Needs mpmath only.
"""

import random
import struct

from mpmath import asinh, atan, atan2, atanh, cos, degrees, ellipe, hypot, log, mp, mpc, mpf, nstr, pi, quad, radians, sin, sinh, sqrt, tan

mp.dps = 80

ELLIPSOIDS = {"wgs84": (6378137.0, 1 / 298.257223563), "oblate10": (6.4e6, 0.1), "prolate150": (6.4e6, -1 / 150)}


class Surface:
    def __init__(self, a, f):
        self.a, f = mpf(a), mpf(f)
        self.b = self.a * (1 - f)
        self.e2 = f * (2 - f)
        self.e = sqrt(mpc(self.e2))

    def atanh_term(self, s):
        return (self.e * atanh(self.e * s)).real

    def isometric(self, p):
        return asinh(tan(p)) - self.atanh_term(sin(p))

    def meridian(self, p):
        return self.a * (ellipe(p, self.e2) - self.e2 * sin(p) * cos(p) / sqrt(1 - self.e2 * sin(p) ** 2))

    def slope(self, p):
        return self.a * (1 - self.e2) / sqrt(1 - self.e2 * sin(p) ** 2) ** 3

    def parallel(self, p):
        return self.a * cos(p) / sqrt(1 - self.e2 * sin(p) ** 2)

    def zone(self, s):
        """The area between the equator and a parallel, for a radian of longitude."""
        w = 1 - self.e2 * s * s
        return self.b**2 / 2 * (s / w + self.atanh_term(s) / self.e2)

    def mean_zone(self, p1, p2):
        """The mean of that over the isometric latitude."""
        if p1 == p2:
            return self.zone(sin(p1))
        # In u = asinh tan φ it is smooth.
        u1, u2 = asinh(tan(p1)), asinh(tan(p2))

        def integrand(u):
            s = sinh(u) / sqrt(1 + sinh(u) ** 2)
            return self.zone(s) * (1 - self.e2) / (1 - self.e2 * s * s)

        steps = int(abs(u2 - u1)) + 1
        mp.dps = 45
        total = quad(integrand, [u1 + (u2 - u1) * k / steps for k in range(steps + 1)])
        mp.dps = 80
        return total / (self.isometric(p2) - self.isometric(p1))

    def inverse(self, lat1, lat2, dlon):
        p1, p2, lon = radians(lat1), radians(lat2), radians(dlon)
        area = lon * self.mean_zone(p1, p2)
        if p1 == p2:
            east, north = lon * self.parallel(p1), mpf(0)
        else:
            north = self.meridian(p2) - self.meridian(p1)
            east = lon * north / (self.isometric(p2) - self.isometric(p1))
        return hypot(east, north), degrees(atan2(east, north)), area

    def direct(self, lat, azimuth, s):
        p1, azi = radians(lat), radians(azimuth)
        if abs(azimuth) == 90:
            lon = s * sin(azi) / self.parallel(p1)
            return lat, degrees(lon), lon * self.zone(sin(p1))
        goal = self.meridian(p1) + s * cos(azi)
        if abs(goal) >= self.meridian(pi / 2):
            return None
        p2 = p1
        for _ in range(60):
            step = (goal - self.meridian(p2)) / self.slope(p2)
            p2 += step
            # Not beyond the pole on the way.
            p2 = max(-pi / 2 + mpf(10) ** -30, min(pi / 2 - mpf(10) ** -30, p2))
            if abs(step) < mpf(10) ** -70:
                break
        lon = tan(azi) * (self.isometric(p2) - self.isometric(p1))
        return degrees(p2), degrees(lon), lon * self.mean_zone(p1, p2)


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def shown(x):
    """All digits of a double, without an exponent."""
    text = nstr(mpf(x), 60, min_fixed=-1000, max_fixed=1000)
    return text[:-2] if text.endswith(".0") else text


def number(x):
    return nstr(x, 25, strip_zeros=False) if x else "0.0"


def latitude(r):
    return r.choice(
        [
            r.uniform(-90, 90),
            r.uniform(-90, 90),
            r.uniform(-1e-3, 1e-3),
            (90 - 10 ** r.uniform(-4, 1)) * r.choice([-1, 1]),
            float(r.choice([0, 0, 30, -45, 60, 89])),
        ]
    )


def pairs(r):
    """Rows of two places."""
    for _ in range(60):
        yield latitude(r), r.uniform(-180, 180), latitude(r), r.uniform(-180, 180)
    for _ in range(30):
        lat, lon = latitude(r), r.uniform(-180, 180)
        step = 10 ** r.uniform(-6, 0)
        north, east = r.choice([(0, 1), (1, 0), (1, 1), (-1, 2), (1e-3, -1), (-1e-3, 1)])
        yield max(-89.99, min(89.99, lat + north * step)), lon + east * step, lat, lon
    for _ in range(15):
        lat = latitude(r)
        yield lat, r.uniform(-180, 180), lat, r.uniform(-180, 180)


# A pole's neighbourhood, and steps far below a rounding of f32.
FINE = [
    (89.999999999, 0, 0, 170),
    (-1e-10, 10, -89.999999998, -140),
    (89.9999999999, 0, 89.9999999998, 120),
    (-89.999999999, 3, 89.999999999, -3),
    (45, 20, 45.00000000000001, 20),
    (45, 20, 45.00000000001, 20.00000000001),
    (1e-14, 0, -1e-14, 150),
    (89.99999, 10, 89.99999000001, -170),
]


def ways(r):
    """Rows of a place, an azimuth and a distance."""
    for _ in range(50):
        yield latitude(r), r.uniform(-180, 180), r.uniform(-180, 180), 10 ** r.uniform(0, 7)
    for _ in range(20):
        yield latitude(r), r.uniform(-180, 180), r.choice([0, 90, -90, 180, 90 + 2**-10, -90 - 2**-7]), 10 ** r.uniform(2, 7.3)


def main():
    r = random.Random(2303)
    with open("rhumb_inverse.tsv", "w") as table:
        table.write("# Rhumb lines in degrees, metres and square metres: the first four columns are inputs.\n")
        table.write("ellipsoid lat1 lon1 lat2 lon2 distance azimuth area\n".replace(" ", "\t"))
        for name, (a, f) in ELLIPSOIDS.items():
            surface = Surface(a, f)
            rows = [tuple(single(x) for x in row) for row in pairs(r)] + FINE
            for lat1, lon1, lat2, lon2 in rows:
                lon = mpf(lon2) - mpf(lon1)
                lon -= 360 * (lon > 180)
                lon += 360 * (lon < -180)
                found = surface.inverse(mpf(lat1), mpf(lat2), lon)
                cells = [shown(x) for x in (lat1, lon1, lat2, lon2)] + [number(x) for x in found]
                table.write(name + "\t" + "\t".join(cells) + "\n")
    with open("rhumb_direct.tsv", "w") as table:
        table.write("# Rhumb lines: lat1 lon1 azimuth distance are inputs, the longitude runs on by what is turned.\n")
        table.write("ellipsoid lat1 lon1 azimuth distance lat2 turned area\n".replace(" ", "\t"))
        for name, (a, f) in ELLIPSOIDS.items():
            surface = Surface(a, f)
            for way in ways(r):
                lat, lon, azimuth, s = (single(x) for x in way)
                found = surface.direct(mpf(lat), mpf(azimuth), mpf(s))
                if found is not None:
                    cells = [shown(x) for x in (lat, lon, azimuth, s)] + [number(x) for x in found]
                    table.write(name + "\t" + "\t".join(cells) + "\n")


main()
