use core::fmt;

use super::bilinear::{blend, mean, weights};
use super::vector::{along, difference};
use super::{Base, Tile, Vertices};
use crate::cube::{Corner, CubeMap, CubeProjection, Edge, FacePoint, Faces, ProjectionTask};
use crate::latitude::{Turn, normal, with_correction};
use crate::simd::{CHUNK, Kernel, front, sweep};
use crate::{Direction, Ecef, Ellipsoid, Real, Shifted};

/// The largest number of samples along an edge of a patch.
const MOST: u32 = 4097;

/// Tiles as patches of an ellipsoid, for a renderer that works in single precision (Lambers & Kolb 2012,
/// section 4).
///
/// Once per tile, [`fill`](Self::fill) computes in double precision the tile's corners, lifted to a [`Base`]
/// near the ground, and in single precision, for each sample of a grid, the ellipsoid's normal n and the
/// displacement o of the base from the bilinear patch between the corners. Once per frame,
/// [`Patch::seen_from`] subtracts the camera from the corners in double precision and rounds the result to
/// single precision. Each vertex is then P′ + o + h·n in single precision, where P′ is interpolated between
/// the corners and h is the height above the base ([`Vertices`]).
///
/// In the paper the corners lie on the ellipsoid, and h is the height above it. On a mountain of 8 km, single
/// precision then adds kilometres to kilometres, and the result is off by millimetres however near the eye
/// is. The base avoids that.
///
/// ```
/// use terrella::cube::{CubeMap, Face, Quadrilateralized};
/// use terrella::terrain::{Base, Patches, Tile};
/// use terrella::{Ellipsoid, Shift};
///
/// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized)?);
/// let tile = Tile::new(Face::Front, 8, 130, 140)?;
/// let sea = Base::default();
/// let (mut ox, mut oy, mut oz) = ([0.0; 81], [0.0; 81], [0.0; 81]);
/// let (mut nx, mut ny, mut nz) = ([0.0; 81], [0.0; 81], [0.0; 81]);
/// patches.fill(tile, sea, 9, [&mut ox, &mut oy, &mut oz], [&mut nx, &mut ny, &mut nz])?;
/// // In the middle of this tile, 36 km wide, the displacement is 42 m upward, and 128 m along the ground
/// // because the grid lines bend.
/// assert!((ox[40] - 42.0).abs() < 1.0 && (nx[40] - 0.997).abs() < 0.002);
/// assert!((oy[40].hypot(oz[40]) - 128.0).abs() < 2.0);
/// // At the corners the displacement is zero.
/// assert_eq!((ox[0], oy[8], oz[80]), (0.0, 0.0, 0.0));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "displacement mapping")]
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Patches<P> {
    map: CubeMap<f64, P>,
}

impl<P: CubeProjection> Patches<P> {
    /// Creates the patches of a cube map's tiles.
    #[must_use]
    pub const fn new(map: CubeMap<f64, P>) -> Self {
        Self { map }
    }

    /// Returns the cube map.
    #[must_use]
    pub const fn map(&self) -> CubeMap<f64, P> {
        self.map
    }

    /// Returns the corners of a tile, lifted to a base. From the level of [`plain_level`](Self::plain_level)
    /// on, a renderer needs nothing else of a tile.
    #[must_use]
    pub fn of(&self, tile: Tile, base: Base) -> Patch {
        let mut heights = base.corners().into_iter();
        let ends = Corner::ALL.map(|corner| {
            let right = matches!(corner, Corner::UpRight | Corner::DownRight);
            let up = matches!(corner, Corner::UpRight | Corner::UpLeft);
            let [foot, normal] = self.ground(shared(
                self.map.projection().faces(),
                tile,
                [right.into(), up.into()],
                1,
            ));
            [along(foot, heights.next().unwrap_or_default(), normal), normal]
        });
        Patch {
            corners: ends.map(|[corner, _]| corner),
            normals: ends.map(|[_, normal]| normal.map(narrow)),
        }
    }

