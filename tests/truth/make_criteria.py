#!/usr/bin/env python3
"""Criteria of some cube projections by finite differences: writes criteria.tsv next to itself.

Needs numpy, nothing else: no code of the crate, and no formula for a derivative. The same file comes out of every
run on a machine whose long double has 64 bits of mantissa. README.md has the conventions.
"""

import os

import numpy as np

T = np.longdouble
PI = T("3.14159265358979323846264338327950288")
ROOT2, ROOT3 = np.sqrt(T(2)), np.sqrt(T(3))
STEP = T(10) ** -6
ASIDE = T(10) ** -7

COLUMNS, ROWS = 30, 32  # places of a survey: at the middles of so many columns and rows, none of them on a crease
CELLS = 16              # cells along an edge of a face
PLACES = 40             # places along a crease


# ---- the maps: from the plane to a direction (right, up, outward) -------------------------------

def unit(v):
    return v / np.sqrt((v * v).sum(0))


def separately(warp):
    return lambda x, y: unit(np.stack([warp(x), warp(y), np.ones_like(x)]))


def s2_quadratic(x):
    s = (np.abs(x) + 1) / 2
    return np.sign(x) * (4 * s * s - 1) / 3


def octants(of_first):
    """A map given where 0 <= y <= x, laid out by the symmetries of the square."""
    def whole(x, y):
        a, b = np.abs(x), np.abs(y)
        steep = b > a
        p, q, r = of_first(np.where(steep, b, a), np.where(steep, a, b))
        X, Y = np.where(steep, q, p), np.where(steep, p, q)
        return unit(np.stack([np.copysign(X, x), np.copysign(Y, y), r]))
    return whole


@octants
def quadrilateralized(x, y):
    m = PI / 12 * y / np.where(x == 0, 1, x)
    t = np.sin(m) / (np.cos(m) - 1 / ROOT2)
    h = x * x * (1 - 1 / np.sqrt(2 + t * t))
    X = np.sqrt(h * (2 - h) / (1 + t * t))
    return X, t * X, 1 - h


@octants
def vertex(x, y):
    r = 1 - y
    tau = np.tan(PI / 24 * (x - y) / np.where(r == 0, 1, r))
    half = ROOT2 * tau / ((ROOT3 - 1) / ROOT2 * (1 - tau))
    sin, cos = 2 * half / (1 + half * half), (1 - half * half) / (1 + half * half)
    D = np.stack([sin, np.zeros_like(sin), cos])
    V = np.full_like(D, 1 / ROOT3)
    VD = (V * D).sum(0)
    versine = r * r * (1 - VD)
    return V * (1 - versine) + unit(D - V * VD) * np.sqrt(versine * (2 - versine))


def balanced(x, y):
    p, q = 1 - x * x, 1 - y * y
    b = [T(-22) / 100, T(9) / 100, T(-11) / 100]
    one = lambda x, p, q: x * (1 + p * (b[0] + p * (b[1] + b[2] * q)))
    return unit(np.stack([one(x, p, q), one(y, q, p), np.ones_like(x)]))


MAPS = {
    "tangential": separately(lambda x: x),
    "adjusted": separately(lambda x: np.tan(PI / 4 * x)),
    "s2-quadratic": separately(s2_quadratic),
    "equi-edge": separately(lambda x: ROOT2 * np.tan(x * np.arctan(1 / ROOT2))),
    "algebraic": separately(lambda x: x / np.sqrt(1 + T(87) ** 2 / 10000 * (1 - x * x))),
    "outerra": lambda x, y: unit(np.stack([x, y, 1 + (ROOT2 - 1) / 2 * (1 - x * x) * (1 - y * y)])),
    "quadrilateralized": quadrilateralized,
    "vertex": vertex,
    "balanced": balanced,
}


# ---- what is measured ---------------------------------------------------------------------------

