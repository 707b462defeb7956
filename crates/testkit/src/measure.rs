//! What a projection does to shapes and sizes, measured on the sphere by the crate.

use terrella::cube::{CubeMap, Face, FacePoint, Projection};
use terrella::distortion::{Cells, Ground, Jacobian, Kinks, Survey};
use terrella::{Ellipsoid, Shift};

/// Columns of places that are measured on a face. None of them is on a midline, and with two more rows none is on a diagonal: the
/// places where a projection may be creased are seen from both sides, or not at all.
const COLUMNS: u32 = 300;

/// How far from a crease its sides are measured.
const BESIDE: f64 = 1e-9;

/// Cells along the edge of a face.
const CELLS: u32 = 64;

/// Places along a crease where kinks are measured.
const KINKS: u32 = 2000;

/// A projection in numbers.
pub struct Measures {
    /// The whole sphere.
    pub sphere: Surveys,
    /// A face around the equator, and one around a pole.
    pub kinds: [Surveys; 2],
    /// How lines turn at creases.
    pub kinks: Kinks<f64>,
    /// What whole cells are like.
    pub cells: Cells<f64>,
}

/// The same ground twice.
#[derive(Clone, Copy)]
pub struct Surveys {
    /// Evenly: for means.
    pub usual: Survey<f64>,
    /// The same places, with areas in units of their mean.
    pub fair: Survey<f64>,
    /// Along edges and creases too: for extremes.
    pub worst: Survey<f64>,
}

impl Surveys {
    fn new(ground: &Ground<f64, Projection>) -> Self {
        let none = Survey::new(ground.central_texel());
        Self {
            usual: none,
            fair: Survey::new(ground.fair_texel()),
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
                include(&mut surveys.fair, point);
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
        self.fair.merge(&other.fair);
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
        let (mut kinks, mut cells) = (Kinks::new(), Cells::new());
        for face in [Face::Front, Face::Top] {
            kinks.face(&ground, face, KINKS);
            cells.face(&ground, face, CELLS);
        }
        Self {
            sphere,
            kinds,
            kinks,
            cells,
        }
    }

    /// Largest turn of a line on the ground inside a face, in degrees.
    pub fn inner_bend(&self) -> f64 {
        crate::maximum(self.kinks.diagonals().max(), self.kinks.midlines().max())
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

/// Coordinates from the middle of a crease to nearly its end.
fn places_along() -> impl Iterator<Item = f64> {
    (1..=1000).map(|i| f64::from(i) * 0.9999e-3)
}