    /// Computes the displacements and normals of a tile's samples, and returns the tile's corners, lifted to
    /// a base.
    ///
    /// The samples are the `samples` × `samples` nodes of a grid over the tile, its edges included, row by
    /// row from below. A displacement is the vector from the bilinear patch between the corners to the base,
    /// in metres; a normal is the ellipsoid's outward unit normal. Both are along Earth axes, each in three
    /// slices for x, y and z.
    ///
    /// Before they are rounded to single precision, displacements are within 4 nm (on the Earth) and normals
    /// within 4·10⁻¹⁶. Two tiles of one level that share an edge get identical bits along it, also across
    /// faces that agree there ([`CubeProjection::faces`]), if their bases have the same heights at both ends
    /// of the edge: samples on the edge of a face are computed on the face of the smallest number.
    ///
    /// # Errors
    /// [`InvalidPatch`] if `samples` is not 2 to 4097, or if a slice does not have `samples`² elements.
    /// Nothing is written then.
    pub fn fill(
        &self,
        tile: Tile,
        base: Base,
        samples: u32,
        displacements: [&mut [f32]; 3],
        normals: [&mut [f32]; 3],
    ) -> Result<Patch, InvalidPatch> {
        let [ox, oy, oz] = displacements;
        let [nx, ny, nz] = normals;
        let mut columns = [ox, oy, oz, nx, ny, nz];
        samples_and_length(samples, &columns.each_ref().map(|column| column.len()))?;
        let patch = self.of(tile, base);
        let lifted = Lifted {
            corners: patch.corners,
            base,
            last: f64::from(samples - 1),
        };
        self.map.projection().with(Fill {
            shifted: self.map.shifted(),
            tile,
            lifted,
            samples,
            columns: columns.each_mut().map(|column| &mut **column),
        });
        self.mend(tile, samples, lifted, &mut columns);
        Ok(patch)
    }

    /// Overwrites the samples that lie on the edge of a face with those computed on the neighbouring face, if
    /// that face has the smaller number.
    fn mend(&self, tile: Tile, samples: u32, lifted: Lifted, columns: &mut [&mut [f32]; 6]) {
        let last = samples - 1;
        for edge in Edge::ALL {
            if tile.neighbour(edge).tile.face() >= tile.face() {
                continue;
            }
            for along in 0..samples {
                let [m, n] = match edge {
                    Edge::Right => [last, along],
                    Edge::Up => [along, last],
                    Edge::Left => [0, along],
                    Edge::Down => [along, 0],
                };
                let ground = self.ground(shared(self.map.projection().faces(), tile, [m, n], last));
                let sample = lifted.sample(ground, [m.into(), n.into()]);
                let index = n as usize * samples as usize + m as usize;
                for (column, value) in columns.iter_mut().zip(sample) {
                    if let Some(slot) = column.get_mut(index) {
                        *slot = narrow(value);
                    }
                }
            }
        }
    }

    /// The point on the ellipsoid, in metres, and the ellipsoid's normal there.
    #[inline(always)]
    pub(super) fn ground(&self, point: FacePoint<f64>) -> [[f64; 3]; 2] {
        let shifted = self.map.shifted();
        let normal = shifted.normal(self.map.projection().unproject(point));
        [shifted.ellipsoid().foot(normal), normal.to_array()]
    }
}

/// The corners of a tile and the normals there: from [`Patches::of`] and [`Patches::fill`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Patch {
    corners: [[f64; 3]; 4],
    normals: [[f32; 3]; 4],
}

impl Patch {
    /// Returns the corners at the heights of the base, in metres along Earth axes, in the order of
    /// [`Corner::ALL`]: counter-clockwise from the corner of largest x and y.
    #[must_use]
    pub fn corners(&self) -> [Ecef<f64>; 4] {
        self.corners.map(|[x, y, z]| Ecef::within(x, y, z))
    }

    /// Returns the ellipsoid's outward unit normals at the corners, along Earth axes.
    #[must_use]
    pub const fn normals(&self) -> [[f32; 3]; 4] {
        self.normals
    }

