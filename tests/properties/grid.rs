//! Grids: what is projected comes back, hemispheres and sides of a meridian are mirror images, texts are read as they are
//! written, and nothing at all panics.

use terrella::geodesic::{Geodesic, Karney};
use terrella::grid::{
    AzimuthalEquidistant, Gnomonic, GridPosition, Hemisphere, LambertAzimuthal, Mgrs, PolarStereographic,
    TransverseMercator, UtmUps, Zone,
};
use terrella::{Ellipsoid, LatLon};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties! { transverse_mercator polar equal_area geodesic_maps utm_and_ups mgrs texts any }

fn value<T: Scalar>(x: T) -> f64 {
    x.into()
}

/// How far two places are apart, in radians.
fn apart<T: Scalar>(a: LatLon<T>, b: LatLon<T>) -> f64 {
    let vector = |p: LatLon<T>| {
        LatLon::new(value(p.lat()), value(p.lon()))
            .unwrap()
            .to_direction()
            .to_array()
    };
    testkit::vector::apart(vector(a), vector(b))
}

fn hemisphere(bytes: &mut Bytes<'_>) -> Hemisphere {
    bytes.choice(&[Hemisphere::North, Hemisphere::South])
}

fn is_place<T: Scalar>(place: LatLon<T>) -> bool {
    place.lat().abs() <= T::of(90.0) && place.lon().abs() <= T::of(180.0)
}

/// Up to 45° from the meridian a place comes back; east and west, north and south are mirror images.
fn transverse_mercator<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (ellipsoid, meridian) = (bytes.ellipsoid(-1.0 / 150.0, 1.0 / 150.0), bytes.within::<T>(180.0));
    let map = TransverseMercator::<T>::new(ellipsoid, T::ONE, meridian).unwrap();
    let (lat, step) = (bytes.within::<T>(90.0), bytes.within::<T>(45.0));
    let place = LatLon::new(lat, meridian + step).unwrap();
    let context = || format!("{} {ellipsoid:?} {meridian:?} {place:?}", T::NAME);
    let point = map.forward(place);
    let back = map.inverse(point).unwrap();
    let error = apart(place, back);
    assert!(
        is_place(back) && error <= 8.0 * value(T::EPSILON),
        "{}: {error:e}",
        context()
    );
    let local = map.point_scale(place);
    assert!(
        local.scale.is_finite() && local.convergence.abs() <= T::of(180.0),
        "{}",
        context()
    );
    let about = TransverseMercator::<T>::new(ellipsoid, T::ONE, T::ZERO).unwrap();
    let at = |lat, lon| about.forward(LatLon::new(lat, lon).unwrap());
    let [x, y] = at(lat, step);
    assert_eq!(
        [at(-lat, step), at(lat, -step), at(-lat, -step)],
        [[x, -y], [-x, y], [-x, -y]]
    );
}

/// A place comes back, about both poles; they are mirror images.
fn polar<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (ellipsoid, about) = (bytes.ellipsoid(-0.1, 0.1), hemisphere(bytes));
    let map = PolarStereographic::<T>::new(ellipsoid, T::ONE).unwrap();
    let place = bytes.place::<T>();
    let [x, y] = map.forward(about, place);
    let back = map.inverse(about, [x, y]).unwrap();
    let error = apart(place, back);
    // The other pole is drawn as if it were not quite that.
    let allowed = 6.0 * value(T::EPSILON)
        + if x.abs() + y.abs() > T::of(1e13) {
            [5e-14, 5e-8][T::CLAIM]
        } else {
            0.0
        };
    assert!(
        is_place(back) && error <= allowed,
        "{ellipsoid:?} {about:?} {place:?}: {error:e}"
    );
    let other = if about == Hemisphere::North {
        Hemisphere::South
    } else {
        Hemisphere::North
    };
    let mirrored = LatLon::new(-place.lat(), place.lon()).unwrap();
    assert_eq!(map.forward(other, mirrored), [x, -y]);
}

