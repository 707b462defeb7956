use terrella::geodesic::{Geodesic, Karney};
use terrella::grid::{AzimuthalEquidistant, Gnomonic, LambertAzimuthal};
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;
use testkit::truth::{Row, Scalar, Truth};

use crate::{displacement, distance};

fn centre<T: Scalar>(row: Row<'_>) -> LatLon<T> {
    LatLon::new(row.input("lat0"), row.input("lon0")).unwrap()
}

fn lambert<T: Scalar>() {
    let [mut near, mut far, mut back] = [(); 3].map(|()| Worst::default());
    let truth = Truth::read("grid_laea");
    for row in truth.exact_in::<T>(&["lat0", "lon0", "lat", "lon"]) {
        let map = LambertAzimuthal::<T>::new(Ellipsoid::WGS84, centre(row)).unwrap();
        let point = map
            .forward(LatLon::new(row.input("lat"), row.input("lon")).unwrap())
            .unwrap();
        let (error, rho) = (distance(row, point), row.value("x").hypot(row.value("y")));
        if rho < 1.1e7 {
            let floor = [1e-9, 5e-4][T::CLAIM];
            if error > floor {
                near.add((error - floor) / rho);
            } else {
                near.add(0.0);
            }
        } else {
            far.add(error / rho);
        }
    }
    let truth = Truth::read("grid_laea_inverse");
    for row in truth.exact_in::<T>(&["lat0", "lon0", "x", "y"]) {
        let map = LambertAzimuthal::<T>::new(Ellipsoid::WGS84, centre(row)).unwrap();
        back.add(displacement(
            row,
            map.inverse([row.input("x"), row.input("y")]).unwrap(),
        ));
    }
    let found = [near, far, back].map(Worst::value);
    println!("Lambert azimuthal, {}: {found:?}", T::NAME);
    let claimed = [[6e-16, 1e-15, 5e-9], [4e-7, 4e-7, 2.0]][T::CLAIM];
    assert!(
        found.iter().zip(claimed).all(|(found, claimed)| *found <= claimed),
        "{found:?}"
    );
}

#[test]
fn lambert_azimuthal_is_as_accurate_as_claimed() {
    lambert::<f64>();
    lambert::<f32>();
}

/// EPSG's guidance note, and the centre's antipode.
#[test]
fn lambert_azimuthal_hard_places() {
    for (lat, lon) in [
        (52.0_f64, 10.0_f64),
        (0.0, 0.0),
        (90.0, 0.0),
        (-90.0, 0.0),
        (0.0, 180.0),
    ] {
        let centre = LatLon::new(lat, lon).unwrap();
        let map = LambertAzimuthal::new(Ellipsoid::WGS84, centre).unwrap();
        assert!(
            map.forward(centre).unwrap().iter().all(|v| v.abs() < 1e-100),
            "{centre}"
        );
        let back: LatLon = map.inverse([0.0, 0.0]).unwrap();
        assert!(
            (back.lat() - lat).abs() < 2e-14 && (back.lon() - lon).abs() < 1e-13,
            "{back}"
        );
        let edge = 2.0 * Ellipsoid::<f64>::WGS84.authalic_radius();
        assert!(map.inverse([1.01 * edge, 0.0]).is_err());
        assert!(map.inverse([f64::NAN, 0.0]).is_err());
        // The parallel of −β₀, not −φ₀, is that of the antipode: they are the same by symmetry.
        let antipode = LatLon::new(-lat, lon + 180.0).unwrap();
        assert!(map.forward(antipode).is_err(), "{centre}");
    }
}

fn geodesic_maps<T: Scalar>() {
    let [mut gnomonic, mut equidistant] = [(); 2].map(|()| Worst::default());
    let karney = Karney::<f64>::new(Ellipsoid::WGS84).unwrap();
    let truth = Truth::read("geod_inverse_wgs84");
    for row in truth.exact_in::<T>(&["lat1", "lon1", "lat2", "lon2"]) {
        let [from, to] = [("lat1", "lon1"), ("lat2", "lon2")]
            .map(|(lat, lon)| LatLon::<T>::new(row.input(lat), row.input(lon)).unwrap());
        let ground = |a: LatLon<T>, b: LatLon<T>| {
            let [a, b] = [a, b].map(|p| LatLon::new(p.lat().into(), p.lon().into()).unwrap());
            karney.distance(a, b).unwrap()
        };
        let length: f64 = row.value("s12");
        let map = AzimuthalEquidistant::<T>::new(Ellipsoid::WGS84, from).unwrap();
        let point = map.forward(to);
        let [x, y] = point.map(Into::<f64>::into);
        if length < 1.9e7 {
            equidistant.add((x.hypot(y) - length).abs());
            equidistant.add(ground(map.inverse(point).unwrap(), to));
        }
        let map = Gnomonic::<T>::new(Ellipsoid::WGS84, from).unwrap();
        if length < 6.6e6 {
            let point = map.forward(to).unwrap();
            gnomonic.add(ground(map.inverse(point).unwrap(), to));
        }
        if length > 1.02e7 {
            assert!(map.forward(to).is_err(), "{length}");
        }
    }
    let found = [gnomonic, equidistant].map(Worst::value);
    println!("gnomonic, equidistant, {}: {found:?}", T::NAME);
    let claimed = [[3e-8, 3e-8], [15.0, 15.0]][T::CLAIM];
    assert!(
        found.iter().zip(claimed).all(|(found, claimed)| *found <= claimed),
        "{found:?}"
    );
}

#[test]
fn geodesic_maps_lead_back() {
    geodesic_maps::<f64>();
    geodesic_maps::<f32>();
}
