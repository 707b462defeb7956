#include <stdio.h>
#include <terrella.h>

int main(void) {
  terrella_ellipsoid_f64 wgs84;
  terrella_karney_f64 earth;
  double metres;
  terrella_ellipsoid_named_f64(&wgs84, "wgs84");
  terrella_karney_init_f64(&earth, &wgs84);
  terrella_karney_distance_f64(&earth, 40.6, -73.8, 51.6, -0.5, &metres);
  printf("%.3f m\n", metres); // 5551759.400 m
}
