//! Over slices: the same bits as one by one, for any length, with anything anywhere, and the same refusals; of unequal lengths nothing is written.

use core::fmt::Debug;

use terrella::batch::{self, InvalidBatch, cube::InvalidPoint, ellipsoid::InvalidGeodetic};
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint};
use terrella::geodesic::{Geodesic, Karney, Vincenty};
use terrella::latitude::Conversion;
use terrella::{Direction, Ecef, Geodetic, LatLon, Latitude, Real, Shift, Shifted};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::{Scalar, same};

mod frame;
mod healpix;
mod line;
mod ring;
mod scene;
mod terrain;

use frame::frames;
use healpix::pixels;
use line::{checked, distances, end, line, lines, paths};
use ring::rings;
use scene::answers;
use terrain::{keys, samples, tiles};

properties! {
    positions latitudes points projections maps inverses directs
    distances lines paths frames tiles keys samples rings answers pixels
}

/// What stands where nothing was written.
const MARK: f64 = 7.0;

/// Compares a batch with one by one.
fn compare<T: Scalar, E: Debug, const I: usize, const O: usize>(
    bytes: &mut Bytes<'_>,
    what: &str,
    element: impl Fn(&mut Bytes<'_>) -> [T; I],
    one: impl Fn([T; I]) -> Result<[T; O], E>,
    batch: impl Fn([&[T]; I], [&mut [T]; O]) -> Result<(), InvalidBatch<E>>,
) {
    compare_or(bytes, what, [T::of(f64::NAN); O], element, one, batch);
}

/// Compares a batch with one by one; `nothing` is written for what is refused. A few elements are made of bytes, and come again
/// and again in an order made of them too; a column may be of another length.
fn compare_or<T: Scalar, E: Debug, const I: usize, const O: usize>(
    bytes: &mut Bytes<'_>,
    what: &str,
    nothing: [T; O],
    element: impl Fn(&mut Bytes<'_>) -> [T; I],
    one: impl Fn([T; I]) -> Result<[T; O], E>,
    batch: impl Fn([&[T]; I], [&mut [T]; O]) -> Result<(), InvalidBatch<E>>,
) {
    let length = usize::from(bytes.byte()) + usize::from(bytes.byte() % 46);
    let unequal = bytes.byte();
    let mut order = bytes.word();
    let count = usize::from(bytes.byte() % 6) + 1;
    let elements: Vec<[T; I]> = (0..count).map(|_| element(bytes)).collect();
    let mut next = || {
        order = order
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        elements[(order >> 33) as usize % count]
    };
    let rows: Vec<[T; I]> = (0..length).map(|_| next()).collect();

    // One of eight batches has a column that is shorter or longer.
    let by = usize::from(unequal / 8 % 3);
    let other = if unequal.is_multiple_of(8) {
        (length + 1).saturating_sub(by)
    } else {
        length
    };
    let odd = usize::from(unequal / 32) % (I + O);
    let long = |column: usize| if column == odd { other } else { length };
    let inputs: [Vec<T>; I] = core::array::from_fn(|column| {
        let values = rows.iter().map(|row| row[column]).chain([T::ZERO]);
        values.take(long(column)).collect()
    });
    let mut results: [Vec<T>; O] = core::array::from_fn(|column| vec![T::of(MARK); long(I + column)]);
    let found = batch(
        inputs.each_ref().map(|column| &column[..]),
        results.each_mut().map(|column| &mut column[..]),
    );

    let first = inputs[0].len();
    let lengths = inputs.iter().map(Vec::len).chain(results.iter().map(Vec::len));
    let context = || format!("{what} {}: {length} of {elements:?}", T::NAME);
    if let Some(other) = lengths.into_iter().find(|&other| other != first) {
        let lengths = format!("{:?}", InvalidBatch::<()>::Lengths { first, other });
        assert_eq!(format!("{:?}", found.unwrap_err()), lengths, "{}", context());
        let written = results.iter().flatten().any(|&v| v != T::of(MARK));
        assert!(!written, "{}: written", context());
        return;
    }
    judge(&context(), nothing, &results, |index| one(rows[index]), found);
}

/// Judges what a batch wrote and returned by what one by one gives.
fn judge<T: Scalar, E: Debug, const O: usize>(
    context: &str,
    nothing: [T; O],
    results: &[Vec<T>; O],
    one: impl Fn(usize) -> Result<[T; O], E>,
    found: Result<(), InvalidBatch<E>>,
) {
    let mut refused: Result<(), InvalidBatch<E>> = Ok(());
    for index in 0..results[0].len() {
        let expected = one(index);
        for (column, result) in results.iter().enumerate() {
            let result = result[index];
            assert!(
                same(expected.as_ref().map_or(nothing[column], |row| row[column]), result),
                "{context}: {index} is {expected:?}, not {result:?} in column {column}"
            );
        }
        if let Err(why) = expected {
            match &mut refused {
                Err(InvalidBatch::Elements { count, .. }) => *count += 1,
                _ => {
                    refused = Err(InvalidBatch::Elements {
                        count: 1,
                        first: index,
                        why,
                    });
                }
            }
        }
    }
    // In words, as a NaN is not itself.
    assert_eq!(format!("{refused:?}"), format!("{found:?}"), "{context}");
}

/// A number of a column: in range, or one time in sixteen anything.
fn entry<T: Scalar>(bytes: &mut Bytes<'_>, limit: f64) -> T {
    if bytes.byte() % 16 == 15 {
        bytes.anything()
    } else {
        bytes.within(limit)
    }
}

fn place<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 2] {
    [entry(bytes, 90.0), entry(bytes, 180.0)]
}

/// Two places, seldom bad ones.
fn pair<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 4] {
    if bytes.byte() % 8 == 7 {
        let ([lat1, lon1], [lat2, lon2]) = (place(bytes), place(bytes));
        return [lat1, lon1, lat2, lon2];
    }
    let (from, to) = bytes.pair();
    [from.lat(), from.lon(), to.lat(), to.lon()]
}

