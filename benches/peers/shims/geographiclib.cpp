// GeographicLib: geodesics, Earth-centred coordinates, auxiliary latitudes. Degrees and metres.
#include <GeographicLib/Ellipsoid.hpp>
#include <GeographicLib/Geocentric.hpp>
#include <GeographicLib/Geodesic.hpp>

#include "pass.h"

using namespace GeographicLib;

PASS(inverse) {
    const Geodesic &earth = Geodesic::WGS84();
    for (std::size_t i = 0; i < n; ++i)
        earth.Inverse(in[0][i], in[1][i], in[2][i], in[3][i], out[0][i], out[1][i], out[2][i]);
}
PASS(direct) {
    const Geodesic &earth = Geodesic::WGS84();
    for (std::size_t i = 0; i < n; ++i)
        earth.Direct(in[0][i], in[1][i], in[2][i], in[3][i], out[0][i], out[1][i], out[2][i]);
}
PASS(distance) {
    const Geodesic &earth = Geodesic::WGS84();
    for (std::size_t i = 0; i < n; ++i) earth.Inverse(in[0][i], in[1][i], in[2][i], in[3][i], out[0][i]);
}

PASS(to_ecef) {
    const Geocentric &earth = Geocentric::WGS84();
    for (std::size_t i = 0; i < n; ++i) earth.Forward(in[0][i], in[1][i], in[2][i], out[0][i], out[1][i], out[2][i]);
}
PASS(to_geodetic) {
    const Geocentric &earth = Geocentric::WGS84();
    for (std::size_t i = 0; i < n; ++i) earth.Reverse(in[0][i], in[1][i], in[2][i], out[0][i], out[1][i], out[2][i]);
}

#define LATITUDE(name, Method) \
    PASS(name) { \
        const Ellipsoid &earth = Ellipsoid::WGS84(); \
        for (std::size_t i = 0; i < n; ++i) out[0][i] = earth.Method(in[0][i]); \
    }
LATITUDE(authalic, AuthalicLatitude)
LATITUDE(authalic_inverse, InverseAuthalicLatitude)
LATITUDE(conformal, ConformalLatitude)
LATITUDE(conformal_inverse, InverseConformalLatitude)
LATITUDE(rectifying, RectifyingLatitude)
LATITUDE(rectifying_inverse, InverseRectifyingLatitude)
LATITUDE(parametric, ParametricLatitude)
LATITUDE(parametric_inverse, InverseParametricLatitude)
LATITUDE(geocentric, GeocentricLatitude)
LATITUDE(geocentric_inverse, InverseGeocentricLatitude)
