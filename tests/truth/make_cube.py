#!/usr/bin/env python3
"""High-precision truth for cube projections: writes cube_<name>_{forward,inverse}.tsv next to itself.

    python3 make_cube.py                  all files, and the checks
    python3 make_cube.py vertex square    only these

Needs mpmath, nothing else. The same files come out of every run. README.md has the conventions.
"""

import os
import random
import struct
import sys

from mpmath import mp, mpf, mpc

mp.dps = 120
SEED = 5207
HERE = os.path.dirname(os.path.abspath(__file__))
ONE = mpf(1)
TINY = mpf(10) ** -70  # every exact zero of these maps comes out smaller than this


# ---- faces -------------------------------------------------------------------------------------

def face_of(v):
    """The face of the component of largest magnitude; ties go to x, then y, then z."""
    ax, ay, az = (abs(c) for c in v)
    if ax >= ay and ax >= az:
        return 1 if v[0] > 0 else 3
    if ay >= az:
        return 4 if v[1] > 0 else 5
    return 0 if v[2] > 0 else 2


def to_local(face, v):
    """(vx, vy, vz) -> (right, up, outward) on the face."""
    x, y, z = v
    return [(x, y, z), (-z, y, x), (-x, y, -z), (z, y, -x), (x, -z, y), (x, z, -y)][face]


def from_local(face, p):
    """(right, up, outward) on the face -> (vx, vy, vz)."""
    x, y, z = p
    return [(x, y, z), (z, y, -x), (-x, y, -z), (-z, y, x), (x, z, -y), (x, -z, y)][face]


def unit(p):
    n = mp.sqrt(sum(c * c for c in p))
    return tuple(c / n for c in p)


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


# ---- the maps ----------------------------------------------------------------------------------
# Each has forward(X, Y, Z) -> (x, y) and inverse(x, y) -> (X, Y, Z), in the local frame of a face.
# Neither side needs unit length.

def tangent_family(theta):
    """u = tan(theta x) / tan(theta), v likewise."""
    t = mp.tan(theta)

    def forward(X, Y, Z):
        return mp.atan(t * X / Z) / theta, mp.atan(t * Y / Z) / theta

    def inverse(x, y):
        return mp.tan(theta * x) / t, mp.tan(theta * y) / t, ONE

    return forward, inverse


def algebraic():
    """u = x / sqrt(1 + c^2 - c^2 x^2), c = 0.87."""
    c2 = (mpf(87) / 100) ** 2

    def forward(X, Y, Z):
        return tuple(u * mp.sqrt((1 + c2) / (1 + c2 * u * u)) for u in (X / Z, Y / Z))

    def inverse(x, y):
        return x / mp.sqrt(1 + c2 - c2 * x * x), y / mp.sqrt(1 + c2 - c2 * y * y), ONE

    return forward, inverse


def everitt():
    """|x| = e |u| - (e - 1) u^2, e = 1.4511; u is the smaller root."""
    e = mpf("1.4511")

    def sign(w):
        return (w > 0) - (w < 0)

    def forward(X, Y, Z):
        return tuple(sign(u) * (e * abs(u) - (e - 1) * u * u) for u in (X / Z, Y / Z))

    def inverse(x, y):
        return *(sign(w) * (e - mp.sqrt(e * e - 4 * (e - 1) * abs(w))) / (2 * (e - 1)) for w in (x, y)), ONE

    return forward, inverse


def unicube():
    """u = s / sqrt(1/2 - s^2), s = sin(pi x / 6)."""

    def forward(X, Y, Z):
        return tuple(6 / mp.pi * mp.asin(u / mp.sqrt(2 * (1 + u * u))) for u in (X / Z, Y / Z))

    def inverse(x, y):
        s = [mp.sin(mp.pi * w / 6) for w in (x, y)]
        return *(w / mp.sqrt(ONE / 2 - w * w) for w in s), ONE

    return forward, inverse


def hyperbolic():
    """u = atanh(x tanh c) / c, c = 0.9721."""
    c = mpf("0.9721")
    t = mp.tanh(c)

    def forward(X, Y, Z):
        return tuple(mp.tanh(c * u) / t for u in (X / Z, Y / Z))

    def inverse(x, y):
        return mp.atanh(t * x) / c, mp.atanh(t * y) / c, ONE

    return forward, inverse


def polynomial_5():
    """u = a x + b x^3 + c x^5; forward by Newton iteration."""
    a, b, c = mpf("0.745558715593"), mpf("0.130546850193"), mpf("0.123894434214")

    def inverse(x, y):
        return *(w * (a + w * w * (b + c * w * w)) for w in (x, y)), ONE

    return newton_forward(inverse), inverse


def continuous():
    """u = sqrt(2) tan(x atan(1/sqrt 2)), v = tan(y asin(1/sqrt(2 + u^2))) sqrt(1 + u^2)."""
    c = mp.atan(1 / mp.sqrt(2))

    def forward(X, Y, Z):
        u, v = X / Z, Y / Z
        return mp.atan(u / mp.sqrt(2)) / c, mp.atan(v / mp.sqrt(1 + u * u)) / mp.asin(1 / mp.sqrt(2 + u * u))

    def inverse(x, y):
        u = mp.sqrt(2) * mp.tan(x * c)
        return u, mp.tan(y * mp.asin(1 / mp.sqrt(2 + u * u))) * mp.sqrt(1 + u * u), ONE

    return forward, inverse


