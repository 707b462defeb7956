import { once } from "./module.js";
import { geodesicOf } from "./geodesic.js";

const module = once({
  simd: () => import("./geodesic.simd.wasm.js").then(({ bytes }) => bytes()),
  plain: () => import("./geodesic.wasm.js").then(({ bytes }) => bytes()),
});

export const Geodesic = geodesicOf(module);
