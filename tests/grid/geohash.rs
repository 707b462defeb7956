//! Geohashes: letters of GeographicLib, boundaries by whole numbers, and reports of other libraries.

use fastrand::Rng;
use terrella::LatLon;
use terrella::grid::{Geohash, InvalidGeohash};

fn hash(lat: f64, lon: f64, length: u8) -> String {
    Geohash::containing(LatLon::new(lat, lon).unwrap(), length)
        .unwrap()
        .to_string()
}

/// GeographicLib 2.1.2, `Geohash::Forward`; ±90 and ±180 too.
#[test]
fn letters_are_those_of_geographiclib() {
    for (lat, lon, letters) in [
        (57.64911, 10.40744, "u4pruydqqvj8"),
        (0.0, 0.0, "s00000000000"),
        (-1e-300, 0.0, "kpbpbpbpbpbp"),
        (0.0, -1e-300, "ebpbpbpbpbpb"),
        (90.0, 180.0, "bpbpbpbpbpbp"),
        (90.0, -180.0, "bpbpbpbpbpbp"),
        (-90.0, -180.0, "000000000000"),
        (-90.0, 179.999999999, "pbpbpbpbpbpb"),
        (0.0, -180.0, "800000000000"),
        (42.6, -5.6, "ezs42e44yx96"),
        (45.0, 90.0, "y00000000000"),
        (38.534413, -121.794529, "9qc7hqzzjz0z"),
    ] {
        for length in 1..=12 {
            assert_eq!(hash(lat, lon, length), letters[..length.into()], "{lat} {lon}");
        }
    }
}

/// A boundary, at any depth, belongs to the cell north and east of it; the numbers next to it do not.
#[test]
fn boundaries_are_exact() {
    let mut rng = Rng::with_seed(22);
    for _ in 0..20_000 {
        let length = rng.u8(1..=12);
        let here = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0).unwrap();
        let cell = Geohash::containing(here, length).unwrap();
        let [south, west, north, east] = cell.bounds::<f64>();
        assert!(south <= here.lat() && here.lat() < north && west <= here.lon() && here.lon() < east);
        let at = |lat: f64, lon: f64| Geohash::containing(LatLon::new(lat, lon).unwrap(), length).unwrap();
        assert_eq!(at(south, west), cell);
        assert_eq!(at(north.next_down(), east.next_down()), cell);
        if south > -90.0 {
            assert_eq!(Some(at(south.next_down(), west)), cell.neighbour(-1, 0));
        }
        if north < 90.0 {
            assert_eq!(Some(at(north, west)), cell.neighbour(1, 0));
        }
        if west > -180.0 {
            assert_eq!(Some(at(south, west.next_down())), cell.neighbour(0, -1));
        }
        assert_eq!(Some(at(south, east)), cell.neighbour(0, 1));
        let centre = cell.centre::<f64>();
        assert_eq!(
            (centre.lat(), centre.lon()),
            ((south + north) / 2.0, (west + east) / 2.0)
        );
        assert_eq!(cell.to_string().parse(), Ok(cell));
        assert_eq!(cell.to_string().to_uppercase().parse(), Ok(cell));
        if let Some(parent) = cell.parent() {
            assert_eq!(parent.to_string(), cell.to_string()[..usize::from(length) - 1]);
        }
        // The same of numbers that f32 has.
        let single = LatLon::new(here.lat() as f32, here.lon() as f32).unwrap();
        let double = LatLon::new(f64::from(single.lat()), f64::from(single.lon())).unwrap();
        assert_eq!(Geohash::containing(single, length), Geohash::containing(double, length));
    }
    assert_eq!("s".parse::<Geohash>().unwrap().parent(), None);
}

/// Neighbours across 180 degrees and at poles: Ironholds/geohash, issue 7; sunng87/node-geohash, issue 33;
/// tammoippen/geohash-hilbert, issue 5.
#[test]
fn neighbours_go_round_and_end_at_poles() {
    let around = |text: &str| {
        let cell: Geohash = text.parse().unwrap();
        cell.neighbours()
            .map(|cell| cell.map_or_else(|| "none".to_owned(), |cell| cell.to_string()))
    };
    assert_eq!(
        around("xzrbx"),
        ["xzrbz", "8p20b", "8p208", "8p202", "xzrbr", "xzrbq", "xzrbw", "xzrby"]
    );
    assert_eq!(
        around("8p208"),
        ["8p20b", "8p20c", "8p209", "8p203", "8p202", "xzrbr", "xzrbx", "xzrbz"]
    );
    assert_eq!(around("r"), ["x", "8", "2", "0", "p", "n", "q", "w"]);
    assert_eq!(around("u"), ["none", "none", "v", "t", "s", "e", "g", "none"]);
    assert_eq!(around("00")[3..6], ["none"; 3]);
    let cell: Geohash = "ezs42".parse().unwrap();
    assert_eq!(cell.neighbour(i32::MAX, 0), None);
    assert_eq!(
        cell.neighbour(0, i32::MIN).unwrap().neighbour(0, i32::MIN),
        cell.neighbour(0, 0)
    );
}

/// transitland/geohash, issue 4: the letter a.
#[test]
fn other_letters_are_refused() {
    for (text, why) in [
        ("", InvalidGeohash::Length(0)),
        ("0123456789bcd", InvalidGeohash::Length(13)),
        ("a", InvalidGeohash::Letter { at: 0, found: 'a' }),
        ("ezs4i", InvalidGeohash::Letter { at: 4, found: 'i' }),
        ("ezL", InvalidGeohash::Letter { at: 2, found: 'L' }),
        ("eoz", InvalidGeohash::Letter { at: 1, found: 'o' }),
        ("e ", InvalidGeohash::Letter { at: 1, found: ' ' }),
        ("zé", InvalidGeohash::Letter { at: 1, found: 'é' }),
        (
            "\u{212a}",
            InvalidGeohash::Letter {
                at: 0,
                found: '\u{212a}',
            },
        ),
    ] {
        assert_eq!(text.parse::<Geohash>(), Err(why), "{why}");
    }
    for length in [0, 13, 255] {
        let refused = Geohash::containing(LatLon::<f32>::default(), length);
        assert_eq!(refused, Err(InvalidGeohash::Length(length.into())));
    }
}
