//! The great circle against the truth.

use terrella::geodesic::{Geodesic, GreatCircle};
use terrella::{Direction, LatLon};
use testkit::{Worst, maximum, minimum};

use crate::sample::{awkward, place};
use testkit::truth::{Row, Scalar, Truth};

fn unit<T: Scalar>() -> GreatCircle<T> {
    GreatCircle::new(T::ONE).unwrap()
}

/// The places of a row.
pub fn places<T: Scalar>(row: Row<'_>) -> (LatLon<T>, LatLon<T>) {
    let at = |lat, lon| LatLon::new(row.input::<T>(lat), row.input(lon)).unwrap();
    (at("lat1", "lon1"), at("lat2", "lon2"))
}

const PLACES: [&str; 4] = ["lat1", "lon1", "lat2", "lon2"];

/// The largest relative error of a column.
fn relative(rows: &[Row<'_>], column: &str, computed: impl Fn(Row<'_>) -> f64) -> f64 {
    Worst::of(rows.iter().map(|&row| {
        let truth = row.value(column);
        let error = row.error(column, computed(row));
        if truth == 0.0 { error } else { error / truth }
    }))
}

fn degrees<T: Scalar>() -> f64 {
    let truth = Truth::read("greatcircle_deg");
    relative(&truth.exact_in::<T>(&PLACES), "dist", |row| {
        let (from, to) = places::<T>(row);
        unit().inverse(from, to).unwrap().distance.into()
    })
}

fn radians<T: Scalar>() -> f64 {
    let truth = Truth::read("greatcircle_rad");
    relative(&truth.exact_in::<T>(&PLACES), "dist", |row| {
        let [lat1, lon1, lat2, lon2] = PLACES.map(|column| row.input::<T>(column));
        unit().distance_radians([lat1, lon1], [lat2, lon2]).into()
    })
}

fn vectors<T: Scalar>() -> f64 {
    let truth = Truth::read("greatcircle_vectors");
    relative(
        &truth.exact_in::<T>(&["ax", "ay", "az", "bx", "by", "bz"]),
        "angle",
        |row| {
            let direction = |x, y, z| Direction::new(row.input::<T>(x), row.input(y), row.input(z)).unwrap();
            GreatCircle::angle_radians(direction("ax", "ay", "az"), direction("bx", "by", "bz")).into()
        },
    )
}

/// The largest error of an azimuth in radians, times the sine of the distance.
fn azimuths<T: Scalar>() -> f64 {
    let truth = Truth::read("greatcircle_deg");
    Worst::of(truth.exact_in::<T>(&PLACES).into_iter().map(|row| {
        let (from, to) = places::<T>(row);
        let line = unit().inverse(from, to).unwrap();
        let sine = row.value("dist").sin();
        let of = |column, azimuth: T| match row.text(column) {
            "nan" => 0.0,
            _ => {
                let error = row.error(column, azimuth);
                minimum(error, (360.0 - error).abs()).to_radians() * sine
            }
        };
        maximum(of("azi1", line.azimuth1), of("azi2", line.azimuth2))
    }))
}

#[test]
fn distances_are_as_accurate_as_claimed() {
    let figures = [
        ("degrees", degrees::<f64>(), degrees::<f32>()),
        ("radians", radians::<f64>(), radians::<f32>()),
        ("vectors", vectors::<f64>(), vectors::<f32>()),
    ];
    for (what, double, single) in figures {
        println!("{what}: {double:.2e} {single:.2e}");
    }
    let worst = figures.map(|(_, double, single)| [double, single]);
    // On the truth less than what the table says, which covers random places too.
    assert!(
        worst
            .iter()
            .all(|&[double, single]| double <= 4e-16 && single <= 1.5e-7)
    );
    let largest = |i: usize| Worst::of(worst.iter().map(|pair| pair[i]));
    testkit::table::hold("GreatCircle distance, relative", [largest(0), largest(1)]);
}

