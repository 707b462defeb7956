use super::decay::smooth;
use super::profile::projection;
use super::{CubeProjection, Face, from_gnomonic};
use crate::Real;

projection! {
    /// # Another parameter
    /// It is a projection of your own, for example with e = 1.375, for which the areas vary as little and the
    /// texture oversize is 2.42:
    ///
    /// ```
    /// use terrella::cube::{CubeProjection, Face};
    /// use terrella::{Direction, Real};
    ///
    /// #[derive(Clone, Copy)]
    /// struct Mild;
    ///
    /// impl CubeProjection for Mild {
    ///     fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
    ///         [right / outward, up / outward].map(|u| u * (T::of(1.375) - T::of(0.375) * u.abs()))
    ///     }
    ///     fn inverse<T: Real>(&self, _: Face, point: [T; 2]) -> [T; 3] {
    ///         let [u, v] = point.map(|x| {
    ///             let root = (T::of(1.375 * 1.375) - T::of(4.0 * 0.375) * x.abs()).sqrt();
    ///             x * T::of(2.0) / (T::of(1.375) + root)
    ///         });
    ///         let length = (u * u + v * v + T::ONE).sqrt();
    ///         [u / length, v / length, T::ONE / length]
    ///     }
    /// }
    ///
    /// let there = Mild.unproject(Mild.project(Direction::new(3.0, 2.0, 1.0)?));
    /// assert!((there.x() / there.z() - 3.0_f64).abs() < 1e-15);
    /// # Ok::<(), terrella::InvalidDirection<f64>>(())
    /// ```
    Everitt "everitt" {
        title: "Everitt",
        also: "",
        summary: "Everitt’s cube: x = u(e − (e − 1)|u|) in each coordinate, e = 1.4511.",
        idea: "A parabola on either side of the midline of a face approximates the adjusted cube, as in S2. \
            Here the parabola leads from the sphere to the cube, so that this way takes no square root.",
        origin: "Everitt (2014), Projection cube maps, with the parameter of Zucker & Higashi (2018), JCGT 7(2).",
        choose: "Take it to agree with textures that were made with it. At about the same cost, \
            [`S2Quadratic`](super::S2Quadratic) has less texture oversize (2.105 instead of 3.494), and \
            [`Algebraic`](super::Algebraic) has areas that vary less (1.268 to 1 instead of 1.445 to 1).",
        keeps: None,
        area_ratio: 1.445,
        aspect_ratio: 3.494,
        oversize: 3.494,
        deformation: 35.3,
        forward: Algebraic, error [2.9e-16, 1.6e-7], instructions [73, 71];
        inverse: Algebraic, error [2.9e-16, 1.6e-7], instructions [49, 47];
        tiles: smooth(1.33, 3.26),
    }
}

const E: f64 = 1.4511;

impl CubeProjection for Everitt {
    #[inline(always)]
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let coordinate = |u: T| u * (T::of(E) - T::of(E - 1.0) * u.abs());
        [coordinate(right / outward), coordinate(up / outward)]
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        // The smaller root, without the difference.
        let gnomonic = |x: T| {
            let discriminant = T::of(E * E) - T::of(4.0 * (E - 1.0)) * x.abs();
            x * T::of(2.0) / (T::of(E) + discriminant.sqrt())
        };
        from_gnomonic([gnomonic(x), gnomonic(y)])
    }
}
