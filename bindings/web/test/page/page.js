// What each bundler bundles: one call of each entry, and its result as the page's title.

import { Area } from "terrella/area";
import { CubeMap } from "terrella/cube";
import { Geodesic } from "terrella/geodesic";
import { Ecef } from "terrella/position";
import { Tiles } from "terrella/terrain";

const earth = await Geodesic.on("wgs84");
const found = [
  earth.distance({ lat: 40.6, lon: -73.8 }, { lat: 51.6, lon: -0.5 }).toFixed(3),
  (await Area.on()).ring({ lat: [0, 0, 90], lon: [0, 90, 0] }).area.toFixed(0),
  (await Ecef.on()).fromGeodetic({ lat: 0, lon: 90 }).y.toFixed(0),
  (await CubeMap.of({ projection: "adjusted" })).project({ lat: 0, lon: 100 }).face,
  (await Tiles.of({ projection: "s2-quadratic", shift: "geodetic" })).containing({ lat: 48.8566, lon: 2.3522 }, 12).toString(16),
];
globalThis.document ? (document.title = found.join(" ")) : console.log(found.join(" "));
