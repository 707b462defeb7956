// What the header promises: refusals, NULL, arrays, handles that are copied.

#include "check.h"

_Static_assert(sizeof(terrella_karney_f64) == 872 && sizeof(terrella_karney_f32) == 448, "handles have one size");
_Static_assert(sizeof(terrella_ellipsoid_f32) == 12 && sizeof(terrella_place_f64) == 16, "handles have one size");

#define COUNT 1200 // more than two blocks

static terrella_ellipsoid_f64 wgs84;
static terrella_karney_f64 earth;

static void refusals(void) {
  terrella_ellipsoid_f64 none;
  CHECK(terrella_ellipsoid_init_f64(&none, -1, 0) == TERRELLA_SEMI_MAJOR_AXIS);
  CHECK(terrella_ellipsoid_init_f64(&none, 6e6, NAN) == TERRELLA_FLATTENING);
  CHECK(terrella_ellipsoid_init_f64(NULL, 6e6, 0) == TERRELLA_NULL);
  CHECK(terrella_ellipsoid_named_f64(&none, "wgs-84") == TERRELLA_UNKNOWN);
  CHECK(terrella_ellipsoid_named_f64(&none, NULL) == TERRELLA_NULL);
  OK(terrella_ellipsoid_init_f64(&none, 6e6, 0.3));
  terrella_karney_f64 flat;
  CHECK(terrella_karney_init_f64(&flat, &none) == TERRELLA_UNSUPPORTED_FLATTENING);
  CHECK(terrella_karney_init_f64(&flat, NULL) == TERRELLA_NULL);
  double distance = 7, lat = 7;
  // A handle that was refused, one that nobody made, and one that was made before it was refused.
  CHECK(terrella_karney_distance_f64(&flat, 0, 0, 0, 1, &distance) == TERRELLA_NOT_MADE);
  terrella_cube_f64 zero, noise;
  memset(&zero, 0, sizeof zero);
  memset(&noise, 0xa5, sizeof noise);
  CHECK(terrella_cube_project_f64(&zero, 0, 0, NULL, &lat, NULL) == TERRELLA_NOT_MADE);
  CHECK(terrella_cube_project_f64(&noise, 0, 0, NULL, &lat, NULL) == TERRELLA_NOT_MADE);
  terrella_karney_f64 again = earth;
  CHECK(terrella_karney_init_f64(&again, &none) == TERRELLA_UNSUPPORTED_FLATTENING);
  CHECK(terrella_karney_distance_f64(&again, 0, 0, 0, 1, &distance) == TERRELLA_NOT_MADE);
  CHECK(terrella_karney_inverse_f64(&earth, 91, 0, 0, 0, &distance, NULL, NULL) == TERRELLA_LATITUDE);
  CHECK(terrella_karney_inverse_f64(&earth, 0, 0, 0, INFINITY, &distance, NULL, NULL) == TERRELLA_LONGITUDE);
  CHECK(terrella_karney_inverse_f64(NULL, 0, 0, 0, 0, &distance, NULL, NULL) == TERRELLA_NULL);
  CHECK(terrella_karney_direct_f64(&earth, 0, 0, NAN, 1, &lat, NULL, NULL) == TERRELLA_AZIMUTH);
  CHECK(terrella_karney_direct_f64(&earth, 0, 0, 0, INFINITY, &lat, NULL, NULL) == TERRELLA_DISTANCE);
  CHECK(distance == 7 && lat == 7);
  OK(terrella_karney_inverse_f64(&earth, 0, 0, 0, 1, NULL, NULL, NULL));
  terrella_vincenty_f64 vincenty;
  OK(terrella_vincenty_init_f64(&vincenty, &wgs84));
  CHECK(terrella_vincenty_distance_f64(&vincenty, 0, 0, 0.3, 179.9, &distance) == TERRELLA_NOT_CONVERGED);
  CHECK(terrella_ellipsoid_to_geodetic_f64(&wgs84, 0, NAN, 0, &lat, NULL, NULL) == TERRELLA_POINT);
  CHECK(terrella_ellipsoid_to_ecef_f64(&wgs84, 0, 0, NAN, &lat, NULL, NULL) == TERRELLA_HEIGHT);
  terrella_cube_f64 cube;
  CHECK(terrella_cube_init_f64(&cube, &wgs84, "geodetic", "nothing") == TERRELLA_UNKNOWN);
  OK(terrella_cube_init_f64(&cube, &wgs84, "geodetic", "s2-quadratic"));
  CHECK(terrella_cube_unproject_f64(&cube, 6, 0, 0, &lat, NULL) == TERRELLA_FACE);
  CHECK(terrella_cube_unproject_f64(&cube, 5, 1.5, 0, &lat, NULL) == TERRELLA_FACE_POINT);
  uint64_t key = 0;
  CHECK(terrella_cube_key_f64(&cube, 0, 0, 31, &key) == TERRELLA_LEVEL);
  CHECK(terrella_tile_key(0, 2, 4, 0, &key) == TERRELLA_COLUMN_OR_ROW);
  CHECK(terrella_tile_key(256, 0, 0, 0, &key) == TERRELLA_FACE);
  CHECK(terrella_tile_key(0, 256, 0, 0, &key) == TERRELLA_LEVEL);
  CHECK(terrella_cube_unproject_f64(&cube, 260, 0, 0, &lat, NULL) == TERRELLA_FACE);
  CHECK(terrella_cube_key_f64(&cube, 0, 0, 268, &key) == TERRELLA_LEVEL);
  CHECK(terrella_tile_of_key(0, NULL, NULL, NULL, NULL) == TERRELLA_KEY);
  for (int status = TERRELLA_OK; status <= TERRELLA_OVERLAP; status++)
    CHECK(strcmp(terrella_status_text(status), terrella_status_text(-1)) != 0);
  CHECK(terrella_version() == 10000 * TERRELLA_VERSION_MAJOR + 100 * TERRELLA_VERSION_MINOR + TERRELLA_VERSION_PATCH);
}

