// One number of the bits of every kind of result: the same on every machine, and as from Rust (examples/bits.rs).

#include "check.h"

static uint64_t hash = 0xcbf29ce484222325u;

static void add(uint64_t word) {
  for (int i = 0; i < 8; i++) hash = (hash ^ (word >> (8 * i) & 255)) * 0x100000001b3u;
}

static void add_f64(double number) {
  uint64_t word;
  memcpy(&word, &number, 8);
  add(word);
}

static void add_f32(float number) {
  uint32_t word;
  memcpy(&word, &number, 4);
  add(word);
}

int main(void) {
  terrella_ellipsoid_f64 wgs84;
  terrella_karney_f64 earth;
  terrella_cube_f64 cube;
  terrella_ellipsoid_f32 wgs84_f32;
  terrella_karney_f32 earth_f32;
  OK(terrella_ellipsoid_named_f64(&wgs84, "wgs84"));
  OK(terrella_karney_init_f64(&earth, &wgs84));
  OK(terrella_cube_init_f64(&cube, &wgs84, "authalic", "vertex"));
  OK(terrella_ellipsoid_named_f32(&wgs84_f32, "wgs84"));
  OK(terrella_karney_init_f32(&earth_f32, &wgs84_f32));
  for (int i = 0; i < 200; i++) {
    double lat1 = draw(-90, 90), lon1 = draw(-180, 180), lat2 = draw(-90, 90), lon2 = draw(-180, 180);
    double a = 0, b = 0, c = 0;
    float d = 0, e = 0;
    uint8_t face = 0;
    OK(terrella_karney_inverse_f64(&earth, lat1, lon1, lat2, lon2, &a, &b, &c));
    add_f64(a), add_f64(b), add_f64(c);
    OK(terrella_karney_direct_f64(&earth, lat1, lon1, b, a, &a, &b, &c));
    add_f64(a), add_f64(b), add_f64(c);
    OK(terrella_ellipsoid_to_ecef_f64(&wgs84, lat1, lon1, lat2, &a, &b, &c));
    add_f64(a), add_f64(b), add_f64(c);
    OK(terrella_cube_project_f64(&cube, lat1, lon1, &face, &a, &b));
    add(face), add_f64(a), add_f64(b);
    OK(terrella_karney_closest_f64(&earth, lat1, lon1, lat2, lon2, 10, 20, &a, NULL, NULL, &b, NULL));
    add_f64(a), add_f64(b);
    OK(terrella_karney_inverse_f32(&earth_f32, (float)lat1, (float)lon1, (float)lat2, (float)lon2, &d, &e, NULL));
    add_f32(d), add_f32(e);
  }
  printf("%016llx\n", (unsigned long long)hash);
  return ended();
}
