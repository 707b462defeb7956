"""What the package promises, next to pyproj, pymap3d and the truth."""

import csv
import decimal
import doctest
import importlib
import pathlib
import pkgutil
import warnings

import numpy as np
import pyproj
import pytest
import terrella
from hypothesis import given, settings
from hypothesis import strategies as st

TRUTH = pathlib.Path(__file__).parents[3] / "tests" / "truth"
RNG = np.random.default_rng(1)
COUNT = 70_000  # more than one thread's


def places(count=COUNT):
    return np.degrees(np.arcsin(RNG.uniform(-1, 1, count))), RNG.uniform(-180, 180, count)


def rows(name):
    lines = [line for line in (TRUTH / f"{name}.tsv").read_text().splitlines() if not line.startswith("#")]
    return list(csv.DictReader(lines, delimiter="\t"))


def column(table, name):
    return np.array([float(row[name]) for row in table])


def errors(computed, table, name):
    """From all digits of both."""
    with decimal.localcontext(prec=60):
        return np.array([float(abs(decimal.Decimal(float(x)) - decimal.Decimal(row[name]))) for x, row in zip(computed, table)])


def claim(row):
    """The README's for f64."""
    readme = (TRUTH.parents[1] / "README.md").read_text()
    (line,) = [line for line in readme.splitlines() if line.startswith(f"| {row} |")]
    return float(line.split("|")[3])


def test_distances_are_the_truths():
    table = rows("geod_inverse_wgs84")
    given = {name: column(table, name) for name in ("lat1", "lon1", "lat2", "lon2")}
    worst = errors(terrella.Geodesic().distance(**given), table, "s12").max()
    assert len(table) == 3000 and worst <= claim("Karney inverse, distance")


def test_earth_axes_are_the_truths():
    table = [row for row in rows("ecef_forward_wgs84") if abs(float(row["h"])) <= 1e5]
    points = terrella.geodetic_to_ecef(lat=column(table, "lat"), lon=column(table, "lon"), height=column(table, "h"))
    worst = np.max([errors(axis, table, name) for axis, name in zip(points, "XYZ")])
    assert len(table) > 1000 and worst <= claim("Ellipsoid::to_ecef below 100 km")


@pytest.mark.parametrize("ellps", ["WGS84", "clrk66", "sphere-like"])
def test_geod_is_pyprojs(ellps):
    kwargs = {"a": 6371000.0, "f": 0.0} if ellps == "sphere-like" else {"ellps": ellps}
    ours, theirs = terrella.Geod(**kwargs), pyproj.Geod(**kwargs)
    (lat1, lon1), (lat2, lon2) = places(2000), places(2000)
    for got, expected, within in zip(ours.inv(lon1, lat1, lon2, lat2), theirs.inv(lon1, lat1, lon2, lat2), (1e-9, 1e-9, 2e-8)):
        assert np.abs(got - expected).max() < within
    az, dist = RNG.uniform(-180, 180, 2000), RNG.uniform(0, 1.9e7, 2000)
    for got, expected in zip(ours.fwd(lon1, lat1, az, dist), theirs.fwd(lon1, lat1, az, dist)):
        assert np.abs(np.mod(got - expected + 180, 360) - 180).max() < 1e-8
    assert np.allclose(ours.npts(1, 2, 30, 40, 5), theirs.npts(1, 2, 30, 40, 5), rtol=0, atol=1e-11)
    got = ours.inv_intermediate(1, 2, 30, 40, del_s=3e5)
    expected = theirs.inv_intermediate(1, 2, 30, 40, del_s=3e5, return_back_azimuth=True)
    assert got.npts == expected.npts and np.allclose(got.lats, expected.lats, rtol=0, atol=1e-11)
    with pytest.raises(ValueError, match="del_s above 0"):
        ours.inv_intermediate(1, 2, 30, 40)
    assert ours.line_length(lon1, lat1) == pytest.approx(theirs.line_length(lon1, lat1), rel=1e-14)
    assert ours.line_lengths([1, 2, 3], [4, 5, 6]) == pytest.approx(theirs.line_lengths([1, 2, 3], [4, 5, 6]), rel=1e-13)
    got, expected = (geod.polygon_area_perimeter([-74, -102, -102, -131, -163, 163, 172, 140, 113, 88, 59, 25, -4, -14, -33, -46, -61], [-72.9, -71.9, -74.9, -74.3, -77.5, -77.4, -71.7, -65.9, -65.7, -66.6, -66.9, -69.8, -70.0, -71.0, -77.3, -77.9, -74.7]) for geod in (ours, theirs))
    assert got == pytest.approx(expected, rel=1e-13)