def cross(a, b):
    return np.stack([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def angle(a, b):
    c = cross(a, b)
    return np.arctan2(np.sqrt((c * c).sum(0)), (a * b).sum(0))


def middles(n):
    return (2 * np.arange(n, dtype=T) + 1) / n - 1


def texels(inverse):
    """The deviations of Lambers (2019): areal scale over its fair share, and a/b of Tissot's indicatrix."""
    x, y = (c.ravel() for c in np.meshgrid(middles(COLUMNS), middles(ROWS)))
    by_x = (inverse(x + STEP, y) - inverse(x - STEP, y)) / (2 * STEP)
    by_y = (inverse(x, y + STEP) - inverse(x, y - STEP)) / (2 * STEP)
    # The singular values from the eigenvalues of the first fundamental form.
    e, f, g = (by_x * by_x).sum(0), (by_x * by_y).sum(0), (by_y * by_y).sum(0)
    middle, spread = (e + g) / 2, np.sqrt(((e - g) / 2) ** 2 + f * f)
    area = np.sqrt(e * g - f * f) / (PI / 6)
    isotropy = np.sqrt((middle + spread) / (middle - spread))
    for name, values in [("area", area), ("scale", 1 / area), ("isotropy", isotropy)]:
        yield f"texel-{name}", values, 1


def beyond(inverse):
    """The map continued over the edges of the face: there the cube is turned."""
    def wide(x, y):
        place = inverse(np.clip(x, -1, 1), np.clip(y, -1, 1))
        for beside, (u, v), turn in [
            (x > 1, (x - 2, y), lambda p: (p[2], p[1], -p[0])),
            (x < -1, (x + 2, y), lambda p: (-p[2], p[1], p[0])),
            (y > 1, (x, y - 2), lambda p: (p[0], p[2], -p[1])),
            (y < -1, (x, y + 2), lambda p: (p[0], -p[2], p[1])),
        ]:
            there = turn(inverse(np.where(beside, u, 0.25), np.where(beside, v, 0.125)))
            place = np.where(beside, np.stack(there), place)
        return place
    return wide


def triangle(a, b, c):
    """L'Huilier."""
    p, q, r = angle(b, c) / 2, angle(c, a) / 2, angle(a, b) / 2
    s = (p + q + r) / 2
    return 4 * np.arctan(np.sqrt(np.tan(s) * np.tan(s - p) * np.tan(s - q) * np.tan(s - r)))


def cells(inverse):
    wide, n = beyond(inverse), CELLS
    x, y = (c.ravel() for c in np.meshgrid(middles(n), middles(n)))
    h = T(1) / n
    a, b, c, d = (inverse(x + i * h, y + j * h) for i, j in [(-1, -1), (1, -1), (1, 1), (-1, 1)])
    side = np.sqrt(4 * PI / 6) / n
    edges = np.stack([angle(a, b), angle(b, c), angle(c, d), angle(d, a)])
    diagonals = np.stack([angle(a, c), angle(b, d)])
    # Between the planes of opposite edges: both normals point to the same side.
    spans = np.stack([angle(cross(a, d), cross(b, c)), angle(cross(a, b), cross(d, c))])
    area = triangle(a, b, d) + triangle(b, c, d)
    centre = wide(x, y)
    spacing = np.stack([angle(centre, wide(x + 2 * i * h, y + 2 * j * h)) for i, j in [(1, 0), (0, 1), (-1, 0), (0, -1)]])
    ratio = lambda lengths: lengths.max(0) / lengths.min(0)
    yield "cell-area", area / side**2, 1
    yield "cell-edge", edges.ravel() / side, 1
    yield "cell-diagonal", diagonals.ravel() / side, ROOT2
    yield "cell-span", spans.ravel() / side, 1
    yield "cell-edge-aspect", ratio(edges), 1
    yield "cell-diagonal-aspect", ratio(diagonals), 1
    yield "cell-compactness", area * (4 * PI - area) / edges.sum(0) ** 2, PI / 4
    yield "cell-spacing", ratio(spacing), 1


def kinks(inverse):
    """The turn of a line that crosses the crease at right angles, by one-sided differences of the second order on both sides of the crease."""
    wide = beyond(inverse)

    def kink(x, y, u, v, out=0):
        """Of the line in the direction (u, v); beyond an edge the map is that of the next face."""
        def leaves(sign):
            s = np.full_like(x, sign * ASIDE)
            at = lambda k: wide(x + (sign * out + k * s) * u, y + (sign * out + k * s) * v)
            return sign * (4 * at(1) - at(2) - 3 * at(0))
        return angle(leaves(-1), leaves(1)) * 180 / PI

    s, one, zero = middles(PLACES), np.ones(PLACES, T), np.zeros(PLACES, T)
    # Just off the edge, so that each side is that of one face.
    over = T(2) ** -60
    yield "kink-edges", np.concatenate([
        kink(one, s, 1, 0, over), kink(-one, s, 1, 0, over), kink(s, one, 0, 1, over), kink(s, -one, 0, 1, over)
    ]), 0
    yield "kink-diagonals", np.concatenate([kink(s, s, 1, -1), kink(s, -s, 1, 1)]), 0
    yield "kink-midlines", np.concatenate([kink(zero, s, 1, 0), kink(s, zero, 0, 1)]), 0


HEAD = f"""\
# Criteria of cube projections on the unit sphere, on one face (of these maps all faces are alike).
# texel-*: {COLUMNS} x {ROWS} places at the middles of columns and rows; area over its mean, areal scale, a/b of Tissot.
# cell-*: {CELLS} x {CELLS} cells; lengths and areas in units of the square of mean area. kink-*: {PLACES} places a crease, degrees.
# Tool: numpy with 64 bits of mantissa, differences with steps of 1e-6 and 1e-7 (make_criteria.py).
map	criterion	min	max	mean	rmsd
"""


def main():
    if np.finfo(T).nmant < 63:
        raise SystemExit("long double is too short here")
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "criteria.tsv"), "w", encoding="ascii") as out:
        out.write(HEAD)
        for name, inverse in MAPS.items():
            for measure in (texels, cells, kinks):
                for criterion, values, ideal in measure(inverse):
                    if not np.isfinite(values).all():
                        raise SystemExit(f"{name}, {criterion}: not a number")
                    rmsd = np.sqrt(((values - ideal) ** 2).mean())
                    figures = "\t".join(f"{v:.12f}" for v in (values.min(), values.max(), values.mean(), rmsd))
                    out.write(f"{name}\t{criterion}\t{figures}\n")


if __name__ == "__main__":
    main()
