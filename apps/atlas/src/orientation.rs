//! The orientation of the cube with the least distortion on land.

use draw::page::escaped;
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection, Rotation, Tangential, Turned};
use terrella::distortion::Ground;
use terrella::{Direction, Ellipsoid, LatLon, Shift};

use crate::land::Land;
use crate::page::Shown;

/// Places on the sphere, three tenths of which are land: for the first look, and for the last.
const PLACES: [u32; 2] = [2_000, 20_000];

/// Orientations of the first look, evenly spread: neighbours are some 20° apart.
const ORIENTATIONS: u32 = 1_500;

/// The best of the first look, which the search goes on from.
const STARTS: usize = 6;

/// Cells along the edge of a face in the table of distortions.
const CELLS: usize = 96;

/// Whole degrees: the front face's centre, and the azimuth of its upward axis there.
pub type Place = [i32; 3];

/// What turning a cube gains on land.
pub struct Orientation {
    /// The root mean square of ω on land, in degrees: as the cube stands, and turned.
    deformation: [f64; 2],
    /// How it is turned.
    front: Place,
}

/// A matrix that maps a vector along Earth axes to one along the cube's axes, by its rows.
type Matrix = [[f64; 3]; 3];

/// ω² of cells between planes through the centre, on every face.
struct Table(Vec<f64>);

impl Table {
    fn new(projection: Projection) -> Option<Self> {
        let ground = ground(projection)?;
        let middle = |index: usize| (2 * index + 1) as f64 / CELLS as f64 - 1.0;
        let square = |face, column, row| {
            let place = Tangential.unproject(FacePoint::new(face, middle(column), middle(row)).ok()?);
            let texel = ground.jacobian(projection.project(place)).ok()?;
            Some(texel.deformation().powi(2))
        };
        let rows = Face::ALL
            .into_iter()
            .flat_map(|face| (0..CELLS).map(move |row| (face, row)));
        rows.flat_map(|(face, row)| (0..CELLS).map(move |column| square(face, column, row)))
            .collect::<Option<_>>()
            .map(Self)
    }

    /// ω² at a place along the cube's axes.
    fn at(&self, place: [f64; 3]) -> f64 {
        let Ok(direction) = Direction::new(place[0], place[1], place[2]) else {
            return f64::NAN;
        };
        let point = Tangential.project(direction);
        let [column, row] = [point.x(), point.y()].map(|x| (((x + 1.0) * 0.5 * CELLS as f64) as usize).min(CELLS - 1));
        self.0[(usize::from(point.face().index()) * CELLS + row) * CELLS + column]
    }

    /// The mean of ω² over places, after a turn.
    fn mean(&self, turn: &Matrix, places: &[[f64; 3]]) -> f64 {
        let sum: f64 = places.iter().map(|&place| self.at(times(turn, place))).sum();
        sum / places.len() as f64
    }
}

/// The unit sphere.
fn ground<P: CubeProjection>(projection: P) -> Option<Ground<f64, P>> {
    let sphere = Ellipsoid::sphere(1.0).ok()?;
    Some(Ground::new(CubeMap::new(sphere, Shift::Geodetic, projection).ok()?))
}

/// The root mean square of ω over places, in degrees, by the map's own derivatives.
fn deformation<P: CubeProjection>(projection: P, places: &[[f64; 3]]) -> Option<f64> {
    let ground = ground(projection)?;
    let mut sum = 0.0;
    for &[x, y, z] in places {
        let texel = ground
            .jacobian(ground.map().projection().project(Direction::new(x, y, z).ok()?))
            .ok()?;
        sum += texel.deformation().powi(2);
    }
    Some((sum / places.len() as f64).sqrt())
}

/// Places on land, from so many evenly on the sphere, on a spiral.
fn dry(land: &Land, count: u32) -> Vec<[f64; 3]> {
    let place = |i: u32| {
        let z = f64::from(2 * i + 1) / f64::from(count) - 1.0;
        let (sin, cos) = (2.399_963_229_728_653 * f64::from(i)).sin_cos();
        let axial = (1.0 - z * z).sqrt();
        Direction::new(axial * cos, axial * sin, z).ok()
    };
    let places = (0..count).filter_map(place);
    places
        .filter(|&place| land.holds(place))
        .map(Direction::to_array)
        .collect()
}

