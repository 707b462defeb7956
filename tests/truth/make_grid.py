#!/usr/bin/env python3
"""Writes grid_*.tsv: map projections of WGS84. Needs mpmath; see README.md.

Transverse Mercator is made as Gauss did: the geodetic latitude of a meridian is continued to complex numbers. With the
isometric latitude ψ(φ) and the length M(φ) of the meridian, ψ(Φ) = ψ + iλ and y + ix = M(Φ). This is the exact
projection, without a series in the flattening. The others are closed formulas of Snyder (1987), with Newton's method for
the latitude on the way back.
"""

import random
import struct

from mpmath import mp, mpf, mpc, pi, asinh, atan, atan2, atanh, asin, cos, sin, tan, sinh, sqrt, exp, quad, arg, re, im, degrees, radians, nstr

mp.dps = 45
A, F = mpf(6378137), 1 / mpf("298.257223563")
E2 = F * (2 - F)
E = sqrt(E2)
TINY = mpf(10) ** -36


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def isometric(p):
    return asinh(tan(p)) - E * atanh(E * sin(p))


def isometric_slope(p):
    return (1 - E2) / ((1 - E2 * sin(p) ** 2) * cos(p))


def meridian(p):
    return A * (1 - E2) * quad(lambda t: (1 - E2 * sin(t * p) ** 2) ** mpf(-1.5) * p, [0, mpf(1) / 2, 1])


def meridian_slope(p):
    return A * (1 - E2) * (1 - E2 * sin(p) ** 2) ** mpf(-1.5)


def newton(f, slope, value, guess):
    p = guess
    for _ in range(80):
        step = (f(p) - value) / slope(p)
        p -= step
        if abs(step) < TINY:
            return p
    raise SystemExit(f"Newton did not converge: {value}")


def sphere(w):
    """The complex latitude on the sphere with the isometric latitude w."""
    return atan(sinh(w))


def geodetic(psi):
    return newton(isometric, isometric_slope, psi, sphere(psi))


def tm(lat, lon):
    w = mpc(isometric(radians(mpf(lat))), radians(mpf(lon)))
    p = newton(isometric, isometric_slope, w, sphere(w))
    point = meridian(p)
    # d(y + ix)/dw = N cos Φ.
    slope = A * cos(p) / sqrt(1 - E2 * sin(p) ** 2)
    phi = radians(mpf(lat))
    scale = abs(slope) / (A * cos(phi) / sqrt(1 - E2 * sin(phi) ** 2))
    return im(point), re(point), -degrees(arg(slope)), scale


def tm_inverse(x, y):
    z = mpc(y, x)
    p = newton(meridian, meridian_slope, z, z / A)
    w = isometric(p)
    return degrees(geodetic(re(w))), degrees(im(w))


POLAR = 2 * A * sqrt((1 + E) ** -(1 + E) * (1 - E) ** -(1 - E))


def polar(lat, lon):
    """About the north pole, with scale 1 there."""
    phi, lam = radians(mpf(lat)), radians(mpf(lon))
    rho = POLAR * exp(-isometric(phi))
    scale = rho * sqrt(1 - E2 * sin(phi) ** 2) / (A * cos(phi))
    return rho * sin(lam), -rho * cos(lam), scale


def polar_inverse(x, y):
    x, y = mpf(x), mpf(y)
    psi = -mp.log(sqrt(x * x + y * y) / POLAR)
    return degrees(geodetic(psi)), degrees(atan2(x, -y))


def q(p):
    s = sin(p)
    return (1 - E2) * (s / (1 - E2 * s * s) + atanh(E * s) / E)


def q_slope(p):
    return (1 - E2) * 2 * cos(p) / (1 - E2 * sin(p) ** 2) ** 2


QP = q(pi / 2)


def laea_constants(lat0):
    phi = radians(mpf(lat0))
    beta = asin(q(phi) / QP)
    radius = A * sqrt(QP / 2)
    pole = abs(lat0) == 90
    d = mpf(1) if pole else A * cos(phi) / (sqrt(1 - E2 * sin(phi) ** 2) * radius * cos(beta))
    return beta, radius, d


def laea(lat0, lon0, lat, lon):
    beta0, radius, d = laea_constants(lat0)
    beta = asin(q(radians(mpf(lat))) / QP)
    lam = radians(mpf(lon) - mpf(lon0))
    b = radius * sqrt(2 / (1 + sin(beta0) * sin(beta) + cos(beta0) * cos(beta) * cos(lam)))
    x = b * d * cos(beta) * sin(lam)
    y = b / d * (cos(beta0) * sin(beta) - sin(beta0) * cos(beta) * cos(lam))
    return x, y


def laea_inverse(lat0, lon0, x, y):
    beta0, radius, d = laea_constants(lat0)
    x, y = mpf(x) / d, mpf(y) * d
    rho = sqrt(x * x + y * y)
    c = 2 * asin(rho / (2 * radius))
    value = QP * (cos(c) * sin(beta0) + y * sin(c) * cos(beta0) / rho)
    phi = newton(q, q_slope, value, asin(value / QP))
    lam = atan2(x * sin(c), rho * cos(beta0) * cos(c) - y * sin(beta0) * sin(c))
    return degrees(phi), degrees(lam) + mpf(lon0)


