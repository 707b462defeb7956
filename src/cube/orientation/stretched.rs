use core::fmt;

use crate::cube::{CubeProjection, Face, Faces, ProjectionTask};
use crate::math::{max, select};
use crate::{Direction, Real};

/// A projection onto a cube that is stretched toward its north pole: cells are smaller there, and larger
/// around the opposite pole.
///
/// It is Schmidt's map (1977): a conformal map of the sphere onto itself. With a factor c and C = (c² − 1)/(c²
/// \+ 1), a latitude φ of the cube becomes φ′ with sin φ′ = (C + sin φ)/(1 + C sin φ), so lengths shrink by c
/// at the north pole and grow by c at the south pole. A factor below 1 stretches toward the south pole, as
/// FV3 does with the reciprocal factor. Angles on the sphere stay the same, areas do not: no projection is
/// equal-area when stretched.
///
/// Tiles, terrain, distortion and batches work with it as with the projection itself. For finer cells
/// elsewhere than at a pole, put it into a [`Turned`](super::Turned):
///
/// ```
/// use terrella::LatLon;
/// use terrella::cube::{CubeProjection, EquiEdge, Face, Rotation, Stretched, Turned};
/// use terrella::terrain::Tile;
///
/// let zurich = LatLon::new(47.4, 8.5)?.to_direction();
/// let toward = Rotation::facing(Face::Top, zurich, 0.0)?;
/// let plain = Turned::new(EquiEdge, toward);
/// let finer = Turned::new(Stretched::new(EquiEdge, 2.5)?, toward);
/// let tile = Tile::containing(plain.project(zurich), 10)?;
/// let ratio = tile.solid_angle::<f64>(plain) / tile.solid_angle::<f64>(finer);
/// assert!((ratio.sqrt() - 2.5).abs() < 1e-2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "Schmidt")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Stretched<P> {
    projection: P,
    /// The factor and its reciprocal.
    double: [f64; 2],
    /// The same, rounded.
    single: [f32; 2],
}

impl<P: CubeProjection> Stretched<P> {
    /// The largest factor, and the reciprocal of the smallest.
    const MOST: f64 = 16.0;

    /// Stretches the cube of a projection by a factor in [1/16, 16].
    ///
    /// # Errors
    /// [`InvalidStretch`] if the factor is outside that range or NaN.
    pub const fn new(projection: P, factor: f64) -> Result<Self, InvalidStretch> {
        if !(factor >= 1.0 / Self::MOST && factor <= Self::MOST) {
            return Err(InvalidStretch(factor));
        }
        let inverse = 1.0 / factor;
        Ok(Self {
            projection,
            double: [factor, inverse],
            single: [factor as f32, inverse as f32],
        })
    }

    /// Returns the projection onto the cube that is not stretched.
    #[must_use]
    pub const fn projection(&self) -> P {
        self.projection
    }

    /// Returns the factor.
    #[must_use]
    pub const fn factor(&self) -> f64 {
        let [factor, _] = self.double;
        factor
    }

    /// The factor and its reciprocal.
    #[inline(always)]
    fn factors<T: Real>(&self) -> [T; 2] {
        let ([a, b], [c, d]) = (self.double, self.single);
        [T::pick(a, c), T::pick(b, d)]
    }
}

/// Multiplies tan(½θ) of the distance θ from the south pole by `factor`, of which `inverse` is the reciprocal.
///
/// With 1 + z and 1 − z times the two, Schmidt's formula has no difference of nearly equal numbers. Near a pole
/// the smaller of them is what x and y say, for z has lost it; on the equator both are 1.
#[inline(always)]
fn stretched<T: Real>([x, y, z]: [T; 3], [factor, inverse]: [T; 2]) -> [T; 3] {
    let far = T::ONE + z.abs();
    let near = select(z.abs() < T::of(0.5), T::ONE - z.abs(), (x * x + y * y) / far);
    let south = z < T::ZERO;
    let above = factor * select(south, near, far);
    let below = inverse * select(south, far, near);
    let scale = T::ONE / (above + below);
    let twice = scale + scale;
    [x * twice, y * twice, (above - below) * scale]
}

impl<P: CubeProjection> CubeProjection for Stretched<P> {
    const SYMMETRIC: bool = false;

    #[inline(always)]
    fn faces(&self) -> Faces {
        self.projection.faces()
    }

    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
        self.projection.forward(face, local)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
        self.projection.inverse(face, point)
    }

    #[inline(always)]
    fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
        self.projection.is_polar(direction)
    }

    #[inline(always)]
    fn bend<T: Real>(&self) -> T {
        let [factor, inverse] = self.factors::<T>();
        self.projection.bend::<T>() * max(factor, inverse)
    }

    #[inline(always)]
    fn to_cube<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        let [factor, inverse] = self.factors();
        self.projection.to_cube(stretched(vector, [inverse, factor]))
    }

    #[inline(always)]
    fn to_earth<T: Real>(&self, vector: [T; 3]) -> [T; 3] {
        stretched(self.projection.to_earth(vector), self.factors())
    }

    #[inline(always)]
    fn with<W: ProjectionTask>(self, task: W) -> W::Output {
        self.projection.with(OnStretched {
            stretch: (self.double, self.single),
            task,
        })
    }
}

/// Runs a task with a projection that is stretched.
struct OnStretched<W> {
    stretch: ([f64; 2], [f32; 2]),
    task: W,
}

impl<W: ProjectionTask> ProjectionTask for OnStretched<W> {
    type Output = W::Output;

    #[inline(always)]
    fn run<P: CubeProjection>(self, projection: P) -> W::Output {
        let (double, single) = self.stretch;
        self.task.run(Stretched {
            projection,
            double,
            single,
        })
    }
}

/// The error for a factor that is not in [1/16, 16].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidStretch(pub f64);

impl fmt::Display for InvalidStretch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "expected a factor in [1/16, 16], got {:?}", self.0)
    }
}

impl core::error::Error for InvalidStretch {}