static void arrays(void) {
  static double lat1[COUNT], lon1[COUNT], lat2[COUNT], lon2[COUNT], distance[COUNT], azimuth[COUNT];
  for (int i = 0; i < COUNT; i++) {
    lat1[i] = draw(-90, 90), lat2[i] = draw(-90, 90);
    lon1[i] = draw(-180, 180), lon2[i] = draw(-180, 180);
  }
  lat1[700] = NAN, lon2[1100] = INFINITY;
  size_t first = 0;
  CHECK(terrella_karney_inverse_all_f64(&earth, COUNT, lat1, lon1, lat2, lon2, distance, azimuth, NULL, &first) == TERRELLA_ELEMENTS);
  CHECK(first == 700 && isnan(distance[700]) && isnan(distance[1100]));
  for (int i = 0; i < COUNT; i++) {
    double metres = NAN, degrees = NAN;
    int status = terrella_karney_inverse_f64(&earth, lat1[i], lon1[i], lat2[i], lon2[i], &metres, &degrees, NULL);
    CHECK((status == TERRELLA_OK) == (i != 700 && i != 1100));
    CHECK(status != TERRELLA_OK || (metres == distance[i] && degrees == azimuth[i]));
  }
  // Results over what was given.
  CHECK(terrella_karney_inverse_all_f64(&earth, COUNT, lat1, lon1, lat2, lon2, lat1, lon1, lat2, NULL) == TERRELLA_ELEMENTS);
  CHECK(lat1[1199] == distance[1199] && lon1[3] == azimuth[3]);
  CHECK(terrella_karney_inverse_all_f64(&earth, 3, lat1, NULL, lat2, lon2, distance, NULL, NULL, NULL) == TERRELLA_NULL);
  CHECK(terrella_karney_inverse_all_f64(&earth, 9, lat1, lon1, lat2, lon2, lon1 + 1, NULL, NULL, NULL) == TERRELLA_OVERLAP);
  CHECK(terrella_karney_inverse_all_f64(&earth, 9, lat1, lon1, lat2, lon2, distance, distance, NULL, NULL) == TERRELLA_OVERLAP);
  static const double zero[9];
  OK(terrella_karney_inverse_all_f64(&earth, 9, zero, zero, zero, zero, distance, distance + 9, NULL, NULL));
  OK(terrella_karney_inverse_all_f64(&earth, 0, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL));

  static double x[COUNT], y[COUNT], z[COUNT], height[COUNT], lat[COUNT], lon[COUNT];
  for (int i = 0; i < COUNT; i++) lat[i] = draw(-90, 90), lon[i] = draw(-180, 180), height[i] = draw(-1e4, 1e5);
  OK(terrella_ellipsoid_to_ecef_all_f64(&wgs84, COUNT, lat, lon, height, x, y, z, NULL));
  OK(terrella_ellipsoid_to_geodetic_all_f64(&wgs84, COUNT, x, y, z, x, y, z, NULL));
  for (int i = 0; i < COUNT; i++) CHECK(fabs(x[i] - lat[i]) < 1e-13 && fabs(z[i] - height[i]) < 1e-8);
}

