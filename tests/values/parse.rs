//! A `LatLon` from text.

use std::fmt::Write as _;

use terrella::{InvalidLatLon, LatLon, ParseLatLonError};

fn parsed(text: &str) -> LatLon {
    text.parse().unwrap_or_else(|why| panic!("{text:?}: {why}"))
}

fn refused(text: &str) -> ParseLatLonError<f64> {
    match text.parse::<LatLon>() {
        Ok(place) => panic!("{text:?} is {place}"),
        Err(why) => why,
    }
}

fn bits(place: LatLon) -> [u64; 2] {
    [place.lat().to_bits(), place.lon().to_bits()]
}

#[test]
fn many_spellings_of_one_place() {
    let oslo = LatLon::new(59.91, 10.75).unwrap();
    for text in [
        "59.91, 10.75",
        "59.91,10.75",
        "59.91 10.75",
        "  59.91\t10.75\n",
        "59.91;10.75",
        "+59.91 +10.75",
        "+59.91+10.75",
        "59.910 010.750",
        "59.91N 10.75E",
        "59.91 N 10.75 E",
        "59.91n10.75e",
        "N59.91 E10.75",
        "N 59.91, E 10.75",
        "N59.91E10.75",
        "N 59.91 10.75 E",
        "N59.91 10.75",
        "59.91 10.75E",
        "59.91 10.75 E",
        "59.91N, 10.75",
        "59.91, E10.75",
        "10.75E 59.91N",
        "E10.75 N59.91",
        "10.75E, 59.91",
        "59.91°, 10.75°",
        "59.91° N, 10.75° E",
        "59°54.6′N 10°45′E",
        "59°54′36″N 10°45′00″E",
        "59° 54′ 36″ N, 10° 45′ 0″ E",
        "59°54’36”N 10°45’00”E",
        "59º54'36\"N 10º45'0\"E",
        "59°54'36''N 10°45'00''E",
        "59d54'36\"N 10d45'00\"E",
        "59D54'36\"n, 10D45'e",
        "59 54 36 N 10 45 00 E",
        "59 54 36 N, 10 45 00 E",
        "59 54 36N 10 45E",
        "N 59 54 36 E 10 45 00",
        "59 54 36 10 45 00",
        "59 54 36, 10 45",
        "59 54.6 10 45",
        "59:54:36, 10:45",
        "59:54:36 10:45:00",
        "59:54:36N 010:45:00E",
        "59:54.6 10.75",
        "59°54′36″ 10°45′00″",
        "59° 54′ 36″ 10° 45′ 00″",
        "59°54′36″10°45′00″",
        "59°54′36.0″, 10°44′60.0″",
    ] {
        assert_eq!(parsed(text), oslo, "{text:?}");
    }
}

#[test]
fn hemispheres_and_signs() {
    let sydney = LatLon::new(-33.87, 151.21).unwrap();
    for text in [
        "-33.87 151.21", "\u{2212}33.87, 151.21", "33.87S 151.21E", "S33.87 E151.21", "E151.21 S33.87",
    ] {
        assert_eq!(parsed(text), sydney, "{text:?}");
    }
    let lima = LatLon::new(-12.05, -77.05).unwrap();
    for text in [
        "-12.05-77.05", "-12.05 -77.05", "-12 3 -77 3", "12°3′S 77°3′W", "77:03W 12:03S",
    ] {
        assert_eq!(parsed(text), lima, "{text:?}");
    }
    // −0 keeps its sign.
    assert_eq!(bits(parsed("-0 0")), bits(LatLon::new(-0.0, 0.0).unwrap()));
    assert_eq!(bits(parsed("0S 0W")), bits(LatLon::new(-0.0, -0.0).unwrap()));
    // The longitude is wrapped, as by `new`.
    assert_eq!(parsed("0, 539"), LatLon::new(0.0, 539.0).unwrap());
}

