import { ellipsoidOf } from "./ellipsoid.js";
import { call } from "./module.js";

const PLACE = ["lat", "lon", "height"];
const POINT = ["x", "y", "z"];
const TO_ECEF = call("ellipsoid_to_ecef", PLACE, POINT);
const TO_GEODETIC = call("ellipsoid_to_geodetic", POINT, PLACE);

export const ecefOf = (module) =>
  class Ecef {
    #module;
    #ellipsoid;

    static async on(ellipsoid = "wgs84") {
      const ecef = new Ecef();
      ecef.#ellipsoid = ellipsoidOf(ellipsoid);
      ecef.#module = await module();
      ecef.#use();
      return ecef;
    }

    #use() {
      this.#module.use("ellipsoid", this, this.#ellipsoid.a, this.#ellipsoid.f);
      return this.#module;
    }

    fromGeodetic({ lat, lon, height = 0 }, into = {}) {
      return this.#use().one(TO_ECEF, [lat, lon, height], into);
    }

    toGeodetic({ x, y, z }, into = {}) {
      return this.#use().one(TO_GEODETIC, [x, y, z], into);
    }

    fromGeodeticAll({ lat, lon, height = 0 }, into = {}) {
      return this.#use().all(TO_ECEF, { lat, lon, height }, into);
    }

    toGeodeticAll(points, into = {}) {
      return this.#use().all(TO_GEODETIC, points, into);
    }
  };

const ENU = ["east", "north", "up"];
const NED = ["north", "east", "down"];
const AER = ["azimuth", "elevation", "range"];
const TO_ENU = call("frame_to_enu", PLACE, ENU);
const TO_NED = call("frame_to_ned", PLACE, NED);
const TO_AER = call("frame_to_aer", PLACE, AER);
const FROM_ENU = call("frame_from_enu", ENU, PLACE);
const FROM_NED = call("frame_from_ned", NED, PLACE);
const FROM_AER = call("frame_from_aer", AER, PLACE);

export const localFrameOf = (module) =>
  class LocalFrame {
    #module;
    #ellipsoid;
    #origin;

    static async at({ lat, lon, height = 0 }, ellipsoid = "wgs84") {
      const frame = new LocalFrame();
      frame.#ellipsoid = ellipsoidOf(ellipsoid);
      frame.#origin = [lat, lon, height];
      frame.#module = await module();
      frame.#use();
      return frame;
    }

    #use() {
      const { a, f } = this.#ellipsoid;
      this.#module.use("ellipsoid", this, a, f);
      this.#module.use("frame", this, ...this.#origin);
      return this.#module;
    }

    #one(what, { lat, lon, height = 0 }, into) {
      return this.#use().one(what, [lat, lon, height], into);
    }

    #all(what, { lat, lon, height = 0 }, into) {
      return this.#use().all(what, { lat, lon, height }, into);
    }

    toEnu(place, into = {}) {
      return this.#one(TO_ENU, place, into);
    }

    toNed(place, into = {}) {
      return this.#one(TO_NED, place, into);
    }

    toAer(place, into = {}) {
      return this.#one(TO_AER, place, into);
    }

    fromEnu({ east, north, up }, into = {}) {
      return this.#use().one(FROM_ENU, [east, north, up], into);
    }

    fromNed({ north, east, down }, into = {}) {
      return this.#use().one(FROM_NED, [north, east, down], into);
    }

    fromAer({ azimuth, elevation, range }, into = {}) {
      return this.#use().one(FROM_AER, [azimuth, elevation, range], into);
    }

    toEnuAll(places, into = {}) {
      return this.#all(TO_ENU, places, into);
    }

    toNedAll(places, into = {}) {
      return this.#all(TO_NED, places, into);
    }

    toAerAll(places, into = {}) {
      return this.#all(TO_AER, places, into);
    }

    fromEnuAll(points, into = {}) {
      return this.#use().all(FROM_ENU, points, into);
    }

    fromNedAll(points, into = {}) {
      return this.#use().all(FROM_NED, points, into);
    }

    fromAerAll(points, into = {}) {
      return this.#use().all(FROM_AER, points, into);
    }
  };