def test_geods_examples():
    """Those of pyproj's documentation, as they are, of the class Geod."""
    documented = "\n".join(
        doc for doc in [pyproj.Geod.__doc__, *(getattr(pyproj.Geod, name).__doc__ for name in ("__init__", "fwd", "inv", "npts", "line_length", "line_lengths", "polygon_area_perimeter", "geometry_length", "geometry_area_perimeter"))] if doc
    )
    text = documented.replace("from pyproj import Geod", "from terrella import Geod")
    tried = 0
    for name, doc in enumerate(text.split(">>> from terrella import Geod")[1:]):
        test = doctest.DocTestParser().get_doctest(">>> from terrella import Geod" + doc.split('"""')[0], {}, f"geod{name}", None, 0)
        said = []
        tried += doctest.DocTestRunner(optionflags=doctest.ELLIPSIS).run(test, out=said.append).attempted
        assert not said, "".join(said)
    assert tried > 20


def test_kinds_as_pyprojs():
    for kind in (float, list, tuple, np.array):
        args = [8.0, 47.0, 7.0, 46.0] if kind is float else [kind([x]) for x in (8.0, 47.0, 7.0, 46.0)]
        for ours, theirs in zip(terrella.Geod(ellps="WGS84").inv(*args), pyproj.Geod(ellps="WGS84").inv(*args)):
            assert type(ours) is type(theirs)
    radians = np.radians([8.0, 47.0, 7.0, 46.0])
    assert terrella.Geod(ellps="WGS84").inv(*radians, radians=True) == pytest.approx(pyproj.Geod(ellps="WGS84").inv(*radians, radians=True))


def test_threads_do_not_show():
    earth = terrella.Geodesic()
    (lat1, lon1), (lat2, lon2) = places(), places()
    one = earth.inverse(lat1=lat1, lon1=lon1, lat2=lat2, lon2=lon2, threads=1)
    for threads in (2, 3, 7):
        many = earth.inverse(lat1=lat1, lon1=lon1, lat2=lat2, lon2=lon2, threads=threads)
        assert all(np.array_equal(a, b) for a, b in zip(one, many))
    tiles = terrella.Tiles("vertex")
    assert np.array_equal(tiles.key(lat=lat1, lon=lon1, level=20, threads=1), tiles.key(lat=lat1, lon=lon1, level=20, threads=5))
    cube = terrella.CubeMap("adjusted")
    for a, b in zip(cube.project(lat=lat1, lon=lon1, threads=1), cube.project(lat=lat1, lon=lon1, threads=4)):
        assert np.array_equal(a, b)


def test_shapes():
    earth = terrella.Geodesic()
    lat, lon = np.linspace(-80, 80, 5)[:, None], np.linspace(-170, 170, 7)
    assert earth.distance(lat1=lat, lon1=lon, lat2=0, lon2=0).shape == (5, 7)
    assert np.ndim(earth.distance(lat1=1, lon1=2, lat2=3, lon2=4)) == 0
    assert earth.distance(lat1=np.zeros((0, 3)), lon1=0, lat2=0, lon2=0).shape == (0, 3)
    strided = np.arange(20.0).reshape(4, 5)[::2, ::-2]
    assert np.array_equal(earth.distance(lat1=strided, lon1=0, lat2=0, lon2=0), earth.distance(lat1=strided.copy(), lon1=0, lat2=0, lon2=0))
    out = np.empty((5, 7))
    assert earth.distance(lat1=lat, lon1=lon, lat2=0, lon2=0, out=out) is not None and out[0, 0] > 0
    with pytest.raises(ValueError, match="expected contiguous, writeable arrays of shape"):
        earth.distance(lat1=lat, lon1=lon, lat2=0, lon2=0, out=out.T)
    with pytest.raises(ValueError):
        earth.distance(lat1=[1, 2], lon1=[1, 2, 3], lat2=0, lon2=0)


def test_scalars():
    earth = terrella.Geodesic()
    single = np.array([40.6], np.float32)
    assert earth.distance(lat1=single, lon1=single, lat2=0, lon2=0).dtype == np.float32
    assert earth.distance(lat1=[40], lon1=[7], lat2=0, lon2=0).dtype == np.float64  # whole numbers
    with pytest.raises(TypeError, match="complex"):
        earth.distance(lat1=1j, lon1=0, lat2=0, lon2=0)
    with pytest.raises(TypeError):
        earth.distance(1, 2, 3, 4)  # latitude and longitude go by name


