import { once } from "./module.js";
import { areaOf } from "./area.js";

const module = once({ plain: () => import("./area.wasm.js").then(({ bytes }) => bytes()) });

export const Area = areaOf(module);