/// The search for a projection; none if it keeps angles, as then nothing is to be gained.
pub fn search(projection: Projection, land: &Land) -> Option<Orientation> {
    let table = Table::new(projection)?;
    if table.0.iter().all(|&square| square < 1e-9) {
        return None;
    }
    let [few, all] = PLACES.map(|count| dry(land, count));
    let mut looked: Vec<(f64, Matrix)> = (0..ORIENTATIONS)
        .map(|i| matrix(quaternion(i, ORIENTATIONS)))
        .map(|turn| (table.mean(&turn, &few), turn))
        .collect();
    looked.sort_by(|a, b| a.0.total_cmp(&b.0));
    let refined = looked
        .into_iter()
        .take(STARTS)
        .map(|(_, turn)| refine(&table, turn, &all));
    let (_, best) = refined.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let front = front(&best);
    let turned = Turned::new(projection, rotation(front)?);
    Some(Orientation {
        deformation: [deformation(projection, &all)?, deformation(turned, &all)?],
        front,
    })
}

/// Turns about the cube's axes by less and less, as long as that helps.
fn refine(table: &Table, mut turn: Matrix, places: &[[f64; 3]]) -> (f64, Matrix) {
    let mut least = table.mean(&turn, places);
    for degrees in [8.0_f64, 4.0, 2.0, 1.0] {
        loop {
            let before = least;
            for axis in 0..3 {
                for angle in [degrees, -degrees] {
                    let next = product(&about(axis, angle.to_radians()), &turn);
                    let mean = table.mean(&next, places);
                    if mean < least {
                        (least, turn) = (mean, next);
                    }
                }
            }
            if least >= before {
                break;
            }
        }
    }
    (least, turn)
}

fn times(turn: &Matrix, v: [f64; 3]) -> [f64; 3] {
    turn.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let column = |j: usize| times(a, [b[0][j], b[1][j], b[2][j]]);
    let [x, y, z] = [0, 1, 2].map(column);
    [0, 1, 2].map(|i| [x[i], y[i], z[i]])
}

/// The turn about an axis by an angle in radians.
fn about(axis: usize, angle: f64) -> Matrix {
    let (sin, cos) = angle.sin_cos();
    let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
    let mut turn = [[0.0; 3]; 3];
    turn[axis][axis] = 1.0;
    (turn[next][next], turn[next][last]) = (cos, -sin);
    (turn[last][next], turn[last][last]) = (sin, cos);
    turn
}

/// One of so many unit quaternions, spread evenly (Alexa, Super-Fibonacci spirals, CVPR 2022).
fn quaternion(index: u32, count: u32) -> [f64; 4] {
    let s = f64::from(index) + 0.5;
    let t = s / f64::from(count);
    let (near, far) = (t.sqrt(), (1.0 - t).sqrt());
    let turn = |period: f64| std::f64::consts::TAU * s / period;
    let ((sin_a, cos_a), (sin_b, cos_b)) = (turn(2.0_f64.sqrt()).sin_cos(), turn(1.533_751_168_755_204_3).sin_cos());
    [near * sin_a, near * cos_a, far * sin_b, far * cos_b]
}