def test_missing_and_refused():
    earth = terrella.Geodesic()
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert np.isnan(earth.distance(lat1=[1, np.nan], lon1=0, lat2=0, lon2=0)).tolist() == [False, True]
    with pytest.warns(terrella.RefusedWarning, match=r"1 elements are refused; the first is element 1: latitude 95.0 is not in \[-90, 90\]"):
        distances = earth.distance(lat1=[1, 95], lon1=0, lat2=0, lon2=0)
    assert np.isnan(distances).tolist() == [False, True]
    with pytest.raises(ValueError, match="wgs85"):
        terrella.Geodesic("wgs85")
    with pytest.raises(ValueError, match="0.5"):
        terrella.Geodesic((6e6, 0.5))
    with pytest.warns(terrella.RefusedWarning, match="face 6 is not in 0 to 5"):
        terrella.CubeMap("adjusted").unproject(face=[0, 6], x=0.0, y=0.0)
    # Longitudes of 0 to 360 are the same places; identical pairs are 0 apart.
    assert earth.distance(lat1=1, lon1=350, lat2=1, lon2=-10) == 0


@given(st.floats(-90, 90), st.floats(-180, 180), st.floats(-90, 90), st.floats(-180, 180))
@settings(max_examples=300, deadline=None)
def test_any_pair_as_pyproj(lat1, lon1, lat2, lon2):
    _, _, expected = pyproj.Geod(ellps="WGS84").inv(lon1, lat1, lon2, lat2)
    assert abs(terrella.Geodesic().distance(lat1=lat1, lon1=lon1, lat2=lat2, lon2=lon2) - expected) < 2e-8


@given(st.floats(-90, 90), st.floats(-180, 180), st.floats(-1e4, 1e7))
@settings(max_examples=300, deadline=None)
def test_any_place_there_and_back(lat, lon, height):
    back = terrella.ecef_to_geodetic(**terrella.geodetic_to_ecef(lat=lat, lon=lon, height=height)._asdict())
    assert abs(back.lat - lat) < 1e-13 and abs(back.height - height) < 1e-8


def test_every_method_and_projection():
    for method in terrella.METHODS:
        geodesic = terrella.Geodesic(method=method, about=(47.0, 8.0))
        assert geodesic.distance(lat1=47, lon1=8, lat2=47.01, lon2=8.01) == pytest.approx(1347.0, rel=6e-3)
    lat, lon = places(500)
    assert len(terrella.PROJECTIONS) > 20
    for projection in terrella.PROJECTIONS:
        for shift in ("geodetic", "authalic"):
            cube = terrella.CubeMap(projection, shift=shift)
            points = cube.project(lat=lat, lon=lon)
            assert points.face.dtype == np.uint8
            back = cube.unproject(**points._asdict())
            if projection != "cobe":  # whose published inverse is not its forward map's
                assert np.abs(back.lat - lat).max() < 1e-11
            single = cube.project(lat=lat.astype(np.float32), lon=lon.astype(np.float32))
            assert single.x.dtype == np.float32


def test_whole_numbers_are_not_wrapped():
    tiles, cube = terrella.Tiles("vertex"), terrella.CubeMap("vertex")
    for wrong, message in [(257, "257 is not in 0 to 255"), (-1, "-1 is not in 0 to 255"), (6, "face 6 is not in 0 to 5")]:
        with pytest.raises(ValueError, match=message):
            tiles.key_of(face=wrong, level=3, i=0, j=0)
    with pytest.raises(TypeError, match="whole numbers"):
        tiles.of_key(3.7)
    with pytest.raises(ValueError, match="is not the key of a tile"):
        tiles.of_key(0)
    with pytest.raises(TypeError, match="whole numbers"):
        cube.unproject(face=1.0, x=0.0, y=0.0)
    with pytest.raises(TypeError, match="real numbers"):
        terrella.Geodesic().distance(lat1="1", lon1=0, lat2=0, lon2=0)


def test_masked_misaligned_and_mixed():
    earth = terrella.Geodesic()
    masked = np.ma.array([1.0, 9e9], mask=[False, True])
    assert np.isnan(earth.distance(lat1=masked, lon1=0, lat2=0, lon2=0)).tolist() == [False, True]
    misaligned = np.frombuffer(b"x" + np.arange(3.0).tobytes(), np.float64, 3, 1)
    assert not misaligned.flags.aligned
    assert np.array_equal(earth.distance(lat1=misaligned, lon1=0, lat2=0, lon2=0), earth.distance(lat1=[0, 1, 2], lon1=0, lat2=0, lon2=0))
    single = np.zeros(1, np.float32)
    assert earth.distance(lat1=single, lon1=np.float64(10.125), lat2=0, lon2=0).dtype == np.float64
    assert earth.distance(lat1=single, lon1=10.125, lat2=0, lon2=0).dtype == np.float32
    for threads in (0, -1, 10_000):
        with pytest.raises(ValueError, match="expected 1 to 1024 threads"):
            earth.distance(lat1=1, lon1=0, lat2=0, lon2=0, threads=threads)


def test_refused_among_missing():
    with pytest.warns(terrella.RefusedWarning, match="1 elements are refused; the first is element 1"):
        terrella.Geodesic().distance(lat1=[np.nan, 95, 1], lon1=0, lat2=0, lon2=0)


