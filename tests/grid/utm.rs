use terrella::grid::{GridPosition, Hemisphere, OutsideGrid, Utm, UtmUps, Zone};
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;
use testkit::truth::{Scalar, Truth};

fn grid<T: Scalar>() -> UtmUps<T> {
    UtmUps::new(Ellipsoid::WGS84).unwrap()
}

fn as_geoconvert<T: Scalar>() {
    let grid = grid::<T>();
    let [mut utm, mut ups, mut convergence, mut scale, mut back] = [(); 5].map(|()| Worst::default());
    let truth = Truth::read("grid_geoconvert");
    for row in truth.exact_in::<T>(&["lat", "lon"]) {
        let place = LatLon::<T>::new(row.input("lat"), row.input("lon")).unwrap();
        let context = format!("{} {}", row.text("lat"), row.text("lon"));
        let position = grid.forward(place).unwrap();
        assert_eq!(f64::from(position.zone.number()), row.value("zone"), "{context}");
        assert_eq!(position.hemisphere.to_string(), row.text("hemisphere"), "{context}");
        let error = row
            .error("easting", position.easting)
            .hypot(row.error("northing", position.northing));
        if position.zone == Zone::POLAR {
            &mut ups
        } else {
            &mut utm
        }
        .add(error);
        let local = grid.point_scale(position.zone, place).unwrap();
        let turn = row.error("convergence", local.convergence);
        convergence.add(testkit::minimum(turn, (turn - 360.0).abs()));
        scale.add(row.error("scale", local.scale));
        let there = grid.inverse(position).unwrap();
        let [a, b] = [place, there].map(|p| {
            LatLon::<f64>::new(p.lat().into(), p.lon().into())
                .unwrap()
                .to_direction()
        });
        back.add(
            a.to_array()
                .iter()
                .zip(b.to_array())
                .map(|(a, b)| (a - b).powi(2))
                .sum::<f64>()
                .sqrt()
                * 6.4e6,
        );
    }
    let found = [utm, ups, convergence, scale, back].map(Worst::value);
    println!("as GeoConvert, {}: {found:?}", T::NAME);
    // The program writes nanometres, and 14 decimals of degrees and of the scale.
    let claimed = [[5e-9, 2e-9, 1e-13, 2e-15, 5e-9], [2.2, 0.6, 2e-5, 6e-7, 2.2]][T::CLAIM];
    assert!(
        found.iter().zip(claimed).all(|(found, claimed)| *found <= claimed),
        "{found:?}"
    );
}

#[test]
fn positions_are_those_of_geoconvert() {
    as_geoconvert::<f64>();
    as_geoconvert::<f32>();
}

#[test]
fn zones_have_exceptions() {
    let cases = [
        (55.999, 3.0, 31),
        (56.0, 2.999, 31),
        (56.0, 3.0, 32),
        (63.999, 5.999, 32),
        (64.0, 3.0, 31),
        (60.0, 0.0, 31),
        (60.0, 11.999, 32),
        (60.0, 12.0, 33),
        (71.999, 9.0, 32),
        (72.0, -0.001, 30),
        (72.0, 0.0, 31),
        (72.0, 8.999, 31),
        (72.0, 9.0, 33),
        (72.0, 20.999, 33),
        (72.0, 21.0, 35),
        (83.999, 32.999, 35),
        (83.999, 33.0, 37),
        (80.0, 41.999, 37),
        (80.0, 42.0, 38),
        (84.0, 10.0, 0),
        (90.0, 0.0, 0),
        (-80.0, 0.0, 31),
        (-80.000_001, 0.0, 0),
        (0.0, 180.0, 1),
        (0.0, -180.0, 1),
        (0.0, 179.999, 60),
        (0.0, 6.0, 32),
        (0.0, 5.999, 31),
        (-0.0, -0.0, 31),
        (0.0, -0.001, 30),
        (0.0, 540.0, 1),
    ];
    for (lat, lon, zone) in cases {
        assert_eq!(
            Zone::of(LatLon::<f64>::new(lat, lon).unwrap()).number(),
            zone,
            "{lat} {lon}"
        );
    }
    for number in 0..=60 {
        let zone = Zone::new(number).unwrap();
        let meridian = zone.meridian::<f32>();
        assert_eq!(meridian, (number > 0).then(|| 6.0 * f32::from(number) - 183.0));
    }
    assert_eq!(Zone::new(61).unwrap_err().to_string(), "zone 61 is not in 0 to 60");
}

