use super::InvalidPatch;
use super::bilinear::{blend, weights};
use super::patch::{Places, samples_and_length};
use crate::math::min;
use crate::simd::{Kernel, front, sweep};

/// The corners of a [`Patch`](super::Patch) from a camera, in metres in Earth axes: what single precision needs of a tile for a frame.
///
/// A vertex is P′ + o + h·n, where P′ is interpolated between the corners and h is the height above the
/// patch's [`Base`](super::Base), to be subtracted in double precision. Rounding is at most 4·10⁻⁷ of the
/// farthest corner's distance and h, which is below 10⁻⁶ of the vertex's own distance where the tile's
/// diagonal is at most as long as that. Tiles that share an edge, a level and the heights of the base in the
/// edge's ends have the same bits along it, on whichever faces they are.
///
/// For a shader: weights are products of m/c and (c − m)/c, n/c and (c − n)/c with c = `samples` − 1; P′ is the sum of two sums, each of two
/// opposite corners, and o and h·n are added to it in this order. Where a compiler contracts products and sums, edges agree to their rounding only.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vertices {
    pub(super) corners: [[f32; 3]; 4],
}

impl Vertices {
    /// The corners from the camera in metres, counter-clockwise from the one of largest x and y, as
    /// [`Corner::ALL`](crate::cube::Corner::ALL).
    #[must_use]
    #[inline(always)]
    pub const fn corners(&self) -> [[f32; 3]; 4] {
        self.corners
    }

