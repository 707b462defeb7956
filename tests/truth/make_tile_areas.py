"""Areas of tiles on ellipsoids: the integral of the authalic sine by longitude around the edges of a tile.

The maps are those of make_cube.py. The area between the equator and a parallel on a strip of longitude is known
in closed form, so the area of a tile is the integral of that along its edges, by Gauss's formula with 24 nodes
on each half of an edge, in 110 digits. Derivatives along the edges are differences over 2e-35.
"""

import os
import random

from mpmath import mp, mpf

from make_cube import from_local, kinds

mp.dps = 110
H = mpf(10) ** -35
ELLIPSOIDS = {"wgs84": (mpf(6378137), 1 / mpf("298.257223563")), "oblate10": (mpf(6378137), mpf(1) / 10)}
PROJECTIONS = ("algebraic", "everitt", "arvo", "continuous", "vertex", "balanced", "square", "unicube", "even",
               "hybrid-equi-angular")
SHIFTS = {"geodetic": 0, "parametric": 1, "geocentric": 2}


def gauss(n=24):
    """Nodes and weights on [0, 1]."""
    nodes = []
    for k in range(1, n + 1):
        x = mp.cos(mp.pi * (k - mpf(1) / 4) / (n + mpf(1) / 2))
        for _ in range(12):
            p, q = mpf(1), mpf(0)
            for m in range(n):
                p, q = ((2 * m + 1) * x * p - m * q) / (m + 1), p
            slope = n * (x * p - q) / (x * x - 1)
            x -= p / slope
        nodes.append(((1 + x) / 2, 1 / ((1 - x * x) * slope * slope)))
    return nodes


NODES = gauss()


def strip(sine, a, f):
    """The area from the equator to a geodetic latitude, for a radian of longitude."""
    e2 = f * (2 - f)
    e = mp.sqrt(e2)
    return a * a * (1 - e2) / 2 * (sine / (1 - e2 * sine * sine) + mp.atanh(e * sine) / e)


def area(inverse, face, level, i, j, shift, a, f):
    width = mpf(2) / 2 ** level
    x0, y0 = 2 * mpf(i) / 2 ** level - 1, 2 * mpf(j) / 2 ** level - 1
    corners = [(x0, y0), (x0 + width, y0), (x0 + width, y0 + width), (x0, y0 + width)]
    stretch = (1 / (1 - f)) ** shift

    def place(x, y):
        Y, Z, X = from_local(face, inverse(x, y))
        axial = mp.sqrt(X * X + Y * Y)
        z = Z * stretch
        return X, Y, axial, z / mp.sqrt(z * z + axial * axial)

    total = mpf(0)
    parts = 2
    for (xa, ya), (xb, yb) in zip(corners, corners[1:] + corners[:1]):
        for part in range(parts):
            for node, weight in NODES:
                t = (part + node) / parts
                x, y = xa + t * (xb - xa), ya + t * (yb - ya)
                X, Y, axial, sine = place(x, y)
                dx, dy = (xb - xa) / width * H, (yb - ya) / width * H
                X1, Y1, *_ = place(x + dx, y + dy)
                X0, Y0, *_ = place(x - dx, y - dy)
                turn = (X * (Y1 - Y0) - Y * (X1 - X0)) / (2 * H) / (axial * axial)
                total += weight / parts * width * turn * strip(sine, a, f)
    # Counter-clockwise, eastward below and westward above. At a pole the longitude jumps by a right angle.
    at_pole = face in (4, 5) and (0, 0) in corners
    return (mp.pi / 2 * strip(mpf(1), a, f) if at_pole else 0) - total


def main():
    rng = random.Random(20)
    mp.dps = 110
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "tile_areas.tsv"), "w") as file:
        file.write("# Areas of tiles in square metres: make_tile_areas.py\n")
        file.write("projection\tshift\tellipsoid\tface\tlevel\ti\tj\tarea\n")
        for name in PROJECTIONS:
            maps = kinds(name)
            for n, level in enumerate((0, 1, 1, 2, 3, 4, 6, 9, 14, 20, 30)):
                face = rng.choice((0, 1, 2, 3)) if level == 0 else rng.choice((n % 4, 4, 5))
                last = 2 ** level - 1
                i = rng.choice((0, last, rng.randint(0, last), rng.randint(0, last)))
                j = rng.choice((i, rng.randint(0, last), rng.randint(0, last)))
                shift, ellipsoid = rng.choice(list(SHIFTS)), rng.choice(list(ELLIPSOIDS))
                value = area(maps[face][1], face, level, i, j, SHIFTS[shift], *ELLIPSOIDS[ellipsoid])
                row = [name, shift, ellipsoid, face, level, i, j, mp.nstr(value, 25)]
                file.write("\t".join(map(str, row)) + "\n")
            file.flush()


if __name__ == "__main__":
    main()
