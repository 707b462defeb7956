// The truth through the header, within what the README claims of the crate: truth DIRECTORY CLAIM…
// The claims, in metres: inverse, direct, Earth axes below 100 km.

#include "check.h"

#define COLUMNS 16

static char line[4096];
static char *cells[COLUMNS];
static char header[4096];
static char *names[COLUMNS];

// Opens a table and reads its names; tabs part the cells.
static int split(char *text, char **into) {
  int count = 0;
  for (char *at = text; at && count < COLUMNS; count++) {
    into[count] = at;
    at = strpbrk(at, "\t\n");
    if (at) *at++ = 0;
    if (at && !*at) at = NULL;
  }
  return count;
}

static int next(FILE *file) {
  return fgets(line, sizeof line, file) && split(line, cells) > 0;
}

static FILE *table(const char *directory, const char *name) {
  char path[1024];
  snprintf(path, sizeof path, "%s/%s", directory, name);
  FILE *file = fopen(path, "r");
  if (!file) {
    printf("there is no %s\n", path);
    exit(1);
  }
  do {
    if (!fgets(header, sizeof header, file)) exit(1);
  } while (header[0] == '#');
  split(header, names);
  return file;
}

static const char *cell(const char *name) {
  for (int i = 0; i < COLUMNS && names[i]; i++)
    if (!strcmp(names[i], name)) return cells[i];
  printf("there is no column %s\n", name);
  exit(1);
}

static double number(const char *name) { return strtod(cell(name), NULL); }

// 64 bits of the truth: what they leave is a thousandth of a claim.
static double error(double computed, const char *name) {
  return (double)fabsl((long double)computed - strtold(cell(name), NULL));
}

// The largest, and NaN if one is.
static double worst(double most, double error) { return most >= error ? most : isnan(most) ? most : error; }

static void hold(const char *what, int rows, double most, double claim) {
  printf("%s: %d rows, %.2g of %g m\n", what, rows, most, claim);
  CHECK(rows > 15 && most <= claim);
}

int main(int count, char **given) {
  if (count != 5) return 2;
  const char *directory = given[1];
  terrella_ellipsoid_f64 wgs84;
  terrella_karney_f64 earth;
  OK(terrella_ellipsoid_named_f64(&wgs84, "wgs84"));
  OK(terrella_karney_init_f64(&earth, &wgs84));
  const double metre = 180 / 3.14159265358979324 / 6356752; // in degrees, of latitude at most

  int rows = 0;
  double most = 0;
  FILE *file = table(directory, "geod_inverse_wgs84.tsv");
  for (; next(file); rows++) {
    double distance = NAN;
    OK(terrella_karney_inverse_f64(&earth, number("lat1"), number("lon1"), number("lat2"), number("lon2"), &distance, NULL, NULL));
    most = worst(most, error(distance, "s12"));
  }
  fclose(file);
  hold("distance", rows, most, atof(given[2]));

  rows = 0, most = 0;
  file = table(directory, "geod_direct_wgs84.tsv");
  while (next(file)) {
    if (fabs(number("s12")) > 2e7) continue; // longer than a turn: a claim of its own
    double lat = NAN;
    OK(terrella_karney_direct_f64(&earth, number("lat1"), number("lon1"), number("azi1"), number("s12"), &lat, NULL, NULL));
    most = worst(most, error(lat, "lat2") / metre);
    rows++;
  }
  fclose(file);
  hold("destination", rows, most, atof(given[3]));

  rows = 0, most = 0;
  file = table(directory, "ecef_forward_wgs84.tsv");
  while (next(file)) {
    if (fabs(number("h")) > 1e5) continue;
    double x = NAN, y = NAN, z = NAN;
    OK(terrella_ellipsoid_to_ecef_f64(&wgs84, number("lat"), number("lon"), number("h"), &x, &y, &z));
    most = worst(most, hypot(hypot(error(x, "X"), error(y, "Y")), error(z, "Z")));
    rows++;
  }
  fclose(file);
  hold("Earth axes", rows, most, atof(given[4]));

  // GeographicLib's own cases: to 1e-13 degrees and 1e-8 metres there.
  rows = 0, most = 0;
  file = table("tests", "geodtest.tsv");
  for (; next(file); rows++) {
    double distance = NAN, azimuth1 = NAN, azimuth2 = NAN;
    OK(terrella_karney_inverse_f64(&earth, number("lat1"), number("lon1"), number("lat2"), number("lon2"), &distance, &azimuth1, &azimuth2));
    most = worst(most, error(distance, "s12"));
    CHECK(error(azimuth1, "azi1") < 1e-13 && error(azimuth2, "azi2") < 1e-13);
    double lat = NAN, lon = NAN;
    OK(terrella_karney_direct_f64(&earth, number("lat1"), number("lon1"), number("azi1"), number("s12"), &lat, &lon, NULL));
    CHECK(error(lat, "lat2") < 1e-13 && fabs(remainder(lon - number("lon2"), 360)) < 1e-13);
  }
  fclose(file);
  hold("geodtest", rows, most, 1e-8);
  return ended();
}
