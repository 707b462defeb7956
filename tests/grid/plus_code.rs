//! Plus codes: cases of Google's `test_data` (open-location-code, Apache-2.0, commit 83986da), and laws.

use fastrand::Rng;
use terrella::LatLon;
use terrella::grid::{InvalidPlusCode, PlusCode};
use testkit::Worst;

/// Of `encoding.csv`: latitude, longitude, both as integers, number of digits, code.
const ENCODING: &str = "\
20.375,2.775,2759375000,1497292800,6,7FG49Q00+
20.3700625,2.7821875,2759251562,1497351680,10,7FG49QCJ+2V
20.3701125,2.782234375,2759252812,1497352064,11,7FG49QCJ+2VX
20.3701135,2.78223535156,2759252837,1497352071,13,7FG49QCJ+2VXGJ
47.0000625,8.0000625,3425001562,1540096512,10,8FVC2222+22
-41.2730625,174.7859375,1218173437,2906406400,10,4VCPPQGP+Q9
0.5,-179.5,2262500000,4096000,4,62G20000+
-89.5,-179.5,12500000,4096000,4,22220000+
20.5,2.5,2762500000,1495040000,4,7FG40000+
-89.9999375,-179.9999375,1562,512,10,22222222+22
0.5,179.5,2262500000,2945024000,4,6VGX0000+
1,1,2275000000,1482752000,11,6FH32222+222
90,1,4499999999,1482752000,4,CFX30000+
90,1,4499999999,1482752000,10,CFX3X2X2+X2
1,180,2275000000,0,4,62H20000+
1,181,2275000000,8192000,4,62H30000+
20.3701135,362.78223535156,2759252837,1497352071,13,7FG49QCJ+2VXGJ
47.0000625,728.0000625,3425001562,1540096512,10,8FVC2222+22
-41.2730625,1254.7859375,1218173437,2906406400,10,4VCPPQGP+Q9
20.3701135,-357.217764648,2759252837,1497352072,13,7FG49QCJ+2VXGJ
47.0000625,-711.9999375,3425001562,1540096512,10,8FVC2222+22
-41.2730625,-905.2140625,1218173437,2906406400,10,4VCPPQGP+Q9
1.2,3.4,2280000000,1502412800,10,6FH56C22+22
37.539669125,-122.375069724,3188491728,472063428,15,849VGJQF+VX7QR3J
37.539669125,-122.375069724,3188491728,472063428,16,849VGJQF+VX7QR3J
37.539669125,-122.375069724,3188491728,472063428,100,849VGJQF+VX7QR3J
35.6,3.033,3140000000,1499406336,10,8F75J22M+26
-48.71,142.78,1032250000,2644213760,8,4R347QRJ+
-70,163.7,500000000,2815590400,8,3V252P22+
-2.804,7.003,2179900000,1531928576,13,6F9952W3+C6222
13.9,164.88,2597500000,2825256960,12,7V56WV2J+2222
-13.23,172.77,1919250000,2889891840,8,5VRJQQCC+
40.6,129.7,3265000000,2537062400,8,8QGFJP22+
-52.166,13.694,945850000,1586741248,14,3FVMRMMV+JJ2222
-14,106.9,1900000000,2350284800,6,5PR82W00+
70.3,-87.64,4007500000,756613120,13,C62J8926+22222
66.89,-106,3922250000,606208000,10,95RPV2R2+22
2.5,-64.23,2312500000,948387840,11,67JQGQ2C+222
-56.7,-47.2,832500000,1087897600,14,38MJ8R22+222222
-34.45,-93.719,1388750000,706813952,6,46Q8H700+
-35.849,-93.75,1353775000,706560000,12,46P85722+C222
65.748,24.316,3893700000,1673756672,12,9GQ6P8X8+6C22
-57.32,130.43,817000000,2543042560,12,3QJGMCJJ+2222";

