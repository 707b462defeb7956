"""Makes intersect.tsv and passages.tsv: where geodesics intersect, and what a geodesic passes.

Independent of the crate: the geodesic is integrated on the auxiliary sphere (Karney 2013, equations 7 and 8, by
mpmath's elliptic integral and Gauss-Legendre quadrature); an intersection is where the two points of space
agree, found by Gauss and Newton's method from candidates on the sphere of mean radius. Candidates are
continued from the sphere to the ellipsoid by raising the flattening in steps, all within 23 000 km (WGS84: 21 000 km), and the one
with the smallest sum of displacements is kept. Rows in which another sum is within 1 km of it are left out.
"""

import random
import sys

from mpmath import mp, mpf

mp.dps = 45
A = mpf(6378137)
WGS84 = 1 / mpf("298.257223563")
ELLIPSOIDS = {"wgs84": WGS84, "oblate": mpf(0.1), "prolate": mpf(-0.1)}


class Line:
    def __init__(self, f, lat, lon, azimuth):
        self.f, self.b = f, A * (1 - f)
        pole = abs(lat) == 90
        if pole:
            # A meridian, whose longitude tells the direction.
            lon, azimuth = (lon + 180 - azimuth, mpf(180)) if lat > 0 else (lon + azimuth, mpf(0))
        self.lon = mp.radians(lon)
        alpha = mp.radians(azimuth)
        sin, cos = (1 - f) * mp.sin(mp.radians(lat)), mpf(0) if pole else mp.cos(mp.radians(lat))
        size = mp.sqrt(sin * sin + cos * cos)
        sin, cos = sin / size, cos / size
        cos_azimuth, sin_azimuth = mp.cos(alpha), mp.sin(alpha)
        if azimuth % 90 == 0:
            sin_azimuth, cos_azimuth = {0: (0, 1), 90: (1, 0), 180: (0, -1), 270: (-1, 0)}[azimuth % 360]
        self.sin0 = sin_azimuth * cos
        self.cos0 = mp.sqrt(mpf(cos_azimuth) ** 2 + (sin_azimuth * sin) ** 2)
        self.sigma1 = mp.atan2(sin, cos_azimuth * cos) if (sin, cos_azimuth) != (0, 0) else mpf(0)
        self.k2 = f * (2 - f) / (1 - f) ** 2 * self.cos0**2
        self.start = self.integral(self.sigma1)
        self.turned1 = self.omega(self.sigma1)
        if pole:
            # South of the north pole the meridian is the half circle beyond it.
            self.turned1 = mp.pi if lat > 0 else mpf(0)

    def integral(self, sigma):
        return mp.ellipe(sigma, -self.k2)

    def omega(self, sigma):
        """The longitude on the sphere, through all turns."""
        turns = mp.floor(sigma / (2 * mp.pi) + mpf(1) / 2)
        within = sigma - 2 * mp.pi * turns
        omega = mp.atan2(abs(self.sin0) * mp.sin(within), mp.cos(within))
        return (omega + 2 * mp.pi * turns) * (-1 if self.sin0 < 0 else 1)

    def distance(self, sigma):
        return self.b * (self.integral(sigma) - self.start)

    def sigma(self, distance):
        wanted = self.start + distance / self.b
        sigma = self.sigma1 + distance / A
        for _ in range(100):
            step = (wanted - self.integral(sigma)) / mp.sqrt(1 + self.k2 * mp.sin(sigma) ** 2)
            sigma += step
            if abs(step) < mpf(10) ** -(mp.dps - 6):
                return sigma
        raise ArithmeticError("no sigma")

    def longitude(self, sigma):
        """In radians from the start, through all turns."""
        f = self.f

        def slope(s):
            return (2 - f) / (1 + (1 - f) * mp.sqrt(1 + self.k2 * mp.sin(s) ** 2))

        length = sigma - self.sigma1
        pieces = max(1, int(mp.ceil(abs(length) / (mp.pi / 4))))
        nodes = [self.sigma1 + length * i / pieces for i in range(pieces + 1)]
        integral = mp.quad(slope, nodes, method="gauss-legendre", maxdegree=5 if mp.dps > 20 else 3)
        return self.omega(sigma) - self.turned1 - f * self.sin0 * integral

    def beta(self, sigma):
        sin = self.cos0 * mp.sin(sigma)
        cos = mp.sqrt(self.sin0**2 + (self.cos0 * mp.cos(sigma)) ** 2)
        return sin, cos

    def latitude(self, sigma):
        sin, cos = self.beta(sigma)
        return mp.degrees(mp.atan2(sin, (1 - self.f) * cos))

    def point(self, distance):
        """Point, direction, latitude, longitude in degrees."""
        sigma = self.sigma(distance)
        lon = self.lon + self.longitude(sigma)
        sin, cos = self.beta(sigma)
        place = mp.matrix([A * cos * mp.cos(lon), A * cos * mp.sin(lon), self.b * sin])
        # d/dσ of the longitude is sin α / cos β times the rest; the direction by its azimuth is simpler.
        alpha = mp.atan2(self.sin0, self.cos0 * mp.cos(sigma))
        lat = mp.radians(self.latitude(sigma))
        north = mp.matrix([-mp.sin(lat) * mp.cos(lon), -mp.sin(lat) * mp.sin(lon), mp.cos(lat)])
        east = mp.matrix([-mp.sin(lon), mp.cos(lon), 0])
        return place, mp.cos(alpha) * north + mp.sin(alpha) * east, mp.degrees(lat), mp.degrees(lon)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def meet(lines, at, steps, enough):
    """Newton's method in space; None if it runs away."""
    x, y = at
    for _ in range(steps):
        p, u, lat, lon = lines[0].point(x)
        q, v, _, _ = lines[1].point(y)
        gap = q - p
        cosine = dot(u, v)
        sine2 = 1 - cosine * cosine
        if sine2 == 0:
            return None
        gu, gv = dot(gap, u), dot(gap, v)
        dx = (gu - cosine * gv) / sine2
        dy = (cosine * gu - gv) / sine2
        limit = A / 2
        dx, dy = (max(-limit, min(limit, d)) for d in (dx, dy))
        x, y = x + dx, y + dy
        if abs(dx) + abs(dy) < enough:
            p, u, lat, lon = lines[0].point(x)
            q, v, _, _ = lines[1].point(y)
            if mp.norm(q - p) > enough * 1000:
                return None
            return x, y, lat, lon, mp.sqrt(1 - dot(u, v) ** 2)
    return None