def arvo():
    """u = sqrt(2) t / sqrt(1 - t^2), t = tan(pi x / 6); v = y / sqrt(1 + (1 - y^2) cos(pi x / 3))."""

    def forward(X, Y, Z):
        u, v = X / Z, Y / Z
        return 6 / mp.pi * mp.atan(u / mp.sqrt(2 + u * u)), v * mp.sqrt((2 + u * u) / (1 + u * u + v * v))

    def inverse(x, y):
        t = mp.tan(mp.pi * x / 6)
        return mp.sqrt(2) * t / mp.sqrt(1 - t * t), y / mp.sqrt(1 + (1 - y * y) * mp.cos(mp.pi * x / 3)), ONE

    return forward, inverse


def hybrid_equi_angular(polar):
    """u = tan(pi x / 4); on a side face v = y / (1 + 0.4 (1 - x^2)(1 - y^2)), on a polar one v = tan(pi y / 4)."""

    def forward(X, Y, Z):
        u, v = X / Z, Y / Z
        x = 4 / mp.pi * mp.atan(u)
        if polar:
            return x, 4 / mp.pi * mp.atan(v)
        # a y^2 + y - (v + a) = 0, times 1/v: the root next to v.
        a = mpf(2) / 5 * (1 - x * x) * v
        return x, 2 * (v + a) / (1 + mp.sqrt(1 + 4 * a * (v + a)))

    def inverse(x, y):
        if polar:
            return mp.tan(mp.pi * x / 4), mp.tan(mp.pi * y / 4), ONE
        return mp.tan(mp.pi * x / 4), y / (1 + mpf(2) / 5 * (1 - x * x) * (1 - y * y)), ONE

    return forward, inverse


def cobe_refit():
    """Zucker & Higashi's polynomial to the sphere; forward by Newton iteration."""
    alpha, a, b, c, d, e = (mpf(w) for w in (
        "0.723951234952", "-0.0941180085824", "0.0409125981187", "-0.0623272690881", "0.0275922480902",
        "0.0342217026979"))

    def half(x, y):
        x2, y2 = x * x, y * y
        return x * (alpha + (1 - alpha) * x2 + (1 - x2) * ((a + b * y2 + c * x2) * x2 + (d + e * y2) * y2))

    def inverse(x, y):
        return half(x, y), half(y, x), ONE

    return newton_forward(inverse), inverse


def newton_forward(inverse):
    """Forward of a map given by its inverse: Newton on the gnomonic coordinates, Jacobian by differences."""
    h = mpf(10) ** -55

    def gnomonic(x, y):
        X, Y, Z = inverse(x, y)
        return X / Z, Y / Z

    def forward(X, Y, Z):
        u, v = X / Z, Y / Z
        x = u * (1 + mpf("0.21") * (1 - u * u))
        y = v * (1 + mpf("0.21") * (1 - v * v))
        for _ in range(30):
            u0, v0 = gnomonic(x, y)
            ux, vx = ((a - b) / h for a, b in zip(gnomonic(x + h, y), (u0, v0)))
            uy, vy = ((a - b) / h for a, b in zip(gnomonic(x, y + h), (u0, v0)))
            det = ux * vy - uy * vx
            dx = ((u - u0) * vy - (v - v0) * uy) / det
            dy = ((v - v0) * ux - (u - u0) * vx) / det
            x, y = x + dx, y + dy
            if abs(dx) + abs(dy) < mpf(10) ** -100:
                return x, y
        raise ArithmeticError("no convergence")

    return forward


def balanced():
    b0, b1, b2 = mpf(-22) / 100, mpf(9) / 100, mpf(-11) / 100

    def inverse(x, y):
        p, q = 1 - x * x, 1 - y * y
        return x * (1 + p * (b0 + p * (b1 + b2 * q))), y * (1 + q * (b0 + q * (b1 + b2 * p))), ONE

    return newton_forward(inverse), inverse


def edge_keeping(coefficients, unit):
    """u = x (1 + (1 - x^2) P(x^2, y^2)), v likewise: P has the coefficients of X^i Y^j, times the unit."""

    def half(x, y):
        return x * (1 + (1 - x * x) * sum(mpf(c) / unit * x ** (2 * i) * y ** (2 * j) for (i, j), c in coefficients.items()))

    def inverse(x, y):
        return half(x, y), half(y, x), ONE

    return newton_forward(inverse), inverse


def even():
    return edge_keeping({(0, 0): -2766, (0, 1): 340, (0, 2): -1908, (0, 3): 4685, (0, 4): -1989, (1, 0): -954,
                         (1, 3): 235, (2, 1): -2125, (2, 2): 1374, (5, 0): -137}, 10000)


def compact():
    return edge_keeping({(0, 0): -242, (2, 0): 32, (1, 1): 183, (1, 2): -1119, (1, 3): 904, (3, 1): -69,
                         (0, 2): 483, (0, 3): -375}, 1000)


