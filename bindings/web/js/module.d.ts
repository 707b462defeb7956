/** Numbers of many rows: an array, or one number for all rows. */
export type Column = ArrayLike<number> | number;

/** Where results of many rows go: arrays of the caller, or made by the function. */
export type Result = Float64Array | Float32Array;

/** Rows that were refused: their results are NaN, and whole numbers 0. All others are written. */
export interface Refused {
  /** How many. */
  count: number;
  /** The index of the first. */
  first: number;
  /** Why the first was refused. */
  why: string;
}

export interface Rows {
  /** What was refused, or null. */
  refused: Refused | null;
}

/** A place: latitude and longitude in degrees. */
export interface Place {
  lat: number;
  lon: number;
}

/** The name of an ellipsoid, or its semi-major axis in metres and its flattening. */
export type Ellipsoid = string | { a: number; f: number };
