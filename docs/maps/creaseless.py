#!/usr/bin/env python3
"""The creaseless cube by other means: Runge-Kutta and shooting in double precision, areas as spherical triangles.

    pip install numpy scipy
    python3 creaseless.py

A line of constant x in |y| <= x is the curve phi = f(x) + k(x) z^2 in longitude phi about the axis of Y and height z,
and y is 6/pi times the integral of dphi/dx over z. ../maps.md derives the differential equation of w(x), k(x).
The Rust code and its truth solve another form of it, by collocation.
"""

import numpy as np
from numpy.polynomial.chebyshev import Chebyshev
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

S = 6 / np.pi


def slopes(x, state):
    w, k = state
    q = 1 + 2 * w * w
    z = w / np.sqrt(q)
    slope = 2 * k * z * (1 + w * w) / q**1.5
    r = slope * (1 + w * w) / (1 + slope * w * w)  # du/dv of the line at the diagonal
    dw = np.sqrt(q**1.5 / S * (1 + r) / (1 - r))
    at_end = dw / (1 + w * w) - 2 * k * z * dw / q**1.5  # f' + k' z^2
    on_average = x / (S * z)  # f' + k' z^2/3
    return [dw, 1.5 * (at_end - on_average) / z**2]


def shoot(bow):
    x, slope = 1e-3, 1 / np.sqrt(S)
    third = slope * (1.5 * slope**2 + 2 * bow * slope) / 3
    start = [slope * x + third * x**3, bow * x]
    return solve_ivp(slopes, [x, 1], start, method="DOP853", rtol=1e-12, atol=1e-13, dense_output=True)


def main():
    bow = brentq(lambda b: shoot(b).y[1, -1], 0, 0.2, xtol=1e-13)
    solution = shoot(bow)
    print(f"k'(0) = {bow:.10f}, w(1) - 1 = {solution.y[0, -1] - 1:.1e}, k(1) = {solution.y[1, -1]:.1e}")
    x = np.maximum(np.sqrt((1 - np.cos(np.pi * (np.arange(60) + 0.5) / 60)) / 2), 2e-3)
    w, k = solution.sol(x)
    f = np.arctan(w) - k * w * w / (1 + 2 * w * w)
    F, K = (Chebyshev.fit(x * x, g / x, 13, domain=[0, 1]) for g in (f, k))
    dF, dK = F.deriv(), K.deriv()

    def octant(x, y):
        X = x * x
        a, b = S * (F(X) + 2 * X * dF(X)), S * (K(X) + 2 * X * dK(X)) / 3
        z = y / a
        for _ in range(20):
            z = z - (a * z + b * z**3 - y) / (a + 3 * b * z * z)
        phi, c = x * (F(X) + K(X) * z * z), np.sqrt(1 - z * z)
        return np.stack([c * np.sin(phi), z, c * np.cos(phi)])

    def sphere(x, y):
        steep = abs(y) > abs(x)
        p = octant(abs(np.where(steep, y, x)), abs(np.where(steep, x, y)))
        return np.where(steep, p[[1, 0, 2]], p) * np.stack([np.sign(x), np.sign(y), np.ones_like(x)])

    def triangle(a, b, c):
        volume = (a * np.cross(b, c, axis=0)).sum(0)
        return 2 * np.arctan2(volume, 1 + (a * b).sum(0) + (b * c).sum(0) + (c * a).sum(0))

    for n in (64, 256):
        p = sphere(*np.meshgrid(*[np.linspace(-1, 1, n + 1)] * 2, indexing="ij"))
        a, b, c, d = p[:, :-1, :-1], p[:, 1:, :-1], p[:, 1:, 1:], p[:, :-1, 1:]
        areas = triangle(a, b, c) + triangle(a, c, d)
        print(f"{n}² cells: largest area over smallest {areas.max() / areas.min():.7f}, sum {areas.sum() * 1.5 / np.pi:.12f}")
    h, n = 1e-5, 801
    x, y = np.meshgrid(*[np.linspace(-1 + 1 / n, 1 - 1 / n, n)] * 2)
    a, b = (sphere(x + h, y) - sphere(x - h, y)) / (2 * h), (sphere(x, y + h) - sphere(x, y - h)) / (2 * h)
    singular = np.linalg.svd(np.moveaxis(np.stack([a, b]), [0, 1], [-1, -2]), compute_uv=False)
    most, least = singular[..., 0], singular[..., 1]
    scale, angle = most * least, np.degrees(2 * np.arcsin((most - least) / (most + least)))
    aspect = np.linalg.norm(a, axis=0) / np.linalg.norm(b, axis=0)
    scale = scale[abs(abs(x) - abs(y)) > 2 * h]  # shooting leaves a step of 1e-10 at the diagonals
    print(f"areal scale, largest over smallest - 1: {scale.max() / scale.min() - 1:.1e}")
    print(f"deformation {angle.max():.3f}, rms {np.sqrt(np.mean(angle**2)):.3f}, aspect {aspect.max() / aspect.min():.4f}")
    # One-sided derivatives across the diagonal differ in proportion to the step if there is no jump.
    d = np.linspace(0.1, 0.9, 17)
    for step in (1e-2, 1e-3):
        p = [sphere(d + m * step, d - m * step) for m in range(-2, 3)]
        first = abs(p[4] - 2 * p[2] + p[0]) / (2 * step)
        second = abs((p[4] - 2 * p[3] + p[2]) - (p[2] - 2 * p[1] + p[0])) / step**2
        print(f"step {step}: jump of the first derivative {first.max():.1e}, of the second {second.max():.1e}")



if __name__ == "__main__":
    main()