#[test]
fn azimuths_are_as_accurate_as_claimed() {
    let (double, single) = (azimuths::<f64>(), azimuths::<f32>());
    println!("{double:.2e} {single:.2e}");
    assert!(double <= 6.0e-16 && single <= 3.2e-7);
}

/// Awkward pairs in `f32`, against `f64`: the relative error on a unit sphere, and what the error in metres on the Earth is over 1.5e-7 of the distance.
#[test]
fn single_precision_keeps_its_claim() {
    const EARTH: f32 = 6_371_000.0;
    let (mut relative, mut over) = (Worst::default(), Worst::default());
    let mut rng = fastrand::Rng::with_seed(5);
    let double = GreatCircle::new(1.0).unwrap();
    let (single, earth) = (unit::<f32>(), GreatCircle::new(EARTH).unwrap());
    for _ in 0..1_000_000 {
        let [lat1, lon1, lat2, lon2] = awkward(&mut rng).map(|x| x as f32);
        let (from, to) = (place(lat1, lon1), place(lat2, lon2));
        let [lat1, lon1, lat2, lon2] = [lat1, lon1, lat2, lon2].map(f64::from);
        let truth = double.inverse(place(lat1, lon1), place(lat2, lon2)).unwrap().distance;
        let error = (f64::from(single.inverse(from, to).unwrap().distance) - truth).abs();
        relative.add(if error == 0.0 { 0.0 } else { error / truth });
        let truth = truth * f64::from(EARTH);
        let error = (f64::from(earth.inverse(from, to).unwrap().distance) - truth).abs();
        over.add(error - 1.5e-7 * truth);
    }
    let (relative, over) = (relative.value(), over.value());
    println!("{relative:.2e}, {over:.2} m");
    assert!(relative <= 4.5e-7 && over <= 1.5);
}

/// Points along, in the middle and beside great circles, by triangles that are known.
#[test]
fn points_and_tracks() {
    let mut rng = fastrand::Rng::with_seed(6);
    let sphere = unit::<f64>();
    let apart = |a, b| sphere.inverse(a, b).unwrap().distance;
    let mut errors = [Worst::default(); 4];
    for _ in 0..200_000 {
        let [lat1, lon1, lat2, lon2] = awkward(&mut rng);
        let (start, end) = (place(lat1, lon1), place(lat2, lon2));
        let line = sphere.inverse(start, end).unwrap();
        let middle = sphere.midpoint(start, end);
        let fraction = rng.f64();
        let part = sphere.intermediate(start, end, fraction).unwrap();
        let halves = (apart(start, middle) - apart(middle, end)).abs();
        let parts = (apart(start, part) - fraction * line.distance).abs();
        // A point beside the line: along it, then to the right.
        let (along, cross) = (3.0 * (rng.f64() - 0.5), rng.f64() - 0.5);
        let foot = sphere.direct(start, line.azimuth1, along).unwrap();
        if foot.position.lat().abs() > 85.0 {
            continue; // where its azimuth, and so the point beside it, is not known as well
        }
        let beside = sphere
            .direct(foot.position, foot.azimuth + 90.0, cross)
            .unwrap()
            .position;
        let across = (sphere.cross_track(beside, start, end) - cross).abs();
        let ahead = (sphere.along_track(beside, start, end) - along).abs() * cross.cos();
        for (worst, error) in errors.iter_mut().zip([halves, parts, across, ahead]) {
            worst.add(error);
        }
    }
    println!("{errors:?}");
    assert!(errors.into_iter().all(|error| error.value() <= 4e-15));
}

