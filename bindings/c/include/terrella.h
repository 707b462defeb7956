// terrella for C: geodesics, areas, routes and fences, Earth axes, local frames, cube maps and tiles, in double (`_f64`) and
// single precision (`_f32`). Made from bindings/c/src by bindings/c/header.
//
// Angles are in degrees, azimuths clockwise from north, lengths in metres; latitude comes before longitude. Functions return
// a status, 0 if all is well; if not, nothing is written. A result whose pointer is NULL is not wanted.
// Handles are structs in your memory: made by `init`, copied by assignment, forgotten without a call. They hold no pointers.

#pragma once

#include <stddef.h>
#include <stdint.h>

// The major version of this header.
#define TERRELLA_VERSION_MAJOR 0

// The minor version of this header.
#define TERRELLA_VERSION_MINOR 1

// The patch version of this header.
#define TERRELLA_VERSION_PATCH 0

// What a function returns: 0 if all is well, or one number for each refusal. Nothing is written then. Numbers are
// never used again for something else.
enum terrella_status
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Status: all is well.
  TERRELLA_OK = 0,
  // Status: a latitude is not in [-90, 90] degrees.
  TERRELLA_LATITUDE = 1,
  // Status: a longitude is not finite.
  TERRELLA_LONGITUDE = 2,
  // Status: a height is not finite.
  TERRELLA_HEIGHT = 3,
  // Status: a point is not finite.
  TERRELLA_POINT = 4,
  // Status: a vector has no direction.
  TERRELLA_DIRECTION = 5,
  // Status: a semi-major axis is not in [1e-15, 1e15] metres.
  TERRELLA_SEMI_MAJOR_AXIS = 6,
  // Status: a flattening is not in [-1000, 1).
  TERRELLA_FLATTENING = 7,
  // Status: the flattening is outside the range in which this formula is accurate.
  TERRELLA_UNSUPPORTED_FLATTENING = 8,
  // Status: an azimuth is not finite.
  TERRELLA_AZIMUTH = 9,
  // Status: a distance is not finite.
  TERRELLA_DISTANCE = 10,
  // Status: a distance is longer than this method allows.
  TERRELLA_TOO_FAR = 11,
  // Status: the method does not converge between these places.
  TERRELLA_NOT_CONVERGED = 12,
  // Status: a fraction makes no finite distance.
  TERRELLA_FRACTION = 13,
  // Status: a face is not in 0 to 5.
  TERRELLA_FACE = 14,
  // Status: a point of a face is not in [-1, 1].
  TERRELLA_FACE_POINT = 15,
  // Status: a level is not in 0 to 30.
  TERRELLA_LEVEL = 16,
  // Status: a column or row is not in 0 to 2^level - 1.
  TERRELLA_COLUMN_OR_ROW = 17,
  // Status: a number is not the key of a tile.
  TERRELLA_KEY = 18,
  // Status: there is no such projection, shift or ellipsoid.
  TERRELLA_UNKNOWN = 19,
  // Status: a pointer is NULL that may not be.
  TERRELLA_NULL = 20,
  // Status: elements of the arrays were refused: their results are NaN, and all others are written.
  TERRELLA_ELEMENTS = 21,
  // Status: a handle was not made, or its init was refused.
  TERRELLA_NOT_MADE = 22,
  // Status: an array for results overlaps another in part; it may be one that is given, or apart from all.
  TERRELLA_OVERLAP = 23,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum terrella_status terrella_status;
#else
typedef int32_t terrella_status;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// Which part of a leg is closest to a place.
enum terrella_reach
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Its start: the place is before it.
  TERRELLA_BEFORE = -1,
  // A place between its ends.
  TERRELLA_WITHIN = 0,
  // Its end: the place is past it.
  TERRELLA_PAST = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum terrella_reach terrella_reach;
#else
typedef int32_t terrella_reach;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// On which side of a fence a place is.
enum terrella_side
#if defined(__cplusplus) || __STDC_VERSION__ >= 202311L
  : int32_t
#endif // defined(__cplusplus) || __STDC_VERSION__ >= 202311L
 {
  // Outside.
  TERRELLA_OUTSIDE = -1,
  // On the edge.
  TERRELLA_EDGE = 0,
  // Inside.
  TERRELLA_INSIDE = 1,
};
#ifndef __cplusplus
#if __STDC_VERSION__ >= 202311L
typedef enum terrella_side terrella_side;
#else
typedef int32_t terrella_side;
#endif // __STDC_VERSION__ >= 202311L
#endif // __cplusplus

// The measure of areas on an ellipsoid.
typedef struct {
  double words[188];
  uint32_t made;
} terrella_area_f64;

// An ellipsoid of revolution.
typedef struct {
  double words[2];
  uint32_t made;
} terrella_ellipsoid_f64;

// The measure of areas on an ellipsoid.
typedef struct {
  uint64_t words[96];
  uint32_t made;
} terrella_area_f32;

