use super::InvalidPatch;
use super::bilinear::{blend, weights};
use super::patch::{Places, samples_and_length};
use crate::math::min;
use crate::simd::{Kernel, front, sweep};

/// The corners of a [`Patch`](super::Patch) relative to the eye, in metres along Earth axes: all that a
/// renderer in single precision needs of a tile for one frame (relative-to-eye rendering).
///
/// A vertex is P′ + o + h·n. P′ is interpolated bilinearly between the corners, o is the displacement, n is
/// the normal, and h is the height above the patch's [`Base`](super::Base); subtract the base from the
/// terrain height in double precision. The rounding error is at most 4·10⁻⁷ of the sum of h and the farthest
/// corner's distance. That is below 10⁻⁶ of the vertex's own distance if the tile's diagonal is not longer
/// than that distance. Two tiles that share an edge, a level and the base heights at both ends of the edge
/// get identical bits along it, also across faces that agree there
/// ([`CubeProjection::faces`](crate::cube::CubeProjection::faces)).
///
/// For a shader: the weights are products of m/c or (c − m)/c with n/c or (c − n)/c, where c = `samples` − 1.
/// P′ is the sum of two sums, each of two opposite corners. Add o and then h·n to it, in this order. If a
/// compiler contracts products and sums into fused operations, edges agree only within rounding.
#[doc(alias = "relative-to-eye")]
#[doc(alias = "RTE")]
#[doc(alias = "relative-to-center")]
#[doc(alias = "RTC")]
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vertices {
    pub(super) corners: [[f32; 3]; 4],
}

impl Vertices {
    /// Returns the corners relative to the eye, in metres, in the order of
    /// [`Corner::ALL`](crate::cube::Corner::ALL): counter-clockwise from the corner of largest x and y.
    #[must_use]
    #[inline(always)]
    pub const fn corners(&self) -> [[f32; 3]; 4] {
        self.corners
    }

    /// Returns the vertex in column m and row n of a grid of `samples` × `samples`, relative to the eye, in
    /// metres. `displacement` is in metres, `normal` is a unit vector, and `height` is in metres above the
    /// base.
    ///
    /// An m or n beyond the grid is replaced by the last column or row.
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

    /// Computes all vertices of a patch, relative to the eye, in metres: the results of [`at`](Self::at), row
    /// by row from below, in three slices for x, y and z.
    ///
    /// `displacements` and `normals` are those of [`Patches::fill`](super::Patches::fill). `heights` are in
    /// metres above the base, in the same order.
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
    /// let above = |k: usize| 1_420.0 - base.at([k as u32 % 5, k as u32 / 5], 5);
    /// let heights: [f32; 25] = std::array::from_fn(|k| above(k) as f32);
    /// // Once per frame:
    /// let seen = patch.seen_from(Ecef::new(6_380_000.0, 3_000.0, 20_000.0)?);
    /// let (mut x, mut y, mut z) = ([0.0; 25], [0.0; 25], [0.0; 25]);
    /// seen.fill(5, [&ox, &oy, &oz], [&nx, &ny, &nz], &heights, [&mut x, &mut y, &mut z])?;
    /// let vertex = seen.at([2, 1], 5, [ox[7], oy[7], oz[7]], [nx[7], ny[7], nz[7]], heights[7]);
    /// assert_eq!([x[7], y[7], z[7]], vertex);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPatch`] if `samples` is not 2 to 4097, or if a slice does not have `samples`² elements.
    /// Nothing is written then.
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

    /// Returns the vertex at (s, t) ∈ [0, 1]², relative to the eye, in metres, without a displacement. The
    /// normal is interpolated between those of the corners, `normals`
    /// ([`Patch::normals`](super::Patch::normals)); `height` is in metres above the base. Use it from the
    /// level on that [`Patches::plain_level`](super::Patches::plain_level) returns. An s or t above 1 is
    /// replaced by 1.
    ///
    /// If the base is not level, the error grows by a third of the product of the largest difference between
    /// its heights and the largest difference between its normals.
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
    // Adding 0 removes the sign of a zero, which may differ between two tiles.
    [
        x + ox + height * nx + 0.0,
        y + oy + height * ny + 0.0,
        z + oz + height * nz + 0.0,
    ]
}

/// The kernel from column, row, displacement, normal and height to the vertex.
#[derive(Clone, Copy)]
struct ToVertex {
    corners: [[f32; 3]; 4],
    last: f32,
}

impl Kernel<[f32; 9]> for ToVertex {
    type Output = [f32; 3];

    #[inline(always)]
    fn apply(&self, [m, n, ox, oy, oz, nx, ny, nz, height]: [f32; 9]) -> [f32; 3] {
        vertex(self.corners, [m, n], self.last, [ox, oy, oz], [nx, ny, nz], height)
    }
}
