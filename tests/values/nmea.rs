//! A `LatLon` as fields of NMEA 0183.

use terrella::{LatLon, NmeaLatLon, ParseNmeaError};

fn written(lat: f64, lon: f64, digits: u8) -> String {
    LatLon::new(lat, lon).unwrap().to_nmea(digits).to_string()
}

fn read(text: &str) -> Result<(f64, f64), ParseNmeaError> {
    let place = text.parse::<NmeaLatLon>()?.to_lat_lon();
    Ok((place.lat(), place.lon()))
}

#[test]
fn rounding_carries() {
    assert_eq!(written(9.999_999, -9.999_999, 2), "1000.00,N,01000.00,W");
    assert_eq!(written(59.999_999, 179.999_999_99, 4), "5959.9999,N,18000.0000,E");
    assert_eq!(written(-0.0, 93.6, 0), "0000,S,09336,E");
    assert_eq!(written(90.0, -180.0, 12), "9000.000000000000,N,18000.000000000000,W");
    let place = LatLon::new(1.0 / 3.0, 0.0).unwrap();
    assert_eq!(place.to_nmea(255), place.to_nmea(NmeaLatLon::MAX_DIGITS));
}

/// Issues of other parsers: kosma/minmea 17, kevingoos/NMEAParser 7, semuconsulting/pynmeagps 37,
/// adafruit/Adafruit_GPS 50 and 126, panaaj/nmeasimulator 32.
#[test]
fn sentences_of_receivers() {
    for (text, lat, lon) in [
        (
            "0612.62977,N,07533.94743,W",
            6.0 + 12.629_77 / 60.0,
            -(75.0 + 33.947_43 / 60.0),
        ),
        (
            "5050.10288,N,00419.91808,E",
            50.0 + 50.102_88 / 60.0,
            4.0 + 19.918_08 / 60.0,
        ),
        (
            "4124.8963,N,08151.6838,W",
            41.0 + 24.8963 / 60.0,
            -(81.0 + 51.6838 / 60.0),
        ),
        (
            "2348.3822990,S,15313.5862807,E",
            -(23.0 + 48.382_299 / 60.0),
            153.0 + 13.586_280_7 / 60.0,
        ),
        ("4533.35,N,16708.033,E", 45.0 + 33.35 / 60.0, 167.0 + 8.033 / 60.0),
        ("4533,S,00000.,W", -45.55, -0.0),
        ("9000.0,N,18000.0,W", 90.0, -180.0),
    ] {
        let (a, b) = read(text).unwrap();
        assert!((a - lat).abs() <= 1e-14 && (b - lon).abs() <= 3e-14, "{text} {a} {b}");
    }
    assert_eq!(written(0.0, 93.6, 2), "0000.00,N,09336.00,E");
}

#[test]
fn nothing_is_guessed() {
    let unexpected = |at, found| ParseNmeaError::Unexpected { at, found };
    for (text, why) in [
        ("", unexpected(0, None)),
        (",,,", unexpected(0, Some(','))),
        // Without its leading zeros, or with one too many: ktuukkan/marine-api, issue 99.
        ("4426.291992,N,159.931976,W", unexpected(17, Some('.'))),
        ("02348.3822990,S,15313.5862807,E", unexpected(4, Some('8'))),
        ("4723.81,n,00832.73,E", unexpected(8, Some('n'))),
        ("4723.81,E,00832.73,N", unexpected(8, Some('E'))),
        ("4723.81N,00832.73,E", unexpected(7, Some('N'))),
        ("-4723.81,N,00832.73,E", unexpected(0, Some('-'))),
        ("4723.8.1,N,00832.73,E", unexpected(6, Some('.'))),
        (" 4723.81,N,00832.73,E", unexpected(0, Some(' '))),
        ("4723.81,N,00832.73,E,1", unexpected(20, Some(','))),
        ("4723.81,N,00832.73,E\r\n", unexpected(20, Some('\r'))),
        ("4723.81,N,00832.73,", unexpected(19, None)),
        ("4723.81,N", unexpected(9, None)),
        ("47é3.81,N,00832.73,E", unexpected(2, Some('é'))),
        ("4760.0,N,00832.73,E", ParseNmeaError::NotBelow60 { at: 2 }),
        ("4723.81,N,00899,E", ParseNmeaError::NotBelow60 { at: 13 }),
        ("9000.01,N,00832.73,E", ParseNmeaError::OutOfRange { at: 0 }),
        ("4723.81,N,18000.000000000001,W", ParseNmeaError::OutOfRange { at: 10 }),
        ("4723.0123456789012,N,00832.73,E", unexpected(17, Some('2'))),
    ] {
        assert_eq!(read(text), Err(why), "{text}: {why}");
    }
}

#[test]
fn what_is_written_is_read_again() {
    let mut rng = fastrand::Rng::with_seed(62);
    for _ in 0..20_000 {
        let digits = rng.u8(0..=9);
        let place = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0).unwrap();
        let text = place.to_nmea(digits).to_string();
        let back = text.parse::<NmeaLatLon>().unwrap().to_lat_lon::<f64>();
        let half = 0.5 / 60.0 / 10_f64.powi(digits.into()) + 6e-14;
        assert!(
            (back.lat() - place.lat()).abs() <= half && (back.lon() - place.lon()).abs() <= half,
            "{place} {text}"
        );
        assert_eq!(back.to_nmea(digits).to_string(), text);
        assert_eq!(text.parse(), Ok(place.to_nmea(digits)));
        // Half of the last decimal, and the rounding of the scalar.
        let single = text.parse::<NmeaLatLon>().unwrap().to_lat_lon::<f32>();
        assert!((f64::from(single.lon()) - back.lon()).abs() <= 180.0 * f64::from(f32::EPSILON));
    }
}
