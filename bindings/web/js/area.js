import { ellipsoidOf } from "./ellipsoid.js";

export const areaOf = (module) =>
  class Area {
    #module;
    #ellipsoid;

    static async on(ellipsoid = "wgs84") {
      const area = new Area();
      area.#ellipsoid = ellipsoidOf(ellipsoid);
      area.#module = await module();
      area.#use();
      return area;
    }

    #use() {
      this.#module.use("area", this, this.#ellipsoid.a, this.#ellipsoid.f);
    }

    ring({ lat, lon }, into = {}) {
      if (lat.length !== lon.length) throw new RangeError(`expected arrays of ${lat.length} elements, got ${lon.length}`);
      return this.#measure(lat, lon, 0, lat.length, into);
    }

    rings({ lat, lon, offsets }, into = {}) {
      const count = offsets.length - 1;
      into.area ??= new Float64Array(count);
      into.perimeter ??= new Float64Array(count);
      into.refused = null;
      for (let ring = 0; ring < count; ring++) {
        let measured;
        try {
          measured = this.#measure(lat, lon, offsets[ring], offsets[ring + 1], {});
        } catch (error) {
          if (!(error instanceof RangeError)) throw error;
          measured = { area: NaN, perimeter: NaN };
          into.refused ??= { count: 0, first: ring, why: error.message };
          into.refused.count++;
        }
        into.area[ring] = measured.area;
        into.perimeter[ring] = measured.perimeter;
      }
      return into;
    }

    #measure(lat, lon, start, end, into) {
      if (!(0 <= start && start <= end && end <= Math.min(lat.length, lon.length))) {
        throw new RangeError(`there are no corners ${start} to ${end}`);
      }
      this.#use();
      const module = this.#module;
      module.exports.ring();
      const [lats, lons] = [0, 1].map((index) => module.column(index, "lat"));
      for (let at = start; at < end; at += module.points) {
        const count = Math.min(module.points, end - at);
        for (let index = 0; index < count; index++) {
          lats[index] = lat[at + index];
          lons[index] = lon[at + index];
        }
        const added = module.exports.ring_add(count);
        if (added < count) throw new RangeError(`corner ${at + added}: ${module.words()}`);
      }
      module.exports.ring_measure();
      into.area = module.column(0, "area")[0];
      into.perimeter = module.column(1, "perimeter")[0];
      return into;
    }
  };
