//! A value from outside for every operation, in `f64` and in `f32`.

use crate::run::answers;

/// Where it comes from, the command, the line, and what comes back: right to the digits given. In `f32` the difference
/// is at most `single` of the value and of 1; 0 stands for text, the same in both precisions.
pub struct Case {
    source: &'static str,
    pub command: &'static str,
    pub line: &'static str,
    expected: &'static str,
    single: f64,
}

const fn case(
    source: &'static str,
    command: &'static str,
    line: &'static str,
    expected: &'static str,
    single: f64,
) -> Case {
    Case {
        source,
        command,
        line,
        expected,
        single,
    }
}

#[rustfmt::skip] // a table
pub const CASES: &[Case] = &[
    case("GeographicLib, GeodSolve0", "geodesic-inverse", "40.6 -73.8 49.01666667 2.55", "5853226 53.47022 111.59367", 1e-6),
    case("GeographicLib, GeodSolve1", "geodesic-direct", "40.63972222 -73.77888889 53.5 5850e3", "49.01467 2.56106 111.62947", 1e-5),
    case("GeographicLib, geodtest.c, line 1", "solve", "35.60777 -139.44815 -11.17491 -69.95921",
        "8935244.56048183 111.098748429560 129.289270889709 80.507297142820 6273170.205530 0.166063184474 0.164791169456 12841384694976.4", 1e-6),
    case("GeographicLib, geodtest.c, line 1", "line", "35.60777 -139.44815 111.098748429560326 8935244.5604818305",
        "-11.17491000000 -69.95921000000 129.289270889709 80.507297142820 6273170.205530 0.166063184474 0.164791169456 12841384694976.4", 2e-6),
    case("geo, line_locate_point", "line-between", "20 10 25 125 0.5", "37.722253780058 65.879360721333", 2e-6),
    case("GeographicLib, geodtest.c, line 1", "line-toward", "35.60777 -139.44815 -11.17491 -69.95921 8935244.5604818305",
        "-11.17491000000 -69.95921000000 129.289270889709 80.507297142820 6273170.205530 0.166063184474 0.164791169456 12841384694976.4", 2e-6),
    case("PROJ, builtins.gie, gnom", "gnomonic --ellipsoid 1,1/200", "0 0 80 10", "0.1763 5.7232", 1e-5),

    case("GeographicLib, Planimeter0", "polygon", "89 0 89 90 89 180 89 270", "24952305678 631819.875", 5e-3),
    case("GeographicLib, Planimeter19", "polygon", "", "0 0", 1e-7),
    case("GeographicLib, Planimeter29", "polygon-edges", "0 0 90 1000 0 1000 -90 1000", "1000000.0 4000.00", 1e-2),
    case("GeographicLib 2.1, AddEdge, longer than half way round", "polygon-edges", "10 20 45 25e6 120 30e6", "-251042298707393 69958237.938", 1e-5),
    case("GeographicLib, Planimeter10", "polyline", "90 0 0 0 0 90", "20020719.9", 1e-6),

    case("geo, haversine_destination", "gc-direct", "6371008.8 0 0 90 100000", "0.00000000000000 0.89932036372454 90", 1e-6),
    case("Turf, distance", "gc-inverse", "6371008.8 39.984 -75.343 39.123 -75.534", "97129.221189678", 1e-4),
    case("Turf, distance", "hav-inverse", "6371008.8 39.984 -75.343 39.123 -75.534", "97129.221189678", 1e-4),
    case("geo, cross_track_distance", "gc-xt", "6371008.8 53.2611 -0.7972 53.3206 -1.7297 53.1887 0.1334", "-307.549995", 1e-2),
    case("Veness's geodesy, alongTrackDistanceTo", "gc-at", "6371e3 53.2611 -0.7972 53.3206 -1.7297 53.1887 0.1334", "62331", 1e-4),
    case("Veness's geodesy, intermediatePointTo", "gc-frac", "52.205 0.119 48.857 2.351 0.25", "51.3721 0.7073", 1e-5),
    case("Veness's geodesy, midpointTo", "gc-mid", "52.205 0.119 48.857 2.351", "50.5363 1.2746", 1e-5),

    case("NGA.STND.0036, WGS 84", "radii", "",
        "6378137 6356752.3142 0.00335281066474748 0.0016792203863837 0.00669437999014 0.00673949674228 6371008.7714 6371000.7900 6371007.1809", 2e-7),
    case("EPSG 7004", "radii", "bessel1841", "6377397.155 6356078.963", 2e-7),
    case("PROJ, more_builtins.gie, geocent", "to-ecef --ellipsoid grs80", "1 2 0", "6373287.2795025 222560.095992 110568.774821", 1e-6),
    case("PROJ, 5201.gie", "from-ecef", "-962479.5924 555687.8517 6260738.6526", "80.0000000 150.0000000 1214.137", 1e-2),
    case("Go's S2, latlng_test.go", "direction", "-45 180", "-0.70710678118655 0.0000000000000 -0.70710678118655", 1e-6),
    case("Go's S2, latlng_test.go", "latlon", "1 1 1.4142135623730951", "45.000000000000 45.000000000000", 1e-6),
    case("Cesium, EllipsoidSpec", "up", "15 -45", "0.683012701892219 -0.683012701892219 0.258819045102521", 1e-6),
    case("Orekit, TopocentricFrameTest", "north", "90 0", "-1.000000000000000 0.000000000000000 0.000000000000000", 1e-6),
    case("Orekit, TopocentricFrameTest", "east", "90 0", "0.000000000000000 1.000000000000000 0", 1e-6),

    case("PROJ, more_builtins.gie, topocentric", "to-enu --origin 55,5,200", "53.80939444444444 2.12955 73", "-189013.869 -128642.040 -4220.171", 1e-4),
    case("PROJ, more_builtins.gie, topocentric", "from-enu --origin 55,5,200", "-189013.869 -128642.040 -4220.171", "53.8093944 2.1295500 73.000", 1e-2),
    case("map_3d, geodetic2enu", "geodetic-to-enu", "42 -82 200 42.002581974253744 -81.997751960067460 1139.701799575106", "186.27752082 286.84222785 939.6926208", 5e-2),
    case("NavPy, lla2ned", "geodetic-to-ned", "34.00000048333333 -117.33356934722222 251.702 34.00005343611111 -117.33354774444445 234.052",
        "5.874 1.996 17.650", 1.0),
    case("map_3d, geodetic2aer", "geodetic-to-aer", "42 -82 200 42.002581974253744 -81.997751960067460 1139.701799575106", "33.000000000 70.000000000 1000.0000000", 1e-1),
    case("nav-types, up of Oslo", "enu-to-geodetic", "59.95 10.75 0 0 0 100", "59.950000000 10.750000000 100.00000", 1e-1),
    case("pymap3d, test_ned.py", "ned-to-geodetic", "42.0 -82.0 200.0 286.84222278105 186.27748924553998 -939.6926207859084",
        "42.002581974 -81.997751960 1139.70180", 1e-3),
    case("pymap3d, test_aer.py", "aer-to-geodetic", "42.0 -82.0 200.0 33.0 77.0 1000.0", "42.0016982 -81.99852 1174.374035", 1e-3),
    case("PROJ, more_builtins.gie, topocentric", "ecef-to-enu", "55 5 200 3771793.968 140253.342 5124304.349", "-189013.869 -128642.040 -4220.171", 1e-3),
    case("pymap3d, test_ned.py", "ecef-to-ned", "42.0 -82.0 200.0 660930.19276 -4701424.22296 4246579.60463", "286.8422 186.2775 -939.6926", 5e-2),
    case("pymap3d, test_aer.py", "ecef-to-aer", "42.0 -82.0 200.0 660930.1927610816 -4701424.222957011 4246579.604632881", "33.0000 70.0000 1000.0000", 5e-2),
    case("map_3d, enu2ecef", "enu-to-ecef", "42 -82 200 186.277521 286.842220 939.692620", "660930.193 -4701424.223 4246579.605", 1e-6),
    case("pymap3d, test_ned.py", "ned-to-ecef", "42.0 -82.0 200.0 286.8422 186.2775 -939.6926", "660930.193 -4701424.223 4246579.605", 1e-6),
    case("map_3d, aer2ecef", "aer-to-ecef", "42 -82 200 33 70 1000", "660930.19276108 -4701424.22295701 4246579.60463288", 1e-6),
    case("pymap3d, test_enu.py", "vector-to-enu", "42 -82 5 3 2", "5.3688596465880 3.0085207636681 -0.3523477115241", 1e-6),
    case("pymap3d, test_ned.py", "vector-to-ned", "42 -82 5 3 2", "3.0085207636681 5.3688596465880 0.3523477115241", 1e-6),
    case("pymap3d, test_enu.py", "vector-from-enu", "42 -82 5.368859646588048 3.00852076366812 -0.352347711524077", "5.0000000000000 3.0000000000000 2.0000000000000", 1e-6),
    case("NavPy, ned2ecef", "vector-from-ned", "34.00000048333333 -117.33356934722222 0 0 1", "0.381 0.736 -0.559", 1e-4),
    case("pymap3d, test_aer.py", "enu-to-aer", "186.2775 286.8422 939.6926", "33.0000 70.0000 1000.000", 1e-5),
    case("pymap3d, test_aer.py", "ned-to-aer", "286.8422 186.2775 -939.6926", "33.0000 70.0000 1000.000", 1e-5),
    case("map_3d, aer2enu", "aer-to-enu", "33 70 1000", "186.2775208166 286.8422278517 939.6926207859", 1e-6),
    case("map_3d, aer2ned", "aer-to-ned", "33 70 1000", "286.8422278517 186.2775208166 -939.6926207859", 1e-6),

    case("pymap3d, test_latitude.py", "latitude --from geodetic --to authalic", "45", "44.8717029", 1e-6),

    case("PROJ, builtins.gie, qsc", "project --projection quadrilateralized --shift geocentric --ellipsoid grs80", "1 2", "0 0.0477629206 0.0257322586", 1e-6),
    case("PROJ, builtins.gie, qsc", "unproject --projection quadrilateralized --shift geocentric --ellipsoid grs80",
        "0 0.00003135711885774795994504 0.00001567855942887397997252", "0 0.001", 1e-3),
    case("S2, s2coords.h, its quadratic projection by hand", "forward --projection s2-quadratic", "3 1 0", "0 0.414213562373095 0.000000000000000", 1e-6),
    case("S2, s2coords.h, its quadratic projection by hand", "inverse --projection s2-quadratic", "0 0.41421356237309515 0",
        "0.948683298050514 0.316227766016838 0.000000000000000", 1e-6),
    case("Go's S2, stuv_test.go", "numbered --numbering s2 --projection tangential", "-4 1 2", "3 -0.500000000000000 -0.250000000000000", 1e-6),
    case("Go's S2, stuv_test.go", "from-numbered --numbering s2 --projection tangential", "0 1 0", "0.70710678118655 0.70710678118655 0.000000000000000", 1e-6),
    case("healpy 1.20, ang2pix", "healpix", "10 -77.125 12.3", "8433180", TEXT),
    case("healpy 1.20, pix2ang", "healpix-place", "10 1234567 0.5 0.5", "24.50127813520754 127.001953125000", 1e-6),
    case("healpy 1.20, pix2ang", "healpix-place", "3 500 0.5 0.5", "14.47751218592992 -78.75000000000000", 1e-6),
    case("Calabretta and Roukema 2007, equation 4", "healpix-plane", "0 90", "2.000000000000000 0.000000000000000", 1e-6),
    case("Calabretta and Roukema 2007, equation 4", "healpix-unplane", "1 1", "41.810314895778598 45.000000000000000", 1e-6),
    case("S2, s2coords_test.cc, STUV", "s2-st", "1.0 -0.98 0.0", "0 0.0075283379360 0.500000000000000", 1e-6),
    case("S2, s2coords_test.cc, STUV", "s2-xyz", "0 0.5 0.5", "1.000000000000000 0.000000000000000 0.000000000000000", 1e-6),

    case("Cesium, EllipsoidalOccluderSpec", "horizon", "0 7000000 0 0 -7000000 0 0", "1", 1e-9),
    case("Cesium, EllipsoidalOccluderSpec", "horizon", "0 7000000 0 0 6900000 0 0", "0", 1e-9),

    case("GeographicLib, signtest.cpp", "wrap", "-900", "-180", 1e-9),
    case("GeographicLib, signtest.cpp", "sincosd", "-810", "-1 0", 1e-9),
    case("GeographicLib, signtest.cpp", "atan2d", "0.0 -0.0", "180", 1e-9),

    case("S2 in C++, where four cells meet", "cell", "90 0 10", "5000010000000000", TEXT),
    case("S2, s2coords.h, the north for (0, 1, 1)", "cell-xyz", "0 1 1 0", "5000000000000000", TEXT),
    case("S2, s2coords_test.cc, STtoIJ", "cell-st", "0 9.313225746154785e-10 0.5 30", "0800000000000007", TEXT),
    case("Cesium, HilbertOrderSpec", "cell-ij", "0 3 0 2", "1f00000000000000", TEXT),
    case("Go's S2, cellid_test.go, CenterSiTi", "cell-info", "600000001234567", "3 28 3291 2526", TEXT),
    case("Go's S2, cellid_test.go, ParentChild", "cell-parent", "60000000123457 24", "6000000012345000", TEXT),
    case("Cesium, S2CellSpec", "cell-parent", "2ef59bd352c00000", "2ef59bd353000000", TEXT),
    case("Go's S2, cellid_test.go, ParentChild", "cell-tile-parent", "60000000123457", "60000000123454", TEXT),
    case("Go's S2, cellid_test.go, ParentChild", "cell-children", "60000000123457", "6000000012345640 60000000123456c0 6000000012345740 60000000123457c0", TEXT),
    case("Go's S2, cellid_test.go, ParentChild", "cell-range", "60000000123457", "6000000012345601 60000000123457ff", TEXT),
    case("Go's S2, cellid_test.go, Containment", "cell-contains", "80855c 80855dc", "1 1", TEXT),
    case("Go's S2, cellid_test.go, Containment", "cell-contains", "80855dc 80855c", "0 0", TEXT),
    case("Go's S2, cellid_test.go, EdgeNeighbors", "cell-edges-ordered", "3", "b000000000000000 7000000000000000 5000000000000000 1000000000000000", TEXT),
    case("Go's S2, cellid_test.go, AllNeighbors", "cell-all", "7 0", "3000000000000000 5000000000000000 9000000000000000 b000000000000000", TEXT),
    case("Go's S2, cellid_test.go, VertexNeighbors", "cell-vertex", "5000000000000001 5",
        "4554000000000000 4ffc000000000000 5004000000000000 5aac000000000000", TEXT),
    case("S2, the cube's corner (1, 1, 1)", "cell-corners", "1", "0.577350269189626 0.577350269189626 0.577350269189626", 1e-6),
    case("Go's S2, cell_test.go, Area", "cell-area", "1", "2.09439510239320", 1e-6),
    case("Go's S2, cellid_test.go, Tokens", "token", "876bee99", "876bee9900000000", TEXT),
    case("Go's S2, cellid_test.go, Tokens", "key", "094000000000000f", "094000000000000f", TEXT),
];

