#!/usr/bin/env python3
"""The least texture oversize that ../maps.md proves, and each step of the proof tried on the map `compact`.

    python3 bounds.py

L is the length of an edge of a face. M, delta, P and A are those of the page.
"""

from math import acos, atan, hypot, sin, sqrt

L = acos(1 / 3)
COMPACT = {
    (0, 0): -0.242, (2, 0): 0.032, (1, 1): 0.183, (1, 2): -1.119,
    (1, 3): 0.904, (3, 1): -0.069, (0, 2): 0.483, (0, 3): -0.375,
}


def distance(arc):
    """Between the points of opposite edges at this arc from their middles."""
    return acos(sin(arc) ** 2)


def mean(f, a, b, n=200):
    """Of f over [a, b], by Simpson's rule."""
    at = [f(a + (b - a) * i / n) for i in range(n + 1)]
    return (at[0] + at[-1] + 4 * sum(at[1:-1:2]) + 2 * sum(at[2:-1:2])) / (3 * n)


def largest(delta, aspect, end):
    """What M is at least, by the lines within delta of the midlines; that at t ends at arc end(t)."""
    return mean(lambda t: distance(end(t)), 0, delta) / 2 / (1 - delta / 2 * (1 - aspect**-0.5))


def oversize(delta):
    """The least e with e^2 = (M(e) / (L/2))^2."""
    low, high = 1.0, 2.0
    for _ in range(60):
        e = (low + high) / 2
        low, high = (e, high) if e < largest(delta, e, lambda t: t * L / 2) / (L / 2) else (low, e)
    return low


def compact(x, y):
    def bent(a, b):
        return a * (1 + (1 - a * a) * sum(c * a ** (2 * i) * b ** (2 * j) for (i, j), c in COMPACT.items()))

    u, v = bent(x, y), bent(y, x)
    r = sqrt(1 + u * u + v * v)
    return 1 / r, u / r, v / r


def arc(outward, right, up):
    """From the middle of the edge on the right."""
    return atan(up / hypot(outward, right))


def scales(x, y, h=1e-5):
    def speed(p, q):
        return hypot(*(a - b for a, b in zip(compact(*p), compact(*q)))) / (2 * h)

    return speed((x + h, y), (x - h, y)), speed((x, y + h), (x, y - h))


def main():
    best = max((oversize(i / 1000), i / 1000) for i in range(1, 1001))
    print(f"oversize at least {best[0]:.6f} (lines within {best[1]}); {oversize(1e-9):.6f} by the midline")

    scale = [L / 2 * i / 100 for i in range(1, 101)]
    quotients = [largest(best[1], best[0], lambda t: L / 2 - m * (1 - t)) / m for m in scale]
    assert quotients == sorted(quotients, reverse=True), "an edge of even scale is the worst case"

    n = 200
    grid = [(i + 0.5) / n for i in range(n)]
    inside = {(x, y): scales(x, y) for x in grid for y in grid}
    edge = [scales(1, y) for y in grid]
    places = [*inside.values(), *edge]
    aspect = max(max(a / b, b / a) for a, b in places) ** 2
    products = [a * b for a, b in places]
    ratio, least = max(products) / min(products), min(b for _, b in edge)
    upper = sqrt(max(products)) * aspect**0.25
    d = best[1]
    strips = sum((a if y < d else 0) + (b if x < d else 0) for (x, y), (a, b) in inside.items()) / n**2
    ends = sum(distance(arc(*compact(1, y))) for y in grid if y < d) / n
    lower = largest(d, aspect, lambda t: L / 2 - least * (1 - t))
    print(f"compact: aspect {aspect:.4f}, products {ratio:.4f}")
    print(f"  least scale of the edge {least:.4f} <= {L / 2:.4f}")
    print(f"  strips {strips:.4f} >= {ends:.4f} by their ends; M {upper:.4f} >= {lower:.4f}")
    print(f"  aspect x products {aspect * ratio:.4f} >= {(upper / least) ** 2:.4f} >= {best[0] ** 2:.4f}")
    assert strips >= ends and upper >= lower >= least * best[0]
    assert aspect * ratio >= (upper / least) ** 2


if __name__ == "__main__":
    main()
