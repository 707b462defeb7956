#!/usr/bin/env python3
"""Writes closest.tsv: the points of geodesic segments that are closest to places, and where places are beside the
whole lines. Needs mpmath, and geographiclib for first values and for the search among several minima; see README.md."""

import random
import struct

from geographiclib.geodesic import Geodesic
from mpmath import mp, mpf, asin, atan2, cos, degrees, hypot, nstr, pi, radians, sin, sqrt

mp.dps = 45
ELLIPSOIDS = {
    "wgs84": (mpf(6378137), 1 / mpf("298.257223563")),
    "oblate10": (mpf(6400000), mpf(1) / 10),
    "prolate150": (mpf(6400000), mpf(-1) / 150),
    "sphere": (mpf(6371000), mpf(0)),
}
NODES = []


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def quarter(angle):
    """Sine and cosine of degrees, exact where they are 0 or 1."""
    s, c = sin(radians(mpf(angle))), cos(radians(mpf(angle)))
    return tuple(mpf(0) if abs(x) < mpf(10) ** -40 else x for x in (s, c))


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def integral(f, low, high):
    """By Gauss and Legendre, whose error here is below 1e-42: the next singularity is at a distance of 1.4 at least."""
    parts = int(abs(high - low)) + 1
    step = (high - low) / parts
    total = mpf(0)
    for part in range(parts):
        middle = low + step * (part + mpf(1) / 2)
        total += sum(w * f(middle + step / 2 * x) for x, w in NODES) * step / 2
    return total


class Place:
    """A place with the local axes; at a pole those of its longitude."""

    def __init__(self, planet, lat, lon):
        (self.s, self.c), (sl, cl) = quarter(lat), quarter(lon)
        a, f = planet.a, planet.f
        n = a / sqrt(1 - f * (2 - f) * self.s**2)
        self.position = (n * self.c * cl, n * self.c * sl, n * (1 - f) ** 2 * self.s)
        self.east, self.north = (-sl, cl, mpf(0)), (-self.s * cl, -self.s * sl, self.c)
        self.lon = radians(mpf(lon))


class Planet:
    def __init__(self, a, f):
        self.a, self.f, self.b = a, f, a * (1 - f)
        self.ep2 = f * (2 - f) / (1 - f) ** 2
        self.double = Geodesic(float(a), float(f))

    def place(self, lat, lon):
        return Place(self, lat, lon)


class Line:
    """The geodesic from a place at an azimuth in radians (Karney 2013, equations 7 and 8)."""

    def __init__(self, planet, start, azimuth):
        self.planet, self.start = planet, start
        f = planet.f
        beta = atan2((1 - f) * start.s, start.c)
        sa, ca = sin(azimuth), cos(azimuth)
        # At a pole the azimuth counts from the meridian of its longitude.
        c, s = (cos(beta), sin(beta)) if start.c else (mpf(10) ** -40, start.s)
        self.sin0 = sa * c
        self.cos0 = hypot(ca, sa * s)
        self.sigma1 = atan2(s, ca * c)
        self.omega1 = atan2(self.sin0 * s, ca * c)
        self.k2 = planet.ep2 * self.cos0**2

    def at(self, s):
        """Position, direction of travel and direction to its right, as vectors."""
        planet, f = self.planet, self.planet.f
        root = lambda sigma: sqrt(1 + self.k2 * sin(sigma) ** 2)
        target, step, sigma = s / planet.b, s / planet.b, self.sigma1
        travelled = mpf(0)
        for _ in range(60):
            new = sigma + step
            travelled += integral(root, sigma, new)
            sigma, step = new, (target - travelled) / root(new)
            if abs(step) < mpf(10) ** -43:
                break
        else:
            raise ArithmeticError("no arc")
        lon = integral(lambda x: (2 - f) / (1 + (1 - f) * root(x)), self.sigma1, sigma)
        omega = atan2(self.sin0 * sin(sigma), cos(sigma)) - self.omega1
        turn = 2 * pi * mp.nint((self_sign(self.sin0) * (sigma - self.sigma1) - omega) / (2 * pi))
        lam = self.start.lon + omega + turn - f * self.sin0 * lon
        sin_beta = self.cos0 * sin(sigma)
        cos_beta = hypot(self.sin0, self.cos0 * cos(sigma))
        ca = self.cos0 * cos(sigma)
        azimuth = atan2(self.sin0, ca)
        # β to φ.
        s_phi, c_phi = sin_beta / hypot(sin_beta, (1 - f) * cos_beta), (1 - f) * cos_beta / hypot(sin_beta, (1 - f) * cos_beta)
        sl, cl = sin(lam), cos(lam)
        position = (planet.a * cos_beta * cl, planet.a * cos_beta * sl, planet.b * sin_beta)
        east, north = (-sl, cl, mpf(0)), (-s_phi * cl, -s_phi * sl, c_phi)
        sz, cz = sin(azimuth), cos(azimuth)
        ahead = tuple(sz * e + cz * n for e, n in zip(east, north))
        right = tuple(cz * e - sz * n for e, n in zip(east, north))
        point = Place.__new__(Place)
        point.s, point.c, point.lon = s_phi, c_phi, lam
        return position, ahead, right, point, azimuth


