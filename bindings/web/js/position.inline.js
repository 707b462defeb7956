import { once } from "./module.js";
import { ecefOf, localFrameOf } from "./position.js";

const module = once({
  simd: () => import("./position.simd.wasm.js").then(({ bytes }) => bytes()),
  plain: () => import("./position.wasm.js").then(({ bytes }) => bytes()),
});

export const Ecef = ecefOf(module);
export const LocalFrame = localFrameOf(module);
