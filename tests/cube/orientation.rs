//! Cubes that are turned and stretched, against a rotation and Schmidt's formula written here.

use fastrand::Rng;
use terrella::cube::{
    CubeMap, CubeProjection, Face, FacePoint, Healpix, InvalidRotation, InvalidStretch, Projection, ProjectionTask,
    Rotation, Stretched, Tangential, Turned,
};
use terrella::{Direction, Ellipsoid, LatLon, Shift};
use testkit::scalar::Scalar;
use testkit::vector::{angle, apart};
use testkit::{Worst, maximum};

type Matrix = [[f64; 3]; 3];

fn product(matrix: Matrix, vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| (0..3).map(|k| row[k] * vector[k]).sum())
}

fn transposed(matrix: Matrix) -> Matrix {
    core::array::from_fn(|i| core::array::from_fn(|j| matrix[j][i]))
}

/// The matrix of a random unit quaternion.
fn random_matrix(rng: &mut Rng) -> Matrix {
    let q: [f64; 4] = core::array::from_fn(|_| 2.0 * rng.f64() - 1.0);
    let length = q.iter().map(|v| v * v).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|v| v / length);
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

fn random_direction<T: Scalar>(rng: &mut Rng) -> Direction<T> {
    let [x, y, z] = core::array::from_fn(|_| T::of(2.0 * rng.f64() - 1.0));
    Direction::new(x, y, z).unwrap()
}

fn random_point<T: Scalar>(rng: &mut Rng) -> FacePoint<T> {
    let [x, y] = core::array::from_fn(|_| T::of(2.0 * rng.f64() - 1.0));
    FacePoint::new(Face::ALL[rng.usize(..6)], x, y).unwrap()
}

fn double<T: Scalar>(direction: Direction<T>) -> [f64; 3] {
    direction.to_array().map(Into::into)
}

fn turned_is_rotated<T: Scalar>(allowed: f64) {
    let mut rng = Rng::with_seed(1);
    for &projection in Projection::ALL {
        for _ in 0..2000 {
            let matrix = random_matrix(&mut rng);
            let turned = Turned::new(projection, Rotation::new(matrix).unwrap());
            let point = random_point::<T>(&mut rng);
            let expected = product(matrix, double(projection.unproject(point)));
            assert!(
                apart(expected, double(turned.unproject(point))) < allowed,
                "{projection}"
            );

            let direction = random_direction::<T>(&mut rng);
            let [x, y, z] = product(transposed(matrix), double(direction)).map(T::of);
            let expected = projection.project(Direction::new(x, y, z).unwrap());
            let found = turned.project(direction);
            // Coordinates move faster than directions.
            let moved = angle(
                double(projection.unproject(expected)),
                double(projection.unproject(found)),
            );
            assert!(moved < 4.0 * allowed, "{projection} {direction:?}: {moved:e}");
            if expected.x().abs() < T::of(0.999) && expected.y().abs() < T::of(0.999) {
                assert_eq!(found.face(), expected.face(), "{projection} {direction:?}");
                assert_eq!(turned.face(direction), found.face(), "{projection} {direction:?}");
            }
        }
    }
}

#[test]
fn a_turned_cube_is_the_plain_one_rotated() {
    turned_is_rotated::<f64>(9e-16);
    turned_is_rotated::<f32>(3e-7);
}

/// sin φ′ = (C + sin φ)/(1 + C sin φ), and the cosine of the same latitude.
fn schmidt(factor: f64, [x, y, z]: [f64; 3]) -> [f64; 3] {
    let c = (factor * factor - 1.0) / (factor * factor + 1.0);
    let sin = (c + z) / (1.0 + c * z);
    let cos = x.hypot(y) * 2.0 * factor / (factor * factor + 1.0) / (1.0 + c * z);
    let longitude = y.atan2(x);
    [cos * longitude.cos(), cos * longitude.sin(), sin]
}

