//! Over slices: the same bits as one by one, for every length and for special values, and all of them where some are refused.

use core::convert::Infallible;
use terrella::batch::{
    self, InvalidBatch, area::InvalidRing, cube::InvalidPoint, ellipsoid::InvalidGeodetic, geodesic::InvalidProblem,
    terrain::InvalidTiled,
};
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, InvalidFace, InvalidFacePoint, Projection, QuadCube};
use terrella::frame::{GeodeticOffset, InvalidEnu};
use terrella::geodesic::{
    Area, Direct, Geodesic, GeodesicError, GreatCircle, Inverse, Karney, Method, PlanarArea, Vincenty, Visitor,
};
use terrella::latitude::{Conversion, InvalidLatitude};
use terrella::scene::{AnyArea, Scene, View};
use terrella::terrain::{Curve, Hilbert, InvalidKey, InvalidNumberedTile, InvalidTile, Key, Morton, Tile};
use terrella::{
    Aer, Direction, Ecef, Ellipsoid, Enu, Geodetic, InvalidDirection, InvalidEcef, InvalidHeight, InvalidLatLon,
    LatLon, Latitude, LocalFrame, Ned, Real, Shift, Shifted,
};

/// Lengths about the ends of vectors, blocks and buffers; few under Miri, which takes a thousand times as long.
const LENGTHS: &[usize] = if cfg!(miri) {
    &[0, 1, 65]
} else {
    &[0, 1, 2, 3, 7, 8, 9, 31, 63, 64, 65, 127, 128, 129, 255, 256, 257, 600]
};
/// More than any length.
const ALL: usize = if cfg!(miri) { 70 } else { 700 };

trait Scalar: Real + Into<f64> {}
impl<T: Real + Into<f64>> Scalar for T {}

/// The bits, through `f64`, in which an `f32` is exact; every NaN is the same.
fn bits<T: Scalar>(values: &[T]) -> Vec<u64> {
    let bits = |value: f64| if value.is_nan() { f64::NAN } else { value }.to_bits();
    values.iter().map(|&value| bits(value.into())).collect()
}

/// A special value here and there, a random number in [−1, 1) elsewhere.
fn numbers<T: Scalar>(seed: u64, special: &[f64]) -> Vec<T> {
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut number = || {
        if rng.u8(0..4) == 0 && !special.is_empty() {
            special[rng.usize(0..special.len())]
        } else {
            2.0 * rng.f64() - 1.0
        }
    };
    (0..ALL).map(|_| T::of(number())).collect()
}

fn scaled<T: Scalar>(values: &[T], factor: f64) -> Vec<T> {
    values.iter().map(|&value| value * T::of(factor)).collect()
}

const ENDS: &[f64] = &[0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 1e-7, -1e-7, 1e-300, 0.999_999_9];

/// The parts of columns that are tried: from an offset, of a length.
fn parts() -> impl Iterator<Item = core::ops::Range<usize>> {
    LENGTHS.iter().enumerate().map(|(i, &length)| i..i + length)
}

/// Runs a batch on parts of the columns and compares it with what one by one gives.
fn compare<T: Scalar, const I: usize, const O: usize>(
    what: &str,
    columns: &[Vec<T>; I],
    one: &dyn Fn([T; I]) -> [T; O],
    batch: &dyn Fn([&[T]; I], [&mut [T]; O]),
) {
    let mut expected: [Vec<T>; O] = [const { Vec::new() }; O];
    for i in 0..ALL {
        for (column, value) in expected.iter_mut().zip(one(columns.each_ref().map(|column| column[i]))) {
            column.push(value);
        }
    }
    for part in parts() {
        let mut found = [(); O].map(|()| vec![T::of(f64::NAN); part.len()]);
        batch(
            columns.each_ref().map(|column| &column[part.clone()]),
            found.each_mut().map(|column| &mut column[..]),
        );
        for (expected, found) in expected.iter().zip(&found) {
            assert_eq!(bits(found), bits(&expected[part.clone()]), "{what}, {part:?}");
        }
    }
}

fn number<T: Real>(face: Face) -> T {
    T::of(f64::from(face.index()))
}

/// Unit vectors, with special components.
fn directions<T: Scalar>() -> [Vec<T>; 3] {
    let [x, y, z] = [1, 2, 3].map(|seed| numbers::<T>(seed, ENDS));
    let mut units = [const { Vec::new() }; 3];
    for i in 0..ALL {
        let direction = Direction::new(x[i], y[i], z[i]).unwrap_or(Direction::new(T::ZERO, T::ZERO, -T::ONE).unwrap());
        // Twice, so that even the constructor takes it as it is.
        let [x, y, z] = direction.to_array();
        let direction = Direction::new(x, y, z).unwrap().to_array();
        for (column, value) in units.iter_mut().zip(direction) {
            column.push(value);
        }
    }
    units
}

fn places<T: Scalar>() -> [Vec<T>; 2] {
    [scaled(&numbers(4, ENDS), 90.0), scaled(&numbers(5, ENDS), 180.0)]
}

fn points<T: Scalar>() -> [Vec<T>; 3] {
    let mut rng = fastrand::Rng::with_seed(6);
    let faces = (0..ALL).map(|_| number(Face::ALL[rng.usize(0..6)])).collect();
    [faces, numbers(7, ENDS), numbers(8, ENDS)]
}

fn faces<T: Scalar>(numbers: &[T]) -> Vec<Face> {
    numbers
        .iter()
        .map(|&number| Face::from_index(number.into() as u8).unwrap())
        .collect()
}

fn store<T: Scalar>(faces: &[Face], column: &mut [T]) {
    for (slot, &face) in column.iter_mut().zip(faces) {
        *slot = number(face);
    }
}

