use super::slab::Slab;
use super::vector::{along, difference};
use super::{Camera, Enclosure, Heights, Tile};
use crate::Real;
use crate::cube::CubeProjection;
use crate::math::{max, min, select};

/// The corners and the middles of the edges as nodes of a grid of 2 × 2 cells, counter-clockwise.
pub(super) const BOUNDARY: [[u32; 2]; 8] = [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]];

impl<T: Real, P: CubeProjection> Enclosure<T, P> {
    /// Returns an estimate of the number of pixels that the ground of a tile covers, including those beyond
    /// the sides of the picture. Returns infinity if the tile is partly behind the eye, or so wide that it is seen from
    /// several sides: a coarse tile of a stretched cube.
    ///
    /// The estimate is the area within the tile's edges at the middle of its heights, plus the outline of a
    /// relief of two fifths of their range: half of the sum of four walls along the edges, since a line of
    /// sight that meets two walls enters through one of them. It is two fifths because hills do not fill
    /// their box: with that factor, a [`Selection`](super::Selection) has about as many tiles as if the
    /// ground itself were known (`tests/terrain/visible.rs`). Slopes that face away from the eye count as if
    /// they were visible.
    ///
    /// If the height range is larger than the tile's width, the ground is somewhere in a tall box and does
    /// not fill it. A box as high as it is wide then stands for the ground: of those that may be in the
    /// picture, the one nearest to the centre of projection. Returns infinity if the centre of projection is
    /// inside it.
    ///
    /// ```
    /// use terrella::cube::{Balanced, CubeMap, Face};
    /// use terrella::terrain::{Camera, Enclosure, Heights, Tile};
    /// use terrella::{Ecef, Ellipsoid, Shift};
    ///
    /// let enclosure = Enclosure::new(CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Balanced)?);
    /// let eye = Ecef::new(6_478_137.0, 0.0, 0.0)?; // 100 km above 0° N 0° E
    /// let matrix = [[0.0, 2.0, 0.0, 0.0], [0.0, 0.0, 2.0, 0.0], [0.0; 4], [-1.0, 0.0, 0.0, 0.0]];
    /// let camera = Camera::new(eye, matrix, [1024.0, 1024.0])?;
    /// // 9.5 km wide, 97 pixels.
    /// let tile = Tile::new(Face::Front, 10, 512, 512)?;
    /// let pixels = enclosure.coverage(&camera, tile, Heights::default());
    /// assert!((pixels.sqrt() - 97.0).abs() < 1.0);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "SSE")]
    #[doc(alias = "screen-space error")]
    #[doc(alias = "screen space error")]
    #[doc(alias = "geometric error")]
    #[must_use]
    pub fn coverage(&self, camera: &Camera<T>, tile: Tile, heights: Heights<T>) -> T {
        if self.is_wide(tile) {
            return T::of(f64::INFINITY);
        }
        let slab = Slab::new(&self.of(tile, heights), camera, camera.point());
        self.covered(camera, tile, heights, &slab)
    }

    /// The same as [`coverage`](Self::coverage), for a slab that is already known.
    #[inline]
    pub(super) fn covered(&self, camera: &Camera<T>, tile: Tile, heights: Heights<T>, slab: &Slab<T>) -> T {
        let half = T::of(0.5);
        let (shifted, eye) = (self.map().shifted(), camera.eye().to_array());
        let [width, height, _] = slab.bounds.half();
        let relief = min(half * (heights.high() - heights.low()), min(width, height));
        let middle = half * (heights.low() + heights.high()) + slab.above;
        let mut near = slab.away == Some(T::ZERO);
        // The top of a wall, its middle and its foot.
        let mut wall = |node| {
            let normal = shifted.normal(self.map().projection().unproject(tile.node(node, 2)));
            let ground = along(shifted.ellipsoid().foot(normal), middle, normal.to_array());
            let ground = camera.clip(difference(ground, eye), T::ONE);
            let rise = camera.clip(normal.to_array().map(|v| v * (T::of(0.4) * relief)), T::ZERO);
            [T::ONE, T::ZERO, -T::ONE].map(|up| {
                let point = along(ground, up, rise);
                let [_, _, w] = point;
                near |= w <= T::ZERO;
                camera.on_picture(point)
            })
        };
        let [_, centre, _] = wall([1, 1]);
        let nodes = BOUNDARY.map(wall);
        // Eight triangles. The areas of the two orientations are added up separately: beyond the horizon a
        // tile turns its back.
        let (mut areas, mut walls) = ([T::ZERO; 2], T::ZERO);
        let following = nodes.into_iter().cycle().skip(1);
        for ([top, here, foot], [next_top, next, next_foot]) in nodes.into_iter().zip(following) {
            let area = turn(centre, here, centre, next);
            let [front, back] = &mut areas;
            *front += max(area, T::ZERO);
            *back += max(-area, T::ZERO);
            walls += turn(foot, next_top, next_foot, top).abs();
        }
        let [front, back] = areas;
        let area = half * max(front, back) + T::of(0.25) * walls;
        select(near, T::of(f64::INFINITY), area)
    }
}

/// The cross product of the vector from a to b and the vector from c to d.
#[inline(always)]
fn turn<T: Real>([ax, ay]: [T; 2], [bx, by]: [T; 2], [cx, cy]: [T; 2], [dx, dy]: [T; 2]) -> T {
    (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
}
