use terrella::grid::{GridPosition, Hemisphere, Mgrs, OutsideMgrs, ParseMgrsError, TransverseMercator, UtmUps, Zone};
use terrella::{Ellipsoid, LatLon, Real};
use testkit::truth::Truth;

fn grid<T: Real>() -> UtmUps<T> {
    UtmUps::new(Ellipsoid::WGS84).unwrap()
}

fn parsed(text: &str) -> Mgrs {
    text.parse().unwrap_or_else(|why| panic!("{text}: {why}"))
}

#[test]
fn texts_are_those_of_geoconvert() {
    let grid = grid::<f64>();
    let truth = Truth::read("grid_geoconvert");
    let mut other = 0;
    for row in truth.exact_in::<f64>(&["lat", "lon"]) {
        let place = LatLon::new(row.input("lat"), row.input("lon")).unwrap();
        for (precision, column) in [(0, "mgrs0"), (5, "mgrs5"), (11, "mgrs11")] {
            let square = Mgrs::of(&grid, place, precision).unwrap();
            let (text, theirs) = (square.to_string(), parsed(row.text(column)));
            if precision < 11 {
                assert_eq!(text, row.text(column), "{place}");
            } else {
                // The last digits are micrometres; the numbers are good to nanometres.
                let [a, b] = [square, theirs].map(|square| square.south_west::<f64>());
                assert!(
                    (a.easting - b.easting).abs() < 1.5e-6 && (a.northing - b.northing).abs() < 1.5e-6,
                    "{text}"
                );
                other += u32::from(square != theirs);
            }
            assert_eq!(parsed(&text), square);
        }
    }
    println!(
        "{other} of {} differ in the last micrometre",
        truth.exact_in::<f64>(&["lat", "lon"]).len()
    );
    assert!(other <= 10, "{other}");
}

#[test]
fn what_is_wrong_is_told() {
    use ParseMgrsError as E;
    let cases = [
        ("", E::Unfinished),
        ("4", E::Unfinished),
        ("4Q", E::Unfinished),
        ("4QF", E::Unfinished),
        ("61QFJ", E::Zone(61)),
        ("0QFJ", E::Zone(0)),
        ("00QFJ", E::Zone(0)),
        ("004QFJ", E::Zone(4)),
        ("999QFJ", E::Zone(255)),
        ("4IFJ", E::Band('I')),
        ("4OFJ", E::Band('O')),
        ("4AFJ", E::Band('A')),
        ("4YFJ", E::Band('Y')),
        ("4ZFJ", E::Band('Z')),
        ("QFJ", E::Band('Q')),
        ("32XVAA", E::Column('V')),
        ("4QIJ", E::Column('I')),
        ("4QOJ", E::Column('O')),
        ("4QJJ", E::Column('J')),
        ("4QFI", E::Row('I')),
        ("4QFO", E::Row('O')),
        ("4QFW", E::Row('W')),
        ("4QFV", E::Inconsistent('Q', 'V')),
        ("4QFJ1", E::Odd(1)),
        ("4QFJ12345", E::Odd(5)),
        ("4QFJ 12 345", E::Odd(5)),
        ("4QFJ 1 2 3 4", E::Character(' ')),
        ("4QFJ123456789012345678901234", E::TooLong(24)),
        ("4QFJ12x4", E::Character('x')),
        ("4QFJ12.4", E::Character('.')),
        ("4QéJ", E::Character('é')),
        ("-4QFJ", E::Character('-')),
        ("４QFJ", E::Character('４')),
        ("4Q\tFJ", E::Character('\t')),
        ("INVALID", E::Band('I')),
        // The polar regions.
        ("AAA", E::Column('A')),
        ("YAA", E::Column('A')),
        ("ZKA", E::Column('K')),
        ("ZAQ", E::Row('Q')),
        ("ZDA", E::Column('D')),
        ("ZAO", E::Row('O')),
    ];
    for (text, why) in cases {
        assert_eq!(text.parse::<Mgrs>(), Err(why), "{text}");
        assert!(!why.to_string().is_empty());
    }
    assert_eq!(parsed(" 4q fj 1234 5678 "), parsed("04QFJ12345678"));
    assert_eq!(
        parsed("4QFJ 12345678"),
        parsed("4Q FJ 1234 5678").coarser(11).coarser(4)
    );
}

