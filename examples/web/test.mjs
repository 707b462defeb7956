// Runs the truth through the module: node test.mjs MODULE andoyer-second|karney
// Each error is held to what the README and the method's documentation claim.

import { readFileSync } from "node:fs";
import { claims, error, truth, worst } from "../../bindings/web/test/truth.mjs";
import { load } from "./terrella.mjs";

const [module, method] = process.argv.slice(2);
const terrella = await load(readFileSync(module));

let failed = false;

/** Holds the largest of errors, each a part of what is claimed of it; NaN if one is, which keeps no claim. */
function hold(name, errors, claimed) {
  const most = worst(errors);
  const well = most <= claimed && errors.length > 100;
  failed ||= !well;
  console.log(`${name}\t${errors.length} rows\t${most.toExponential(2)} of ${claimed}${well ? "" : "\tNOT KEPT"}`);
}

const [forward, , inverse] = claims("quadrilateralized");
const axes = ["vz", "vx", "vy"]; // the paper's axes, in the order of the Earth's
const onFace = truth("cube_quadrilateralized_forward").flatMap((row) => {
  const point = terrella.project(axes.map((axis) => Number(row[axis])));
  // On an edge the rounding of the input decides.
  return point.face === Number(row.face) ? [Math.max(error(point.x, row.x), error(point.y, row.y))] : [];
});
hold("quadrilateralized forward", onFace, forward);
const directions = truth("cube_quadrilateralized_inverse").map((row) => {
  const vector = terrella.unproject({ face: Number(row.face), x: Number(row.x), y: Number(row.y) });
  return Math.hypot(...axes.map((axis, index) => error(vector[index], row[axis])));
});
hold("quadrilateralized inverse", directions, inverse);

/** What is claimed of a distance: for the second order of Andoyer's formula, by the distance. */
function claimOfDistance(distance) {
  if (method === "karney") return claims("Karney inverse, distance")[0];
  const steps = [[5e6, 0.02], [1e7, 0.2], [1.5e7, 2], [1.8e7, 20], [1.9e7, 80], [Infinity, 3.5e4]];
  return distance <= 3e6 ? 2e-9 * distance + 5e-9 : steps.find(([limit]) => distance <= limit)[1];
}
const distances = truth("geod_inverse_wgs84").map((row) => {
  const line = terrella.inverse([Number(row.lat1), Number(row.lon1)], [Number(row.lat2), Number(row.lon2)]);
  return error(line.distance, row.s12) / claimOfDistance(Number(row.s12));
});
hold(`${method} distance, parts of the claim`, distances, 1);

for (const refused of [
  () => terrella.project([0, 0, 0]),
  () => terrella.unproject({ face: 6, x: 0, y: 0 }),
  () => terrella.unproject({ face: 0, x: 1.5, y: 0 }),
  () => terrella.inverse([91, 0], [0, 0]),
]) {
  try {
    refused();
    failed = true;
    console.log(`NOT REFUSED: ${refused}`);
  } catch (why) {
    if (!(why instanceof RangeError)) throw why;
  }
}
process.exitCode = failed ? 1 : 0;