def self_sign(x):
    return -1 if x < 0 else 1


def off(end, position):
    return tuple(x - y for x, y in zip(end, position))


def inverse(planet, one, two):
    """Azimuth in radians and distance between places given in degrees, by Newton's method from first values in double
    precision; none where the lines from the first place cross again near the second."""
    first = planet.double.Inverse(*map(float, one + two), outmask=Geodesic.ALL)
    start, end = planet.place(*one), planet.place(*two)
    azimuth, s = radians(mpf(first["azi1"])), mpf(first["s12"])
    if s == 0:
        return mpf(0), mpf(0)
    if abs(first["m12"]) < 1e-3 * first["s12"]:
        raise ArithmeticError("conjugate")
    for _ in range(40):
        position, ahead, right, _, _ = Line(planet, start, azimuth).at(s)
        rest = off(end.position, position)
        ds, turn = dot(rest, ahead), dot(rest, right) / mpf(first["m12"])
        azimuth, s = azimuth + turn, s + ds
        if abs(ds) + abs(turn) * planet.a < mpf(10) ** -30:
            assert s > 0
            return azimuth, s
    raise ArithmeticError("no line")


def foot(planet, line, place, along, across):
    """Along and across, from first values: where a line at a right angle meets the place."""
    s, h = mpf(along), mpf(across)
    end = planet.place(*place)
    _, _, _, point, azimuth = line.at(s)
    lat, lon = float(degrees(atan2(point.s, point.c))), float(degrees(point.lon))
    scale = planet.double.Line(lat, lon, float(degrees(azimuth)) + 90, caps=Geodesic.ALL).Position(float(h), Geodesic.ALL)["M12"]
    for _ in range(60):
        _, _, _, point, azimuth = line.at(s)
        position, ahead, right, _, _ = Line(planet, point, azimuth + pi / 2).at(h)
        rest = off(end.position, position)
        # To the right of the way across is backward along the line.
        dh, ds = dot(rest, ahead), -dot(rest, right) / scale
        s, h = s + ds, h + dh
        if abs(dh) + abs(ds) < mpf(10) ** -28:
            return s, h
    raise ArithmeticError("no foot")


def search(planet, place, way, low, high, parts):
    """In double precision: the lowest point of a dense sample of a line, its neighbours brought together."""
    double = planet.double
    line = double.Line(*way, caps=Geodesic.ALL)

    def sight(s):
        point = line.Position(s)
        back = double.Inverse(*place, point["lat2"], point["lon2"])
        return back["s12"], point["azi2"] - back["azi2"]

    steps = [low + (high - low) * k / parts for k in range(parts + 1)]
    heights = [sight(s)[0] for s in steps]
    best = min(range(parts + 1), key=heights.__getitem__)
    low, high = steps[max(best - 1, 0)], steps[min(best + 1, parts)]
    for _ in range(60):
        middle = 0.5 * (low + high)
        if cos(radians(mpf(sight(middle)[1]))) < 0:
            low = middle
        else:
            high = middle
    s = 0.5 * (low + high)
    distance, turn = sight(s)
    return s, distance, float(sin(radians(mpf(turn))))


