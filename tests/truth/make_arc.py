"""Makes arc.tsv: lengths of arcs of geodesic circles on WGS84.

The arc is at `radius` metres from lat lon, from an azimuth clockwise through `sweep` degrees; lat2 lon2 is its end. The
length is the integral of the reduced length over the azimuth (Karney 2013, equation 40); all
integrals are by Gauss's rule with 24 nodes.
"""

import random

from mpmath import atan2, cos, hypot, mp, mpf, nstr, pi, radians, sin, sqrt
from mpmath.calculus.quadrature import GaussLegendre

from make_fence import B, EP2, F, direct

mp.dps = 30


NODES = GaussLegendre(mp).calc_nodes(4, mp.prec)


def integral(f, start, end):
    """By 24 nodes: the integrands are nearly constant."""
    middle, half = (start + end) / 2, (end - start) / 2
    return half * sum(weight * f(middle + half * node) for node, weight in NODES)


def reduced(lat, azimuth, distance):
    beta = mp.atan((1 - F) * mp.tan(radians(lat)))
    alpha = radians(azimuth)
    cos0 = hypot(cos(alpha), sin(alpha) * sin(beta))
    sigma1 = atan2(sin(beta), cos(alpha) * cos(beta))
    k2 = EP2 * cos0**2
    root = lambda sigma: sqrt(1 + k2 * sin(sigma) ** 2)
    sigma2 = sigma1 + distance / B
    for _ in range(60):
        step = (integral(root, sigma1, sigma2) - distance / B) / root(sigma2)
        sigma2 -= step
        if abs(step) < mpf(10) ** -16:
            # Newton's next step is below the rounding.
            sigma2 -= (integral(root, sigma1, sigma2) - distance / B) / root(sigma2)
            break
    else:
        raise ArithmeticError((lat, azimuth, distance))
    j = integral(lambda sigma: k2 * sin(sigma) ** 2 / root(sigma), sigma1, sigma2)
    return B * (
        root(sigma2) * cos(sigma1) * sin(sigma2) - root(sigma1) * sin(sigma1) * cos(sigma2) - cos(sigma1) * cos(sigma2) * j
    )


def check():
    """About a pole the circle is a parallel."""
    distance = mpf(3000000)
    lat, _, _ = direct(mpf(90), mpf(0), mpf(180), distance)
    parallel = 6378137 * cos(radians(lat)) / sqrt(1 - F * (2 - F) * sin(radians(lat)) ** 2)
    assert abs(reduced(mpf(90), mpf(180), distance) - parallel) < mpf(10) ** -10


def rows():
    rng = random.Random(21)
    for number in range(104):
        lat = mpf(float(rng.choice((rng.uniform(-89, 89), 90, 0, 45)))) if number % 4 else mpf(rng.uniform(-89, 89))
        lon = mpf(rng.uniform(-180, 180))
        radius = mpf(float(10 ** rng.uniform(1, 6.95)))
        azimuth = mpf(rng.uniform(-180, 180))
        sweep = mpf(float(rng.choice((360, 90, rng.uniform(0, 360), 10 ** rng.uniform(-2, 2)))))
        thirds = [azimuth + sweep * third / 3 for third in range(4)]
        width = lambda a: reduced(lat, a, radius)
        length = sum(integral(width, *part) for part in zip(thirds, thirds[1:])) * pi / 180
        end = direct(lat, lon, azimuth + sweep, radius)
        inputs = [repr(float(x)) for x in (lat, lon, radius, azimuth, sweep)]
        yield inputs + [nstr(x, 22) for x in (length, end[0], end[1])] + ["arc"]


if __name__ == "__main__":
    check()
    with open("arc.tsv", "w") as file:
        print("# make_arc.py: mpmath, 30 digits", file=file)
        print("lat lon radius azimuth sweep length lat2 lon2 class".replace(" ", "\t"), file=file)
        for row in rows():
            print("\t".join(row), file=file, flush=True)