#[test]
fn refusals_say_where() {
    let at = |at, found| ParseLatLonError::Unexpected { at, found };
    for (text, why) in [
        ("", ParseLatLonError::Undivided),
        ("garbage", ParseLatLonError::Undivided),
        ("59.91", ParseLatLonError::Undivided),
        ("59.91 E 10.75", ParseLatLonError::Undivided),
        ("59.91 E10.75", ParseLatLonError::Undivided),
        ("59 54 36", ParseLatLonError::Undivided),
        ("1 2 3 4 5", ParseLatLonError::Undivided),
        ("59.91,", at(6, None)),
        (",10.75", at(0, Some(','))),
        ("59,91,10,75", at(5, Some(','))),
        // The letter is east.
        ("1e-7, 0", at(2, Some('-'))),
        ("0, 1E7", at(5, Some('7'))),
        ("nan, 0", at(1, Some('a'))),
        ("0, inf", at(3, Some('i'))),
        ("59.91m 10.75", at(5, Some('m'))),
        ("59..91, 10.75", at(3, Some('.'))),
        ("59.5 30, 10", at(5, Some('3'))),
        ("1 2 3 4, 5", at(6, Some('4'))),
        ("59°54°, 10", at(6, Some('°'))),
        ("59″54′, 10", at(5, Some('5'))),
        ("59°°, 10", at(4, Some('°'))),
        ("59:, 10", at(3, Some(','))),
        ("59:54:36:1, 10", at(9, Some('1'))),
        ("-59.91S, 10.75", at(6, Some('S'))),
        ("S-59.91, 10.75", at(1, Some('-'))),
        ("--59.91, 10.75", at(1, Some('-'))),
        ("- 59.91, 10.75", at(1, Some(' '))),
        ("59.91NN, 10.75", at(6, Some('N'))),
        ("59.91N5, 10.75", at(6, Some('5'))),
        ("(59.91, 10.75)", at(0, Some('('))),
        ("59.91N 10.75N", ParseLatLonError::SameAxis),
        ("59.91W, 10.75E", ParseLatLonError::SameAxis),
        ("59°60′, 10", ParseLatLonError::NotBelow60(60.0)),
        ("59:59:60, 10", ParseLatLonError::NotBelow60(60.0)),
        ("59:61.5, 10", ParseLatLonError::NotBelow60(61.5)),
        ("90.5, 10", ParseLatLonError::OutOfRange(InvalidLatLon::Latitude(90.5))),
        (
            "10.75, 100N",
            ParseLatLonError::OutOfRange(InvalidLatLon::Latitude(100.0)),
        ),
        (
            "90°0′0.001″ 10",
            ParseLatLonError::OutOfRange(InvalidLatLon::Latitude(90.0 + 1.0 / 3_600_000.0)),
        ),
    ] {
        assert_eq!(refused(text), why, "{text:?}");
    }
    let far = format!("0, 1{:0400}", 0);
    assert_eq!(
        refused(&far),
        ParseLatLonError::OutOfRange(InvalidLatLon::Longitude(f64::INFINITY))
    );
    let said = |text| refused(text).to_string();
    assert_eq!(
        said("59.91m 10.75"),
        "expected latitude and longitude, got 'm' at byte 5"
    );
    assert_eq!(
        said("59.91,"),
        "expected latitude and longitude, got the end of the text at byte 6"
    );
    assert_eq!(said("59.91"), "expected two angles with a comma between them");
    assert_eq!(
        said("5N 6N"),
        "expected one of N, S and one of E, W, got two of the same"
    );
    assert_eq!(said("5:60 6"), "expected minutes and seconds below 60, got 60.0");
    assert_eq!(said("91 6"), "latitude 91.0 is not in [-90, 90] degrees");
}

/// `GeographicLib`'s tests of `DMS::Decode` (`tests/CMakeLists.txt`, `signtest.cpp`). It takes −0S for +0; a minus sign
/// beside a letter is refused here, as are its `nan` and `inf`.
#[test]
fn geographiclib_cases() {
    assert_eq!(parsed("33.3 44.4"), LatLon::new(33.3, 44.4).unwrap());
    assert_eq!(
        parsed("30d30'30\" 30.50833"),
        LatLon::new(30.0 + 1830.0 / 3600.0, 30.50833).unwrap()
    );
    // A point alone is no number.
    assert_eq!(
        refused("5d. 0"),
        ParseLatLonError::Unexpected {
            at: 2,
            found: Some('.')
        }
    );
    // Decimals are rounded once.
    assert_eq!(parsed("0 179.99999999999998578").lon(), 179.999_999_999_999_97);
    for text in ["5d70.0 10", "5d60 10"] {
        assert!(matches!(refused(text), ParseLatLonError::NotBelow60(_)), "{text}");
    }
    assert_eq!(parsed("5d59 10"), LatLon::new(5.0 + 59.0 / 60.0, 10.0).unwrap());
    for text in ["5d60. 10", "5d60.0 10"] {
        assert_eq!(parsed(text), LatLon::new(6.0, 10.0).unwrap());
    }
    assert_eq!(parsed("49d01'N 2d33'E"), LatLon::new(2941.0 / 60.0, 2.55).unwrap());
    assert_eq!(
        parsed("40d38'23\"N 073d46'44\"W"),
        LatLon::new(146_303.0 / 3600.0, -265_604.0 / 3600.0).unwrap()
    );
    assert_eq!(parsed("7:33:36 0").lat(), 7.56);
    for (text, zero) in [(" +0 ", 0.0), ("-0  ", -0.0), (" +0N", 0.0), ("+0S ", -0.0)] {
        let lat = parsed(&format!("{text}, 1")).lat();
        assert_eq!(lat.to_bits(), f64::to_bits(zero), "{text:?}");
    }
    for text in [" nan", "+inf", "-inf", "-0N ", " -0S"] {
        refused(&format!("{text}, 1"));
    }
}

