//! Geohashes, plus codes, tiles of Web Mercator and fields of NMEA 0183.

use terrella::NmeaLatLon;
use terrella::grid::web_mercator::{self, Quadkey, Tile};
use terrella::grid::{Geohash, PlusCode};
use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties! { geohashes plus_codes web_tiles text }

/// A cell holds its place, its text is read again, its neighbours' neighbour it is.
fn geohashes<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (place, length) = (bytes.place::<T>(), bytes.byte() % 12 + 1);
    let cell = Geohash::containing(place, length).unwrap();
    let [lat, lon]: [f64; 2] = [place.lat().into(), place.lon().into()];
    let lon = if lon == 180.0 { -180.0 } else { lon };
    let [south, west, north, east] = cell.bounds::<f64>();
    let context = || format!("{} {place:?} {cell:?}", T::NAME);
    assert!(south <= lat && (lat < north || north == 90.0), "{}", context());
    assert!(west <= lon && lon < east, "{}", context());
    assert_eq!(cell.to_string().parse(), Ok(cell), "{}", context());
    for (other, back) in cell.neighbours().into_iter().zip([4, 5, 6, 7, 0, 1, 2, 3]) {
        if let Some(other) = other {
            assert_eq!(other.neighbours()[back], Some(cell), "{}", context());
        }
    }
}

/// Text is read again, in small letters too; a short code is recovered.
fn plus_codes<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (place, near) = bytes.pair::<T>();
    let length = bytes.choice(&[2, 4, 6, 8, 10, 11, 12, 13, 14, 15]);
    let code = PlusCode::containing(place, length).unwrap();
    let text = code.to_string();
    let context = || format!("{} {place:?} {near:?} {text}", T::NAME);
    assert_eq!(text.to_lowercase().parse(), Ok(code), "{}", context());
    assert_eq!(
        PlusCode::containing(code.centre::<f64>(), length),
        Ok(code),
        "{}",
        context()
    );
    if let Some(short) = code.shortened(near) {
        let short = short.to_string();
        assert!(text.ends_with(&short) && short.len() < text.len(), "{}", context());
        assert_eq!(PlusCode::recovered(&short, near), Ok(code), "{}", context());
    }
}

/// A tile holds its place up to rounding; parents and children, keys and texts lead back.
fn web_tiles<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (place, zoom) = (bytes.place::<T>(), bytes.byte() % 31);
    let context = || format!("{} {place:?} {zoom}", T::NAME);
    let Ok(tile) = Tile::containing(place, zoom) else {
        assert!(place.lat().abs() > T::of(85.0511), "{}", context());
        return;
    };
    let [lat, lon]: [f64; 2] = [place.lat().into(), place.lon().into()];
    let lon = if lon == 180.0 { -180.0 } else { lon };
    let [south, west, north, east] = tile.bounds::<f64>();
    let rounding = 180.0 * T::EPSILON.into();
    assert!(
        south - rounding <= lat && lat <= north + rounding,
        "{} {tile}",
        context()
    );
    assert!(west <= lon && lon < east, "{} {tile}", context());
    assert_eq!(tile.to_string().parse(), Ok(tile), "{}", context());
    assert_eq!(tile.quadkey().to_string().parse(), Ok(tile.quadkey()), "{}", context());
    for child in tile.children().into_iter().flatten() {
        assert_eq!(child.parent(), Some(tile), "{}", context());
    }
    let back = web_mercator::from_plane(web_mercator::to_plane(place)).unwrap();
    let apart = Into::<f64>::into(back.lat()) - lat;
    assert!(apart.abs() <= 2.0 * rounding, "{} {back:?}", context());
    let any = [bytes.anything::<T>(), bytes.anything()];
    let answered = web_mercator::from_plane(any).is_ok();
    assert!(
        answered || !any[0].is_finite() || !(any[1] == T::ZERO || any[1].abs() > T::ZERO) || any[0].abs() > T::of(1e37),
        "{any:?}"
    );
}

/// Any text is answered, and what is accepted is written as what is read again.
fn text<T: Scalar>(bytes: &mut Bytes<'_>) {
    let letters = b"0123456789+./,NSEW bcdefghjkmnpqrstuvwxyzCFGHJMPQRVX\xc3\xa9";
    let mut text = Vec::new();
    for _ in 0..bytes.byte() % 32 {
        text.push(bytes.choice(letters));
    }
    let text = String::from_utf8_lossy(&text).into_owned();
    if let Ok(cell) = text.parse::<Geohash>() {
        assert_eq!(cell.to_string(), text.to_lowercase());
    }
    if let Ok(code) = text.parse::<PlusCode>() {
        assert_eq!(code.to_string().parse(), Ok(code), "{text}");
    }
    if let Ok(code) = PlusCode::recovered(&text, bytes.place::<T>()) {
        assert_eq!(code.to_string().parse(), Ok(code), "{text}");
    }
    if let Ok(tile) = text.parse::<Tile>() {
        assert_eq!(tile.to_string().parse(), Ok(tile), "{text}");
    }
    if let Ok(Quadkey(tile)) = text.parse::<Quadkey>() {
        assert_eq!(Quadkey(tile).to_string(), text);
    }
    if let Ok(fields) = text.parse::<NmeaLatLon>() {
        let place = fields.to_lat_lon::<f64>();
        assert!(place.lat().abs() <= 90.0 && place.lon().abs() <= 180.0, "{text}");
    }
    let place = bytes.place::<f64>();
    let fields = place.to_nmea(bytes.byte() % 13);
    assert_eq!(fields.to_string().parse(), Ok(fields), "{place:?} {fields}");
}
