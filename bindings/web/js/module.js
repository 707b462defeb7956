// A module of WebAssembly: made once, and called about one row, or about arrays in blocks.

// The smallest module with an instruction of 128 bits: (func (result v128) i32.const 0 i8x16.splat).
const WITH_SIMD = new Uint8Array([
  0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11,
]);

/**
 * A function that makes the module at its first call: from the bytes that `simd` promises where there is SIMD, and from
 * those of `plain` elsewhere.
 */
export function once({ plain, simd = plain }) {
  let module;
  return () =>
    (module ??= (WebAssembly.validate(WITH_SIMD) ? simd() : plain()).then(instantiate).catch((error) => {
      module = undefined; // The next call tries again.
      throw error;
    }));
}

async function instantiate(bytes) {
  let memory;
  const write_number = (number, to) => encoder.encodeInto(String(number), new Uint8Array(memory.buffer, to, 32)).written;
  const { instance } = await WebAssembly.instantiate(bytes, { env: { write_number } });
  memory = instance.exports.memory;
  return new Module(instance.exports);
}

const encoder = new TextEncoder();
const decoder = new TextDecoder();

/** The arrays of fields that are whole numbers; those of all others are Float64Array. */
const whole = { face: Uint8Array, level: Uint8Array, i: Uint32Array, j: Uint32Array, key: BigUint64Array };
const typeOf = (field) => whole[field] ?? Float64Array;

/** A function of the module, with the names of what its columns hold. */
export const call = (name, inputs, outputs) => ({ name, inputs, outputs });

class Module {
  #current = new Map();

  constructor(exports) {
    this.exports = exports;
    this.points = exports.points();
    const views = (Type) =>
      Array.from({ length: exports.columns_count() }, (_, index) => {
        return new Type(exports.memory.buffer, exports.columns() + index * this.points * 8, this.points);
      });
    this.columns = new Map([Float64Array, Uint8Array, Uint32Array, BigUint64Array].map((Type) => [Type, views(Type)]));
  }

  /** The column of a field. */
  column(index, field) {
    return this.columns.get(typeOf(field))[index];
  }

  /** Makes calls be about an object of JavaScript, by a function of the module that says whether it could. */
  use(what, object, ...numbers) {
    if (this.#current.get(what) === object) return;
    this.#current.set(what, undefined);
    if (!this.exports[what](...numbers)) throw this.refusal();
    this.#current.set(what, object);
  }

  /** Why the last call refused something. */
  words() {
    const { memory, words, words_length } = this.exports;
    return decoder.decode(new Uint8Array(memory.buffer, words(), words_length()));
  }

  refusal() {
    return new RangeError(this.words());
  }

  /** Calls a function about one row of numbers, and writes its results to the fields of an object. */
  one({ name, inputs, outputs }, numbers, into, ...more) {
    for (let index = 0; index < inputs.length; index++) this.column(index, inputs[index])[0] = numbers[index];
    if (this.exports[name](1, ...more)) throw this.refusal();
    for (let index = 0; index < outputs.length; index++) {
      into[outputs[index]] = this.column(inputs.length + index, outputs[index])[0];
    }
    return into;
  }

  /**
   * Calls a function about rows of arrays, a block at a time. What is given has an array for each input, or a number for all
   * rows. Results go to the arrays of `into`, which are made where there are none; so does what was refused, or null.
   */
  all({ name, inputs, outputs }, given, into, ...more) {
    const count = lengthOf(inputs.map((field) => given[field]));
    for (const field of outputs) into[field] ??= new (typeOf(field))(count);
    for (const field of outputs) {
      if (into[field].length !== count) throw unequal(count, into[field].length);
    }
    into.refused = null;
    for (let start = 0; start < count; start += this.points) {
      const end = Math.min(start + this.points, count);
      inputs.forEach((field, index) => fill(this.column(index, field), given[field], start, end));
      const refused = this.exports[name](end - start, ...more);
      if (refused) {
        into.refused ??= { count: 0, first: start + this.column(0)[0], why: this.words() };
        into.refused.count += refused;
      }
      outputs.forEach((field, index) => {
        const made = this.column(inputs.length + index, field);
        into[field].set(end - start < this.points ? made.subarray(0, end - start) : made, start);
      });
    }
    return into;
  }
}

const isArray = (given) => typeof given === "object" && given !== null;

/** The common length of arrays; 1 if all are numbers. */
function lengthOf(given) {
  const [first, ...others] = given.filter(isArray);
  if (!first) return 1;
  for (const { length } of others) {
    if (length !== first.length) throw unequal(first.length, length);
  }
  return first.length;
}

const unequal = (first, other) => new RangeError(`expected arrays of ${first} elements, got ${other}`);

function fill(column, given, start, end) {
  if (!isArray(given)) column.fill(given, 0, end - start);
  else if (start === 0 && end === given.length) column.set(given);
  else column.set(given.subarray ? given.subarray(start, end) : given.slice(start, end));
}
