#!/usr/bin/env python3
"""Makes `conformal.rs`, the series of the conformal cube: `python3 conformal.py > conformal.rs && rustfmt conformal.rs`.

Rančić, Purser & Mesinger (1996): with W = w³ about a corner of the cube (neighbouring corners at W = 1, the next at −8),
z = I⁻¹ w^¾ S(W), S(W) = Σ aₙWⁿ/(1 + 4n), Σ aₙWⁿ = [(1 − W)(1 + W/8)]^(−¼). Folding to the nearest corner leaves
|W| ≤ 0.3924 and |z⁴| ≤ ¼. The inverse is w = z^(4/3) B(z⁴); B is the reverted series.

About the face's centre, x + iy = C ζ Σ dₙ ζ⁴ⁿ/(1 + 4n), Σ dₙ sⁿ = (1 + 14s + s²)^(−¼), with ζ the stereographic coordinate there
and C such that the edge's midpoint, ζ = tan 22.5°, is at 1.

Needs mpmath only.
"""

import struct
from mpmath import mp, mpf, beta, cos, hyp2f1, pi, quad, sqrt

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
    slope = power([mpf(1), mpf(14), mpf(1)] + [mpf(0)] * (LENGTH - 3), -mpf(1) / 4)
    edge = sqrt(mpf(2)) - 1
    centre = 1 / quad(lambda t: (1 + 14 * t**4 + t**8) ** (-mpf(1) / 4), [0, edge])
    d = [centre * c / (1 + 4 * n) for n, c in enumerate(slope)]
    # ζ⁴ = s, Z⁴ = s (Σ …)⁴: revert in the fourth powers, then take the fourth root.
    e = power(reverted(power(d, mpf(4))), mpf(1) / 4)
    print("//! Made by `conformal.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    print("/// √3·(2 cos 22.5°/I)^(4/3), the scale toward the plane.")
    scale = (2 * cos(pi / 8) / i) ** (mpf(4) / 3)
    print(f"pub(crate) const TO_PLANE_SCALE: f64 = {float(sqrt(mpf(3)) * scale)!r};\n")
    print("/// (2 cos 22.5°/I)^(−4/3).")
    print(f"pub(crate) const TO_PLANE_UNSCALE: f64 = {float(1 / scale)!r};\n")
    print("/// I⁴ = B(0)³, the scale toward the sphere.")
    print(f"pub(crate) const TO_SPHERE_SCALE: f64 = {float(i**4)!r};\n")
    for name, text, series, radius in (
        ("TO_PLANE", "(S(W) − 1)/W, |W| ≤ 0.3924", s[1:], mpf("0.3924")),
        ("CENTRE_TO_PLANE", "(x + iy)/ζ in s = ζ⁴, |ζ|² ≤ 0.02", d, mpf("0.0004")),
        ("CENTRE_TO_SPHERE", "ζ/(x + iy) in (x + iy)⁴, |x + iy|² ≤ 0.14", e, mpf("0.14") ** 2),
        ("TO_SPHERE", "(B(Z)/B(0) − 1)/Z, |Z| ≤ ¼", [c / b[0] for c in b[1:]], mpf(1) / 4),
    ):
        counts = {"f64": enough(series, radius, mpf(2) ** -58), "f32": enough(series, radius, mpf(2) ** -28)}
        print(f"/// {text}.")
        print(f"pub(crate) const {name}: Polynomial<{counts['f64']}, {counts['f32']}> = Polynomial {{")
        for scalar, count in counts.items():
            print(f"    {scalar}: [{', '.join(literal(c, scalar) for c in series[:count])}],")
        print("};\n")


main()
