import { bytes } from "#bytes";
import { once } from "./module.js";
import { areaOf } from "./area.js";

const module = once({ plain: () => bytes(new URL("./area.wasm", import.meta.url)) });

export const Area = areaOf(module);
