// Times of a call beside other packages: medians of rounds in which each has its turn. See bench/run.

import { distance as turf } from "@turf/distance";
import { Cartesian3, Cartographic, Ellipsoid, EllipsoidGeodesic } from "cesium";
import { geoDistance } from "d3-geo";
import { project as toEcef, unproject as fromEcef } from "ecef-projector";
import geographiclib from "geographiclib-geodesic";
import { getPreciseDistance } from "geolib";
import proj4 from "proj4";
import { s2 } from "s2js";
import { Geodesic } from "terrella/geodesic";
import { Ecef } from "terrella/position";
import { Tiles } from "terrella/terrain";

const COUNT = 20_000;
const ROUNDS = 15;

const random = (() => {
  let state = 1n;
  return () => {
    state = (state * 6364136223846793005n + 1442695040888963407n) & 0xffffffffffffffffn;
    return Number(state >> 11n) / 2 ** 53;
  };
})();
const latitudes = () => Float64Array.from({ length: COUNT }, () => (180 / Math.PI) * Math.asin(2 * random() - 1));
const longitudes = () => Float64Array.from({ length: COUNT }, () => 360 * random() - 180);
const [lat1, lon1, lat2, lon2] = [latitudes(), longitudes(), latitudes(), longitudes()];
const height = lat1.map(() => 10_000 * random());

const earth = await Geodesic.on();
const ecef = await Ecef.on();
const tiles = await Tiles.of({ projection: "s2-quadratic", shift: "geodetic" });
const exact = earth.inverseAll({ lat1, lon1, lat2, lon2 }).distance;
const points = ecef.fromGeodeticAll({ lat: lat1, lon: lon1, height });
const out = new Float64Array(COUNT);
const each = (body) => () => {
  for (let i = 0; i < COUNT; i++) out[i] = body(i);
};

const wgs84 = geographiclib.Geodesic.WGS84;
const { DISTANCE, AZIMUTH } = geographiclib.Geodesic;
const radians = (degrees) => (degrees * Math.PI) / 180;
const geodesic = new EllipsoidGeodesic(undefined, undefined, Ellipsoid.WGS84);
const [start, end] = [new Cartographic(), new Cartographic()];
const cartesian = new Cartesian3();
const geocent = proj4("EPSG:4326", "+proj=geocent +datum=WGS84");

/** What is timed: by topic, name and body; the largest error of a distance in metres goes along. */
const topics = {
  "distance and azimuths": {
    "terrella, rows": () => earth.inverseAll({ lat1, lon1, lat2, lon2 }, { distance: out }),
    terrella: (() => {
      const [from, to, line] = [{}, {}, {}];
      return each((i) => {
        [from.lat, from.lon, to.lat, to.lon] = [lat1[i], lon1[i], lat2[i], lon2[i]];
        return earth.inverse(from, to, line).distance;
      });
    })(),
    "geographiclib-geodesic": each((i) => wgs84.Inverse(lat1[i], lon1[i], lat2[i], lon2[i], DISTANCE | AZIMUTH).s12),
    "Cesium, Vincenty": each((i) => {
      [start.latitude, start.longitude] = [radians(lat1[i]), radians(lon1[i])];
      [end.latitude, end.longitude] = [radians(lat2[i]), radians(lon2[i])];
      try {
        geodesic.setEndPoints(start, end);
        return geodesic.surfaceDistance;
      } catch {
        return NaN; // It refuses places that are nearly antipodal.
      }
    }),
    "geolib, Vincenty": each((i) => getPreciseDistance({ lat: lat1[i], lon: lon1[i] }, { lat: lat2[i], lon: lon2[i] }, 1e-3)),
    "Turf, sphere": each((i) => turf([lon1[i], lat1[i]], [lon2[i], lat2[i]], { units: "meters" })),
    "d3-geo, sphere": each((i) => 6371008.8 * geoDistance([lon1[i], lat1[i]], [lon2[i], lat2[i]])),
  },
  "place to Earth axes": {
    "terrella, rows": () => ecef.fromGeodeticAll({ lat: lat1, lon: lon1, height }, { x: out }),
    "ecef-projector": each((i) => toEcef(lat1[i], lon1[i], height[i])[0]),
    Cesium: each((i) => Cartesian3.fromDegrees(lon1[i], lat1[i], height[i], Ellipsoid.WGS84, cartesian).x),
    proj4: each((i) => geocent.forward([lon1[i], lat1[i], height[i]])[0]),
  },
  "Earth axes to place": {
    "terrella, rows": () => ecef.toGeodeticAll(points, { lat: out }),
    "ecef-projector": each((i) => fromEcef(points.x[i], points.y[i], points.z[i])[0]),
    Cesium: each((i) => {
      [cartesian.x, cartesian.y, cartesian.z] = [points.x[i], points.y[i], points.z[i]];
      return Cartographic.fromCartesian(cartesian, Ellipsoid.WGS84, start).latitude;
    }),
    proj4: each((i) => geocent.inverse([points.x[i], points.y[i], points.z[i]])[1]),
  },
  "S2 cell of level 20": {
    "terrella, rows": () => tiles.containingAll({ lat: lat1, lon: lon1 }, 20),
    s2js: each((i) => Number(s2.cellid.parent(s2.cellid.fromLatLng(s2.LatLng.fromDegrees(lat1[i], lon1[i])), 20) & 1n)),
  },
};

/** The largest error of a distance, and how many there are not. */
function worst(distances) {
  const errors = distances.map((distance, i) => Math.abs(distance - exact[i]));
  const none = errors.filter(Number.isNaN).length;
  return `${Math.max(...errors.filter((error) => error >= 0)).toPrecision(2)} m${none ? `, ${none} refused` : ""}`;
}

const median = (numbers) => numbers.toSorted((a, b) => a - b)[numbers.length >> 1];
for (const [topic, bodies] of Object.entries(topics)) {
  const times = new Map(Object.keys(bodies).map((name) => [name, []]));
  const errors = new Map();
  for (let round = 0; round < ROUNDS; round++) {
    for (const [name, body] of Object.entries(bodies)) {
      const begin = performance.now();
      body();
      times.get(name).push(((performance.now() - begin) * 1e6) / COUNT);
      if (topic.startsWith("distance")) errors.set(name, worst(out));
    }
  }
  const [[, ours]] = times;
  for (const [name, all] of times) {
    console.log([topic, name, median(all).toFixed(0), (median(all) / median(ours)).toFixed(1), errors.get(name) ?? ""].join("\t"));
  }
}
