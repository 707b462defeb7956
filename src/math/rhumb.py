#!/usr/bin/env python3
"""Makes `rhumb.rs`, the series of the area under a rhumb line: `python3 rhumb.py > rhumb.rs && rustfmt rhumb.rs`.

The mean of sin ξ over the isometric latitude ψ is the area under a rhumb line (Karney, The area of rhumb polygons, 2024,
section 4; ξ is the authalic latitude). With the conformal latitude χ, ∫ sin χ dψ = −ln cos χ, and what is left is smooth:
∫ (sin ξ − sin χ) dψ = Σ Rₖ cos 2kφ in the geodetic latitude φ. Rₖ(n) = nᵏ pₖ(n), and the polynomials are found as those of
`latitude.py` are.

Needs mpmath only.
"""

from mpmath import cos, mpf, pi, sin
from latitude import LIMIT, ORDER, POINTS, closed_forms, literal, powers

COUNT = 20


def coefficients(n, order):
    """[R₁ … R_order] at one n: g sin-transformed, and integrated."""
    f = 2 * n / (1 + n)
    e2 = f * (2 - f)
    forms = closed_forms(n)
    authalic, conformal = forms["AUTHALIC"][0], forms["CONFORMAL"][0]

    def g(p):
        return (sin(authalic(p)) - sin(conformal(p))) * (1 - e2) / ((1 - e2 * sin(p) ** 2) * cos(p))

    xs = [pi / 2 * j / POINTS for j in range(1, POINTS)]
    values = [g(x) for x in xs]
    sines = [sum(v * sin(2 * k * x) for v, x in zip(values, xs)) * 2 / POINTS for k in range(1, order + 1)]
    return [-c / (2 * k) for k, c in enumerate(sines, 1)]


def main():
    nodes = [LIMIT * cos(pi * (2 * j + 1) / (2 * COUNT)) for j in range(COUNT)]
    found = [coefficients(n, ORDER["f64"]) for n in nodes]
    tables = {}
    for scalar, top in ORDER.items():
        table = tables[scalar] = []
        for k in range(1, top + 1):
            values = [row[k - 1] / n**k for n, row in zip(nodes, found)]
            cheb = [
                sum(v * cos(pi * j * (2 * i + 1) / (2 * COUNT)) for i, v in enumerate(values)) * (1 if j == 0 else 2) / COUNT
                for j in range(top - k + 1)
            ]
            table += powers(cheb)
    print("//! Made by `rhumb.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    print("/// ∫ (sin ξ − sin χ) dψ by cosines: the polynomials p₁, p₂, … one after the other, lowest power first.")
    print(f"pub(crate) const AREA: Polynomial<{len(tables['f64'])}, {len(tables['f32'])}> = Polynomial {{")
    for scalar, table in tables.items():
        print(f"    {scalar}: [{', '.join(literal(mpf(c), scalar) for c in table)}],")
    print("};")


main()