/// A projection, in both directions and on the ellipsoid.
fn projection<T: Scalar, P: CubeProjection>(name: &str, p: P) {
    compare(
        &format!("{name} project"),
        &directions::<T>(),
        &|[x, y, z]| {
            let point = p.project(Direction::new(x, y, z).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::cube::project(p, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    compare(
        &format!("{name} unproject"),
        &points::<T>(),
        &|[face, x, y]| p.unproject(FacePoint::new(faces(&[face])[0], x, y).unwrap()).to_array(),
        &|[face, x, y], to| batch::cube::unproject(p, &faces(face), [x, y], to).unwrap(),
    );
}

fn map<T: Scalar, P: CubeProjection>(name: &str, p: P, shift: Shift) {
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, shift, p).unwrap();
    compare(
        &format!("{name} map, {shift}"),
        &places::<T>(),
        &|[lat, lon]| {
            let point = map.project(LatLon::new(lat, lon).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::map::project(&map, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    compare(
        &format!("{name} map back, {shift}"),
        &points::<T>(),
        &|[face, x, y]| {
            let place = map.unproject(FacePoint::new(faces(&[face])[0], x, y).unwrap());
            [place.lat(), place.lon()]
        },
        &|[face, x, y], to| batch::map::unproject(&map, &faces(face), [x, y], to).unwrap(),
    );
}

/// A projection that the crate does not know, from its documentation.
#[derive(Clone, Copy)]
struct Gnomonic;

impl CubeProjection for Gnomonic {
    fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        [right / outward, up / outward]
    }
    fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
        let length = (x * x + y * y + T::ONE).sqrt();
        [x / length, y / length, T::ONE / length]
    }
}

fn every_projection<T: Scalar>() {
    for &p in Projection::ALL {
        projection::<T, _>(p.name(), p);
    }
    projection::<T, _>("gnomonic", Gnomonic);
    projection::<T, _>("quad cube", QuadCube::COBE);
    for &shift in Shift::ALL {
        map::<T, _>("vertex", Projection::Vertex, shift);
    }
    map::<T, _>("gnomonic", Gnomonic, Shift::Authalic);
}

#[test]
fn projections_are_the_same_bits() {
    every_projection::<f64>();
    every_projection::<f32>();
}

/// Pairs of places as latitude, longitude, latitude, longitude: anywhere, nearly coincident, nearly antipodal, on meridians and parallels.
fn pairs<T: Scalar>() -> [Vec<T>; 4] {
    let mut rng = fastrand::Rng::with_seed(31);
    let [lat, lon] = places::<T>();
    let tiny = |rng: &mut fastrand::Rng| T::of(10f64.powf(-12.0 * rng.f64()) * (2.0 * rng.f64() - 1.0));
    let mut other = [const { Vec::new() }; 2];
    for i in 0..ALL {
        let j = rng.usize(0..ALL);
        let (to_lat, to_lon) = match rng.u8(0..6) {
            0 => (lat[i] + tiny(&mut rng), lon[i] + tiny(&mut rng)),
            1 => (-lat[i] + tiny(&mut rng), lon[i] + T::of(180.0) + tiny(&mut rng)),
            2 => (lat[i], lon[i]),
            3 => (lat[j], lon[i]),
            _ => (lat[j], lon[j]),
        };
        let to_lat = if to_lat.abs() > T::of(90.0) { lat[i] } else { to_lat };
        other[0].push(to_lat);
        other[1].push(to_lon);
    }
    let [lat2, lon2] = other;
    [lat, lon, lat2, lon2]
}

fn every_geodesic<T: Scalar, M: Geodesic<T>>(method: &M) {
    let nothing = [T::of(f64::NAN); 3];
    compare(
        "inverse",
        &pairs::<T>(),
        &|[lat1, lon1, lat2, lon2]| match method
            .inverse(LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap())
        {
            Ok(line) => [line.distance, line.azimuth1, line.azimuth2],
            Err(_) => nothing,
        },
        &|[lat1, lon1, lat2, lon2], lines| {
            let places = |i: usize| {
                let here = LatLon::new(lat1[i], lon1[i]).unwrap();
                (here, LatLon::new(lat2[i], lon2[i]).unwrap())
            };
            let refused = (0..lat1.len()).filter_map(|index| {
                let (from, to) = places(index);
                let why = method.inverse(from, to).err()?;
                Some((index, InvalidProblem::Geodesic(why)))
            });
            let refused: Vec<_> = refused.collect();
            let result = batch::geodesic::inverse(method, [lat1, lon1], [lat2, lon2], lines);
            let count = refused.len();
            let first = refused.into_iter().next();
            let expected = first.map_or(Ok(()), |(first, why)| Err(InvalidBatch::Elements { count, first, why }));
            assert_eq!(result, expected);
        },
    );
    let [lat, lon, azimuth, distance] = pairs::<T>();
    // The slow door too: azimuths beyond 360° and lines of many circuits.
    for (turns, length) in [(1.0, 2e5), (3.0, 1.5e6)] {
        compare(
            "direct",
            &[
                lat.clone(),
                lon.clone(),
                scaled(&azimuth, turns * 2.0),
                scaled(&distance, length),
            ],
            &|[lat, lon, azimuth, distance]| {
                let end = method
                    .direct(LatLon::new(lat, lon).unwrap(), azimuth, distance)
                    .unwrap();
                [end.position.lat(), end.position.lon(), end.azimuth]
            },
            &|[lat, lon, azimuth, distance], ends| {
                batch::geodesic::direct(method, [lat, lon], azimuth, distance, ends).unwrap();
            },
        );
    }
}

/// Distances alone, of one place, and of the legs of a path; a bad place among them.
fn every_distance<T: Scalar, M: Geodesic<T>>(method: &M) {
    let [lat1, lon1, lat2, lon2] = pairs::<T>();
    let one = LatLon::new(lat1[3], lon1[3]).unwrap();
    let distance = |from: [T; 2], to: [T; 2]| {
        let places = LatLon::new(from[0], from[1]).ok().zip(LatLon::new(to[0], to[1]).ok());
        let line = places.and_then(|(from, to)| {
            let line = method.inverse(from, to);
            assert_eq!(method.distance(from, to), line.map(|line| line.distance));
            line.ok()
        });
        line.map_or([T::of(f64::NAN); 3], |line| {
            [line.distance, line.azimuth1, line.azimuth2]
        })
    };
    for length in [0, 1, 2, 5, 64, 131] {
        let (mut lat1, lon1) = (lat1[..length].to_vec(), &lon1[..length]);
        let (lat2, lon2) = (&lat2[..length], &lon2[..length]);
        if let Some(bad) = lat1.get_mut(length / 2 + 1) {
            *bad = T::of(f64::NAN);
        }
        let many = [&lat1[..], lon1];
        let nothing = vec![T::of(7.0); length];
        let (here, there) = (|i: usize| [lat1[i], lon1[i]], |i: usize| [lat2[i], lon2[i]]);
        let alone = [one.lat(), one.lon()];
        let check = |what: &str, found: &[T], expected: &dyn Fn(usize) -> T| {
            let expected: Vec<T> = (0..found.len()).map(expected).collect();
            assert_eq!(bits(found), bits(&expected), "{what}, {length}");
        };
        let mut found = nothing.clone();
        let _ = batch::geodesic::distance(method, many, [lat2, lon2], &mut found);
        check("distance", &found, &|i| distance(here(i), there(i))[0]);
        let mut found = nothing.clone();
        let _ = batch::geodesic::distance_from(method, one, many, &mut found);
        check("distance_from", &found, &|i| distance(alone, here(i))[0]);
        let mut found = nothing.clone();
        let _ = batch::geodesic::distance_to(method, many, one, &mut found);
        check("distance_to", &found, &|i| distance(here(i), alone)[0]);
        let mut lines = [nothing.clone(), nothing.clone(), nothing.clone()];
        let _ = batch::geodesic::inverse_from(method, one, many, lines.each_mut().map(|c| &mut c[..]));
        for (column, found) in lines.iter().enumerate() {
            check("inverse_from", found, &|i| distance(alone, here(i))[column]);
        }
        let _ = batch::geodesic::inverse_to(method, many, one, lines.each_mut().map(|c| &mut c[..]));
        for (column, found) in lines.iter().enumerate() {
            check("inverse_to", found, &|i| distance(here(i), alone)[column]);
        }
        let mut found = nothing[length.min(1)..].to_vec();
        let _ = batch::geodesic::legs(method, many, &mut found);
        check("legs", &found, &|i| distance(here(i), here(i + 1))[0]);
    }
    let (column, mut found) = ([T::ZERO; 3], [T::ONE; 3]);
    let unequal = batch::geodesic::legs(method, [&column, &column], &mut found);
    assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 2, other: 3 }));
    let unequal = batch::geodesic::distance_from(method, one, [&column[1..], &column], &mut found);
    assert_eq!(unequal, Err(InvalidBatch::Lengths { first: 2, other: 3 }));
    assert_eq!(bits(&found), bits(&[T::ONE; 3]));
}

/// Places on one meridian, at a pole, on the equator, and the same place twice, also across 180°.
#[test]
fn special_lines_are_the_same_bits() {
    fn by<T: Scalar>() {
        let (lat, other) = (
            scaled(&numbers::<T>(51, ENDS), 90.0),
            scaled(&numbers::<T>(53, ENDS), 90.0),
        );
        let ends = &[1.0, -1.0, 0.0, -0.0];
        let (lon, far) = (
            scaled(&numbers::<T>(52, ends), 180.0),
            scaled(&numbers::<T>(54, ends), 180.0),
        );
        let turned: Vec<T> = lon.iter().map(|&lon| lon + T::of(360.0)).collect();
        let (pole, equator) = (vec![T::of(90.0); ALL], vec![T::ZERO; ALL]);
        let earth = Karney::new(Ellipsoid::<T>::WGS84).unwrap();
        for columns in [
            [&lat, &lon, &lat, &lon],
            [&lat, &lon, &lat, &turned],
            [&lat, &lon, &other, &lon],
            [&lat, &lon, &pole, &far],
            [&pole, &lon, &pole, &lon],
            [&equator, &lon, &equator, &far],
        ] {
            compare(
                "special",
                &columns.map(Vec::clone),
                &|[lat1, lon1, lat2, lon2]| {
                    let (from, to) = (LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap());
                    let line = earth.inverse(from, to).unwrap();
                    [line.distance, line.azimuth1, line.azimuth2]
                },
                &|[lat1, lon1, lat2, lon2], lines| {
                    batch::geodesic::inverse(&earth, [lat1, lon1], [lat2, lon2], lines).unwrap();
                },
            );
        }
    }
    by::<f64>();
    by::<f32>();
}

#[test]
fn geodesics_are_the_same_bits() {
    fn both<T: Scalar>(f: f64) {
        let ellipsoid = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
        every_geodesic(&Karney::new(ellipsoid).unwrap());
        if let Ok(vincenty) = Vincenty::new(ellipsoid) {
            every_geodesic(&vincenty);
        }
    }
    for f in [1.0 / 298.257, 0.0, 1.0 / 293.0, 1.0 / 170.0, -1.0 / 150.0, 0.015, 0.1] {
        both::<f64>(f);
        both::<f32>(f);
    }
}

/// [`every_geodesic`], by a method's own type.
struct Every;

impl<T: Scalar> Visitor<T> for Every {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        every_geodesic(&method);
        every_distance(&method);
    }
}

#[test]
fn all_methods_are_the_same_bits() {
    fn both<T: Scalar>() {
        let earth = Ellipsoid::new(T::of(6.4e6), T::of(1.0 / 298.257)).unwrap();
        for method in Method::ALL {
            let place = LatLon::new(T::of(47.0), T::of(8.0)).unwrap();
            let method = method.about(earth, place).unwrap();
            method.visit(Every);
            every_distance(&method);
        }
    }
    both::<f64>();
    both::<f32>();
}

/// A user's method: a sphere whose places in the west it refuses, and whose lines have a longest one.
struct East(GreatCircle<f64>);

impl Geodesic<f64> for East {
    fn inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> Result<Inverse<f64>, GeodesicError<f64>> {
        if from.lon() < 0.0 || to.lon() < 0.0 {
            return Err(GeodesicError::NotConverged(from, to));
        }
        self.0.inverse(from, to)
    }

    fn direct(&self, from: LatLon<f64>, azimuth: f64, distance: f64) -> Result<Direct<f64>, GeodesicError<f64>> {
        let limit = 2e9;
        if distance.abs() > limit {
            return Err(GeodesicError::TooFar { distance, limit });
        }
        self.0.direct(from, azimuth, distance)
    }
}

/// The same with a fast answer for some places alone.
struct Fast(East);

impl Geodesic<f64> for Fast {
    fn inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> Result<Inverse<f64>, GeodesicError<f64>> {
        self.0.inverse(from, to)
    }

    fn direct(&self, from: LatLon<f64>, azimuth: f64, distance: f64) -> Result<Direct<f64>, GeodesicError<f64>> {
        self.0.direct(from, azimuth, distance)
    }

    fn fast_inverse(&self, from: LatLon<f64>, to: LatLon<f64>) -> (Inverse<f64>, bool) {
        let nothing = Inverse {
            distance: f64::NAN,
            azimuth1: f64::NAN,
            azimuth2: f64::NAN,
        };
        let (line, found) = self.0.fast_inverse(from, to);
        let found = found & (from.lat() > 0.0);
        (if found { line } else { nothing }, found)
    }
}

#[test]
fn a_users_method_goes_through() {
    fn by(method: &impl Geodesic<f64>) {
        every_geodesic(method);
        every_distance(method);
        let too_far = GeodesicError::TooFar {
            distance: -3e9,
            limit: 2e9,
        };
        let mut ends = [[7.0; 3]; 3];
        let [a, b, c] = &mut ends;
        let refused = batch::geodesic::direct(method, [&[0.0; 3], &[0.0; 3]], &[1.0; 3], &[1e7, -3e9, 4e9], [a, b, c]);
        let (count, first, why) = (2, 1, InvalidProblem::Geodesic(too_far));
        assert_eq!(refused, Err(InvalidBatch::Elements { count, first, why }));
        assert_eq!(ends.map(|column| column.map(f64::is_nan)), [[false, true, true]; 3]);
    }
    let sphere = GreatCircle::new(6.4e6).unwrap();
    by(&East(sphere));
    by(&Fast(East(sphere)));
}

#[test]
fn geodesics_that_are_refused() {
    let earth = Karney::new(Ellipsoid::WGS84).unwrap();
    let refused = |lat, azimuth, distance| {
        let mut ends = [[7.0_f64]; 3];
        let [a, b, c] = &mut ends;
        let why = batch::geodesic::direct(&earth, [&[lat], &[0.0]], &[azimuth], &[distance], [a, b, c]).unwrap_err();
        assert!(ends.as_flattened().iter().all(|end| end.is_nan()));
        why
    };
    let element = |why| InvalidBatch::Elements {
        count: 1,
        first: 0,
        why,
    };
    assert_eq!(
        refused(91.0, 0.0, 0.0),
        element(InvalidProblem::LatLon(InvalidLatLon::Latitude(91.0)))
    );
    assert_eq!(
        refused(0.0, f64::INFINITY, 0.0),
        element(InvalidProblem::Geodesic(GeodesicError::Azimuth(f64::INFINITY)))
    );
    assert_eq!(
        refused(0.0, 0.0, 1e15),
        element(InvalidProblem::Geodesic(
            earth.direct(LatLon::new(0.0, 0.0).unwrap(), 0.0, 1e15).unwrap_err()
        ))
    );
    let mut lines = [[0.0; 2], [0.0; 2], [0.0; 2]];
    let [a, b, c] = &mut lines;
    let why = batch::geodesic::inverse(&earth, [&[0.0, 0.0], &[0.0, 0.0]], [&[0.0], &[0.0]], [a, b, c]).unwrap_err();
    assert_eq!(why, InvalidBatch::Lengths { first: 2, other: 1 });
}

fn every_position<T: Scalar>() {
    compare(
        "to_direction",
        &places::<T>(),
        &|[lat, lon]| LatLon::new(lat, lon).unwrap().to_direction().to_array(),
        &|from, to| batch::position::to_direction(from, to).unwrap(),
    );
    compare(
        "to_lat_lon",
        &directions::<T>(),
        &|[x, y, z]| {
            let place = Direction::new(x, y, z).unwrap().to_lat_lon();
            [place.lat(), place.lon()]
        },
        &|from, to| batch::position::to_lat_lon(from, to).unwrap(),
    );
    for (ellipsoid, &shift) in [Ellipsoid::WGS84, Ellipsoid::new(T::of(6e6), T::of(0.08)).unwrap()]
        .into_iter()
        .flat_map(|ellipsoid| Shift::ALL.iter().map(move |shift| (ellipsoid, shift)))
    {
        let shifted = Shifted::new(ellipsoid, shift).unwrap();
        compare(
            &format!("to_direction, {shift}"),
            &places::<T>(),
            &|[lat, lon]| shifted.to_direction(LatLon::new(lat, lon).unwrap()).to_array(),
            &|from, to| batch::latitude::to_direction(&shifted, from, to).unwrap(),
        );
        compare(
            &format!("to_lat_lon, {shift}"),
            &directions::<T>(),
            &|[x, y, z]| {
                let place = shifted.to_lat_lon(Direction::new(x, y, z).unwrap());
                [place.lat(), place.lon()]
            },
            &|from, to| batch::latitude::to_lat_lon(&shifted, from, to).unwrap(),
        );
    }
}

#[test]
fn positions_are_the_same_bits() {
    every_position::<f64>();
    every_position::<f32>();
}

fn every_latitude<T: Scalar>() {
    let [degrees, _] = places::<T>();
    let right = core::f64::consts::FRAC_PI_2;
    let radians = scaled(
        &numbers(4, ENDS),
        if T::EPSILON.into() > 1e-10 { 1.570_796_2 } else { right },
    );
    for f in [1.0 / 298.257, 0.09] {
        let ellipsoid = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
        for (&from, &to) in Latitude::ALL
            .iter()
            .flat_map(|a| Latitude::ALL.iter().map(move |b| (a, b)))
        {
            let conversion = Conversion::new(ellipsoid, from, to).unwrap();
            let isometric = scaled(&numbers(9, &[0.0, -0.0, 0.1, f64::INFINITY, f64::NEG_INFINITY]), 10.0);
            let values = if from == Latitude::Isometric {
                &isometric
            } else {
                &degrees
            };
            compare(
                &format!("{from} to {to} in degrees"),
                &[values.to_vec()],
                &|[value]| [conversion.degrees(value).unwrap()],
                &|[from], [to]| batch::latitude::degrees(&conversion, from, to).unwrap(),
            );
            let values = if from == Latitude::Isometric {
                &isometric
            } else {
                &radians
            };
            compare(
                &format!("{from} to {to} in radians"),
                &[values.to_vec()],
                &|[value]| [conversion.radians(value).unwrap()],
                &|[from], [to]| batch::latitude::radians(&conversion, from, to).unwrap(),
            );
        }
    }
}

#[test]
fn latitudes_are_the_same_bits() {
    every_latitude::<f64>();
    every_latitude::<f32>();
}

fn every_ecef<T: Scalar>() {
    let [lat, lon] = places::<T>();
    let sizes = [0.0, -0.0, 1.0, 1e-4, 3e-3, 1e-30, 1e20];
    for ellipsoid in [
        Ellipsoid::<T>::WGS84,
        Ellipsoid::MOON,
        Ellipsoid::new(T::of(6e6), T::of(-0.1)).unwrap(),
    ] {
        let heights = scaled(&numbers(10, ENDS), 1e7);
        compare(
            "to_ecef",
            &[lat.clone(), lon.clone(), heights],
            &|[lat, lon, height]| {
                let place = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
                ellipsoid.to_ecef(place).to_array()
            },
            &|from, to| batch::ellipsoid::to_ecef(ellipsoid, from, to).unwrap(),
        );
        for special in [&sizes[..], &[]] {
            compare(
                "to_geodetic",
                &[11, 12, 13].map(|seed| scaled(&numbers(seed, special), 7e6)),
                &|[x, y, z]| {
                    let place = ellipsoid.to_geodetic(Ecef::new(x, y, z).unwrap());
                    [place.lat(), place.lon(), place.height()]
                },
                &|from, to| batch::ellipsoid::to_geodetic(ellipsoid, from, to).unwrap(),
            );
        }
    }
}

#[test]
fn ecef_is_the_same_bits() {
    every_ecef::<f64>();
    every_ecef::<f32>();
}

/// All of a frame, about an origin: the conversions to and from three kinds of axes.
fn every_frame<T: Scalar>(frame: &LocalFrame<T>) {
    fn enu<T: Scalar>([east, north, up]: [T; 3]) -> Enu<T> {
        Enu { east, north, up }
    }
    fn ned<T: Scalar>([north, east, down]: [T; 3]) -> Ned<T> {
        Ned { north, east, down }
    }
    fn aer<T: Scalar>([azimuth, elevation, range]: [T; 3]) -> Aer<T> {
        Aer {
            azimuth,
            elevation,
            range,
        }
    }
    let of_enu = |Enu { east, north, up }: Enu<T>| [east, north, up];
    let of_ned = |Ned { north, east, down }: Ned<T>| [north, east, down];
    let of_aer = |Aer {
                      azimuth,
                      elevation,
                      range,
                  }: Aer<T>| [azimuth, elevation, range];
    let of_offset = |GeodeticOffset { lat, lon, height }: GeodeticOffset<T>| [lat, lon, height];
    let of_place = |place: Geodetic<T>| [place.lat(), place.lon(), place.height()];
    let nothing = [T::of(f64::NAN); 3];
    let point = |[x, y, z]: [T; 3]| Ecef::new(x, y, z).unwrap();
    let place = |[lat, lon, height]: [T; 3]| Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
    let [lat, lon] = places::<T>();
    let points = [11, 12, 13].map(|seed| scaled(&numbers(seed, ENDS), 7e6));
    let places = [lat.clone(), lon.clone(), scaled(&numbers(10, ENDS), 1e7)];
    // From the origin to the centre of the Earth and beyond, and far into space; not finite as a point.
    let far = f64::from(f32::MAX);
    let rows = |units: [f64; 3]| {
        let special = [0.0, -0.0, 1.0, -1.0, 1e3, 1e-6, 1e-20, f64::INFINITY, f64::NAN, far];
        let mut columns = units.map(|unit| scaled(&numbers(14, &special), unit));
        for (seed, column) in (15..).zip(&mut columns) {
            column.rotate_left(seed);
        }
        columns
    };
    let along = rows([1e7; 3]);
    let aers = rows([200.0, 90.0, 1e7]);
    macro_rules! compare {
        ($columns:expr, $name:ident, |$row:ident| $one:expr) => {
            compare(
                stringify!($name),
                $columns,
                &|$row| $one,
                &|from: [&[T]; 3], into| {
                    let row = |i: usize| from.each_ref().map(|column| column[i]);
                    let refused = (0..from[0].len()).filter(|&i| {
                        let $row = row(i);
                        let result: [T; 3] = $one;
                        // The open conversions keep NaN.
                        result.iter().all(|value| bits(&[*value]) == bits(&nothing[..1]))
                    });
                    let refused: Vec<_> = refused.collect();
                    match batch::frame::$name(frame, from, into) {
                        Err(InvalidBatch::Elements { count, first, .. }) => {
                            assert_eq!((count, Some(&first)), (refused.len(), refused.first()))
                        }
                        other => assert_eq!(other, Ok(())),
                    }
                },
            )
        };
    }
    compare!(&points, to_enu, |row| of_enu(frame.to_enu(point(row))));
    compare!(&points, to_ned, |row| of_ned(frame.to_ned(point(row))));
    compare!(&points, to_aer, |row| of_aer(frame.to_aer(point(row))));
    compare!(&places, geodetic_to_enu, |row| of_enu(
        frame.geodetic_to_enu(place(row))
    ));
    compare!(&places, geodetic_to_ned, |row| of_ned(
        frame.geodetic_to_ned(place(row))
    ));
    compare!(&places, geodetic_to_aer, |row| of_aer(
        frame.geodetic_to_aer(place(row))
    ));
    compare!(&along, from_enu, |row| frame
        .from_enu(enu(row))
        .map_or(nothing, Ecef::to_array));
    compare!(&along, from_ned, |row| frame
        .from_ned(ned(row))
        .map_or(nothing, Ecef::to_array));
    compare!(&aers, from_aer, |row| frame
        .from_aer(aer(row))
        .map_or(nothing, Ecef::to_array));
    compare!(&along, enu_to_geodetic, |row| frame
        .enu_to_geodetic(enu(row))
        .map_or(nothing, of_place));
    compare!(&along, ned_to_geodetic, |row| frame
        .ned_to_geodetic(ned(row))
        .map_or(nothing, of_place));
    compare!(&aers, aer_to_geodetic, |row| frame
        .aer_to_geodetic(aer(row))
        .map_or(nothing, of_place));
    compare!(&along, enu_to_offset, |row| frame
        .enu_to_offset(enu(row))
        .map_or(nothing, of_offset));
    compare!(&places, offset_to_enu, |row| {
        let [lat, lon, height] = row;
        of_enu(frame.offset_to_enu(GeodeticOffset { lat, lon, height }))
    });
    compare!(&along, vector_to_enu, |row| of_enu(frame.vector_to_enu(row)));
    compare!(&along, vector_from_enu, |row| frame.vector_from_enu(enu(row)));
}

#[test]
fn frames_are_the_same_bits() {
    fn both<T: Scalar>() {
        for [lat, lon, height] in [
            [47.0, 8.0, 400.0],
            [-90.0, 30.0, 0.0],
            [0.5, -180.0, -4e6],
            [60.0, 179.5, 1e9],
        ] {
            let place = LatLon::new(T::of(lat), T::of(lon)).unwrap();
            let origin = Geodetic::new(place, T::of(height)).unwrap();
            every_frame(&LocalFrame::new(Ellipsoid::WGS84, origin));
        }
        every_frame(&LocalFrame::new(
            Ellipsoid::new(T::of(1e6), T::of(0.3)).unwrap(),
            Geodetic::default(),
        ));
    }
    both::<f64>();
    both::<f32>();
}

/// Keys of both curves, from tiles and back, and of places.
fn every_key<T: Scalar, C: Curve>() {
    let mut rng = fastrand::Rng::with_seed(41);
    let tiles = [(); ALL].map(|()| {
        let level = rng.u8(0..=30);
        let [i, j] = [(); 2].map(|()| rng.u32(0..1 << level));
        Tile::new(Face::ALL[rng.usize(0..6)], level, i, j).unwrap()
    });
    let keys = tiles.map(|tile| Key::<C>::from(tile).bits());
    for part in parts() {
        let tiles = &tiles[part.clone()];
        let faces: Vec<Face> = tiles.iter().map(|tile| tile.face()).collect();
        let levels: Vec<u8> = tiles.iter().map(|tile| tile.level()).collect();
        let [i, j]: [Vec<u32>; 2] = [
            tiles.iter().map(|tile| tile.i()).collect(),
            tiles.iter().map(|tile| tile.j()).collect(),
        ];
        let mut found = vec![7; part.len()];
        batch::terrain::to_key::<C, _>(&faces, &levels, [&i, &j], &mut found).unwrap();
        assert_eq!(found, keys[part.clone()]);
        let (mut f, mut l, mut a, mut b) = (vec![9_u8; part.len()], levels.clone(), i.clone(), j.clone());
        l.fill(9);
        a.fill(9);
        b.fill(9);
        batch::terrain::from_key::<C, _>(&found, &mut f, &mut l, [&mut a, &mut b]).unwrap();
        assert_eq!((&l, &a, &b), (&levels, &i, &j));
        assert!(f.iter().zip(&faces).all(|(f, face)| *f == face.index()));
    }
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, Projection::S2Quadratic).unwrap();
    let ([lat, lon], [x, y, z]) = (places::<T>(), directions::<T>());
    let key = |point, level| Key::<C>::from(Tile::containing(point, level).unwrap()).bits();
    for (part, level) in parts().zip([0, 1, 12, 29, 30].into_iter().cycle()) {
        let mut found = vec![7; part.len()];
        batch::terrain::places_to_key::<C, _, _>(&map, level, [&lat[part.clone()], &lon[part.clone()]], &mut found)
            .unwrap();
        for (i, &found) in part.clone().zip(&found) {
            assert_eq!(found, key(map.project(LatLon::new(lat[i], lon[i]).unwrap()), level));
        }
        let columns = [&x[part.clone()], &y[part.clone()], &z[part.clone()]];
        batch::terrain::directions_to_key::<C, _, _>(Projection::Cobe, level, columns, &mut found).unwrap();
        for (i, found) in part.clone().zip(found) {
            let point = Projection::Cobe.project(Direction::new(x[i], y[i], z[i]).unwrap());
            assert_eq!(found, key(point, level));
        }
        let [face, x, y] = points::<T>().map(|column| column[part.clone()].to_vec());
        let (mut i, mut j) = (vec![7; part.len()], vec![7; part.len()]);
        batch::terrain::containing(level, &bytes(&face), [&x, &y], [&mut i, &mut j]).unwrap();
        for index in 0..part.len() {
            let point = FacePoint::new(faces(&face)[index], x[index], y[index]).unwrap();
            let tile = Tile::containing(point, level).unwrap();
            assert_eq!((i[index], j[index]), (tile.i(), tile.j()));
        }
    }
}