def creaseless():
    """In |y| <= x: the line of constant x is phi = f(x) + k(x) z^2 in longitude phi and height z (of Y), dx dy is
    6/pi of the area dphi dz, and the diagonal u = v = w(x) is crossed without a crease. So
    k z^3 2/3 = E(w) - pi x^2/12 at the diagonal, E the area of (0, 0), (w, 0), (w, w), and w solves a differential
    equation of the first order: collocation with 64 Chebyshev polynomials of x^2, to 1e-50."""
    with mp.workdps(80):
        n, h = 64, mpf(10) ** -40

        def excess(x, w):
            return mp.pi / 4 - mp.asin(1 / mp.sqrt(2 * (1 + w * w))) - mp.pi * x * x / 12

        def residual(x, w, dw):
            q = 1 + 2 * w * w
            z = w / mp.sqrt(q)
            # du = a ds along the diagonal and g across it, a g = q^(3/2) pi/6; the line's slope is (a - g)/(a + g).
            g = q ** mpf("1.5") * mp.pi / 6 / dw
            r = (dw - g) / (dw + g)
            dphi, dz = r / (1 + w * w), (1 + w * w - w * w * r) / q ** mpf("1.5")
            return (3 * excess(x, w) / (z * z) * dz - dphi) / (x * x)

        def basis(X):
            t, d = [ONE, 2 * X - 1], [mpf(0), mpf(2)]
            for _ in range(n - 1):
                d.append(4 * t[-1] + 2 * (2 * X - 1) * d[-1] - d[-2])
                t.append(2 * (2 * X - 1) * t[-1] - t[-2])
            return t, d

        rows = [((1 - mp.cos(mp.pi * (2 * j + 1) / (2 * n))) / 2) for j in range(n)]
        rows = [(mp.sqrt(X), X, *basis(X)) for X in rows]
        c0 = mp.sqrt(mp.pi / 6)
        c = mp.matrix([(1 + c0) / 2, (1 - c0) / 2] + [0] * (n - 1))
        for _ in range(9):
            a, b = mp.matrix(n + 1, n + 1), mp.matrix(n + 1, 1)
            for j, (x, X, t, d) in enumerate(rows):
                o, do = mp.fdot(c, t), mp.fdot(c, d)
                w, dw = x * o, o + 2 * X * do
                rest = residual(x, w, dw)
                by_w, by_dw = (residual(x, w + h, dw) - rest) / h, (residual(x, w, dw + h) - rest) / h
                b[j] = -rest
                for k in range(n + 1):
                    a[j, k] = by_w * x * t[k] + by_dw * (t[k] + 2 * X * d[k])
            for k in range(n + 1):
                a[n, k] = 1
            b[n] = 1 - sum(c)
            step = mp.lu_solve(a, b)
            c += step
            if max(abs(v) for v in step) < mpf(10) ** -60:
                break
        else:
            raise ArithmeticError("no convergence")

    def octant(x, y):
        if x == 0:
            return mpf(0), mpf(0), ONE
        t, d = basis(x * x)
        o, do = mp.fdot(c, t), mp.fdot(c, d)
        w, dw = x * o, o + 2 * x * x * do
        if x == 1:
            w = ONE
        q = 1 + 2 * w * w
        end, dend = w / mp.sqrt(q), dw / q ** mpf("1.5")
        k = excess(x, w) * 3 / (2 * end ** 3) if x != 1 else mpf(0)
        darea = end * dw / (1 + w * w) - mp.pi * x / 6  # of the excess, by x
        dk = darea * 3 / (2 * end ** 3) - 3 * k * dend / end
        # f' end + k' end^3/3 = pi/6 x: f' without the difference f = phi - k end^2.
        df = (mp.pi / 6 * x - dk * end ** 3 / 3) / end
        z = end * y / x
        for _ in range(40):
            step = (df * z + dk * z ** 3 / 3 - mp.pi / 6 * y) / (df + dk * z * z)
            z -= step
            if abs(step) <= abs(z) * mpf(10) ** -110:
                break
        # tan phi = tan(phi_d - k (end^2 - z^2))
        s = mp.tan(k * (end * end - z * z)) if abs(y) != x else mpf(0)
        u = (w - s) / (1 + w * s)
        v = z * mp.sqrt((1 + u * u) / (1 - z * z)) if abs(y) != x else (w if y > 0 else -w)
        return u, v, ONE

    def inverse(x, y):
        steep = abs(y) > abs(x)
        major, minor = (y, x) if steep else (x, y)
        u, v, _ = octant(abs(major), minor)
        u = -u if major < 0 else u
        return (v, u, ONE) if steep else (u, v, ONE)

    return newton_forward(inverse), inverse


def square():
    b02, z20, z21 = mpf("-0.14466724146108473"), mpf("-0.04735555476289911"), mpf("0.12576117646754637")

    def a(x, y):
        p, q = 1 - x * x, 1 - y * y
        return 1 + b02 * p * y ** 4 + z20 * q * q

    def inverse(x, y):
        p, q = 1 - x * x, 1 - y * y
        return x * a(x, y), y * a(y, x), 1 + z20 * (p * p + q * q) + z21 * (p * p * q + p * q * q)

    return newton_forward(inverse), inverse


