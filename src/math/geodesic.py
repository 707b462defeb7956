#!/usr/bin/env python3
"""Makes `geodesic.rs`, the series of the geodesic integrals: `python3 geodesic.py > geodesic.rs && rustfmt geodesic.rs`.

Karney, Algorithms for geodesics (2013), to higher order than printed there. With z = e^(2iσ),
q = √((1 − εz)(1 − ε/z)), everything is a power series in ε and the third flattening n with Laurent polynomials in z:

    I₁ = ∫ √(1 + k² sin²σ) dσ = ∫ q dσ/(1 − ε)                     (his 7, 15)
    I₂ = ∫ dσ/√(1 + k² sin²σ) = ∫ (1 − ε) dσ/q                     (his 41)
    I₃ = ∫ (2 − f) dσ/(1 + (1 − f)√(1 + k² sin²σ))
       = ∫ 2(1 − ε) dσ/((1 + n)(1 − ε) + (1 − n)q)                 (his 8, 23)
    I₄ = −∫ (t(e'²) − t(k² sin²σ))/(e'² − k² sin²σ) ½ sin σ dσ      (his 60)

Exact rational arithmetic, the standard library only.
"""

import struct
from fractions import Fraction as F

ORDER = {"f64": 12, "f32": 6}
TOP = max(ORDER.values())


class Series:
    """{(power of ε, power of n): {power of z: coefficient}}, to total order TOP."""

    def __init__(self, terms=None):
        self.terms = terms or {}

    @staticmethod
    def of(value):
        return Series({(0, 0): {0: F(value)}})

    def __add__(self, other):
        sum_ = {key: dict(modes) for key, modes in self.terms.items()}
        for key, modes in other.terms.items():
            mine = sum_.setdefault(key, {})
            for m, c in modes.items():
                mine[m] = mine.get(m, 0) + c
        return Series(sum_)

    def times(self, factor):
        return Series({key: {m: c * factor for m, c in modes.items()} for key, modes in self.terms.items()})

    def __mul__(self, other):
        product = {}
        for (i, j), modes in self.terms.items():
            for (k, l), others in other.terms.items():
                if i + k + j + l <= TOP:
                    mine = product.setdefault((i + k, j + l), {})
                    for m, c in modes.items():
                        for n, d in others.items():
                            mine[m + n] = mine.get(m + n, 0) + c * d
        return Series(product)

    def power(self, exponent):
        """(1 + small)^exponent by the binomial series."""
        small = self + Series.of(-1)
        total, term = Series.of(1), Series.of(1)
        for k in range(1, TOP + 1):
            term = (term * small).times((F(exponent) - k + 1) / k)
            total = total + term
        return total

    def mode(self, m):
        """{(i, j): coefficient of z^m}."""
        return {key: modes[m] for key, modes in self.terms.items() if modes.get(m)}


def binomial(exponent, k):
    c = F(1)
    for i in range(k):
        c *= (F(exponent) - i) / (i + 1)
    return c


EPS = Series({(1, 0): {0: F(1)}})
N = Series({(0, 1): {0: F(1)}})
ONE = Series.of(1)


def q_to(exponent):
    """q^(2·exponent) = ((1 − εz)(1 − ε/z))^exponent."""
    def half(sign):
        return Series({(k, 0): {sign * k: binomial(exponent, k) * (-1) ** k} for k in range(TOP + 1)})

    return half(1) * half(-1)


def in_eps(series, m):
    """Coefficients of z^m by power of ε, of a series without n."""
    found = series.mode(m)
    return [found.get((i, 0), F(0)) for i in range(TOP + 1)]


def quotient(p, d):
    """p/d of power series in ε."""
    r = []
    for i in range(TOP + 1):
        r.append((p[i] - sum(r[k] * d[i - k] for k in range(i))) / d[0])
    return r


def reversion(c):
    """C'ₗ with σ = τ + Σ C'ₗ sin 2lτ for τ = σ + Σ Cₗ sin 2lσ, by Lagrange: −h, +(h²)'/2, −(h³)''/6, …"""
    # sin 2lσ = (z^l − z^−l)/2i: keep h·i, so that all coefficients are real; d/dσ brings 2i·m.
    h = Series({})
    for l, powers in c.items():
        for i, value in enumerate(powers):
            if value:
                h = h + Series({(i, 0): {l: value / 2, -l: -value / 2}})
    total = {}
    product, factorial = Series.of(1), 1
    for k in range(1, TOP + 1):
        product = product * h
        factorial *= k
        # hᵏ is product/iᵏ; k − 1 derivatives multiply by (2im)^(k−1); the sign is (−1)ᵏ. Then i·(…) is what a sine needs.
        for key, modes in product.terms.items():
            for m, value in modes.items():
                if m > 0 and value:
                    term = F((-1) ** k) * value * (2 * m) ** (k - 1) / factorial
                    total.setdefault(m, [F(0)] * (TOP + 1))[key[0]] += 2 * term
    return total


