import { bytes } from "#bytes";
import { once } from "./module.js";
import { ecefOf, localFrameOf } from "./position.js";

const module = once({
  simd: () => bytes(new URL("./position.simd.wasm", import.meta.url)),
  plain: () => bytes(new URL("./position.wasm", import.meta.url)),
});

export const Ecef = ecefOf(module);
export const LocalFrame = localFrameOf(module);