def vertex():
    """Vertex equal-area: slice and dice on the octant 0 <= y <= x with its apex at the cube corner V.
    D is where the great circle from V through P meets Y = 0."""
    V = (1 / mp.sqrt(3),) * 3
    k = (mp.sqrt(3) - 1) / mp.sqrt(2)

    def folded(octant_map):
        def whole(a, b, *rest):
            swap = abs(b) > abs(a)
            c, d, *rest = octant_map(*((abs(b), abs(a)) if swap else (abs(a), abs(b))), *rest)
            if swap:
                c, d = d, c
            return (-c if a < 0 else c, -d if b < 0 else d, *rest)
        return whole

    def forward(X, Y, Z):
        P = unit((X, Y, Z))
        if X == Y == Z:
            return ONE, ONE
        D = unit((X - Y, 0 * X, Z - Y))
        r = mp.sqrt((1 - dot(V, P)) / (1 - dot(V, D)))
        # Area E of the triangle (V, C, D), C = (0, 0, 1): tan(E/2) = V.(C x D) / (1 + V.C + C.D + D.V).
        E = 2 * mp.atan2(V[0] * D[0], 1 + V[2] + D[2] + dot(V, D))
        t = 12 * E / mp.pi
        return 1 - r * (1 - t), 1 - r

    def inverse(x, y):
        r = 1 - y
        if r == 0:
            return V
        T = mp.tan(mp.pi * (x - y) / r / 24)
        xi = 2 * mp.atan(mp.sqrt(2) * T / (k * (1 - T)))
        D = (mp.sin(xi), mpf(0), mp.cos(xi))
        vd = dot(V, D)
        h = r * r * (1 - vd)  # 1 - cos(VP)
        n = unit(tuple(d - v * vd for d, v in zip(D, V)))
        return tuple(v * (1 - h) + m * mp.sqrt(h * (2 - h)) for v, m in zip(V, n))

    return folded(forward), folded(inverse)


class Conformal:
    """Rancic, Purser & Mesinger 1996, about the nearest cube corner V.

    w: stereographic coordinate about V, w = 1 at a neighbouring corner; W = w^3.
    z: plane coordinate from V, in edge lengths; Z = z^4 = K W S(W)^4,
    S(W) = sum a_n W^n / (1 + 4n), sum a_n W^n = f(W) = [(1 - W)(1 + W/8)]^(-1/4), K = I^-4, z(1) = 1.
    """

    def __init__(self, terms=320):  # |W| <= (sqrt 3 - 1)^3 = 0.3923 after folding: 0.3923^320 = 1e-130
        g1, g2 = mpf(-7) / 8, mpf(-1) / 8
        a = [ONE, mpf(7) / 32]
        for n in range(2, terms):
            a.append(-(g1 * (n - mpf(3) / 4) * a[n - 1] + g2 * (n - mpf(3) / 2) * a[n - 2]) / n)
        self.s = [c / (1 + 4 * n) for n, c in enumerate(a)][::-1]
        # I = integral of W^(-3/4) f(W) / 4 over [0, 1] = B(1/4, 3/4) 2F1(1/4, 1/4; 1; -1/8) / 4
        self.I = mp.pi * mp.sqrt(2) / 4 * mp.hyp2f1(ONE / 4, ONE / 4, 1, -ONE / 8)
        self.K = self.I ** -4

    def S(self, W):
        acc = mpc(0)
        for c in self.s:
            acc = acc * W + c
        return acc

    def f(self, W):
        return ((1 - W) * (1 + W / 8)) ** (-ONE / 4)

    def z_of_w(self, w):
        if w == 0:
            return mpc(0)
        return mp.exp(mpf(3) / 4 * mp.log(w)) / self.I * self.S(w ** 3)

    def w_of_z(self, z):
        if z == 0:
            return mpc(0)
        Z = z ** 4
        W = Z / self.K
        for _ in range(30):
            s = self.S(W)
            step = (self.K * W * s ** 4 - Z) / (self.K * s ** 3 * self.f(W))
            W -= step
            if abs(step) < abs(W) * mpf(10) ** -110:
                return mp.exp(mpf(4) / 3 * mp.log(z)) * (W / Z) ** (ONE / 3)
        raise ArithmeticError("no convergence")

    # Frame at V = (1,1,1)/sqrt 3: e1 = (-2,1,1)/sqrt 6 along the edge to (-1,1,1), e2 = V x e1 = (0,-1,1)/sqrt 2.
    def w_of_point(self, P):
        X, Y, Z = unit(P)
        return mp.sqrt(2) * mpc((Y + Z - 2 * X) / mp.sqrt(6), (Z - Y) / mp.sqrt(2)) / (1 + (X + Y + Z) / mp.sqrt(3))

    def point_of_w(self, w):
        s = w / mp.sqrt(2)
        m = s.real ** 2 + s.imag ** 2
        a, b, c = 2 * s.real / (1 + m) / mp.sqrt(6), 2 * s.imag / (1 + m) / mp.sqrt(2), (1 - m) / (1 + m) / mp.sqrt(3)
        return c - 2 * a, c + a - b, c + a + b

    def forward(self, X, Y, Z):
        z = self.z_of_w(self.w_of_point((abs(X), abs(Y), Z)))
        x, y = 1 - 2 * z.real, 1 - 2 * z.imag
        return (-x if X < 0 else x), (-y if Y < 0 else y)

    def inverse(self, x, y):
        X, Y, Z = self.point_of_w(self.w_of_z(mpc((1 - abs(x)) / 2, (1 - abs(y)) / 2)))
        return (-X if x < 0 else X), (-Y if y < 0 else Y), Z


