import { bytes } from "#bytes";
import { once } from "./module.js";
import { cubeMapOf } from "./cube.js";

const module = once({ plain: () => bytes(new URL("./cube.wasm", import.meta.url)) });

export const CubeMap = cubeMapOf(module);