// An ellipsoid of revolution.
typedef struct {
  float words[2];
  uint32_t made;
} terrella_ellipsoid_f32;

// Karney's geodesics: exact between any two places.
typedef struct {
  double words[108];
  uint32_t made;
} terrella_karney_f64;

// Karney's geodesics.
typedef struct {
  uint64_t words[55];
  uint32_t made;
} terrella_karney_f32;

// A map of an ellipsoid onto the faces of a cube, by any projection.
typedef struct {
  double words[38];
  uint32_t made;
} terrella_cube_f64;

// A map of an ellipsoid onto the faces of a cube, by any projection.
typedef struct {
  float words[38];
  uint32_t made;
} terrella_cube_f32;

// Axes about an origin.
typedef struct {
  double words[14];
  uint32_t made;
} terrella_frame_f64;

// Axes about an origin.
typedef struct {
  float words[14];
  uint32_t made;
} terrella_frame_f32;

// Vincenty's formulas (1975), which may not converge between nearly antipodal places.
typedef struct {
  double words[4];
  uint32_t made;
} terrella_vincenty_f64;

// Andoyer's formula to the second order in the flattening.
typedef struct {
  double words[4];
  uint32_t made;
} terrella_andoyer_second_f64;

// Vincenty's formulas (1975).
typedef struct {
  float words[4];
  uint32_t made;
} terrella_vincenty_f32;

// Andoyer's formula to the second order in the flattening.
typedef struct {
  float words[4];
  uint32_t made;
} terrella_andoyer_second_f32;

// Great circles of a sphere.
typedef struct {
  double words[1];
  uint32_t made;
} terrella_great_circle_f64;

// A geodesic from a place at an azimuth, along which many places are found.
typedef struct {
  double words[150];
  uint32_t made;
} terrella_line_f64;

// Great circles of a sphere.
typedef struct {
  float words[1];
  uint32_t made;
} terrella_great_circle_f32;

// A geodesic from a place at an azimuth.
typedef struct {
  uint64_t words[76];
  uint32_t made;
} terrella_line_f32;

// A place that was checked: a corner of a fence.
typedef struct {
  double words[2];
} terrella_place_f64;

// A place that was checked: a corner of a fence.
typedef struct {
  float words[2];
} terrella_place_f32;

// Rhumb lines: lines of constant azimuth.
typedef struct {
  double words[69];
  uint32_t made;
} terrella_rhumb_f64;

// Rhumb lines: lines of constant azimuth.
typedef struct {
  float words[69];
  uint32_t made;
} terrella_rhumb_f32;