#[test]
fn keys_are_the_same_bits() {
    every_key::<f64, Hilbert>();
    every_key::<f32, Hilbert>();
    every_key::<f64, Morton>();
    every_key::<f32, Morton>();
}

#[test]
fn s2_cells_are_the_same_bits() {
    let ends = &[0.0, -0.0, 1.0, -1.0, 0.5, -0.5, 1e-300, -1e-300];
    let [x, y, z] = [1, 2, 3].map(|seed| numbers::<f64>(seed, ends));
    for part in parts() {
        let mut found = vec![7; part.len()];
        let result = batch::terrain::s2_leaf([&x[part.clone()], &y[part.clone()], &z[part.clone()]], &mut found);
        let expected = part.clone().map(|i| Key::s2_leaf_of([x[i], y[i], z[i]]));
        assert!(
            found
                .iter()
                .zip(expected.clone())
                .all(|(found, key)| *found == key.map_or(0, Key::bits))
        );
        let refused = expected.clone().filter(Result::is_err).count();
        match result {
            Ok(()) => assert_eq!(refused, 0),
            Err(InvalidBatch::Elements { count, first, why }) => {
                assert_eq!((count, Err(why)), (refused, expected.clone().nth(first).unwrap()));
            }
            other => panic!("{other:?}"),
        }
    }
}