def sphere(case):
    """All intersections on the sphere within a circuit: distances in radians."""
    directions = []
    for lat, lon, azimuth in (case[:3], case[3:]):
        lat, lon, azimuth = map(mp.radians, (lat, lon, azimuth))
        place = mp.matrix([mp.cos(lat) * mp.cos(lon), mp.cos(lat) * mp.sin(lon), mp.sin(lat)])
        north = mp.matrix([-mp.sin(lat) * mp.cos(lon), -mp.sin(lat) * mp.sin(lon), mp.cos(lat)])
        east = mp.matrix([-mp.sin(lon), mp.cos(lon), 0])
        directions.append((place, mp.cos(azimuth) * north + mp.sin(azimuth) * east))
    (p, u), (q, v) = directions

    def cross(a, b):
        return mp.matrix([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])

    axis = cross(cross(p, u), cross(q, v))
    for side in (1, -1):
        x = mp.atan2(side * dot(axis, u), side * dot(axis, p))
        y = mp.atan2(side * dot(axis, v), side * dot(axis, q))
        for i in (-1, 0, 1):
            for j in (-1, 0, 1):
                yield x + 2 * mp.pi * i, y + 2 * mp.pi * j


def closest(f, case):
    radius = A * (1 - f / 3)
    found = []
    mp.dps = 20
    for x, y in sphere(case):
        at = (x * radius, y * radius)
        if abs(at[0]) + abs(at[1]) > (21_000_000 if abs(f) < 0.01 else 23_000_000):
            continue
        stages = 1 if abs(f) < 0.01 else 2
        for stage in range(1, stages + 1):
            part = f * stage / stages
            lines = [Line(part, *case[:3]), Line(part, *case[3:])]
            met = meet(lines, at, 40, mpf("1e-3"))
            if met is None:
                break
            at = met[:2]
        else:
            if all(abs(at[0] - o[0]) + abs(at[1] - o[1]) > 1 for o in found):
                found.append(at)
    mp.dps = 45
    found.sort(key=lambda at: abs(at[0]) + abs(at[1]))
    sums = [abs(at[0]) + abs(at[1]) for at in found]
    if not found or sums[0] > 21_000_000 or len(sums) > 1 and sums[1] - sums[0] < 1000:
        return None
    lines = [Line(f, *case[:3]), Line(f, *case[3:])]
    return meet(lines, found[0], 20, mpf("1e-30"))


