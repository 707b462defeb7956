#!/usr/bin/env python3
"""The search for the even cube: a polynomial map of a face whose areas differ by 1 in 1000.

    pip install numpy scipy
    python3 even.py          the search: which ten terms, and their coefficients (a minute)
    python3 even.py check    the figures of the map that terrella has, by other formulas

The map takes (x, y) to the gnomonic coordinates u = x(1 + pP(X, Y)), v = y(1 + qP(Y, X)), where X = x², Y = y²,
p = 1 − X, q = 1 − Y. The areal scale is minimax: a sequence of linear programs for the coefficients, in which the
logarithm of the scale is linear about the last ones. ../maps.md has the problem and the results.
"""

import sys

import numpy as np
from scipy.optimize import linprog

BOUND = 1.00095  # the largest areal scale over the smallest; rounding may add 0.00005
DIGITS = 4
PENALTY = 3000.0  # degrees for a ratio of e above the bound

# What terrella has: the coefficient of XⁱYʲ by (i, j).
EVEN = {
    (0, 0): -0.2766,
    (0, 1): 0.034,
    (0, 2): -0.1908,
    (0, 3): 0.4685,
    (0, 4): -0.1989,
    (1, 0): -0.0954,
    (1, 3): 0.0235,
    (2, 1): -0.2125,
    (2, 2): 0.1374,
    (5, 0): -0.0137,
}


def terms(degree):
    return [(i, total - i) for total in range(degree + 1) for i in range(total, -1, -1)]


class Places:
    """Places of a face, with the map's value there as linear functions of the coefficients."""

    def __init__(self, terms, x, y):
        X, Y = x * x, y * y
        self.x, self.y = x, y

        def columns(f):
            return np.array([f(i, j) for i, j in terms]).T

        def slope(x, j):
            return 2 * j * x ** (2 * j - 1) if j else 0 * x

        self.U = columns(lambda i, j: x * (1 - X) * X**i * Y**j)
        self.V = columns(lambda i, j: y * (1 - Y) * Y**i * X**j)
        self.Ux = columns(lambda i, j: ((2 * i + 1) * X**i - (2 * i + 3) * X ** (i + 1)) * Y**j)
        self.Vy = columns(lambda i, j: ((2 * i + 1) * Y**i - (2 * i + 3) * Y ** (i + 1)) * X**j)
        self.Uy = columns(lambda i, j: x * (1 - X) * X**i * slope(y, j))
        self.Vx = columns(lambda i, j: y * (1 - Y) * Y**i * slope(x, j))

    def jacobian(self, c):
        u, v = self.x + self.U @ c, self.y + self.V @ c
        return u, v, 1 + self.Ux @ c, self.Uy @ c, self.Vx @ c, 1 + self.Vy @ c

    def scale(self, c):
        """The logarithm of the areal scale, and its gradient."""
        u, v, ux, uy, vx, vy = self.jacobian(c)
        det, r = ux * vy - uy * vx, 1 + u * u + v * v
        with np.errstate(all="ignore"):
            value = np.log(det) - 1.5 * np.log(r)
        d = vy[:, None] * self.Ux + ux[:, None] * self.Vy - vx[:, None] * self.Uy - uy[:, None] * self.Vx
        return value, d / det[:, None] - 3 * (u[:, None] * self.U + v[:, None] * self.V) / r[:, None]

    def deformation(self, c):
        """The root mean square of the angular deformation, in degrees."""
        u, v, ux, uy, vx, vy = self.jacobian(c)
        r = 1 + u * u + v * v

        def dot(a, b, c, d):
            return ((a * c + b * d) * r - (a * u + b * v) * (c * u + d * v)) / r**2

        both, area = dot(ux, vx, ux, vx) + dot(uy, vy, uy, vy), 2 * (ux * vy - uy * vx) / r**1.5
        sine = np.sqrt(np.maximum(0, (both - area) / (both + area)))
        return np.degrees(np.sqrt(np.mean((2 * np.arcsin(sine)) ** 2)))

    def deformation_slope(self, c, free):
        value, slope, h = self.deformation(c), np.zeros(len(free)), 1e-6
        for n, k in enumerate(free):
            d = c.copy()
            d[k] += h
            slope[n] = (self.deformation(d) - value) / h
        return slope