/// Of `decoding.csv`: code, number of digits, south, west, north, east.
const DECODING: &str = "\
7FG49Q00+,6,20.35,2.75,20.4,2.8
7FG49QCJ+2V,10,20.37,2.782125,20.370125,2.78225
7FG49QCJ+2VX,11,20.3701,2.78221875,20.370125,2.78225
7FG49QCJ+2VXGJ,13,20.370113,2.782234375,20.370114,2.78223632813
8FVC2222+22,10,47.0,8.0,47.000125,8.000125
4VCPPQGP+Q9,10,-41.273125,174.785875,-41.273,174.786
62G20000+,4,0.0,-180.0,1,-179
22220000+,4,-90,-180,-89,-179
7FG40000+,4,20.0,2.0,21.0,3.0
22222222+22,10,-90.0,-180.0,-89.999875,-179.999875
6VGX0000+,4,0,179,1,180
6FH32222+222,11,1,1,1.000025,1.00003125
CFX30000+,4,89,1,90,2
62H20000+,4,1,-180,2,-179
62H30000+,4,1,-179,2,-178
CFX3X2X2+X2,10,89.9998750,1,90,1.0001250
84000000+,2,30,-140,50,-120
6FH56C22+22,10,1.2000000000000028,3.4000000000000057,1.2001249999999999,3.4001250000000027
849VGJQF+VX7QR3J,15,37.5396691200,-122.3750698242,37.5396691600,-122.3750697021
849VGJQF+VX7QR3J7QR3J,15,37.5396691200,-122.3750698242,37.5396691600,-122.3750697021
5PVX2JXR+R6G29VC,15,-12.95044812,119.640568847656,-12.95044808,119.640568969727
55CJG366+PP,10,-21.48825,-107.93825,-21.488125,-107.938125
4MC8JQQF+GG,10,-41.36125,86.77375,-41.361125,86.773875
9R000000+,2,50,140,70,160
44X9MM00+,6,-30.35,-132.35,-30.3,-132.3
3C000000+,2,-70,-20,-50,0
65CQGXV4+J5FQPCF,15,-1.45593152,-104.04456628418,-1.45593148,-104.044566162109
4H94MH00+,6,-42.35,42.55,-42.3,42.6
CP9C0000+,4,77,108,78,109
85F6GC93+RFFVC35,15,39.519572,-115.596335083008,39.51957204,-115.596334960937
62VR8V49+M47GJQ7,15,7.30666364,-163.132201538086,7.30666368,-163.132201416016
CH3V0000+,4,71,57,72,58
45VR59QV+7C4JVF5,15,-32.8118556,-103.606434692383,-32.81185556,-103.606434570312
2JH70000+,4,-79,65,-78,66
8J7GRCCX+FMJWRQ,14,35.8212246,70.449142089844,35.8212248,70.449142578125
96QQM963+G8J,11,65.661325,-84.64675,65.66135,-84.64671875
3HX66C3H+8PQQQPQ,15,-50.79665628,44.429374389648,-50.79665624,44.429374511719
3MRGM4GH+56,10,-53.324625,90.128,-53.3245,90.128125
95000000+,2,50,-120,70,-100
4J86FVGW+9449,12,-43.52412,64.8953359375,-43.524115,64.89534375";

/// Of `shortCodeTests.csv`: full code, latitude, longitude, short code, and whether it is recovered,
/// shortened or both.
const SHORT: &str = "\
9C3W9QCJ+2VX,51.3701125,-1.217765625,+2VX,B
9C3W9QCJ+2VX,51.3708675,-1.217765625,CJ+2VX,B
9C3W9QCJ+2VX,51.3693575,-1.217765625,CJ+2VX,B
9C3W9QCJ+2VX,51.3701125,-1.218520625,CJ+2VX,B
9C3W9QCJ+2VX,51.3701125,-1.217010625,CJ+2VX,B
9C3W9QCJ+2VX,51.3852125,-1.217765625,9QCJ+2VX,B
9C3W9QCJ+2VX,51.3550125,-1.217765625,9QCJ+2VX,B
9C3W9QCJ+2VX,51.3701125,-1.232865625,9QCJ+2VX,B
9C3W9QCJ+2VX,51.3701125,-1.202665625,9QCJ+2VX,B
8FJFW222+,42.899,9.012,22+,B
796RXG22+,14.95125,-23.5001,22+,B
8FVC2GGG+GG,46.976,8.526,2GGG+GG,B
8FRCXGGG+GG,47.026,8.526,XGGG+GG,B
8FR9GXGG+GG,46.526,8.026,GXGG+GG,B
8FRCG2GG+GG,46.526,7.976,G2GG+GG,B
CFX22222+22,89.6,0.0,2222+22,R
2CXXXXXX+XX,-81.0,0.0,XXXXXX+XX,R
8FRCG2GG+GG,46.526,7.976,8FRCG2GG+GG,R
8FRCG2GG+GG,46.526,7.976,8frCG2GG+gG,R";

