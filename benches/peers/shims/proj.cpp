// PROJ: cube projections, HEALPix, Earth-centred coordinates; geodesics by its copy of GeographicLib's C code.
// Latitudes and longitudes in radians, but in degrees for geodesics, as each of its functions wants them.
//
// A projection to a cube is one PROJ object per face and the choice of face the caller's, so it costs nothing here:
// one by one the face is looked up, in batch the points come sorted by face.
#include <geodesic.h>
#include <proj.h>

#include <cstdio>
#include <string>

#include "pass.h"

static PJ *make(const std::string &definition) {
    static PJ_CONTEXT *context = [] {
        PJ_CONTEXT *fresh = proj_context_create();
        // Nothing here needs the database that a build from source does not find and complains of.
        proj_log_func(fresh, nullptr, [](void *, int, const char *) {});
        return fresh;
    }();
    PJ *p = proj_create(context, definition.c_str());
    if (!p) std::fprintf(stderr, "PROJ refuses %s\n", definition.c_str());
    return p;
}

// The six faces of a cube.
struct Faces {
    PJ *face[6];
    explicit Faces(const std::string &definition) {
        static const char *const centre[6] = {"+lat_0=0 +lon_0=0",   "+lat_0=0 +lon_0=90", "+lat_0=0 +lon_0=180",
                                              "+lat_0=0 +lon_0=-90", "+lat_0=90 +lon_0=0", "+lat_0=-90 +lon_0=0"};
        for (int k = 0; k < 6; ++k) face[k] = make(definition + " " + centre[k]);
    }
};

static void one_by_one(const Faces &cube, PJ_DIRECTION direction, std::size_t n, const unsigned char *face,
                       const double *const *in, double *const *out) {
    for (std::size_t i = 0; i < n; ++i) {
        const PJ_COORD c = proj_trans(cube.face[face[i]], direction, proj_coord(in[0][i], in[1][i], 0, 0));
        out[0][i] = c.v[0];
        out[1][i] = c.v[1];
    }
}

// In place on the results, as the library wants it: copying the points is part of it.
static void generic(PJ *p, PJ_DIRECTION direction, int axes, std::size_t begin, std::size_t end,
                    const double *const *in, double *const *out) {
    for (int k = 0; k < axes; ++k)
        for (std::size_t i = begin; i < end; ++i) out[k][i] = in[k][i];
    const std::size_t count = end - begin, step = sizeof(double);
    proj_trans_generic(p, direction, out[0] + begin, step, count, out[1] + begin, step, count,
                       axes > 2 ? out[2] + begin : nullptr, step, axes > 2 ? count : 0, nullptr, 0, 0);
}

static void batch(const Faces &cube, PJ_DIRECTION direction, std::size_t n, const unsigned char *face,
                  const double *const *in, double *const *out) {
    for (std::size_t begin = 0, end; begin < n; begin = end) {
        for (end = begin; end < n && face[end] == face[begin];) ++end;
        generic(cube.face[face[begin]], direction, 2, begin, end, in, out);
    }
}

#define CUBE(name, definition) \
    static const Faces &name() { \
        static const Faces faces(definition); \
        return faces; \
    } \
    PASS(name##_forward) { one_by_one(name(), PJ_FWD, n, face, in, out); } \
    PASS(name##_inverse) { one_by_one(name(), PJ_INV, n, face, in, out); } \
    PASS(name##_forward_batch) { batch(name(), PJ_FWD, n, face, in, out); } \
    PASS(name##_inverse_batch) { batch(name(), PJ_INV, n, face, in, out); }

CUBE(qsc, "+proj=qsc +R=1")
CUBE(qsc_wgs84, "+proj=qsc +ellps=WGS84")
CUBE(s2_quadratic, "+proj=s2 +R=1")
CUBE(s2_tangent, "+proj=s2 +R=1 +UVtoST=tangent")
CUBE(s2_none, "+proj=s2 +R=1 +UVtoST=none")

static PJ *healpix() {
    static PJ *p = make("+proj=healpix +R=1");
    return p;
}

static PJ *cart() {
    static PJ *p = make("+proj=cart +ellps=WGS84");
    return p;
}

static void healpix_one_by_one(PJ_DIRECTION direction, std::size_t n, const double *const *in, double *const *out) {
    for (std::size_t i = 0; i < n; ++i) {
        const PJ_COORD c = proj_trans(healpix(), direction, proj_coord(in[0][i], in[1][i], 0, 0));
        out[0][i] = c.v[0];
        out[1][i] = c.v[1];
    }
}
PASS(healpix_forward) { healpix_one_by_one(PJ_FWD, n, in, out); }
PASS(healpix_inverse) { healpix_one_by_one(PJ_INV, n, in, out); }
PASS(healpix_forward_batch) { generic(healpix(), PJ_FWD, 2, 0, n, in, out); }
PASS(healpix_inverse_batch) { generic(healpix(), PJ_INV, 2, 0, n, in, out); }

static void cart_one_by_one(PJ_DIRECTION direction, std::size_t n, const double *const *in, double *const *out) {
    for (std::size_t i = 0; i < n; ++i) {
        const PJ_COORD c = proj_trans(cart(), direction, proj_coord(in[0][i], in[1][i], in[2][i], 0));
        for (int k = 0; k < 3; ++k) out[k][i] = c.v[k];
    }
}
PASS(to_ecef) { cart_one_by_one(PJ_FWD, n, in, out); }
PASS(to_geodetic) { cart_one_by_one(PJ_INV, n, in, out); }
PASS(to_ecef_batch) { generic(cart(), PJ_FWD, 3, 0, n, in, out); }
PASS(to_geodetic_batch) { generic(cart(), PJ_INV, 3, 0, n, in, out); }

static geod_geodesic wgs84() {
    geod_geodesic earth;
    geod_init(&earth, 6378137, 1 / 298.257223563);
    return earth;
}
PASS(inverse) {
    const geod_geodesic earth = wgs84();
    for (std::size_t i = 0; i < n; ++i)
        geod_inverse(&earth, in[0][i], in[1][i], in[2][i], in[3][i], &out[0][i], &out[1][i], &out[2][i]);
}
PASS(distance) {
    const geod_geodesic earth = wgs84();
    for (std::size_t i = 0; i < n; ++i)
        geod_inverse(&earth, in[0][i], in[1][i], in[2][i], in[3][i], &out[0][i], nullptr, nullptr);
}
PASS(direct) {
    const geod_geodesic earth = wgs84();
    for (std::size_t i = 0; i < n; ++i)
        geod_direct(&earth, in[0][i], in[1][i], in[2][i], in[3][i], &out[0][i], &out[1][i], &out[2][i]);
}
