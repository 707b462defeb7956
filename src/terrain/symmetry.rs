use super::patch::samples_and_length;
use super::{InvalidPatch, Tile};
use crate::cube::Face;
use crate::math::select;

/// The symmetry that maps the patch of one tile to that of another: see [`Tile::representative`].
///
/// An ellipsoid of revolution whose axis is that of the cube keeps its shape under quarter turns about the
/// axis, under the mirror of the equator and under the mirrors of meridians; so does a level
/// [`Base`](super::Base), of the same height everywhere. These are 16 symmetries of tiles; eight of them map
/// a polar face to itself, four a side face. A symmetry exchanges and negates vector components, so
/// displacements and normals are carried over without rounding: the result has the same bits as that of
/// [`Patches::fill`](super::Patches::fill). The exception is the conformal cube: it is itself symmetric only
/// to 2 ulps, and displacements there agree within 6 nm and one ulp. If x and y of a projection differ on a
/// polar face ([`Faces::are_square`](crate::cube::Faces::are_square)), use the symmetries of its side faces
/// only.
#[doc(alias = "instancing")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Symmetry {
    from: Face,
    to: Face,
    /// In the local frame of the face, x and y are exchanged first …
    swapped: bool,
    /// … then x, y or both are negated.
    mirrored: [bool; 2],
}

impl Tile {
    /// Returns the representative of this tile, and the symmetry that maps the representative to this tile.
    ///
    /// All tiles that the ellipsoid's symmetries map to each other have the same representative: a tile of
    /// the front or top face in the quarter where x and y are positive, and on the top face where x ≥ y. The
    /// patch of a polar face's tile is that of its representative only if x and y are alike there: see
    /// [`Symmetry`].
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::Tile;
    /// let (representative, symmetry) = Tile::new(Face::Bottom, 3, 4, 0)?.representative();
    /// assert_eq!(representative, Tile::new(Face::Top, 3, 7, 4)?);
    /// // Column 0 of row 0 of a 5 × 5 grid on the bottom corresponds to column 4 of row 0 there.
    /// assert_eq!(symmetry.place([0, 0], 5), [4, 0]);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    pub const fn representative(self) -> (Self, Symmetry) {
        let (last, half) = (self.last(), (1 << self.level) / 2);
        let mirrored = [self.i < half, self.j < half];
        let i = if mirrored[0] { last - self.i } else { self.i };
        let j = if mirrored[1] { last - self.j } else { self.j };
        let polar = self.face.is_polar();
        let swapped = polar && j > i;
        let face = if polar { Face::Top } else { Face::Front };
        let (i, j) = if swapped { (j, i) } else { (i, j) };
        let symmetry = Symmetry {
            from: face,
            to: self.face,
            swapped,
            mirrored,
        };
        (Self::within(face, self.level, i, j), symmetry)
    }

    /// Returns how many tiles of a level are their own representatives: 2 of the 6 tiles of level 0, and
    /// (3k² + k)/2 of the 24k² tiles of a finer level, with k = 2^(level − 1). A level above 30 is treated
    /// as 30.
    ///
    /// ```
    /// use terrella::terrain::Tile;
    /// assert_eq!([0, 1, 2, 3, 10].map(Tile::distinct), [2, 2, 7, 26, 393_472]);
    /// ```
    #[must_use]
    pub const fn distinct(level: u8) -> u64 {
        if level == 0 {
            return 2;
        }
        let level = if level > Self::MAX_LEVEL {
            Self::MAX_LEVEL
        } else {
            level
        };
        let k = 1_u64 << (level - 1);
        (3 * k * k + k) / 2
    }
}

impl Symmetry {
    /// Maps a displacement or a normal of the representative to this tile.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// use terrella::terrain::Tile;
    /// let (_, symmetry) = Tile::new(Face::Back, 1, 1, 0)?.representative();
    /// assert_eq!(symmetry.vector([1.0, 2.0, 3.0]), [-1.0, -2.0, -3.0]);
    /// # Ok::<(), terrella::terrain::InvalidTile>(())
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn vector(self, vector: [f32; 3]) -> [f32; 3] {
        let [right, up, outward] = self.from.to_local(vector);
        let (right, up) = select(self.swapped, (up, right), (right, up));
        let [beside, above] = self.mirrored;
        let local = [select(beside, -right, right), select(above, -up, up), outward];
        // Adding 0 makes a negative zero positive.
        self.to.to_earth(local).map(|v| v + 0.0)
    }

    /// Returns the column and row in the representative's grid of `samples` × `samples` points that
    /// correspond to column m and row n of this tile's grid.
    #[must_use]
    #[inline(always)]
    pub fn place(self, [m, n]: [u32; 2], samples: u32) -> [u32; 2] {
        let last = samples.saturating_sub(1);
        let [beside, above] = self.mirrored;
        let m = select(beside, last.saturating_sub(m), m);
        let n = select(above, last.saturating_sub(n), n);
        select(self.swapped, [n, m], [m, n])
    }

    /// Maps the displacements or normals of all samples of the representative to this tile.
    ///
    /// `from` and `to` each hold three slices, for x, y and z, with `samples`² elements row by row from
    /// below.
    ///
    /// ```
    /// use terrella::cube::{CubeMap, Face, Quadrilateralized};
    /// use terrella::terrain::{Base, Patches, Tile};
    /// use terrella::{Ellipsoid, Shift};
    ///
    /// let patches = Patches::new(CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Quadrilateralized)?);
    /// let tile = Tile::new(Face::Left, 5, 3, 30)?;
    /// let (representative, symmetry) = tile.representative();
    /// let fill = |tile| {
    ///     let (mut o, mut n) = ([[0.0; 16]; 3], [[0.0; 16]; 3]);
    ///     let (into_o, into_n) = (o.each_mut().map(|o| &mut o[..]), n.each_mut().map(|n| &mut n[..]));
    ///     patches.fill(tile, Base::default(), 4, into_o, into_n).map(|_| o)
    /// };
    /// let mut carried = [[0.0; 16]; 3];
    /// let known = fill(representative)?;
    /// symmetry.fill(4, known.each_ref().map(|o| &o[..]), carried.each_mut().map(|o| &mut o[..]))?;
    /// assert_eq!(carried, fill(tile)?);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPatch`] if `samples` is not 2 to 4097, or if a slice does not have `samples`² elements.
    /// Nothing is written then.
    pub fn fill(self, samples: u32, from: [&[f32]; 3], to: [&mut [f32]; 3]) -> Result<(), InvalidPatch> {
        let ([a, b, c], [x, y, z]) = (from, to);
        samples_and_length(samples, &[a.len(), b.len(), c.len(), x.len(), y.len(), z.len()])?;
        let mut place = [0, 0];
        for ((x, y), z) in x.iter_mut().zip(y).zip(z) {
            let [m, n] = self.place(place, samples);
            let index = n as usize * samples as usize + m as usize;
            let component = |column: &[f32]| column.get(index).copied().unwrap_or_default();
            [*x, *y, *z] = self.vector([component(a), component(b), component(c)]);
            let [m, n] = place;
            place = if m + 1 == samples { [0, n + 1] } else { [m + 1, n] };
        }
        Ok(())
    }
}
