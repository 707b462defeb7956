// The truth through the package, within what the README claims of the crate.

import assert from "node:assert/strict";
import { test } from "node:test";

import { Area } from "terrella/area";
import { CubeMap } from "terrella/cube";
import { Geodesic } from "terrella/geodesic";
import { Ecef } from "terrella/position";
import { projections } from "terrella/tables";

import { claims, error, truth, worst } from "./truth.mjs";

const column = (rows, name) => Float64Array.from(rows, (row) => Number(row[name]));

/** Holds the largest of errors to a claim. */
function hold(what, errors, claimed, rows = 100) {
  assert.ok(errors.length > rows, `${what}: ${errors.length} rows`);
  const most = worst(errors);
  console.log(`${what}: ${errors.length} rows, ${most.toExponential(1)} of ${claimed}`);
  assert.ok(most <= claimed, `${what}: ${most} is more than ${claimed}`);
}

test("distances", async () => {
  const earth = await Geodesic.on("wgs84");
  const rows = truth("geod_inverse_wgs84");
  const given = Object.fromEntries(["lat1", "lon1", "lat2", "lon2"].map((name) => [name, column(rows, name)]));
  const { distance, refused } = earth.inverseAll(given);
  assert.equal(refused, null);
  hold("distance", rows.map((row, index) => error(distance[index], row.s12)), claims("Karney inverse, distance")[0]);
});

test("destinations", async () => {
  const earth = await Geodesic.on("wgs84");
  // Over less than a turn: longer lines have a claim of their own.
  const rows = truth("geod_direct_wgs84").filter((row) => Math.abs(Number(row.s12)) < 2e7);
  const given = { lat: column(rows, "lat1"), lon: column(rows, "lon1"), azimuth: column(rows, "azi1"), distance: column(rows, "s12") };
  const { lat } = earth.directAll(given);
  hold("latitude", rows.map((row, index) => error(lat[index], row.lat2) * 111_700), claims("Karney direct, position")[0]);
});

test("Earth axes", async () => {
  const ecef = await Ecef.on("wgs84");
  const low = (row) => Math.abs(Number(row.h)) <= 1e5;
  const rows = truth("ecef_forward_wgs84").filter(low);
  const points = ecef.fromGeodeticAll({ lat: column(rows, "lat"), lon: column(rows, "lon"), height: column(rows, "h") });
  const missed = rows.map((row, index) => Math.hypot(...["x", "y", "z"].map((axis) => error(points[axis][index], row[axis.toUpperCase()]))));
  hold("to Earth axes", missed, claims("Ellipsoid::to_ecef below 100 km")[0]);
  const back = truth("ecef_reverse_wgs84").filter((row) => low(row) && row.class === "random");
  const places = ecef.toGeodeticAll({ x: column(back, "X"), y: column(back, "Y"), z: column(back, "Z") });
  const heights = back.map((row, index) => error(places.height[index], row.h));
  hold("heights", heights, claims("Ellipsoid::to_geodetic below 100 km, down to the centre")[0], 20);
});

test("every projection", async () => {
  const axes = { x: "vz", y: "vx", z: "vy" }; // the paper's axes, in the order of the Earth's
  assert.ok(projections.length > 20);
  for (const projection of projections) {
    const map = await CubeMap.of({ projection, shift: "geodetic", ellipsoid: { a: 1, f: 0 } });
    const [forward, , inverse] = claims(projection);
    if (projection !== "cobe") {
      const rows = truth(`cube_${projection}_forward`);
      const found = map.projectDirectionAll(Object.fromEntries(Object.entries(axes).map(([axis, name]) => [axis, column(rows, name)])));
      // On an edge the rounding of the input decides.
      const same = rows.flatMap((row, index) => (found.face[index] === Number(row.face) ? [index] : []));
      hold(`${projection} forward`, same.map((index) => Math.max(error(found.x[index], rows[index].x), error(found.y[index], rows[index].y))), forward);
    }
    const rows = truth(`cube_${projection}_inverse`);
    const found = map.unprojectDirectionAll({ face: column(rows, "face"), x: column(rows, "x"), y: column(rows, "y") });
    hold(`${projection} inverse`, rows.map((row, index) => Math.hypot(...Object.entries(axes).map(([axis, name]) => error(found[axis][index], row[name])))), inverse);
  }
});

test("areas", async () => {
  // An eighth of WGS 84: π/2 times the square of the authalic radius, 6371007.1809184747 m.
  const { area, perimeter } = (await Area.on("wgs84")).ring({ lat: [0, 0, 90], lon: [0, 90, 0] });
  assert.ok(Math.abs(area - (Math.PI / 2) * 6371007.1809184747 ** 2) < 0.1);
  assert.ok(Math.abs(perimeter - (2 * 10001965.7293127 + 10018754.1713946)) < 1e-6);
});
