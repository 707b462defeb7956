// Runs the truth through the module: node test.mjs MODULE andoyer-second|karney
// Each error is held to what the README and the method's documentation claim.

import { readFileSync } from "node:fs";
import { load } from "./terrella.mjs";

const [module, method] = process.argv.slice(2);
const root = new URL("../../", import.meta.url);
const terrella = await load(readFileSync(module));

/** The rows of a truth file, as objects of text. */
function truth(name) {
  const text = readFileSync(new URL(`tests/truth/${name}.tsv`, root), "utf8");
  const [header, ...rows] = text.trimEnd().split("\n").filter((line) => !line.startsWith("#")).map((line) => line.split("\t"));
  return rows.map((row) => Object.fromEntries(header.map((name, index) => [name, row[index]])));
}

/** A decimal as an integer of 10^-places. */
function fixed(text, places) {
  const [mantissa, exponent = "0"] = text.toLowerCase().split("e");
  const [whole, fraction = ""] = mantissa.split(".");
  const shift = places + Number(exponent) - fraction.length;
  const digits = BigInt(whole + fraction);
  return shift < 0 ? digits / 10n ** BigInt(-shift) : digits * 10n ** BigInt(shift);
}

/** |computed - truth|, from all the digits of both. */
function error(computed, text) {
  const exact = exactly(computed);
  const difference = fixed(exact, 60) - fixed(text, 60);
  return Math.abs(Number(difference) / 1e60);
}

/** All the digits of a number: a sum of powers of two, which end. */
function exactly(number) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, number);
  const bits = view.getBigUint64(0);
  const biased = (bits >> 52n) & 0x7ffn;
  const fraction = bits & 0xfffffffffffffn;
  const significand = biased === 0n ? fraction : fraction | (1n << 52n);
  const power = (biased === 0n ? 1n : biased) - 1075n;
  const scaled = power < 0n ? (significand * 10n ** 60n) >> -power : (significand << power) * 10n ** 60n;
  return `${number < 0 ? "-" : ""}${scaled}e-60`;
}

/** The claims of a row of the README's tables. */
function claims(name) {
  const row = readFileSync(new URL("README.md", root), "utf8").split("\n").find((line) => line.startsWith(`| ${name} |`) && /\de-\d/.test(line));
  return row.split("|").slice(2, -1).map(Number).filter((number) => !Number.isNaN(number));
}

let failed = false;

/** Holds the largest of errors, each a part of what is claimed of it; NaN if one is, which keeps no claim. */
function hold(name, errors, claimed) {
  const worst = Math.max(0, ...errors);
  const well = worst <= claimed && errors.length > 100;
  failed ||= !well;
  console.log(`${name}\t${errors.length} rows\t${worst.toExponential(2)} of ${claimed}${well ? "" : "\tNOT KEPT"}`);
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
