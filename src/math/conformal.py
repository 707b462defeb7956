#!/usr/bin/env python3
"""Makes `conformal.rs`, the series of the conformal cube: `python3 conformal.py > conformal.rs && rustfmt conformal.rs`.

Rančić, Purser & Mesinger (1996): with W = w³ about a corner of the cube (neighbouring corners at W = 1, the next at −8),
z = I⁻¹ w^¾ S(W), S(W) = Σ aₙWⁿ/(1 + 4n), Σ aₙWⁿ = [(1 − W)(1 + W/8)]^(−¼). Folding to the nearest corner leaves
|W| ≤ 0.3924 and |z⁴| ≤ ¼. The inverse is w = z^(4/3) B(z⁴); B is the reverted series.

Needs mpmath only.
"""

import struct
from mpmath import mp, mpf, beta, hyp2f1

mp.dps = 60
LENGTH = 80


def power(p, exponent):
    """p^exponent of a series with p[0] > 0 (Euler's recurrence)."""
    r = [p[0] ** exponent]
    for n in range(1, LENGTH):
        r.append(sum((exponent * k - n + k) * p[k] * r[n - k] for k in range(1, n + 1)) / (n * p[0]))
    return r


def reverted(p):
    """Q with Q(Z) the solution W of Z = W p(W), as W = Z Q(Z), by Lagrange's formula."""
    q = []
    for n in range(1, LENGTH + 1):
        q.append(power(p, mpf(-n))[n - 1] / n)
    return q


def enough(series, radius, bound):
    return max(n for n, c in enumerate(series[:-1]) if abs(c) * radius**n > bound) + 1


def literal(value, scalar):
    if scalar == "f64":
        return repr(float(value))
    single = struct.unpack("f", struct.pack("f", float(value)))[0]
    return next(t for t in (f"{single:.{d}e}" for d in range(5, 10)) if struct.unpack("f", struct.pack("f", float(t)))[0] == single)


def main():
    derivative = power([mpf(1), mpf(1) / 8 - 1, -mpf(1) / 8] + [mpf(0)] * (LENGTH - 3), -mpf(1) / 4)
    s = [c / (1 + 4 * n) for n, c in enumerate(derivative)]
    # z(1) = 1: I = ¼ ∫₀¹ W^(−¾) [(1 − W)(1 + W/8)]^(−¼) dW, Euler's integral of a hypergeometric function.
    quarter = mpf(1) / 4
    i = quarter * beta(quarter, 1 - quarter) * hyp2f1(quarter, quarter, 1, -mpf(1) / 8)
    z_of_w = [i**-4 * c for c in power(s, mpf(4))]
    b = power(reverted(z_of_w), mpf(1) / 3)
    print("//! Made by `conformal.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    print(f"/// 1/I: the face's coordinate is z = w^¾ S(w³)/I.")
    print(f"pub(crate) const INVERSE_I: f64 = {float(1 / i)!r};\n")
    for name, text, series, radius in (
        ("CONFORMAL_TO_PLANE", "S(W), |W| ≤ 0.3924", s, mpf("0.3924")),
        ("CONFORMAL_TO_SPHERE", "B(Z), |Z| ≤ ¼", b, mpf(1) / 4),
    ):
        counts = {"f64": enough(series, radius, mpf(2) ** -57), "f32": enough(series, radius, mpf(2) ** -28)}
        print(f"/// {text}.")
        print(f"pub(crate) const {name}: Polynomial<{counts['f64']}, {counts['f32']}> = Polynomial {{")
        for scalar, count in counts.items():
            print(f"    {scalar}: [{', '.join(literal(c, scalar) for c in series[:count])}],")
        print("};\n")


main()
