//! The errors over a slice of the truth, each held to what the README claims.

use cortex_m_semihosting::hprintln;
use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection};
use terrella::distortion::Ground;
use terrella::geodesic::{Area, Geodesic, GreatCircle, Karney, Vincenty};
use terrella::latitude::Conversion;
use terrella::{Direction, Ecef, Ellipsoid, Geodetic, LatLon, Latitude, Shift, math};
use testkit::{Worst, maximum, minimum};

use crate::truth::{
    ATAN, ATAN2, CBRT, CLAIMS, CLAIMS_OF_PROJECTIONS, DIRECT, DIRECTION, GEODETIC, GREAT_CIRCLE, INVERSE, JACOBIAN,
    LAT_LON, LATITUDES, PROJECTIONS, Row, SIN_COS, SIN_COS_DEGREES, Single, TAN, TO_ECEF, TO_GEODETIC, sqrt,
};

/// Prints a line for each claim; whether all are kept.
pub fn all_kept() -> bool {
    let mut kept = true;
    hprintln!("claim\tscalar\trows\tlargest error\tclaimed");
    every::<f64>(&mut kept);
    every::<f32>(&mut kept);
    kept
}

fn every<T: Single>(kept: &mut bool) {
    kernels::<T>(kept);
    positions::<T>(kept);
    latitudes::<T>(kept);
    geodesics::<T>(kept);
    jacobians::<T>(kept);
    for (projection, forward, inverse) in PROJECTIONS {
        projections::<T>(kept, *projection, forward, inverse);
    }
}

/// Holds the largest error over the rows that are exact in the scalar; rows of which `error` says nothing do not count.
fn hold<T: Single, const GIVEN: usize, const TRUTH: usize>(
    kept: &mut bool,
    name: &str,
    rows: &[Row<GIVEN, TRUTH>],
    error: impl Fn([T; GIVEN], &Row<GIVEN, TRUTH>) -> Option<f64>,
) {
    let claim = CLAIMS.iter().find(|(claim, _)| *claim == name);
    let claimed = claim.map_or(f64::NAN, |(_, claimed)| claimed[T::INDEX]);
    judge::<T, _, _>(kept, format_args!("{name}"), claimed, rows, error);
}

fn judge<T: Single, const GIVEN: usize, const TRUTH: usize>(
    kept: &mut bool,
    name: core::fmt::Arguments,
    claimed: f64,
    rows: &[Row<GIVEN, TRUTH>],
    error: impl Fn([T; GIVEN], &Row<GIVEN, TRUTH>) -> Option<f64>,
) {
    let (mut count, mut worst) = (0, Worst::default());
    for row in rows {
        if let Some(error) = row.lift().and_then(|given| error(given, row)) {
            count += 1;
            worst.add(error);
        }
    }
    let worst = worst.value();
    let well = worst <= claimed && count >= 5;
    *kept &= well;
    let verdict = if well { "" } else { "\tNOT KEPT" };
    hprintln!(
        "{}\t{}\t{}\t{:.2e}\t{:e}{}",
        name,
        T::NAME,
        count,
        worst,
        claimed,
        verdict
    );
}

/// The length of a vector of errors.
fn length<const N: usize>(errors: [f64; N]) -> f64 {
    sqrt(errors.into_iter().map(|error| error * error).sum())
}

fn place<T: Single>(lat: T, lon: T) -> Option<LatLon<T>> {
    LatLon::new(lat, lon).ok()
}

