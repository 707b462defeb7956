//! Geodesics by every method: distances, one place and many, lines, paths.

use terrella::batch::{self, geodesic::InvalidProblem};
use terrella::geodesic::{AnyMethod, Geodesic, GeodesicError, GreatCircle, Karney, Method};
use terrella::{Ellipsoid, LatLon};

use super::{compare, entry, judge, pair, place};
use testkit::bytes::Bytes;
use testkit::scalar::Scalar;

type Problem<T, R> = Result<R, InvalidProblem<T>>;

/// Any method, on an ellipsoid that it holds for.
fn any_method<T: Scalar>(bytes: &mut Bytes<'_>) -> AnyMethod<T> {
    let method = bytes.choice(Method::ALL);
    let ellipsoid = bytes.ellipsoid(-1.0 / 9.0, 0.1);
    let about = LatLon::new(bytes.within(80.0), bytes.within(180.0)).unwrap();
    let solver = method.about(ellipsoid, about);
    solver.or_else(|_| method.about(Ellipsoid::WGS84, about)).unwrap()
}

pub(super) fn checked<T: Scalar>([lat, lon]: [T; 2]) -> Problem<T, LatLon<T>> {
    LatLon::new(lat, lon).map_err(InvalidProblem::LatLon)
}

pub(super) fn line<T: Scalar>(method: &impl Geodesic<T>, from: LatLon<T>, to: LatLon<T>) -> Problem<T, [T; 3]> {
    let line = method.inverse(from, to).map_err(InvalidProblem::Geodesic)?;
    Ok([line.distance, line.azimuth1, line.azimuth2])
}

fn length<T: Scalar>(method: &AnyMethod<T>, from: LatLon<T>, to: LatLon<T>) -> Problem<T, [T; 1]> {
    line(method, from, to).map(|[distance, ..]| [distance])
}

pub(super) fn end<T: Scalar>(
    method: &impl Geodesic<T>,
    from: LatLon<T>,
    azimuth: T,
    distance: T,
) -> Problem<T, [T; 3]> {
    let end = method.direct(from, azimuth, distance);
    let end = end.map_err(InvalidProblem::Geodesic)?;
    Ok([end.position.lat(), end.position.lon(), end.azimuth])
}

pub(super) fn distances<T: Scalar>(bytes: &mut Bytes<'_>) {
    let method = &any_method::<T>(bytes);
    let alone = bytes.place();
    match bytes.byte() % 6 {
        0 => compare(
            bytes,
            "inverse",
            pair,
            |[lat1, lon1, lat2, lon2]| line(method, checked([lat1, lon1])?, checked([lat2, lon2])?),
            |[lat1, lon1, lat2, lon2], lines| batch::geodesic::inverse(method, [lat1, lon1], [lat2, lon2], lines),
        ),
        1 => compare(
            bytes,
            "distance",
            pair,
            |[lat1, lon1, lat2, lon2]| length(method, checked([lat1, lon1])?, checked([lat2, lon2])?),
            |[lat1, lon1, lat2, lon2], [found]| batch::geodesic::distance(method, [lat1, lon1], [lat2, lon2], found),
        ),
        2 => compare(
            bytes,
            "inverse_from",
            place,
            |place| line(method, alone, checked(place)?),
            |places, lines| batch::geodesic::inverse_from(method, alone, places, lines),
        ),
        3 => compare(
            bytes,
            "inverse_to",
            place,
            |place| line(method, checked(place)?, alone),
            |places, lines| batch::geodesic::inverse_to(method, places, alone, lines),
        ),
        4 => compare(
            bytes,
            "distance_from",
            place,
            |place| length(method, alone, checked(place)?),
            |places, [found]| batch::geodesic::distance_from(method, alone, places, found),
        ),
        _ => compare(
            bytes,
            "distance_to",
            place,
            |place| length(method, checked(place)?, alone),
            |places, [found]| batch::geodesic::distance_to(method, places, alone, found),
        ),
    }
}

