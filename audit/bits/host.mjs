// Prints the lines of the wasm module: node host.mjs MODULE

import { readFileSync } from "node:fs";

const decoder = new TextDecoder();
const host = {
  line(start, length) {
    console.log(decoder.decode(new Uint8Array(instance.exports.memory.buffer, start, length)));
  },
};
const { instance } = await WebAssembly.instantiate(readFileSync(process.argv[2]), { host });
instance.exports.bits();
