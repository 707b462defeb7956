"""Seeds for the fuzz targets, from the truth: python3 seeds.py DIRECTORY writes DIRECTORY/TARGET/*.

A seed is the bytes that crates/testkit/src/bytes.rs reads: the property and the scalar, then numbers as any bits.
"""

import pathlib
import re
import struct
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
EVERY = 23  # rows of a file are taken by this step


def rows(name):
    lines = (ROOT / "tests/truth" / f"{name}.tsv").read_text().splitlines()
    lines = [line.split("\t") for line in lines if not line.startswith("#")]
    return [dict(zip(lines[0], line)) for line in lines[1::EVERY]]


def properties(target):
    batch = "crates/slices/tests/slices/batch/mod.rs"
    text = (ROOT / (batch if target == "batch" else f"tests/properties/{target}.rs")).read_text()
    return re.search(r"properties! \{([\w\s]*)\}", text)[1].split()


class Seeds:
    def __init__(self, directory, target):
        self.directory = pathlib.Path(directory) / target
        self.directory.mkdir(parents=True, exist_ok=True)
        self.properties = properties(target)
        self.count = 0

    def add(self, property, parts):
        """For both scalars: `parts` are small numbers and the texts of any others."""
        for single in (0, 1):
            bytes_ = bytes([2 * self.properties.index(property) + single])
            for part in parts:
                bytes_ += bytes([part]) if isinstance(part, int) else raw(part, single)
            (self.directory / f"seed-{property}-{self.count:04}").write_bytes(bytes_)
            self.count += 1


class Any(str):
    """A number for `anything`."""


def raw(text, single):
    """A number as its bits: what `within` takes them for, or `anything`."""
    value = float(text)
    bits = struct.pack("<f", value) + bytes(4) if single else struct.pack("<d", value)
    return bytes([0 if isinstance(text, Any) else 3]) + bits


def vector(*components):
    """A direction by its components: `anything` of any bits, each followed by a sign."""
    return [7, *(part for component in components for part in (Any(component), 0))]


# In the order of the list, each with the name that its own file gives.
LIST = ROOT / "src/cube/projection"
PROJECTIONS = [
    re.search(rf'^    {kind} "([\w-]+)" \{{', (LIST / f"{module}.rs").read_text(), re.M)[1]
    for module, kind in re.findall(r"^    (\w+)::(\w+),$", (LIST / "mod.rs").read_text(), re.M)
]
# Of the methods, those that need no place.
METHODS = len(re.findall(r"^    \w+::\w+ \|\w+\|", (ROOT / "src/geodesic/mod.rs").read_text(), re.M))
EARTH, SPHERE, LEAST, MOST = 0, 3, 4, 5


def main(directory):
    seeds = Seeds(directory, "projection")
    edges = Seeds(directory, "edges")
    for path in sorted((ROOT / "tests/truth").glob("cube_*_forward.tsv")):
        name = path.stem.split("_")[1]
        projection = PROJECTIONS.index(name)
        for row in rows(path.stem):
            # The paper's axes, in the order of the Earth's.
            direction = vector(row["vz"], row["vx"], row["vy"])
            seeds.add("forward_is_true", [projection, *direction])
            edges.add("step", [projection, 0, *direction, 1, 255, 1])
        for row in rows(f"cube_{name}_inverse"):
            point = [int(row["face"]), row["x"], 0, row["y"], 0]
            seeds.add("inverse_is_true", [projection, *point])
    for row in rows("geod_inverse_wgs84"):
        for shift in range(6):
            seeds.add("ellipsoid", [5, shift, EARTH, row["lat1"], row["lon1"]])

    seeds = Seeds(directory, "geodesic")
    for name, ellipsoid in [("wgs84", EARTH), ("moon", SPHERE), ("oblate10", MOST), ("prolate150", LEAST)]:
        for row in rows(f"geod_inverse_{name}"):
            pair = [0, row["lat1"], row["lon1"], row["lat2"], row["lon2"]]
            seeds.add("inverse", [ellipsoid, *pair])
            seeds.add("lengths", [ellipsoid, *pair])
            for method in range(METHODS):
                seeds.add("methods_inverse", [method, ellipsoid, *pair])
        for row in rows(f"geod_direct_{name}"):
            line = [row["lat1"], row["lon1"], 0, row["azi1"], 5, row["s12"]]
            seeds.add("direct", [ellipsoid, *line])

    seeds = Seeds(directory, "position")
    for row in rows("kernel_direction"):
        seeds.add("to_direction", [row["lat"], row["lon"]])
    for row in rows("kernel_lat_lon"):
        seeds.add("to_lat_lon", vector(row["x"], row["y"], row["z"]))
    for row in rows("ecef_forward_wgs84"):
        seeds.add("to_ecef", [EARTH, row["lat"], row["lon"], 4, row["h"]])
    for row in rows("ecef_reverse_wgs84"):
        seeds.add("to_geodetic", [EARTH, 0, 3, row["X"], row["Y"], row["Z"]])
    for row in rows("auxlat_wgs84_rad"):
        for kind in range(7):
            seeds.add("latitudes_are_true", [EARTH, kind, row["phi"]])

    seeds = Seeds(directory, "healpix")
    for row in rows("healpix_pixels"):
        seeds.add("containing", [row["lat"], row["lon"], 29])
    for row in rows("healpix_places"):
        depth, number = int(row["depth"]), int(row["pixel"])
        base, rest = number >> 2 * depth, number % (1 << 2 * depth)
        pixel = [depth, base, *rest.to_bytes(8, "little"), 0, 0]
        seeds.add("numbers", [30, *[0] * 9, *pixel])
        seeds.add("neighbours", pixel)
        seeds.add("place_is_true", [*pixel, row["dx"], row["dy"]])

    seeds = Seeds(directory, "legs")
    for row in rows("closest"):
        leg = [0, row["lat1"], row["lon1"], row["lat2"], row["lon2"], 0, row["lat"], row["lon"]]
        seeds.add("closest_on_ellipsoid", [EARTH, *leg])
        seeds.add("closest_on_sphere", leg)

    seeds = Seeds(directory, "batch")
    for row in rows("geod_inverse_wgs84"):
        pair = [0, 0, row["lat1"], row["lon1"], row["lat2"], row["lon2"]]
        seeds.add("inverses", [1, EARTH, 100, 0, 1, *[0] * 8, 0, *pair])

    seeds = Seeds(directory, "validation")
    for row in rows("kernel_direction"):
        seeds.add("lat_lon", [Any(row["lat"]), 0, Any(row["lon"]), 0])
    for row in rows("kernel_lat_lon"):
        seeds.add("direction", vector(row["x"], row["y"], row["z"])[1:])


if __name__ == "__main__":
    main(sys.argv[1])
