// Google's S2: unit vectors to face, s and t in [0, 1], and back, with its own numbering of faces.
#include <s2/s2coords.h>

#include "pass.h"

PASS(s2_quadratic_forward) {
    for (std::size_t i = 0; i < n; ++i) {
        double u, v;
        face[i] = static_cast<unsigned char>(S2::XYZtoFaceUV(S2Point(in[0][i], in[1][i], in[2][i]), &u, &v));
        out[0][i] = S2::UVtoST(u);
        out[1][i] = S2::UVtoST(v);
    }
}

PASS(s2_quadratic_inverse) {
    for (std::size_t i = 0; i < n; ++i) {
        const S2Point p = S2::FaceUVtoXYZ(face[i], S2::STtoUV(in[0][i]), S2::STtoUV(in[1][i])).Normalize();
        out[0][i] = p.x();
        out[1][i] = p.y();
        out[2][i] = p.z();
    }
}

PASS(gnomonic_forward) {
    for (std::size_t i = 0; i < n; ++i)
        face[i] = static_cast<unsigned char>(
            S2::XYZtoFaceUV(S2Point(in[0][i], in[1][i], in[2][i]), &out[0][i], &out[1][i]));
}

PASS(gnomonic_inverse) {
    for (std::size_t i = 0; i < n; ++i) {
        const S2Point p = S2::FaceUVtoXYZ(face[i], in[0][i], in[1][i]).Normalize();
        out[0][i] = p.x();
        out[1][i] = p.y();
        out[2][i] = p.z();
    }
}
