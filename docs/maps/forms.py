#!/usr/bin/env python3
"""Other forms than compact.py's: how low the texture oversize goes with tangents, creases and a free corner.

    pip install numpy scipy
    python3 forms.py            a minute

In the octant 0 <= y <= x <= 1, u = x(1 + pU), v = y(1 + qV) for sums U, V of terms. The figures are over
the places that the search uses, and over 1893.
"""

import numpy as np

from compact import improve, oversize
from even import octant

FORMS = [
    ("polynomial", 2), ("polynomial", 5), ("polynomial", 8), ("tangent", 2), ("tangent", 5), ("tangent", 8),
    ("crease", 2), ("crease", 4), ("crease", 6), ("corner", 2), ("corner", 4), ("corner", 6),
]
STEP = 1e-30j  # derivatives by a complex step
NEAR = 1 - 1e-5


def powers(a, b, degree):
    return [a ** (2 * i) * b ** (2 * j) for i in range(degree + 1) for j in range(degree + 1 - i)]


def terms(form, degree, a, b, x, y):
    """Of the coordinate a, where b is the other; x and y are the same two, the larger one first."""
    beside = {
        "crease": lambda: x * x - y * y,  # |X - Y|, which bends at the diagonal
        "corner": lambda: np.sqrt((1 - x * x) ** 2 + (1 - y * y) ** 2),
    }.get(form)
    return powers(a, b, degree) + ([beside() * t for t in powers(a, b, degree - 1)] if beside else [])


class Places:
    def __init__(self, form, degree, dense):
        x, y = octant((1 - np.cos(np.pi * np.arange(dense + 1) / dense)) / 2)
        inside = x * y < 1  # a free corner has no derivative there: places next to it instead
        x, y = np.r_[x[inside], NEAR, 1, NEAR], np.r_[y[inside], NEAR, NEAR, 2 * NEAR - 1]
        self.tangent = form == "tangent"
        self.x, self.y = x, y

        def bent(x, y):
            u, v = terms(form, degree, x, y, x, y), terms(form, degree, y, x, x, y)
            return np.array([x * (1 - x * x) * t for t in u]), np.array([y * (1 - y * y) * t for t in v])

        self.u, self.v = bent(x, y)
        self.by_x = [s.imag / STEP.imag for s in bent(x + STEP, y + 0j)]
        self.by_y = [s.imag / STEP.imag for s in bent(x + 0j, y + STEP)]

    def jacobian(self, c):
        u, v = self.x + c @ self.u, self.y + c @ self.v
        (ux, vx), (uy, vy) = ([c @ s for s in by] for by in (self.by_x, self.by_y))
        ux, vy = 1 + ux, 1 + vy
        if not self.tangent:
            return u, v, ux, uy, vx, vy
        u, v = np.tan(np.pi / 4 * u), np.tan(np.pi / 4 * v)
        du, dv = (np.pi / 4 * (1 + w * w) for w in (u, v))
        return u, v, ux * du, uy * du, vx * dv, vy * dv


def main():
    for form, degree in FORMS:
        dense = 16 if degree < 6 else 26
        places = Places(form, degree, dense)
        c = np.zeros(len(places.u))
        c[0] = 0 if form == "tangent" else -0.24
        c, worst = improve(places, c, list(range(len(c))), steps=60)
        more = oversize(Places(form, degree, 60), c)
        print(f"{form} {degree}: {len(c)} coefficients, {np.exp(worst):.4f}, {np.exp(more):.4f}", flush=True)


if __name__ == "__main__":
    main()
