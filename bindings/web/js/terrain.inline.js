import { once } from "./module.js";
import { tilesOf } from "./terrain.js";

const module = once({ plain: () => import("./terrain.wasm.js").then(({ bytes }) => bytes()) });

export const Tiles = tilesOf(module);