fn stretched_is_schmidts<T: Scalar>(allowed: f64) {
    let mut rng = Rng::with_seed(2);
    for &projection in Projection::ALL {
        for _ in 0..1000 {
            let factor = 16_f64.powf(2.0 * rng.f64() - 1.0);
            let stretched = Stretched::new(projection, factor).unwrap();
            assert_eq!(stretched.factor(), factor);
            // The rounding of a latitude's sine grows with the factor, in the formula as it is published.
            let allowed = allowed * maximum(factor, 1.0 / factor).powi(2);
            let point = random_point::<T>(&mut rng);
            let plain = double(projection.unproject(point));
            let found = double(stretched.unproject(point));
            assert!(
                apart(schmidt(factor, plain), found) < allowed,
                "{projection} {factor} {point:?}"
            );

            let direction = random_direction::<T>(&mut rng);
            let [x, y, z] = schmidt(1.0 / factor, double(direction)).map(T::of);
            let expected = projection.project(Direction::new(x, y, z).unwrap());
            let found = stretched.project(direction);
            let moved = angle(
                double(projection.unproject(expected)),
                double(projection.unproject(found)),
            );
            assert!(moved < 4.0 * allowed, "{projection} {factor} {direction:?}: {moved:e}");
        }
    }
}

#[test]
fn a_stretched_cube_is_schmidts() {
    stretched_is_schmidts::<f64>(9e-16);
    stretched_is_schmidts::<f32>(4e-7);
}

/// tan(½θ) about the pole is multiplied by the factor: next to the poles too, where Schmidt's sines lose digits.
#[test]
fn stretching_is_exact_at_the_poles() {
    for factor in [0.0625, 0.3, 1.0, 2.5, 16.0] {
        let stretched = Stretched::new(Tangential, factor).unwrap();
        for (face, sign) in [(Face::Top, 1.0), (Face::Bottom, -1.0)] {
            for tiny in [0.0, 1e-300, 1e-20, 1e-9, 1e-3_f64] {
                let point = FacePoint::new(face, tiny, 0.0).unwrap();
                let from_pole = stretched.unproject(point).y();
                let ratio: f64 = if sign > 0.0 { 1.0 / factor } else { factor };
                let expected = 2.0 * (ratio * (0.5 * tiny.atan()).tan()).atan();
                let expected = expected.sin();
                assert!(
                    (from_pole - expected).abs() <= 1e-15 * expected,
                    "{factor} {face} {tiny}: {from_pole} {expected}"
                );
                let back = stretched.project(stretched.unproject(point));
                assert_eq!(back.face(), face);
                assert!((back.x() - tiny).abs() <= 2e-15 * tiny, "{factor} {face} {tiny}");
            }
        }
    }
}

#[test]
fn a_turn_by_quarters_and_a_stretch_by_one_keep_their_place() {
    let mut rng = Rng::with_seed(3);
    for &projection in Projection::ALL {
        for quarters in 0..4 {
            let turned = Turned::new(projection, Rotation::about_axis(90.0 * f64::from(quarters)).unwrap());
            let same = Turned::new(
                Stretched::new(projection, 1.0).unwrap(),
                Rotation::about_axis(90.0 * f64::from(quarters)).unwrap(),
            );
            for _ in 0..50 {
                let point = random_point::<f64>(&mut rng);
                let mut expected = projection.unproject(point).to_array();
                for _ in 0..quarters {
                    let [x, y, z] = expected;
                    expected = [-y, x, z];
                }
                assert_eq!(turned.unproject(point).to_array(), expected, "{projection}");
                assert!(
                    apart(same.unproject(point).to_array(), expected) < 4e-16,
                    "{projection}"
                );
            }
        }
    }
}

