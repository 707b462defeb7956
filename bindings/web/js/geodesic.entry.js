import { bytes } from "#bytes";
import { once } from "./module.js";
import { geodesicOf } from "./geodesic.js";

const module = once({
  simd: () => bytes(new URL("./geodesic.simd.wasm", import.meta.url)),
  plain: () => bytes(new URL("./geodesic.wasm", import.meta.url)),
});

export const Geodesic = geodesicOf(module);
