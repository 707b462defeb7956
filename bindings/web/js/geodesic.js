import { ellipsoidOf } from "./ellipsoid.js";
import { call } from "./module.js";

const INVERSE = call("geodesic_inverse", ["lat1", "lon1", "lat2", "lon2"], ["distance", "azimuth1", "azimuth2"]);
const DIRECT = call("geodesic_direct", ["lat", "lon", "azimuth", "distance"], ["lat", "lon", "azimuth"]);
const AT = call("line_at", ["distance"], ["lat", "lon", "azimuth"]);

export const geodesicOf = (module) =>
  class Geodesic {
    #module;
    #ellipsoid;

    static async on(ellipsoid = "wgs84") {
      const geodesic = new Geodesic();
      geodesic.#ellipsoid = ellipsoidOf(ellipsoid);
      geodesic.#module = await module();
      geodesic.#use();
      return geodesic;
    }

    #use() {
      this.#module.use("geodesic", this, this.#ellipsoid.a, this.#ellipsoid.f);
      return this.#module;
    }

    distance(from, to) {
      return this.inverse(from, to).distance;
    }

    inverse(from, to, into = {}) {
      return this.#use().one(INVERSE, [from.lat, from.lon, to.lat, to.lon], into);
    }

    direct(from, azimuth, distance, into = {}) {
      return this.#use().one(DIRECT, [from.lat, from.lon, azimuth, distance], into);
    }

    inverseAll(given, into = {}) {
      return this.#use().all(INVERSE, given, into);
    }

    directAll(given, into = {}) {
      return this.#use().all(DIRECT, given, into);
    }

    along(from, azimuth, distance, into = {}) {
      const module = this.#use();
      module.use("line", NaN, from.lat, from.lon, azimuth); // NaN equals nothing: a new line each time.
      return module.all(AT, { distance }, into);
    }
  };
