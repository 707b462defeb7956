use super::cell::{MEASURES, ToCell};
use super::strips::{Strips, WIDTH};
use super::{Ground, Statistic};
use crate::cube::{CubeProjection, Face, FacePoint, ProjectionTask};
use crate::simd::sweep;
use crate::{Real, Shifted};

/// An accumulator of measures of whole cells, when each face is divided into n × n: their areas, edges,
/// diagonals, shapes, and distances to their neighbours. Its size is fixed.
///
/// Edges and diagonals are great circles between the corners, as those of S2's cells are. The unit of length
/// is the side of a square with the mean area, which is 1.4472/n authalic radii; the unit of area is the mean
/// area. So the values of an even map hardly change with n, and those of large n are limits: S2's constants
/// (`kMinEdge`, `kMaxDiag` and so on) are these limits times 1.4472, its areas times 2.0944.
///
/// On a sphere, values have a relative error of at most n · 2e-15 (`f64`) or n · 1e-6 (`f32`), spans of at
/// most n² · 1e-16 or n² · 5e-8. On an ellipsoid, lengths are arcs of the authalic sphere over the same
/// chords: for flattenings up to 1/298 the further error is at most 4e-3/n².
///
/// ```
/// use terrella::cube::{CubeMap, Face, S2Quadratic};
/// use terrella::distortion::{Cells, Ground};
/// use terrella::{Ellipsoid, Shift};
///
/// let sphere = Ellipsoid::sphere(1.0_f64)?;
/// let ground = Ground::new(CubeMap::new(sphere, Shift::Geodetic, S2Quadratic)?);
/// let mut cells = Cells::new();
/// cells.face(&ground, Face::Front, 64);
/// assert!((cells.area().ratio() - 2.0167).abs() < 1e-3);
/// assert!(cells.diagonal_aspect().max() < 3.0_f64.sqrt());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "cell metrics")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Cells<T> {
    area: Statistic<T>,
    edge: Statistic<T>,
    diagonal: Statistic<T>,
    span: Statistic<T>,
    edge_aspect: Statistic<T>,
    diagonal_aspect: Statistic<T>,
    compactness: Statistic<T>,
    spacing: Statistic<T>,
}

impl<T: Real> Default for Cells<T> {
    fn default() -> Self {
        Self::new()
    }
}

impl<T: Real> Cells<T> {
    /// Creates an empty accumulator.
    #[must_use]
    pub fn new() -> Self {
        let one = Statistic::about(T::ONE);
        Self {
            area: one,
            edge: one,
            diagonal: Statistic::about(T::of(core::f64::consts::SQRT_2)),
            span: one,
            edge_aspect: one,
            diagonal_aspect: one,
            compactness: Statistic::about(T::of(core::f64::consts::FRAC_PI_4)),
            spacing: one,
        }
    }

    /// Includes the n × n cells of a face. A neighbour across an edge of the cube is the cell beside it there.
    pub fn face<P: CubeProjection>(&mut self, ground: &Ground<T, P>, face: Face, n: u32) {
        let shifted = ground.map().shifted();
        ground.map().projection().with(Rows {
            cells: self,
            shifted: &shifted,
            face,
            n,
        });
    }

    /// Includes the n × n cells of each of the six faces.
    pub fn sphere<P: CubeProjection>(&mut self, ground: &Ground<T, P>, n: u32) {
        for face in Face::ALL {
            self.face(ground, face, n);
        }
    }

    /// Includes all cells that another accumulator has.
    pub fn merge(&mut self, other: &Self) {
        self.area.merge(&other.area);
        self.edge.merge(&other.edge);
        self.diagonal.merge(&other.diagonal);
        self.span.merge(&other.span);
        self.edge_aspect.merge(&other.edge_aspect);
        self.diagonal_aspect.merge(&other.diagonal_aspect);
        self.compactness.merge(&other.compactness);
        self.spacing.merge(&other.spacing);
    }

