// What every pass of a shim looks like: n points, their coordinates in slices of their own, the results likewise.
// `face` is read where a pass needs a face (0 to 5, numbered as in tests/truth/README.md) and written where it gives one.
// A point that fails gives a number that is not finite in its first result.
#pragma once
#include <cmath>
#include <cstddef>

#define EXPORTED extern "C" __attribute__((visibility("default")))

#define PASS(name) \
    EXPORTED void name(std::size_t n, [[maybe_unused]] unsigned char *face, const double *const *in, double *const *out)

// The version of the library, as Debian counts.
EXPORTED const char *version() { return VERSION; }