#[test]
fn corners_are_in_their_squares() {
    for text in [
        "4QFJ",
        "4QFJ12",
        "33XVG7459643593",
        "60CWA00000000009999999999",
        "ZAH",
        "YZG99",
        "BAN0000000000",
        "AZA1234",
    ] {
        corner::<f64>(text, 11);
        // In f32 down to metres.
        corner::<f32>(text, 5);
    }
}

fn corner<T: Real>(text: &str, finest: u8) {
    let square = parsed(text);
    let square = square.coarser(finest);
    let position = square.south_west::<T>();
    // Any latitude of the band: where the square is.
    let lat = grid::<T>().inverse(square.centre()).unwrap().lat();
    assert_eq!(Mgrs::new(position, lat, square.precision()).unwrap(), square, "{text}");
    let centre = square.centre::<T>();
    assert_eq!(
        Mgrs::new(centre, lat, square.precision().min(if finest == 5 { 4 } else { 11 })).unwrap(),
        square.coarser(if finest == 5 { 4 } else { 11 })
    );
    let half: f64 = square.width::<f64>() / 2.0;
    let [a, b]: [f64; 2] = [centre.easting, position.easting].map(Into::into);
    assert!((a - b - half).abs() <= 0.02, "{text}");
}

/// Every micrometre is its own: the corner of a square, rounded to the scalar, is in the square.
#[test]
fn digits_lead_back() {
    let mut rng = fastrand::Rng::with_seed(11);
    for _ in 0..20_000 {
        let precision = rng.u8(0..=11);
        let digits = |rng: &mut fastrand::Rng| {
            (0..precision)
                .map(|_| char::from(b'0' + rng.u8(0..10)))
                .collect::<String>()
        };
        let text = format!(
            "31U{}{}{}",
            ["DQ", "ES", "FT"][rng.usize(0..3)],
            digits(&mut rng),
            digits(&mut rng)
        );
        let square = parsed(&text);
        let lat = 50.0;
        assert_eq!(
            Mgrs::new(square.south_west::<f64>(), lat, precision)
                .unwrap()
                .to_string(),
            text
        );
        if precision <= 5 {
            assert_eq!(
                Mgrs::new(square.south_west::<f32>(), lat as f32, precision)
                    .unwrap()
                    .to_string(),
                text
            );
        }
    }
}

#[test]
fn upper_limits_belong_to_the_last_square() {
    let new = |zone, hemisphere, easting, northing, lat: f64| {
        Mgrs::new(
            GridPosition::new(Zone::new(zone).unwrap(), hemisphere, easting, northing),
            lat,
            3,
        )
    };
    use Hemisphere::{North, South};
    let cases = [
        (31, North, 9e5, 0.0, 0.0, "31NHA999000"),
        (31, North, 5e5, -0.0, 0.0, "31NEA000000"),
        (31, South, 5e5, 1e7, -0.0, "31MEV000999"),
        (31, South, 5e5, 10_000_000.1, 1e-6, "31NEA000000"),
        (31, South, 5e5, 9_999_999.5, -1e-9, "31MEV000999"),
        (31, North, 5e5, -0.5, -1e-9, "31MEV000999"),
        (31, North, 5e5, 9.5e6, 84.9, "31XEQ000999"),
        (31, South, 5e5, 1e6, -80.9, "31CEL000000"),
        (0, North, 2.7e6, 2.7e6, 84.0, "ZJP999999"),
        (0, North, 1.3e6, 1.3e6, 84.0, "YRA000000"),
        (0, South, 3.2e6, 3.2e6, -79.0, "BRZ999999"),
        (0, South, 8e5, 8e5, -79.0, "AJA000000"),
        (0, North, 2e6, 2e6, 90.0, "ZAH000000"),
        (0, South, 2e6, 2e6, -90.0, "BAN000000"),
    ];
    for (zone, hemisphere, easting, northing, lat, text) in cases {
        assert_eq!(
            new(zone, hemisphere, easting, northing, lat).map(|m| m.to_string()),
            Ok(text.into()),
            "{text}"
        );
    }
    assert_eq!(new(31, North, 99_999.0, 0.0, 0.0), Err(OutsideMgrs::Easting(99_999.0)));
    assert_eq!(
        new(31, North, 900_000.1, 0.0, 0.0),
        Err(OutsideMgrs::Easting(900_000.1))
    );
    assert_eq!(new(31, North, 5e5, 9.6e6, 84.0), Err(OutsideMgrs::Northing(9.6e6)));
    assert_eq!(new(0, North, 1.2e6, 2e6, 84.0), Err(OutsideMgrs::Easting(1.2e6)));
    assert_eq!(new(31, North, 5e5, 5e6, 10.0), Err(OutsideMgrs::Latitude(10.0)));
    assert!(matches!(
        new(31, North, f64::NAN, 5e6, 10.0),
        Err(OutsideMgrs::Easting(_))
    ));
    let place = LatLon::new(10.0, 10.0).unwrap();
    assert_eq!(Mgrs::of(&grid::<f64>(), place, 12), Err(OutsideMgrs::Precision(12)));
}