/// A place that is not next to the antipode comes back.
fn equal_area<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ellipsoid = bytes.ellipsoid(-0.1, 0.1);
    let (centre, place) = bytes.pair::<T>();
    let map = LambertAzimuthal::<T>::new(ellipsoid, centre).unwrap();
    let context = || format!("{} {ellipsoid:?} {centre:?} {place:?}", T::NAME);
    match map.forward(place) {
        Ok([x, y]) => {
            let rho = value(x).hypot(value(y)) / value(ellipsoid.authalic_radius());
            assert!(rho <= 2.0 + value(ellipsoid.f()).abs() + 1e-5, "{}: {rho}", context());
            if rho < 1.9 {
                let back = map.inverse([x, y]).unwrap();
                let error = apart(place, back);
                assert!(
                    is_place(back) && error <= 16.0 * value(T::EPSILON),
                    "{}: {error:e}",
                    context()
                );
            }
        }
        Err(why) => {
            assert_eq!(why.0, place);
            let antipode = LatLon::new(-centre.lat(), centre.lon() + T::of(180.0)).unwrap();
            assert!(apart(antipode, place) < [1e-6, 1e-2][T::CLAIM], "{}", context());
        }
    }
}

/// Distances are those of geodesics, and places come back.
fn geodesic_maps<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (centre, place) = bytes.pair::<T>();
    let ellipsoid = Ellipsoid::WGS84;
    let (equidistant, gnomonic) = (
        AzimuthalEquidistant::<T>::new(ellipsoid, centre).unwrap(),
        Gnomonic::<T>::new(ellipsoid, centre).unwrap(),
    );
    let context = || format!("{} {centre:?} {place:?}", T::NAME);
    let length = value(Karney::new(ellipsoid).unwrap().inverse(centre, place).unwrap().distance);
    let [x, y] = equidistant.forward(place);
    assert!(
        (value(x).hypot(value(y)) - length).abs() <= 2.0 * value(T::EPSILON) * length,
        "{}",
        context()
    );
    // Next to the antipode a turn of the azimuth moves the end by little, and a rounding of it by much.
    let error = apart(equidistant.inverse([x, y]).unwrap(), place);
    assert!(error <= 16.0 * value(T::EPSILON), "{}: {error:e}", context());
    match gnomonic.forward(place) {
        Ok(point) if length < 6.6e6 => {
            let error = apart(gnomonic.inverse(point).unwrap(), place);
            assert!(error <= 16.0 * value(T::EPSILON), "{}: {error:e}", context());
        }
        Ok(_) => assert!(length < 1.01e7, "{}", context()),
        Err(_) => assert!(length > 0.99e7, "{}", context()),
    }
}

/// Every place has a position in its zone, and comes back; so does one in a neighbouring zone.
fn utm_and_ups<T: Scalar>(bytes: &mut Bytes<'_>) {
    let grid = UtmUps::<T>::new(Ellipsoid::WGS84).unwrap();
    let place = bytes.place::<T>();
    let zone = Zone::of(place);
    let context = || format!("{} {place:?}", T::NAME);
    let position = grid.forward(place).unwrap();
    assert_eq!(
        (position.zone, position.hemisphere),
        (zone, Hemisphere::of(place.lat())),
        "{}",
        context()
    );
    let beside = Zone::new(zone.number() % 60 + 1).unwrap();
    let neighbour = grid.in_zone(beside, place);
    for position in [Ok(position), neighbour].into_iter().flatten() {
        let back = grid.inverse(position).unwrap();
        // A false origin is rounded to the units of ten thousand kilometres.
        let error = apart(place, back);
        assert!(
            is_place(back) && error <= 8.0 * value(T::EPSILON),
            "{} {position}: {error:e}",
            context()
        );
    }
    let local = grid.point_scale(zone, place).unwrap();
    assert!((0.99..1.02).contains(&value(local.scale)), "{}: {local:?}", context());
}

