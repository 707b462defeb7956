#!/usr/bin/env python3
"""Writes grid_geoconvert.tsv: what GeographicLib 2.1.2's program GeoConvert says of places. See README.md."""

import random
import subprocess


def convert(options, lines):
    text = "\n".join(lines) + "\n"
    return subprocess.run(["GeoConvert", *options], input=text, capture_output=True, text=True, check=True).stdout.splitlines()


def main():
    rng = random.Random(37)
    places = []
    # Borders of zones and bands, exactly on them and next to them; Norway, Svalbard, the polar regions, the equator.
    for lat in (0.0, -0.0, 1e-9, -1e-9, 8.0, -8.0, 55.999, 56.0, 63.999, 64.0, 71.999, 72.0, 83.999, 84.0, 84.5, -79.999, -80.0, -80.001, 89.9999):
        for lon in (0.0, 2.9999, 3.0, 6.0, 9.0, 21.0, 33.0, 42.0, 180.0, -180.0, 179.9999, -177.0):
            if rng.random() < 0.5 or lat in (56.0, 72.0, 84.0, -80.0):
                places.append((lat, lon))
    places += [(90.0, 0.0), (-90.0, 0.0), (90.0, -170.0), (-90.0, 45.0), (40.0, 0.25), (-34.0, 18.5)]
    places += [(rng.uniform(-80, 84), rng.uniform(-180, 180)) for _ in range(90)]
    places += [(rng.choice((1, -1)) * rng.uniform(80, 90), rng.uniform(-180, 180)) for _ in range(30)]
    # Where parallels run through two rows of squares.
    places += [(lat + rng.uniform(-0.02, 0.02), rng.uniform(0, 12)) for lat in (64, 72, -64, -72) for _ in range(8)]
    places = [(round(lat, 12), round(lon, 12)) for lat, lon in places]
    lines = [f"{lat:.12f} {lon:.12f}" for lat, lon in places]
    grid = convert(["-u", "-p", "9"], lines)
    scale = convert(["-c", "-p", "9"], lines)
    texts = [convert(["-m", "-p", str(p)], lines) for p in (-5, 0, 6)]
    with open("grid_geoconvert.tsv", "w") as out:
        out.write("# What GeographicLib's GeoConvert says of places on WGS84: positions in UTM and UPS, convergence and scale, MGRS.\n")
        out.write("# Made by make_geoconvert.py with GeographicLib 2.1.2; inputs are binary64.\n")
        out.write("lat\tlon\tzone\themisphere\teasting\tnorthing\tconvergence\tscale\tmgrs0\tmgrs5\tmgrs11\n")
        for place, position, local, *squares in zip(places, grid, scale, *texts):
            zone, easting, northing = position.split()
            cells = [repr(place[0]), repr(place[1]), zone[:-1] or "0", zone[-1], easting, northing, *local.split(), *squares]
            out.write("\t".join(cells) + "\n")


main()