pub(super) fn lines<T: Scalar>(bytes: &mut Bytes<'_>) {
    let method = &any_method::<T>(bytes);
    match bytes.byte() % 4 {
        0 => compare(
            bytes,
            "direct",
            |bytes| {
                let [lat, lon] = place(bytes);
                [lat, lon, entry(bytes, 400.0), entry(bytes, 4e8)]
            },
            |[lat, lon, azimuth, distance]| end(method, checked([lat, lon])?, azimuth, distance),
            |[lat, lon, azimuth, distance], ends| batch::geodesic::direct(method, [lat, lon], azimuth, distance, ends),
        ),
        1 => {
            let (from, azimuth) = (bytes.place(), entry(bytes, 400.0));
            compare(
                bytes,
                "direct_from",
                |bytes| [entry(bytes, 4e8)],
                |[distance]| end(method, from, azimuth, distance),
                |[distance], ends| batch::geodesic::direct_from(method, from, azimuth, distance, ends),
            );
        }
        2 => {
            let (from, to) = bytes.pair();
            compare(
                bytes,
                "intermediate",
                |bytes| [entry(bytes, 2.0)],
                |[fraction]| {
                    let line = method.inverse(from, to)?;
                    match method.direct(from, line.azimuth1, line.distance * fraction) {
                        Ok(end) => Ok([end.position.lat(), end.position.lon()]),
                        Err(GeodesicError::Distance(_)) => Err(GeodesicError::Fraction(fraction)),
                        Err(why) => Err(why),
                    }
                },
                |[fractions], places| batch::geodesic::intermediate(method, from, to, fractions, places),
            );
        }
        _ => {
            let karney = Karney::new(bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1)).unwrap();
            let line = karney.line(bytes.place(), bytes.within(400.0)).unwrap();
            compare(
                bytes,
                "along",
                |bytes| [entry(bytes, 4e9)],
                |[distance]| {
                    let point = line.at(distance)?;
                    Ok([point.position.lat(), point.position.lon(), point.azimuth])
                },
                |[distance], points| batch::geodesic::along(&line, distance, points),
            );
        }
    }
}

/// Successive places, and places beside great circles.
pub(super) fn paths<T: Scalar>(bytes: &mut Bytes<'_>) {
    let method = &any_method::<T>(bytes);
    let sphere = GreatCircle::new(T::of(6.4e6)).unwrap();
    let alone = bytes.place();
    let kind = bytes.byte() % 3;
    if kind == 0 {
        let (start, end) = bytes.pair();
        compare(
            bytes,
            "tracks",
            place,
            |[lat, lon]| {
                let place = LatLon::new(lat, lon)?;
                Ok([
                    sphere.along_track(place, start, end),
                    sphere.cross_track(place, start, end),
                ])
            },
            |places, tracks| batch::geodesic::tracks(&sphere, places, start, end, tracks),
        );
        return;
    }
    let (count, stride) = (usize::from(bytes.byte()), usize::from(bytes.byte()));
    let few = [(); 5].map(|()| place::<T>(bytes));
    let places: Vec<[T; 2]> = (0..count).map(|i| few[(i * stride + i * i) % few.len()]).collect();
    let path = [0, 1].map(|column| places.iter().map(|place| place[column]).collect::<Vec<T>>());
    let path = path.each_ref().map(|column| &column[..]);
    let legs = count.saturating_sub(1);
    let context = format!("{method:?}: {count} of {few:?}");
    if kind == 1 {
        let mut results = [vec![T::of(super::MARK); legs]];
        let found = batch::geodesic::legs(method, path, &mut results[0]);
        let one = |i: usize| length(method, checked(places[i])?, checked(places[i + 1])?);
        judge(&context, [T::of(f64::NAN)], &results, one, found);
    } else {
        let mut results = [(); 2].map(|()| vec![T::of(super::MARK); legs]);
        let found = batch::geodesic::leg_tracks(&sphere, alone, path, results.each_mut().map(|column| &mut column[..]));
        let one = |i: usize| {
            let [start, end] = [places[i], places[i + 1]].map(|[lat, lon]| LatLon::new(lat, lon));
            let (start, end) = (start?, end?);
            Ok([
                sphere.along_track(alone, start, end),
                sphere.cross_track(alone, start, end),
            ])
        };
        judge(&context, [T::of(f64::NAN); 2], &results, one, found);
    }
}