#[test]
fn a_face_comes_to_its_place() {
    let mut rng = Rng::with_seed(4);
    let own = [
        [0.0, 0.0],
        [0.0, 90.0],
        [0.0, 180.0],
        [0.0, -90.0],
        [90.0, 0.0],
        [-90.0, 0.0],
    ];
    for (face, [lat, lon]) in Face::ALL.into_iter().zip(own) {
        let there = LatLon::new(lat, lon).unwrap().to_direction();
        let unmoved = Rotation::facing(face, there, 0.0).unwrap().matrix();
        assert_eq!(unmoved, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], "{face}");
        for _ in 0..1000 {
            let heading = 360.0 * rng.f64();
            let place = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64()).unwrap();
            let rotation = Rotation::facing(face, place.to_direction(), heading).unwrap();
            let matrix = rotation.matrix();
            let at_place = |local| product(matrix, face.to_earth(local));
            assert!(apart(at_place([0.0, 0.0, 1.0]), place.to_direction().to_array()) < 4e-16);
            // A step upward on the face, by longitude and latitude.
            let [sin, cos] = [heading.to_radians().sin(), heading.to_radians().cos()];
            let ([a, b], [c, d]) = (
                [place.lat().to_radians().sin(), place.lat().to_radians().cos()],
                [place.lon().to_radians().sin(), place.lon().to_radians().cos()],
            );
            let upward = [-a * d * cos - c * sin, -a * c * cos + d * sin, b * cos];
            assert!(apart(at_place([0.0, 1.0, 0.0]), upward) < 1e-15);
        }
    }
}