#[test]
fn tiles_that_are_refused() {
    // 70 elements, of which some are bad: keys of nothing, tiles of no level.
    let bad = [0, 0x5000_0000_0000_0002, u64::MAX, 1 << 63, 0xd000_0000_0000_0000];
    let good = Key::<Hilbert>::from(Tile::new(Face::Top, 4, 3, 9).unwrap()).bits();
    for length in [3, 70] {
        for bits in bad {
            let mut keys = vec![good; length];
            (keys[1], keys[length - 1]) = (bits, bits);
            let (mut face, mut level) = (vec![Face::Left; length], vec![7; length]);
            let (mut i, mut j) = (vec![7; length], vec![7; length]);
            let found = batch::terrain::from_key::<Hilbert, _>(&keys, &mut face, &mut level, [&mut i, &mut j]);
            let (count, first, why) = (2, 1, InvalidKey(bits));
            assert_eq!(found, Err(InvalidBatch::Elements { count, first, why }));
            assert_eq!((face[0], level[0], i[0], j[0]), (Face::Top, 4, 3, 9));
            assert_eq!((face[1], level[1], i[1], j[1]), (Face::Front, 0, 0, 0));
        }
        let level_31 = InvalidNumberedTile::Tile(InvalidTile::Level(31));
        let column = InvalidNumberedTile::Tile(InvalidTile::Column { level: 4, i: 16 });
        let row = InvalidNumberedTile::Tile(InvalidTile::Row { level: 4, j: u32::MAX });
        let face = InvalidNumberedTile::Face(InvalidFace(6));
        for (tile, why) in [
            ((0, 31, 0, 0), level_31),
            ((0, 4, 16, 0), column),
            ((0, 4, 0, u32::MAX), row),
            ((6, 99, 0, 0), face),
        ] {
            let (mut f, mut l, mut i, mut j) = (vec![4; length], vec![4; length], vec![3; length], vec![9; length]);
            (f[1], l[1], i[1], j[1]) = tile;
            let mut keys = vec![7; length];
            let found = batch::terrain::to_key::<Hilbert, u8>(&f, &l, [&i, &j], &mut keys);
            let (count, first) = (1, 1);
            assert_eq!(found, Err(InvalidBatch::Elements { count, first, why }));
            assert_eq!((keys[0], keys[1], keys[2]), (good, 0, good));
        }
        let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Vertex).unwrap();
        let mut lat = vec![1.0; length];
        lat[1] = f64::NAN;
        let (lon, mut keys) = (vec![2.0; length], vec![7; length]);
        let found = batch::terrain::places_to_key::<Morton, _, _>(&map, 30, [&lat, &lon], &mut keys);
        assert!(matches!(
            found,
            Err(InvalidBatch::Elements {
                count: 1,
                first: 1,
                why: InvalidTiled::Place(_)
            })
        ));
        assert!(keys[1] == 0 && keys[0] == keys[2] && keys[0] != 0);
        let found = batch::terrain::places_to_key::<Morton, _, _>(&map, 31, [&lat, &lon], &mut keys);
        let (count, first, why) = (length, 0, InvalidTiled::Tile(InvalidTile::Level(31)));
        assert_eq!(found, Err(InvalidBatch::Elements { count, first, why }));
        assert!(keys.iter().all(|&key| key == 0));
        let found = batch::terrain::places_to_key::<Morton, _, _>(&map, 31, [&lat, &lon], &mut keys[1..]);
        assert_eq!(
            found,
            Err(InvalidBatch::Lengths {
                first: length,
                other: length - 1
            })
        );
        assert_eq!(
            batch::terrain::places_to_key::<Morton, f64, _>(&map, 31, [&[], &[]], &mut []),
            Ok(())
        );
    }
}

