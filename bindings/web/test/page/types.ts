// Compiled, not run: what the types allow, and what they refuse.

import { Area } from "terrella/area";
import { CubeMap } from "terrella/cube";
import { Geodesic } from "terrella/geodesic";
import { Ecef, LocalFrame } from "terrella/position";
import { ellipsoids, projections } from "terrella/tables";
import { Tiles } from "terrella/terrain";

const earth = await Geodesic.on(ellipsoids.wgs84);
const distance: number = earth.distance({ lat: 1, lon: 2 }, { lat: 3, lon: 4 });
const line = { distance: 0, azimuth1: 0, azimuth2: 0 };
earth.inverse({ lat: 1, lon: 2 }, { lat: 3, lon: 4 }, line).azimuth1.toFixed(1);
const rows = earth.inverseAll({ lat1: [1, 2], lon1: new Float32Array(2), lat2: 0, lon2: 0 });
const first: number | undefined = rows.refused?.first;
earth.directAll({ lat: [1], lon: [2], azimuth: 3, distance: 4 }, { lat: new Float32Array(1) });
// @ts-expect-error longitude and latitude go by name
earth.distance([1, 2], [3, 4]);
// @ts-expect-error a method is made by `on`
new Geodesic();
(await Area.on()).rings({ lat: [], lon: [], offsets: [0] }).area;
(await Ecef.on("grs80")).toGeodetic({ x: 1, y: 2, z: 3 }).height;
(await LocalFrame.at({ lat: 0, lon: 0 })).toAerAll({ lat: [1], lon: [2] }).range;
const map = await CubeMap.of({ projection: projections[0]! });
const face: Uint8Array = map.projectAll({ lat: [1], lon: [2] }).face;
// @ts-expect-error a cube map needs a projection
CubeMap.of({});
const tiles = await Tiles.of({ projection: "vertex" });
const key: bigint = tiles.containing({ lat: 1, lon: 2 }, 3);
tiles.cover({ south: 0, west: 0, north: 1, east: 1 }, 4, { inner: true }).length;

export { distance, first, face, key };
