#!/usr/bin/env python3
"""Makes `minimax.rs`, the polynomials of the kernels: `python3 minimax.py > minimax.rs && rustfmt minimax.rs`.

Each entry is a smooth function g on an interval. Remez exchange finds the polynomial whose weighted error
|w (g - p)| has the smallest maximum; the degree is the smallest that stays under the bound of the scalar.
Coefficients are rounded to the scalar at the end: every kernel adds its polynomial as a correction to a
leading term, so that this rounding stays far below half an ulp of the result.

Needs mpmath only.
"""

from mpmath import mp, mpf, mpc, pi, sqrt, sin, cos, tan, asin, atan, atanh, exp, log, factorial, fdot, matrix, lu_solve, chebyt
import struct

mp.dps = 60
BOUND = {"f64": mpf(2) ** -58, "f32": mpf(2) ** -28.5}


def odd_correction(f):
    """g with f(x) = x + x z g(z), z = x²."""
    return lambda z: (f(sqrt(z)) / sqrt(z) - 1) / z


def odd_unit(f):
    """g with f(x) = x - x (1 - z) g(z), z = x², for an odd f with f(1) = 1."""
    return lambda z: (1 - f(sqrt(z)) / sqrt(z)) / (1 - z)


def unit(f):
    """g with f(x) = x + x (1 - x) g(x), for f(0) = 0 and f(1) = 1."""
    return lambda x: (f(x) / x - 1) / (1 - x)


def quad_m(w):
    return 12 / pi * mp.asin(w * sin(pi / 12))


# In a corner of the quadrilateralized cube, √2·sin 15° = √2·cos 15° − 1.
QUAD_CORNER = (sqrt(mpf(3)) - 1) / 2


def quad_sin(m):
    return sqrt(mpf(2)) * sin(pi * m / 12)


def quad_cos(m):
    return sqrt(mpf(2)) * cos(pi * m / 12) - 1


# Vertex equal-area: tau = tan(xi/2) / tan(pi/8) against the share t of the triangle's area.
K = (sqrt(mpf(3)) - 1) / sqrt(mpf(2))
TAN_PI_8 = sqrt(mpf(2)) - 1


def vertex_tau(t):
    T = tan(pi * t / 24)
    return sqrt(mpf(2)) * T / (K * (1 - T)) / TAN_PI_8


def vertex_t(tau):
    half = tau * TAN_PI_8
    return 24 / pi * atan(K * half / (sqrt(mpf(2)) + K * half))


# Conformal: a power of a complex number of unit real part, in real and imaginary parts. Toward the plane it is turned by
# 22.5° and scaled so that its real part is 1 at k = 0.
def conformal_power(k):
    k = mpc(1, k / sqrt(mpf(3)))
    return exp(mpc(0, pi / 8)) / cos(pi / 8) * k ** (mpf(3) / 4)


def conformal_root(t):
    return mpc(1, t) ** (mpf(4) / 3)


# Cube maps by a function of each coordinate.
def tangent_pair(theta):
    return lambda u: atan(u * tan(theta)) / theta, lambda x: tan(theta * x) / tan(theta)


TANGENTS = [
    ("ADJUSTED", "π/4: the adjusted cube", pi / 4),
    ("EQUI_EDGE", "atan √½: equal edges", atan(sqrt(mpf(1) / 2))),
    ("SEPARABLE", "acos 2^(−5/12): the separable map", mp.acos(mpf(2) ** (-mpf(5) / 12))),
    ("ZUCKER_HIGASHI", "0.868734829276: Zucker & Higashi's tangent", mpf("0.868734829276")),
    ("LAMBERS", "atan 1.1968: Lambers' tangent", atan(mpf("1.1968"))),
]
TANH_C = mpf("0.9721")


def unicube(x):
    s = sin(pi * x / 6)
    return s / sqrt(mpf(1) / 2 - s * s)


