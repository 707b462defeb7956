#!/usr/bin/env python3
"""The search for the compact cube: a polynomial map of a face with the least texture oversize.

    pip install numpy scipy
    python3 compact.py          the search: which eight terms, and their coefficients (two minutes)
    python3 compact.py check    the figures of the map that terrella has, by other formulas

The map has the form of even.py's. For the scales a along x and b along y, the largest aspect ratio over the smallest, and
the same of the products ab, are minimax: a sequence of linear programs for the coefficients, in which the logarithms of a and
b are linear about the last ones. ../maps.md has the problem and the results.
"""

import sys

import numpy as np
from scipy.optimize import linprog

from even import Places, octant, terms

TERMS = 8
DIGITS = 3

# What terrella has: the coefficient of XⁱYʲ by (i, j).
COMPACT = {
    (0, 0): -0.242,
    (2, 0): 0.032,
    (1, 1): 0.183,
    (1, 2): -1.119,
    (1, 3): 0.904,
    (3, 1): -0.069,
    (0, 2): 0.483,
    (0, 3): -0.375,
}


def logarithms(places, c):
    """Of the aspect a/b, and of the product ab."""
    u, v, ux, uy, vx, vy = places.jacobian(c)
    r = 1 + u * u + v * v
    with np.errstate(all="ignore"):
        a, b = (np.log(((s * s + t * t) * r - (s * u + t * v) ** 2) / r**2) / 2 for s, t in ((ux, vx), (uy, vy)))
    return a - b, a + b


def oversize(places, c):
    """The logarithm of the larger of both ratios. By exchange of x and y, each aspect comes with its reciprocal."""
    aspect, product = logarithms(places, c)
    worst = max(2 * np.abs(aspect).max(), np.ptp(product))
    return worst if np.isfinite(worst) else np.inf


def improve(places, c, free, steps=80, reach=0.05):
    """Linear programs in a region that shrinks where the last one promised too much."""
    best, n, h = oversize(places, c), len(free), 1e-6
    for _ in range(steps):
        aspect, product = logarithms(places, c)
        by = [logarithms(places, c + h * np.eye(len(c))[k]) for k in free]
        aspects = np.array([(a - aspect) / h for a, _ in by]).T
        products = np.array([(p - product) / h for _, p in by]).T
        one, zero = np.ones((len(aspect), 1)), np.zeros((len(aspect), 1))
        # Unknowns: the change, the largest and the smallest product, and the oversize.
        a = np.vstack([
            np.hstack([2 * aspects, zero, zero, -one]),
            np.hstack([-2 * aspects, zero, zero, -one]),
            np.hstack([products, -one, zero, zero]),
            np.hstack([-products, zero, one, zero]),
            np.r_[np.zeros(n), 1, -1, -1],
        ])
        b = np.r_[-2 * aspect, 2 * aspect, -product, product, 0]
        limits = [(-reach, reach)] * n + [(None, None)] * 3
        found = linprog(np.r_[np.zeros(n + 2), 1], A_ub=a, b_ub=b, bounds=limits, method="highs")
        if found.x is None:
            break
        changed = c.copy()
        changed[free] += found.x[:n]
        worst = oversize(places, changed)
        if worst < best:
            gain, c, best, reach = best - worst, changed, worst, min(2 * reach, 0.3)
            if gain < 1e-8:
                break
        else:
            reach /= 3
            if reach < 1e-8:
                break
    return c, best


def places(terms, dense):
    return Places(terms, *octant((1 - np.cos(np.pi * np.arange(dense + 1) / dense)) / 2))


def ranked(p, c, sets, keep):
    """The sets of terms, optimised: those first that promise the least."""
    starts = []
    for free in sets:
        start = np.where(np.isin(np.arange(len(c)), free), c, 0.0)
        starts.append((free, *improve(p, start, free, steps=6, reach=0.2)))
    starts.sort(key=lambda s: s[2])
    return min(((free, *improve(p, start, free)) for free, start, _ in starts[:keep]), key=lambda s: s[2])