def conformal():
    c = Conformal()
    return c.forward, c.inverse


# COBE: coefficients P_ij of the published inverse, u = x + x (1 - x^2) sum P_ij x^2i y^2j (v: swap x and y).
# Row j, column i. Compared digit by digit in four programs, see README.md.
COBE_P = [[mpf(c) for c in row.split()] for row in (
    "-0.27292696 -0.07629969 -0.22797056 0.54852384 -0.62930065 0.25795794 0.02584375",
    "-0.02819452 -0.01471565 0.48051509 -1.74114454 1.71547508 -0.53022337",
    "0.27058160 -0.56800938 0.30803317 0.98938102 -0.83180469",
    "-0.60441560 1.50880086 -0.93678576 0.08693841",
    "0.93412077 -1.41601920 0.33887446",
    "-0.63915306 0.52032238",
    "0.14381585")]


def cobe_published():
    def half(x, y):
        x2, y2 = x * x, y * y
        return x + x * (1 - x2) * sum(c * x2 ** i * y2 ** j for j, row in enumerate(COBE_P) for i, c in enumerate(row))

    def half_forward(u, v):
        # The published forward polynomial, for the check only.
        g, gamma, m, omega = (mpf(c) for c in ("1.37484847732", "-0.13161671474", "0.004869491981", "-0.159596235474"))
        d0, d1 = mpf("0.0759196200467"), mpf("-0.0217762490699")
        c00, c10, c01, c11, c20, c02 = (mpf(c) for c in (
            "0.141189631152", "0.0809701286525", "-0.281528535557", "0.15384112876", "-0.178251207466", "0.106959469314"))
        a, b = u * u, v * v
        return u * (g + (1 - g) * a + (1 - a) * (b * (
            gamma + (m - gamma) * a + (1 - b) * (c00 + c10 * a + c01 * b + c11 * a * b + c20 * a * a + c02 * b * b))
            + a * (omega - (1 - a) * (d0 + d1 * a))))

    def forward(X, Y, Z):
        return half_forward(X / Z, Y / Z), half_forward(Y / Z, X / Z)

    def inverse(x, y):
        return half(x, y), half(y, x), ONE

    return forward, inverse


MAPS = {
    "algebraic": ("Algebraic cube, u = x / sqrt(1 + c^2 - c^2 x^2), c = 87/100 exactly", algebraic),
    "equi-edge": ("Equi-edge cube, u = tan(theta x) / tan(theta), theta = atan(1/sqrt 2)",
                  lambda: tangent_family(mp.atan(1 / mp.sqrt(2)))),
    "separable": ("Separable cube, u = tan(theta x) / tan(theta), theta = acos(2^(-5/12))",
                  lambda: tangent_family(mp.acos(mpf(2) ** (-mpf(5) / 12)))),
    "balanced": ("Balanced cube, b = -0.22, 0.09, -0.11 exactly; forward by Newton iteration", balanced),
    "square": ("Square cube, decimal coefficients taken exactly; forward by Newton iteration", square),
    "vertex": ("Vertex equal-area cube (slice and dice about the cube's corners)", vertex),
    "cobe": ("COBE quadrilateralized Spherical Cube, published inverse polynomial, decimal coefficients taken exactly",
                       cobe_published),
    "everitt": ("Everitt's cube, x = u (e - (e - 1) |u|), e = 1.4511 exactly", everitt),
    "unicube": ("Unicube, u = s / sqrt(1/2 - s^2), s = sin(pi x / 6)", unicube),
    "tanh": ("Lambers' hyperbolic tangent, x = tanh(c u) / tanh(c), c = 0.9721 exactly", hyperbolic),
    "zucker-higashi": ("Zucker & Higashi's tangent, u = tan(theta x) / tan(theta), theta = 0.868734829276 exactly",
                       lambda: tangent_family(mpf("0.868734829276"))),
    "lambers": ("Lambers' tangent, u = tan(theta x) / tan(theta), theta = atan(1.1968)",
                lambda: tangent_family(mp.atan(mpf("1.1968")))),
    "polynomial-5": ("Zucker & Higashi's polynomial of degree 5, decimal coefficients taken exactly; forward by Newton "
                     "iteration", polynomial_5),
    "continuous": ("Continuous cube (Grimm & Niebruegge), u = sqrt(2) tan(x atan(1/sqrt 2)), v = tan(y asin(1/sqrt(2 + u^2))) "
                   "sqrt(1 + u^2)", continuous),
    "arvo": ("Arvo's equal-area cube, u = sqrt(2) t / sqrt(1 - t^2), t = tan(pi x / 6); v = y / sqrt(1 + (1 - y^2) cos(pi x / 3))",
             arvo),
    "hybrid-equi-angular": ("Hybrid equi-angular cube, u = tan(pi x / 4); sides v = y / (1 + 0.4 (1 - x^2)(1 - y^2)), "
                            "top and bottom v = tan(pi y / 4)", hybrid_equi_angular),
    "cobe-refit": ("Zucker & Higashi's refit of COBE's cube, decimal coefficients taken exactly; forward by Newton iteration",
                   cobe_refit),
    "even": ("Even cube, decimal coefficients taken exactly; forward by Newton iteration", even),
    "compact": ("Compact cube, decimal coefficients taken exactly; forward by Newton iteration", compact),
    "creaseless": ("Creaseless equal-area cube; forward by Newton iteration", creaseless),
    "conformal": ("Conformal cube (Rancic, Purser & Mesinger), series of 320 terms about the nearest corner; "
                  "inverse by Newton iteration", conformal),
}


