// A firmware that calls one function, in single precision: what it carries of the library.

#include "terrella.h"

int main(void) {
  terrella_ellipsoid_f32 wgs84;
  float x;
  terrella_ellipsoid_init_f32(&wgs84, 6378137, 1 / 298.257223563f);
  return terrella_ellipsoid_to_ecef_f32(&wgs84, 47, 8, 500, &x, NULL, NULL) != TERRELLA_OK || !(x > 4.3e6f && x < 4.4e6f);
}