def search():
    for degree in (1, 2, 3, 4, 5):
        t = terms(degree)
        c = np.zeros(len(t))
        c[0] = -0.24
        c, worst = improve(places(t, 16), c, list(range(len(t))))
        print(f"degree {degree}, {len(t)} terms: {np.exp(worst):.4f}", flush=True)
        if degree == 4:
            four = c
    t = terms(4)
    p, c, free = places(t, 16), four, list(range(len(t)))
    while len(free) > TERMS:
        free, c, worst = ranked(p, c, [[f for f in free if f != k] for k in free[1:]], 3)
        print(f"{len(free)} terms: {np.exp(worst):.4f}", flush=True)
    t = terms(5)
    p, c = places(t, 16), np.r_[c, np.zeros(len(t) - len(c))]
    while True:
        others = [k for k in range(len(t)) if k not in free]
        sets = [[f for f in free if f != old] + [new] for old in free[1:] for new in others]
        changed, found, next_worst = ranked(p, c, sets, 8)
        if next_worst > worst - 1e-5:
            break
        free, c, worst = changed, found, next_worst
        print(f"exchanged: {np.exp(worst):.4f} {sorted(t[f] for f in free)}", flush=True)
    # Round one coefficient after another, the least important first, and let the others make up for it.
    t, c = [t[f] for f in sorted(free)], c[sorted(free)]
    p, free = places(t, 40), list(range(TERMS))
    c, worst = improve(p, c, free, steps=200)
    print(f"on more places: {np.exp(worst):.4f}", flush=True)
    unit = 10.0**-DIGITS
    while free:
        tried = []
        for k in free:
            rest, d = [f for f in free if f != k], c.copy()
            d[k] = round(d[k], DIGITS)
            d, worst = improve(p, d, rest, steps=12, reach=unit) if rest else (d, oversize(p, d))
            tried.append((worst, k, d))
        worst, k, c = min(tried, key=lambda t: t[0])
        free.remove(k)
    print(f"rounded: {np.exp(worst):.4f}", flush=True)
    # Then change one or two of them by units of the last digit, as long as that helps.
    one = [sign * e for e in unit * np.eye(TERMS) for sign in (1, -1)]
    moves = one + [a + b for i, a in enumerate(one) for b in one[i + 1 :]]
    while True:
        changed, k = min((oversize(p, c + move), k) for k, move in enumerate(moves))
        if changed >= worst:
            break
        c, worst = np.round(c + moves[k], DIGITS), changed
    print(f"last digits: {np.exp(worst):.4f}")
    print({place: round(float(value), DIGITS) for place, value in zip(t, c)})


def check():
    """Scales by differences on the sphere."""

    def sphere(x, y):
        def half(x, y):
            return x * (1 + (1 - x * x) * sum(c * x ** (2 * i) * y ** (2 * j) for (i, j), c in COMPACT.items()))

        place = np.stack([half(x, y), half(y, x), np.ones_like(x)])
        return place / np.linalg.norm(place, axis=0)

    h, n = 1e-5, 1001
    x, y = np.meshgrid(*[np.linspace(-1, 1, n)] * 2)
    a, b = (sphere(x + h, y) - sphere(x - h, y)) / (2 * h), (sphere(x, y + h) - sphere(x, y - h)) / (2 * h)
    wide, high = np.linalg.norm(a, axis=0), np.linalg.norm(b, axis=0)
    area = np.linalg.norm(np.cross(a, b, axis=0), axis=0)
    aspect, product = wide / high, wide * high
    print(f"{n}² places: aspect {aspect.max() / aspect.min():.4f}, product {product.max() / product.min():.4f}, "
          f"area {area.max() / area.min():.4f}")


if __name__ == "__main__":
    check() if sys.argv[1:] == ["check"] else search()