#ifdef __cplusplus
extern "C" {
#endif // __cplusplus

// Makes the measure of areas on an ellipsoid.
terrella_status terrella_area_init_f64(terrella_area_f64 *area, const terrella_ellipsoid_f64 *ellipsoid);

// The area in m² and the perimeter in metres of a polygon with geodesic edges: positive counter-clockwise. The last
// corner is joined to the first.
terrella_status terrella_area_polygon_f64(const terrella_area_f64 *area,
                                          const double *lat,
                                          const double *lon,
                                          size_t count,
                                          double *square_metres,
                                          double *perimeter);

// Makes the measure of areas on an ellipsoid.
terrella_status terrella_area_init_f32(terrella_area_f32 *area, const terrella_ellipsoid_f32 *ellipsoid);

// The area in m² and the perimeter in metres of a polygon with geodesic edges: positive counter-clockwise. The last
// corner is joined to the first.
terrella_status terrella_area_polygon_f32(const terrella_area_f32 *area,
                                          const float *lat,
                                          const float *lon,
                                          size_t count,
                                          float *square_metres,
                                          float *perimeter);

// `terrella_karney_inverse` for arrays of `count` elements, several at a time where the machine has vectors. What is
// refused becomes NaN, and the index of the first such goes to `first_refused`, which is not written if nothing is
// refused. Arrays for results may be arrays that are given, or apart from all. It takes 12 kB of stack (f32: 6), with
// vectors more.
terrella_status terrella_karney_inverse_all_f64(const terrella_karney_f64 *karney,
                                                size_t count,
                                                const double *lat1,
                                                const double *lon1,
                                                const double *lat2,
                                                const double *lon2,
                                                double *distance,
                                                double *azimuth1,
                                                double *azimuth2,
                                                size_t *first_refused);

// `terrella_karney_direct` for arrays, in the manner of `terrella_karney_inverse_all`.
terrella_status terrella_karney_direct_all_f64(const terrella_karney_f64 *karney,
                                               size_t count,
                                               const double *lat1,
                                               const double *lon1,
                                               const double *azimuth1,
                                               const double *distance,
                                               double *lat2,
                                               double *lon2,
                                               double *azimuth2,
                                               size_t *first_refused);

// `terrella_ellipsoid_to_ecef` for arrays, in the manner of `terrella_karney_inverse_all`.
terrella_status terrella_ellipsoid_to_ecef_all_f64(const terrella_ellipsoid_f64 *ellipsoid,
                                                   size_t count,
                                                   const double *lat,
                                                   const double *lon,
                                                   const double *height,
                                                   double *x,
                                                   double *y,
                                                   double *z,
                                                   size_t *first_refused);

// `terrella_ellipsoid_to_geodetic` for arrays, in the manner of `terrella_karney_inverse_all`.
terrella_status terrella_ellipsoid_to_geodetic_all_f64(const terrella_ellipsoid_f64 *ellipsoid,
                                                       size_t count,
                                                       const double *x,
                                                       const double *y,
                                                       const double *z,
                                                       double *lat,
                                                       double *lon,
                                                       double *height,
                                                       size_t *first_refused);

// `terrella_karney_inverse` for arrays of `count` elements, several at a time where the machine has vectors. What is
// refused becomes NaN, and the index of the first such goes to `first_refused`, which is not written if nothing is
// refused. Arrays for results may be arrays that are given, or apart from all. It takes 12 kB of stack (f32: 6), with
// vectors more.
terrella_status terrella_karney_inverse_all_f32(const terrella_karney_f32 *karney,
                                                size_t count,
                                                const float *lat1,
                                                const float *lon1,
                                                const float *lat2,
                                                const float *lon2,
                                                float *distance,
                                                float *azimuth1,
                                                float *azimuth2,
                                                size_t *first_refused);

// `terrella_karney_direct` for arrays, in the manner of `terrella_karney_inverse_all`.
terrella_status terrella_karney_direct_all_f32(const terrella_karney_f32 *karney,
                                               size_t count,
                                               const float *lat1,
                                               const float *lon1,
                                               const float *azimuth1,
                                               const float *distance,
                                               float *lat2,
                                               float *lon2,
                                               float *azimuth2,
                                               size_t *first_refused);

// `terrella_ellipsoid_to_ecef` for arrays, in the manner of `terrella_karney_inverse_all`.
terrella_status terrella_ellipsoid_to_ecef_all_f32(const terrella_ellipsoid_f32 *ellipsoid,
                                                   size_t count,
                                                   const float *lat,
                                                   const float *lon,
                                                   const float *height,
                                                   float *x,
                                                   float *y,
                                                   float *z,
                                                   size_t *first_refused);

// `terrella_ellipsoid_to_geodetic` for arrays, in the manner of `terrella_karney_inverse_all`.
terrella_status terrella_ellipsoid_to_geodetic_all_f32(const terrella_ellipsoid_f32 *ellipsoid,
                                                       size_t count,
                                                       const float *x,
                                                       const float *y,
                                                       const float *z,
                                                       float *lat,
                                                       float *lon,
                                                       float *height,
                                                       size_t *first_refused);

// Makes a map: by a projection, such as "adjusted", "s2-quadratic" or "vertex", and a shift, "geodetic",
// "geocentric", "parametric", "authalic", "conformal" or "rectifying".
terrella_status terrella_cube_init_f64(terrella_cube_f64 *cube,
                                       const terrella_ellipsoid_f64 *ellipsoid,
                                       const char *shift,
                                       const char *projection);

// From a place in degrees to a face, 0 front (0° N 0° E), 1 right, 2 back, 3 left, 4 top, 5 bottom, and x and y in
// [−1, 1] on it.
terrella_status terrella_cube_project_f64(const terrella_cube_f64 *cube,
                                          double lat,
                                          double lon,
                                          uint8_t *face,
                                          double *x,
                                          double *y);

// The inverse of `terrella_cube_project`.
terrella_status terrella_cube_unproject_f64(const terrella_cube_f64 *cube,
                                            uint32_t face,
                                            double x,
                                            double y,
                                            double *lat,
                                            double *lon);

// Makes a map: by a projection, such as "adjusted", "s2-quadratic" or "vertex", and a shift, "geodetic",
// "geocentric", "parametric", "authalic", "conformal" or "rectifying".
terrella_status terrella_cube_init_f32(terrella_cube_f32 *cube,
                                       const terrella_ellipsoid_f32 *ellipsoid,
                                       const char *shift,
                                       const char *projection);

// From a place in degrees to a face, 0 front (0° N 0° E), 1 right, 2 back, 3 left, 4 top, 5 bottom, and x and y in
// [−1, 1] on it.
terrella_status terrella_cube_project_f32(const terrella_cube_f32 *cube,
                                          float lat,
                                          float lon,
                                          uint8_t *face,
                                          float *x,
                                          float *y);

// The inverse of `terrella_cube_project`.
terrella_status terrella_cube_unproject_f32(const terrella_cube_f32 *cube,
                                            uint32_t face,
                                            float x,
                                            float y,
                                            float *lat,
                                            float *lon);

// Makes the ellipsoid of a semi-major axis in metres and a flattening (a − b)/a.
terrella_status terrella_ellipsoid_init_f64(terrella_ellipsoid_f64 *ellipsoid, double a, double f);

// Makes the ellipsoid of a name, such as "wgs84", "grs80" or "moon".
terrella_status terrella_ellipsoid_named_f64(terrella_ellipsoid_f64 *ellipsoid, const char *name);

// From latitude and longitude in degrees and height in metres to Earth axes in metres: x toward 0° N 0° E, y toward
// 0° N 90° E, z toward the north pole. Within 1 nm (f32: 0.5 m) below 100 km.
terrella_status terrella_ellipsoid_to_ecef_f64(const terrella_ellipsoid_f64 *ellipsoid,
                                               double lat,
                                               double lon,
                                               double height,
                                               double *x,
                                               double *y,
                                               double *z);

// The inverse of `terrella_ellipsoid_to_ecef`. Within 2.2 nm (f32: 1.2 m) below 100 km.
terrella_status terrella_ellipsoid_to_geodetic_f64(const terrella_ellipsoid_f64 *ellipsoid,
                                                   double x,
                                                   double y,
                                                   double z,
                                                   double *lat,
                                                   double *lon,
                                                   double *height);

// Makes the ellipsoid of a semi-major axis in metres and a flattening (a − b)/a.
terrella_status terrella_ellipsoid_init_f32(terrella_ellipsoid_f32 *ellipsoid, float a, float f);

// Makes the ellipsoid of a name, such as "wgs84", "grs80" or "moon".
terrella_status terrella_ellipsoid_named_f32(terrella_ellipsoid_f32 *ellipsoid, const char *name);

// From latitude and longitude in degrees and height in metres to Earth axes in metres: x toward 0° N 0° E, y toward
// 0° N 90° E, z toward the north pole. Within 1 nm (f32: 0.5 m) below 100 km.
terrella_status terrella_ellipsoid_to_ecef_f32(const terrella_ellipsoid_f32 *ellipsoid,
                                               float lat,
                                               float lon,
                                               float height,
                                               float *x,
                                               float *y,
                                               float *z);

// The inverse of `terrella_ellipsoid_to_ecef`. Within 2.2 nm (f32: 1.2 m) below 100 km.
terrella_status terrella_ellipsoid_to_geodetic_f32(const terrella_ellipsoid_f32 *ellipsoid,
                                                   float x,
                                                   float y,
                                                   float z,
                                                   float *lat,
                                                   float *lon,
                                                   float *height);

// Makes the axes about an origin, in degrees and metres.
terrella_status terrella_frame_init_f64(terrella_frame_f64 *frame,
                                        const terrella_ellipsoid_f64 *ellipsoid,
                                        double lat,
                                        double lon,
                                        double height);

// From a place in degrees and a height in metres to east, north and up, in metres.
terrella_status terrella_frame_to_enu_f64(const terrella_frame_f64 *frame,
                                          double lat,
                                          double lon,
                                          double height,
                                          double *east,
                                          double *north,
                                          double *up);

// From east, north and up, in metres to a place in degrees and a height in metres.
terrella_status terrella_frame_from_enu_f64(const terrella_frame_f64 *frame,
                                            double east,
                                            double north,
                                            double up,
                                            double *lat,
                                            double *lon,
                                            double *height);

// From a place in degrees and a height in metres to north, east and down, in metres.
terrella_status terrella_frame_to_ned_f64(const terrella_frame_f64 *frame,
                                          double lat,
                                          double lon,
                                          double height,
                                          double *north,
                                          double *east,
                                          double *down);

// From north, east and down, in metres to a place in degrees and a height in metres.
terrella_status terrella_frame_from_ned_f64(const terrella_frame_f64 *frame,
                                            double north,
                                            double east,
                                            double down,
                                            double *lat,
                                            double *lon,
                                            double *height);

// From a place in degrees and a height in metres to azimuth clockwise from north and elevation, in degrees, and range in metres.
terrella_status terrella_frame_to_aer_f64(const terrella_frame_f64 *frame,
                                          double lat,
                                          double lon,
                                          double height,
                                          double *azimuth,
                                          double *elevation,
                                          double *range);

// From azimuth clockwise from north and elevation, in degrees, and range in metres to a place in degrees and a height in metres.
terrella_status terrella_frame_from_aer_f64(const terrella_frame_f64 *frame,
                                            double azimuth,
                                            double elevation,
                                            double range,
                                            double *lat,
                                            double *lon,
                                            double *height);

// Makes the axes about an origin, in degrees and metres.
terrella_status terrella_frame_init_f32(terrella_frame_f32 *frame,
                                        const terrella_ellipsoid_f32 *ellipsoid,
                                        float lat,
                                        float lon,
                                        float height);

// From a place in degrees and a height in metres to east, north and up, in metres.
terrella_status terrella_frame_to_enu_f32(const terrella_frame_f32 *frame,
                                          float lat,
                                          float lon,
                                          float height,
                                          float *east,
                                          float *north,
                                          float *up);

// From east, north and up, in metres to a place in degrees and a height in metres.
terrella_status terrella_frame_from_enu_f32(const terrella_frame_f32 *frame,
                                            float east,
                                            float north,
                                            float up,
                                            float *lat,
                                            float *lon,
                                            float *height);

// From a place in degrees and a height in metres to north, east and down, in metres.
terrella_status terrella_frame_to_ned_f32(const terrella_frame_f32 *frame,
                                          float lat,
                                          float lon,
                                          float height,
                                          float *north,
                                          float *east,
                                          float *down);

// From north, east and down, in metres to a place in degrees and a height in metres.
terrella_status terrella_frame_from_ned_f32(const terrella_frame_f32 *frame,
                                            float north,
                                            float east,
                                            float down,
                                            float *lat,
                                            float *lon,
                                            float *height);

// From a place in degrees and a height in metres to azimuth clockwise from north and elevation, in degrees, and range in metres.
terrella_status terrella_frame_to_aer_f32(const terrella_frame_f32 *frame,
                                          float lat,
                                          float lon,
                                          float height,
                                          float *azimuth,
                                          float *elevation,
                                          float *range);

// From azimuth clockwise from north and elevation, in degrees, and range in metres to a place in degrees and a height in metres.
terrella_status terrella_frame_from_aer_f32(const terrella_frame_f32 *frame,
                                            float azimuth,
                                            float elevation,
                                            float range,
                                            float *lat,
                                            float *lon,
                                            float *height);

// Makes the method on an ellipsoid.
terrella_status terrella_karney_init_f64(terrella_karney_f64 *method,
                                         const terrella_ellipsoid_f64 *ellipsoid);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Within 7 nm on the Earth between any two places, in f32 within 4 m.
terrella_status terrella_karney_inverse_f64(const terrella_karney_f64 *method,
                                            double lat1,
                                            double lon1,
                                            double lat2,
                                            double lon2,
                                            double *distance,
                                            double *azimuth1,
                                            double *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_karney_distance_f64(const terrella_karney_f64 *method,
                                             double lat1,
                                             double lon1,
                                             double lat2,
                                             double lon2,
                                             double *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Within 7 nm on the Earth between any two places, in f32 within 4 m.
terrella_status terrella_karney_direct_f64(const terrella_karney_f64 *method,
                                           double lat1,
                                           double lon1,
                                           double azimuth1,
                                           double distance,
                                           double *lat2,
                                           double *lon2,
                                           double *azimuth2);

// Makes the method on an ellipsoid.
terrella_status terrella_vincenty_init_f64(terrella_vincenty_f64 *method,
                                           const terrella_ellipsoid_f64 *ellipsoid);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Within 0.1 mm where it converges.
terrella_status terrella_vincenty_inverse_f64(const terrella_vincenty_f64 *method,
                                              double lat1,
                                              double lon1,
                                              double lat2,
                                              double lon2,
                                              double *distance,
                                              double *azimuth1,
                                              double *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_vincenty_distance_f64(const terrella_vincenty_f64 *method,
                                               double lat1,
                                               double lon1,
                                               double lat2,
                                               double lon2,
                                               double *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Within 0.1 mm where it converges.
terrella_status terrella_vincenty_direct_f64(const terrella_vincenty_f64 *method,
                                             double lat1,
                                             double lon1,
                                             double azimuth1,
                                             double distance,
                                             double *lat2,
                                             double *lon2,
                                             double *azimuth2);

// Makes the method on an ellipsoid.
terrella_status terrella_andoyer_second_init_f64(terrella_andoyer_second_f64 *method,
                                                 const terrella_ellipsoid_f64 *ellipsoid);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Within 2e-9 of the distance to 3000 km; from 10 000 km on 0.2 m and more.
terrella_status terrella_andoyer_second_inverse_f64(const terrella_andoyer_second_f64 *method,
                                                    double lat1,
                                                    double lon1,
                                                    double lat2,
                                                    double lon2,
                                                    double *distance,
                                                    double *azimuth1,
                                                    double *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_andoyer_second_distance_f64(const terrella_andoyer_second_f64 *method,
                                                     double lat1,
                                                     double lon1,
                                                     double lat2,
                                                     double lon2,
                                                     double *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Within 2e-9 of the distance to 3000 km; from 10 000 km on 0.2 m and more.
terrella_status terrella_andoyer_second_direct_f64(const terrella_andoyer_second_f64 *method,
                                                   double lat1,
                                                   double lon1,
                                                   double azimuth1,
                                                   double distance,
                                                   double *lat2,
                                                   double *lon2,
                                                   double *azimuth2);

// Makes the method on an ellipsoid.
terrella_status terrella_karney_init_f32(terrella_karney_f32 *method,
                                         const terrella_ellipsoid_f32 *ellipsoid);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Within 7 nm on the Earth between any two places, in f32 within 4 m.
terrella_status terrella_karney_inverse_f32(const terrella_karney_f32 *method,
                                            float lat1,
                                            float lon1,
                                            float lat2,
                                            float lon2,
                                            float *distance,
                                            float *azimuth1,
                                            float *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_karney_distance_f32(const terrella_karney_f32 *method,
                                             float lat1,
                                             float lon1,
                                             float lat2,
                                             float lon2,
                                             float *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Within 7 nm on the Earth between any two places, in f32 within 4 m.
terrella_status terrella_karney_direct_f32(const terrella_karney_f32 *method,
                                           float lat1,
                                           float lon1,
                                           float azimuth1,
                                           float distance,
                                           float *lat2,
                                           float *lon2,
                                           float *azimuth2);

// Makes the method on an ellipsoid.
terrella_status terrella_vincenty_init_f32(terrella_vincenty_f32 *method,
                                           const terrella_ellipsoid_f32 *ellipsoid);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Within 0.1 mm where it converges.
terrella_status terrella_vincenty_inverse_f32(const terrella_vincenty_f32 *method,
                                              float lat1,
                                              float lon1,
                                              float lat2,
                                              float lon2,
                                              float *distance,
                                              float *azimuth1,
                                              float *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_vincenty_distance_f32(const terrella_vincenty_f32 *method,
                                               float lat1,
                                               float lon1,
                                               float lat2,
                                               float lon2,
                                               float *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Within 0.1 mm where it converges.
terrella_status terrella_vincenty_direct_f32(const terrella_vincenty_f32 *method,
                                             float lat1,
                                             float lon1,
                                             float azimuth1,
                                             float distance,
                                             float *lat2,
                                             float *lon2,
                                             float *azimuth2);

// Makes the method on an ellipsoid.
terrella_status terrella_andoyer_second_init_f32(terrella_andoyer_second_f32 *method,
                                                 const terrella_ellipsoid_f32 *ellipsoid);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Within 2e-9 of the distance to 3000 km; from 10 000 km on 0.2 m and more.
terrella_status terrella_andoyer_second_inverse_f32(const terrella_andoyer_second_f32 *method,
                                                    float lat1,
                                                    float lon1,
                                                    float lat2,
                                                    float lon2,
                                                    float *distance,
                                                    float *azimuth1,
                                                    float *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_andoyer_second_distance_f32(const terrella_andoyer_second_f32 *method,
                                                     float lat1,
                                                     float lon1,
                                                     float lat2,
                                                     float lon2,
                                                     float *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Within 2e-9 of the distance to 3000 km; from 10 000 km on 0.2 m and more.
terrella_status terrella_andoyer_second_direct_f32(const terrella_andoyer_second_f32 *method,
                                                   float lat1,
                                                   float lon1,
                                                   float azimuth1,
                                                   float distance,
                                                   float *lat2,
                                                   float *lon2,
                                                   float *azimuth2);

// Makes the method on a sphere of a radius in metres; 6371008.8 is the Earth's mean.
terrella_status terrella_great_circle_init_f64(terrella_great_circle_f64 *method, double radius);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Exact on the sphere: within 8e-16 of the distance, in f32 4.2e-7.
terrella_status terrella_great_circle_inverse_f64(const terrella_great_circle_f64 *method,
                                                  double lat1,
                                                  double lon1,
                                                  double lat2,
                                                  double lon2,
                                                  double *distance,
                                                  double *azimuth1,
                                                  double *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_great_circle_distance_f64(const terrella_great_circle_f64 *method,
                                                   double lat1,
                                                   double lon1,
                                                   double lat2,
                                                   double lon2,
                                                   double *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Exact on the sphere: within 8e-16 of the distance, in f32 4.2e-7.
terrella_status terrella_great_circle_direct_f64(const terrella_great_circle_f64 *method,
                                                 double lat1,
                                                 double lon1,
                                                 double azimuth1,
                                                 double distance,
                                                 double *lat2,
                                                 double *lon2,
                                                 double *azimuth2);

// Makes the geodesic from a place at an azimuth, all in degrees.
terrella_status terrella_line_init_f64(terrella_line_f64 *line,
                                       const terrella_karney_f64 *karney,
                                       double lat,
                                       double lon,
                                       double azimuth);

// The place at a distance in metres along a line, and the azimuth of travel at it, in degrees.
terrella_status terrella_line_at_f64(const terrella_line_f64 *line,
                                     double distance,
                                     double *lat,
                                     double *lon,
                                     double *azimuth);

// Makes the method on a sphere of a radius in metres; 6371008.8 is the Earth's mean.
terrella_status terrella_great_circle_init_f32(terrella_great_circle_f32 *method, float radius);

// From two places in degrees to the distance in metres and the azimuths at both, in degrees clockwise from north.
//
// Exact on the sphere: within 8e-16 of the distance, in f32 4.2e-7.
terrella_status terrella_great_circle_inverse_f32(const terrella_great_circle_f32 *method,
                                                  float lat1,
                                                  float lon1,
                                                  float lat2,
                                                  float lon2,
                                                  float *distance,
                                                  float *azimuth1,
                                                  float *azimuth2);

// The distance alone, which takes less time.
terrella_status terrella_great_circle_distance_f32(const terrella_great_circle_f32 *method,
                                                   float lat1,
                                                   float lon1,
                                                   float lat2,
                                                   float lon2,
                                                   float *distance);

// From a place in degrees, an azimuth in degrees and a distance in metres to the place there, and the azimuth
// of travel at it.
//
// Exact on the sphere: within 8e-16 of the distance, in f32 4.2e-7.
terrella_status terrella_great_circle_direct_f32(const terrella_great_circle_f32 *method,
                                                 float lat1,
                                                 float lon1,
                                                 float azimuth1,
                                                 float distance,
                                                 float *lat2,
                                                 float *lon2,
                                                 float *azimuth2);

// Makes the geodesic from a place at an azimuth, all in degrees.
terrella_status terrella_line_init_f32(terrella_line_f32 *line,
                                       const terrella_karney_f32 *karney,
                                       float lat,
                                       float lon,
                                       float azimuth);

// The place at a distance in metres along a line, and the azimuth of travel at it, in degrees.
terrella_status terrella_line_at_f32(const terrella_line_f32 *line,
                                     float distance,
                                     float *lat,
                                     float *lon,
                                     float *azimuth);

// The closest place of a leg to a place, all in degrees: its distance in metres, and how many metres from the leg's
// start it is.
terrella_status terrella_karney_closest_f64(const terrella_karney_f64 *surface,
                                            double lat1,
                                            double lon1,
                                            double lat2,
                                            double lon2,
                                            double lat,
                                            double lon,
                                            double *distance,
                                            double *closest_lat,
                                            double *closest_lon,
                                            double *along,
                                            terrella_reach *reach);

// How far a place is to the right of a leg and along it, in metres, all places in degrees.
terrella_status terrella_karney_track_f64(const terrella_karney_f64 *surface,
                                          double lat1,
                                          double lon1,
                                          double lat2,
                                          double lon2,
                                          double lat,
                                          double lon,
                                          double *across,
                                          double *along);

// On which side of a ring a place is, and how far from its edge: metres, negative inside. The inside is the
// smaller part of the Earth. Ask only for what is needed: the distance takes more time.
terrella_status terrella_karney_fence_f64(const terrella_karney_f64 *surface,
                                          const terrella_place_f64 *ring,
                                          size_t count,
                                          double lat,
                                          double lon,
                                          terrella_side *side,
                                          double *distance);

// The closest place of a leg to a place, all in degrees: its distance in metres, and how many metres from the leg's
// start it is.
terrella_status terrella_karney_closest_f32(const terrella_karney_f32 *surface,
                                            float lat1,
                                            float lon1,
                                            float lat2,
                                            float lon2,
                                            float lat,
                                            float lon,
                                            float *distance,
                                            float *closest_lat,
                                            float *closest_lon,
                                            float *along,
                                            terrella_reach *reach);

// How far a place is to the right of a leg and along it, in metres, all places in degrees.
terrella_status terrella_karney_track_f32(const terrella_karney_f32 *surface,
                                          float lat1,
                                          float lon1,
                                          float lat2,
                                          float lon2,
                                          float lat,
                                          float lon,
                                          float *across,
                                          float *along);

// On which side of a ring a place is, and how far from its edge: metres, negative inside. The inside is the
// smaller part of the Earth. Ask only for what is needed: the distance takes more time.
terrella_status terrella_karney_fence_f32(const terrella_karney_f32 *surface,
                                          const terrella_place_f32 *ring,
                                          size_t count,
                                          float lat,
                                          float lon,
                                          terrella_side *side,
                                          float *distance);

// The closest place of a leg to a place, all in degrees: its distance in metres, and how many metres from the leg's
// start it is.
terrella_status terrella_great_circle_closest_f64(const terrella_great_circle_f64 *surface,
                                                  double lat1,
                                                  double lon1,
                                                  double lat2,
                                                  double lon2,
                                                  double lat,
                                                  double lon,
                                                  double *distance,
                                                  double *closest_lat,
                                                  double *closest_lon,
                                                  double *along,
                                                  terrella_reach *reach);

// How far a place is to the right of a leg and along it, in metres, all places in degrees.
terrella_status terrella_great_circle_track_f64(const terrella_great_circle_f64 *surface,
                                                double lat1,
                                                double lon1,
                                                double lat2,
                                                double lon2,
                                                double lat,
                                                double lon,
                                                double *across,
                                                double *along);

// On which side of a ring a place is, and how far from its edge: metres, negative inside. The inside is the
// smaller part of the Earth. Ask only for what is needed: the distance takes more time.
terrella_status terrella_great_circle_fence_f64(const terrella_great_circle_f64 *surface,
                                                const terrella_place_f64 *ring,
                                                size_t count,
                                                double lat,
                                                double lon,
                                                terrella_side *side,
                                                double *distance);

// The closest place of a leg to a place, all in degrees: its distance in metres, and how many metres from the leg's
// start it is.
terrella_status terrella_great_circle_closest_f32(const terrella_great_circle_f32 *surface,
                                                  float lat1,
                                                  float lon1,
                                                  float lat2,
                                                  float lon2,
                                                  float lat,
                                                  float lon,
                                                  float *distance,
                                                  float *closest_lat,
                                                  float *closest_lon,
                                                  float *along,
                                                  terrella_reach *reach);

// How far a place is to the right of a leg and along it, in metres, all places in degrees.
terrella_status terrella_great_circle_track_f32(const terrella_great_circle_f32 *surface,
                                                float lat1,
                                                float lon1,
                                                float lat2,
                                                float lon2,
                                                float lat,
                                                float lon,
                                                float *across,
                                                float *along);

// On which side of a ring a place is, and how far from its edge: metres, negative inside. The inside is the
// smaller part of the Earth. Ask only for what is needed: the distance takes more time.
terrella_status terrella_great_circle_fence_f32(const terrella_great_circle_f32 *surface,
                                                const terrella_place_f32 *ring,
                                                size_t count,
                                                float lat,
                                                float lon,
                                                terrella_side *side,
                                                float *distance);

// Checks a place in degrees and keeps it: a corner of a fence.
terrella_status terrella_place_init_f64(terrella_place_f64 *place, double lat, double lon);

// Makes rhumb lines of an ellipsoid.
terrella_status terrella_rhumb_init_f64(terrella_rhumb_f64 *rhumb, const terrella_ellipsoid_f64 *ellipsoid);

// The rhumb line between two places in degrees: its length in metres, and its azimuth in degrees.
terrella_status terrella_rhumb_inverse_f64(const terrella_rhumb_f64 *rhumb,
                                           double lat1,
                                           double lon1,
                                           double lat2,
                                           double lon2,
                                           double *distance,
                                           double *azimuth);

// Checks a place in degrees and keeps it: a corner of a fence.
terrella_status terrella_place_init_f32(terrella_place_f32 *place, float lat, float lon);

// Makes rhumb lines of an ellipsoid.
terrella_status terrella_rhumb_init_f32(terrella_rhumb_f32 *rhumb, const terrella_ellipsoid_f32 *ellipsoid);

// The rhumb line between two places in degrees: its length in metres, and its azimuth in degrees.
terrella_status terrella_rhumb_inverse_f32(const terrella_rhumb_f32 *rhumb,
                                           float lat1,
                                           float lon1,
                                           float lat2,
                                           float lon2,
                                           float *distance,
                                           float *azimuth);

// Returns what a status means, in English, for whatever number it is.
const char *terrella_status_text(int32_t status);

// The key of a tile, along Hilbert's curve: face 0 to 5, level 0 to 30, column and row 0 to 2^level − 1. With the projection
// "s2-quadratic" and the shift "geodetic" it is S2's cell id.
terrella_status terrella_tile_key(uint32_t face,
                                  uint32_t level,
                                  uint32_t i,
                                  uint32_t j,
                                  uint64_t *key);

// The tile of a key.
terrella_status terrella_tile_of_key(uint64_t key, uint8_t *face, uint8_t *level, uint32_t *i, uint32_t *j);

// The key of the tile of a level that contains a place in degrees.
terrella_status terrella_cube_key_f64(const terrella_cube_f64 *cube,
                                      double lat,
                                      double lon,
                                      uint32_t level,
                                      uint64_t *key);

// The box of latitudes and longitudes in degrees that holds a tile; `east` is below `west` if it crosses ±180°.
terrella_status terrella_cube_bounds_f64(const terrella_cube_f64 *cube,
                                         uint64_t key,
                                         double *south,
                                         double *west,
                                         double *north,
                                         double *east);

// The key of the tile of a level that contains a place in degrees.
terrella_status terrella_cube_key_f32(const terrella_cube_f32 *cube,
                                      float lat,
                                      float lon,
                                      uint32_t level,
                                      uint64_t *key);

// The box of latitudes and longitudes in degrees that holds a tile; `east` is below `west` if it crosses ±180°.
terrella_status terrella_cube_bounds_f32(const terrella_cube_f32 *cube,
                                         uint64_t key,
                                         float *south,
                                         float *west,
                                         float *north,
                                         float *east);

// Returns 10 000 × major + 100 × minor + patch of the library that is linked; compare it with the header's.
int32_t terrella_version(void);

#ifdef __cplusplus
}  // extern "C"
#endif  // __cplusplus
