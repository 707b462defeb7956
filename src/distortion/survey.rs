use super::statistic::BLOCK;
use super::{Ground, Jacobian, Statistic};
use crate::Real;
use crate::batch::{Pass, widest};
use crate::cube::{CubeProjection, Face, FacePoint};
use crate::math::{max, min};

/// What is worst and what is usual over any set of places: an accumulator of fixed size.
///
/// Areas are told in units of the `reference` it was made with: Λ₀², the paper's central texel, is
/// [`Ground::central_texel`].
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::distortion::{Ground, Survey};
/// use terrella::{Ellipsoid, Shift};
///
/// let sphere = Ellipsoid::sphere(1.0_f64)?;
/// let ground = Ground::new(CubeMap::new(sphere, Shift::Geodetic, Quadrilateralized)?);
/// let mut survey = Survey::new(ground.central_texel());
/// survey.face(&ground, Face::Front, 201);
/// assert!((survey.area().ratio() - 1.0).abs() < 1e-13);
/// assert!((survey.deformation().max() - 25.17).abs() < 0.01);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Survey<T> {
    reference: T,
    aspect: Statistic<T>,
    sides: Statistic<T>,
    area: Statistic<T>,
    deformation: Statistic<T>,
    skipped: u64,
}

impl<T: Real> Survey<T> {
    /// Of nothing yet; areas will be told in units of `reference`, in square metres per unit of x and of y.
    #[must_use]
    pub fn new(reference: T) -> Self {
        Self {
            reference,
            aspect: Statistic::about(T::ONE),
            sides: Statistic::about(T::ONE),
            area: Statistic::about(T::ONE),
            deformation: Statistic::about(T::ZERO),
            skipped: 0,
        }
    }

    /// Includes a place.
    #[inline]
    pub fn include(&mut self, point: FacePoint<T>, texel: &Jacobian<T>) {
        let [aspect, sides, area, deformation] = self.measures(texel);
        self.aspect.include(point, aspect);
        self.sides.include(point, sides);
        self.area.include(point, area);
        self.deformation.include(point, deformation);
    }

    #[inline(always)]
    fn measures(&self, texel: &Jacobian<T>) -> [T; 4] {
        [
            texel.aspect(),
            texel.sides() / self.reference,
            texel.area() / self.reference,
            texel.deformation(),
        ]
    }

    /// Includes n × n places of a face, at x and y of −1 + 2i/n for i from 0 to n − 1: each texel once, and by symmetry the edges.
    ///
    /// Those where the map has no derivative are left out and counted.
    pub fn face<P: CubeProjection>(&mut self, ground: &Ground<T, P>, face: Face, n: u32) {
        widest(Rows {
            survey: self,
            ground,
            face,
            n,
        });
    }

    /// Includes n × n places of each face: for any projection, whichever of its faces differ.
    ///
    /// For those of this crate the front stands for the sides, and the top for the bottom.
    pub fn sphere<P: CubeProjection>(&mut self, ground: &Ground<T, P>, n: u32) {
        for face in Face::ALL {
            self.face(ground, face, n);
        }
    }

    /// Includes what another survey with the same reference has seen.
    pub fn merge(&mut self, other: &Self) {
        self.aspect.merge(&other.aspect);
        self.sides.merge(&other.sides);
        self.area.merge(&other.area);
        self.deformation.merge(&other.deformation);
        self.skipped += other.skipped;
    }

    /// δ_aspect = Λx/Λy.
    #[must_use]
    pub fn aspect(&self) -> &Statistic<T> {
        &self.aspect
    }

    /// δ_area = Λx·Λy over the reference.
    #[must_use]
    pub fn sides(&self) -> &Statistic<T> {
        &self.sides
    }

    /// The true area over the reference.
    #[must_use]
    pub fn area(&self) -> &Statistic<T> {
        &self.area
    }

    /// Tissot's ω in degrees.
    #[must_use]
    pub fn deformation(&self) -> &Statistic<T> {
        &self.deformation
    }

    /// ε: how much larger than needed a texture must be, if its worst texel is to be good enough; the larger of the ratios of δ_aspect and δ_area
    /// (paper 3.9, in the reading under which its conclusions follow).
    #[must_use]
    pub fn oversize(&self) -> T {
        max(self.aspect.ratio(), self.sides.ratio())
    }

    /// How many places were left out because the map has no derivative there.
    #[must_use]
    pub fn skipped(&self) -> u64 {
        self.skipped
    }
}

/// The survey of a face, a block of a row at a time: first every place is measured, then all are counted.
struct Rows<'a, T, P> {
    survey: &'a mut Survey<T>,
    ground: &'a Ground<T, P>,
    face: Face,
    n: u32,
}

impl<T: Real, P: CubeProjection> Pass for Rows<'_, T, P> {
    type Output = ();

    #[inline(always)]
    fn run(self) {
        let Self {
            survey,
            ground,
            face,
            n,
        } = self;
        let step = T::of(2.0) / T::whole(u64::from(n));
        let along = |index: u32| min(T::whole(u64::from(index)) * step - T::ONE, T::ONE);
        for row in 0..n {
            let y = along(row);
            for start in (0..n).step_by(BLOCK) {
                let mut xs = [T::ZERO; BLOCK];
                for (x, index) in xs.iter_mut().zip(start..) {
                    *x = along(index);
                }
                let at = |x: T| FacePoint::within(face, x, y);
                let mut regular = true;
                let [mut aspect, mut sides, mut area, mut deformation] = [[T::ZERO; BLOCK]; 4];
                let columns = aspect.iter_mut().zip(&mut sides).zip(&mut area).zip(&mut deformation);
                for ((((aspect, sides), area), deformation), &x) in columns.zip(&xs) {
                    let texel = ground.slopes(face, [x, y]);
                    [*aspect, *sides, *area, *deformation] = survey.measures(&texel);
                    regular &= texel.is_regular();
                }
                if regular & (n - start >= BLOCK as u32) {
                    let place = |index: usize| at(xs.get(index).copied().unwrap_or(T::ZERO));
                    survey.aspect.include_block(&aspect, place);
                    survey.sides.include_block(&sides, place);
                    survey.area.include_block(&area, place);
                    survey.deformation.include_block(&deformation, place);
                } else {
                    for &x in xs.iter().take((n - start) as usize) {
                        match ground.jacobian(at(x)) {
                            Ok(texel) => survey.include(at(x), &texel),
                            Err(_) => survey.skipped += 1,
                        }
                    }
                }
            }
        }
    }
}