def test_tiles_and_pixels():
    s2 = terrella.Tiles("s2-quadratic", shift="geodetic")
    cells = s2.cover(south=36.9999, west=126.9999, north=37.0001, east=127.0001, level=20)
    assert [len(cells), hex(cells[0]), hex(cells[-1])] == [13, "0x357b3cd6f8500000", "0x357b3cd6ff300000"]
    lat, lon = places(1000)
    keys = s2.key(lat=lat, lon=lon, level=17)
    assert np.array_equal(s2.key_of(**s2.of_key(keys)._asdict()), keys)
    south, west, north, east = s2.bounds(int(keys[0]))
    assert south <= lat[0] <= north
    with pytest.raises(ValueError, match="more than 10 tiles"):
        s2.cover(south=0, west=0, north=10, east=10, level=10, limit=10)
    with pytest.raises(ValueError, match="level 31"):
        s2.key(lat=0, lon=0, level=31)
    pixels = terrella.Healpix(9)
    numbers = pixels.pixel(lat=lat, lon=lon)
    assert np.array_equal(pixels.pixel(**pixels.centre(numbers)._asdict()), numbers)


def test_grids():
    grid = terrella.MgrsGrid()
    lat, lon = places(300)
    utm = grid.utm(lat=lat, lon=lon)
    back = grid.place(**utm._asdict())
    assert np.abs(back.lat - lat).max() < 1e-12
    here = grid.utm(lat=59.91, lon=10.75)
    transformer = pyproj.Transformer.from_crs(4326, 32632)
    assert (here.easting, here.northing) == pytest.approx(transformer.transform(59.91, 10.75), abs=1e-6)
    assert grid.middle("04QFJ21755677").lat == pytest.approx(21.3088, abs=1e-4)
    with pytest.raises(ValueError, match="XYZ"):
        grid.middle("XYZ")


def test_rings():
    shapely = pytest.importorskip("shapely")
    polygon = shapely.Polygon([(8, 47), (9, 47), (9, 48), (8, 48)], [[(8.4, 47.4), (8.4, 47.6), (8.6, 47.6), (8.6, 47.4)]])
    ours, theirs = terrella.Geod(ellps="WGS84"), pyproj.Geod(ellps="WGS84")
    assert ours.geometry_area_perimeter(polygon) == pytest.approx(theirs.geometry_area_perimeter(polygon), rel=1e-12)
    assert ours.geometry_length(polygon) == pytest.approx(theirs.geometry_length(polygon), rel=1e-12)
    _, coordinates, (offsets, _) = shapely.to_ragged_array([polygon])
    areas, perimeters = terrella.Area().rings(lat=coordinates[:, 1], lon=coordinates[:, 0], offsets=offsets)
    whole = theirs.polygon_area_perimeter(*zip(*polygon.exterior.coords))
    assert areas[0] == pytest.approx(whole[0], rel=1e-12) and perimeters[0] == pytest.approx(whole[1], rel=1e-12)
    with pytest.warns(terrella.RefusedWarning, match="there are no corners 4 to 9"):
        terrella.Area().rings(lat=[0, 1, 2, 3], lon=[0, 1, 0, 2], offsets=[0, 4, 9])


def test_frames_as_pymap3d():
    pymap3d = pytest.importorskip("pymap3d")
    lat, lon = 52 + RNG.uniform(-1, 1, 500), 8 + RNG.uniform(-1, 1, 500)
    height = RNG.uniform(0, 1e4, 500)
    frame = terrella.LocalFrame(lat=52, lon=8, height=110)
    for got, expected in zip(frame.to_enu(lat=lat, lon=lon, height=height), pymap3d.geodetic2enu(lat, lon, height, 52, 8, 110)):
        assert np.abs(got - expected).max() < 1e-7
    back = frame.from_ned(**frame.to_ned(lat=lat, lon=lon, height=height)._asdict())
    assert np.abs(back.lat - lat).max() < 1e-13
    with pytest.warns(terrella.RefusedWarning):
        terrella.LocalFrame(lat=52, lon=8).from_enu(east=np.inf, north=0, up=0)


def test_latitudes():
    lat = np.linspace(-90, 90, 101)
    for target in ("geocentric", "parametric", "authalic", "conformal", "rectifying"):
        other = terrella.convert_latitude(lat, source="geodetic", target=target)
        assert np.abs(terrella.convert_latitude(other, source=target, target="geodetic") - lat).max() < 1e-13


def test_doctests():
    ran = 0
    for module in pkgutil.iter_modules(terrella.__path__):
        if not module.name.startswith("_"):
            failed, tried = doctest.testmod(importlib.import_module(f"terrella.{module.name}"))
            assert failed == 0
            ran += tried
    assert ran > 8
