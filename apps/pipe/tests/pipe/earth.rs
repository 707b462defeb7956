//! Geodesics by every method, frames about an origin, every latitude.

use terrella::Latitude;
use terrella::geodesic::Method;

use crate::run::{answers, complaint, in_place, numbers};

#[test]
fn geodesics_and_positions() {
    // The worked example of GeographicLib: Wellington to Salamanca.
    let pair = "-41.32 174.81 40.96 -5.5";
    let row = &numbers(&answers("geodesic-inverse", pair))[0];
    let expected = [19_959_679.267_353_82, 161.067_669_986_16, 18.825_195_123_25];
    assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-8), "{row:?}");
    for method in Method::ALL {
        let there = answers(
            &format!("geodesic-direct --method {method} --about 40,-75"),
            "40 -75 30 10000",
        );
        let row = &numbers(&there)[0];
        assert!(
            (row[0] - 40.077_98).abs() < 3e-4 && (row[1] + 74.941_38).abs() < 3e-4,
            "{method}: {there}"
        );
        let back = format!("40 -75 {} {}", row[0], row[1]);
        let distance = numbers(&answers(
            &format!("geodesic-inverse --method {method} --about 40,-75"),
            back,
        ))[0][0];
        assert!((distance - 10_000.0).abs() < 0.05, "{method}: {distance}");
    }
    in_place(
        "geodesic-direct",
        "40 -75 30 10000",
        &[
            (b"40 -75 nan 1", "azimuth NaN is not finite"),
            (b"40 -75 0 inf", "distance inf is not finite"),
        ],
    );
    assert_eq!(
        answers("to-ecef", "90 0 100\n0 90 -7\n"),
        "0.0\t0.0\t6356852.314245179\n0.0\t6378130.0\t0.0\n"
    );
    let row = &numbers(&answers("from-ecef", "0 0 6356852.314245179"))[0];
    assert!(row[..2] == [90.0, 0.0] && (row[2] - 100.0).abs() < 1e-9, "{row:?}");
    assert_eq!(
        answers("to-enu --origin 0,90,5 --ellipsoid 1000,0", "0 90 12"),
        "0.0\t0.0\t7.0\n"
    );
    let enu = answers("to-enu --origin -40,-75,0", "-40.1 -75.2 100");
    let back = &numbers(&answers("from-enu --origin -40,-75,0", enu))[0];
    assert!((back[0] + 40.1).abs() < 1e-13 && (back[1] + 75.2).abs() < 1e-13 && (back[2] - 100.0).abs() < 1e-8);
    assert!(complaint("to-enu --origin 1,2").contains("3 numbers"));
    assert!(complaint("to-enu --origin 91,0,0").contains("latitude 91.0 is not in"));
    assert!(complaint("geodesic-inverse --method bessel").contains("karney"));
    assert!(complaint("geodesic-inverse --method plane").contains("plane needs a place"));
}

#[test]
fn places_in_rings() {
    let ring = "0 0 0 10 10 10 10 0";
    let lines = ["1 1", "-1 1", "0 5", "10 10", "10.03 5", "10.04 5"].map(|place| format!("{place} {ring}\n"));
    // On the sphere the northern edge rises to 10.037°.
    assert_eq!(
        answers("contains", lines.concat()),
        "inside\noutside\nedge\nedge\ninside\noutside\n"
    );
    assert_eq!(
        answers("contains --ellipsoid 1000,0 --scalar f32", "1 1 0 0 0 2 2 1\n1 1\n"),
        "inside\noutside\n"
    );
}

#[test]
fn latitudes_are_in_degrees_or_in_radians() {
    for kind in Latitude::ALL.iter().filter(|&&k| k != Latitude::Isometric) {
        let degrees = numbers(&answers(
            &format!("latitude --from geodetic --to {kind}"),
            "-90\n0\n52.5",
        ));
        let radians = answers(
            &format!("latitude --radians --from geodetic --to {kind}"),
            format!("{}\n0\n{}", -std::f64::consts::FRAC_PI_2, 52.5_f64.to_radians()),
        );
        assert_eq!((degrees[0][0], degrees[1][0]), (-90.0, 0.0), "{kind}");
        for (degrees, radians) in degrees.iter().zip(numbers(&radians)) {
            assert!(
                (degrees[0].to_radians() - radians[0]).abs() < 5e-16,
                "{kind}: {degrees:?}, {radians:?}"
            );
        }
    }
    assert_eq!(
        answers("latitude --from geodetic --to authalic", "45"),
        "44.87170287343394\n"
    );
}

