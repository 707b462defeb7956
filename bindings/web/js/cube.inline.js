import { once } from "./module.js";
import { cubeMapOf } from "./cube.js";

const module = once({ plain: () => import("./cube.wasm.js").then(({ bytes }) => bytes()) });

export const CubeMap = cubeMapOf(module);
