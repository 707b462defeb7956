#!/usr/bin/env python3
"""Makes `kruger.rs`, Krüger's series: `python3 kruger.py | rustfmt --edition 2024 --config-path . > kruger.rs`.

The rectifying latitude of the conformal one is μ = χ + Σ αⱼ sin 2jχ, and the other way χ = μ − Σ βⱼ sin 2jμ (Krüger,
Konforme Abbildung des Erdellipsoids in der Ebene, 1912; Karney, Transverse Mercator with an accuracy of a few nanometers,
J. Geodesy 85, 2011, eqs. 11 and 25). With complex χ they lead to the transverse Mercator projection, and back.
αⱼ(n) = nʲ pⱼ(n) with the third flattening n; pⱼ has degree ORDER − j. Here it interpolates αⱼ/nʲ in Chebyshev nodes over
|n| ≤ 1/119 (f = 1/60), which is a little better there than the Taylor polynomial of the same degree; αⱼ comes from the
closed forms of both latitudes by a discrete sine transform with 40 points and 60 digits.

`RECTIFYING_RADIUS` is the same of a (1 + n)/(quarter of a meridian/(π/2)), by powers of n².

Needs mpmath only.
"""

from mpmath import mp, mpf, mpc, pi, sqrt, sin, cos, tan, atan, asinh, atanh, sinh, ellipe
from latitude import literal, powers

mp.dps = 60
ORDER = {"f64": 8, "f32": 4}
RADIUS = {"f64": 4, "f32": 2}
LIMIT = mpf(1) / 119 * mpf("1.0001")
POINTS = 40
NODES = 16


def latitudes(n):
    """The conformal and the rectifying latitude of the geodetic one, and dμ/dφ, dχ/dφ."""
    f = 2 * n / (1 + n)
    e2 = f * (2 - f)
    e = sqrt(mpc(e2))
    quadrant = ellipe(e2)

    def conformal(p):
        return atan(sinh(asinh(tan(p)) - (e * atanh(e * sin(p))).real))

    def conformal_slope(p):
        return cos(conformal(p)) * (1 - e2) / ((1 - e2 * sin(p) ** 2) * cos(p))

    def rectifying(p):
        return pi / 2 * (ellipe(p, e2) - e2 * sin(p) * cos(p) / sqrt(1 - e2 * sin(p) ** 2)) / quadrant

    def rectifying_slope(p):
        return pi / 2 * (1 - e2) / (sqrt(1 - e2 * sin(p) ** 2) ** 3 * quadrant)

    return (conformal, conformal_slope), (rectifying, rectifying_slope)


def inverse(g, slope, value):
    p = value
    for _ in range(60):
        step = (g(p) - value) / slope(p)
        p -= step
        if abs(step) < mpf(10) ** -56:
            return p
    raise SystemExit("Newton did not converge")


def sine_coefficients(n):
    """[α₁ …], [β₁ …] at one n."""
    conformal, rectifying = latitudes(n)
    xs = [pi / 2 * j / POINTS for j in range(1, POINTS)]

    def series(start, end):
        values = [end[0](inverse(*start, x)) - x for x in xs]
        return [sum(v * sin(2 * k * x) for v, x in zip(values, xs)) * 2 / POINTS for k in range(1, ORDER["f64"] + 1)]

    return series(conformal, rectifying), [-c for c in series(rectifying, conformal)]


def chebyshev(values, degree, limit, nodes):
    """The polynomial of a degree through values at Chebyshev nodes of ±limit, by powers."""
    count = len(nodes)
    return powers([
        sum(v * cos(pi * j * (2 * i + 1) / (2 * count)) for i, v in enumerate(values)) * (1 if j == 0 else 2) / count
        for j in range(degree + 1)
    ], limit)


def table(name, words, columns):
    sizes = [len(columns[s]) for s in ORDER]
    print(f"/// {words}")
    print(f"pub(crate) const {name}: Polynomial<{sizes[0]}, {sizes[1]}> = Polynomial {{")
    for scalar in ORDER:
        print(f"    {scalar}: [{', '.join(literal(c, scalar) for c in columns[scalar])}],")
    print("};\n")


def main():
    nodes = [LIMIT * cos(pi * (2 * j + 1) / (2 * NODES)) for j in range(NODES)]
    found = [sine_coefficients(n) for n in nodes]
    print("//! Made by `kruger.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    print("/// Terms of each series, for `f64` and `f32`.")
    print(f"pub(crate) const ORDER: (usize, usize) = ({ORDER['f64']}, {ORDER['f32']});\n")
    for which, (name, words) in enumerate((("FORWARD", "α, conformal to rectifying"), ("INVERSE", "β, rectifying to conformal"))):
        columns = {
            scalar: [
                c
                for k in range(1, top + 1)
                for c in chebyshev([f[which][k - 1] / n**k for f, n in zip(found, nodes)], top - k, LIMIT, nodes)
            ]
            for scalar, top in ORDER.items()
        }
        table(name, f"{words}: the polynomials p₁, p₂, … one after the other, lowest power first.", columns)
    square = LIMIT**2
    points = [square * cos(pi * (2 * j + 1) / (2 * NODES)) for j in range(NODES)]

    def radius(q):
        # E(e²) 2/π (1 + n) is even in n: at n² = q < 0 by an imaginary n.
        n = sqrt(mpc(q))
        return (ellipe(4 * n / (1 + n) ** 2) * 2 / pi * (1 + n)).real

    columns = {s: chebyshev([radius(q) for q in points], degree, square, points) for s, degree in RADIUS.items()}
    table("RECTIFYING_RADIUS", "(1 + n) A/a, by powers of n².", columns)


main()