fn vector<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 3] {
    match bytes.byte() % 8 {
        0 => [bytes.anything(), bytes.anything(), bytes.anything()],
        1 | 2 => [entry(bytes, 1.0), entry(bytes, 1.0), entry(bytes, 1.0)],
        _ => bytes.direction().to_array(),
    }
}

/// What a point of a face is that was refused.
fn no_point<T: Scalar>() -> [T; 3] {
    [T::ZERO, T::of(f64::NAN), T::of(f64::NAN)]
}

fn number<T: Real>(face: Face) -> T {
    T::of(f64::from(face.index()))
}

fn numbers<T: Scalar>(numbers: &[T]) -> Vec<u8> {
    numbers.iter().map(|&number| number.into() as u8).collect()
}

/// x, y and the number of a face, or of none.
fn point<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 3] {
    [entry(bytes, 1.0), entry(bytes, 1.0), T::of(f64::from(bytes.byte() % 7))]
}

/// The point of a face, as a batch takes it.
fn face_point<T: Scalar>([x, y, number]: [T; 3]) -> Result<FacePoint<T>, InvalidPoint<T>> {
    let face = Face::from_index(number.into() as u8).map_err(InvalidPoint::Face)?;
    FacePoint::new(face, x, y).map_err(InvalidPoint::Point)
}

/// Faces in place of a column of numbers, which are written if they are.
fn with_faces<T: Scalar, E>(
    column: &mut [T],
    work: impl FnOnce(&mut [Face]) -> Result<(), InvalidBatch<E>>,
) -> Result<(), InvalidBatch<E>> {
    let mut faces = vec![Face::Left; column.len()];
    let result = work(&mut faces);
    if !matches!(result, Err(InvalidBatch::Lengths { .. })) {
        for (slot, face) in column.iter_mut().zip(faces) {
            *slot = number(face);
        }
    } else {
        assert!(faces.iter().all(|&face| face == Face::Left), "faces are written");
    }
    result
}

/// An ellipsoid and a shift that holds for it.
fn shifted<T: Scalar>(bytes: &mut Bytes<'_>) -> Shifted<T> {
    let shift = bytes.choice(Shift::ALL);
    let (least, most) = match shift {
        Shift::Geodetic | Shift::Geocentric | Shift::Parametric => (-1.0, 0.5),
        _ => (-1.0 / 9.0, 0.1),
    };
    Shifted::new(bytes.ellipsoid(least, most), shift).unwrap()
}

fn positions<T: Scalar>(bytes: &mut Bytes<'_>) {
    let shifted = shifted::<T>(bytes);
    let plain = bytes.flag();
    if bytes.flag() {
        compare(
            bytes,
            "to_direction",
            place,
            |[lat, lon]| {
                let place = LatLon::new(lat, lon)?;
                Ok(if plain {
                    place.to_direction()
                } else {
                    shifted.to_direction(place)
                }
                .to_array())
            },
            |from, to| {
                if plain {
                    batch::position::to_direction(from, to)
                } else {
                    batch::latitude::to_direction(&shifted, from, to)
                }
            },
        );
    } else {
        compare(
            bytes,
            "to_lat_lon",
            vector,
            |[x, y, z]| {
                let direction = Direction::new(x, y, z)?;
                let place = if plain {
                    direction.to_lat_lon()
                } else {
                    shifted.to_lat_lon(direction)
                };
                Ok([place.lat(), place.lon()])
            },
            |from, to| {
                if plain {
                    batch::position::to_lat_lon(from, to)
                } else {
                    batch::latitude::to_lat_lon(&shifted, from, to)
                }
            },
        );
    }
}