# Maps that are another on the top and the bottom: made with whether a face is one of them.
BY_FACE = {"hybrid-equi-angular"}
POLAR = (4, 5)


def kinds(name):
    """For each face its forward and inverse."""
    make = MAPS[name][1]
    if name not in BY_FACE:
        return [make()] * 6
    side, polar = make(False), make(True)
    return [polar if face in POLAR else side for face in range(6)]


# ---- inputs ------------------------------------------------------------------------------------

SPECIAL = [("edge", 23), ("corner", 16), ("diag", 16), ("centre", 12), ("axis", 12)]


def f32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def random_unit(rng):
    p = [rng.gauss(0, 1) for _ in range(3)]
    n = sum(c * c for c in p) ** 0.5
    return [c / n for c in p]


def normalise(p):
    """Roughly unit length; components equal in magnitude stay exactly so."""
    n = sum(c * c for c in p) ** 0.5
    return [c / n for c in p]


def sign(rng):
    return rng.choice((-1.0, 1.0))


def forward_inputs(rng):
    rows = [(random_unit(rng), "uniform") for _ in range(117)]
    rows += [([f32(c) for c in random_unit(rng)], "f32") for _ in range(31)]

    def point(kind, d):
        """A point within about 3 d of the feature, in a random face's frame."""
        off = lambda: d * rng.uniform(-3, 3)
        a, b = rng.uniform(-1, 1), sign(rng)
        if kind == "edge":
            p = [b * (1 + off()), a, 1.0]
        elif kind == "corner":
            p = [b * (1 + off()), sign(rng) * (1 + off()), 1 + off()]
        elif kind == "diag":
            p = [a, b * a * (1 + off()), 1.0]
        elif kind == "centre":
            p = [off(), off(), 1.0]
        else:
            p = [a, off(), 1.0]
        if rng.random() < 0.5:
            p[0], p[1] = p[1], p[0]
        return normalise(from_local(rng.randrange(6), p))

    for kind, count in SPECIAL:
        for d in (1e-3, 1e-9, 1e-15):
            made = 0
            while made < count:
                v = point(kind, d)
                m = sorted(abs(c) for c in v)
                if m[1] == m[2]:
                    continue  # an exact tie has its own class
                rows.append((v, f"{kind}_{d:.0e}".replace("e-0", "e-")))
                made += 1
    for face in range(6):
        a, b = rng.uniform(-1, 1), rng.uniform(-1, 1)
        for p in ([0.0, 0.0, 1.0], [a, 0.0, 1.0], [0.0, b, 1.0], [a, a, 1.0], [b, -b, 1.0]):
            rows.append((normalise(from_local(face, p)), "exact"))
    for p in [(1, s, t) for s in (-1, 1) for t in (-1, 1)]:
        rows += [(normalise([c * p[0], p[1], p[2]]), "exact_tie") for c in (-1.0, 1.0)]  # corners
    for i in range(3):
        for s in (-1.0, 1.0):
            for t in (-1.0, 1.0):
                for a in (0.0, rng.uniform(-1, 1)):  # middle of the edge, and another point of it
                    p = [s, t]
                    p.insert(i, a)
                    rows.append((normalise(p), "exact_tie"))
    return [([c + 0.0 for c in v], cls) for v, cls in rows]  # + 0.0: no minus zero


