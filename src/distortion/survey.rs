use super::ground::jacobian;
use super::jacobian::is_regular;
use super::{Ground, Jacobian, Statistic};
use crate::cube::{CubeProjection, Face, FacePoint, ProjectionTask};
use crate::latitude::{Turn, with_correction};
use crate::math::{max, min};
use crate::simd::{BLOCK, Kernel, sweep};
use crate::{Direction, Dual, Ellipsoid, Real, Shifted};

/// An accumulator of distortion measures over any set of points: the worst and the mean values. Its size is
/// fixed.
///
/// Areas are in units of the `reference` that the survey was created with. For Λ₀², the paper's central
/// texel, use [`Ground::central_texel`]; for the mean area, [`Ground::fair_texel`]. [`Cells`](super::Cells)
/// measures whole cells instead of points, and [`Kinks`](super::Kinks) the creases between them.
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
    scale: Statistic<T>,
    isotropy: Statistic<T>,
    skipped: u64,
}

impl<T: Real> Survey<T> {
    /// Creates an empty survey. `reference` is the unit for areas, in square metres per unit of x and of y.
    #[must_use]
    pub fn new(reference: T) -> Self {
        Self {
            reference,
            aspect: Statistic::about(T::ONE),
            sides: Statistic::about(T::ONE),
            area: Statistic::about(T::ONE),
            deformation: Statistic::about(T::ZERO),
            scale: Statistic::about(T::ONE),
            isotropy: Statistic::about(T::ONE),
            skipped: 0,
        }
    }

    /// Includes a point and the derivative of the ground there.
    #[inline]
    pub fn include(&mut self, point: FacePoint<T>, texel: &Jacobian<T>) {
        self.take(point, measures(texel, self.reference));
    }

    /// Includes part of a row.
    fn include_row(&mut self, face: Face, y: T, xs: &[T], texels: [&[T]; MEASURES]) {
        let at = |x: T| FacePoint::within(face, x, y);
        let [aspect, sides, area, deformation, scale, isotropy] = texels;
        self.aspect.include_row(at, xs, aspect);
        self.sides.include_row(at, xs, sides);
        self.area.include_row(at, xs, area);
        self.deformation.include_row(at, xs, deformation);
        self.scale.include_row(at, xs, scale);
        self.isotropy.include_row(at, xs, isotropy);
    }

    /// Includes the measures of a point.
    fn take(&mut self, point: FacePoint<T>, measures: [T; MEASURES]) {
        let [aspect, sides, area, deformation, scale, isotropy] = measures;
        self.aspect.include(point, aspect);
        self.sides.include(point, sides);
        self.area.include(point, area);
        self.deformation.include(point, deformation);
        self.scale.include(point, scale);
        self.isotropy.include(point, isotropy);
    }

    /// Includes n × n points of a face, at x and y of −1 + 2i/n for i from 0 to n − 1. The edges
    /// at x = 1 and y = 1 are left out, so that each texel counts once; by symmetry those at −1 represent
    /// them.
    ///
    /// Points where the map has no derivative are left out and counted in [`skipped`](Self::skipped).
    pub fn face<P: CubeProjection>(&mut self, ground: &Ground<T, P>, face: Face, n: u32) {
        self.rows(ground, face, n, None::<fn(Direction<T>) -> bool>);
    }

