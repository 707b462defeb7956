// D. K. Olson, "Converting Earth-Centered, Earth-Fixed Coordinates to Geodetic Coordinates", IEEE Transactions on
// Aerospace and Electronic Systems 32 (1996), pp. 473-476: WGS84, latitude and longitude in radians, heights in metres.
// Written after the paper's formulas and constants, whose letters these are.
#include "pass.h"

static constexpr double a = 6378137, e2 = 6.6943799901377997e-3;
static constexpr double a1 = a * e2, a2 = a1 * a1, a3 = a1 * e2 / 2, a4 = 2.5 * a2, a5 = a1 + a3, a6 = 1 - e2;

// Where the paper's routine gives up: closer to the centre than this.
static constexpr double nearest = 1e5;

PASS(to_geodetic) {
    for (std::size_t i = 0; i < n; ++i) {
        const double x = in[0][i], y = in[1][i], z = in[2][i], height = std::fabs(z);
        const double w2 = x * x + y * y, z2 = z * z, r2 = w2 + z2;
        const double w = std::sqrt(w2), r = std::sqrt(r2);
        if (r < nearest) {
            out[0][i] = NAN;
            continue;
        }

        // Sine or cosine of the latitude, whichever changes more, by a series in e2 from those of the geocentric one.
        const double s2 = z2 / r2, c2 = w2 / r2, u = a2 / r, v = a3 - a4 / r;
        double latitude, sine, cosine, square;
        if (c2 > 0.3) {
            sine = height / r * (1 + c2 * (a1 + u + s2 * v) / r);
            latitude = std::asin(sine);
            square = sine * sine;
            cosine = std::sqrt(1 - square);
        } else {
            cosine = w / r * (1 - s2 * (a5 - u - c2 * v) / r);
            latitude = std::acos(cosine);
            square = 1 - cosine * cosine;
            sine = std::sqrt(square);
        }

        // One step of Newton's: what the point is off the ellipsoid's there, along the normal and along the meridian.
        const double g = 1 - e2 * square, rg = a / std::sqrt(g), rf = a6 * rg;
        const double outward = w - rg * cosine, upward = height - rf * sine;
        const double normal = cosine * outward + sine * upward, meridian = cosine * upward - sine * outward;
        const double step = meridian / (rf / g + normal);
        out[0][i] = std::copysign(latitude + step, z);
        out[1][i] = std::atan2(y, x);
        out[2][i] = normal + meridian * step / 2;
    }
}