static void routes(void) {
  // Closest places of the crate's page of recipes and of the issue trackers of others.
  terrella_great_circle_f64 sphere;
  OK(terrella_great_circle_init_f64(&sphere, 6371008.8));
  double across = 0, along = 0, distance = 0;
  terrella_reach reach = TERRELLA_WITHIN;
  OK(terrella_karney_closest_f64(&earth, 0, 0, 0, 1, 1, 2, &distance, NULL, NULL, &along, &reach));
  double leg = 0, end = 0;
  OK(terrella_karney_distance_f64(&earth, 0, 0, 0, 1, &leg));
  OK(terrella_karney_distance_f64(&earth, 1, 2, 0, 1, &end));
  CHECK(reach == TERRELLA_PAST && fabs(along - leg) < 1e-8 && fabs(distance - end) < 1e-8);
  OK(terrella_great_circle_track_f64(&sphere, 0, 0, 0, 10, -1, 5, &across, &along));
  CHECK(fabs(across - 6371008.8 * 3.14159265358979324 / 180) < 1e-8);

  terrella_place_f64 ring[4];
  const double corners[4][2] = {{47, 8}, {47, 8.1}, {47.1, 8.1}, {47.1, 8}};
  for (int i = 0; i < 4; i++) OK(terrella_place_init_f64(&ring[i], corners[i][0], corners[i][1]));
  terrella_side side = TERRELLA_EDGE;
  OK(terrella_karney_fence_f64(&earth, ring, 4, 47.05, 8.05, &side, &distance));
  CHECK(side == TERRELLA_INSIDE && distance < -3700 && distance > -3900);
  OK(terrella_karney_fence_f64(&earth, ring, 4, 47.05, 8.2, &side, NULL));
  CHECK(side == TERRELLA_OUTSIDE);
  CHECK(terrella_karney_fence_f64(&earth, NULL, 4, 47, 8, &side, NULL) == TERRELLA_NULL);
  OK(terrella_karney_fence_f64(&earth, NULL, 0, 47, 8, &side, NULL));
  CHECK(side == TERRELLA_OUTSIDE);

  terrella_rhumb_f64 rhumb;
  OK(terrella_rhumb_init_f64(&rhumb, &wgs84));
  double azimuth = 0;
  OK(terrella_rhumb_inverse_f64(&rhumb, 0, 0, 0, 90, &distance, &azimuth));
  CHECK(fabs(distance - 6378137 * 3.14159265358979324 / 2) < 1e-8 && azimuth == 90);
}

static void others(void) {
  terrella_karney_f64 copy = earth;
  double distance = 0, again = 0;
  OK(terrella_karney_distance_f64(&earth, 40.6, -73.8, 51.6, -0.5, &distance));
  OK(terrella_karney_distance_f64(&copy, 40.6, -73.8, 51.6, -0.5, &again));
  CHECK(distance == again && fabs(distance - 5551759.4003) < 1e-4);

  terrella_line_f64 line;
  double lat = 0, lon = 0, height = 0;
  OK(terrella_line_init_f64(&line, &earth, 40, 10, 30));
  OK(terrella_line_at_f64(&line, 1e6, &lat, &lon, NULL));
  OK(terrella_karney_inverse_f64(&earth, 40, 10, lat, lon, &distance, NULL, NULL));
  CHECK(fabs(distance - 1e6) < 1e-8);

  terrella_area_f64 area;
  const double lats[] = {0, 0, 90}, lons[] = {0, 90, 0};
  double square = 0, perimeter = 0;
  OK(terrella_area_init_f64(&area, &wgs84));
  OK(terrella_area_polygon_f64(&area, lats, lons, 3, &square, &perimeter));
  // An eighth of the Earth: π/2 times the square of the authalic radius.
  CHECK(fabs(square - 63758202715511.06) < 0.1);
  CHECK(terrella_area_polygon_f64(&area, NULL, lons, 3, &square, NULL) == TERRELLA_NULL);

  // The antenna of the crate's first page.
  terrella_frame_f64 antenna;
  double azimuth = 0, elevation = 0, range = 0;
  OK(terrella_frame_init_f64(&antenna, &wgs84, 52, 8, 110));
  OK(terrella_frame_to_aer_f64(&antenna, 52.1, 8.3, 10000, &azimuth, &elevation, &range));
  CHECK(fabs(azimuth - 61.5) < 0.05 && fabs(elevation - 22.8) < 0.05 && fabs(range - 25417.3) < 0.05);
  OK(terrella_frame_from_aer_f64(&antenna, azimuth, elevation, range, &lat, &lon, &height));
  CHECK(fabs(lat - 52.1) < 1e-13 && fabs(lon - 8.3) < 1e-13 && fabs(height - 10000) < 1e-8);

  terrella_cube_f64 cube;
  uint64_t key = 0;
  uint8_t face = 9, level = 9;
  double south = 0, west = 0, north = 0, east = 0;
  OK(terrella_cube_init_f64(&cube, &wgs84, "geodetic", "s2-quadratic"));
  OK(terrella_cube_key_f64(&cube, 48.8566, 2.3522, 12, &key));
  CHECK(key == 0x47e66e1000000000u); // S2's cell in Paris
  OK(terrella_tile_of_key(key, &face, &level, NULL, NULL));
  OK(terrella_cube_bounds_f64(&cube, key, &south, &west, &north, &east));
  CHECK(level == 12 && south < 48.8566 && 48.8566 < north && west < 2.3522 && 2.3522 < east);

  // In single precision: the same functions, to their own claims.
  terrella_ellipsoid_f32 single;
  terrella_karney_f32 coarse;
  float metres = 0;
  OK(terrella_ellipsoid_named_f32(&single, "wgs84"));
  OK(terrella_karney_init_f32(&coarse, &single));
  OK(terrella_karney_distance_f32(&coarse, 40.6f, -73.8f, 51.6f, -0.5f, &metres));
  CHECK(fabs((double)metres - 5551759.4) < 4);
}

int main(void) {
  OK(terrella_ellipsoid_named_f64(&wgs84, "wgs84"));
  OK(terrella_karney_init_f64(&earth, &wgs84));
  refusals();
  arrays();
  routes();
  others();
  return ended();
}