    /// Includes those of the n × n points of a face that `keep` accepts, for example those on land. Each
    /// texel that is kept counts once.
    ///
    /// `keep` is called with the outward normal of the ground, whose
    /// [`to_lat_lon`](Direction::to_lat_lon) gives the geodetic latitude and the longitude.
    ///
    /// ```
    /// use terrella::cube::{Balanced, CubeMap, Face};
    /// use terrella::distortion::{Ground, Survey};
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let ground = Ground::new(CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Balanced)?);
    /// let mut tropics = Survey::new(ground.fair_texel());
    /// for face in Face::ALL {
    ///     tropics.face_where(&ground, face, 30, |normal| normal.z().abs() < 0.4);
    /// }
    /// // Of the planet's area, 40 %.
    /// assert!((1900..2500).contains(&tropics.area().count()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn face_where<P: CubeProjection>(
        &mut self,
        ground: &Ground<T, P>,
        face: Face,
        n: u32,
        keep: impl FnMut(Direction<T>) -> bool,
    ) {
        self.rows(ground, face, n, Some(keep));
    }

    /// Includes points of a face: all, or those that `keep` accepts.
    fn rows<P: CubeProjection>(
        &mut self,
        ground: &Ground<T, P>,
        face: Face,
        n: u32,
        keep: Option<impl FnMut(Direction<T>) -> bool>,
    ) {
        ground.map().projection().with(Rows {
            survey: self,
            shifted: ground.lifted(),
            spherical: &ground.map().shifted(),
            face,
            n,
            keep,
        });
    }

    /// Includes n × n points of each of the six faces. This works for any projection, even if all its faces
    /// differ.
    ///
    /// For the projections of this crate it is enough to survey the front for all side faces and the top for
    /// both polar ones.
    pub fn sphere<P: CubeProjection>(&mut self, ground: &Ground<T, P>, n: u32) {
        for face in Face::ALL {
            self.face(ground, face, n);
        }
    }

    /// Includes all points that another survey has. Both must have the same reference.
    pub fn merge(&mut self, other: &Self) {
        self.aspect.merge(&other.aspect);
        self.sides.merge(&other.sides);
        self.area.merge(&other.area);
        self.deformation.merge(&other.deformation);
        self.scale.merge(&other.scale);
        self.isotropy.merge(&other.isotropy);
        self.skipped += other.skipped;
    }

    /// Returns the statistic of δ_aspect = Λx/Λy.
    #[must_use]
    pub fn aspect(&self) -> &Statistic<T> {
        &self.aspect
    }

    /// Returns the statistic of δ_area = Λx·Λy, divided by the reference.
    #[must_use]
    pub fn sides(&self) -> &Statistic<T> {
        &self.sides
    }

    /// Returns the statistic of the true area, divided by the reference.
    #[must_use]
    pub fn area(&self) -> &Statistic<T> {
        &self.area
    }

    /// Returns the statistic of Tissot's ω, in degrees.
    #[must_use]
    pub fn deformation(&self) -> &Statistic<T> {
        &self.deformation
    }

    /// Returns the statistic of the areal scale: the reference divided by the area.
    ///
    /// With [`Ground::fair_texel`] as the reference, it is D_A, the area distortion of Lambers (2019): he
    /// gives its mean, the largest deviation from 1, and the root of the mean square deviation. That of
    /// [`area`](Self::area) is the measure for which the projections of Zucker & Higashi (2018) were
    /// optimised.
    #[must_use]
    pub fn scale(&self) -> &Statistic<T> {
        &self.scale
    }

    /// Returns the statistic of a/b, the ratio of the semi-axes of Tissot's indicatrix: D_I, the isotropy
    /// distortion of Lambers (2019).
    #[must_use]
    pub fn isotropy(&self) -> &Statistic<T> {
        &self.isotropy
    }

    /// Returns ε, the texture oversize: how many times larger than necessary a texture must be so that its
    /// worst texel is good enough.
    ///
    /// It is the larger of the ratios (largest to smallest) of δ_aspect and δ_area (paper 3.9, in the reading
    /// under which its conclusions follow).
    #[must_use]
    pub fn oversize(&self) -> T {
        max(self.aspect.ratio(), self.sides.ratio())
    }

    /// Returns the number of points that were left out because the map has no derivative there.
    #[must_use]
    pub fn skipped(&self) -> u64 {
        self.skipped
    }
}

/// The number of measures of a texel.
const MEASURES: usize = 6;

/// δ_aspect, δ_area, the true area in the same unit, ω, the areal scale, and the isotropy.
#[inline(always)]
fn measures<T: Real>(texel: &Jacobian<T>, reference: T) -> [T; MEASURES] {
    [
        texel.aspect(),
        texel.sides() / reference,
        texel.area() / reference,
        texel.deformation(),
        reference / texel.area(),
        texel.isotropy(),
    ]
}

/// The survey of a face for a known projection, a part of a row at a time.
struct Rows<'a, T, K> {
    survey: &'a mut Survey<T>,
    shifted: &'a Shifted<Dual<T, 2>>,
    spherical: &'a Shifted<T>,
    face: Face,
    n: u32,
    /// Which points are included: all without it.
    keep: Option<K>,
}

