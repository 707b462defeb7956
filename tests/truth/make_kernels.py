#!/usr/bin/env python3
"""High-precision truth for elementary functions: writes kernel_<name>.tsv next to itself.

    python3 make_kernels.py              all files
    python3 make_kernels.py atan cbrt    only these

Needs mpmath, nothing else. The same files come out of every run. README.md has the conventions.
"""

import math
import os
import random
import struct
import sys

from mpmath import mp, mpf

mp.dps = 100
SEED = 6113
HERE = os.path.dirname(os.path.abspath(__file__))
TINY = [m * s for m in (1e-300, 1e-200, 1e-100, 1e-50, 1e-20, 1e-15, 1e-10, 1e-8, 3e-8, 1e-5, 1e-4) for s in (1.0, -1.0)]


# ---- inputs ------------------------------------------------------------------------------------

def f32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def log_uniform(rng, lo, hi):
    return math.exp(rng.uniform(math.log(lo), math.log(hi)))


def around(rng, x):
    """The binary64 next to x, its neighbours, and points about 1e-12, 1e-9, 1e-6, 1e-3 away."""
    x = float(x)
    d = 10.0 ** rng.choice((-12, -9, -6, -3))
    return [x, math.nextafter(x, math.inf), math.nextafter(x, -math.inf), x * (1 + rng.uniform(-3, 3) * d)]


def tag(values, cls):
    return [(float(v), cls) for v in values]


def f32_rows(rng, draw, count=100):
    return [(f32(draw(rng)), "f32") for _ in range(count)]


# ---- output ------------------------------------------------------------------------------------

def decimal(x):
    """Shortest decimal of a binary64."""
    s = repr(float(x))
    return s[:-2] if s.endswith(".0") else s


def digits(x):
    """25 significant digits; integers as such."""
    if x == mp.floor(x) and abs(x) < 10 ** 15:
        return str(int(x))
    return mp.nstr(x, 25, strip_zeros=False)


def write(name, what, checked, columns, rows):
    path = os.path.join(HERE, f"kernel_{name}.tsv")
    head = [
        f"# {what}",
        f"# Tool: mpmath with {mp.dps} working digits (make_kernels.py, seed {SEED}); 25 significant digits.",
        "# Inputs are shortest round-trip decimals of binary64 values; truth is computed from exactly those binary64 values.",
        f"# Checked: {checked}",
        "\t".join(columns),
    ]
    with open(path, "w", encoding="ascii", newline="\n") as out:
        out.write("\n".join(head + ["\t".join(r) for r in rows]) + "\n")
    print(f"{os.path.basename(path)}: {len(rows)} rows; {checked}", flush=True)


def relative(a, b):
    return abs(a - b) / abs(b) if b else abs(a)


def worst(differences):
    w = max(differences)
    assert w < mpf(10) ** -80, w
    return mp.nstr(w, 2)


def table(inputs, function, inverse):
    """Rows (input, truth, class) of a function of one variable, and how well its inverse closes."""
    rows, differences = [], []
    for x, cls in inputs:
        y = function(mpf(x))
        differences.append(relative(inverse(y), mpf(x)))
        rows.append([decimal(x), digits(y), cls])
    return rows, worst(differences)


# ---- the kernels -------------------------------------------------------------------------------

def sin_cos_rows(inputs, radians):
    rows, differences = [], []
    for x, cls in inputs:
        a = radians(mpf(x))
        # What is this small away from zero is an exact zero (a multiple of 90 degrees), or 1, or 1/2.
        snap = lambda v: mp.nint(2 * v) / 2 if abs(x) > 1 and abs(2 * v - mp.nint(2 * v)) < mpf(10) ** -80 else v
        s, c = snap(mp.sin(a)), snap(mp.cos(a))
        t = mp.tan(a / 2)
        # The half-angle formulas; tan(a/2) is of no use near an odd multiple of 180 degrees.
        half = (2 * t / (1 + t * t), (1 - t * t) / (1 + t * t))
        differences.append(max(abs(s - half[0]), abs(c - half[1])) if c > -0.99 else abs(s * s + c * c - 1))
        rows.append([decimal(x), digits(s), digits(c), cls])
    return rows, f"half-angle formulas agree to {worst(differences)}."


def sin_cos_degrees(rng):
    u = lambda r: r.uniform(-720, 720)
    inputs = [(float(x), "exact") for x in range(-720, 721, 15)]
    inputs += tag([u(rng) for _ in range(190)], "uniform") + tag(TINY, "tiny")
    for _ in range(45):
        inputs += tag([x for x in around(rng, 45 * rng.randint(-15, 15) or 90) if abs(x) <= 720], "near")
    inputs += f32_rows(rng, u, 80) + [(f32(45 * rng.randint(-15, 15) + rng.uniform(-1, 1) * 1e-3), "f32") for _ in range(20)]
    rows, checked = sin_cos_rows(inputs, lambda x: x * mp.pi / 180)
    write("sin_cos_degrees", "Sine and cosine of x degrees, x in [-720, 720]; every multiple of 15", checked,
          ["x", "sin", "cos", "class"], rows)