def write(name, what, columns, rows):
    with open(f"grid_{name}.tsv", "w") as out:
        out.write(f"# {what}; WGS84, f = 1/298.257223563 exactly. Degrees, metres.\n")
        out.write("# Made by make_grid.py (mpmath, 45 working digits); inputs are binary64, 25 digits of truth.\n")
        out.write("\t".join(columns) + "\n")
        for inputs, truth in rows:
            cells = [repr(float(v)) for v in inputs]
            cells += [nstr(v if abs(v) > mpf(10) ** -30 else mpf(0), 25, min_fixed=-30, max_fixed=30) for v in truth]
            out.write("\t".join(cells) + "\n")


def main():
    rng = random.Random(1912)

    def draw(low, high):
        x = rng.uniform(low, high)
        return single(x) if rng.random() < 0.7 else x

    # By the distance from the central meridian, in radii: in a zone, to 35°, and beyond.
    places = [(0.0, 3.0), (84.0, 3.0), (-80.0, -3.0), (45.0, 1e-9), (1e-9, 2.0), (89.9999, 40.0), (0.0, 35.0), (0.0, 52.0), (56.0, -3.0), (72.0, 3.0)]
    places += [(draw(-84, 84), draw(-3.5, 3.5)) for _ in range(60)]
    places += [(draw(-84, 84), draw(-35, 35)) for _ in range(50)]
    places += [(draw(-80, 80), draw(-64, 64)) for _ in range(30)]
    places += [(draw(40, 89.9), draw(-89, 89)) for _ in range(20)]
    write("tm", "Transverse Mercator, scale 1 on the meridian of 0", ("lat", "lon", "x", "y", "convergence", "scale"), [((a, b), tm(a, b)) for a, b in places])
    points = [(x, y) for x in (100000.0, -400000.0, 1.0) for y in (0.0, 5e6, -9e6)]
    points += [(draw(-5e5, 5e5), draw(-9.3e6, 9.3e6)) for _ in range(60)]
    points += [(draw(-3.9e6, 3.9e6), draw(-8e6, 8e6)) for _ in range(40)]
    points += [(draw(-8.5e6, 8.5e6), draw(-5e6, 5e6)) for _ in range(20)]
    write("tm_inverse", "Transverse Mercator, the other way", ("x", "y", "lat", "lon"), [((a, b), tm_inverse(a, b)) for a, b in points])

    places = [(84.0, 0.0), (84.0, 180.0), (89.99999, -45.0), (80.0, 90.0), (70.0, -90.0), (0.0, 10.0), (-60.0, 120.0)]
    places += [(draw(70, 90), draw(-180, 180)) for _ in range(70)]
    places += [(90 - 10 ** draw(-9, 0.5), draw(-180, 180)) for _ in range(20)]
    places += [(draw(-60, 70), draw(-180, 180)) for _ in range(20)]
    write("polar", "Polar stereographic about the north pole, scale 1 there", ("lat", "lon", "x", "y", "scale"), [((a, b), polar(a, b)) for a, b in places])
    points = [(draw(-2e6, 2e6), draw(-2e6, 2e6)) for _ in range(90)] + [(draw(-2e7, 2e7), draw(-2e7, 2e7)) for _ in range(20)]
    write("polar_inverse", "Polar stereographic, the other way", ("x", "y", "lat", "lon"), [((a, b), polar_inverse(a, b)) for a, b in points])

    centres = [(52.0, 10.0), (0.0, 0.0), (90.0, 0.0), (-90.0, 30.0), (-35.5, 149.0), (1e-6, -100.0)]
    pairs = [c + (c[0] - 0.001 if c[0] > 0 else c[0] + 0.001, c[1] + 0.001) for c in centres]
    for _ in range(120):
        c = rng.choice(centres)
        pairs.append(c + (draw(-89, 89), draw(-180, 180)))
    for _ in range(40):
        c = rng.choice(centres)
        lat = single(min(max(c[0] + rng.uniform(-5, 5), -90), 90))
        pairs.append(c + (lat, single(c[1] + rng.uniform(-5, 5))))
    write("laea", "Lambert azimuthal equal-area", ("lat0", "lon0", "lat", "lon", "x", "y"), [(p, laea(*p)) for p in pairs])
    points = [rng.choice(centres) + (draw(-6e6, 6e6), draw(-6e6, 6e6)) for _ in range(80)]
    points += [rng.choice(centres) + (draw(-1e5, 1e5), draw(-1e5, 1e5)) for _ in range(40)]
    write("laea_inverse", "Lambert azimuthal equal-area, the other way", ("lat0", "lon0", "x", "y", "lat", "lon"), [(p, laea_inverse(*p)) for p in points])


main()
