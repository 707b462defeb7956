import { ellipsoids } from "./tables.js";

/** An ellipsoid of its name, or as it is. */
export function ellipsoidOf(given) {
  if (typeof given !== "string") return given;
  const found = ellipsoids[given];
  if (!found) throw new RangeError(`no ellipsoid is called "${given}": expected ${Object.keys(ellipsoids).join(", ")}`);
  return found;
}