def sin_cos(rng):
    inputs = tag([rng.uniform(-math.pi, math.pi) for _ in range(150)] + [rng.uniform(-1000, 1000) for _ in range(80)], "uniform")
    inputs += tag(TINY, "tiny") + [(0.0, "exact")]
    for k in [k for k in range(-8, 9) if k] + [rng.randint(9, 1270) * rng.choice((-1, 1)) for _ in range(45)]:
        inputs += tag(around(rng, k * mp.pi / 4), "near")
    inputs += f32_rows(rng, lambda r: r.uniform(-math.pi, math.pi), 60) + f32_rows(rng, lambda r: r.uniform(-1000, 1000), 20)
    inputs += [(f32(rng.randint(-1270, 1270) * math.pi / 4), "f32") for _ in range(20)]
    rows, checked = sin_cos_rows(inputs, lambda x: x)
    write("sin_cos", "Sine and cosine of x radians, x in [-1000, 1000], many in [-pi, pi]", checked, ["x", "sin", "cos", "class"], rows)


def tan(rng):
    top = math.pi / 4  # just below pi/4
    u = lambda r: r.uniform(-top, top)
    inputs = tag([u(rng) for _ in range(300)], "uniform") + tag(TINY, "tiny") + [(0.0, "exact")]
    marks = [top, mp.pi / 8, mp.pi / 12, mp.pi / 16, 0.5, 0.25, 0.67434]
    inputs += tag([s * x for m in marks for s in (1, -1) for _ in range(4) for x in around(rng, m) if x <= top], "near")
    inputs += f32_rows(rng, u)
    rows, closure = table(inputs, mp.tan, mp.atan)
    write("tan", "Tangent of x radians, x in [-pi/4, pi/4]", f"atan(tan) closes to {closure} (relative).", ["x", "tan", "class"], rows)


def atan(rng):
    s = lambda: rng.choice((-1, 1))
    inputs = tag([rng.uniform(-1e6, 1e6) for _ in range(60)] + [rng.uniform(-3, 3) for _ in range(120)], "uniform")
    inputs += tag([s() * log_uniform(rng, 1e-6, 1e6) for _ in range(120)], "log")
    inputs += tag(TINY, "tiny") + tag([s() * log_uniform(rng, 1e6, 1e300) for _ in range(30)] + [1e300, -1e300, 1e6, -1e6], "huge")
    inputs += tag([0, 1, -1], "exact")
    marks = [1, mp.sqrt(2) - 1, mp.sqrt(2) + 1, mp.sqrt(3), 1 / mp.sqrt(3), 2 - mp.sqrt(3), 2 + mp.sqrt(3),
             mpf(7) / 16, mpf(11) / 16, mpf(19) / 16, mpf(39) / 16, 0.5, 1.5, 1 / mp.sqrt(2), mp.sqrt(2)]
    inputs += tag([s() * x for m in marks for _ in range(2) for x in around(rng, m)], "near")
    inputs += f32_rows(rng, lambda r: r.uniform(-3, 3), 60) + f32_rows(rng, lambda r: s() * log_uniform(r, 1e-6, 1e6), 40)
    # tan magnifies by about x near pi/2: the closure of huge x needs as many more digits.
    mp.dps, keep = 420, mp.dps
    rows, closure = table(inputs, mp.atan, mp.tan)
    write("atan", "Arctangent in radians, x in [-1e6, 1e6], and huge and tiny x", f"tan(atan) closes to {closure} (relative).",
          ["x", "atan", "class"], rows)
    mp.dps = keep


