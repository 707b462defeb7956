// Rows of the truth, with errors from all of their digits.

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

// The tests of the package run beside where it is installed, and are told where the project is.
const root = process.env.TRUTH ? pathToFileURL(`${process.env.TRUTH}/`) : new URL("../../../", import.meta.url);

/** The rows of a truth file, as objects of text. */
export function truth(name) {
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
  return number < 0 ? -scaled : scaled;
}

/** |computed − truth|; NaN if what was computed is no finite number. */
export function error(computed, text) {
  if (!Number.isFinite(computed)) return NaN;
  const difference = exactly(computed) - fixed(text, 60);
  return Math.abs(Number(difference)) / 1e60;
}

/** The largest; NaN if one is. */
export const worst = (errors) => errors.reduce((most, error) => (Number.isNaN(most) || error <= most ? most : error), 0);

/** The claims for f64 of a row of the README's tables. */
export function claims(name) {
  const rows = readFileSync(new URL("README.md", root), "utf8").split("\n");
  const row = rows.find((line) => line.startsWith(`| ${name} |`) && /\de-\d/.test(line));
  return row.split("|").slice(2, -1).map(Number).filter((number) => !Number.isNaN(number));
}
