//! What a projection does to shapes and sizes, measured on the sphere by differences over a tiny step.

use terrella::cube::{CubeProjection, Edge, Face, FacePoint, Projection};

/// Half the step of a difference: the square root of the rounding of a coordinate, about.
const STEP: f64 = 1e-8;

/// How far from a crease its sides are measured.
const BESIDE: f64 = 1e-7;

/// Points along a side of each triangle that is searched.
const POINTS: u32 = 180;

/// A projection in numbers.
pub struct Measures {
    /// Ground area of a cell: that of the largest over that of the smallest.
    pub area_ratio: f64,
    /// Width over height of a cell on the ground, along the grid: smallest and largest.
    pub aspect: [f64; 2],
    /// The larger of the aspect's ratio and that of width times height.
    pub oversize: f64,
    /// Largest change of an angle, in degrees.
    pub deformation: f64,
    /// Largest turn of a grid line on the ground inside a face, in degrees.
    pub inner_bend: f64,
    /// Largest turn of a grid line on the ground from face to face, in degrees.
    pub edge_bend: f64,
}

impl Measures {
    /// Measures a projection on the front and the top, for all side faces are alike and so are both polar ones.
    pub fn of(projection: Projection) -> Self {
        let mut area = Range::EMPTY;
        let mut aspect = Range::EMPTY;
        let mut sides = Range::EMPTY;
        let mut deformation = Range::EMPTY;
        for face in [Face::Front, Face::Top] {
            for [x, y] in quarter() {
                let [a, b] = slopes(projection, face, [x, y]);
                let (width, height, cell) = (length(a), length(b), length(cross(a, b)));
                area.include(cell);
                aspect.include(width / height);
                sides.include(width * height);
                deformation.include(angular_deformation(width, height, cell));
            }
        }
        let deformation = deformation.max;
        let conformal = deformation < CONFORMAL;
        Self {
            // Where three right angles of the cube fill a whole turn of the sphere, angles are kept by vanishing cells only.
            area_ratio: if conformal { f64::INFINITY } else { area.ratio() },
            aspect: [aspect.min, aspect.max],
            oversize: if conformal {
                f64::INFINITY
            } else {
                aspect.ratio().max(sides.ratio())
            },
            deformation,
            inner_bend: inner_bend(projection),
            edge_bend: edge_bend(projection),
        }
    }

    /// Largest over smallest ratio of width to height.
    pub fn aspect_ratio(&self) -> f64 {
        self.aspect[1] / self.aspect[0]
    }

    /// Whether every cell covers the same area.
    pub fn is_equal_area(&self) -> bool {
        self.area_ratio < 1.000_01
    }

    /// Whether angles are kept.
    pub fn is_conformal(&self) -> bool {
        self.deformation < CONFORMAL
    }
}

/// Degrees of deformation that are rounding.
const CONFORMAL: f64 = 0.01;

struct Range {
    min: f64,
    max: f64,
}

impl Range {
    const EMPTY: Self = Self {
        min: f64::INFINITY,
        max: f64::NEG_INFINITY,
    };

    fn include(&mut self, value: f64) {
        self.min = self.min.min(value);
        self.max = self.max.max(value);
    }

    fn ratio(&self) -> f64 {
        self.max / self.min
    }
}

/// Points of the upper right quarter of a face, close to its edges, diagonal and midlines but on none of them: there a
/// projection may be creased.
fn quarter() -> impl Iterator<Item = [f64; 2]> {
    let along = |i: u32, from: f64, to: f64| from + (to - from) * f64::from(i) / f64::from(POINTS - 1);
    (0..POINTS * POINTS).flat_map(move |index| {
        let long = along(index / POINTS, 2e-3, 1.0 - 1e-6);
        let short = long * along(index % POINTS, 1e-5, 1.0 - 1e-5);
        [[long, short], [short, long]]
    })
}

/// The derivatives of the unit vector by x and by y.
fn slopes(projection: Projection, face: Face, [x, y]: [f64; 2]) -> [[f64; 3]; 2] {
    let at = |x, y| FacePoint::new(face, x, y).map_or([f64::NAN; 3], |point| projection.unproject(point).to_array());
    let slope = |from: [f64; 3], to: [f64; 3]| std::array::from_fn(|i| (to[i] - from[i]) / (2.0 * STEP));
    [
        slope(at(x - STEP, y), at(x + STEP, y)),
        slope(at(x, y - STEP), at(x, y + STEP)),
    ]
}

/// Tissot's ω in degrees, of a cell of these sides and this area: sin(ω/2) = (a − b)/(a + b) with the semi-axes a, b of the ellipse.
fn angular_deformation(width: f64, height: f64, area: f64) -> f64 {
    let squares = width * width + height * height;
    let difference = (squares - 2.0 * area).max(0.0).sqrt();
    let sum = (squares + 2.0 * area).sqrt();
    2.0 * (difference / sum).asin().to_degrees()
}

/// The largest turn of a grid line at the diagonals and midlines of a face.
fn inner_bend(projection: Projection) -> f64 {
    let bend =
        |face, from, to, axis: usize| turn(slopes(projection, face, from)[axis], slopes(projection, face, to)[axis]);
    let (less, more) = (-BESIDE, BESIDE);
    [Face::Front, Face::Top]
        .into_iter()
        .flat_map(|face| places_along().map(move |s| (face, s)))
        .flat_map(|(face, s)| {
            [
                bend(face, [s + less, s], [s + more, s], 0),
                bend(face, [s, s + less], [s, s + more], 1),
                bend(face, [less, s], [more, s], 0),
                bend(face, [s, less], [s, more], 1),
            ]
        })
        .fold(0.0, f64::max)
}

/// The largest turn of a grid line between the front and its neighbours to the right and above.
fn edge_bend(projection: Projection) -> f64 {
    let (end, begin) = (1.0 - BESIDE, BESIDE - 1.0);
    let right = Face::Front.neighbour(Edge::Right).face;
    let above = Face::Front.neighbour(Edge::Up).face;
    places_along()
        .flat_map(|s| {
            let [to_right, _] = slopes(projection, Face::Front, [end, s]);
            let [from_left, _] = slopes(projection, right, [begin, s]);
            let [_, up] = slopes(projection, Face::Front, [s, end]);
            let [_, from_below] = slopes(projection, above, [s, begin]);
            [turn(to_right, from_left), turn(up, from_below)]
        })
        .fold(0.0, f64::max)
}

/// Coordinates from the middle of a crease to nearly its end.
fn places_along() -> impl Iterator<Item = f64> {
    (1..=1000).map(|i| f64::from(i) * 0.9999e-3)
}

/// The angle between two vectors, in degrees.
fn turn(a: [f64; 3], b: [f64; 3]) -> f64 {
    let dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    length(cross(a, b)).atan2(dot).to_degrees()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn length(a: [f64; 3]) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}