def wrapped(lon):
    return lon - 360 * mp.floor(lon / 360 + mpf(1) / 2)


def text(value):
    return mp.nstr(value, 25, strip_zeros=True) if value else "0"


def cases():
    rng = random.Random(20264)

    def eighth(limit):
        return rng.randrange(-8 * limit, 8 * limit + 1) / 8

    for name in ELLIPSOIDS:
        for _ in range(40 if name == "wgs84" else 12):
            yield name, "f32", [eighth(90), eighth(180), eighth(180), eighth(90), eighth(180), eighth(180)]
        for _ in range(20 if name == "wgs84" else 5):
            yield name, "uniform", [g(r) for r in (90, 180, 180) * 2 for g in (lambda r: rng.uniform(-r, r),)]
        for k in range(12 if name == "wgs84" else 4):
            lat, lon, d = eighth(80), eighth(170), 2.0 ** -rng.randrange(0, 15)
            azimuth = eighth(180)
            yield name, "near", [lat, lon, azimuth, lat + d * eighth(1), lon + d * eighth(1), azimuth + 90 + eighth(45)]
        for k in range(12 if name == "wgs84" else 4):
            lat, lon, azimuth = eighth(80), eighth(170), eighth(180)
            d = 2.0 ** -rng.randrange(1, 14)
            yield name, "parallel", [lat, lon, azimuth, lat + d / 4, lon - d, azimuth + d / 2 + 180 * (k % 2)]
        for _ in range(10 if name == "wgs84" else 3):
            lat, lon, d = eighth(80), eighth(90), 2.0 ** -rng.randrange(0, 20)
            yield name, "antipodal", [lat, lon, eighth(180), -lat + d, lon + 180, eighth(180)]
        for pole in (90, -90):
            yield name, "pole", [pole, eighth(180), eighth(180), eighth(80), eighth(180), eighth(180)]
        for azimuth in (0, 180, 90, -90):
            yield name, "axis", [0, eighth(180), azimuth, eighth(60), eighth(180), eighth(170)]
        yield name, "equator", [0, 0, 90, 0.125, 20, 100]
        yield name, "meridians", [20, 10, 0, -30, 90, 0]


def intersections():
    head = (
        "# Intersections of two geodesics, a = 6378137 m, f by name: 1/298.257223563, 0.1 and -0.1 (as binary64).\n"
        "# Inputs: lat1 lon1 azi1 lat2 lon2 azi2, exact binary64. Truth: displacements in metres, the place in degrees, the sine\n"
        "# of the angle between the lines; 25 digits. Made by make_intersect.py with mpmath, 45 working digits.\n"
        "ellipsoid\tlat1\tlon1\tazi1\tlat2\tlon2\tazi2\tx\ty\tlat\tlon\tsine\tclass\n"
    )
    rows = []
    for name, kind, case in cases():
        met = closest(ELLIPSOIDS[name], [mpf(c) for c in case])
        if met is None:
            continue
        x, y, lat, lon, sine = met
        outputs = [text(v) for v in (x, y, lat, wrapped(lon))] + [mp.nstr(sine, 6)]
        rows.append("\t".join([name, *map(repr, map(float, case)), *outputs, kind]))
    with open("intersect.tsv", "w") as file:
        file.write(head + "\n".join(rows) + "\n")


