//! What a projection does to shapes and sizes, measured on the sphere: surveys by the crate, and the bends of grid lines.

use terrella::cube::{CubeMap, Edge, Face, FacePoint, Projection};
use terrella::distortion::{Ground, Jacobian, Survey};
use terrella::{Ellipsoid, Shift};

/// Columns of places that are measured on a face. None of them is on a midline, and with two more rows none is on a diagonal: the
/// places where a projection may be creased are seen from both sides, or not at all.
const COLUMNS: u32 = 300;

/// How far from a crease its sides are measured.
const BESIDE: f64 = 1e-9;

/// A projection in numbers.
pub struct Measures {
    /// The whole sphere.
    pub sphere: Surveys,
    /// A face around the equator, and one around a pole.
    pub kinds: [Surveys; 2],
    /// Largest turn of a grid line on the ground inside a face, in degrees.
    pub inner_bend: f64,
    /// Largest turn of a grid line on the ground from face to face, in degrees.
    pub edge_bend: f64,
}

/// The same ground twice.
#[derive(Clone, Copy)]
pub struct Surveys {
    /// Evenly: for means.
    pub usual: Survey<f64>,
    /// Along edges and creases too: for extremes.
    pub worst: Survey<f64>,
}

impl Surveys {
    fn new(ground: &Ground<f64, Projection>) -> Self {
        let none = Survey::new(ground.central_texel());
        Self {
            usual: none,
            worst: none,
        }
    }

    fn of(ground: &Ground<f64, Projection>, face: Face) -> Self {
        let mut surveys = Self::new(ground);
        let include = |survey: &mut Survey<f64>, [x, y]: [f64; 2]| {
            if let Ok(point) = FacePoint::new(face, x, y)
                && let Ok(texel) = ground.jacobian(point)
            {
                survey.include(point, &texel);
            }
        };
        let middle = |index: u32, count: u32| f64::from(2 * index + 1) / f64::from(count) - 1.0;
        for row in 0..COLUMNS + 2 {
            for column in 0..COLUMNS {
                let point = [middle(column, COLUMNS), middle(row, COLUMNS + 2)];
                include(&mut surveys.usual, point);
            }
        }
        surveys.worst = surveys.usual;
        let coordinates = places_along().flat_map(|s| [s, -s]).chain([1.0, -1.0]);
        for s in coordinates {
            for aside in [BESIDE, -BESIDE] {
                for point in [[s + aside, s], [s + aside, -s], [s, aside], [s, aside.signum()]] {
                    include(&mut surveys.worst, point);
                    include(&mut surveys.worst, [point[1], point[0]]);
                }
            }
            include(&mut surveys.worst, [s, s.signum()]);
        }
        surveys
    }

    fn merge(&mut self, other: &Self) {
        self.usual.merge(&other.usual);
        self.worst.merge(&other.worst);
    }

    /// True area of the largest cell over that of the smallest.
    pub fn area_ratio(&self) -> f64 {
        self.unless_conformal(self.worst.area().ratio())
    }

    /// Width times height, largest over smallest.
    pub fn sides_ratio(&self) -> f64 {
        self.unless_conformal(self.worst.sides().ratio())
    }

    /// The paper's ε.
    pub fn oversize(&self) -> f64 {
        self.unless_conformal(self.worst.oversize())
    }

    /// Where three right angles of the cube fill a whole turn of the sphere, angles are kept by vanishing cells only, at a place that is
    /// in no survey.
    fn unless_conformal(&self, ratio: f64) -> f64 {
        if self.is_conformal() { f64::INFINITY } else { ratio }
    }

    /// Whether angles are kept, up to rounding.
    pub fn is_conformal(&self) -> bool {
        self.worst.deformation().max() < 1e-6
    }
}

impl Measures {
    /// Measures a projection on the front and the top, for all side faces are alike and so are both polar ones.
    pub fn of(projection: Projection) -> Self {
        let ground = sphere(projection);
        let kinds = [Face::Front, Face::Top].map(|face| Surveys::of(&ground, face));
        let mut sphere = Surveys::new(&ground);
        for face in Face::ALL {
            sphere.merge(&kinds[usize::from(face.is_polar())]);
        }
        Self {
            sphere,
            kinds,
            inner_bend: inner_bend(&ground),
            edge_bend: edge_bend(&ground),
        }
    }

    /// Whether a side face and a polar one differ.
    pub fn has_two_kinds(&self) -> bool {
        let [side, polar] = self.kinds.map(|surveys| surveys.worst.aspect().max());
        (side - polar).abs() > 1e-9
    }

    /// Whether every cell covers the same area.
    pub fn is_equal_area(&self) -> bool {
        self.sphere.area_ratio() < 1.0 + 1e-9
    }
}

/// The sphere of radius 1 under the faces of a projection.
pub fn sphere(projection: Projection) -> Ground<f64, Projection> {
    let map = Ellipsoid::sphere(1.0)
        .ok()
        .and_then(|sphere| CubeMap::new(sphere, Shift::Geodetic, projection).ok());
    Ground::new(map.unwrap_or_else(|| unreachable!("the unit sphere is an ellipsoid, with every latitude")))
}

/// The texel at a place, unless it has none.
pub fn texel(ground: &Ground<f64, Projection>, face: Face, [x, y]: [f64; 2]) -> Option<Jacobian<f64>> {
    ground.jacobian(FacePoint::new(face, x, y).ok()?).ok()
}

/// The largest turn of a grid line at the diagonals and midlines of a face.
fn inner_bend(ground: &Ground<f64, Projection>) -> f64 {
    let bend = |face, from, to, line: fn(&Jacobian<f64>) -> [f64; 2]| {
        Some(turn(line(&texel(ground, face, from)?), line(&texel(ground, face, to)?)))
    };
    let (less, more) = (-BESIDE, BESIDE);
    [Face::Front, Face::Top]
        .into_iter()
        .flat_map(|face| places_along().map(move |s| (face, s)))
        .flat_map(|(face, s)| {
            [
                bend(face, [s + less, s], [s + more, s], |texel| texel.by_x),
                bend(face, [s, s + less], [s, s + more], |texel| texel.by_y),
                bend(face, [less, s], [more, s], |texel| texel.by_x),
                bend(face, [s, less], [s, more], |texel| texel.by_y),
            ]
        })
        .flatten()
        .fold(0.0, crate::maximum)
}

/// The largest turn of a grid line between the front and its neighbours to the right and above.
fn edge_bend(ground: &Ground<f64, Projection>) -> f64 {
    let right = Face::Front.neighbour(Edge::Right).face;
    let above = Face::Front.neighbour(Edge::Up).face;
    places_along()
        .flat_map(|s| {
            let (from, to) = (texel(ground, Face::Front, [1.0, s]), texel(ground, right, [-1.0, s]));
            let across = from.zip(to).map(|(from, to)| turn(from.by_x, to.by_x));
            let (from, to) = (texel(ground, Face::Front, [s, 1.0]), texel(ground, above, [s, -1.0]));
            let upward = from.zip(to).map(|(from, to)| turn(from.by_y, to.by_y));
            [across, upward]
        })
        .flatten()
        .fold(0.0, crate::maximum)
}

/// Coordinates from the middle of a crease to nearly its end.
fn places_along() -> impl Iterator<Item = f64> {
    (1..=1000).map(|i| f64::from(i) * 0.9999e-3)
}

/// The angle between two vectors to the east and to the north, in degrees.
fn turn([a, b]: [f64; 2], [c, d]: [f64; 2]) -> f64 {
    (a * d - b * c).abs().atan2(a * c + b * d).to_degrees()
}