fn matrix([x, y, z, w]: [f64; 4]) -> Matrix {
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - z * w),
            2.0 * (x * z + y * w),
        ],
        [
            2.0 * (x * y + z * w),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - x * w),
        ],
        [
            2.0 * (x * z - y * w),
            2.0 * (y * z + x * w),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

/// The front face's place and azimuth, of a turn whose rows are the cube's axes along Earth axes.
fn front([outward, _, up]: &Matrix) -> Place {
    let [x, y, z] = *outward;
    let (lat, lon) = (z.atan2(x.hypot(y)), y.atan2(x));
    let (sin_lat, cos_lat, sin_lon, cos_lon) = (lat.sin(), lat.cos(), lon.sin(), lon.cos());
    let east = up[1] * cos_lon - up[0] * sin_lon;
    let north = up[2] * cos_lat - sin_lat * (up[0] * cos_lon + up[1] * sin_lon);
    [lat, lon, east.atan2(north)].map(|angle| angle.to_degrees().round() as i32)
}

/// The rotation of a front face's place.
pub fn rotation([lat, lon, azimuth]: Place) -> Option<Rotation> {
    let place = LatLon::new(f64::from(lat), f64::from(lon)).ok()?;
    Rotation::facing(Face::Front, place.to_direction(), f64::from(azimuth)).ok()
}

/// The section of the page.
pub fn section(shown: &[Shown]) -> String {
    let mut turned: Vec<_> = shown
        .iter()
        .filter_map(|s| Some((s, s.orientation.as_ref()?)))
        .collect();
    turned.sort_by(|(_, a), (_, b)| a.deformation[1].total_cmp(&b.deformation[1]));
    let rows: String = turned
        .iter()
        .map(|(s, orientation)| {
            let ([stands, turned], [lat, lon, azimuth]) = (orientation.deformation, orientation.front);
            let gain = 100.0 * (1.0 - turned / stands);
            format!(
                "<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th><td class=\"number\">{stands:.2}°</td>\
                 <td class=\"number\">{turned:.2}°</td><td class=\"number\">{gain:.0} %</td>\
                 <td><code>--front {lat},{lon},{azimuth}</code></td></tr>\n",
                s.projection,
                escaped(s.projection.profile().title),
            )
        })
        .collect();
    if rows.is_empty() {
        return rows;
    }
    format!(
        r##"<section aria-labelledby="orientation">
<h2 id="orientation">Turned for the land</h2>
<p>Most cubes are worst at their eight corners. A cube may be turned so that corners and edges lie in the sea: here is, for each projection,
the root mean square of ω on land as the cube stands, with its front at 0° N 0° E, and as a search over all orientations leaves it. The last
column says where the front face’s centre is then, and the azimuth of the face’s upward axis there: so <code>pipe project</code> takes
it, and <code>Rotation::facing</code>.</p>
<div class="scroll" role="region" aria-labelledby="orientation" tabindex="0">
<table>
<thead>
<tr><th scope="col">Projection</th><th scope="col" class="number">ω rms, as it stands</th><th scope="col" class="number">turned</th>
<th scope="col" class="number">gain</th><th scope="col">Turned to</th></tr>
</thead>
<tbody>
{rows}</tbody>
</table>
</div>
<p class="note">On the sphere, over the places on land of 20 000 spread evenly. Of {count} orientations the best six are turned further by
smaller and smaller angles; the last figures are those of the rounded degrees. The conformal cube keeps angles in any orientation.</p>
</section>
"##,
        count = ORIENTATIONS
    )
}

#[cfg(test)]
mod tests {
    use super::{Place, front, matrix, quaternion, rotation, search};
    use crate::land::Land;
    use terrella::cube::Projection;

    /// A turn's place leads to the turn again, but for the rounding of degrees.
    #[test]
    fn places_and_turns_agree() {
        for i in 0..50 {
            let turn = matrix(quaternion(i, 50));
            let Some(rotation) = rotation(front(&turn)) else {
                unreachable!("a rotation")
            };
            let rows = rotation.matrix();
            for (row, axis) in turn.iter().enumerate() {
                for (column, value) in axis.iter().enumerate() {
                    assert!((rows[column][row] - value).abs() < 0.03, "{turn:?} {rows:?}");
                }
            }
        }
    }

    #[test]
    fn a_turn_gains_on_land() {
        let land = Land::read(&draw::data::file("land-110m.tsv")).unwrap_or_else(|why| unreachable!("{why}"));
        let found = search(Projection::Adjusted, &land);
        let (deformation, place) = found.map_or(([0.0; 2], Place::default()), |found| (found.deformation, found.front));
        assert!(deformation[1] < 0.9 * deformation[0], "{deformation:?} {place:?}");
        assert!(search(Projection::Conformal, &land).is_none());
    }
}