fn kernels<T: Single>(kept: &mut bool) {
    let pair = |row: &Row<1, 2>, (sin, cos): (T, T)| maximum(row.truth[0].ulps(sin), row.truth[1].ulps(cos));
    hold::<T, _, _>(kept, "math::sin_cos", SIN_COS, |[x], row| {
        (row.given[0].abs() <= 100.0).then(|| pair(row, math::sin_cos(x)))
    });
    hold::<T, _, _>(kept, "math::sin_cos_degrees", SIN_COS_DEGREES, |[x], row| {
        Some(pair(row, math::sin_cos_degrees(x)))
    });
    hold::<T, _, _>(kept, "math::tan", TAN, |[x], row| Some(row.truth[0].ulps(math::tan(x))));
    hold::<T, _, _>(kept, "math::atan", ATAN, |[x], row| {
        Some(row.truth[0].ulps(math::atan(x)))
    });
    hold::<T, _, _>(kept, "math::atan2", ATAN2, |[y, x], row| {
        Some(row.truth[0].ulps(math::atan2(y, x)))
    });
    hold::<T, _, _>(kept, "math::atan2_degrees", ATAN2, |[y, x], row| {
        Some(row.truth[1].ulps(math::atan2_degrees(y, x)))
    });
    hold::<T, _, _>(kept, "math::cbrt", CBRT, |[x], row| {
        Some(row.truth[0].ulps(math::cbrt(x)))
    });
}

fn positions<T: Single>(kept: &mut bool) {
    hold::<T, _, _>(kept, "LatLon to Direction", DIRECTION, |[lat, lon], row| {
        let [x, y, z] = place(lat, lon)?.to_direction().to_array();
        Some(length([
            row.truth[0].error(x),
            row.truth[1].error(y),
            row.truth[2].error(z),
        ]))
    });
    hold::<T, _, _>(kept, "Direction to LatLon", LAT_LON, |[x, y, z], row| {
        let place = Direction::new(x, y, z).ok()?.to_lat_lon();
        Some(maximum(row.truth[0].ulps(place.lat()), row.truth[1].ulps(place.lon())))
    });
    let earth = Ellipsoid::<T>::WGS84;
    let to_ecef = |[lat, lon, h]: [T; 3], row: &Row<3, 3>| {
        let point = earth.to_ecef(Geodetic::new(place(lat, lon)?, h).ok()?);
        let [x, y, z] = point.to_array();
        Some(length([
            row.truth[0].error(x),
            row.truth[1].error(y),
            row.truth[2].error(z),
        ]))
    };
    hold::<T, _, _>(kept, "Ellipsoid::to_ecef below 100 km", TO_ECEF, |given, row| {
        if row.given[2] < 1e5 { to_ecef(given, row) } else { None }
    });
    hold::<T, _, _>(kept, "Ellipsoid::to_ecef to 50 000 km", TO_ECEF, to_ecef);
    let to_geodetic = |[x, y, z]: [T; 3], row: &Row<3, 3>| {
        let found = earth.to_geodetic(Ecef::new(x, y, z).ok()?);
        let [lat, lon, h] = &row.truth;
        let ([along, across], cos) = radii(lat.value());
        Some(length([
            lat.error(found.lat()).to_radians() * (along + h.value()),
            lon.turn(found.lon()).to_radians() * (across + h.value()) * cos,
            h.error(found.height()),
        ]))
    };
    let low = "Ellipsoid::to_geodetic below 100 km, down to the centre";
    hold::<T, _, _>(kept, low, TO_GEODETIC, |given, row| {
        if row.truth[2].value() < 1e5 {
            to_geodetic(given, row)
        } else {
            None
        }
    });
    hold::<T, _, _>(kept, "Ellipsoid::to_geodetic to 50 000 km", TO_GEODETIC, to_geodetic);
}

/// The radii of curvature along the meridian and across it in metres, and the cosine, at a latitude in degrees.
fn radii(lat: f64) -> ([f64; 2], f64) {
    let earth = Ellipsoid::<f64>::WGS84;
    let (sin, cos) = math::sin_cos_degrees(lat);
    let square = 1.0 - earth.e2() * sin * sin;
    let across = earth.a() / sqrt(square);
    ([across * (1.0 - earth.e2()) / square, across], cos)
}

