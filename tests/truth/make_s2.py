#!/usr/bin/env python3
"""Writes s2_cells.tsv: S2's leaf cells of vectors, by Google's C++ library. Needs s2geometry (PyPI); see README.md."""

import itertools
import math
import random

import s2geometry as s2


def centre_and_corners(rng):
    level = rng.randrange(31)
    cell = s2.S2CellId(s2.S2Point_FromRaw(*(rng.gauss(0, 1) for _ in range(3)))).parent(level)
    yield cell.ToPoint()
    for corner in range(4):
        yield s2.S2Cell(cell).GetVertex(corner)


def vectors():
    # Axes, edges and corners of the cube, in all signs; unit vectors, and others.
    for v in itertools.product((-1.0, -0.0, 0.0, 1.0), repeat=3):
        if any(v):
            yield v
            length = math.sqrt(sum(x * x for x in v))
            yield tuple(x / length for x in v)
    rng = random.Random(1610)
    sign = lambda: rng.choice((-1, 1))
    for _ in range(300):
        a, b = rng.random(), rng.random() * 10 ** rng.uniform(-20, 0)
        v = [sign() * a, sign() * a, sign() * a * b]
        rng.shuffle(v)
        yield tuple(v)
        v = [sign() * a, rng.choice((-0.0, 0.0)), sign() * b]
        rng.shuffle(v)
        yield tuple(v)
        # Of which the larger component is larger by a digit.
        v = [sign() * a, sign() * math.nextafter(a, 2), sign() * a * b]
        rng.shuffle(v)
        yield tuple(v)
    for _ in range(200):
        for point in centre_and_corners(rng):
            yield point.x(), point.y(), point.z()
    # On the lines of a level: u of a whole number of cells.
    for _ in range(300):
        uv = []
        for _ in range(2):
            s = rng.randrange(2**10 + 1) / 2**10
            uv.append((4 * s * s - 1) / 3 if s >= 0.5 else (1 - 4 * (1 - s) * (1 - s)) / 3)
        v = uv + [sign()]
        rng.shuffle(v)
        yield tuple(float(x) for x in v)
    for _ in range(300):
        scale = 10 ** rng.uniform(-100, 100)
        yield tuple(scale * rng.gauss(0, 1) for _ in range(3))


with open("s2_cells.tsv", "w") as out:
    out.write("# Leaf cells of vectors of any length: S2CellId(S2Point), C++ S2 0.14. Inputs are binary64, ids hexadecimal.\n")
    out.write("# Made by make_s2.py (s2geometry).\n")
    out.write("x\ty\tz\tid\n")
    for v in vectors():
        id = s2.S2CellId(s2.S2Point_FromRaw(*v)).id()
        out.write("\t".join([repr(float(x)) for x in v] + [f"{id:016x}"]) + "\n")