/// A place has a square of every precision; each contains the next; its text leads back; its centre is near.
fn mgrs<T: Scalar>(bytes: &mut Bytes<'_>) {
    let grid = UtmUps::<T>::new(Ellipsoid::WGS84).unwrap();
    let (place, precision) = (bytes.place::<T>(), bytes.byte() % 12);
    let context = || format!("{} {place:?} {precision}", T::NAME);
    let square = Mgrs::of(&grid, place, precision).unwrap();
    let text = square.text();
    assert_eq!(text.as_str().parse(), Ok(square), "{}", context());
    assert_eq!(square.zone(), Zone::of(place), "{}", context());
    let coarse = bytes.byte() % (precision + 1);
    if precision <= 5 {
        assert_eq!(
            Mgrs::of(&grid, place, coarse),
            Ok(square.coarser(coarse)),
            "{} {coarse}",
            context()
        );
    }
    let centre = grid.inverse(square.centre::<T>()).unwrap();
    let width = value(square.width::<T>()) / 6.3e6;
    let error = apart(centre, place);
    assert!(
        error <= 0.75 * width + 8.0 * value(T::EPSILON),
        "{}: {error:e}",
        context()
    );
    let corner = square.south_west::<T>();
    let again = Mgrs::new(corner, place.lat(), precision);
    // The corner may be in another band than the place. A corner of UTM's last squares may be beyond a border.
    if let (Ok(again), true) = (again, precision <= 5 || T::CLAIM == 0) {
        assert_eq!(again, square, "{}", context());
    }
}

/// Any text is a square or is refused; a square's text is the same square.
fn texts<T: Scalar>(bytes: &mut Bytes<'_>) {
    const SIGNS: &[u8] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabz -.\t\xc3\xa9";
    let length = bytes.byte() % 32;
    let zone = u64::from(bytes.byte() % 62);
    let mut text = if bytes.flag() { zone.to_string() } else { String::new() };
    for _ in 0..length {
        let sign = bytes.choice(SIGNS);
        text.push(if sign < 128 { char::from(sign) } else { 'é' });
    }
    match text.parse::<Mgrs>() {
        Ok(square) => {
            assert_eq!(square.to_string().parse(), Ok(square), "{text}");
            let grid = UtmUps::<T>::new(Ellipsoid::WGS84).unwrap();
            assert!(is_place(grid.inverse(square.centre()).unwrap()), "{text}");
            assert!(is_place(grid.inverse(square.south_west()).unwrap()), "{text}");
        }
        Err(why) => assert!(!why.to_string().is_empty()),
    }
}

/// Any numbers at all: what is given is a place, and what is refused says why.
fn any<T: Scalar>(bytes: &mut Bytes<'_>) {
    let [x, y, scale, lat] = [(); 4].map(|()| bytes.anything::<T>());
    let (about, centre) = (hemisphere(bytes), bytes.place::<T>());
    let ellipsoid = bytes.ellipsoid(-0.1, 0.1);
    if let Ok(map) = TransverseMercator::<T>::new(ellipsoid, scale, x) {
        assert!(map.forward(centre).iter().all(|x| x.is_finite()), "{map:?} {centre:?}");
        let _ = map.point_scale(centre);
        if let Ok(place) = map.inverse([x, y]) {
            assert!(is_place(place), "{map:?} {x:?} {y:?}");
        }
    }
    if let Ok(map) = PolarStereographic::<T>::new(ellipsoid, scale) {
        assert!(
            map.forward(about, centre).iter().all(|x| x.is_finite()),
            "{map:?} {centre:?}"
        );
        let _ = map.point_scale(about, centre);
        if let Ok(place) = map.inverse(about, [x, y]) {
            assert!(is_place(place), "{map:?} {x:?} {y:?}");
        }
    }
    let places = [
        LambertAzimuthal::<T>::new(ellipsoid, centre)
            .unwrap()
            .inverse([x, y])
            .ok(),
        AzimuthalEquidistant::<T>::new(ellipsoid, centre)
            .unwrap()
            .inverse([x, y])
            .ok(),
        Gnomonic::<T>::new(ellipsoid, centre).unwrap().inverse([x, y]).ok(),
    ];
    assert!(
        places.into_iter().flatten().all(is_place),
        "{ellipsoid:?} {centre:?} {x:?} {y:?}"
    );
    let grid = UtmUps::<T>::new(Ellipsoid::WGS84).unwrap();
    let zone = Zone::new(bytes.byte() % 61).unwrap();
    for [easting, northing] in [[x, y], [bytes.within(3.3e6), bytes.within(2e7)]] {
        let position = GridPosition::new(zone, about, easting, northing);
        if let Ok(place) = grid.inverse(position) {
            assert!(is_place(place), "{position}");
        }
        let _ = Mgrs::new(position, lat, bytes.byte() % 13);
    }
    let _ = (grid.in_zone(zone, centre), grid.point_scale(zone, centre));
}