def text(x, digits=21):
    x = mpf(x)
    return "0" if abs(x) < mpf(10) ** -25 else nstr(x, digits, strip_zeros=False, min_fixed=-40, max_fixed=40)


def row(name, planet, place, start, end, kind):
    double = planet.double
    azimuth, length = inverse(planet, start, end)
    line = Line(planet, planet.place(*start), azimuth)
    way = (*start, float(degrees(azimuth)))
    total = float(length)
    s, distance, side = search(planet, place, way, 0.0, total, 720 if kind == "band" else 90)
    edge = max(1e-7, 1e-12 * total)
    reach = "within"
    track = ("none", "none")
    if edge < s < total - edge:
        along, across = foot(planet, line, place, s, distance if side > 0 else -distance)
        assert 0 <= along <= length
        found, at = abs(across), along
        if kind != "band":
            track = (text(across), text(along))
    else:
        ends = [(inverse(planet, place, end)[1], at) for end, at in ((start, mpf(0)), (end, length))]
        found, at = min(ends)
        reach = "before" if at == 0 else "past"
        if kind != "band":
            # The whole line, if its closest point is no matter of choice.
            half = 0.98 * 3.14159 * float(planet.b)
            s, distance, side = search(planet, place, way, -half, half, 180)
            if abs(s) < 0.97 * half and distance < 9.9e6 * float(planet.b) / 6356752:
                try:
                    along, across = foot(planet, line, place, s, distance if side > 0 else -distance)
                    track = (text(across), text(along))
                except ArithmeticError:
                    pass
    if reach == "within":
        position, _, _, _, _ = line.at(at)
    else:
        position = planet.place(*(start if reach == "before" else end)).position
    fields = [name, *map(repr, (*place, *start, *end)), text(found), *map(text, position), text(at), reach, *track, kind]
    return "\t".join(fields)


