import { ellipsoidOf } from "./ellipsoid.js";
import { call } from "./module.js";
import { projections, shifts } from "./tables.js";

const PLACE = ["lat", "lon"];
const POINT = ["face", "x", "y"];
const DIRECTION = ["x", "y", "z"];
const PROJECT = call("cube_project", PLACE, POINT);
const UNPROJECT = call("cube_unproject", POINT, PLACE);
const PROJECT_DIRECTION = call("cube_project_direction", DIRECTION, POINT);
const UNPROJECT_DIRECTION = call("cube_unproject_direction", POINT, DIRECTION);

/** The index of a name in a list. */
export function indexOf(name, names, what) {
  const index = names.indexOf(name);
  if (index < 0) throw new RangeError(`no ${what} is called "${name}": expected ${names.join(", ")}`);
  return index;
}

export const cubeMapOf = (module) =>
  class CubeMap {
    #module;
    #numbers;

    static async of({ projection, shift = "authalic", ellipsoid = "wgs84" }) {
      const map = new CubeMap();
      const { a, f } = ellipsoidOf(ellipsoid);
      map.#numbers = [a, f, indexOf(shift, shifts, "shift"), indexOf(projection, projections, "projection")];
      map.#module = await module();
      map.#use();
      return map;
    }

    #use() {
      this.#module.use("cube", this, ...this.#numbers);
      return this.#module;
    }

    project({ lat, lon }, into = {}) {
      return this.#use().one(PROJECT, [lat, lon], into);
    }

    unproject({ face, x, y }, into = {}) {
      return this.#use().one(UNPROJECT, [face, x, y], into);
    }

    projectDirection({ x, y, z }, into = {}) {
      return this.#use().one(PROJECT_DIRECTION, [x, y, z], into);
    }

    unprojectDirection({ face, x, y }, into = {}) {
      return this.#use().one(UNPROJECT_DIRECTION, [face, x, y], into);
    }

    projectAll(places, into = {}) {
      return this.#use().all(PROJECT, places, into);
    }

    unprojectAll(points, into = {}) {
      return this.#use().all(UNPROJECT, points, into);
    }

    projectDirectionAll(directions, into = {}) {
      return this.#use().all(PROJECT_DIRECTION, directions, into);
    }

    unprojectDirectionAll(points, into = {}) {
      return this.#use().all(UNPROJECT_DIRECTION, points, into);
    }
  };