/// The rows of squares that a band may have are those that reach into it, computed from the projection.
#[test]
fn bands_have_the_rows_that_reach_into_them() {
    let map = TransverseMercator::<f64>::new(Ellipsoid::WGS84, 0.9996, 0.0).unwrap();
    let letters = "CDEFGHJKLMNPQRSTUVWX";
    let rows = "ABCDEFGHJKLMNPQRSTUV";
    let mut found = 0;
    for (index, band) in letters.chars().enumerate() {
        let (foot, head) = (8.0 * index as f64 - 80.0, 8.0 * index as f64 - 72.0);
        for column in 1..=8_u8 {
            for row in -90..=94_i32 {
                let [near, far] = if column < 5 {
                    [5 - (column + 1), 5 - column]
                } else {
                    [column - 5, column - 4]
                };
                let lat = |x: u8, y: i32| map.inverse([1e5 * f64::from(x), 1e5 * f64::from(y)]).unwrap().lat();
                // Where a square is farthest from the equator and where it is nearest.
                let corners = [(near, row), (near, row + 1), (far, row), (far, row + 1)].map(|(x, y)| lat(x, y));
                let low = corners.into_iter().reduce(testkit::minimum).unwrap();
                let high = corners.into_iter().reduce(testkit::maximum).unwrap();
                let reaches = (low < head || band == 'X') && (high > foot || band == 'C');
                let text = format!(
                    "31{band}{}{}",
                    &"ABCDEFGH"[usize::from(column) - 1..usize::from(column)],
                    &rows[row.rem_euclid(20) as usize..][..1]
                );
                let square = text.parse::<Mgrs>();
                let north = if band >= 'N' { 0.0 } else { 1e7 };
                let here =
                    square.is_ok_and(|square| (square.south_west::<f64>().northing - north) / 1e5 == f64::from(row));
                assert_eq!(here, reaches, "{text} {row}: {low} {high}");
                found += u32::from(here);
            }
        }
    }
    assert_eq!(found, 1632);
}

/// Bug reports of others: chrisveness/geodesy 73 and 28 (squares in two bands), NASAWorldWind/WorldWindJava 157 and
/// Tronald/CoordinateSharp 64 (the south polar region, there rounded), locationtech/geotrellis 2726 (leading zeros).
#[test]
fn bug_reports_of_others() {
    let grid = grid::<f64>();
    let there_and_back = |lat, lon, text: &str| {
        let square = parsed(text);
        assert_eq!(
            Mgrs::of(&grid, LatLon::new(lat, lon).unwrap(), square.precision()),
            Ok(square),
            "{text}"
        );
        let place = grid.inverse(square.centre()).unwrap();
        let width = 2e-5 * 10_f64.powi(5 - i32::from(square.precision()));
        assert!((place.lat() - lat).abs() < width, "{text}: {place}");
    };
    there_and_back(64.000_78, -171.459_95, "02WMR7750397182");
    there_and_back(-89.345_4, -48.930_6, "AZN4520747746");
    there_and_back(-80.5, 100.0, "BQL4099216444");
    there_and_back(0.001, 0.001, "31NAA6613200110");
    // GeographicLib's documentation, MGRS.
    there_and_back(33.3, 44.4, "38SMB4414084706");
}
