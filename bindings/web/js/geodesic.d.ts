import type { Column, Ellipsoid, Place, Result, Rows } from "./module.js";

export interface Inverse<T = number> {
  /** In metres. */
  distance: T;
  /** At the first place, in degrees clockwise from north. */
  azimuth1: T;
  /** At the second place, in the direction of travel. */
  azimuth2: T;
}

export interface Direct<T = number> {
  lat: T;
  lon: T;
  /** In the direction of travel, in degrees clockwise from north. */
  azimuth: T;
}

/**
 * Geodesics of an ellipsoid by Karney's method: shortest lines between any two places, to 7 nm on the Earth.
 *
 * Single calls throw a RangeError for what is no place, azimuth or distance. Calls about many rows write NaN there, and say
 * in `refused` how many rows that are.
 *
 * @example
 * const earth = await Geodesic.on("wgs84");
 * earth.distance({ lat: 40.6, lon: -73.8 }, { lat: 51.6, lon: -0.5 }); // 5551759.400 m
 */
export class Geodesic {
  private constructor();

  /** On an ellipsoid, "wgs84" if none is given. Throws a RangeError for an unknown name, and for f outside [−1/9, 1/10]. */
  static on(ellipsoid?: Ellipsoid): Promise<Geodesic>;

  /** The length of the shortest line, in metres. */
  distance(from: Place, to: Place): number;

  /** The shortest line. Writes to the fields of `into`, so that a loop need not make objects. */
  inverse<T extends object>(from: Place, to: Place, into?: T): T & Inverse;

  /** Where one comes from a place at an azimuth in degrees after a distance in metres. */
  direct<T extends object>(from: Place, azimuth: number, distance: number, into?: T): T & Direct;

  /** {@link inverse} for many rows. */
  inverseAll(
    given: { lat1: Column; lon1: Column; lat2: Column; lon2: Column },
    into?: Partial<Inverse<Result>>,
  ): Inverse<Result> & Rows;

  /** {@link direct} for many rows. */
  directAll(
    given: { lat: Column; lon: Column; azimuth: Column; distance: Column },
    into?: Partial<Direct<Result>>,
  ): Direct<Result> & Rows;

  /** Places along one line, at distances in metres from its start. */
  along(from: Place, azimuth: number, distance: ArrayLike<number>, into?: Partial<Direct<Result>>): Direct<Result> & Rows;
}