#[test]
fn the_isometric_latitude_of_a_pole_is_infinite() {
    assert_eq!(
        answers("latitude --from geodetic --to isometric", "90\n-90\n0"),
        "inf\n-inf\n0.0\n"
    );
    assert_eq!(
        answers("latitude --from isometric --to rectifying", "inf\n-inf\n0"),
        "90.0\n-90.0\n0.0\n"
    );
    let radians = answers(
        "latitude --from isometric --to conformal --radians --scalar f32",
        "inf\n-infinity",
    );
    assert_eq!(radians, "1.5707964\n-1.5707964\n");
    // Dimensionless, whatever the unit of the other.
    let degrees = numbers(&answers("latitude --from isometric --to geodetic", "0.75"));
    let radians = numbers(&answers("latitude --from isometric --to geodetic --radians", "0.75"));
    assert!((degrees[0][0].to_radians() - radians[0][0]).abs() < 5e-16);
}

/// A rhumb line and its way back; to a pole it is a meridian, and beyond there is nothing.
#[test]
fn rhumb_lines_end_at_poles() {
    let line = &numbers(&answers("rhumb-inverse", "21.3 -157.9 35.4 139.7"))[0];
    assert!(
        (line[0] - 6_290_482.155).abs() < 1e-3 && (line[1] + 75.615_997_7).abs() < 1e-7,
        "{line:?}"
    );
    let end = &numbers(&answers("rhumb-direct", format!("21.3 -157.9 {} {}", line[1], line[0])))[0];
    assert!(
        (end[0] - 35.4).abs() < 1e-13 && (end[1] - 139.7).abs() < 1e-12,
        "{end:?}"
    );
    assert_eq!(
        answers("rhumb-inverse --ellipsoid 1,0", "90 10 90 20"),
        "0.0\t0.0\t0.17453292519943295\n"
    );
    in_place(
        "rhumb-direct",
        "0 0 0 1000",
        &[
            (
                b"0 0 0 2e7",
                "distance 20000000.0 is longer than 10001965.729312722 metres",
            ),
            (b"0 0 inf 1", "azimuth inf is not finite"),
        ],
    );
    assert!(complaint("rhumb-inverse --ellipsoid 1,0.2").contains("flattening 0.2"));
}

/// Text comes back; what is not text of a place is refused, with the place of what is wrong.
#[test]
fn places_as_text_come_back() {
    let place = "-33.868820125 151.209290500\n";
    let [lat, lon] = [-33.868_820_125, 151.209_290_5];
    for (there, back, most) in [
        ("dms", "from-dms", 1e-13),
        ("nmea", "from-nmea", 1e-11),
        ("geohash", "from-geohash", 2e-7),
        ("plus-code --digits 15", "from-plus-code", 1e-7),
    ] {
        let text = answers(there, place);
        let row = &numbers(&answers(back, text.clone()))[0];
        assert!(
            (row[0] - lat).abs() <= most && (row[1] - lon).abs() <= most,
            "{text} {row:?}"
        );
    }
    assert_eq!(
        answers("dms --decimals 1", "59.99999999 -0.5"),
        "60°00′00.0″N\t0°30′00.0″W\n"
    );
    in_place(
        "from-geohash",
        "ezs42",
        &[(b"ezs4a", "'a' at index 4 is no letter of geohashes")],
    );
    in_place(
        "from-plus-code",
        "8FVC2222+22",
        &[(b"2222+22", "a short plus code needs a place to which it is near")],
    );
    in_place(
        "web-mercator-tile",
        "3 0 0",
        &[(
            b"3 86 0",
            "latitude 86.0 is beyond the tiles, which end at 85.05112877980659",
        )],
    );
    in_place(
        "from-nmea",
        "4723.81,N,00832.73,E",
        &[(
            b"4723.81,N,832.73,E",
            "expected fields of latitude and longitude, got '.' at byte 13",
        )],
    );
}
