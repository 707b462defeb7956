//! Triangles to pixels, in either precision: corners on a fixed grid, so that neighbours leave no hole, what is between them in perspective,
//! the nearest wins.

use crate::scalar::Scalar;

/// Steps of the grid to a pixel.
const STEPS: i64 = 256;

/// How many times as wide and high as the picture a triangle may be before it is cut.
const GUARD: f64 = 4.0;

/// Nothing nearer than this is drawn, in metres.
const NEAR: f64 = 1.0;

/// What is drawn at a place: red, green and blue from 0 to 1, and a quantity.
pub type Paint = [f32; 4];

/// A picture in the making.
pub struct Canvas<T> {
    pub width: u32,
    pub height: u32,
    /// One over the distance along the line of sight; 0 where nothing is.
    inverse: Vec<T>,
    paint: Vec<Paint>,
}

/// A corner of a triangle, in the picture.
#[derive(Clone, Copy)]
pub struct Corner<T> {
    clip: [T; 3],
    paint: Paint,
    /// Where on the grid; none where the triangle is to be cut.
    grid: Option<[i64; 2]>,
}

impl<T: Scalar> Canvas<T> {
    pub fn new([width, height]: [u32; 2]) -> Self {
        let pixels = width as usize * height as usize;
        Self {
            width,
            height,
            inverse: vec![T::ZERO; pixels],
            paint: vec![[0.0; 4]; pixels],
        }
    }

    /// What is seen at a pixel, if anything.
    pub fn at(&self, column: u32, row: u32) -> Option<Paint> {
        let index = row as usize * self.width as usize + column as usize;
        (self.inverse[index] > T::ZERO).then(|| self.paint[index])
    }

    /// A corner at x, y and w of clip space.
    pub fn corner(&self, clip: [T; 3], paint: Paint) -> Corner<T> {
        let [x, y, w] = clip;
        let room = T::of(GUARD) * w;
        let fits = w >= T::of(NEAR) && x.abs() <= room && y.abs() <= room;
        let half = T::of(0.5);
        // Rows are counted from above.
        let grid = fits.then(|| {
            let place = |v: T, count: u32| (half + half * v) * T::whole(u64::from(count) * STEPS as u64) + half;
            [place(x / w, self.width), place(-(y / w), self.height)].map(|v| Into::<f64>::into(v).floor() as i64)
        });
        Corner { clip, paint, grid }
    }

    /// Draws a triangle, either side of it.
    pub fn triangle(&mut self, corners: [Corner<T>; 3]) {
        // All beyond one side of the picture.
        let beyond = |side: fn([T; 3]) -> bool| corners.iter().all(|corner| side(corner.clip));
        if beyond(|[x, _, w]| x > w)
            || beyond(|[x, _, w]| -x > w)
            || beyond(|[_, y, w]| y > w)
            || beyond(|[_, y, w]| -y > w)
        {
            return;
        }
        let [a, b, c] = corners;
        if let (Some(p), Some(q), Some(r)) = (a.grid, b.grid, c.grid) {
            self.fill(corners, [p, q, r]);
            return;
        }
        let cut = self.cut(corners);
        let Some((&first, rest)) = cut.split_first() else {
            return;
        };
        for pair in rest.windows(2) {
            let fan = [first, pair[0], pair[1]];
            if let [Some(p), Some(q), Some(r)] = fan.map(|corner| corner.grid) {
                self.fill(fan, [p, q, r]);
            }
        }
    }

