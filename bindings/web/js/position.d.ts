import type { Column, Ellipsoid, Place, Result, Rows } from "./module.js";

/** A place with a height above the ellipsoid in metres. */
export interface Geodetic<T = number> {
  lat: T;
  lon: T;
  height: T;
}

/** In metres, in Earth axes: x toward 0° N 0° E, y toward 0° N 90° E, z toward the north pole. */
export interface Point<T = number> {
  x: T;
  y: T;
  z: T;
}

/** In metres. */
export interface Enu<T = number> {
  east: T;
  north: T;
  up: T;
}

/** In metres. */
export interface Ned<T = number> {
  north: T;
  east: T;
  down: T;
}

/** Azimuth in degrees clockwise from north, elevation in degrees above the horizon, range in metres. */
export interface Aer<T = number> {
  azimuth: T;
  elevation: T;
  range: T;
}

/** A place with or without a height, which is 0 then. */
type Located = Place & { height?: number };
type LocatedRows = { lat: Column; lon: Column; height?: Column };
type Columns<T> = { [part in keyof T]: Column };

/** Geodetic places and Earth-centred, Earth-fixed coordinates of an ellipsoid, each from the other to 9 nm. */
export class Ecef {
  private constructor();

  /** Of an ellipsoid, "wgs84" if none is given. Throws a RangeError for an unknown name. */
  static on(ellipsoid?: Ellipsoid): Promise<Ecef>;

  fromGeodetic<T extends object>(place: Located, into?: T): T & Point;
  toGeodetic<T extends object>(point: Point, into?: T): T & Geodetic;
  fromGeodeticAll(places: LocatedRows, into?: Partial<Point<Result>>): Point<Result> & Rows;
  toGeodeticAll(points: Columns<Point>, into?: Partial<Geodetic<Result>>): Geodetic<Result> & Rows;
}

/** Axes about an origin: east, north, up; north, east, down; azimuth, elevation, range. */
export class LocalFrame {
  private constructor();

  /** About an origin, on an ellipsoid, "wgs84" if none is given. */
  static at(origin: Located, ellipsoid?: Ellipsoid): Promise<LocalFrame>;

  toEnu<T extends object>(place: Located, into?: T): T & Enu;
  toNed<T extends object>(place: Located, into?: T): T & Ned;
  toAer<T extends object>(place: Located, into?: T): T & Aer;
  fromEnu<T extends object>(point: Enu, into?: T): T & Geodetic;
  fromNed<T extends object>(point: Ned, into?: T): T & Geodetic;
  fromAer<T extends object>(point: Aer, into?: T): T & Geodetic;
  toEnuAll(places: LocatedRows, into?: Partial<Enu<Result>>): Enu<Result> & Rows;
  toNedAll(places: LocatedRows, into?: Partial<Ned<Result>>): Ned<Result> & Rows;
  toAerAll(places: LocatedRows, into?: Partial<Aer<Result>>): Aer<Result> & Rows;
  fromEnuAll(points: Columns<Enu>, into?: Partial<Geodetic<Result>>): Geodetic<Result> & Rows;
  fromNedAll(points: Columns<Ned>, into?: Partial<Geodetic<Result>>): Geodetic<Result> & Rows;
  fromAerAll(points: Columns<Aer>, into?: Partial<Geodetic<Result>>): Geodetic<Result> & Rows;
}
