// What the types and the README promise of the functions.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { Area } from "terrella/area";
import { CubeMap } from "terrella/cube";
import { Geodesic } from "terrella/geodesic";
import { Geodesic as Inline } from "terrella/geodesic/inline";
import { Ecef, LocalFrame } from "terrella/position";
import { ellipsoids } from "terrella/tables";
import { Tiles } from "terrella/terrain";

/** More rows than two blocks, with a few of another kind. */
const COUNT = 5000;
const random = (() => {
  let state = 1n;
  return () => {
    state = (state * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
    return Number(state >> 11n) / 2 ** 53;
  };
})();
const places = () => ({
  lat: Float64Array.from({ length: COUNT }, () => (180 / Math.PI) * Math.asin(2 * random() - 1)),
  lon: Float64Array.from({ length: COUNT }, () => 360 * random() - 180),
});

test("rows have the bits of single calls", async () => {
  const earth = await Geodesic.on("wgs84");
  const [from, to] = [places(), places()];
  const rows = earth.inverseAll({ lat1: from.lat, lon1: from.lon, lat2: to.lat, lon2: to.lon });
  const line = {};
  for (let i = 0; i < COUNT; i++) {
    earth.inverse({ lat: from.lat[i], lon: from.lon[i] }, { lat: to.lat[i], lon: to.lon[i] }, line);
    assert.deepEqual([rows.distance[i], rows.azimuth1[i], rows.azimuth2[i]], [line.distance, line.azimuth1, line.azimuth2]);
  }
  const ends = earth.directAll({ ...from, azimuth: rows.azimuth1, distance: rows.distance });
  for (let i = 0; i < COUNT; i++) assert.ok(Math.abs(ends.lat[i] - to.lat[i]) < 1e-12);
});

test("with and without SIMD the bits are the same", async () => {
  const { once } = await import(new URL("module.js", import.meta.resolve("terrella/geodesic")));
  const { geodesicOf } = await import(new URL("geodesic.js", import.meta.resolve("terrella/geodesic")));
  const file = (name) => async () => readFileSync(new URL(name, import.meta.resolve("terrella/geodesic")));
  const [from, to] = [places(), places()];
  const given = { lat1: from.lat, lon1: from.lon, lat2: to.lat, lon2: to.lon };
  const [simd, plain] = await Promise.all(
    ["geodesic.simd.wasm", "geodesic.wasm"].map(async (name) => (await geodesicOf(once({ plain: file(name) })).on()).inverseAll(given)),
  );
  assert.deepEqual(simd, plain);
});

test("with the bytes inside it is the same", async () => {
  const pair = [{ lat: 1, lon: 2 }, { lat: -3, lon: 140 }];
  assert.equal((await Inline.on()).distance(...pair), (await Geodesic.on()).distance(...pair));
});

test("what is refused in a row is NaN, counted and told", async () => {
  const earth = await Geodesic.on();
  const { lat, lon } = places();
  lat[3000] = NaN;
  lat[4096] = -91;
  lon[4500] = Infinity;
  const { distance, refused } = earth.inverseAll({ lat1: lat, lon1: lon, lat2: 0, lon2: 0 });
  assert.deepEqual(refused, { count: 3, first: 3000, why: "latitude NaN is not in [-90, 90] degrees" });
  assert.equal(distance.filter(Number.isNaN).length, 3);
});

test("single calls throw the crate's words", async () => {
  const earth = await Geodesic.on();
  const home = { lat: 0, lon: 0 };
  const refusals = [
    [() => earth.distance({ lat: 91.5, lon: 0 }, home), "latitude 91.5 is not in [-90, 90] degrees"],
    [() => earth.distance({ lat: 1, lon: NaN }, home), "longitude NaN is not finite"],
    [() => earth.distance({}, home), "latitude NaN is not in [-90, 90] degrees"],
    [() => earth.direct(home, Infinity, 1), "azimuth Infinity is not finite"],
    [() => earth.direct(home, 0, NaN), "distance NaN is not finite"],
    [() => earth.inverseAll({ lat1: [1, 2], lon1: [1], lat2: 0, lon2: 0 }), "expected arrays of 2 elements, got 1"],
    [() => earth.inverseAll({ lat1: [1, 2], lon1: 0, lat2: 0, lon2: 0 }, { distance: new Float32Array(3) }), "expected arrays of 2 elements, got 3"],
  ];
  for (const [call, message] of refusals) assert.throws(call, { name: "RangeError", message });
  await assert.rejects(Geodesic.on({ a: 6e6, f: 0.5 }), RangeError);
  await assert.rejects(Geodesic.on({ a: NaN, f: 0 }), { message: "semi-major axis NaN is not in [1e-15, 1e15] metres" });
  await assert.rejects(Geodesic.on("wgs-84"), /no ellipsoid is called "wgs-84": expected wgs84, /);
  const map = await CubeMap.of({ projection: "adjusted" });
  assert.throws(() => map.unproject({ face: 6, x: 0, y: 0 }), { message: "face 6 is not in 0 to 5" });
  assert.throws(() => map.unproject({ face: 1, x: 1.5, y: 0 }), { message: "(1.5, 0) is not in [-1, 1]²" });
  assert.throws(() => map.projectDirection({ x: 0, y: 0, z: 0 }), { message: "(0, 0, 0) has no direction" });
  await assert.rejects(CubeMap.of({ projection: "Adjusted" }), /no projection is called "Adjusted": expected /);
  const area = await Area.on();
  assert.throws(() => area.ring({ lat: [0, 99], lon: [0, 0] }), { message: "corner 1: latitude 99 is not in [-90, 90] degrees" });
});

test("two ellipsoids at a time do not mix", async () => {
  const [earth, moon] = await Promise.all([Geodesic.on("wgs84"), Geodesic.on("moon")]);
  const quarter = (geodesic) => geodesic.distance({ lat: 0, lon: 0 }, { lat: 90, lon: 0 });
  for (let turn = 0; turn < 3; turn++) {
    assert.ok(Math.abs(quarter(earth) - 10001965.7293) < 1e-4);
    assert.ok(Math.abs(quarter(moon) - (Math.PI / 2) * ellipsoids.moon.a) < 1e4);
  }
  const [zurich, quito] = await Promise.all([LocalFrame.at({ lat: 47, lon: 8 }), LocalFrame.at({ lat: 0, lon: -78, height: 2850 })]);
  for (const [frame, lat, lon] of [[zurich, 47, 8], [quito, 0, -78], [zurich, 47, 8]]) {
    assert.ok(Math.abs(frame.toEnu({ lat: lat + 1e-5, lon }).north - 1.11) < 0.01);
  }
});

test("places along a line", async () => {
  const earth = await Geodesic.on();
  const points = earth.along({ lat: 10, lon: 20 }, 30, [0, 1e6, 2e6]);
  const end = earth.direct({ lat: 10, lon: 20 }, 30, 2e6);
  assert.ok(Math.abs(points.lat[2] - end.lat) < 1e-13 && Math.abs(points.lat[0] - 10) < 1e-13);
});

test("frames there and back", async () => {
  const frame = await LocalFrame.at({ lat: 52, lon: 8, height: 110 });
  const aircraft = { lat: 52.1, lon: 8.3, height: 10_000 };
  const seen = frame.toAer(aircraft);
  // The example of the crate's first page.
  assert.deepEqual([seen.azimuth, seen.elevation, seen.range].map((part) => part.toFixed(1)), ["61.5", "22.8", "25417.3"]);
  for (const axes of ["Enu", "Ned", "Aer"]) {
    const back = frame[`from${axes}`](frame[`to${axes}`](aircraft));
    for (const part of ["lat", "lon", "height"]) assert.ok(Math.abs(back[part] - aircraft[part]) < 1e-8, axes);
    const rows = frame[`from${axes}All`](frame[`to${axes}All`]({ lat: [52.1], lon: [8.3], height: 10_000 }));
    assert.equal(rows.lat[0], back.lat);
  }
});

test("results go to the caller's arrays, of 32 bits too", async () => {
  const ecef = await Ecef.on();
  const mine = { x: new Float32Array(2), y: new Float64Array(2) };
  const points = ecef.fromGeodeticAll({ lat: [0, 0], lon: [0, 90] }, mine);
  assert.ok(points === mine && mine.x[0] === 6378137 && mine.y[1] === 6378137 && mine.z instanceof Float64Array);
});

test("rings in flat arrays, longer than a block", async () => {
  const earth = await Area.on();
  const turn = Array.from({ length: COUNT }, (_, index) => (360 * index) / COUNT - 180);
  const given = { lat: [...turn.map(() => 60), 0, 0, 90, 95], lon: [...turn, 0, 90, 0, 0], offsets: [0, COUNT, COUNT + 3, COUNT + 4, 1e6] };
  const { area, perimeter, refused } = earth.rings(given);
  assert.deepEqual(refused, { count: 2, first: 2, why: `corner ${COUNT + 3}: latitude 95 is not in [-90, 90] degrees` });
  assert.equal(area[1], earth.ring({ lat: [0, 0, 90], lon: [0, 90, 0] }).area);
  // The cap north of 60°: π a² (q(1) − q(sin 60°)); the chords bulge by some parts in 10⁶.
  assert.ok(Math.abs(area[0] / 34415850514903.88 - 1) < 1e-5 && Number.isNaN(area[2]) && Number.isNaN(perimeter[3]));
});

test("S2's cells", async () => {
  const s2 = await Tiles.of({ projection: "s2-quadratic", shift: "geodetic" });
  const paris = s2.containing({ lat: 48.8566, lon: 2.3522 }, 12);
  assert.equal(paris.toString(16), "47e66e1000000000");
  const tile = s2.tile(paris);
  assert.equal(s2.key(tile), paris);
  const box = s2.bounds(tile);
  assert.ok(box.south < 48.8566 && 48.8566 < box.north && box.west < 2.3522 && 2.3522 < box.east);
  const { right } = s2.neighbours(tile);
  assert.equal(s2.neighbours(s2.tile(right)).left, paris);
  // What S2 gives for this box.
  const cells = s2.cover({ south: 36.9999, west: 126.9999, north: 37.0001, east: 127.0001 }, 20);
  assert.deepEqual([cells.length, cells[0].toString(16), cells.at(-1).toString(16)], [13, "357b3cd6f8500000", "357b3cd6ff300000"]);
  assert.throws(() => s2.cover({ south: -90, west: -180, north: 90, east: 180 }, 10, { limit: 1000 }), /more than 1000 tiles/);
  assert.throws(() => s2.cover({ south: 1, west: 0, north: 0, east: 1 }, 3), /southern latitude 1 is above the northern one, 0/);
  const many = s2.cover({ south: -90, west: -180, north: 90, east: 180 }, 6);
  assert.equal(new Set(many).size, 6 * 4 ** 6);
  const samples = s2.samples(tile, 65);
  assert.ok(samples.lat.every((lat) => box.south - 1e-12 <= lat && lat <= box.north + 1e-12));
  assert.throws(() => s2.tile(0n), /is not the key of a tile/);
  assert.throws(() => s2.bounds({ face: 0, level: 2, i: 4, j: 0 }), { message: "column 4 is not in 0 to 2^2 - 1" });
});

test("each projection there and back from places", async () => {
  const { lat, lon } = places();
  for (const [projection, shift] of [["vertex", "authalic"], ["s2-quadratic", "geodetic"], ["adjusted", "geocentric"], ["healpix", "authalic"]]) {
    const map = await CubeMap.of({ projection, shift });
    const points = map.projectAll({ lat, lon });
    const back = map.unprojectAll(points);
    for (let i = 0; i < COUNT; i++) {
      assert.ok(Math.abs(back.lat[i] - lat[i]) < 1e-12);
      assert.equal(points.x[i], map.project({ lat: lat[i], lon: lon[i] }).x);
    }
  }
});