fn every_sample<T: Scalar>() {
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Conformal, Projection::Balanced).unwrap();
    for (tile, samples) in [
        (Tile::root(Face::Left), 0),
        (Tile::root(Face::Top), 1),
        (Tile::new(Face::Bottom, 3, 7, 2).unwrap(), 2),
        (Tile::new(Face::Back, 20, 1 << 19, 77).unwrap(), 17),
        (Tile::new(Face::Front, 30, 5, 1 << 29).unwrap(), 33),
    ] {
        let length = (samples * samples) as usize;
        let mut found = [(); 5].map(|()| vec![T::of(7.0); length]);
        let [lat, lon, x, y, z] = &mut found;
        batch::terrain::sample_places(&map, tile, samples, [lat, lon]).unwrap();
        batch::terrain::sample_directions(Projection::Vertex, tile, samples, [x, y, z]).unwrap();
        for index in 0..length as u32 {
            let node = tile.node([index % samples, index / samples], samples.saturating_sub(1));
            let (place, direction) = (map.unproject(node), Projection::Vertex.unproject(node));
            let [x, y, z] = direction.to_array();
            let row = found.each_ref().map(|column| column[index as usize]);
            assert_eq!(bits(&row), bits(&[place.lat(), place.lon(), x, y, z]));
        }
        let [lat, lon, ..] = &mut found;
        lat.push(T::ZERO);
        let refused = batch::terrain::sample_places(&map, tile, samples, [lat, lon]);
        assert_eq!(
            refused,
            Err(InvalidBatch::Lengths {
                first: length,
                other: length + 1
            })
        );
    }
}

