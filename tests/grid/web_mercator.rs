//! Web Mercator: tiles as mercantile and PROJ have them, and what a tile's bounds say.

use fastrand::Rng;
use terrella::LatLon;
use terrella::grid::web_mercator::{
    BeyondTiles, InvalidTile, LATITUDE_LIMIT, ParseTileError, Quadkey, Tile, from_plane, resolution, to_plane,
};
use testkit::Worst;

fn place(lat: f64, lon: f64) -> LatLon<f64> {
    LatLon::new(lat, lon).unwrap()
}

/// mercantile's tests, Google's example of Chicago, and the ends.
#[test]
fn tiles_are_those_of_others() {
    for (lat, lon, zoom, text) in [
        (41.850, -87.650, 7, "7/32/47"),
        (40.0, -105.0, 4, "4/3/6"),
        (-14.1, -170.6, 8, "8/6/138"),
        (85.0511, -180.0, 2, "2/0/0"),
        (-85.0511, 179.999, 2, "2/3/3"),
        (0.0, 0.0, 1, "1/1/1"),
        (0.0, 180.0, 1, "1/0/1"),
        (40.1222, 20.6852, 9, "9/285/193"),
        (LATITUDE_LIMIT, 0.0, 30, "30/536870912/0"),
        (-LATITUDE_LIMIT, 0.0, 30, "30/536870912/1073741823"),
    ] {
        let tile = Tile::containing(place(lat, lon), zoom).unwrap();
        assert_eq!(tile.to_string(), text, "{lat} {lon}");
        assert_eq!(text.parse(), Ok(tile));
    }
    assert_eq!("213".parse::<Quadkey>().unwrap().0.to_string(), "3/3/5");
    assert_eq!("0313102310".parse::<Quadkey>().unwrap().0.to_string(), "10/486/332");
    assert_eq!(Tile::new(0, 0, 0).unwrap().quadkey().to_string(), "");
    assert_eq!(Tile::new(0, 0, 0).unwrap().parent(), None);
    // mercantile: bounds of 486-332-10.
    let bounds = Tile::new(10, 486, 332).unwrap().bounds::<f64>();
    let expected = [53.120_405_283_106_57, -9.140_625, 53.330_872_983_017_05, -8.789_062_5];
    assert!(
        bounds.iter().zip(expected).all(|(a, b)| (a - b).abs() < 2e-14),
        "{bounds:?}"
    );
    assert!((resolution::<f64>(0, 0.0) - 156_543.033_928_041).abs() < 1e-8);
    assert!((resolution::<f32>(10, 60.0) - 76.437_03).abs() < 1e-4);
}

/// The formula with 40 digits.
#[test]
fn the_plane_is_as_accurate_as_claimed() {
    for (lat, lon, x, y) in [
        (52.51627, 13.3777, 1489198.751985176, 6894017.4435509965),
        (-33.86882, 151.20929, 16832541.166012435, -4011201.3286847872),
        (1e-09, -1e-09, -0.00011131949079327358, 0.00011131949079327358),
        (85.0, -179.999, -20037397.023298449, 19971868.880408563),
        (-89.99, 0.5, 55659.745396636786, -59613540.207253066),
    ] {
        let found: [f64; 2] = to_plane(place(lat, lon));
        let near = |found: f64, true_value: f64| (found - true_value).abs() <= 2e-16 * (1.0 + true_value.abs() * 3.0);
        assert!(near(found[0], x) && near(found[1], y), "{found:?} {x} {y}");
        let back = from_plane([x, y]).unwrap();
        assert!(
            (back.lat() - lat).abs() <= 5e-14 && (back.lon() - lon).abs() <= 6e-14,
            "{back}"
        );
    }
    let [x, y] = to_plane(place(LATITUDE_LIMIT, 180.0));
    assert!(
        (x - 20_037_508.342_789_244).abs() < 1e-8 && (y - 20_037_508.342_789_244).abs() < 4e-8,
        "{x} {y}"
    );
    assert_eq!(to_plane(place(90.0, 0.0))[1], f64::INFINITY);
    assert_eq!(from_plane([0.0, f64::NEG_INFINITY]), Ok(place(-90.0, 0.0)));
    assert!(from_plane([f64::INFINITY, 0.0]).is_err() && from_plane([0.0_f32, f32::NAN]).is_err());
    let wrapped = from_plane([25e6_f64, 0.0]).unwrap();
    assert!((wrapped.lon() - (25e6 / 6_378_137.0_f64).to_degrees() + 360.0).abs() < 1e-12);
}