def cases(rng):
    """Name, place, start, end, class."""

    def anywhere():
        return float(degrees(asin(rng.uniform(-1, 1)))), rng.uniform(-180, 180)

    def from_(double, place, azimuth, distance):
        end = double.Direct(*place, azimuth, distance)
        return end["lat2"], end["lon2"]

    def rounded(*places):
        return [tuple(map(single, place)) for place in places]

    double = {name: Geodesic(float(a), float(f)) for name, (a, f) in ELLIPSOIDS.items()}
    for name, count in (("wgs84", 1), ("oblate10", 4), ("prolate150", 4), ("sphere", 3)):
        earth = double[name]
        for k in range(100 // count):
            start = anywhere()
            length, away = 10 ** rng.uniform(0, 7), 10 ** rng.uniform(0, 6.9)
            end = from_(earth, start, rng.uniform(-180, 180), length)
            way = earth.InverseLine(*start, *end)
            middle = way.Position(way.s13 * rng.uniform(-0.2, 1.2))
            place = from_(earth, (middle["lat2"], middle["lon2"]), middle["azi2"] + rng.choice([90, -90]), away)
            kind = "beside"
            if k % 3 == 0:
                (place, start, end), kind = rounded(place, start, end), "f32"
            yield name, place, start, end, kind
        for _ in range(32 // count):
            yield name, anywhere(), anywhere(), anywhere(), "anywhere"
        # On a sphere all points of the leg are as far then.
        for _ in range(0 if name == "sphere" else 20 // count):
            # The place is near a pole of the leg's line.
            start = anywhere()
            azimuth = rng.uniform(-180, 180)
            end = from_(earth, start, azimuth, rng.uniform(2e6, 1.96e7))
            way = earth.InverseLine(*start, *end)
            middle = way.Position(way.s13 * rng.random())
            away = 0.5 * 3.14159265 * float(ELLIPSOIDS[name][0]) * (1 - 0.002 * rng.random())
            place = from_(earth, (middle["lat2"], middle["lon2"]), middle["azi2"] + 90, away)
            yield name, place, start, end, "band"
    earth = double["wgs84"]
    for _ in range(10):
        # Over a pole, next to one, from one.
        side = rng.choice([-1, 1])
        lon = rng.uniform(-180, 180)
        start = (side * rng.uniform(60, 90), lon)
        end = (side * rng.uniform(60, 90), rng.choice([lon + 180 if lon < 0 else lon - 180, lon + rng.uniform(-1, 1)]))
        place = (side * rng.uniform(70, 90), rng.uniform(-180, 180))
        yield "wgs84", place, start, end, "polar"
        yield "wgs84", (side * 90.0, 0.0), start, end, "polar"
        yield "wgs84", place, (side * 90.0, rng.uniform(-180, 180)), end, "polar"
    for _ in range(8):
        # Across 180°, along the equator, along a meridian.
        start, end = (rng.uniform(-60, 60), rng.uniform(170, 180)), (rng.uniform(-60, 60), rng.uniform(-180, -170))
        yield "wgs84", (rng.uniform(-60, 60), rng.choice([-1, 1]) * rng.uniform(175, 180)), start, end, "date line"
        yield "wgs84", (rng.uniform(-30, 30), rng.uniform(0, 40)), (0.0, 3.0), (0.0, rng.uniform(4, 90)), "equator"
        yield "wgs84", (rng.uniform(-60, 60), rng.uniform(0, 40)), (-40.0, 13.0), (rng.uniform(-30, 70), 13.0), "meridian"
    for _ in range(10):
        # On the far side.
        start = anywhere()
        end = from_(earth, start, rng.uniform(-180, 180), 10 ** rng.uniform(3, 7))
        far = (-start[0], start[1] + 180 if start[1] < 0 else start[1] - 180)
        place = from_(earth, far, rng.uniform(-180, 180), 10 ** rng.uniform(5, 6.5))
        yield "wgs84", place, start, end, "far side"
    # Issues: phpgeo 92 and 56, turf 2934, 2870 and 2234, Boost.Geometry 595 (two).
    leg = (55.984670000751470, 13.54443000032418), (55.98461833972562, 13.544295002187091)
    yield "wgs84", (55.976093, 13.547599), *leg, "issue"
    yield "wgs84", (29.941561, -95.118365), (29.888044473729, -93.580916446874), (29.890583508738, -93.552272621677), "issue"
    yield "wgs84", (-88.0, -45.0), (88.0, 25.0), (-70.0, 25.0), "issue"
    yield "wgs84", (46.50646, 13.6023), (-58.32062, -96.80974), (38.36643, -50.2464), "issue"
    yield "wgs84", (28.5528852825411, -58.26491343728603), (25.604782, -64.371054), (45.178866, -19.65732), "issue"
    yield "wgs84", (-6.29345, 3.32696), (-7.52882, -16.42203), (-6.15568, 4.89998), "issue"
    yield "wgs84", (-6.28451, 3.3262), (-7.52882, -16.42203), (-6.15568, 4.89998), "issue"


def nodes(count):
    """Of Gauss and Legendre, by Newton's method on the polynomial."""
    found = []
    for k in range(1, count + 1):
        x = cos(pi * (mpf(k) - mpf(1) / 4) / (count + mpf(1) / 2))
        for _ in range(100):
            p, q = mpf(1), x
            for n in range(2, count + 1):
                p, q = q, ((2 * n - 1) * x * q - (n - 1) * p) / n
            slope = count * (x * q - p) / (x * x - 1)
            dx = q / slope
            x -= dx
            if abs(dx) < mpf(10) ** -44:
                break
        found.append((x, 2 / ((1 - x * x) * slope**2)))
    return found


def main():
    global NODES
    NODES = nodes(30)
    planets = {name: Planet(*of) for name, of in ELLIPSOIDS.items()}
    rows = []
    for name, place, start, end, kind in cases(random.Random(20)):
        try:
            rows.append(row(name, planets[name], tuple(place), tuple(start), tuple(end), kind))
        except ArithmeticError as why:
            print("left out:", why, name, place, start, end, kind, flush=True)
    with open("closest.tsv", "w") as out:
        out.write("# The point of a geodesic segment that is closest to a place; its position in Earth axes, in metres.\n")
        out.write("# Made by make_closest.py with mpmath, 45 digits; lines close to 1e-28 m.\n")
        columns = "ellipsoid lat lon lat1 lon1 lat2 lon2 distance x y z along reach across_line along_line class"
        out.write("\t".join(columns.split()) + "\n")
        out.write("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