    /// The vertex in column m and row n of a grid of `samples` × `samples`, from the camera in metres, for
    /// its displacement in metres, its normal and its height above the base in metres.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Face, Quadrilateralized};
    /// use terrella::terrain::{Base, Patches, Tile};
    /// use terrella::{Ecef, Ellipsoid, Shift};
    ///
    /// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized)?);
    /// let patch = patches.of(Tile::new(Face::Front, 12, 2050, 2060)?, Base::default());
    /// let seen = patch.seen_from(Ecef::new(6_378_500.0, 3_000.0, 20_000.0)?);
    /// let corner = seen.at([0, 0], 65, [0.0; 3], patch.normals()[2], 0.0);
    /// assert_eq!(corner, seen.corners()[2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn at(
        &self,
        [m, n]: [u32; 2],
        samples: u32,
        displacement: [f32; 3],
        normal: [f32; 3],
        height: f32,
    ) -> [f32; 3] {
        let last = samples.saturating_sub(1).max(1);
        let place = [m.min(last) as f32, n.min(last) as f32];
        vertex(self.corners, place, last as f32, displacement, normal, height)
    }

    /// All vertices of a patch, from the camera in metres: what [`at`](Self::at) says, in rows from below, into three slices for x, y and z.
    ///
    /// Displacements and normals are those of [`Patches::fill`](super::Patches::fill); heights are above the
    /// base in metres, in the same order.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Face, Quadrilateralized};
    /// use terrella::terrain::{Base, Patches, Tile};
    /// use terrella::{Ecef, Ellipsoid, Shift};
    ///
    /// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized)?);
    /// // Once per tile:
    /// let (mut ox, mut oy, mut oz) = ([0.0; 25], [0.0; 25], [0.0; 25]);
    /// let (mut nx, mut ny, mut nz) = ([0.0; 25], [0.0; 25], [0.0; 25]);
    /// let tile = Tile::new(Face::Front, 12, 2050, 2060)?;
    /// let base = Base::new([1_500.0, 1_400.0, 1_300.0, 1_600.0])?;
    /// let patch = patches.fill(tile, base, 5, [&mut ox, &mut oy, &mut oz], [&mut nx, &mut ny, &mut nz])?;
    /// let heights: [f32; 25] = std::array::from_fn(|k| (1_420.0 - base.at([k as u32 % 5, k as u32 / 5], 5)) as f32);
    /// // Once per frame:
    /// let seen = patch.seen_from(Ecef::new(6_380_000.0, 3_000.0, 20_000.0)?);
    /// let (mut x, mut y, mut z) = ([0.0; 25], [0.0; 25], [0.0; 25]);
    /// seen.fill(5, [&ox, &oy, &oz], [&nx, &ny, &nz], &heights, [&mut x, &mut y, &mut z])?;
    /// assert_eq!([x[7], y[7], z[7]], seen.at([2, 1], 5, [ox[7], oy[7], oz[7]], [nx[7], ny[7], nz[7]], heights[7]));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPatch`] for less than 2 samples or more than 4097, and for a slice that is not of `samples`² elements; nothing is written then.
    pub fn fill(
        &self,
        samples: u32,
        displacements: [&[f32]; 3],
        normals: [&[f32]; 3],
        heights: &[f32],
        mut vertices: [&mut [f32]; 3],
    ) -> Result<(), InvalidPatch> {
        let [ox, oy, oz] = displacements;
        let [nx, ny, nz] = normals;
        let mut columns = [ox, oy, oz, nx, ny, nz, heights];
        let [x, y, z] = vertices.each_ref().map(|column| column.len());
        let [a, b, c, d, e, f, g] = columns.map(<[f32]>::len);
        samples_and_length(samples, &[a, b, c, d, e, f, g, x, y, z])?;
        let kernel = ToVertex {
            corners: self.corners,
            last: (samples - 1) as f32,
        };
        let mut places = Places::new(samples);
        while let Some(places) = places.next::<f32>() {
            let [m, n] = places.columns();
            let [ox, oy, oz, nx, ny, nz, h] = columns.each_mut().map(|column| {
                let (head, rest) = column.split_at_checked(m.len()).unwrap_or_default();
                *column = rest;
                head
            });
            sweep(kernel, [m, n, ox, oy, oz, nx, ny, nz, h], front(&mut vertices, m.len()));
        }
        Ok(())
    }

    /// The vertex at (s, t) in [0, 1]² without displacement, its normal interpolated between those of the
    /// corners ([`Patch::normals`](super::Patch::normals)), at a height above the base in metres: for tiles
    /// from the level that [`Patches::plain_level`](super::Patches::plain_level) says.
    ///
    /// A base that is not level adds a third of the largest difference of its heights times that of its
    /// normals.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Face, Balanced};
    /// use terrella::terrain::{Base, Heights, Patches, Tile};
    /// use terrella::{Ecef, Ellipsoid, Shift};
    ///
    /// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Balanced)?);
    /// let level = patches.plain_level(0.01, Heights::new(-11_000.0, 9_000.0)?).ok_or("none")?;
    /// assert_eq!(level, 15);
    /// let patch = patches.of(Tile::new(Face::Front, level, 9_000, 9_000)?, Base::default());
    /// let seen = patch.seen_from(patch.corners()[0]);
    /// assert_eq!(seen.plain([1.0, 1.0], patch.normals(), 0.0), [0.0; 3]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn plain(&self, [s, t]: [f32; 2], normals: [[f32; 3]; 4], height: f32) -> [f32; 3] {
        let place = [min(s, 1.0), min(t, 1.0)];
        let normal = blend(normals, weights(place, 1.0));
        vertex(self.corners, place, 1.0, [0.0; 3], normal, height)
    }
}

/// P = P′ + o + h·n.
#[inline(always)]
fn vertex(
    corners: [[f32; 3]; 4],
    place: [f32; 2],
    last: f32,
    [ox, oy, oz]: [f32; 3],
    [nx, ny, nz]: [f32; 3],
    height: f32,
) -> [f32; 3] {
    let [x, y, z] = blend(corners, weights(place, last));
    // Two tiles may have zeros of different signs.
    [
        x + ox + height * nx + 0.0,
        y + oy + height * ny + 0.0,
        z + oz + height * nz + 0.0,
    ]
}

/// Column, row, displacement, normal and height to the vertex.
#[derive(Clone, Copy)]
struct ToVertex {
    corners: [[f32; 3]; 4],
    last: f32,
}

impl Kernel<f32, 9, 3> for ToVertex {
    #[inline(always)]
    fn apply(&self, [m, n, ox, oy, oz, nx, ny, nz, height]: [f32; 9]) -> [f32; 3] {
        vertex(self.corners, [m, n], self.last, [ox, oy, oz], [nx, ny, nz], height)
    }
}
