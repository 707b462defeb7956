#!/usr/bin/env python3
"""Makes `latitude.rs`, the series of the auxiliary latitudes: `python3 latitude.py > latitude.rs && rustfmt latitude.rs`.

An auxiliary latitude differs from the geodetic one by a sine series, a = φ + Σ cₖ sin 2kφ, and the same the other way.
cₖ(n) = nᵏ pₖ(n) with the third flattening n (Karney, On auxiliary latitudes, 2022). Here pₖ interpolates cₖ/nᵏ in
Chebyshev nodes over |n| ≤ 1/19 (f = 1/10), which is a little better there than the Taylor polynomial of the same order;
cₖ comes from the defining closed forms by a discrete sine transform with 64 points and 70 digits.

Needs mpmath only.
"""

import struct
from mpmath import mp, mpf, mpc, pi, sqrt, sin, cos, tan, atan, asin, atanh, asinh, sinh, ellipe

mp.dps = 70
ORDER = {"f64": 16, "f32": 8}
LIMIT = mpf(1) / 19 * mpf("1.0001")
POINTS = 64


def closed_forms(n):
    """Auxiliary latitudes of the geodetic latitude, each with its derivative."""
    f = 2 * n / (1 + n)
    e2 = f * (2 - f)
    e = sqrt(mpc(e2))

    def atanh_term(s):  # e atanh(e s), real for either sign of e²
        return (e * atanh(e * s)).real

    def q(s):
        return s / (1 - e2 * s * s) + atanh_term(s) / e2

    def authalic(p):
        return asin(q(sin(p)) / q(mpf(1)))

    def authalic_slope(p):
        w = 1 - e2 * sin(p) ** 2
        return 2 * cos(p) / (w * w * q(mpf(1)) * sqrt(1 - (q(sin(p)) / q(mpf(1))) ** 2))

    def conformal(p):
        return atan(sinh(asinh(tan(p)) - atanh_term(sin(p))))

    def conformal_slope(p):
        return cos(conformal(p)) * (1 - e2) / ((1 - e2 * sin(p) ** 2) * cos(p))

    quadrant = ellipe(e2)

    def rectifying(p):
        return pi / 2 * (ellipe(p, e2) - e2 * sin(p) * cos(p) / sqrt(1 - e2 * sin(p) ** 2)) / quadrant

    def rectifying_slope(p):
        return pi / 2 * (1 - e2) / (sqrt(1 - e2 * sin(p) ** 2) ** 3 * quadrant)

    return {
        "AUTHALIC": (authalic, authalic_slope),
        "CONFORMAL": (conformal, conformal_slope),
        "RECTIFYING": (rectifying, rectifying_slope),
    }


def inverse(g, slope, value):
    p = value
    for _ in range(60):
        step = (g(p) - value) / slope(p)
        p -= step
        if abs(step) < mpf(10) ** -66:
            return p
    raise SystemExit("Newton did not converge")


def sine_coefficients(n, order):
    """{name: [c₁ … c_order]} at one n, and for the inverses."""
    found = {}
    for name, (g, slope) in closed_forms(n).items():
        xs = [pi / 2 * j / POINTS for j in range(1, POINTS)]
        for suffix, values in (("", [g(x) - x for x in xs]), ("_INVERSE", [inverse(g, slope, x) - x for x in xs])):
            found[name + suffix] = [
                sum(v * sin(2 * k * x) for v, x in zip(values, xs)) * 2 / POINTS for k in range(1, order + 1)
            ]
    return found


def main():
    order = ORDER["f64"]
    # Nodes for every degree 0 … order − 1; none is zero.
    tables = {s: {} for s in ORDER}
    cache = {}

    def at(n):
        if n not in cache:
            cache[n] = sine_coefficients(n, order)
        return cache[n]

    # One set of nodes serves all: least squares in Chebyshev nodes is the truncated Chebyshev series.
    count = 20
    nodes = [LIMIT * cos(pi * (2 * j + 1) / (2 * count)) for j in range(count)]
    names = list(at(nodes[0]))
    for scalar, top in ORDER.items():
        for name in names:
            rows = []
            for k in range(1, top + 1):
                degree = top - k
                values = [at(n)[name][k - 1] / n**k for n in nodes]
                cheb = [
                    sum(v * cos(pi * j * (2 * i + 1) / (2 * count)) for i, v in enumerate(values)) * (1 if j == 0 else 2) / count
                    for j in range(degree + 1)
                ]
                rows.append(powers(cheb))
            tables[scalar][name] = [c for row in rows for c in row]
    print("//! Made by `latitude.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    print(f"/// Terms of each series, for `f64` and `f32`.")
    print(f"pub(crate) const ORDER: (usize, usize) = ({ORDER['f64']}, {ORDER['f32']});\n")
    for name in names:
        sizes = [len(tables[s][name]) for s in ORDER]
        words = name.lower().replace("_inverse", " to geodetic") if "INV" in name else "geodetic to " + name.lower()
        print(f"/// {words}: the polynomials p₁, p₂, … one after the other, lowest power first.")
        print(f"pub(crate) const {name}: Polynomial<{sizes[0]}, {sizes[1]}> = Polynomial {{")
        for scalar in ORDER:
            print(f"    {scalar}: [{', '.join(literal(c, scalar) for c in tables[scalar][name])}],")
        print("};\n")


def powers(cheb, limit=None):
    """Chebyshev coefficients in n / limit, LIMIT if none is given, to powers of n."""
    limit = limit or LIMIT
    total = [mpf(0)] * len(cheb)
    t0, t1 = [mpf(1)], [mpf(0), 1 / limit]
    for c in cheb:
        for k, v in enumerate(t0):
            total[k] += c * v
        t2 = [mpf(0)] + [2 / limit * v for v in t1]
        for k, v in enumerate(t0):
            t2[k] -= v
        t0, t1 = t1, t2
    return total


def literal(value, scalar):
    if abs(value) < mpf(10) ** -20:
        return "0.0"
    if scalar == "f64":
        return repr(float(value))
    single = struct.unpack("f", struct.pack("f", float(value)))[0]
    return next(t for t in (f"{single:.{d}e}" for d in range(5, 10)) if struct.unpack("f", struct.pack("f", float(t)))[0] == single)


if __name__ == "__main__":
    main()