def octant(coordinates):
    x, y = np.meshgrid(coordinates, coordinates, indexing="ij")
    return x[y <= x + 1e-12], y[y <= x + 1e-12]


class Search:
    def __init__(self, terms, dense=18):
        self.terms = terms
        chebyshev = (1 - np.cos(np.pi * np.arange(dense + 1) / dense)) / 2
        self.scale = Places(terms, *octant(chebyshev))
        self.angle = Places(terms, *octant((np.arange(dense + 8) + 0.5) / (dense + 8)))

    def spread(self, c):
        return np.ptp(self.scale.scale(c)[0])

    def merit(self, c, bound):
        """What is minimised: the spread of the scale, or the deformation with the spread at most the bound."""
        spread = self.spread(c)
        if not np.isfinite(spread):
            return np.inf
        return spread if bound is None else self.angle.deformation(c) + PENALTY * max(0, spread - np.log(bound))

    def improve(self, c, free, bound=None, steps=60, reach=0.05):
        """Linear programs in a region that shrinks where the last one promised too much."""
        best, n = self.merit(c, bound), len(free)
        for _ in range(steps):
            value, slope = self.scale.scale(c)
            slope, one, zero = slope[:, free], np.ones((len(value), 1)), np.zeros((len(value), 1))
            # Unknowns: the change, the largest and the smallest logarithm, and what the spread has too much.
            a = np.vstack([np.hstack([slope, -one, zero, zero]), np.hstack([-slope, zero, one, zero])])
            b = np.r_[-value, value]
            cost = np.r_[np.zeros(n), 1, -1, 0]
            if bound is not None:
                a, b = np.vstack([a, np.r_[np.zeros(n), 1, -1, -1]]), np.r_[b, np.log(bound)]
                cost = np.r_[self.angle.deformation_slope(c, free), 0, 0, PENALTY]
            limits = [(-reach, reach)] * n + [(None, None)] * 2 + [(0, None)]
            found = linprog(cost, A_ub=a, b_ub=b, bounds=limits, method="highs")
            if found.x is None:
                break
            changed = c.copy()
            changed[free] += found.x[:n]
            merit = self.merit(changed, bound)
            if merit < best:
                gain, c, best, reach = best - merit, changed, merit, min(2 * reach, 0.2)
                if gain < 1e-8 * best:
                    break
            else:
                reach /= 3
            if reach < 1e-9:
                break
        return c, best

    def without(self, c, free):
        """A start with the other coefficients 0: a few steps of least squares for the scale."""
        c = np.where(np.isin(np.arange(len(c)), free), c, 0.0)
        for _ in range(5):
            value, slope = self.scale.scale(c)
            if not np.isfinite(value).all():
                return None
            slope = slope[:, free] - slope[:, free].mean(0)
            c[free] += np.linalg.lstsq(slope, value.mean() - value, rcond=1e-10)[0]
        return c if np.isfinite(self.spread(c)) else None

    def ranked(self, c, sets, keep):
        """The sets of terms, optimised: those first that promise an even scale."""
        starts = [(free, self.without(c, free)) for free in sets]
        starts = [(free, *self.improve(start, free, steps=5)) for free, start in starts if start is not None]
        starts.sort(key=lambda s: s[2])
        found = [(free, *self.improve(start, free, BOUND, steps=40)) for free, start, _ in starts[:keep]]
        return min(found, key=lambda s: s[2])

    def report(self, text, c, free):
        ratio, rms = np.exp(self.spread(c)), self.angle.deformation(c)
        print(f"{text}: {len(free)} terms, areas {ratio:.6f}, rms deformation {rms:.4f}", flush=True)


