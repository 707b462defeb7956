// The calls of coming-from.md.

#include "check.h"

int main(void) {
  double a = 6378137, f = 1 / 298.257223563, s12 = 0, azi1 = 0, azi2 = 0, lat2 = 0, lon2 = 0, A = 0, P = 0;
  const double lats[] = {47, 47, 47.1, 47.1}, lons[] = {8, 8.1, 8.1, 8};

  // GeographicLib's geodesic.h
  terrella_ellipsoid_f64 e;
  terrella_karney_f64 k;
  terrella_line_f64 l;
  terrella_area_f64 m;
  OK(terrella_ellipsoid_init_f64(&e, a, f));
  OK(terrella_karney_init_f64(&k, &e));
  OK(terrella_karney_inverse_f64(&k, 47, 8, 48, 9, &s12, &azi1, &azi2));
  OK(terrella_karney_distance_f64(&k, 47, 8, 48, 9, &s12));
  OK(terrella_karney_direct_f64(&k, 47, 8, azi1, s12, &lat2, &lon2, &azi2));
  CHECK(fabs(lat2 - 48) < 1e-12 && fabs(lon2 - 9) < 1e-12);
  OK(terrella_line_init_f64(&l, &k, 47, 8, azi1));
  OK(terrella_line_at_f64(&l, s12, &lat2, &lon2, &azi2));
  CHECK(fabs(lat2 - 48) < 1e-12);
  OK(terrella_area_init_f64(&m, &e));
  OK(terrella_area_polygon_f64(&m, lats, lons, 4, &A, &P));
  CHECK(A > 8.4e7 && A < 8.5e7 && P > 37e3 && P < 38e3);
  CHECK(terrella_karney_distance_f64(&k, 91, 8, 48, 9, &s12) == TERRELLA_LATITUDE);

  // PX4's geo library
  terrella_great_circle_f64 s;
  double metres = 0, azimuth = 0, across = 0, along = 0, north = 0, east = 0;
  terrella_reach reach = TERRELLA_WITHIN;
  OK(terrella_great_circle_init_f64(&s, 6371000));
  OK(terrella_great_circle_distance_f64(&s, 47, 8, 47.01, 8, &metres));
  CHECK(fabs(metres - 6371000 * 0.01 * 3.14159265358979324 / 180) < 1e-8);
  OK(terrella_great_circle_inverse_f64(&s, 47, 8, 47.01, 8, NULL, &azimuth, NULL));
  CHECK(azimuth == 0);
  OK(terrella_great_circle_direct_f64(&s, 47, 8, azimuth, metres, &lat2, &lon2, NULL));
  CHECK(fabs(lat2 - 47.01) < 1e-12);
  OK(terrella_karney_track_f64(&k, 47, 8, 48, 8, 47.5, 8.001, &across, &along));
  CHECK(across > 75 && across < 76); // to the right of a way north
  OK(terrella_karney_closest_f64(&k, 47, 8, 47.1, 8, 47.2, 8, &metres, NULL, NULL, &along, &reach));
  CHECK(reach == TERRELLA_PAST);
  terrella_frame_f64 here;
  double lat = 0, lon = 0, height = 0;
  OK(terrella_frame_init_f64(&here, &e, 47, 8, 500));
  OK(terrella_frame_to_ned_f64(&here, 47.001, 8, 500, &north, &east, NULL));
  CHECK(north > 111 && north < 112 && fabs(east) < 1e-9);
  OK(terrella_frame_from_ned_f64(&here, north, east, 0, &lat, &lon, &height));
  CHECK(fabs(lat - 47.001) < 1e-12);

  // ArduPilot's Location
  terrella_place_f64 ring[4];
  terrella_side side = TERRELLA_EDGE;
  for (int i = 0; i < 4; i++) OK(terrella_place_init_f64(&ring[i], lats[i], lons[i]));
  OK(terrella_karney_fence_f64(&k, ring, 4, 47.05, 8.05, &side, &metres));
  CHECK(side == TERRELLA_INSIDE && metres < 0);
  return ended();
}