#[test]
fn samples_are_the_same_bits() {
    every_sample::<f64>();
    every_sample::<f32>();
}

/// Rings of 0 to 300 corners, about places and anywhere.
fn every_ring<T: Scalar>() {
    let mut rng = fastrand::Rng::with_seed(43);
    let mut offsets = vec![0_i32];
    let mut corners = [const { Vec::<T>::new() }; 2];
    for count in [0, 1, 2, 3, 4, 15, 16, 17, 18, 64, 65, 100, 256, 257, 258, 300] {
        let middle = [89.9 * (2.0 * rng.f64() - 1.0), 360.0 * rng.f64()];
        let size = [0.01, 1.0, 30.0][rng.usize(0..3)];
        for _ in 0..count {
            let lat = (middle[0] + size * (rng.f64() - 0.5)).clamp(-90.0, 90.0);
            corners[0].push(T::of(lat));
            corners[1].push(T::of(middle[1] + size * (rng.f64() - 0.5)));
        }
        offsets.push(corners[0].len() as i32);
    }
    // One that is too long, one backwards, one that starts below 0; then a good one.
    offsets.extend([i32::MAX, 30, 10, -1, 0, 4]);
    let rings = offsets.len() - 1;
    let [lat, lon] = &mut corners;
    let bad = [0, 3, 12, 290].map(|i| offsets[12] as usize + i);
    for sabotaged in [false, true] {
        if sabotaged {
            for &index in &bad {
                lat[index] = T::of(f64::NAN);
            }
        }
        let area = Area::new(Ellipsoid::<T>::WGS84).unwrap();
        let planes = [
            PlanarArea::new(Ellipsoid::<T>::WGS84).unwrap(),
            PlanarArea::local(Ellipsoid::<T>::WGS84, LatLon::new(T::of(-3.0), T::ZERO).unwrap()).unwrap(),
        ];
        let ring = |i: usize| {
            let range = usize::try_from(offsets[i]).ok()?..usize::try_from(offsets[i + 1]).ok()?;
            let (lat, lon) = (lat.get(range.clone())?, lon.get(range)?);
            let corners = lat.iter().zip(lon).map(|(&lat, &lon)| LatLon::new(lat, lon));
            corners.collect::<Result<Vec<_>, _>>().ok()
        };
        let refused: Vec<_> = (0..rings).filter(|&i| ring(i).is_none()).collect();
        let check = |result: Result<(), InvalidBatch<InvalidRing<T>>>| match result {
            Err(InvalidBatch::Elements { count, first, why }) => {
                assert_eq!((count, first), (refused.len(), refused[0]));
                let sabotaged = matches!(why, InvalidRing::Corner { index, .. } if index == bad[0]);
                assert!(
                    sabotaged
                        || why
                            == InvalidRing::Offsets {
                                start: offsets[first] as usize,
                                end: i32::MAX as usize
                            }
                );
            }
            other => panic!("{other:?}"),
        };
        let nan = T::of(f64::NAN);
        let [mut areas, mut perimeters] = [(); 2].map(|()| vec![T::of(7.0); rings]);
        check(batch::area::polygons(
            &area,
            &offsets,
            [lat, lon],
            &mut areas,
            &mut perimeters,
        ));
        for i in 0..rings {
            let [found, length] = ring(i).map_or([nan; 2], |corners| {
                let mut polygon = area.polygon();
                corners.into_iter().for_each(|corner| polygon.add(corner));
                [polygon.area(), polygon.perimeter()]
            });
            assert_eq!(bits(&[areas[i], perimeters[i]]), bits(&[found, length]), "ring {i}");
        }
        let solvers = [
            AnyArea::Ellipsoid(area),
            AnyArea::Plane(planes[0]),
            AnyArea::Plane(planes[1]),
        ];
        for solver in solvers {
            check(batch::scene::areas(&solver, &offsets, [lat, lon], &mut areas));
            for (i, area) in areas.iter().enumerate() {
                let found = ring(i).map_or(nan, |corners| solver.area(corners));
                assert_eq!(bits(&[*area]), bits(&[found]), "ring {i}");
            }
        }
    }
    let plane = PlanarArea::new(Ellipsoid::<T>::WGS84).unwrap();
    let mut areas = vec![T::ZERO; 3];
    let refused = batch::area::fields(&plane, &[0_usize, 1, 2], [&lat[..2], &lon[..2]], &mut areas);
    assert_eq!(refused, Err(InvalidBatch::Lengths { first: 2, other: 3 }));
    let refused = batch::area::fields(&plane, &[0_usize, 1], [&lat[..2], &lon[..1]], &mut areas[..1]);
    assert_eq!(refused, Err(InvalidBatch::Lengths { first: 2, other: 1 }));
    assert_eq!(batch::area::fields::<T, u32>(&plane, &[], [&[], &[]], &mut []), Ok(()));
}