/// The Earth's geodetic latitude of another: once in the image, not once for each claim.
#[inline(never)]
fn geodetic<T: Single>(from: Latitude, value: T) -> Option<T> {
    let conversion = Conversion::new(Ellipsoid::WGS84, from, Latitude::Geodetic).ok()?;
    conversion.radians(value).ok()
}

fn latitudes<T: Single>(kept: &mut bool) {
    let earth = Ellipsoid::<T>::WGS84;
    let conversion = |from, to| Conversion::new(earth, from, to).ok();
    let angles = [
        Latitude::Geocentric,
        Latitude::Parametric,
        Latitude::Authalic,
        Latitude::Conformal,
        Latitude::Rectifying,
    ];
    hold::<T, _, _>(kept, "latitude of a geodetic one", LATITUDES, |[phi], row| {
        let mut worst = 0.0_f64;
        for (latitude, truth) in angles.into_iter().zip(&row.truth) {
            worst = maximum(
                worst,
                truth.error(conversion(Latitude::Geodetic, latitude)?.radians(phi).ok()?),
            );
        }
        Some(worst)
    });
    let isometric = "isometric latitude, relative to 1 or more";
    hold::<T, _, _>(kept, isometric, LATITUDES, |[phi], row| {
        let truth = &row.truth[5];
        let found = conversion(Latitude::Geodetic, Latitude::Isometric)?.radians(phi).ok()?;
        truth
            .value()
            .is_finite()
            .then(|| truth.error(found) / maximum(truth.value().abs(), 1.0))
    });
    for (what, of_isometric) in [
        ("geodetic latitude of another", false),
        ("geodetic latitude of an isometric one", true),
    ] {
        hold::<T, _, _>(kept, what, GEODETIC, |[value], row| {
            let from = row.word.parse().ok()?;
            if (from == Latitude::Isometric) != of_isometric {
                return None;
            }
            Some(row.truth[0].error(geodetic(from, value)?))
        });
    }
}

/// In `f32` an error of a geodesic may grow by 1.5e-7 of the distance before it counts.
fn beyond_rounding<T: Single>(error: f64, distance: f64) -> f64 {
    let allowed = if T::INDEX == 1 { 1.5e-7 * distance.abs() } else { 0.0 };
    maximum(error - allowed, 0.0)
}