def passages():
    head = (
        "# What geodesics pass, ellipsoids as in intersect.tsv. Inputs: lat1 lon1 azi1, the parallel lat2, the meridian lon2.\n"
        "# Truth: the first vertex ahead on the northern side (latitude, longitude, distance), where the parallel is first met\n"
        "# (distance, longitude, its azimuth's cosine; nan if never), where the meridian is (distance, latitude, its azimuth's sine),\n"
        "# and the longitude after 100 000 km, through all turns; 25 digits. Made by make_intersect.py.\n"
        "ellipsoid\tlat1\tlon1\tazi1\tlat2\tlon2\ttop_lat\ttop_lon\ttop_s\tsin0\tparallel_s\tparallel_lon\tparallel_cos\t"
        "meridian_s\tmeridian_lat\tmeridian_sin\tunrolled\n"
    )
    rng = random.Random(20265)
    rows = []
    for name, f in ELLIPSOIDS.items():
        for k in range(76 if name == "wgs84" else 18):
            case = [rng.randrange(-8 * r, 8 * r + 1) / 8 for r in (89, 180, 179, 60, 180)]
            if k % 8 == 1:
                case[2] = 2.0 ** -rng.randrange(3, 16)
            if k % 8 == 2:
                case[2] = 90 + 2.0 ** -rng.randrange(3, 16)
            if k % 8 == 3:
                case[0] = 0.0
            if case[2] % 180 == 0:
                continue
            line = Line(f, *map(mpf, case[:3]))
            circle = 2 * mp.pi
            ahead = lambda sigma: line.sigma1 + ((sigma - line.sigma1) % circle)
            lon_at = lambda sigma: wrapped(mp.degrees(line.lon + line.longitude(sigma)))
            top = ahead(mp.pi / 2)
            out = [line.latitude(top), lon_at(top), line.distance(top), abs(line.sin0)]
            beta = mp.atan((1 - f) * mp.tan(mp.radians(mpf(case[3]))))
            ratio = mp.sin(beta) / line.cos0
            if abs(ratio) < 1:
                met = min(ahead(mp.asin(ratio)), ahead(mp.pi - mp.asin(ratio)))
                cosine = line.cos0 * mp.cos(met) / line.beta(met)[1]
                out += [line.distance(met), lon_at(met), cosine]
            else:
                out += [None] * 3
            east = -1 if line.sin0 < 0 else 1
            wanted = mp.radians((east * (mpf(case[4]) - mpf(case[1]))) % 360)
            low, high = line.sigma1, line.sigma1 + mp.mpf(16) / 2
            # Bisection, then Illinois's method.
            miss = lambda sigma: east * line.longitude(sigma) - wanted
            mp.dps = 15
            for _ in range(30):
                middle = (low + high) / 2
                low, high = (low, middle) if miss(middle) > 0 else (middle, high)
            mp.dps = 45
            low, high = low - mpf("1e-12"), high + mpf("1e-12")
            b = mp.findroot(miss, (low, high), solver="illinois", tol=mpf(10) ** -76, maxsteps=200)
            assert abs(miss(b)) < mpf(10) ** -36, case
            out += [line.distance(b), line.latitude(b), line.sin0 / line.beta(b)[1]]
            out.append(mp.degrees(line.lon + line.longitude(line.sigma(mpf(100_000_000)))))
            fields = ["nan" if v is None else text(v) for v in out]
            rows.append("\t".join([name, *map(repr, case), *fields]))
    with open("passages.tsv", "w") as file:
        file.write(head + "\n".join(rows) + "\n")



for name, make in (("intersect", intersections), ("passages", passages)):
    if len(sys.argv) == 1 or name in sys.argv:
        make()
