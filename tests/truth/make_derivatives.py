#!/usr/bin/env python3
"""High-precision derivatives of the functions of num-traits' Float: writes derivatives.tsv next to itself.

No formula of a derivative is used: mpmath differentiates each function by differences with 120 digits.
Needs mpmath, nothing else. The same file comes out of every run. README.md has the conventions.
"""

import os
import struct

from mpmath import mp, mpf

mp.dps = 120

ANY = (-300.0, -40.0, -5.0, -1.25, -0.7, -1e-3, 1e-20, 0.1, 0.9, 1.0, 2.5, 30.0, 80.0)
POSITIVE = (1e-30, 1e-5, 0.1, 0.99, 1.0, 1.01, 3.0, 100.0, 1e20)
UNIT = (-0.9999, -0.75, -0.1, -1e-10, 1e-20, 1e-3, 0.5, 0.99, 0.999999)
MODEST = tuple(x for x in ANY if abs(x) < 85)

ONE = {
    "recip": (lambda x: 1 / x, ANY),
    "sqrt": (mp.sqrt, POSITIVE),
    "cbrt": (lambda x: mp.sign(x) * mp.cbrt(abs(x)), ANY + (1e30, -1e-30)),
    "exp": (mp.exp, MODEST),
    "exp2": (lambda x: mpf(2) ** x, MODEST),
    "exp_m1": (mp.expm1, MODEST),
    "ln": (mp.log, POSITIVE),
    "ln_1p": (mp.log1p, (-0.999, -0.5, -1e-10, 1e-20, 1e-3, 1.0, 1e10)),
    "log2": (lambda x: mp.log(x, 2), POSITIVE),
    "log10": (mp.log10, POSITIVE),
    "to_degrees": (mp.degrees, ANY),
    "to_radians": (mp.radians, ANY),
    "sin": (mp.sin, ANY),
    "cos": (mp.cos, ANY),
    "tan": (mp.tan, ANY + (1.5707, 1.5708)),
    "asin": (mp.asin, UNIT),
    "acos": (mp.acos, UNIT),
    "atan": (mp.atan, ANY + (1e15,)),
    "sinh": (mp.sinh, MODEST),
    "cosh": (mp.cosh, MODEST),
    "tanh": (mp.tanh, tuple(x for x in ANY if abs(x) < 35)),
    "asinh": (mp.asinh, ANY + (1e25,)),
    "acosh": (mp.acosh, (1.0000001, 1.001, 1.5, 10.0, 1e25)),
    "atanh": (mp.atanh, UNIT),
}

PAIRS = [(a, b) for a in (-3.5, -0.2, 1e-5, 0.75, 20.0) for b in (-7.0, -0.5, 1e-4, 1.5, 12.0)]
BASES = [(a, b) for a in (1e-10, 0.3, 1.125, 50.0) for b in (0.25, 1.5, 10.0)]
POWERS = [(a, b) for a in (1e-3, 0.4, 1.0, 1.75, 9.0) for b in (-6.0, -0.5, 1e-3, 1.0, 2.5, 11.0)]

TWO = {
    "powf": (lambda x, y: x ** y, POWERS),
    "log": (lambda x, y: mp.log(x) / mp.log(y), BASES),
    "hypot": (mp.hypot, PAIRS),
    "atan2": (mp.atan2, PAIRS),
}

POWI = [(x, n) for x in (-3.0, -0.7, 0.2, 1.0, 1.5) for n in (-7, -2, -1, 1, 2, 3, 12)]


def single(x):
    """The nearest binary32: the same table serves both precisions."""
    return struct.unpack("f", struct.pack("f", x))[0]


def derivative(f, x):
    x = mpf(x)
    return mp.diff(f, x, h=abs(x) * mpf(10) ** -45 if x else mpf(10) ** -45)


def decimal(x):
    return mp.nstr(x, 25, strip_zeros=False)


rows = []
for name, (f, places) in ONE.items():
    for x in map(single, places):
        rows.append((name, repr(x), "", decimal(derivative(f, x)), ""))
for name, (f, places) in TWO.items():
    for x, y in places:
        x, y = single(x), single(y)
        by_x = derivative(lambda u: f(u, mpf(y)), x)
        by_y = derivative(lambda v: f(mpf(x), v), y)
        rows.append((name, repr(x), repr(y), decimal(by_x), decimal(by_y)))
for x, n in POWI:
    x = single(x)
    rows.append(("powi", repr(x), str(n), decimal(derivative(lambda u: u ** n, x)), ""))

with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "derivatives.tsv"), "w", newline="\n") as out:
    print(f"# Derivatives of functions of one and two arguments, by differences with {mp.dps} digits (make_derivatives.py).",
          "# Arguments are binary32 numbers. Without y a function of one argument.", "function\tx\ty\tby x\tby y", sep="\n", file=out)
    for row in rows:
        print(*row, sep="\t", file=out)