#[test]
fn a_matrix_is_improved_or_refused() {
    let mut rng = Rng::with_seed(5);
    for _ in 0..1000 {
        let rough = random_matrix(&mut rng).map(|row| row.map(|v| v + 2e-10 * (2.0 * rng.f64() - 1.0)));
        let matrix = Rotation::new(rough).unwrap().matrix();
        let moved = Worst::of((0..9).map(|k| (matrix[k / 3][k % 3] - rough[k / 3][k % 3]).abs()));
        assert!(moved < 1e-9);
        for (i, a) in matrix.into_iter().enumerate() {
            for (j, b) in matrix.into_iter().enumerate() {
                let dot: f64 = (0..3).map(|k| a[k] * b[k]).sum();
                assert!((dot - if i == j { 1.0 } else { 0.0 }).abs() < 6e-16);
            }
        }
    }
    let refused = |matrix| Rotation::new(matrix).unwrap_err().departure;
    assert_eq!(refused([[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), 3.0);
    assert_eq!(refused([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]]), 2.0);
    assert_eq!(refused([[1.0, 0.25, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), 0.25);
    assert_eq!(refused([[1.0, 0.0, 0.5], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), 0.5);
    assert_eq!(refused([[0.0; 3]; 3]), 1.0);
    assert!(refused([[f64::NAN; 3]; 3]).is_nan());
    for place in 0..9 {
        let mut matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        matrix[place / 3][place % 3] = f64::INFINITY;
        assert!(!refused(matrix).is_finite());
        matrix[place / 3][place % 3] = f64::NAN;
        assert!(refused(matrix).is_nan());
    }
    for wrong in [f64::NAN, f64::INFINITY, 1e10] {
        assert!(Rotation::about_axis(wrong).unwrap_err().departure.is_nan());
        let pole = Direction::new(0.0, 0.0, 1.0).unwrap();
        assert!(
            Rotation::facing(Face::Left, pole, wrong)
                .unwrap_err()
                .departure
                .is_nan()
        );
    }
    let said = InvalidRotation { departure: 2.0 }.to_string();
    assert_eq!(said, "expected a rotation, got a matrix that departs from one by 2.0");
}

#[test]
fn what_is_no_factor_is_refused() {
    for factor in [0.0, 0.0624, 16.1, -2.0, f64::INFINITY] {
        assert_eq!(Stretched::new(Tangential, factor), Err(InvalidStretch(factor)));
    }
    assert!(Stretched::new(Tangential, f64::NAN).unwrap_err().0.is_nan());
    assert_eq!(
        InvalidStretch(17.0).to_string(),
        "expected a factor in [1/16, 16], got 17.0"
    );
}

/// Unprojects by way of the projection's own type.
struct Unproject(FacePoint<f64>);

impl ProjectionTask for Unproject {
    type Output = Direction<f64>;
    fn run<P: CubeProjection>(self, projection: P) -> Direction<f64> {
        assert!(size_of::<P>() < size_of::<Turned<Stretched<Turned<Projection>>>>());
        projection.unproject(self.0)
    }
}

/// Both parts may be inside the other; a task runs with the type of the projection inside.
#[test]
fn they_nest() {
    let mut rng = Rng::with_seed(6);
    let [first, second] = [0; 2].map(|_| random_matrix(&mut rng));
    let rotation = |matrix| Rotation::new(matrix).unwrap();
    let both = Turned::new(
        Stretched::new(Turned::new(Projection::Vertex, rotation(first)), 3.0).unwrap(),
        rotation(second),
    );
    assert_eq!(both.rotation(), rotation(second));
    assert_eq!(both.projection().projection().projection(), Projection::Vertex);
    for _ in 0..1000 {
        let point = random_point::<f64>(&mut rng);
        let inner = product(first, Projection::Vertex.unproject(point).to_array());
        let expected = product(second, schmidt(3.0, inner));
        assert!(apart(expected, both.unproject(point).to_array()) < 1e-14);
        assert_eq!(both.with(Unproject(point)), both.unproject(point));
        let back = both.project(both.unproject(point));
        assert_eq!(back.face(), point.face());
        assert!((back.x() - point.x()).abs() + (back.y() - point.y()).abs() < 1e-13);
    }
}

/// A pole in the middle of an edge, or in a corner: it is the pole from each face, whatever its longitude.
#[test]
fn a_pole_may_lie_on_an_edge() {
    // Where the centre of the front face is put.
    let (edge, corner) = ([45.0, 0.0, 0.0], [35.264_389_682_754_654, 45.0, -45.0]);
    for ([lat, lon, heading], in_corner) in [(edge, false), (corner, true)] {
        let front = LatLon::new(lat, lon).unwrap().to_direction();
        let away = Rotation::facing(Face::Front, front, heading).unwrap();
        for &projection in Projection::ALL {
            if projection == Projection::Healpix {
                continue; // its faces meet elsewhere
            }
            let map = CubeMap::new(
                Ellipsoid::<f64>::WGS84,
                Shift::Geocentric,
                Turned::new(projection, away),
            )
            .unwrap();
            let point = map.project(LatLon::new(90.0, 0.0).unwrap());
            for lon in [-180.0, -0.0, 12.5, 180.0] {
                let other = map.project(LatLon::new(90.0, lon).unwrap());
                assert_eq!((other, map.unproject(other).lat()), (point, map.unproject(point).lat()));
            }
            let on_edge = |v: f64| (v.abs() - 1.0).abs() < 1e-3;
            assert!(on_edge(point.x()) || on_edge(point.y()), "{projection} {point}");
            assert!(
                !in_corner || (on_edge(point.x()) && on_edge(point.y())),
                "{projection} {point}"
            );
            assert!(map.unproject(point).lat() > 90.0 - 1e-5, "{projection} {point}");
        }
    }
}

/// A zero's sign never matters, but for the choice between 180 and −180.
#[test]
fn zeros_of_both_signs_are_one() {
    let mut rng = Rng::with_seed(7);
    for degrees in [0.0, 10.0, 90.0, 180.0, -45.0] {
        let about = Rotation::about_axis(degrees).unwrap();
        let any = Rotation::new(random_matrix(&mut rng)).unwrap();
        for rotation in [about, any] {
            let turned = Turned::new(Projection::Balanced, rotation);
            for [x, y, z] in [
                [0.0, 0.6, 0.8],
                [0.0, 0.0, 1.0],
                [1.0, 0.0, 0.0],
                [0.0, 0.0, -1.0],
                [-1.0, 0.0, 0.0],
            ] {
                let point = turned.project(Direction::new(x, y, z).unwrap());
                let negated = [x, y, z].map(|v: f64| if v == 0.0 { -v } else { v });
                let [x, y, z] = negated;
                assert_eq!(point, turned.project(Direction::new(x, y, z).unwrap()));
            }
        }
    }
}

/// PROJ 9.5.1, `+proj=rhealpix +ellps=WGS84 +lon_0=…`: `lon_0`, latitude and longitude, easting and northing in metres.
const RHEALPIX: [(f64, [f64; 2], [f64; 2]); 22] = [
    (0.0, [0.0, 0.0], [0.000_000, 0.000_000]),
    (0.0, [30.0, 10.0], [1_111_950.519_752, 3_740_232.893_366]),
    (0.0, [-20.0, 170.0], [18_903_158.835_789, -2_556_949.434_603]),
    (0.0, [41.0, -100.0], [-11_119_505.197_523, 4_911_590.422_803]),
    (0.0, [41.5, -100.0], [-11_119_505.197_523, 4_960_901.721_851]),
    (0.0, [60.0, 20.0], [-13_242_578.473_728, 13_191_311.055_041]),
    (0.0, [80.0, 100.0], [-16_084_257.783_307, 10_842_052.496_277]),
    (0.0, [-75.0, -30.0], [-13_404_697.863_163, -10_543_099.395_602]),
    (0.0, [-50.0, -160.0], [-17_347_298.425_326, -5_802_815.142_164]),
    (0.0, [89.0, 45.0], [-15_011_332.016_656, 10_114_993.024_717]),
    (0.0, [12.5, -131.0], [-14_566_551.808_755, 1_617_600.194_133]),
    (-131.25, [0.0, 0.0], [14_594_350.571_749, 0.000_000]),
    (-131.25, [30.0, 10.0], [15_706_301.091_501, 3_740_232.893_366]),
    (-131.25, [-20.0, 170.0], [-6_532_709.303_545, -2_556_949.434_603]),
    (-131.25, [41.0, -100.0], [3_474_845.374_226, 4_911_590.422_803]),
    (-131.25, [41.5, -100.0], [3_474_845.374_226, 4_960_901.721_851]),
    (-131.25, [60.0, 20.0], [-18_195_088.393_927, 8_857_864.874_867]),
    (-131.25, [80.0, 100.0], [-14_862_314.549_066, 8_934_628.911_119]),
    (-131.25, [-75.0, -30.0], [-16_617_966.170_149, -11_212_530.292_891]),
    (-131.25, [-50.0, -160.0], [-10_806_592.481_049, -11_525_932.843_406]),
    (-131.25, [89.0, 45.0], [-15_118_770.363_603, 9_909_069.526_403]),
    (-131.25, [12.5, -131.0], [27_798.762_994, 1_617_600.194_133]),
];

/// A point on PROJ's sheet, in halves of a face: the side faces in a row from `lon_0` − 180°, the polar ones above and below the first
/// of them, and turned by half.
fn on_sheet(point: FacePoint<f64>) -> [f64; 2] {
    let (x, y) = (point.x(), point.y());
    match point.face() {
        Face::Back => [x - 3.0, y],
        Face::Left => [x - 1.0, y],
        Face::Front => [x + 1.0, y],
        Face::Right => [x + 3.0, y],
        Face::Top => [-3.0 - x, 2.0 - y],
        Face::Bottom => [-3.0 - x, -2.0 - y],
    }
}

#[test]
fn rhealpix_is_healpix_turned() {
    for (lon_0, [lat, lon], [easting, northing]) in RHEALPIX {
        let rotation = Rotation::about_axis(lon_0 + 45.0).unwrap();
        let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Turned::new(Healpix, rotation)).unwrap();
        let point = map.project(LatLon::new(lat, lon).unwrap());
        // The authalic radius times π/4: half a face.
        let half = 6_371_007.180_918_474 * core::f64::consts::FRAC_PI_4;
        let [x, y] = on_sheet(point);
        assert!(
            (x * half - easting).abs() < 1e-6 && (y * half - northing).abs() < 1e-6,
            "{lat} {lon}: {point} at {} {}",
            x * half,
            y * half
        );
    }
}