impl<T: Real, K: FnMut(Direction<T>) -> bool> ProjectionTask for Rows<'_, T, K> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self {
            survey,
            shifted,
            spherical,
            face,
            n,
            mut keep,
        } = self;
        let ellipsoid = shifted.ellipsoid();
        let [_, correction] = shifted.corrections();
        let reference = survey.reference;
        let step = T::of(2.0) / T::whole(u64::from(n));
        // The last one may round to a number beyond the face.
        let along = |index: u32| min(T::whole(u64::from(index)) * step - T::ONE, T::ONE);
        let mut places = [[T::ZERO; PART]; 2];
        let mut directions = [[T::ZERO; PART]; 9];
        let mut texels = [[T::ZERO; PART]; MEASURES];
        let mut kept = [true; PART];
        for row in 0..n {
            let y = along(row);
            for start in (0..n).step_by(PART) {
                let [xs, ys] = &mut places;
                for (x, index) in xs.iter_mut().zip(start..) {
                    *x = along(index);
                }
                *ys = [y; PART];
                sweep(
                    ToDirection { projection, face },
                    [xs.as_slice(), ys.as_slice()],
                    directions.each_mut().map(<[T; PART]>::as_mut_slice),
                );
                let known = directions.each_ref().map(<[T; PART]>::as_slice);
                let measured = texels.each_mut().map(<[T; PART]>::as_mut_slice);
                with_correction!(&correction, turn => {
                    let turn = *turn;
                    sweep(ToTexel { ellipsoid, turn, reference }, known, measured);
                });
                let here = ((n - start) as usize).min(PART);
                let used = |column| <[T]>::get(column, ..here).unwrap_or_default();
                if let Some(keep) = &mut keep {
                    let [xs, _, _, ys, _, _, zs, _, _] = known.map(used);
                    for (kept, ((&x, &y), &z)) in kept.iter_mut().zip(xs.iter().zip(ys).zip(zs)) {
                        *kept = keep(spherical.normal(Direction::within(x, y, z)));
                    }
                }
                let columns = texels.each_ref().map(|column| used(column));
                let [_, _, area, ..] = columns;
                let all = kept.iter().zip(area).all(|(&kept, &area)| kept & is_regular(area));
                if all {
                    survey.include_row(face, y, used(xs), columns);
                    continue;
                }
                for (index, (&kept, &x)) in kept.iter().zip(used(xs)).enumerate() {
                    let measures = columns.map(|column| column.get(index).copied().unwrap_or_default());
                    let [_, _, area, ..] = measures;
                    if kept & is_regular(area) {
                        survey.take(FacePoint::within(face, x, y), measures);
                    } else {
                        survey.skipped += u64::from(kept);
                    }
                }
            }
        }
    }
}

/// The number of texels that are measured together.
const PART: usize = 2 * BLOCK;

/// The kernel from a point of a face to the components of its direction, each followed by its derivatives.
#[derive(Clone, Copy)]
struct ToDirection<P> {
    projection: P,
    face: Face,
}

impl<T: Real, P: CubeProjection> Kernel<[T; 2]> for ToDirection<P> {
    type Output = [T; 9];

    #[inline(always)]
    fn apply(&self, point: [T; 2]) -> [T; 9] {
        let [x, y, z] = self.projection.vector(self.face, Dual::variables(point));
        let ([xx, xy], [yx, yy], [zx, zy]) = (x.slopes(), y.slopes(), z.slopes());
        [x.value(), xx, xy, y.value(), yx, yy, z.value(), zx, zy]
    }
}

/// The kernel from those to the measures of a survey.
#[derive(Clone, Copy)]
struct ToTexel<T, C> {
    ellipsoid: Ellipsoid<Dual<T, 2>>,
    turn: C,
    reference: T,
}

impl<T: Real, C: Turn<Dual<T, 2>>> Kernel<[T; 9]> for ToTexel<T, C> {
    type Output = [T; MEASURES];

    #[inline(always)]
    fn apply(&self, [x, xx, xy, y, yx, yy, z, zx, zy]: [T; 9]) -> [T; MEASURES] {
        let direction = [Dual::new(x, [xx, xy]), Dual::new(y, [yx, yy]), Dual::new(z, [zx, zy])];
        measures(&jacobian(self.ellipsoid, &self.turn, direction), self.reference)
    }
}