    /// Includes part of a row.
    fn include_row(&mut self, at: impl Fn(T) -> FacePoint<T> + Copy, xs: &[T], measures: [&[T]; MEASURES]) {
        let [
            area,
            a,
            b,
            c,
            d,
            e,
            f,
            g,
            h,
            edge_aspect,
            diagonal_aspect,
            compactness,
            spacing,
        ] = measures;
        self.area.include_row(at, xs, area);
        for edges in [a, b, c, d] {
            self.edge.include_row(at, xs, edges);
        }
        for diagonals in [e, f] {
            self.diagonal.include_row(at, xs, diagonals);
        }
        for spans in [g, h] {
            self.span.include_row(at, xs, spans);
        }
        self.edge_aspect.include_row(at, xs, edge_aspect);
        self.diagonal_aspect.include_row(at, xs, diagonal_aspect);
        self.compactness.include_row(at, xs, compactness);
        self.spacing.include_row(at, xs, spacing);
    }

    /// Returns the statistic of areas, in units of the mean area.
    #[must_use]
    pub fn area(&self) -> &Statistic<T> {
        &self.area
    }

    /// Returns the statistic of edges: four for each cell.
    #[must_use]
    pub fn edge(&self) -> &Statistic<T> {
        &self.edge
    }

    /// Returns the statistic of diagonals: two for each cell. Deviations are from √2.
    #[must_use]
    pub fn diagonal(&self) -> &Statistic<T> {
        &self.diagonal
    }

    /// Returns the statistic of angle spans, two for each cell: the angle between the planes through the
    /// centre of the planet and opposite edges. For cells on a crease it does not shrink with n, since such
    /// edges differ in direction.
    #[doc(alias = "angle span")]
    #[must_use]
    pub fn span(&self) -> &Statistic<T> {
        &self.span
    }

    /// Returns the statistic of a cell's longest edge divided by its shortest.
    #[must_use]
    pub fn edge_aspect(&self) -> &Statistic<T> {
        &self.edge_aspect
    }

    /// Returns the statistic of a cell's longer diagonal divided by the other.
    #[must_use]
    pub fn diagonal_aspect(&self) -> &Statistic<T> {
        &self.diagonal_aspect
    }

    /// Returns the statistic of compactness, A(4π − A)/P² for a cell with the area A and the perimeter P on
    /// the unit sphere: 1 for a circle of any size, π/4 for a small square, from which deviations are
    /// measured. For small cells it is 4πA/P².
    #[doc(alias = "isoperimetric quotient")]
    #[doc(alias = "zone of standardised compactness")]
    #[must_use]
    pub fn compactness(&self) -> &Statistic<T> {
        &self.compactness
    }

    /// Returns the statistic of spacing: the largest distance from a cell's centre to the centres of its four
    /// neighbours, divided by the smallest.
    #[doc(alias = "intercell distance")]
    #[must_use]
    pub fn spacing(&self) -> &Statistic<T> {
        &self.spacing
    }
}

/// The cells of a face for a known projection, a part of a row at a time.
struct Rows<'a, T> {
    cells: &'a mut Cells<T>,
    shifted: &'a Shifted<T>,
    face: Face,
    n: u32,
}

impl<T: Real> ProjectionTask for Rows<'_, T> {
    type Output = ();

    fn run<P: CubeProjection>(self, projection: P) {
        let Self {
            cells,
            shifted,
            face,
            n,
        } = self;
        let strips = Strips::new(projection, shifted, face, n);
        let kernel = ToCell {
            side: T::of(1.447_202_509_116_535_3) / T::whole(u64::from(n)),
        };
        let mut measures = [[T::ZERO; WIDTH]; MEASURES];
        for start in (0..n).step_by(WIDTH) {
            let here = ((n - start) as usize).min(WIDTH);
            let centres = strips.centres(start);
            for row in 0..n {
                let parts = strips.around(start, row, here);
                let places = parts.each_ref().map(|part| part.columns(here));
                let into = |column| <[T]>::get_mut(column, ..here).unwrap_or_default();
                sweep(
                    kernel,
                    *places.as_flattened().first_chunk().unwrap_or(&[&[]; 27]),
                    measures.each_mut().map(|column| into(column)),
                );
                let y = strips.centre(row + 1);
                cells.include_row(
                    |x| FacePoint::within(face, x, y),
                    centres.get(1..=here).unwrap_or_default(),
                    measures.each_ref().map(|column| column.get(..here).unwrap_or_default()),
                );
            }
        }
    }
}
