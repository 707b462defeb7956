#!/usr/bin/env python3
"""High-precision truth for the derivatives of the cube projections: writes cube_jacobian.tsv next to itself.

Needs mpmath and make_cube.py, nothing else. The same file comes out of every run. README.md has the conventions.
"""

import os
import random

from mpmath import mp, mpf

import make_cube as cube

SEED = 2016
STEP = mpf(10) ** -35  # central differences: the error is of the order of its square
ONE = mpf(1)


def outerra(x, y):
    return x, y, 1 + (mp.sqrt(2) - 1) / 2 * (1 - x * x) * (1 - y * y)


def in_triangle(inverse):
    """A map given where |y| <= x, turned onto the other three triangles."""
    def whole(x, y):
        if abs(y) <= abs(x):
            X, Y, Z = inverse(abs(x), y)
            return (X if x > 0 else -X), Y, Z
        Y, X, Z = inverse(abs(y), x)
        return X, (Y if y > 0 else -Y), Z
    return whole


@in_triangle
def quadrilateralized(x, y):
    m = y / x
    t = mp.sin(mp.pi * m / 12) / (mp.cos(mp.pi * m / 12) - 1 / mp.sqrt(2))
    h = x * x * (1 - 1 / mp.sqrt(2 + t * t))
    X = mp.sqrt(h * (2 - h) / (1 + t * t))
    return X, t * X, 1 - h


def cartesian(x, y):
    a, b = x * x, y * y
    return x * mp.sqrt(ONE / 2 - b / 6), y * mp.sqrt(ONE / 2 - a / 6), mp.sqrt(1 - a / 2 - b / 2 + a * b / 3)


def healpix_side(x, y):
    height = 2 * y / 3
    radius = mp.sqrt(1 - height * height)
    return radius * mp.sin(mp.pi * x / 4), height, radius * mp.cos(mp.pi * x / 4)


@in_triangle
def healpix_cap(x, y):
    height = 1 - x * x / 3
    radius = mp.sqrt(1 - height * height)
    angle = mp.pi / 4 * y / x
    return radius * mp.cos(angle), radius * mp.sin(angle), height


def s2_quadratic(x, y):
    def half(w):
        s = (w + 1) / 2
        return (4 * s * s - 1) / 3 if s >= ONE / 2 else (1 - 4 * (1 - s) ** 2) / 3
    return half(x), half(y), ONE


def cobe_exact(x, y):
    """The published forward polynomial, inverted by Newton's method with secants."""
    forward, _ = cube.cobe_published()
    u, v, h = x, y, mpf(10) ** -55
    for _ in range(40):
        a, b = forward(u, v, ONE)
        au, bu = ((p - q) / h for p, q in zip(forward(u + h, v, ONE), (a, b)))
        av, bv = ((p - q) / h for p, q in zip(forward(u, v + h, ONE), (a, b)))
        det = au * bv - av * bu
        du = ((x - a) * bv - (y - b) * av) / det
        dv = ((y - b) * au - (x - a) * bu) / det
        u, v = u + du, v + dv
        if abs(du) + abs(dv) < mpf(10) ** -100:
            return u, v, ONE
    raise ArithmeticError("no convergence")


def inverse_of(name):
    return cube.MAPS[name][1]()[1]


MAPS = [
    ("tangential", 0, lambda x, y: (x, y, ONE)),
    ("adjusted", 0, cube.tangent_family(mp.pi / 4)[1]),
    ("outerra", 0, outerra),
    ("cobe", 0, inverse_of("cobe")),
    ("cobe-exact", 0, cobe_exact),
    ("quadrilateralized", 0, quadrilateralized),
    ("cartesian", 0, cartesian),
    ("healpix", 0, healpix_side),
    ("healpix", 4, healpix_cap),
    ("s2-quadratic", 0, s2_quadratic),
]
MAPS += [(name, face, cube.kinds(name)[face][1]) for name in cube.MAPS if name != "cobe"
         for face in ((0, 4) if name in cube.BY_FACE else (0,))]


def inputs(rng):
    """Places beside the creases that a map may have, never on them."""
    u = lambda: rng.uniform(-0.98, 0.98)
    rows = [(u(), u(), "uniform") for _ in range(14)]
    rows += [(cube.f32(u()), cube.f32(u()), "f32") for _ in range(14)]
    for d in (2.0 ** -10, 2.0 ** -20):
        a, s = cube.f32(u()), cube.sign(rng)
        rows += [
            (s * (1 - d), a, "edge"),
            (a, s * (1 - d), "edge"),
            (s * (1 - d), 1 - 2 * d, "corner"),
            (a, cube.f32(a * (1 - d)), "diagonal"),
            (d, a, "axis"),
            (a, -d, "axis"),
            (d, d / 2, "centre"),
        ]
    return rows


def main():
    rows = []
    for name, face, inverse in MAPS:
        for xf, yf, where in inputs(random.Random(f"{SEED} {name} {face}")):
            x, y = mpf(xf), mpf(yf)
            by_x, by_y = cube.tangents(inverse, x, y, STEP)
            area = mp.sqrt(sum(c * c for c in cube.cross(by_x, by_y)))
            numbers = (*by_x, *by_y, area)
            rows.append([name, str(face), cube.decimal(xf), cube.decimal(yf), *(cube.digits(c) for c in numbers), where])
    head = [
        "# Derivatives of the unit vector, in the face's frame (right, up, outward), by x and by y; area is the length of their product",
        f"# Tool: mpmath with {mp.dps} working digits, central differences with a step of 1e-35 (make_jacobian.py, seed {SEED}); 25 significant digits.",
        "# Inputs are shortest round-trip decimals of binary64 values; truth is computed from exactly those binary64 values.",
        "\t".join(["projection", "face", "x", "y", "rx", "ux", "ox", "ry", "uy", "oy", "area", "class"]),
    ]
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "cube_jacobian.tsv")
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("\n".join(head + ["\t".join(r) for r in rows]) + "\n")
    print(f"{os.path.basename(path)}: {len(rows)} rows")


if __name__ == "__main__":
    main()