#[test]
fn there_and_back() {
    let mut rng = Rng::with_seed(24);
    let mut worst = [Worst::default(), Worst::default()];
    for _ in 0..20_000 {
        let here = place(2.0 * LATITUDE_LIMIT * (rng.f64() - 0.5), 360.0 * rng.f64() - 180.0);
        let back = from_plane(to_plane(here)).unwrap();
        worst[0].add((back.lat() - here.lat()).hypot(back.lon() - here.lon()).to_radians() * 6.4e6);
        let single = LatLon::new(here.lat() as f32, here.lon() as f32).unwrap();
        let double = place(single.lat().into(), single.lon().into());
        let ([x, y], [a, b]) = (to_plane(double), to_plane(single).map(f64::from));
        worst[1].add((x - a).hypot(y - b));
        let zoom = rng.u8(0..=30);
        let tile = Tile::containing(here, zoom).unwrap();
        let [south, west, north, east] = tile.bounds::<f64>();
        let little = 1e-13;
        assert!(
            south - little <= here.lat() && here.lat() <= north + little,
            "{tile} {here}"
        );
        assert!(west <= here.lon() && here.lon() < east, "{tile} {here}");
        assert_eq!(tile.quadkey().to_string().parse(), Ok(tile.quadkey()));
        assert_eq!(tile.to_string().parse(), Ok(tile));
        if let Some(children) = tile.children() {
            assert!(children.iter().all(|child| child.parent() == Some(tile)));
            assert_eq!(children.map(|child| child.x() & 1 | (child.y() & 1) << 1), [0, 1, 2, 3]);
        }
    }
    let worst = worst.map(|worst| worst.value());
    println!("{worst:?}");
    assert!(worst[0] <= 6e-9 && worst[1] <= 4.0, "{worst:?}");
}

#[test]
fn refusals_say_what_is_wrong() {
    let above = LATITUDE_LIMIT.next_up();
    assert_eq!(Tile::containing(place(above, 0.0), 3), Err(BeyondTiles(above)));
    for (zoom, x, y) in [(31, 0, 0), (0, 1, 0), (3, 7, 8), (255, 0, 0)] {
        assert_eq!(Tile::new(zoom, x, y), Err(InvalidTile { zoom, x, y }));
    }
    let unexpected = |at, found| ParseTileError::Unexpected { at, found };
    for (text, why) in [
        ("", unexpected(0, None)),
        ("1/2", unexpected(3, None)),
        ("1/2/", unexpected(4, None)),
        ("1/+1/0", unexpected(2, Some('+'))),
        ("1/1/0 ", unexpected(5, Some(' '))),
        ("1/1/0/", unexpected(5, Some('/'))),
        ("3/99999999999/0", unexpected(2, Some('9'))),
        (
            "300/0/0",
            ParseTileError::Invalid(InvalidTile { zoom: 255, x: 0, y: 0 }),
        ),
        ("2/4/0", ParseTileError::Invalid(InvalidTile { zoom: 2, x: 4, y: 0 })),
    ] {
        assert_eq!(text.parse::<Tile>(), Err(why), "{text} {why}");
    }
    assert_eq!("0124".parse::<Quadkey>(), Err(unexpected(3, Some('4'))));
    assert_eq!("0".repeat(31).parse::<Quadkey>(), Err(unexpected(30, Some('0'))));
    assert!("0".repeat(30).parse::<Quadkey>().is_ok());
}