def divided_difference():
    """(t(a) − t(b))/(a − b), a = e'² = 4n/(1 − n)², b = k² sin²σ, t(x) = x + √(1 + 1/x) asinh √x."""
    asinh, c = [], F(1)
    for m in range(TOP + 3):
        asinh.append(c / (2 * m + 1))
        c *= -F(2 * m + 1, 2 * m + 2)
    t = [sum(asinh[k] * binomial(F(1, 2), m - k) for k in range(m + 1)) for m in range(TOP + 3)]
    t[1] += 1
    minus = lambda s: (ONE + s.times(-1)).power(-2)
    a = (N * minus(N)).times(4)
    sine2 = Series({(0, 0): {0: F(1, 2), 1: -F(1, 4), -1: -F(1, 4)}})
    b = (EPS * minus(EPS)).times(4) * sine2
    a_powers, b_powers = [ONE], [ONE]
    for _ in range(TOP):
        a_powers.append(a_powers[-1] * a)
        b_powers.append(b_powers[-1] * b)
    total = Series({})
    for m in range(1, TOP + 2):
        for i in range(m):
            if m - 1 - i <= TOP and i <= TOP and m - 1 <= TOP:
                total = total + (a_powers[i] * b_powers[m - 1 - i]).times(t[m])
    return total


def tables():
    i1, i2 = q_to(F(1, 2)), q_to(-F(1, 2))
    one = {}
    for name, series in (("1", i1), ("2", i2)):
        mean = in_eps(series, 0)
        one["A" + name] = mean
        # ∫ (g₀ + 2Σ gₗ cos 2lσ) = g₀(σ + Σ gₗ/(l g₀) sin 2lσ)
        one["C" + name] = {l: [v / l for v in quotient(in_eps(series, l), mean)] for l in range(1, TOP + 1)}
    one["C1P"] = reversion(one["C1"])
    denominator = ((ONE + N) * (ONE + EPS.times(-1)) + (ONE + N.times(-1)) * i1).times(F(1, 2))
    i3 = (ONE + EPS.times(-1)) * denominator.power(-1)
    two = {"A3": [i3.mode(0)], "C3": [{k: v / l for k, v in i3.mode(l).items()} for l in range(1, TOP)]}
    # ½ sin σ · g(2σ): the coefficient of sin((2l + 1)σ) is (gₗ − gₗ₊₁)/2; −∫ gives cos((2l + 1)σ)/(2l + 1).
    g = divided_difference()
    c4 = []
    for l in range(TOP):
        low, high = g.mode(l), g.mode(l + 1)
        keys = set(low) | set(high)
        c4.append({k: (low.get(k, F(0)) - high.get(k, F(0))) / (2 * (2 * l + 1)) for k in keys})
    two["C4"] = c4
    return one, two


def flat(one, two, order):
    """The tables in the order in which the crate reads them."""
    made = {}
    # A: powers of ε² from the zeroth; of C row l: ε^l times powers of ε².
    for name in ("A1", "A2"):
        made[name] = [one[name][i] for i in range(0, order + 1, 2)]
    for name in ("C1", "C1P", "C2"):
        made[name] = [one[name][l][i] for l in range(1, order + 1) for i in range(l, order + 1, 2)]
    # For each power j of ε below the order the powers of n, to total order − 1; of row l from ε^l on.
    rows = lambda modes, j: [modes.get((j, k), F(0)) for k in range(order - j)]
    made["A3"] = [c for j in range(order) for c in rows(two["A3"][0], j)]
    made["C3"] = [c for l in range(1, order) for j in range(l, order) for c in rows(two["C3"][l - 1], j)]
    made["C4"] = [c for l in range(order) for j in range(l, order) for c in rows(two["C4"][l], j)]
    return made


def literal(value, scalar):
    number = value.numerator / value.denominator
    if scalar == "f64":
        return repr(number)
    single = struct.unpack("f", struct.pack("f", number))[0]
    return next(t for t in (f"{single:.{d}e}" for d in range(5, 10)) if struct.unpack("f", struct.pack("f", float(t)))[0] == single)


TEXT = {
    "A1": "(1 − ε)A₁ in powers of ε²",
    "C1": "C₁ₗ/ε^l in powers of ε², l = 1, 2, …: I₁ = A₁(σ + Σ C₁ₗ sin 2lσ)",
    "C1P": "C′₁ₗ/ε^l, the reversion of C₁",
    "A2": "A₂/(1 − ε) in powers of ε²",
    "C2": "C₂ₗ/ε^l: I₂ = A₂(σ + Σ C₂ₗ sin 2lσ)",
    "A3": "A₃: for each power of ε the powers of n",
    "C3": "A₃C₃ₗ/ε^l, l = 1, 2, …: I₃ = A₃σ + Σ A₃C₃ₗ sin 2lσ; for each power of ε the powers of n",
    "C4": "C₄ₗ/ε^l, l = 0, 1, …: I₄ = Σ C₄ₗ cos (2l + 1)σ",
}


def main():
    one, two = tables()
    made = {scalar: flat(one, two, order) for scalar, order in ORDER.items()}
    print("//! Made by `geodesic.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    print("/// The order of the series, for `f64` and `f32`.")
    print(f"pub(crate) const ORDER: (usize, usize) = ({ORDER['f64']}, {ORDER['f32']});\n")
    for name, text in TEXT.items():
        sizes = [len(made[s][name]) for s in ORDER]
        print(f"/// {text}.")
        print(f"pub(crate) const {name}: Polynomial<{sizes[0]}, {sizes[1]}> = Polynomial {{")
        for scalar in ORDER:
            print(f"    {scalar}: [{', '.join(literal(c, scalar) for c in made[scalar][name])}],")
        print("};\n")


main()