    /// Returns the corners relative to a camera (relative-to-eye): subtracted in double precision, then
    /// rounded to single precision.
    #[doc(alias = "relative-to-eye")]
    #[doc(alias = "RTE")]
    #[must_use]
    #[inline]
    pub fn seen_from(&self, camera: Ecef<f64>) -> Vertices {
        Vertices {
            corners: self
                .corners
                .map(|corner| difference(corner, camera.to_array()).map(narrow)),
        }
    }
}

/// Rounds to single precision. A zero becomes positive, since two tiles may have zeros of different signs.
#[inline(always)]
pub(super) fn narrow(value: f64) -> f32 {
    value as f32 + 0.0
}

/// A node of a tile's grid as a point of the face of smallest number that contains it and agrees.
fn shared(faces: Faces, tile: Tile, [m, n]: [u32; 2], count: u32) -> FacePoint<f64> {
    let last = tile.last();
    let mut first = (tile, [m, n]);
    for edge in Edge::ALL {
        // The coordinates of the node in the neighbouring tile, unfolded into the plane of this one.
        let (on_edge, mut place) = match edge {
            Edge::Right => (tile.i() == last && m == count, [0, n]),
            Edge::Up => (tile.j() == last && n == count, [m, 0]),
            Edge::Left => (tile.i() == 0 && m == 0, [count, n]),
            Edge::Down => (tile.j() == 0 && n == 0, [m, count]),
        };
        let beyond = tile.neighbour(edge);
        if on_edge && beyond.tile.face() < first.0.face() && faces.agree(tile.face(), edge) {
            for _ in 0..beyond.turns {
                place = [count - place[1], place[0]];
            }
            first = (beyond.tile, place);
        }
    }
    first.0.node(first.1, count)
}

/// The corners of a tile, lifted to a base, and the last column of a grid.
#[derive(Clone, Copy)]
struct Lifted {
    corners: [[f64; 3]; 4],
    base: Base,
    last: f64,
}

impl Lifted {
    /// The displacement and normal of a node, from the point on the ellipsoid and the normal there.
    #[inline(always)]
    fn sample(&self, [foot, normal]: [[f64; 3]; 2], place: [f64; 2]) -> [f64; 6] {
        let weights = weights(place, self.last);
        let base = along(foot, mean(self.base.corners(), weights), normal);
        let [x, y, z] = difference(base, blend(self.corners, weights));
        let [nx, ny, nz] = normal;
        [x, y, z, nx, ny, nz]
    }
}

/// The computation of a tile's samples for a known projection, one part at a time.
struct Fill<'a> {
    shifted: Shifted<f64>,
    tile: Tile,
    lifted: Lifted,
    samples: u32,
    columns: [&'a mut [f32]; 6],
}

impl ProjectionTask for Fill<'_> {
    type Output = ();

    fn run<P: CubeProjection>(mut self, projection: P) {
        let [_, correction] = self.shifted.corrections();
        let mut directions = [[0.0; CHUNK]; 3];
        let to_direction = ToDirection::new(projection, self.tile, self.samples - 1);
        let mut places = Places::new(self.samples);
        while let Some(places) = places.next::<f64>() {
            let [m, n] = places.columns();
            let here = m.len();
            let [x, y, z] = &mut directions;
            let known = [x, y, z].map(|column| column.get_mut(..here).unwrap_or_default());
            sweep(to_direction, [m, n], known);
            let [x, y, z] = directions
                .each_ref()
                .map(|column| column.get(..here).unwrap_or_default());
            let sink = front(&mut self.columns, here);
            with_correction!(&correction, turn => {
                let kernel = ToSample {
                    ellipsoid: self.shifted.ellipsoid(),
                    turn: *turn,
                    lifted: self.lifted,
                };
                sweep(kernel, [m, n, x, y, z], sink);
            });
        }
    }
}

/// The kernel from column and row to the direction.
#[derive(Clone, Copy)]
struct ToDirection<P> {
    projection: P,
    tile: Tile,
    low: [f64; 2],
    across: f64,
}

