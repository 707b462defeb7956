use super::decay::smooth;
use super::edge_keeping::{self, EdgeKeeping};
use super::profile::projection;
use super::{CubeProjection, Face};
use crate::Real;
use crate::math::Polynomial;

projection! {
    Compact "compact" {
        title: "Compact",
        also: "",
        summary: "The compact cube: of all maps here the least texture oversize.",
        idea: "A polynomial with eight coefficients, found by minimax search, so that cells differ as little \
            as possible both in area and in the ratio of their sides.",
        origin: "Made for terrella: the texture oversize of Dimitrijević, Lambers & Rančić (2016), eq. 3.9, is \
            1.355 where their best projection has 2. No smooth map with less than 1.322 was found, with 120 \
            coefficients.",
        choose: "Take it for the least texture memory. [`Balanced`](super::Balanced) has more texture oversize \
            (1.405 instead of 1.355), but costs less to the cube (240 instructions instead of 380).",
        keeps: None,
        area_ratio: 1.548,
        aspect_ratio: 1.355,
        oversize: 1.355,
        deformation: 31.1,
        forward: Iteration, error [2.4e-16, 1.3e-7], instructions [380, 280];
        inverse: Algebraic, error [2.7e-16, 1.5e-7], instructions [75, 73];
        tiles: smooth(0.78, 5.95),
    }
}

/// Coefficients of 1, X², XY, XY², XY³, X³Y, Y² and Y³.
const C: Polynomial<8, 8> = Polynomial::rounded([-0.242, 0.032, 0.183, -1.119, 0.904, -0.069, 0.483, -0.375]);

impl EdgeKeeping for Compact {
    // The guess is within 4.7e-3. After one, two and three steps of Newton's method the error is at most
    // 1.3e-5, 1.1e-10 and 2e-16.
    const START: Polynomial<5, 5> = Polynomial::rounded([0.172, -0.0408, -0.0805, 0.1967, 0.0426]);

    #[inline(always)]
    fn polynomial<T: Real>(x: T, y: T) -> T {
        let [c00, c20, c11, c12, c13, c31, c02, c03] = T::all(&C);
        let (xx, yy) = (x * x, y * y);
        (c00 + c20 * xx) + yy * (c02 + c03 * y) + (x * y) * ((c11 + c31 * xx) + (c12 * y + c13 * yy))
    }

    #[inline(always)]
    fn slopes<T: Real>(x: T, y: T) -> [T; 2] {
        let [_, c20, c11, c12, c13, c31, c02, c03] = T::all(&C);
        let (two, three) = (T::of(2.0), T::of(3.0));
        let (xx, yy) = (x * x, y * y);
        [
            two * c20 * x + y * ((c11 + three * c31 * xx) + (c12 * y + c13 * yy)),
            y * (two * c02 + three * c03 * y) + x * ((c11 + c31 * xx) + (two * c12 * y + three * c13 * yy)),
        ]
    }
}

impl CubeProjection for Compact {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, vector: [T; 3]) -> [T; 2] {
        edge_keeping::forward::<Self, T>(vector)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
        edge_keeping::inverse::<Self, T>(point)
    }
}