def inverse_inputs(rng):
    u = lambda: rng.uniform(-1, 1)
    rows = [(u(), u(), "uniform") for _ in range(117)]
    rows += [(f32(u()), f32(u()), "f32") for _ in range(31)]

    def point(kind, d):
        off = lambda: d * rng.uniform(-3, 3)
        inner = lambda: sign(rng) * (1 - abs(off()))
        a = u()
        if kind == "edge":
            p = [inner(), a]
        elif kind == "corner":
            p = [inner(), inner()]
        elif kind == "diag":
            p = [a, sign(rng) * max(-1.0, min(1.0, a + off()))]
        elif kind == "centre":
            p = [off(), off()]
        else:
            p = [a, off()]
        return p if rng.random() < 0.5 else p[::-1]

    for kind, count in SPECIAL:
        for d in (1e-3, 1e-9, 1e-15):
            rows += [(*point(kind, d), f"{kind}_{d:.0e}".replace("e-0", "e-")) for _ in range(count)]
    rows = [(rng.randrange(6), *r) for r in rows]
    for face in range(6):
        a, b = u(), u()
        for x, y in ((0.0, 0.0), (a, 0.0), (0.0, b), (a, a), (b, -b), (1.0, a), (b, -1.0), (-1.0, 0.0), (0.0, 1.0)):
            rows.append((face, x, y, "exact"))
    for face in range(6):
        for x, y in ((1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0))[face % 2::2]:
            rows.append((face, x, y, "exact"))
    return rows


# ---- files -------------------------------------------------------------------------------------

def decimal(x):
    """Shortest decimal of a binary64."""
    s = repr(float(x))
    return s[:-2] if s.endswith(".0") else s


def digits(x):
    """25 significant digits; 0, 1, -1 as such."""
    if abs(x) < TINY:
        return "0"
    if abs(abs(x) - 1) < TINY:
        return "1" if x > 0 else "-1"
    return mp.nstr(x, 25, strip_zeros=False)


def write(name, kind, title, what, closure, columns, rows):
    path = os.path.join(HERE, f"cube_{name}_{kind}.tsv")
    head = [
        f"# {title}, {kind}: {what}",
        f"# Tool: mpmath with {mp.dps} working digits (make_cube.py, seed {SEED}); 25 significant digits.",
        "# Inputs are shortest round-trip decimals of binary64 values; truth is computed from exactly those binary64 values.",
        "# Faces, axes and ties: see README.md.",
        f"# Checked: {closure}",
        "\t".join(columns),
    ]
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("\n".join(head + ["\t".join(r) for r in rows]) + "\n")
    print(f"{os.path.basename(path)}: {len(rows)} rows; {closure}", flush=True)


def make_forward(name, title, maps):
    rng = random.Random(f"{SEED} {name} forward")
    rows, worst = [], mpf(0)
    for v, cls in forward_inputs(rng):
        exact = tuple(mpf(c) for c in v)
        face = face_of(exact)
        forward, inverse = maps[face]
        x, y = forward(*to_local(face, exact))
        assert max(abs(x), abs(y)) <= 1 + TINY
        back = from_local(face, unit(inverse(x, y)))
        worst = max(worst, max(abs(a - b) for a, b in zip(back, unit(exact))))
        rows.append([*(decimal(c) for c in v), str(face), digits(x), digits(y), cls])
    assert worst < TINY
    write(name, "forward", title, "direction (vx, vy, vz), not exactly of unit length -> face, x, y in [-1, 1]",
          f"inverse(forward) closes to {mp.nstr(worst, 2)}.", ["vx", "vy", "vz", "face", "x", "y", "class"], rows)


def make_inverse(name, title, maps, exact_pair=True):
    rng = random.Random(f"{SEED} {name} inverse")
    rows, worst = [], mpf(0)
    for face, xf, yf, cls in inverse_inputs(rng):
        x, y = mpf(xf), mpf(yf)
        forward, inverse = maps[face]
        local = unit(inverse(x, y))
        v = from_local(face, local)
        if max(abs(x), abs(y)) < 1:
            assert face_of(v) == face
        x1, y1 = forward(*local)
        worst = max(worst, abs(x1 - x), abs(y1 - y))
        rows.append([str(face), decimal(xf), decimal(yf), *(digits(c) for c in v), cls])
    assert worst < (TINY if exact_pair else mpf("3e-4"))
    closure = f"forward(inverse) closes to {mp.nstr(worst, 2)}"
    closure += "." if exact_pair else " on these rows: the published pair is an approximation, that is not an error of this file."
    write(name, "inverse", title, "face, x, y -> exact unit vector", closure,
          ["face", "x", "y", "vx", "vy", "vz", "class"], rows)


# ---- checks of the maps themselves ---------------------------------------------------------------

def tangents(inverse, x, y, h=mpf(10) ** -35):
    """d/dx and d/dy of the unit vector, central differences (error about h^2)."""
    def d(x1, y1, x0, y0):
        return tuple((a - b) / (2 * h) for a, b in zip(unit(inverse(x1, y1)), unit(inverse(x0, y0))))
    return d(x + h, y, x - h, y), d(x, y + h, x, y - h)


def cross(a, b):
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def near(a, b, tolerance, what):
    assert abs(a - b) < tolerance, (what, a, b)


POINTS = [(mpf(a) / 16, mpf(b) / 16) for a, b in ((3, 2), (11, 7), (5, 13), (-9, 14), (-15, -4), (2, -7))]


def check_vertex(forward, inverse):
    """Equal area: the Jacobian is pi/6 everywhere. Edges meet edges; edge midpoints and corners stay."""
    for x, y in POINTS:
        a, b = tangents(inverse, x, y)
        near(dot(cross(a, b), unit(inverse(x, y))), mp.pi / 6, 1e-60, "area")
    for t in (-0.9, 0.25, 0.5, 1):
        p = inverse(ONE, mpf(t))
        near(p[0], p[2], TINY, "edge")
    near(inverse(ONE, mpf(0))[0], 1 / mp.sqrt(2), TINY, "edge midpoint")