#[test]
fn rings_are_the_same_bits() {
    every_ring::<f64>();
    every_ring::<f32>();
}

fn every_answer<T: Scalar>() {
    let scene = Scene::around(Ellipsoid::WGS84, 47.0, 1e5).up_to(1e5);
    let origin = Geodetic::new(LatLon::new(T::of(47.0), T::of(8.0)).unwrap(), T::of(400.0)).unwrap();
    let [lat, lon] = places::<T>();
    let columns = [lat, lon, scaled(&numbers(10, ENDS), 1e5)];
    for view in View::ALL {
        let view = scene.positions_by::<T>(view).unwrap().about(origin);
        compare(
            "enu",
            &columns,
            &|[lat, lon, height]| {
                let place = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
                let Enu { east, north, up } = view.enu(place);
                [east, north, up]
            },
            &|from, to| batch::scene::enu(&view, from, to).unwrap(),
        );
    }
    for &method in Scene::METHODS {
        let method = scene.distances_by::<T>(method).unwrap().solver();
        let nothing = [T::of(f64::NAN); 3];
        compare(
            "inverse",
            &pairs::<T>(),
            &|[lat1, lon1, lat2, lon2]| {
                let (from, to) = (LatLon::new(lat1, lon1).unwrap(), LatLon::new(lat2, lon2).unwrap());
                let line = method.inverse(from, to);
                line.map_or(nothing, |line| [line.distance, line.azimuth1, line.azimuth2])
            },
            &|[lat1, lon1, lat2, lon2], lines| {
                let _ = batch::scene::inverse(method, [lat1, lon1], [lat2, lon2], lines);
            },
        );
        let [lat, lon, azimuth, distance] = pairs::<T>();
        compare(
            "direct",
            &[lat, lon, azimuth, scaled(&distance, 1e4)],
            &|[lat, lon, azimuth, distance]| {
                let end = method
                    .direct(LatLon::new(lat, lon).unwrap(), azimuth, distance)
                    .unwrap();
                [end.position.lat(), end.position.lon(), end.azimuth]
            },
            &|[lat, lon, azimuth, distance], ends| {
                batch::scene::direct(method, [lat, lon], azimuth, distance, ends).unwrap();
            },
        );
    }
}

#[test]
fn answers_of_scenes_are_the_same_bits() {
    every_answer::<f64>();
    every_answer::<f32>();
}

