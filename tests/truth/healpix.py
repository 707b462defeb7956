"""Formulas of standard HEALPix with mpmath, for the scripts that write its files."""

from mpmath import asin, degrees, floor, mp, mpf, radians, sin, sqrt

mp.dps = 60
DEPTH = 29


def plane(lat, lon):
    """Calabretta & Roukema 2007, in units of pi/4; x in [0, 8)."""
    z, x = sin(radians(mpf(lat))), (mpf(lon) % 360) / 45
    if abs(lat) == 90:
        z = mpf(lat) / 90
    if abs(z) <= mpf(2) / 3:
        return x, 3 * z / 2
    sigma = sqrt(3 * (1 - abs(z)))
    tip = 2 * floor(x / 2) + 1  # on a meridian between two quarters, the eastern one
    return tip + (x - tip) * sigma, (2 - sigma) * (1 if z > 0 else -1)


def interleaved(x, y):
    return sum((x >> k & 1) << 2 * k | (y >> k & 1) << 2 * k + 1 for k in range(DEPTH))


def pixel(lat, lon):
    """The pixel, and how far the place is from its edges, in pixels."""
    x, y = plane(lat, lon)
    for base in range(12):
        row, column = divmod(base, 4)
        cx, cy = (2 * column + (row != 1), 1 - row)
        dx = (x - cx + 4) % 8 - 4
        a, b = (dx + (y - cy) + 1) / 2, (-dx + (y - cy) + 1) / 2
        # A cap's quarter is its base pixel's, edges included; elsewhere western and southern edges are.
        cap = abs(y) > 1
        if 0 <= a < 1 and 0 <= b < 1 if not cap else (row, column) == (0 if y > 0 else 2, int(floor(x / 2))):
            a, b = a * 2**DEPTH, b * 2**DEPTH
            margin = min(abs(v - mp.nint(v)) for v in (a, b))
            a, b = (max(0, min(2**DEPTH - 1, int(floor(v)))) for v in (a, b))
            return base << 2 * DEPTH | interleaved(a, b), margin
    raise ValueError((lat, lon))


def place(number, depth, dx, dy):
    base, rest = divmod(number, 4**depth)
    a, b = (sum((rest >> 2 * k + s & 1) << k for k in range(depth)) for s in (0, 1))
    a, b = ((i + mpf(d)) / 2**depth for i, d in ((a, dx), (b, dy)))
    row, column = divmod(base, 4)
    x, y = 2 * column + (row != 1) + a - b, 1 - row + a + b - 1
    if abs(y) <= 1:
        lat, lon = asin(2 * y / 3), x * 45
    else:
        sigma = 2 - abs(y)
        # 1 - sigma^2 / 3 by its complement: asin has not the digits near 1.
        lat = (mp.pi / 2 - 2 * asin(sigma / sqrt(mpf(6)))) * (1 if y > 0 else -1)
        tip = 2 * column + 1
        lon = 45 * (tip + ((x - tip) / sigma if sigma else 0))
    lon = lon % 360
    return degrees(lat), lon if lon <= 180 else lon - 360