def check_conformal(forward, inverse):
    c = Conformal()
    near(c.I, mp.quad(lambda t: (1 - t ** 4) ** (-ONE / 4) * (1 + t ** 4 / 8) ** (-ONE / 4), [0, 0.5, 1]), 1e-25, "I")
    near(c.I, mpf("1.10243939899658277"), 1e-17, "I as published")
    # Centre, edge midpoint, and where they lie in W.
    near(c.z_of_w(c.w_of_point((0, 0, ONE))), mpc(ONE / 2, ONE / 2), TINY, "centre")
    near(c.z_of_w(c.w_of_point((0, ONE, ONE))), ONE / 2, TINY, "edge midpoint")
    near(c.w_of_point((0, 0, ONE)) ** 3, -(mp.sqrt(3) - 1) ** 3, TINY, "W of centre")
    near(c.w_of_point((-ONE, ONE, ONE)) ** 3, 1, TINY, "W of the adjacent corner")
    near(c.w_of_point((-ONE, -ONE, ONE)) ** 3, -8, TINY, "W of the opposite corner of the face")
    # Edges go to edges, diagonals to diagonals.
    near(c.z_of_w(c.w_of_point((ONE / 3, ONE, ONE))).imag, 0, TINY, "edge")
    near(c.z_of_w(c.w_of_point((ONE, ONE / 3, ONE))).real, 0, TINY, "edge")
    z = c.z_of_w(c.w_of_point((ONE / 3, ONE / 3, ONE)))
    near(z.real, z.imag, TINY, "diagonal")
    # The integral itself, z = I^-1 w^(3/4) integral of f(s^4 W) over s in [0, 1], against the series.
    for P in ((ONE / 5, ONE / 3, ONE), (ONE / 2, ONE / 9, ONE), (mpf(7) / 8, mpf(6) / 7, ONE)):
        w = c.w_of_point(P)
        z = w ** (mpf(3) / 4) / c.I * mp.quad(lambda s: c.f(s ** 4 * w ** 3), mp.linspace(0, 1, 5))
        near(c.z_of_w(w), z, 1e-80, "quadrature")
    # Past the fold the series of this corner agrees with that of the neighbouring corner (|W| < 1 still).
    for X, Y in ((-0.1, 0.4), (-0.2, 0.9), (0.3, -0.05), (-0.03, -0.04)):
        z = c.z_of_w(c.w_of_point((mpf(X), mpf(Y), ONE)))
        x, y = c.forward(mpf(X), mpf(Y), ONE)
        near(z, mpc(1 - x, 1 - y) / 2, 1e-40, "fold")
    # Conformal, and not mirrored.
    for x, y in POINTS:
        a, b = tangents(inverse, x, y)
        near(dot(a, b), 0, 1e-60, "right angle")
        near(dot(a, a), dot(b, b), 1e-60, "equal scale")
        assert dot(cross(a, b), inverse(x, y)) > 0


def check_cobe(forward, inverse):
    """The published pair misses by at most about 2.9e-4."""
    worst, n = mpf(0), 60
    mp.dps, keep = 20, mp.dps
    for i in range(n + 1):
        for j in range(n + 1):
            x, y = mpf(i) / n, mpf(j) / n
            X, Y, Z = inverse(x, y)
            x1, y1 = forward(X, Y, Z)
            worst = max(worst, abs(x1 - x), abs(y1 - y))
    mp.dps = keep
    print(f"cobe-published: forward(inverse) misses by up to {mp.nstr(worst, 4)}")
    assert mpf("2.5e-4") < worst < mpf("3.1e-4")


def check_continuous(forward, inverse):
    """All edges are the same: so faces agree, whichever way x and y are."""
    for t in (-0.9, 0.25, 0.5, 1):
        near(inverse(ONE, mpf(t))[1], inverse(mpf(t), ONE)[0], TINY, "edge")


def check_arvo(forward, inverse):
    """Equal area; edges x = 1 and y = 1 differ."""
    for x, y in POINTS:
        a, b = tangents(inverse, x, y)
        near(dot(cross(a, b), unit(inverse(x, y))), mp.pi / 6, 1e-60, "area")
    near(inverse(ONE / 2, ONE)[0], mpf("0.3933"), 1e-4, "edge y = 1")
    near(inverse(ONE, ONE / 2)[1], mpf("0.4264"), 1e-4, "edge x = 1")


CHECKS = {"continuous": check_continuous, "arvo": check_arvo, "vertex": check_vertex, "conformal": check_conformal, "cobe": check_cobe}


def main():
    for name in sys.argv[1:] or MAPS:
        title, maps = MAPS[name][0], kinds(name)
        if name in CHECKS:
            CHECKS[name](*maps[0])
        if name != "cobe":
            make_forward(name, title, maps)
        make_inverse(name, title, maps, exact_pair=name != "cobe")


if __name__ == "__main__":
    main()
