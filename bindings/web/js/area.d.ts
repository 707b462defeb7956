import type { Ellipsoid, Result, Rows } from "./module.js";

export interface Measured<T = number> {
  /** In square metres, positive for a ring counter-clockwise. */
  area: T;
  /** In metres. */
  perimeter: T;
}

/**
 * Areas and perimeters of rings whose edges are geodesics of an ellipsoid, of any size. The last corner is joined to the
 * first.
 *
 * @example
 * const earth = await Area.on("wgs84");
 * earth.ring({ lat: [0, 0, 90], lon: [0, 90, 0] }).area; // an eighth of the Earth: 63758202715511 m²
 */
export class Area {
  private constructor();

  /** On an ellipsoid, "wgs84" if none is given. Throws a RangeError for an unknown name, and for f outside [−1/9, 1/10]. */
  static on(ellipsoid?: Ellipsoid): Promise<Area>;

  /** One ring. Throws a RangeError for a corner that is no place. */
  ring<T extends object>(corners: { lat: ArrayLike<number>; lon: ArrayLike<number> }, into?: T): T & Measured;

  /** Many rings in flat arrays: ring r has the corners `offsets[r]` up to `offsets[r + 1]`. */
  rings(
    given: { lat: ArrayLike<number>; lon: ArrayLike<number>; offsets: ArrayLike<number> },
    into?: Partial<Measured<Result>>,
  ): Measured<Result> & Rows;
}
