// The wasm module's functions with JavaScript's types.

/** From the bytes of the module. */
export async function load(bytes) {
  const { instance } = await WebAssembly.instantiate(bytes);
  const { memory, results, project, unproject, inverse } = instance.exports;
  const left = new Float64Array(memory.buffer, results(), 3);
  return {
    /** A vector in Earth axes (x through 0° N 0° E, z through the north pole) to a face, 0 to 5, and x and y in [-1, 1] on it. */
    project(vector) {
      const face = project(...vector);
      if (face < 0) throw new RangeError(`(${vector}) has no direction`);
      return { face, x: left[0], y: left[1] };
    },
    /** A point of a face to its unit vector. */
    unproject({ face, x, y }) {
      if (!unproject(face, x, y)) throw new RangeError(`(${x}, ${y}) is not on face ${face}`);
      return [...left];
    },
    /** Two places, [latitude, longitude] in degrees, to their distance in metres and the azimuths at both in degrees. */
    inverse(from, to) {
      const distance = inverse(...from, ...to);
      if (Number.isNaN(distance)) throw new RangeError(`no places: ${from}, ${to}`);
      return { distance, azimuths: [left[0], left[1]] };
    },
  };
}
