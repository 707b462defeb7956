import { indexOf } from "./cube.js";
import { ellipsoidOf } from "./ellipsoid.js";
import { call } from "./module.js";
import { projections, shifts } from "./tables.js";

const TILE = ["face", "level", "i", "j"];
const CONTAINING = call("tiles_containing", ["lat", "lon"], ["key"]);
const TO_KEY = call("tiles_to_key", TILE, ["key"]);
const FROM_KEY = call("tiles_from_key", ["key"], TILE);

export const tilesOf = (module) =>
  class Tiles {
    #module;
    #numbers;

    static async of({ projection, shift = "authalic", ellipsoid = "wgs84" }) {
      const tiles = new Tiles();
      const { a, f } = ellipsoidOf(ellipsoid);
      tiles.#numbers = [a, f, indexOf(shift, shifts, "shift"), indexOf(projection, projections, "projection")];
      tiles.#module = await module();
      tiles.#use();
      return tiles;
    }

    #use() {
      this.#module.use("tiles", this, ...this.#numbers);
      return this.#module;
    }

    containing({ lat, lon }, level) {
      return this.#use().one(CONTAINING, [lat, lon], {}, level).key;
    }

    containingAll(places, level, into = {}) {
      return this.#use().all(CONTAINING, places, into, level);
    }

    key({ face, level, i, j }) {
      return this.#use().one(TO_KEY, [face, level, i, j], {}).key;
    }

    keyAll(tiles, into = {}) {
      return this.#use().all(TO_KEY, tiles, into);
    }

    tile(key, into = {}) {
      return this.#use().one(FROM_KEY, [key], into);
    }

    tileAll(keys, into = {}) {
      return this.#use().all(FROM_KEY, keys, into);
    }

    bounds({ face, level, i, j }, into = {}) {
      const module = this.#use();
      if (!module.exports.tile_bounds(face, level, i, j)) throw module.refusal();
      ["south", "west", "north", "east"].forEach((side, index) => (into[side] = module.column(index, side)[0]));
      return into;
    }

    neighbours({ face, level, i, j }, into = {}) {
      const module = this.#use();
      if (!module.exports.tile_neighbours(face, level, i, j)) throw module.refusal();
      ["right", "up", "left", "down"].forEach((edge, index) => (into[edge] = module.column(index, "key")[0]));
      return into;
    }

    samples({ face, level, i, j }, samples, into = {}) {
      if (!(Number.isInteger(samples) && 2 <= samples && samples <= 4097)) {
        throw new RangeError(`expected 2 to 4097 samples a side, got ${samples}`);
      }
      const module = this.#use();
      const count = samples * samples;
      into.lat ??= new Float64Array(count);
      into.lon ??= new Float64Array(count);
      for (let first = 0; first < count; first += module.points) {
        const here = Math.min(module.points, count - first);
        if (!module.exports.tile_samples(face, level, i, j, samples, first, here)) throw module.refusal();
        into.lat.set(module.column(0, "lat").subarray(0, here), first);
        into.lon.set(module.column(1, "lon").subarray(0, here), first);
      }
      return into;
    }

    cover({ south, west, north, east }, level, { inner = false, mixed = false, limit = 1e6 } = {}) {
      const module = this.#use();
      if (!module.exports.cover(south, west, north, east, level, inner, mixed)) throw module.refusal();
      const blocks = [];
      let total = 0;
      for (let count; (count = module.exports.cover_next()); total += count) {
        if (total + count > limit) throw new RangeError(`more than ${limit} tiles cover this box at level ${level}`);
        blocks.push(module.column(0, "key").slice(0, count));
      }
      const keys = new BigUint64Array(total);
      let at = 0;
      for (const block of blocks) {
        keys.set(block, at);
        at += block.length;
      }
      return keys.sort();
    }
  };
