import { bytes } from "#bytes";
import { once } from "./module.js";
import { tilesOf } from "./terrain.js";

const module = once({ plain: () => bytes(new URL("./terrain.wasm", import.meta.url)) });

export const Tiles = tilesOf(module);