    /// The part of a triangle that is before the eye and not too far to the sides.
    fn cut(&self, corners: [Corner<T>; 3]) -> Vec<Corner<T>> {
        // A little inside of what a corner on the grid asks for.
        let guard = T::of(0.75 * GUARD);
        let sides: [&dyn Fn([T; 3]) -> T; 5] = [
            &|[_, _, w]| w - T::of(2.0 * NEAR),
            &|[x, _, w]| guard * w - x,
            &|[x, _, w]| guard * w + x,
            &|[_, y, w]| guard * w - y,
            &|[_, y, w]| guard * w + y,
        ];
        let mut shape = corners.to_vec();
        for side in sides {
            let mut kept = Vec::with_capacity(shape.len() + 1);
            for (index, &corner) in shape.iter().enumerate() {
                let next = shape[(index + 1) % shape.len()];
                let (here, there) = (side(corner.clip), side(next.clip));
                if here >= T::ZERO {
                    kept.push(corner);
                }
                if (here >= T::ZERO) != (there >= T::ZERO) {
                    // From the inside to the outside, so that both triangles of an edge have the same place.
                    let (inner, outer, part) = if here >= T::ZERO {
                        (corner, next, here / (here - there))
                    } else {
                        (next, corner, there / (there - here))
                    };
                    kept.push(self.between(inner, outer, part));
                }
            }
            shape = kept;
        }
        shape
    }

    /// Part of the way from a corner to another.
    fn between(&self, from: Corner<T>, to: Corner<T>, part: T) -> Corner<T> {
        let clip = std::array::from_fn(|k| from.clip[k] + part * (to.clip[k] - from.clip[k]));
        let share = part.single();
        let paint = std::array::from_fn(|k| from.paint[k] + share * (to.paint[k] - from.paint[k]));
        self.corner(clip, paint)
    }

    /// Draws a triangle whose corners are on the grid.
    fn fill(&mut self, [a, b, c]: [Corner<T>; 3], [p, q, r]: [[i64; 2]; 3]) {
        let area = (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]);
        let ([a, b, c], [p, q, r], area) = match area {
            0 => return,
            1.. => ([a, b, c], [p, q, r], area),
            _ => ([a, c, b], [p, r, q], -area),
        };
        let range = |axis: usize, count: u32| {
            let (low, high) = (p[axis].min(q[axis]).min(r[axis]), p[axis].max(q[axis]).max(r[axis]));
            // Pixels whose middles are between.
            let middle = STEPS / 2;
            let first = (low - middle + STEPS - 1).div_euclid(STEPS).max(0);
            let last = (high - middle).div_euclid(STEPS).min(i64::from(count) - 1);
            first..=last
        };
        let edges = [(q, r), (r, p), (p, q)].map(|(from, to)| Edge::new(from, to));
        let inverses = [a, b, c].map(|corner| T::ONE / corner.clip[2]);
        let share = T::ONE / T::whole(area as u64);
        for row in range(1, self.height) {
            for column in range(0, self.width) {
                let at = [column * STEPS + STEPS / 2, row * STEPS + STEPS / 2];
                let inside = edges.each_ref().map(|edge| edge.inside(at));
                if inside.iter().zip(&edges).any(|(&inside, edge)| inside < edge.least) {
                    continue;
                }
                let parts: [T; 3] = std::array::from_fn(|k| T::whole(inside[k] as u64) * share * inverses[k]);
                let inverse = parts[0] + parts[1] + parts[2];
                let index = row as usize * self.width as usize + column as usize;
                if inverse > self.inverse[index] {
                    self.inverse[index] = inverse;
                    let [u, v, w] = parts.map(|part| (part / inverse).single());
                    self.paint[index] = std::array::from_fn(|k| u * a.paint[k] + v * b.paint[k] + w * c.paint[k]);
                }
            }
        }
    }
}

/// An edge with the triangle on its positive side.
struct Edge {
    from: [i64; 2],
    along: [i64; 2],
    /// A pixel on the line belongs to one of the two triangles that share it.
    least: i64,
}

impl Edge {
    fn new(from: [i64; 2], to: [i64; 2]) -> Self {
        let along = [to[0] - from[0], to[1] - from[1]];
        let is_top_or_left = along[1] < 0 || (along[1] == 0 && along[0] > 0);
        Self {
            from,
            along,
            least: i64::from(!is_top_or_left),
        }
    }

    fn inside(&self, at: [i64; 2]) -> i64 {
        self.along[0] * (at[1] - self.from[1]) - self.along[1] * (at[0] - self.from[0])
    }
}