def atan2(rng):
    def circle(r, angle, radius=1.0):
        return [radius * math.sin(angle), radius * math.cos(angle)]

    s = lambda: rng.choice((-1, 1))
    turn = lambda: rng.uniform(-math.pi, math.pi)
    inputs = [(*circle(rng, turn(), log_uniform(rng, 1e-3, 1e3)), "uniform") for _ in range(200)]
    for d in (1e-3, 1e-9, 1e-15):
        for _ in range(16):
            a, e = log_uniform(rng, 1e-2, 1e2), d * rng.uniform(0.2, 3)
            inputs += [(s() * a * e, s() * a, "axis"), (s() * a, s() * a * e, "axis"),
                       (s() * a, s() * a * (1 + s() * e), "diag")]
    for _ in range(30):
        small, big = log_uniform(rng, 1e-150, 1e-20), log_uniform(rng, 1e-100, 1e100)
        inputs += [(s() * big, s() * small * big, "ratio"), (s() * small * big, s() * big, "ratio")]
    for scale in (1e-300, 1e-160, 1e160, 1e300):  # squares of these leave the range of binary64
        inputs += [(*circle(rng, turn(), scale), "scale") for _ in range(8)]
    inputs += [(1e200, s() * 1e-200, "scale"), (-1e200, 1e-200, "scale"), (1e-200, -1e200, "scale"), (-1e-200, -1e200, "scale")]
    inputs += [(y, x, "exact") for y in (-1.0, 0.0, 1.0) for x in (-1.0, 0.0, 1.0) if x or y]
    inputs += [(s() * a, s() * a, "exact") for a in (0.1, 3.0, 7e-5, 1e20)]
    inputs += [(0.0, 2.5, "exact"), (0.0, -2.5, "exact"), (2.5, 0.0, "exact"), (-2.5, 0.0, "exact")]
    inputs += [(*(f32(c) for c in circle(rng, turn(), log_uniform(rng, 1e-3, 1e3))), "f32") for _ in range(80)]
    inputs += [(f32(s() * a), f32(s() * a * e), "f32") for a, e in ((rng.uniform(0.1, 2), log_uniform(rng, 1e-7, 1)) for _ in range(20))]
    rows, differences = [], []
    mp.dps, keep = 420, mp.dps
    for y, x, cls in inputs:
        a = mp.atan2(mpf(y), mpf(x))
        r = mp.hypot(mpf(x), mpf(y))
        differences.append(max(abs(mp.sin(a) - mpf(y) / r), abs(mp.cos(a) - mpf(x) / r)))
        degrees = a * 180 / mp.pi
        if abs(degrees - mp.nint(degrees)) < mpf(10) ** -360:
            degrees = mp.nint(degrees)
        rows.append([decimal(y), decimal(x), digits(a), digits(degrees), cls])
    write("atan2", "atan2(y, x) in radians and in degrees, in (-180, 180]; zeros are plus zero",
          f"sine and cosine of it give back y and x over the radius to {worst(differences)}.",
          ["y", "x", "atan2_radians", "atan2_degrees", "class"], rows)
    mp.dps = keep


def cbrt(rng):
    inputs = tag([rng.uniform(1e-3, 1) for _ in range(200)], "uniform") + tag([log_uniform(rng, 1e-300, 1e300) for _ in range(150)], "log")
    inputs += tag([1e-300, 1e-200, 1e-100, 1e-50, 1e-20, 1e-15, 1e-10, 1e-8, 1e300, 2.2250738585072014e-308], "tiny")
    inputs += tag([0, 1, 8, 27, 64, 125, 1000, 0.125, 3.375, 1e15, 8.0 ** 100, 8.0 ** -100, 27 * 8.0 ** -40], "exact")
    for k in (-300, -30, -9, -6, -4, -3, -2, -1, 0, 1, 2, 3, 4, 30, 300):
        inputs += tag(around(rng, 2.0 ** k) + around(rng, 1.5 * 2.0 ** k), "near")
    inputs += f32_rows(rng, lambda r: r.uniform(1e-3, 1), 60) + f32_rows(rng, lambda r: log_uniform(r, 1e-36, 1e36), 40)

    def root(x):
        y = mp.cbrt(x)
        n = mp.nint(2 * y) / 2
        return n if n ** 3 == x else y
    rows, closure = table(inputs, root, lambda y: y ** 3)
    write("cbrt", "Cube root, x from 0 to 1e300, many in [1e-3, 1]", f"cube closes to {closure} (relative).", ["x", "cbrt", "class"], rows)


def exp_m1(rng):
    s = lambda: rng.choice((-1, 1))
    inputs = tag([rng.uniform(-1, 1) for _ in range(150)] + [rng.uniform(-40, 0) for _ in range(60)] + [rng.uniform(0, 709) for _ in range(60)], "uniform")
    inputs += tag([s() * log_uniform(rng, 1e-20, 1) for _ in range(80)], "log") + tag(TINY, "tiny")
    inputs += tag([0, 1, -1, 2, -2, 10, -10, -30, -600, -745, 700, 709.78], "exact")
    for k in [-107, -106, -75, -53, -11, *range(-5, 6), 11, 49, 75, 107, 108, 109, 2045]:
        inputs += tag(around(rng, k * mp.log(2) / 2), "near")
    inputs += f32_rows(rng, lambda r: r.uniform(-2, 2), 80) + f32_rows(rng, lambda r: r.uniform(-17, 88), 40)
    inputs += f32_rows(rng, lambda r: s() * log_uniform(r, 1e-30, 1), 30)
    mp.dps, keep = 500, mp.dps  # -745 is close to the end of the result, -1
    rows, closure = table(inputs, mp.expm1, mp.log1p)
    write("exp_m1", "e^x - 1, x from -745 to 709.78, many in [-1, 1]", f"ln(1 + it) closes to {closure} (relative).",
          ["x", "exp_m1", "class"], rows)
    mp.dps = keep


