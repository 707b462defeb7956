"""Makes fence.tsv: places beside geodesic edges, for the test whether a place is in a polygon.

An edge starts at lat1 lon1 and goes along a geodesic of WGS84 of the class's length. A place of it is moved at a right
angle to it by `offset` metres, to the left if positive. A third corner lies to the left of the edge. All numbers are
rounded to binary64 only after that, so offsets are true to 5 nm.

Direct geodesics by the integrals of Bessel's auxiliary sphere (Karney 2013, equations 7 and 8), elliptic ones by mpmath,
that of the longitude by quadrature.
"""

import random

from mpmath import asin, atan2, cos, ellipe, floor, hypot, mp, mpf, pi, quad, radians, sin, sqrt

mp.dps = 40
A = mpf(6378137)
F = 1 / mpf("298.257223563")
B = A * (1 - F)
EP2 = F * (2 - F) / (1 - F) ** 2


def direct(lat, lon, azimuth, distance):
    """Latitude, longitude and azimuth in degrees of the end of a line."""
    tan_beta = (1 - F) * mp.tan(radians(lat))
    beta = mp.atan(tan_beta)
    alpha = radians(azimuth)
    sin0 = sin(alpha) * cos(beta)
    cos0 = hypot(cos(alpha), sin(alpha) * sin(beta))
    sigma1 = atan2(sin(beta), cos(alpha) * cos(beta))
    omega1 = atan2(sin0 * sin(beta), cos(alpha) * cos(beta))
    k2 = EP2 * cos0**2
    start = ellipe(sigma1, -k2)
    sigma = sigma1 + distance / B
    for _ in range(60):
        step = (ellipe(sigma, -k2) - start - distance / B) / sqrt(1 + k2 * sin(sigma) ** 2)
        sigma -= step
        if abs(step) < 1000 * mp.eps:
            break
    else:
        raise ArithmeticError((lat, lon, azimuth, distance))
    sin_beta = cos0 * sin(sigma)
    cos_beta = hypot(sin0, cos0 * cos(sigma))
    omega = atan2(sin0 * sin(sigma), cos(sigma))
    integral = quad(lambda s: (2 - F) / (1 + (1 - F) * sqrt(1 + k2 * sin(s) ** 2)), mp.linspace(sigma1, sigma, 5))
    turn = mp.degrees(omega - omega1 - F * sin0 * integral)
    lon2 = lon + turn
    lon2 -= 360 * floor((lon2 + 180) / 360)
    lat2 = mp.degrees(atan2(sin_beta, (1 - F) * cos_beta))
    return lat2, lon2, mp.degrees(atan2(sin0, cos0 * cos(sigma)))


def check():
    """The quadrant of a meridian and of the equator; there and back."""
    lat, lon, _ = direct(mpf(0), mpf(0), mpf(90), pi * A / 2)
    assert abs(lat) < mpf(10) ** -35 and abs(lon - 90) < mpf(10) ** -35, (lat, lon)
    lat, _, _ = direct(mpf(0), mpf(0), mpf(0), B * ellipe(pi / 2, -EP2))
    assert abs(lat - 90) < mpf(10) ** -17
    lat, lon, azimuth = direct(mpf(35), mpf(20), mpf(70), mpf(9000000))
    back = direct(lat, lon, azimuth, mpf(-9000000))
    assert abs(back[0] - 35) < mpf(10) ** -33 and abs(back[1] - 20) < mpf(10) ** -33


LENGTHS = {"field": (10, 5e3), "leg": (5e3, 5e5), "long": (5e5, 1e7), "far": (1e7, 1.6e7)}


def rows():
    rng = random.Random(20)
    for kind in ("any", "polar", "dateline", "meridian", "equator"):
        for name, (least, most) in LENGTHS.items():
            for offset in ("0", "1e-6", "-1e-6", "1e-3", "-1e-3", "1", "-1"):
                for _ in range(2):
                    lat = mp.degrees(asin(rng.uniform(-0.99, 0.99)))
                    lon, azimuth = rng.uniform(-180, 180), rng.uniform(-180, 180)
                    if kind == "polar":
                        lat = rng.choice((-1, 1)) * (90 - 10 ** rng.uniform(-4, 0.5))
                    elif kind == "dateline":
                        lon = 180 - 10 ** rng.uniform(-4, 1)
                        azimuth = abs(azimuth)
                    elif kind == "meridian":
                        azimuth = rng.choice((0, 180)) + rng.choice((0, 1)) * 10 ** rng.uniform(-6, -3)
                    elif kind == "equator":
                        lat = rng.choice((0, 1)) * 10 ** rng.uniform(-6, -3)
                        azimuth = rng.choice((90, -90))
                    lat, lon, azimuth = mpf(lat), mpf(lon), mpf(azimuth)
                    length = mpf(least) * (mpf(most) / least) ** rng.random()
                    part = rng.choice((rng.uniform(0.02, 0.98), 10 ** rng.uniform(-3, -1)))
                    here = direct(lat, lon, azimuth, length * mpf(part))
                    end = direct(lat, lon, azimuth, length)
                    third = direct(*here[:2], here[2] - 90, min(length, mpf(2000000)) * mpf("0.3"))
                    place = here if offset == "0" else direct(*here[:2], here[2] - 90, mpf(offset))
                    numbers = [lat, lon, *end[:2], *third[:2], *place[:2]]
                    yield [repr(float(x)) for x in numbers] + [offset, f"{kind}_{name}"]


if __name__ == "__main__":
    check()
    with open("fence.tsv", "w") as file:
        print("# make_fence.py: mpmath, 40 digits; direct geodesics close to 1e-33 degrees", file=file)
        print("lat1 lon1 lat2 lon2 lat3 lon3 lat lon offset class".replace(" ", "\t"), file=file)
        for row in rows():
            print("\t".join(row), file=file)