fn latitudes<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1);
    let (from, to) = (bytes.choice(Latitude::ALL), bytes.choice(Latitude::ALL));
    let conversion = Conversion::new(ellipsoid, from, to).unwrap();
    let degrees = bytes.flag();
    let limit = match (from, degrees) {
        (Latitude::Isometric, _) => 40.0,
        (_, true) => 90.0,
        _ => core::f64::consts::FRAC_PI_2,
    };
    compare(
        bytes,
        "latitudes",
        |bytes| [entry(bytes, limit)],
        |[value]| {
            let result = if degrees {
                conversion.degrees(value)
            } else {
                conversion.radians(value)
            };
            result.map(|value| [value])
        },
        |[from], [to]| {
            if degrees {
                batch::latitude::degrees(&conversion, from, to)
            } else {
                batch::latitude::radians(&conversion, from, to)
            }
        },
    );
}

fn points<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid::<T>(-9.0, 0.9);
    if bytes.flag() {
        compare(
            bytes,
            "to_ecef",
            |bytes| {
                let [lat, lon] = place(bytes);
                [lat, lon, entry(bytes, 1e6)]
            },
            |[lat, lon, height]| {
                let place = LatLon::new(lat, lon).map_err(InvalidGeodetic::LatLon)?;
                let place = Geodetic::new(place, height).map_err(InvalidGeodetic::Height)?;
                Ok(ellipsoid.to_ecef(place).to_array())
            },
            |from, to| batch::ellipsoid::to_ecef(ellipsoid, from, to),
        );
    } else {
        compare(
            bytes,
            "to_geodetic",
            |bytes| {
                let size = bytes.choice(&[1e5, 1e7, 1e8]);
                [entry(bytes, size), entry(bytes, size), entry(bytes, size)]
            },
            |[x, y, z]| {
                let place = ellipsoid.to_geodetic(Ecef::new(x, y, z)?);
                Ok([place.lat(), place.lon(), place.height()])
            },
            |from, to| batch::ellipsoid::to_geodetic(ellipsoid, from, to),
        );
    }
}

fn projections<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    if bytes.flag() {
        compare_or(
            bytes,
            projection.name(),
            no_point(),
            vector::<T>,
            |[x, y, z]| {
                let point = projection.project(Direction::new(x, y, z)?);
                Ok([number(point.face()), point.x(), point.y()])
            },
            |from, [face, x, y]| with_faces(face, |faces| batch::cube::project(projection, from, faces, [x, y])),
        );
    } else {
        compare(
            bytes,
            projection.name(),
            point::<T>,
            |point| Ok(projection.unproject(face_point(point)?).to_array()),
            |[x, y, faces], to| batch::cube::unproject(projection, &numbers(faces), [x, y], to),
        );
    }
}

fn maps<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let shifted = shifted::<T>(bytes);
    let map = CubeMap::new(shifted.ellipsoid(), shifted.shift(), projection).unwrap();
    if bytes.flag() {
        compare_or(
            bytes,
            projection.name(),
            no_point(),
            place::<T>,
            |[lat, lon]| {
                let point = map.project(LatLon::new(lat, lon)?);
                Ok([number(point.face()), point.x(), point.y()])
            },
            |from, [face, x, y]| with_faces(face, |faces| batch::map::project(&map, from, faces, [x, y])),
        );
    } else {
        compare(
            bytes,
            projection.name(),
            point::<T>,
            |point| {
                let place = map.unproject(face_point(point)?);
                Ok([place.lat(), place.lon()])
            },
            |[x, y, faces], to| batch::map::unproject(&map, &numbers(faces), [x, y], to),
        );
    }
}

fn inverses<T: Scalar>(bytes: &mut Bytes<'_>) {
    fn by<T: Scalar, M: Geodesic<T>>(bytes: &mut Bytes<'_>, method: &M) {
        compare(
            bytes,
            "inverse",
            pair,
            |[lat1, lon1, lat2, lon2]| line(method, checked([lat1, lon1])?, checked([lat2, lon2])?),
            |[lat1, lon1, lat2, lon2], lines| batch::geodesic::inverse(method, [lat1, lon1], [lat2, lon2], lines),
        );
    }
    if bytes.flag() {
        let ellipsoid = bytes.ellipsoid::<T>(0.0, 1.0 / 293.0);
        by(bytes, &Vincenty::new(ellipsoid).unwrap());
    } else {
        let ellipsoid = bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1);
        by(bytes, &Karney::new(ellipsoid).unwrap());
    }
}

fn directs<T: Scalar>(bytes: &mut Bytes<'_>) {
    fn by<T: Scalar, M: Geodesic<T>>(bytes: &mut Bytes<'_>, method: &M) {
        compare(
            bytes,
            "direct",
            |bytes| {
                let [lat, lon] = place(bytes);
                [lat, lon, entry(bytes, 400.0), entry(bytes, 4e8)]
            },
            |[lat, lon, azimuth, distance]| end(method, checked([lat, lon])?, azimuth, distance),
            |[lat, lon, azimuth, distance], ends| batch::geodesic::direct(method, [lat, lon], azimuth, distance, ends),
        );
    }
    if bytes.flag() {
        let ellipsoid = bytes.ellipsoid::<T>(0.0, 1.0 / 293.0);
        by(bytes, &Vincenty::new(ellipsoid).unwrap());
    } else {
        let ellipsoid = bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1);
        by(bytes, &Karney::new(ellipsoid).unwrap());
    }
}