def log2(rng):
    inputs = tag([rng.uniform(0.5, 2) for _ in range(150)], "uniform") + tag([log_uniform(rng, 1e-300, 1e300) for _ in range(100)], "log")
    inputs += tag([1 + rng.choice((-1, 1)) * log_uniform(rng, 1e-16, 0.5) for _ in range(60)], "near")
    inputs += tag([x for x in TINY if x > 0] + [1.7976931348623157e308, 2.2250738585072014e-308], "extreme")
    inputs += tag([2.0 ** k for k in (-1022, -1000, -149, -126, -10, -3, -2, -1, 0, 1, 2, 3, 10, 127, 1000, 1023)], "exact")
    for k in (-300, -30, -3, -2, -1, 0, 1, 2, 3, 30, 300):
        inputs += tag(around(rng, mpf(2) ** k) + around(rng, mpf(2) ** k * mp.sqrt(2)), "near")
    inputs += f32_rows(rng, lambda r: r.uniform(0.5, 2), 80) + f32_rows(rng, lambda r: log_uniform(r, 1e-36, 1e36), 50)

    def logarithm(x):
        y = mp.log(x, 2)
        n = mp.nint(y)
        return n if mpf(2) ** n == x else y
    rows, closure = table(inputs, logarithm, lambda y: mpf(2) ** y)
    write("log2", "Logarithm to base 2, x from 1e-300 to 1.8e308, many in [1/2, 2]", f"its power of 2 closes to {closure} (relative).",
          ["x", "log2", "class"], rows)


def places(rng):
    """Latitude and longitude in degrees, near and far from poles, equator, antimeridian and the multiples of 45."""
    lat, lon = lambda: math.degrees(math.asin(rng.uniform(-1, 1))), lambda: rng.uniform(-180, 180)
    rows = [(lat(), lon(), "uniform") for _ in range(150)]
    for _ in range(40):
        d = 10.0 ** rng.uniform(-14, -1)
        rows += [(rng.choice((-1, 1)) * (90 - d), lon(), "pole"), (rng.choice((-1, 1)) * d, lon(), "equator"),
                 (lat(), rng.choice((-1, 1)) * (180 - d), "antimeridian"), (lat(), 45 * rng.randint(-3, 3) + d, "near")]
    return rows + [(f32(lat()), f32(lon()), "f32") for _ in range(80)]


def direction(rng):
    rows, differences = [], []
    for lat, lon, cls in places(rng):
        p, q = mp.radians(mpf(lat)), mp.radians(mpf(lon))
        x, y, z = mp.cos(p) * mp.cos(q), mp.cos(p) * mp.sin(q), mp.sin(p)
        differences.append(abs(x * x + y * y + z * z - 1))
        rows.append([decimal(lat), decimal(lon), digits(x), digits(y), digits(z), cls])
    write("direction", "Unit vector (x, y, z) of latitude and longitude in degrees; x through 0 N 0 E, y through 0 N 90 E, z north",
          f"of unit length to {worst(differences)}.", ["lat", "lon", "x", "y", "z", "class"], rows)


def lat_lon(rng):
    rows, differences = [], []
    for lat, lon, cls in places(rng):
        lat, lon = math.radians(lat), math.radians(lon)
        vector = [math.cos(lat) * math.cos(lon), math.cos(lat) * math.sin(lon), math.sin(lat)]
        x, y, z = (mpf(f32(v) if cls == "f32" else v) for v in vector)
        p, q = mp.atan2(z, mp.hypot(x, y)), mp.atan2(y, x)
        r = mp.sqrt(x * x + y * y + z * z)
        differences.append(max(abs(r * mp.cos(p) * mp.cos(q) - x), abs(r * mp.sin(p) - z)))
        rows.append([decimal(x), decimal(y), decimal(z), digits(mp.degrees(p)), digits(mp.degrees(q)), cls])
    write("lat_lon", "Latitude and longitude in degrees of the direction (x, y, z), which has unit length only up to rounding",
          f"cosines and sines give the vector back to {worst(differences)}.", ["x", "y", "z", "lat", "lon", "class"], rows)


KERNELS = {f.__name__: f for f in (sin_cos_degrees, sin_cos, tan, atan, atan2, cbrt, exp_m1, log2, direction, lat_lon)}

if __name__ == "__main__":
    for name in sys.argv[1:] or KERNELS:
        KERNELS[name](random.Random(f"{SEED} {name}"))