impl<P> ToDirection<P> {
    /// All whole numbers here are below 2⁵³. A coordinate is one division, as in [`Tile::node`].
    fn new(projection: P, tile: Tile, count: u32) -> Self {
        let across = f64::from(count) * f64::from(1_u32 << tile.level());
        let low = [tile.i(), tile.j()].map(|index| 2.0 * f64::from(index) * f64::from(count) - across);
        Self {
            projection,
            tile,
            low,
            across,
        }
    }
}

impl<P: CubeProjection> Kernel<[f64; 2]> for ToDirection<P> {
    type Output = [f64; 3];

    #[inline(always)]
    fn apply(&self, [m, n]: [f64; 2]) -> [f64; 3] {
        let [x, y] = self.low;
        let point = [(x + 2.0 * m) / self.across, (y + 2.0 * n) / self.across];
        self.projection.vector(self.tile.face(), point)
    }
}

/// The kernel from column, row and direction to displacement and normal.
#[derive(Clone, Copy)]
struct ToSample<C> {
    ellipsoid: Ellipsoid<f64>,
    turn: C,
    lifted: Lifted,
}

impl<C: Turn<f64>> Kernel<[f64; 5]> for ToSample<C> {
    type Output = [f32; 6];

    #[inline(always)]
    fn apply(&self, [m, n, x, y, z]: [f64; 5]) -> [f32; 6] {
        let normal = normal(&self.turn, Direction::within(x, y, z));
        let ground = [self.ellipsoid.foot(normal), normal.to_array()];
        self.lifted.sample(ground, [m, n]).map(narrow)
    }
}

/// An iterator over the columns and rows of a grid, one part at a time.
pub(super) struct Places {
    samples: u32,
    next: [u32; 2],
}

/// One part of the columns and rows, as scalars.
pub(super) struct Part<T> {
    places: [[T; CHUNK]; 2],
    length: usize,
}

impl<T> Part<T> {
    #[inline(always)]
    pub(super) fn columns(&self) -> [&[T]; 2] {
        self.places
            .each_ref()
            .map(|column| column.get(..self.length).unwrap_or_default())
    }
}

impl Places {
    pub(super) const fn new(samples: u32) -> Self {
        Self { samples, next: [0; 2] }
    }

    #[inline(always)]
    pub(super) fn next<T: Real>(&mut self) -> Option<Part<T>> {
        let mut part = Part {
            places: [[T::ZERO; CHUNK]; 2],
            length: 0,
        };
        let [ms, ns] = &mut part.places;
        let [mut m, mut n] = self.next;
        for (column, row) in ms.iter_mut().zip(ns) {
            if n == self.samples {
                break;
            }
            (*column, *row) = (T::whole(m.into()), T::whole(n.into()));
            part.length += 1;
            m += 1;
            if m == self.samples {
                (m, n) = (0, n + 1);
            }
        }
        self.next = [m, n];
        (part.length > 0).then_some(part)
    }
}

/// Refuses a number of samples that is not 2 to [`MOST`], and slices that do not have one element for each
/// node of the grid.
pub(super) fn samples_and_length(samples: u32, lengths: &[usize]) -> Result<(), InvalidPatch> {
    if !(2..=MOST).contains(&samples) {
        return Err(InvalidPatch::Samples(samples));
    }
    let expected = samples as usize * samples as usize;
    match lengths.iter().find(|&&length| length != expected) {
        Some(&length) => Err(InvalidPatch::Length { expected, length }),
        None => Ok(()),
    }
}

/// The error of filling slices with the samples of a patch. Nothing was written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidPatch {
    /// The number of samples along an edge; it is not 2 to 4097.
    Samples(u32),
    /// A slice does not have one element for each sample.
    Length {
        /// The square of the number of samples along an edge.
        expected: usize,
        /// The length of the first slice that differs.
        length: usize,
    },
}

impl fmt::Display for InvalidPatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Samples(samples) => write!(f, "expected 2 to {MOST} samples along an edge, got {samples}"),
            Self::Length { expected, length } => {
                write!(f, "expected slices of {expected} elements, got a slice of {length}")
            }
        }
    }
}

impl core::error::Error for InvalidPatch {}