def search():
    for degree in (2, 3, 4, 5):
        s = Search(terms(degree))
        free = list(range(len(s.terms)))
        c = np.zeros(len(free))
        c[0] = -0.27
        c, _ = s.improve(c, free, reach=0.1)
        s.report(f"degree {degree}, the most even", c, free)
        if np.exp(s.spread(c)) < BOUND:
            c, _ = s.improve(c, free, BOUND)
            s.report(f"degree {degree}, least deformation", c, free)
    four = Search(terms(4))
    free = list(range(len(four.terms)))
    c = np.zeros(len(free))
    c[0] = -0.27
    c, _ = four.improve(c, free, reach=0.1)
    c, _ = four.improve(c, free, BOUND)
    while len(free) > 10:
        free, c, _ = four.ranked(c, [[f for f in free if f != k] for k in free[1:]], 5)
        four.report(f"without {set(four.terms) - {four.terms[f] for f in free}}", c, free)
    s = Search(terms(5))
    c = np.r_[c, np.zeros(len(s.terms) - len(c))]
    c, best = s.improve(c, free, BOUND)
    while True:
        others = [k for k in range(len(s.terms)) if k not in free]
        sets = [[f for f in free if f != old] + [new] for old in free[1:] for new in others]
        changed, found, merit = s.ranked(c, sets, 30)
        if merit > best - 1e-3:
            break
        free, c, best = changed, found, merit
        s.report(f"exchanged: {sorted(s.terms[f] for f in free)}", c, free)
    # Round one coefficient after another, the least important first, and let the others make up for it.
    s = Search([s.terms[f] for f in sorted(free)], dense=40)
    c = c[sorted(free)]
    free = list(range(len(c)))
    c, _ = s.improve(c, free, BOUND, steps=200)
    s.report("on more places", c, free)
    while free:
        best = None
        for k in free:
            rest = [f for f in free if f != k]
            d = c.copy()
            d[k] = round(d[k], DIGITS)
            d, merit = s.improve(d, rest, BOUND, steps=12, reach=10.0**-DIGITS) if rest else (d, s.merit(d, BOUND))
            if best is None or merit < best[0]:
                best = merit, k, d
        _, k, c = best
        free.remove(k)
    s.report("rounded", c, range(len(c)))
    # Then change one or two of them by units of the last digit, as long as that helps.
    unit, n = 10.0**-DIGITS, len(c)
    one = [m * e for e in unit * np.eye(n) for m in (1, -1)]
    moves = one + [a + b for i, a in enumerate(one) for b in one[i + 1 :]]
    best = s.merit(c, BOUND)
    while True:
        merit, found = min(((s.merit(c + m, BOUND), k) for k, m in enumerate(moves)))
        if merit >= best:
            break
        c, best = np.round(c + moves[found], DIGITS), merit
    s.report("last digits", c, range(n))
    print({t: round(float(v), DIGITS) for t, v in zip(s.terms, c)})


def check():
    """Areas of cells as spherical triangles, and deformation by differences."""

    def sphere(x, y):
        def half(x, y):
            return x * (1 + (1 - x * x) * sum(c * x ** (2 * i) * y ** (2 * j) for (i, j), c in EVEN.items()))

        place = np.stack([half(x, y), half(y, x), np.ones_like(x)])
        return place / np.linalg.norm(place, axis=0)

    def triangle(a, b, c):
        volume = (a * np.cross(b, c, axis=0)).sum(0)
        return 2 * np.arctan2(volume, 1 + (a * b).sum(0) + (b * c).sum(0) + (c * a).sum(0))

    n = 256
    p = sphere(*np.meshgrid(*[np.linspace(-1, 1, n + 1)] * 2, indexing="ij"))
    areas = triangle(p[:, :-1, :-1], p[:, 1:, :-1], p[:, 1:, 1:]) + triangle(p[:, :-1, :-1], p[:, 1:, 1:], p[:, :-1, 1:])
    print(f"{n}² cells: largest area over smallest {areas.max() / areas.min():.6f}, sum {areas.sum() * 3 / np.pi / 2:.12f}")
    h = 1e-5
    x, y = np.meshgrid(*[(np.arange(999) + 0.5) / 999] * 2)
    a, b = (sphere(x + h, y) - sphere(x - h, y)) / (2 * h), (sphere(x, y + h) - sphere(x, y - h)) / (2 * h)
    _, singular, _ = np.linalg.svd(np.moveaxis(np.stack([a, b]), [0, 1], [-1, -2]))
    most, least = singular[..., 0], singular[..., 1]
    angle = np.degrees(2 * np.arcsin((most - least) / (most + least)))
    print(f"areal scale, largest over smallest {(most * least).max() / (most * least).min():.6f}")
    aspect = np.linalg.norm(a, axis=0) / np.linalg.norm(b, axis=0)
    print(f"deformation {angle.max():.3f}, rms {np.sqrt(np.mean(angle**2)):.3f}, aspect {aspect.max() / aspect.min():.4f}")


if __name__ == "__main__":
    check() if sys.argv[1:] == ["check"] else search()