#[test]
fn the_equator_is_in_both_hemispheres() {
    let utm = Utm::<f64>::new(Ellipsoid::WGS84).unwrap();
    let [north, south] = [0.0, -0.0].map(|lat| utm.forward(LatLon::new(lat, 0.0).unwrap()).unwrap());
    assert_eq!((north.hemisphere, north.northing), (Hemisphere::North, 0.0));
    assert_eq!((south.hemisphere, south.northing), (Hemisphere::South, 10_000_000.0));
    // Northings run on.
    for (hemisphere, northing) in [(Hemisphere::North, -5e6), (Hemisphere::South, 5e6)] {
        let place = utm
            .inverse(GridPosition::new(Zone::new(31).unwrap(), hemisphere, 5e5, northing))
            .unwrap();
        assert!((place.lat() + 45.13).abs() < 0.1 && place.lon() == 3.0, "{place}");
    }
}

#[test]
fn limits_are_those_of_geographiclib() {
    let grid = grid::<f64>();
    let position = |zone, hemisphere, easting, northing| {
        grid.inverse(GridPosition::new(
            Zone::new(zone).unwrap(),
            hemisphere,
            easting,
            northing,
        ))
        .err()
    };
    use Hemisphere::{North, South};
    // From the file and from one millimetre inside; outside by one millimetre.
    for (zone, hemisphere, east, north) in [
        (31, North, [0.0, 1e6], [-9.1e6, 9.6e6]),
        (31, South, [0.0, 1e6], [9e5, 1.96e7]),
        (0, North, [1.2e6, 2.8e6], [1.2e6, 2.8e6]),
        (0, South, [7e5, 3.3e6], [7e5, 3.3e6]),
    ] {
        for (at, outward) in [(0, -1e-3), (1, 1e-3)] {
            assert_eq!(position(zone, hemisphere, east[at], 2e6), None);
            assert_eq!(
                position(
                    zone,
                    hemisphere,
                    1e6 / 2.0 + 1e6 * f64::from(u8::from(zone == 0)) * 1.5,
                    north[at]
                ),
                None
            );
            let (x, y) = (east[at] + outward, north[at] + outward);
            assert_eq!(position(zone, hemisphere, x, 2e6), Some(OutsideGrid::Easting(x)));
            let middle = if zone == 0 { 2e6 } else { 5e5 };
            assert_eq!(position(zone, hemisphere, middle, y), Some(OutsideGrid::Northing(y)));
        }
    }
    assert!(matches!(
        position(31, North, f64::NAN, 0.0),
        Some(OutsideGrid::Easting(_))
    ));
    assert!(matches!(
        position(31, North, 5e5, f64::NAN),
        Some(OutsideGrid::Northing(_))
    ));
    let at = |zone: u8, lat: f64, lon: f64| {
        grid.in_zone(Zone::new(zone).unwrap(), LatLon::new(lat, lon).unwrap())
            .err()
    };
    assert_eq!(at(31, 89.0, 63.001), Some(OutsideGrid::Longitude(63.001)));
    assert_eq!(at(60, 85.0, -179.0), None);
    assert_eq!(at(1, 85.0, 122.9), Some(OutsideGrid::Longitude(122.9)));
    assert_eq!(at(0, 69.999, 0.0), Some(OutsideGrid::Latitude(69.999)));
    assert!(matches!(at(31, 0.0, 10.0), Some(OutsideGrid::Easting(_))));
    let utm = Utm::<f64>::new(Ellipsoid::WGS84).unwrap();
    let pole = LatLon::new(85.0, 0.0).unwrap();
    assert_eq!(utm.forward(pole).err(), Some(OutsideGrid::Latitude(85.0)));
    assert_eq!(
        utm.in_zone(Zone::POLAR, LatLon::new(0.0, 0.0).unwrap()).err(),
        Some(OutsideGrid::Zone(Zone::POLAR))
    );
}

/// Bug reports of others: Turbo87/utm 17 (a zone asked for, next to the equator), OSGeo/PROJ 1076 (the false northing
/// of the south) and 2253 (the sign of the convergence there).
#[test]
fn bug_reports_of_others() {
    let utm = Utm::<f64>::new(Ellipsoid::WGS84).unwrap();
    let cases = [
        (31, 0.001, 0.001, 166_132.871_880_47, 110.682_654_08),
        (31, -0.001, -0.001, 165_910.014_476_82, 9_999_889.317_142_07),
        (30, -0.001, -0.001, 833_867.128_119_53, 9_999_889.317_345_92),
        (
            54, -35.341_367_958_3, 143.517_785_097, 728_818.368_345, 6_086_190.184_27,
        ),
    ];
    for (zone, lat, lon, easting, northing) in cases {
        let here = utm
            .in_zone(Zone::new(zone).unwrap(), LatLon::new(lat, lon).unwrap())
            .unwrap();
        assert!(
            (here.easting - easting).abs() < 2e-4 && (here.northing - northing).abs() < 2e-4,
            "{here}"
        );
    }
    let local = utm
        .point_scale(Zone::new(19).unwrap(), LatLon::new(-39.0, -70.0).unwrap())
        .unwrap();
    assert!((local.convergence - 0.629_359_46).abs() < 1e-8 && (local.scale - 0.999_692_33).abs() < 1e-8);
}
