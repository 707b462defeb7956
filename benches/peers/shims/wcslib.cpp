// WCSLIB: the cube projections and HEALPix of FITS. Degrees throughout: latitude and longitude, and the plane with all
// faces in it, a face 90 wide.
#include <prj.h>

#include <string>
#include <vector>

#include "pass.h"

struct Projection {
    prjprm parameters;
    Projection(const char *code, int (*set)(prjprm *)) {
        parameters.flag = -1;
        prjini(&parameters);
        parameters.r0 = 0;
        if (code[0] == 'h') parameters.pv[1] = 4, parameters.pv[2] = 3;
        set(&parameters);
    }
};

template <class Call>
static void one_by_one(prjprm &p, Call call, std::size_t n, const double *const *in, double *const *out) {
    for (std::size_t i = 0; i < n; ++i) {
        int status = 0;
        call(&p, 1, 0, 1, 1, &in[0][i], &in[1][i], &out[0][i], &out[1][i], &status);
        if (status) out[0][i] = NAN;
    }
}

template <class Call>
static void vector(prjprm &p, Call call, std::size_t n, const double *const *in, double *const *out) {
    static std::vector<int> status;
    status.resize(n);
    // The vector call, and the caller's look at what became of each point if any failed.
    if (call(&p, static_cast<int>(n), 0, 1, 1, in[0], in[1], out[0], out[1], status.data()))
        for (std::size_t i = 0; i < n; ++i)
            if (status[i]) out[0][i] = NAN;
}

// In: longitude, latitude. Out: x, y; and back.
#define PROJECTION(name, code) \
    static prjprm &name() { \
        static Projection projection(#name, code##set); \
        return projection.parameters; \
    } \
    PASS(name##_forward) { one_by_one(name(), code##s2x, n, in, out); } \
    PASS(name##_inverse) { one_by_one(name(), code##x2s, n, in, out); } \
    PASS(name##_forward_batch) { vector(name(), code##s2x, n, in, out); } \
    PASS(name##_inverse_batch) { vector(name(), code##x2s, n, in, out); }

PROJECTION(qsc, qsc)
PROJECTION(tsc, tsc)
PROJECTION(csc, csc)
PROJECTION(healpix, hpx)