/// Whole seconds are a quotient of whole numbers, which a division rounds once.
#[test]
fn whole_seconds_are_correctly_rounded() {
    for seconds in (0..=324_000_u32).step_by(7).chain(320_000..=324_000) {
        let text = format!("{}:{}:{}, 0", seconds / 3600, seconds / 60 % 60, seconds % 60);
        assert_eq!(parsed(&text).lat(), f64::from(seconds) / 3600.0, "{text}");
        let single: LatLon<f32> = text.parse().unwrap();
        assert_eq!(single.lat(), seconds as f32 / 3600.0, "{text}");
    }
}

/// Decimal seconds against a division of whole numbers below 2⁵³: the last number is rounded before the division.
#[test]
fn decimal_seconds_are_within_an_ulp_and_a_half() {
    let mut rng = fastrand::Rng::with_seed(60);
    let mut different = 0;
    for i in 0..100_000 {
        let micro = rng.u64(0..if i % 2 == 0 { 324_000_000_000 } else { 60_000_000 });
        let (seconds, fraction) = (micro / 1_000_000, micro % 1_000_000);
        let text = format!(
            "{}:{}:{}.{fraction:06} 0",
            seconds / 3600,
            seconds / 60 % 60,
            seconds % 60
        );
        let nearest = micro as f64 / 3_600_000_000.0;
        let double = parsed(&text).lat();
        assert!((double - nearest).abs() <= nearest.next_up() - nearest, "{text}");
        different += u32::from(double != nearest);
        let single: LatLon<f32> = text.parse().unwrap();
        let (single, ulp) = (
            f64::from(single.lat()),
            f64::from(single.lat().next_up() - single.lat()),
        );
        assert!((single - nearest).abs() <= 1.5 * ulp, "{text}");
    }
    assert!(different < 15_000, "{different}");
}

/// How many random inputs are tried.
const CASES: u32 = 4000;

fn place(rng: &mut fastrand::Rng) -> LatLon<f64> {
    LatLon::new(90.0 * (2.0 * rng.f64() - 1.0), 180.0 * (2.0 * rng.f64() - 1.0)).unwrap()
}

#[test]
fn no_text_panics() {
    let mut rng = fastrand::Rng::with_seed(21);
    for _ in 0..CASES {
        let any = (0..rng.usize(0..=40)).map(|_| rng.char(..));
        let text: String = any.filter(|character| !character.is_control()).collect();
        let _ = text.parse::<LatLon>();
        let _ = text.parse::<LatLon<f32>>();
    }
}

#[test]
fn no_text_of_the_alphabet_panics_and_what_is_read_is_in_range() {
    let alphabet: Vec<char> = "0123456789.,;:+-NSEWnsewdD°′″'\" ".chars().collect();
    let mut rng = fastrand::Rng::with_seed(22);
    for _ in 0..CASES {
        let text: String = (0..rng.usize(0..=24)).filter_map(|_| rng.choice(&alphabet)).collect();
        if let Ok(place) = text.parse::<LatLon>() {
            assert!(place.lat().abs() <= 90.0 && place.lon().abs() <= 180.0, "{text}");
        }
    }
}

#[test]
fn what_is_written_is_read_bit_for_bit() {
    let mut rng = fastrand::Rng::with_seed(23);
    for _ in 0..CASES {
        let (place, small) = (place(&mut rng), 2_f64.powi(-rng.i32(0..1074)));
        for place in [place, LatLon::new(place.lat() * small, place.lon() * small).unwrap()] {
            assert_eq!(bits(parsed(&place.to_string())), bits(place));
            let single = place.to_f32();
            assert_eq!(single.to_string().parse(), Ok(single));
        }
    }
}

#[test]
fn degrees_minutes_and_seconds_come_back_within_half_a_digit() {
    let mut rng = fastrand::Rng::with_seed(24);
    for _ in 0..CASES {
        let (place, digits) = (place(&mut rng), rng.u8(0..10));
        let mut text = String::new();
        write!(text, "{}", place.to_dms(digits)).unwrap();
        let back = parsed(&text);
        let half = 0.5 / 3600.0 / 10_f64.powi(digits.into()) + 3e-14;
        let errors = [back.lat() - place.lat(), back.lon() - place.lon()];
        assert!(errors.into_iter().all(|error| error.abs() <= half), "{text}");
        assert_eq!(back.to_dms(digits), place.to_dms(digits));
    }
}
