import type { CubeMapOptions } from "./cube.js";
import type { Column, Place, Result, Rows } from "./module.js";

/** A tile of a face: at level l, column i and row j are 0 to 2^l − 1. */
export interface Tile<B = number, U = number> {
  face: B;
  level: B;
  i: U;
  j: U;
}

/** In degrees; the eastern longitude is below the western one if the box crosses ±180°. */
export interface Box {
  south: number;
  west: number;
  north: number;
  east: number;
}

type Tiles32 = Tile<Uint8Array, Uint32Array>;
type Keys = { key: BigUint64Array };

/**
 * Tiles of a cube map. A key is a number of 64 bits along Hilbert's curve; with the projection "s2-quadratic" and the shift
 * "geodetic" it is S2's cell id.
 *
 * @example
 * const s2 = await Tiles.of({ projection: "s2-quadratic", shift: "geodetic" });
 * s2.containing({ lat: 48.8566, lon: 2.3522 }, 12).toString(16); // "47e66e1000000000"
 */
export class Tiles {
  private constructor();

  /** Throws a RangeError for an unknown name, and for a flattening that the shift does not hold for. */
  static of(options: CubeMapOptions): Promise<Tiles>;

  /** The key of the tile of a level, 0 to 30, that contains a place. */
  containing(place: Place, level: number): bigint;
  containingAll(places: { lat: Column; lon: Column }, level: number, into?: Partial<Keys>): Keys & Rows;
  key(tile: Tile): bigint;
  keyAll(tiles: { face: Column; level: Column; i: Column; j: Column }, into?: Partial<Keys>): Keys & Rows;
  tile<T extends object>(key: bigint, into?: T): T & Tile;
  tileAll(keys: Keys, into?: Partial<Tiles32>): Tiles32 & Rows;
  /** The box of latitude and longitude that holds the tile. */
  bounds<T extends object>(tile: Tile, into?: T): T & Box;
  /** The keys of the neighbours over the tile's edges, over edges of the cube too. */
  neighbours<T extends object>(tile: Tile, into?: T): T & { right: bigint; up: bigint; left: bigint; down: bigint };
  /** Places of `samples` × `samples` samples, row by row from below, the first and last of a row on the tile's edges. */
  samples(tile: Tile, samples: number, into?: Partial<{ lat: Result; lon: Result }>): { lat: Result; lon: Result };
  /**
   * The keys of the tiles of a level that cover a box, sorted: `inner` only those inside it, `mixed` coarser ones where they
   * are inside. Throws a RangeError if there are more than `limit`, a million if none is given.
   */
  cover(box: Box, level: number, options?: { inner?: boolean; mixed?: boolean; limit?: number }): BigUint64Array;
}
