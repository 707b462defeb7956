use super::slab::Slab;
use super::vector::{along, difference};
use super::{Camera, Enclosure, Heights, Tile};
use crate::Real;
use crate::cube::CubeProjection;
use crate::math::{max, min, select};

/// Counter-clockwise, each corner followed by the middle of an edge.
pub(super) const BOUNDARY: [[u32; 2]; 8] = [[0, 0], [1, 0], [2, 0], [2, 1], [2, 2], [1, 2], [0, 2], [0, 1]];

impl<T: Real, P: CubeProjection> Enclosure<T, P> {
    /// How many pixels the ground of a tile is taken to cover, whether they are in the picture or beyond its
    /// sides; infinitely many if it is partly behind the eye.
    ///
    /// It is the area within the tile's edges at the middle of its heights, and what a relief of two fifths
    /// of their range has of outline beyond that: half of the sum of four walls along the edges, since a line
    /// of sight that meets two of them enters by one. Two fifths, because hills do not fill their box: with
    /// that there are about as many tiles as there would be if the ground itself were known
    /// (`tests/terrain/visible.rs`). Slopes that turn their back count as if they were seen.
    ///
    /// Where heights are farther apart than the tile is wide, the ground is somewhere in a tall box and not
    /// everywhere: a box as high as wide is taken for it, the nearest to the centre of projection of those
    /// that may be in the picture. Infinitely many pixels if the centre of projection is in it.
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
    #[must_use]
    pub fn coverage(&self, camera: &Camera<T>, tile: Tile, heights: Heights<T>) -> T {
        let slab = Slab::new(&self.of(tile, heights), camera, camera.point());
        self.covered(camera, tile, heights, &slab)
    }

    /// The same, where it is known what is taken for the ground.
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
        // Eight triangles, those of either sense apart: beyond the horizon a tile turns its back.
        let (mut areas, mut walls) = ([T::ZERO; 2], T::ZERO);
        for ([top, here, foot], [next_top, next, next_foot]) in nodes.into_iter().zip(nodes.into_iter().cycle().skip(1))
        {
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

/// The cross product of the ways from a to b and from c to d.
#[inline(always)]
fn turn<T: Real>([ax, ay]: [T; 2], [bx, by]: [T; 2], [cx, cy]: [T; 2], [dx, dy]: [T; 2]) -> T {
    (bx - ax) * (dy - cy) - (by - ay) * (dx - cx)
}
