import type { Column, Ellipsoid, Place, Result, Rows } from "./module.js";

/** A point of a face of the cube: 0 front (0° N 0° E), 1 right, 2 back, 3 left, 4 top, 5 bottom; x, y in [−1, 1]. */
export interface FacePoint<F = number, T = number> {
  face: F;
  x: T;
  y: T;
}

/** A direction in Earth axes, of any length but 0: x toward 0° N 0° E, z toward the north pole. */
export interface Direction<T = number> {
  x: T;
  y: T;
  z: T;
}

type PlaceRows = { lat: Column; lon: Column };
type PointRows = { face: Column; x: Column; y: Column };
type DirectionRows = { x: Column; y: Column; z: Column };
type Points = FacePoint<Uint8Array, Result>;

/** How a cube map is made: names of `projections` and `shifts` in "terrella/tables". */
export interface CubeMapOptions {
  projection: string;
  /** By which latitude the ellipsoid becomes a sphere; "authalic", which keeps areas, if none is given. */
  shift?: string;
  /** "wgs84" if none is given. */
  ellipsoid?: Ellipsoid;
}

/**
 * A map of the ellipsoid onto the faces of a cube.
 *
 * @example
 * const map = await CubeMap.of({ projection: "s2-quadratic", shift: "geodetic" });
 * map.project({ lat: 0, lon: 100 }).face; // 1, the right one
 */
export class CubeMap {
  private constructor();

  /** Throws a RangeError for an unknown name, and for a flattening that the shift does not hold for. */
  static of(options: CubeMapOptions): Promise<CubeMap>;

  project<T extends object>(place: Place, into?: T): T & FacePoint;
  unproject<T extends object>(point: FacePoint, into?: T): T & Place;
  /** From the sphere, without the shift. */
  projectDirection<T extends object>(direction: Direction, into?: T): T & FacePoint;
  /** To a unit vector of the sphere, without the shift. */
  unprojectDirection<T extends object>(point: FacePoint, into?: T): T & Direction;
  projectAll(places: PlaceRows, into?: Partial<Points>): Points & Rows;
  unprojectAll(points: PointRows, into?: Partial<{ lat: Result; lon: Result }>): { lat: Result; lon: Result } & Rows;
  projectDirectionAll(directions: DirectionRows, into?: Partial<Points>): Points & Rows;
  unprojectDirectionAll(points: PointRows, into?: Partial<Direction<Result>>): Direction<Result> & Rows;
}