/// Of `validityTests.csv`: code, whether it is valid, short, full.
const VALIDITY: &str = "\
8FWC2345+G6,true,false,true
8FWC2345+G6G,true,false,true
8fwc2345+,true,false,true
8FWCX400+,true,false,true
84000000+,true,false,true
WC2345+G6g,true,true,false
2345+G6,true,true,false
45+G6,true,true,false
+G6,true,true,false
G+,false,false,false
+,false,false,false
8FWC2345+G,false,false,false
8FWC2_45+G6,false,false,false
8FWC2η45+G6,false,false,false
8FWC2345+G6+,false,false,false
8FWC2345G6+,false,false,false
8FWC2300+G6,false,false,false
WC2300+G6g,false,false,false
WC2345+G,false,false,false
WC2300+,false,false,false
84900000+,false,false,false
849VGJQF+VX7QR3J,true,false,true
849VGJQF+VX7QR3U,false,false,false
849VGJQF+VX7QR3JW,true,false,true
849VGJQF+VX7QR3JU,false,false,false";

fn rows(text: &str) -> impl Iterator<Item = Vec<&str>> {
    text.lines().map(|line| line.split(',').collect())
}

fn place(lat: &str, lon: &str) -> LatLon<f64> {
    LatLon::new(lat.parse().unwrap(), lon.parse().unwrap()).unwrap()
}

/// The reference rounds a product of degrees, and so some decimals fall below their integers: it allows 5 %
/// of them.
fn encoding(text: &str) {
    let (mut all, mut rounded) = (0, 0);
    for row in rows(text) {
        let [lat, lon, whole_lat, whole_lon] = [0, 1, 2, 3].map(|column| row[column].parse::<f64>().unwrap());
        let length = row[4].parse().unwrap();
        let code = |lat: f64, lon| {
            PlusCode::containing(LatLon::new(lat.clamp(-90.0, 90.0), lon).unwrap(), length)
                .unwrap()
                .to_string()
        };
        // The middle of the finest cell.
        let middle = [(whole_lat + 0.5) / 25e6 - 90.0, (whole_lon + 0.5) / 8_192_000.0 - 180.0];
        assert_eq!(code(middle[0], middle[1]), row[5], "{row:?}");
        let found = code(lat, lon);
        (all, rounded) = (all + 1, rounded + i32::from(found != row[5]));
        let shift = [lat * 25e6, lon * 8_192_000.0].map(f64::floor);
        let turned = |whole: f64| whole.rem_euclid(360.0 * 8_192_000.0);
        let known = lat.abs() < 90.0
            && (shift[0] + 90.0 * 25e6 != whole_lat || turned(shift[1] + 180.0 * 8_192_000.0) != whole_lon);
        assert!(found == row[5] || known, "{row:?} {found}");
    }
    println!("{rounded} of {all}");
    assert!(all < 100 || rounded * 20 <= all, "{rounded} of {all}");
}

fn decoding(text: &str) -> f64 {
    let mut worst = Worst::default();
    for row in rows(text) {
        let code: PlusCode = row[0].parse().unwrap();
        assert_eq!(code.length().to_string(), row[1]);
        for (found, expected) in code.bounds::<f64>().into_iter().zip(&row[2..]) {
            worst.add((found - expected.parse::<f64>().unwrap()).abs());
        }
        let centre = code.centre::<f64>();
        assert_eq!(PlusCode::containing(centre, code.length()), Ok(code));
    }
    worst.value()
}

#[test]
fn places_have_the_codes_of_the_reference() {
    encoding(ENCODING);
}

#[test]
fn codes_have_the_bounds_of_the_reference() {
    assert!(decoding(DECODING) <= 1e-10);
}

/// All of the reference's rows, from its repository: `OPEN_LOCATION_CODE=…/test_data`.
#[test]
#[ignore = "needs the reference's test data"]
fn all_rows_of_the_reference() {
    let folder = std::env::var("OPEN_LOCATION_CODE").unwrap();
    let read = |name: &str| {
        let text = std::fs::read_to_string(format!("{folder}/{name}.csv")).unwrap();
        let lines = text
            .lines()
            .filter(|line| !line.is_empty() && !line.starts_with('#') && !line.starts_with("92,"));
        lines.map(str::to_owned).collect::<Vec<_>>().join("\n")
    };
    encoding(&read("encoding"));
    assert!(decoding(&read("decoding")) <= 1e-10);
}