/// The largest errors in radians of the place a line ends at, and of the azimuth there times the cosine of its latitude.
fn ends<T: Scalar>() -> [f64; 2] {
    let truth = Truth::read("geod_direct_moon");
    let moon = GreatCircle::new(T::of(1_737_400.0)).unwrap();
    let mut worst = [Worst::default(); 2];
    for row in truth.exact_in::<T>(&["lat1", "lon1", "azi1", "s12"]) {
        if row.value("a12").abs() > 180.0 {
            continue;
        }
        let [lat, lon, azimuth, distance] = ["lat1", "lon1", "azi1", "s12"].map(|column| row.input::<T>(column));
        let end = moon.direct(place(lat, lon), azimuth, distance).unwrap();
        let cos = row.value("lat2").to_radians().cos();
        let turn = |column, angle: T| {
            let error = row.error(column, angle);
            minimum(error, (360.0 - error).abs()).to_radians() * cos
        };
        let place = row.error("lat2", end.position.lat()).to_radians();
        let place = place.hypot(turn("lon2", end.position.lon()));
        for (worst, error) in worst.iter_mut().zip([place, turn("azi2", end.azimuth)]) {
            worst.add(error);
        }
    }
    worst.map(Worst::value)
}

#[test]
fn destinations_are_as_accurate_as_claimed() {
    let (double, single) = (ends::<f64>(), ends::<f32>());
    println!("{double:?} {single:?}");
    assert!(double[0] <= 1.1e-15 && double[1] <= 1.5e-15);
    assert!(single[0] <= 6.0e-7 && single[1] <= 8.0e-7);
}

/// Of four radians any may be no number.
#[test]
fn no_number_is_no_distance() {
    fn check<T: Scalar>() {
        for i in 0..4 {
            let mut given = [T::ONE; 4];
            given[i] = T::of(f64::NAN);
            let [lat1, lon1, lat2, lon2] = given;
            assert!(unit::<T>().distance_radians([lat1, lon1], [lat2, lon2]).into().is_nan());
        }
    }
    check::<f64>();
    check::<f32>();
}

/// Random pairs do not meet the worst: from hundreds of them each digit is varied, in `f32`, as long as the error grows. 3.0e-7 was claimed.
#[test]
fn climbing_finds_no_distance_worse_than_claimed() {
    let (single, double) = (unit::<f32>(), unit::<f64>());
    let error = |[lat1, lon1, lat2, lon2]: [f32; 4]| {
        let found: f64 = single
            .inverse(place(lat1, lon1), place(lat2, lon2))
            .unwrap()
            .distance
            .into();
        let [lat1, lon1, lat2, lon2] = [lat1, lon1, lat2, lon2].map(f64::from);
        let truth = double.inverse(place(lat1, lon1), place(lat2, lon2)).unwrap().distance;
        if truth == 0.0 {
            0.0
        } else {
            (found - truth).abs() / truth
        }
    };
    let mut rng = fastrand::Rng::with_seed(31);
    let mut worst = Worst::default();
    // The worst of a longer search.
    worst.add(error([57.372_787, 143.648_93, 57.928_08, 129.177_19]));
    for _ in 0..400 {
        let apart = 10.0_f32.powf(3.0 * rng.f32() - 2.0);
        let (lat, lon) = (160.0 * rng.f32() - 80.0, 300.0 * rng.f32() - 150.0);
        let mut pair = [lat, lon, lat + 0.1 * apart * rng.f32(), lon + apart * rng.f32()];
        let (mut most, mut step) = (error(pair), apart);
        for _ in 0..300 {
            let near = pair.map(|x| if rng.bool() { x + step * (rng.f32() - 0.5) } else { x });
            if near[0].abs() > 90.0 || near[2].abs() > 90.0 {
                continue;
            }
            let next = error(near);
            if next >= most {
                (pair, most) = (near, next);
            } else {
                step *= 0.98;
            }
        }
        worst.add(most);
    }
    let worst = worst.value();
    println!("{worst:e}");
    assert!(worst > 3.0e-7 && worst <= 4.2e-7, "{worst:e}");
}

/// The worst in `f64` that climbing found, by 40 digits.
#[test]
fn the_worst_distance_between_neighbours() {
    let (from, to) = (
        place(-55.378_945_537_922_08, 123.875_699_911_301_87),
        place(-55.471_549_572_492_1, 125.699_350_687_937_61),
    );
    let truth = 0.018_133_826_846_893_837;
    let error = (unit::<f64>().inverse(from, to).unwrap().distance - truth).abs() / truth;
    assert!((6.8e-16..=8e-16).contains(&error), "{error:e}");
}