# The creaseless cube: see src/cube/projection/creaseless.rs. Its one function w(x) solves a differential equation of
# the first order, by collocation: w = x·Σ cₖTₖ(2x² − 1) with w(1) = 1.
class Creaseless:
    def __init__(self, degree=44):
        n = degree
        h = mpf(10) ** (-mp.dps // 2)
        squares = [(1 - cos(pi * (2 * j + 1) / (2 * n))) / 2 for j in range(n)]
        rows = [(sqrt(z), z, *self.basis(n, z)) for z in squares]
        first, third = sqrt(pi / 6), mpf("0.0484")
        c = matrix([(1 + first) / 2 - third / 8, (1 - first) / 2, third / 8] + [0] * (n - 2))
        for _ in range(20):
            a, b = matrix(n + 1, n + 1), matrix(n + 1, 1)
            for j, (x, z, t, dt) in enumerate(rows):
                value, slope = fdot(c, t), fdot(c, dt)
                w, dw = x * value, value + 2 * z * slope
                rest = self.residual(x, w, dw)
                by_w = (self.residual(x, w + h, dw) - rest) / h
                by_dw = (self.residual(x, w, dw + h) - rest) / h
                b[j] = -rest
                for k in range(n + 1):
                    a[j, k] = by_w * x * t[k] + by_dw * (t[k] + 2 * z * dt[k])
            for k in range(n + 1):
                a[n, k] = 1
            b[n] = 1 - sum(c)
            change = lu_solve(a, b)
            c += change
            if max(abs(v) for v in change) < mpf(10) ** (15 - mp.dps):
                break
        self.c = list(c)

    @staticmethod
    def basis(n, z):
        """Chebyshev's polynomials of 2z − 1, and their derivatives by z."""
        s = 2 * z - 1
        t, dt = [mpf(1), s], [mpf(0), mpf(2)]
        for _ in range(n - 1):
            dt.append(4 * t[-1] + 2 * s * dt[-1] - dt[-2])
            t.append(2 * s * t[-1] - t[-2])
        return t, dt

    @staticmethod
    def excess(x, w):
        """The area of the triangle (0, 0), (w, 0), (w, w) of the sphere, less that of (0, 0), (x, 0), (x, x)."""
        return pi / 4 - asin(1 / sqrt(2 * (1 + w * w))) - pi / 12 * x * x

    def residual(self, x, w, dw):
        """The slope of a curve at the diagonal, as its area demands, less the slope without a crease."""
        q = 1 + 2 * w * w
        along = q ** mpf("1.5") * pi / 6
        r = (dw * dw - along) / (dw * dw + along)
        bend = (1 + w * w) * (1 + w * w * (1 - r)) / q ** mpf("1.5")
        return (3 * self.excess(x, w) * q / (w * w) * bend - r) / (x * x)

    def diagonal(self, z):
        """w/x and dw/dx at x² = z."""
        t, dt = self.basis(len(self.c) - 1, z)
        value = fdot(self.c, t)
        return value, value + 2 * z * fdot(self.c, dt)

    def stretch(self, z):
        return self.diagonal(z)[0]

    def bow(self, z):
        """κ/(x(1 − x²)w²): how far in longitude a curve's end is from its middle."""
        x = sqrt(z)
        w = x * self.stretch(z)
        return mpf(3) / 2 * self.excess(x, w) * sqrt(1 + 2 * w * w) / w**3 / (x * (1 - z))

    def cubic(self, z):
        """τ/x²."""
        x = sqrt(z)
        value, dw = self.diagonal(z)
        w = x * value
        q = 1 + 2 * w * w
        area = (w / sqrt(q) * dw / (1 + w * w) - pi / 6 * x) / 2
        return 6 / pi * (area - mpf(3) / 2 * self.excess(x, w) * dw / (w * q)) / (x * z)


def less_one(f):
    """(f(z) − 1)/(1 − z)."""
    return lambda z: (f(z) - 1) / (1 - z)


CREASELESS = Creaseless()
QUARTER = (pi / 4 * mpf("1.0001")) ** 2
HALF_LN_2 = log(mpf(2)) / 2 * mpf("1.0001")
ENTRIES = [
    ("SIN", "sin x = x + x³·p(x²), |x| ≤ π/4", odd_correction(sin), 0, QUARTER, lambda z: z),
    ("COS", "cos x = 1 − x²/2 + x⁴·p(x²), |x| ≤ π/4", lambda z: ((cos(sqrt(z)) - 1) / z + mpf(1) / 2) / z, 0, QUARTER, lambda z: z * z),
    ("TAN", "tan x = x + x³·p(x²), |x| ≤ π/4", odd_correction(tan), 0, QUARTER, lambda z: z),
    ("ATAN", "atan x = x + x³·p(x²), |x| ≤ 7/16", odd_correction(atan), 0, mpf(49) / 256, lambda z: z),
    ("ARC", "2·asin √h = 2√h·(1 + h·p(h)), 0 ≤ h ≤ ½", lambda h: (mp.asin(sqrt(h)) / sqrt(h) - 1) / h, 0, mpf("0.50001"), lambda h: h),
    ("ATANH", "atanh x = x + x³·p(x²), |x| ≤ (√2 − 1)²", odd_correction(atanh), 0, TAN_PI_8**4 * mpf("1.0001"), lambda z: z),
    ("EXP", "eˣ = 1 + x + x²/2 + x³·p(x), |x| ≤ ½ ln 2", lambda x: sum(x**k / factorial(k + 3) for k in range(40)), -HALF_LN_2, HALF_LN_2, lambda x: x * x),
    ("QUAD_M", "12/π·asin(w·sin(π/12)) = w − w·(1 − w²)·p(w²), |w| ≤ 1: the forward ordinate of the quadrilateralized cube", odd_unit(quad_m), 0, 1, lambda z: 1 - z),
    ("QUAD_SIN", "√2·sin(πm/12) = m·(c + (1 − m²)·p(m²)), |m| ≤ 1, c = (√3 − 1)/2: toward the sphere", lambda z: (quad_sin(sqrt(z)) / sqrt(z) - QUAD_CORNER) / (1 - z), 0, 1, lambda z: 1 - z),
    ("QUAD_COS", "√2·cos(πm/12) − 1 = c + (1 − m²)·p(m²), |m| ≤ 1", lambda z: (quad_cos(sqrt(z)) - QUAD_CORNER) / (1 - z), 0, 1, lambda z: 1 - z),
    ("UNICUBE_X", "x(u) = 6/π·asin(u/√(2 + 2u²)) = u − u·(1 − u²)·p(u²), |u| ≤ 1: the unicube", odd_unit(lambda u: 6 / pi * mp.asin(u / sqrt(2 + 2 * u * u))), 0, 1, lambda z: 1 - z),
    ("UNICUBE_U", "u(x) = s/√(½ − s²), s = sin(πx/6): back", odd_unit(unicube), 0, 1, lambda z: 1 - z),
    ("TANH_X", "x(u) = tanh(cu)/tanh c, c = 0.9721: Lambers' hyperbolic tangent", odd_unit(lambda u: mp.tanh(TANH_C * u) / mp.tanh(TANH_C)), 0, 1, lambda z: 1 - z),
    ("TANH_U", "u(x) = atanh(x·tanh c)/c: back", odd_unit(lambda x: atanh(x * mp.tanh(TANH_C)) / TANH_C), 0, 1, lambda z: 1 - z),
    *(
        entry
        for name, theta, (x, u) in ((name, text, tangent_pair(theta)) for name, text, theta in TANGENTS)
        for entry in (
            (f"{name}_X", f"x(u) = atan(u·tan θ)/θ = u − u·(1 − u²)·p(u²), |u| ≤ 1, θ = {theta}", odd_unit(x), 0, 1, lambda z: 1 - z),
            (f"{name}_U", "u(x) = tan(θx)/tan θ: back", odd_unit(u), 0, 1, lambda z: 1 - z),
        )
    ),
    ("VERTEX_T", "t(τ) = τ + τ·(1 − τ)·p(τ), 0 ≤ τ ≤ 1: the vertex map's area share", unit(vertex_t), 0, 1, lambda x: 1 - x),
    ("VERTEX_TAU", "τ(t) = t + t·(1 − t)·p(t), 0 ≤ t ≤ 1: its inverse", unit(vertex_tau), 0, 1, lambda x: 1 - x),
    ("POWER_RE", "Re c(k) = 1 + k·p(k), |k| ≤ 1, c(k) = e^(iπ/8)(1 + ik/√3)^¾/cos(π/8): the conformal map toward the plane", lambda k: (conformal_power(k).real - 1) / k, -1, 1, abs),
    ("POWER_IM", "Im c(k) = (1 + k)·p(k), |k| ≤ 1", lambda k: conformal_power(k).imag / (1 + k), -1, 1, lambda k: 1 + k),
    ("ROOT_RE", "Re (1 + it)^(4/3) = 1 + t²·p(t²), 0 ≤ t ≤ 1: the conformal map toward the sphere", lambda z: (conformal_root(sqrt(z)).real - 1) / z, 0, 1, lambda z: z),
    ("ROOT_IM", "Im (1 + it)^(4/3) = t·p(t²), 0 ≤ t ≤ 1", lambda z: conformal_root(sqrt(z)).imag / sqrt(z), 0, 1, sqrt),
    ("CREASELESS_W", "w/x = 1 + (1 − z)·p(z), z = x² ≤ 1: the diagonal of the creaseless cube", less_one(CREASELESS.stretch), 0, 1, lambda z: 1 - z),
    ("CREASELESS_BOW", "κ = x(1 − z)w²·p(z): the bow of its curves", CREASELESS.bow, 0, 1, lambda z: z * (1 - z)),
    ("CREASELESS_CUBIC", "τ = z·p(z): the place on a curve", CREASELESS.cubic, 0, 1, lambda z: z),
]


def remez(g, lo, hi, weight, terms):
    """Coefficients (ascending) and the largest weighted error."""
    lo, hi = mpf(lo), mpf(hi)
    inset = (hi - lo) * mpf(10) ** -12  # g has removable singularities at the ends
    lo, hi = lo + inset, hi - inset
    mid, half = (lo + hi) / 2, (hi - lo) / 2
    nodes = [mid - half * cos(pi * (2 * k + 1) / (2 * (terms + 1))) for k in range(terms + 1)]
    grid = [mid - half * cos(pi * k / (24 * terms)) for k in range(24 * terms + 1)]
    grid = [x or inset for x in grid]  # and one at 0
    nodes = [x or inset for x in nodes]
    values = [g(x) for x in grid]
    for _ in range(12):
        a = matrix(terms + 1, terms + 1)
        b = matrix(terms + 1, 1)
        for i, x in enumerate(nodes):
            w = weight(x)
            s = (x - mid) / half
            for j in range(terms):
                a[i, j] = w * chebyt(j, s)
            a[i, terms] = (-1) ** i
            b[i] = w * g(x)
        c = lu_solve(a, b)
        cheb = [c[j] for j in range(terms)]

        def p(x):
            s = (x - mid) / half
            b1 = b2 = mpf(0)
            for cj in reversed(cheb[1:]):
                b1, b2 = 2 * s * b1 - b2 + cj, b1
            return s * b1 - b2 + cheb[0]

        errors = [weight(x) * (v - p(x)) for x, v in zip(grid, values)]
        # One extremum for each run of equal sign.
        runs, best = [], 0
        for k in range(1, len(errors)):
            if errors[k] * errors[best] < 0:
                runs.append(best)
                best = k
            elif abs(errors[k]) > abs(errors[best]):
                best = k
        runs.append(best)
        worst = max(abs(e) for e in errors)
        while len(runs) > terms + 1:
            runs.pop(0 if abs(errors[runs[0]]) < abs(errors[runs[-1]]) else -1)
        if len(runs) < terms + 1 or worst < abs(c[terms]) * mpf("1.01"):
            break
        nodes = [grid[k] for k in runs]
    # Chebyshev in s to powers of x.
    powers = [mpf(0)] * terms
    t0, t1 = [mpf(1)], [-mid / half, 1 / half]
    for j in range(terms):
        for k, v in enumerate(t0):
            powers[k] += cheb[j] * v
        t2 = [mpf(0)] * (len(t1) + 1)
        for k, v in enumerate(t1):
            t2[k] -= 2 * mid / half * v
            t2[k + 1] += 2 / half * v
        for k, v in enumerate(t0):
            t2[k] -= v
        t0, t1 = t1, t2
    return powers, worst


def shortest(g, lo, hi, weight, bound):
    for terms in range(2, 40):
        powers, worst = remez(g, lo, hi, weight, terms)
        if worst < bound:
            return powers, worst
    raise SystemExit("no polynomial is short enough")


def literal(value, scalar):
    if scalar == "f64":
        return repr(float(value))
    single = struct.unpack("f", struct.pack("f", float(value)))[0]
    for digits in range(6, 10):
        text = f"{single:.{digits}e}"
        if struct.unpack("f", struct.pack("f", float(text)))[0] == single:
            return text
    return repr(single)


def main():
    print("//! Made by `minimax.py`; do not edit.\n")
    print("use super::Polynomial;\n")
    for name, text, g, lo, hi, weight in ENTRIES:
        tables = {s: shortest(g, lo, hi, weight, BOUND[s]) for s in ("f64", "f32")}
        n, m = len(tables["f64"][0]), len(tables["f32"][0])
        print(f"/// {text}; error {mp.nstr(tables['f64'][1], 2)} (f64), {mp.nstr(tables['f32'][1], 2)} (f32).")
        print(f"pub(crate) const {name}: Polynomial<{n}, {m}> = Polynomial {{")
        for scalar in ("f64", "f32"):
            print(f"    {scalar}: [{', '.join(literal(c, scalar) for c in tables[scalar][0])}],")
        print("};\n")


main()