#[test]
fn codes_are_shortened_and_recovered() {
    for row in rows(SHORT) {
        let (near, full) = (place(row[1], row[2]), row[0].parse::<PlusCode>().unwrap());
        if row[4] != "S" {
            assert_eq!(PlusCode::recovered(row[3], near), Ok(full), "{row:?}");
        }
        if row[4] != "R" {
            assert_eq!(full.shortened(near).unwrap().to_string(), row[3], "{row:?}");
        }
    }
}

#[test]
fn validity_is_that_of_the_reference() {
    for row in rows(VALIDITY) {
        let parsed = row[0].parse::<PlusCode>();
        let (short, full) = (parsed == Err(InvalidPlusCode::Short), parsed.is_ok());
        assert_eq!(
            [(short || full).to_string(), short.to_string(), full.to_string()],
            row[1..],
            "{row:?} {parsed:?}"
        );
    }
}

#[test]
fn refusals_say_what_is_wrong() {
    for (text, why) in [
        ("8FWC2345", InvalidPlusCode::Separator { at: 8 }),
        ("", InvalidPlusCode::Separator { at: 0 }),
        ("+", InvalidPlusCode::Separator { at: 0 }),
        ("8FWC23451+G6", InvalidPlusCode::Separator { at: 9 }),
        ("8FWC2345+G6+", InvalidPlusCode::Separator { at: 11 }),
        ("8FWC2_45+G6", InvalidPlusCode::Digit { at: 5, found: '_' }),
        ("8FWC2η45+G6", InvalidPlusCode::Separator { at: 9 }),
        ("8FWCη45+G6", InvalidPlusCode::Digit { at: 4, found: 'η' }),
        ("8FWC2345+A6", InvalidPlusCode::Digit { at: 9, found: 'A' }),
        ("8FWC2300+G6", InvalidPlusCode::Padding { at: 9 }),
        ("8F0C0000+", InvalidPlusCode::Padding { at: 3 }),
        ("00000000+", InvalidPlusCode::Padding { at: 0 }),
        ("WC2300+", InvalidPlusCode::Padding { at: 4 }),
        ("8FWC2345+0", InvalidPlusCode::Padding { at: 9 }),
        ("8FWC2345+G", InvalidPlusCode::Length(9)),
        ("45+G6", InvalidPlusCode::Short),
        ("F2222222+22", InvalidPlusCode::OutOfRange),
        ("2X222222+22", InvalidPlusCode::OutOfRange),
    ] {
        assert_eq!(text.parse::<PlusCode>(), Err(why), "{text}: {why}");
    }
    for length in [0, 1, 3, 5, 7, 9] {
        let refused = PlusCode::containing(LatLon::<f32>::default(), length);
        assert_eq!(refused, Err(InvalidPlusCode::Length(length)));
    }
}

/// A cell holds its place, up to the rounding of the specification; text and code are each other's.
#[test]
fn a_cell_holds_its_place() {
    let mut rng = Rng::with_seed(23);
    for _ in 0..20_000 {
        let here = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0).unwrap();
        for length in [2, 4, 6, 8, 10, 11, 12, 13, 14, 15] {
            let code = PlusCode::containing(here, length).unwrap();
            let [south, west, north, east] = code.bounds::<f64>();
            let little = 1e-13;
            assert!((south - little..=north + little).contains(&here.lat()), "{here} {code}");
            assert!((west - little..=east + little).contains(&here.lon()), "{here} {code}");
            let text = code.to_string();
            assert_eq!(text.parse(), Ok(code));
            assert_eq!(text.to_lowercase().parse(), Ok(code));
            if let Some(short) = code.shortened(here) {
                assert_eq!(PlusCode::recovered(&short.to_string(), here), Ok(code));
            }
        }
    }
    // A place across 180 degrees is near.
    let code: PlusCode = "6VGX2X22+22".parse().unwrap();
    let near = LatLon::new(code.centre::<f64>().lat(), -179.95).unwrap();
    let short = code.shortened(near).unwrap().to_string();
    assert_eq!(PlusCode::recovered(&short, near), Ok(code));
    assert_eq!(
        "8FWC2345+".parse::<PlusCode>().unwrap().shortened(code.centre::<f64>()),
        None
    );
    let eight: PlusCode = "8FWC2345+".parse().unwrap();
    let short = eight.shortened(eight.centre::<f64>()).unwrap().to_string();
    assert_eq!(
        (short.as_str(), PlusCode::recovered(&short, eight.centre::<f64>())),
        ("45+", Ok(eight))
    );
}