fn not_kept<T: Scalar>() {
    // Vectors of any length, and longitudes beyond the half circle, as the constructors take them.
    let size = T::of(if T::EPSILON.into() > 1e-10 { 1e15 } else { 1e150 });
    let vectors = [1, 2, 3].map(|seed| {
        let column = numbers::<T>(seed, &[2.0, -1e-12, 1.0]);
        column
            .iter()
            .map(|&v| if v > T::of(1.5) { v * size } else { v })
            .collect::<Vec<_>>()
    });
    compare(
        "vectors",
        &vectors,
        &|[x, y, z]| {
            let place = Direction::new(x, y, z).unwrap().to_lat_lon();
            [place.lat(), place.lon()]
        },
        &|from, to| batch::position::to_lat_lon(from, to).unwrap(),
    );
    compare(
        "vectors on faces",
        &vectors,
        &|[x, y, z]| {
            let point = Projection::Balanced.project(Direction::new(x, y, z).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::cube::project(Projection::Balanced, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    let [lat, lon] = places::<T>();
    let lon: Vec<T> = lon
        .iter()
        .enumerate()
        .map(|(i, &lon)| lon * T::of((i % 7) as f64))
        .collect();
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Conformal, Projection::Healpix).unwrap();
    compare(
        "longitudes",
        &[lat.clone(), lon.clone()],
        &|[lat, lon]| {
            let point = map.project(LatLon::new(lat, lon).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::map::project(&map, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    let earth = Ellipsoid::<T>::WGS84;
    compare(
        "longitudes with heights",
        &[lat.clone(), lon, lat],
        &|[lat, lon, height]| {
            let place = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
            earth.to_ecef(place).to_array()
        },
        &|from, to| batch::ellipsoid::to_ecef(earth, from, to).unwrap(),
    );
}

#[test]
fn what_the_constructors_change_is_changed() {
    not_kept::<f64>();
    not_kept::<f32>();
}

/// A batch writes all but bad elements, which are NaN and counted; with a column that is too short it writes
/// nothing.
fn refuse<T: Scalar, E: PartialEq + core::fmt::Debug, const I: usize, const O: usize>(
    good: [f64; I],
    bad: &[([f64; I], E)],
    batch: &dyn Fn([&[T]; I], [&mut [T]; O]) -> Result<(), InvalidBatch<E>>,
) {
    let mark = T::of(7.0);
    let columns = good.map(|value| vec![T::of(value); 200]);
    let lent = |columns: &[Vec<T>; I], results: &mut [Vec<T>; O]| {
        batch(
            columns.each_ref().map(|c| &c[..]),
            results.each_mut().map(|c| &mut c[..]),
        )
    };
    let mut expected = [(); O].map(|()| vec![mark; 200]);
    lent(&columns, &mut expected).unwrap();
    for (numbers, why) in bad {
        for places in [&[0][..], &[5], &[63, 64], &[7, 8, 150, 199], &[199]] {
            let mut columns = columns.clone();
            for &index in places {
                for (column, &value) in columns.iter_mut().zip(numbers) {
                    column[index] = T::of(value);
                }
            }
            let mut results = [(); O].map(|()| vec![mark; 200]);
            match lent(&columns, &mut results) {
                Err(InvalidBatch::Elements {
                    count,
                    first,
                    why: found,
                }) => {
                    assert_eq!((count, first), (places.len(), places[0]));
                    assert_eq!(format!("{found:?}"), format!("{why:?}"));
                }
                other => panic!("{other:?}"),
            }
            for index in 0..200 {
                let is_bad = places.contains(&index);
                let row = results.each_ref().map(|column| column[index].into());
                if is_bad {
                    // A column of faces has the front there.
                    assert!(row.iter().all(|v| v.is_nan() || *v == 0.0) && row.iter().any(|v| v.is_nan()));
                } else {
                    assert_eq!(row, expected.each_ref().map(|column| column[index].into()));
                }
            }
        }
    }
    for short in 0..I + O {
        let mut results = [(); O].map(|()| vec![mark; 200]);
        let length = |column: usize| if column == short { 199 } else { 200 };
        let mut outputs = results
            .iter_mut()
            .enumerate()
            .map(|(i, column)| &mut column[..length(I + i)]);
        let outputs = [(); O].map(|()| outputs.next().unwrap());
        let mut inputs = columns.iter().enumerate().map(|(i, column)| &column[..length(i)]);
        let inputs = [(); I].map(|()| inputs.next().unwrap());
        let (first, other) = if short == 0 { (199, 200) } else { (200, 199) };
        assert_eq!(batch(inputs, outputs), Err(InvalidBatch::Lengths { first, other }));
        assert!(results.iter().flatten().all(|&v| v == mark));
    }
}

fn every_refusal<T: Scalar + PartialEq>() {
    let of = |value: f64| T::of(value);
    let nan = f64::NAN;
    let infinite = f64::INFINITY;
    let vector = |[x, y, z]: [f64; 3]| {
        let why = InvalidDirection {
            x: of(x),
            y: of(y),
            z: of(z),
        };
        ([x, y, z], why)
    };
    let vectors = [[0.0, 0.0, 0.0], [nan, 1.0, 0.0], [0.0, infinite, 0.0], [0.0, 0.0, nan]].map(vector);
    let places = [
        ([nan, 0.0], InvalidLatLon::Latitude(of(nan))),
        ([90.001, 0.0], InvalidLatLon::Latitude(of(90.001))),
        ([-91.0, nan], InvalidLatLon::Latitude(of(-91.0))),
        ([1.0, nan], InvalidLatLon::Longitude(of(nan))),
        ([1.0, -infinite], InvalidLatLon::Longitude(of(-infinite))),
    ];
    let point = |[x, y]: [f64; 2]| {
        let why = InvalidPoint::Point(InvalidFacePoint { x: of(x), y: of(y) });
        ([x, y, 1.0], why)
    };
    let mut points = [[1.000_001, 0.0], [0.0, -2.0], [nan, 0.0], [0.5, nan]]
        .map(point)
        .to_vec();
    points.push(([0.0, 0.0, 6.0], InvalidPoint::Face(InvalidFace(6))));
    points.push(([nan, 0.0, 255.0], InvalidPoint::Face(InvalidFace(255))));
    let shifted = Shifted::new(Ellipsoid::<T>::WGS84, Shift::Authalic).unwrap();
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, Projection::Vertex).unwrap();
    let earth = Ellipsoid::<T>::WGS84;

    refuse::<T, _, 3, 2>([1.0, 0.0, 0.0], &vectors, &batch::position::to_lat_lon);
    refuse::<T, _, 3, 2>([3.0, 0.0, 0.0], &vectors, &|from, to| {
        batch::latitude::to_lat_lon(&shifted, from, to)
    });
    refuse::<T, _, 2, 3>([1.0, 0.0], &places, &batch::position::to_direction);
    refuse::<T, _, 2, 3>([1.0, 300.0], &places, &|from, to| {
        batch::latitude::to_direction(&shifted, from, to)
    });
    refuse::<T, _, 3, 3>([1.0, 0.0, 0.0], &vectors, &|from, [face, x, y]| {
        with_faces(face, |faces| {
            batch::cube::project(Projection::Vertex, from, faces, [x, y])
        })
    });
    refuse::<T, _, 2, 3>([1.0, 0.0], &places, &|from, [face, x, y]| {
        with_faces(face, |faces| batch::map::project(&map, from, faces, [x, y]))
    });
    refuse::<T, _, 3, 3>([0.5, 0.5, 4.0], &points, &|[x, y, numbers], to| {
        batch::cube::unproject(Projection::Vertex, &bytes(numbers), [x, y], to)
    });
    refuse::<T, _, 3, 2>([0.5, 0.5, 4.0], &points, &|[x, y, numbers], to| {
        batch::map::unproject(&map, &bytes(numbers), [x, y], to)
    });

    let conversion = Conversion::new(earth, Latitude::Geodetic, Latitude::Authalic).unwrap();
    let latitudes = [nan, 91.0, -100.0, infinite].map(|value| ([value], InvalidLatitude(of(value))));
    refuse::<T, _, 1, 1>([45.0], &latitudes, &|[from], [to]| {
        batch::latitude::degrees(&conversion, from, to)
    });
    refuse::<T, _, 1, 1>([0.5], &latitudes, &|[from], [to]| {
        batch::latitude::radians(&conversion, from, to)
    });

    let ecef = [[nan, 0.0, 0.0], [0.0, infinite, 0.0], [0.0, 0.0, -infinite]];
    let ecef = ecef.map(|[x, y, z]| {
        (
            [x, y, z],
            InvalidEcef {
                x: of(x),
                y: of(y),
                z: of(z),
            },
        )
    });
    refuse::<T, _, 3, 3>([7e6, 0.0, 0.0], &ecef, &|from, to| {
        batch::ellipsoid::to_geodetic(earth, from, to)
    });
    let mut geodetic: Vec<_> = places
        .iter()
        .map(|&([lat, lon], why)| ([lat, lon, 0.0], InvalidGeodetic::LatLon(why)))
        .collect();
    for height in [nan, infinite] {
        let why = InvalidHeight { height: of(height) };
        geodetic.push(([0.0, 200.0, height], InvalidGeodetic::Height(why)));
    }
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &geodetic, &|from, to| {
        batch::ellipsoid::to_ecef(earth, from, to)
    });

    let frame = LocalFrame::new(earth, Geodetic::default());
    refuse::<T, _, 3, 3>([7e6, 0.0, 0.0], &ecef, &|from, to| {
        batch::frame::to_aer(&frame, from, to)
    });
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &geodetic, &|from, to| {
        batch::frame::geodetic_to_aer(&frame, from, to)
    });
    let enu = |[east, north, up]: [f64; 3]| {
        let why = InvalidEnu {
            east: of(east),
            north: of(north),
            up: of(up),
        };
        ([east, north, up], why)
    };
    let enu = [[nan, 0.0, 0.0], [0.0, infinite, 0.0], [1.0, 2.0, -infinite]].map(enu);
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &enu, &|from, to| {
        batch::frame::enu_to_geodetic(&frame, from, to)
    });
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &enu, &|from, to| {
        batch::frame::enu_to_offset(&frame, from, to)
    });
    // At the origin on the x axis, up, east and north are x, y and z.
    let point = [(
        [0.0, 1.0, infinite],
        InvalidEcef {
            x: of(infinite),
            y: of(nan),
            z: of(nan),
        },
    )];
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &point, &|from, to| {
        batch::frame::from_enu(&frame, from, to)
    });
    refuse::<T, Infallible, 3, 3>([1.0, 2.0, 3.0], &[], &|from, to| {
        batch::frame::vector_to_enu(&frame, from, to)
    });
}

/// Bytes in place of a column of numbers.
fn bytes<T: Scalar>(numbers: &[T]) -> Vec<u8> {
    numbers.iter().map(|&number| number.into() as u8).collect()
}

/// Faces in place of a column of numbers.
fn with_faces<T: Scalar, E>(column: &mut [T], work: impl FnOnce(&mut [Face]) -> Result<(), E>) -> Result<(), E> {
    // The mark where nothing is written.
    let mut faces = vec![Face::Left; column.len()];
    let result = work(&mut faces);
    for (slot, face) in column.iter_mut().zip(faces).filter(|(_, face)| *face != Face::Left) {
        *slot = number(face);
    }
    result
}

#[test]
fn refused_elements_are_nan_and_counted() {
    every_refusal::<f64>();
    every_refusal::<f32>();
}

/// The same call with a number of elements, a bad one among them, against one by one.
#[test]
fn all_lengths() {
    let [lat, lon] = places::<f64>();
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Projection::Outerra).unwrap();
    for length in 0..=200 {
        let mut lat = lat[..length].to_vec();
        // In the west, as 180 to 360.
        let lon: Vec<f64> = lon[..length].iter().map(|lon| lon.rem_euclid(360.0)).collect();
        let bad: Vec<usize> = [length / 2, length.wrapping_sub(1)]
            .into_iter()
            .filter(|i| i % 3 == 1)
            .collect();
        for &index in bad.iter().filter(|&&index| index < length) {
            lat[index] = f64::NAN;
        }
        let (mut faces, mut x, mut y) = (vec![9; length], vec![7.0; length], vec![7.0; length]);
        let found = batch::map::project(&map, [&lat, &lon], &mut faces, [&mut x, &mut y]);
        let mut refused = Vec::new();
        for index in 0..length {
            match LatLon::new(lat[index], lon[index]) {
                Ok(place) => {
                    let point = map.project(place);
                    let expected = (point.face().index(), point.x().to_bits(), point.y().to_bits());
                    assert_eq!((faces[index], x[index].to_bits(), y[index].to_bits()), expected);
                }
                Err(_) => {
                    assert!(faces[index] == 0 && x[index].is_nan() && y[index].is_nan());
                    refused.push(index);
                }
            }
        }
        match (found, refused.first()) {
            (Ok(()), None) => {}
            (Err(InvalidBatch::Elements { count, first, .. }), Some(&index)) => {
                assert_eq!((count, first), (refused.len(), index));
            }
            other => panic!("{length}: {other:?}"),
        }
    }
}