/// Compared as it is written, in both precisions.
const TEXT: f64 = 0.0;

/// Whether a number is the expected one to the digits given, and so much of it and of 1 beside.
fn agrees(found: &str, expected: &str, allowed: f64) -> bool {
    let (number, wanted): (f64, f64) = (found.parse().unwrap(), expected.parse().unwrap());
    let decimals = expected.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let half_digit = 0.5001 * 0.1_f64.powi(decimals as i32);
    (number - wanted).abs() <= half_digit + allowed * (1.0 + wanted.abs())
}

#[test]
fn every_value_from_outside_comes_back() {
    let mut wrong = String::new();
    for Case {
        source,
        command,
        line,
        expected,
        single,
    } in CASES
    {
        for scalar in ["f64", "f32"] {
            let answer = answers(&format!("{command} --scalar {scalar}"), format!("{line}\n"));
            let found: Vec<_> = answer.split_whitespace().collect();
            let expected: Vec<_> = expected.split_whitespace().collect();
            assert!(found.len() >= expected.len(), "{source}: {command}: {answer}");
            for (found, expected) in found.into_iter().zip(expected) {
                let allowed = if scalar == "f64" { 0.0 } else { *single };
                let right = if *single == TEXT {
                    found == expected
                } else {
                    agrees(found, expected, allowed)
                };
                if !right {
                    wrong += &format!("{source}: {command} --scalar {scalar} of {line}: {found} for {expected}\n");
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn help_lists_every_operation_and_each_has_a_value() {
    let help = answers("--help", "");
    let listed: Vec<_> = help
        .lines()
        .filter(|line| line.contains(" -> "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(listed.len() > 50, "{help}");
    for name in &listed {
        let tried = CASES.iter().any(|case| case.command.split(' ').next() == Some(name));
        assert!(tried, "{name} has no value from outside");
        let own = answers(&format!("{name} --help"), "");
        assert!(own.contains(" -> ") && own.contains("--scalar"), "{own}");
    }
    for case in CASES {
        assert!(
            listed.contains(&case.command.split(' ').next().unwrap()),
            "{}",
            case.command
        );
    }
}
