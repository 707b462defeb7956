//! Places and unit vectors to points of the cube's faces, and back.

use terrella::batch::cube::{self, InvalidPoint};
use terrella::batch::map;
use terrella::cube::{CubeMap, InvalidFacePoint, Projection};
use terrella::{Ellipsoid, InvalidDirection, Shift};

use crate::columns::column;
use crate::current::Current;
use crate::refusal::{Refusal, Value, or_words, refused};

static MAP: Current<CubeMap<f64, Projection>> = Current::none();

/// Calls are about this map from now on, or words. Shift and projection by their indices in `ALL`, of which the package
/// has the names.
#[unsafe(no_mangle)]
extern "C" fn cube(a: f64, f: f64, shift: usize, projection: usize) -> bool {
    let map = || {
        let (shift, projection) = (*Shift::ALL.get(shift)?, *Projection::ALL.get(projection)?);
        or_words(CubeMap::new(or_words(Ellipsoid::new(a, f))?, shift, projection))
    };
    MAP.put(map())
}

/// Columns lat, lon → face, x, y.
#[unsafe(no_mangle)]
extern "C" fn cube_project(count: usize) -> usize {
    // SAFETY: each column is lent once.
    unsafe {
        let places = [column(0, count), column(1, count)].map(|column| &*column);
        let (face, points) = (column::<u8>(2, count), [column(3, count), column(4, count)]);
        refused(map::project(MAP.get(), places, face, points))
    }
}

/// Columns face, x, y → lat, lon.
#[unsafe(no_mangle)]
extern "C" fn cube_unproject(count: usize) -> usize {
    // SAFETY: each column is lent once.
    unsafe {
        let (face, points) = (
            column::<u8>(0, count),
            [column(1, count), column(2, count)].map(|column| &*column),
        );
        let places = [column(3, count), column(4, count)];
        refused(map::unproject(MAP.get(), face, points, places))
    }
}

/// Columns x, y, z → face, x, y.
#[unsafe(no_mangle)]
extern "C" fn cube_project_direction(count: usize) -> usize {
    // SAFETY: each column is lent once.
    unsafe {
        let directions = [column(0, count), column(1, count), column(2, count)].map(|column| &*column);
        let (face, points) = (column::<u8>(3, count), [column(4, count), column(5, count)]);
        refused(cube::project(MAP.get().projection(), directions, face, points))
    }
}

/// Columns face, x, y → x, y, z.
#[unsafe(no_mangle)]
extern "C" fn cube_unproject_direction(count: usize) -> usize {
    // SAFETY: each column is lent once.
    unsafe {
        let (face, points) = (
            column::<u8>(0, count),
            [column(1, count), column(2, count)].map(|column| &*column),
        );
        let directions = [column(3, count), column(4, count), column(5, count)];
        refused(cube::unproject(MAP.get().projection(), face, points, directions))
    }
}

impl Refusal for InvalidDirection<f64> {
    type Words = InvalidDirection<Value>;

    fn words(self) -> Self::Words {
        let [x, y, z] = [self.x, self.y, self.z].map(Value);
        InvalidDirection { x, y, z }
    }
}

impl Refusal for InvalidPoint<f64> {
    type Words = InvalidPoint<Value>;

    fn words(self) -> Self::Words {
        match self {
            Self::Face(why) => InvalidPoint::Face(why),
            Self::Point(InvalidFacePoint { x, y }) => InvalidPoint::Point(InvalidFacePoint {
                x: Value(x),
                y: Value(y),
            }),
        }
    }
}