fn geodesics<T: Single>(kept: &mut bool) {
    let earth = Ellipsoid::<T>::WGS84;
    let (Ok(karney), Ok(vincenty), Ok(area), Ok(sphere)) = (
        Karney::new(earth),
        Vincenty::new(earth),
        Area::new(earth),
        GreatCircle::new(T::ONE),
    ) else {
        *kept = false;
        return;
    };
    hold::<T, _, _>(
        kept,
        "GreatCircle distance, relative",
        GREAT_CIRCLE,
        |[a, b, c, d], row| {
            let found = sphere.inverse(place(a, b)?, place(c, d)?).ok()?.distance;
            let (truth, error) = (row.truth[0].value(), row.truth[0].error(found));
            Some(if truth == 0.0 { error } else { error / truth })
        },
    );
    hold::<T, _, _>(kept, "Vincenty inverse, distance", INVERSE, |[a, b, c, d], row| {
        let found = vincenty.inverse(place(a, b)?, place(c, d)?).ok()?;
        Some(row.truth[0].error(found.distance))
    });
    hold::<T, _, _>(kept, "Karney inverse, distance", INVERSE, |[a, b, c, d], row| {
        let found = karney.inverse(place(a, b)?, place(c, d)?).ok()?;
        Some(beyond_rounding::<T>(
            row.truth[0].error(found.distance),
            row.truth[0].value(),
        ))
    });
    hold::<T, _, _>(
        kept,
        "Karney inverse, azimuth times length",
        INVERSE,
        |[a, b, c, d], row| {
            let found = karney.inverse(place(a, b)?, place(c, d)?).ok()?;
            let [s12, azi1, azi2, m12, _] = &row.truth;
            let turn = maximum(azi1.turn(found.azimuth1), azi2.turn(found.azimuth2));
            (row.word == "unique").then(|| turn.to_radians() * minimum(m12.value().abs(), s12.value()))
        },
    );
    // Near conjugate points the reduced length and the area are as ill-conditioned as the azimuths.
    let well = |row: &Row<4, 5>| {
        let (s12, m12) = (row.truth[0].value(), row.truth[3].value().abs());
        row.word == "unique" && (s12 < 1e6 || m12 > 0.1 * s12)
    };
    hold::<T, _, _>(kept, "Karney inverse, reduced length", INVERSE, |[a, b, c, d], row| {
        let found = karney.solve(place(a, b)?, place(c, d)?).reduced_length;
        well(row).then(|| row.truth[3].error(found))
    });
    hold::<T, _, _>(kept, "Karney area under a line", INVERSE, |[a, b, c, d], row| {
        let found = area.under(place(a, b)?, place(c, d)?);
        well(row).then(|| row.truth[4].error(found))
    });
    hold::<T, _, _>(
        kept,
        "Karney direct, position",
        DIRECT,
        |[lat, lon, azimuth, distance], row| {
            let end = karney.direct(place(lat, lon)?, azimuth, distance).ok()?.position;
            let [lat2, lon2] = &row.truth;
            let ([along, across], cos) = radii(lat2.value());
            let cos = if row.word == "pole_end" { 0.0 } else { cos };
            let error = length([
                lat2.error(end.lat()).to_radians() * along,
                lon2.turn(end.lon()).to_radians() * across * cos,
            ]);
            let s12 = row.given[3];
            let once = s12.abs() <= 1.01 * core::f64::consts::TAU * 6_378_137.0;
            once.then(|| beyond_rounding::<T>(error, s12))
        },
    );
}

fn jacobians<T: Single>(kept: &mut bool) {
    hold::<T, _, _>(kept, "Ground::jacobian, area, relative", JACOBIAN, |[_, x, y], row| {
        let projection: Projection = row.word.parse().ok()?;
        let sphere = Ellipsoid::sphere(T::ONE).ok()?;
        let ground = Ground::new(CubeMap::new(sphere, Shift::Geodetic, projection).ok()?);
        let face = Face::from_index(row.given[0] as u8).ok()?;
        let found = ground.jacobian(FacePoint::new(face, x, y).ok()?).ok()?.area();
        Some(row.truth[0].error(found) / row.truth[0].value())
    });
}

fn projections<T: Single>(kept: &mut bool, projection: Projection, forward: &[Row<3, 3>], inverse: &[Row<3, 3>]) {
    let name = projection.name();
    let claim = CLAIMS_OF_PROJECTIONS.iter().find(|(claim, _)| *claim == name);
    let [there, back] = claim.map_or([[f64::NAN; 2]; 2], |(_, claimed)| *claimed);
    judge::<T, _, _>(
        kept,
        format_args!("{name} forward"),
        there[T::INDEX],
        forward,
        |[x, y, z], row| {
            let point = projection.project(Direction::new(x, y, z).ok()?);
            let [face, x, y] = &row.truth;
            // On an edge the rounding of the input decides.
            let same = f64::from(point.face().index()) == face.value();
            same.then(|| maximum(x.error(point.x()), y.error(point.y())))
        },
    );
    judge::<T, _, _>(
        kept,
        format_args!("{name} inverse"),
        back[T::INDEX],
        inverse,
        |[_, x, y], row| {
            let face = Face::from_index(row.given[0] as u8).ok()?;
            let [x, y, z] = projection.unproject(FacePoint::new(face, x, y).ok()?).to_array();
            Some(length([
                row.truth[0].error(x),
                row.truth[1].error(y),
                row.truth[2].error(z),
            ]))
        },
    );
}
