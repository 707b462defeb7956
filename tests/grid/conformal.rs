use terrella::grid::{Hemisphere, InvalidMap, PolarStereographic, TransverseMercator};
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;
use testkit::truth::{Scalar, Truth};

use crate::{displacement, distance};

fn tm<T: Scalar>() -> TransverseMercator<T> {
    TransverseMercator::new(Ellipsoid::WGS84, T::ONE, T::ZERO).unwrap()
}

/// The classes of distance: metres of x at most, and what is claimed of points and places in `f64` and `f32`.
const BANDS: [(f64, [f64; 2]); 4] = [
    (4e5, [5e-9, 1.9]),
    (3.9e6, [5e-9, 1.9]),
    (6e6, [5e-9, 2.2]),
    (8.5e6, [4e-8, 2.2]),
];

fn band(x: f64) -> usize {
    BANDS
        .iter()
        .position(|(limit, _)| x.abs() <= *limit)
        .unwrap_or(BANDS.len())
}

fn transverse_mercator<T: Scalar>() {
    let map = tm::<T>();
    let mut worst = [(); 4].map(|()| [Worst::default(), Worst::default()]);
    let mut scales = [Worst::default(), Worst::default()];
    let truth = Truth::read("grid_tm");
    for row in truth.exact_in::<T>(&["lat", "lon"]) {
        let band = band(row.value("x"));
        if band == BANDS.len() {
            continue;
        }
        let place = LatLon::new(row.input("lat"), row.input("lon")).unwrap();
        worst[band][0].add(distance(row, map.forward(place)));
        if band < 2 {
            let here = map.point_scale(place);
            scales[0].add(row.error("convergence", here.convergence));
            scales[1].add(row.error("scale", here.scale));
        }
    }
    let truth = Truth::read("grid_tm_inverse");
    for row in truth.exact_in::<T>(&["x", "y"]) {
        let place = map.inverse([row.input("x"), row.input("y")]).unwrap();
        worst[band(row.value("x"))][1].add(displacement(row, place));
    }
    for (found, (limit, claimed)) in worst.into_iter().zip(BANDS) {
        let [forward, inverse] = found.map(Worst::value);
        println!("transverse Mercator to {limit} m, {}: {forward:e} {inverse:e}", T::NAME);
        assert!(
            forward <= claimed[T::CLAIM] && inverse <= claimed[T::CLAIM],
            "{limit}: {forward:e} {inverse:e}"
        );
    }
    let [convergence, scale] = scales.map(Worst::value);
    println!("convergence and scale, {}: {convergence:e} {scale:e}", T::NAME);
    assert!(convergence <= [1e-13, 2e-5][T::CLAIM] && scale <= [2e-15, 6e-7][T::CLAIM]);
}

#[test]
fn transverse_mercator_is_as_accurate_as_claimed() {
    transverse_mercator::<f64>();
    transverse_mercator::<f32>();
}

fn polar<T: Scalar>() {
    let map = PolarStereographic::<T>::new(Ellipsoid::WGS84, T::ONE).unwrap();
    let mut worst = [(); 6].map(|()| Worst::default());
    let truth = Truth::read("grid_polar");
    for row in truth.exact_in::<T>(&["lat", "lon"]) {
        let (lat, lon) = (row.input::<T>("lat"), row.input("lon"));
        let [north, south] = [lat, -lat].map(|lat| LatLon::new(lat, lon).unwrap());
        let [x, y] = map.forward(Hemisphere::North, north);
        // The south is the mirror image.
        let mirrored = map.forward(Hemisphere::South, south);
        assert_eq!(mirrored, [x, -y]);
        let error = distance(row, [x, y]);
        let rho = row.value("x").hypot(row.value("y"));
        if rho < 2e6 {
            worst[0].add(error);
            let here = map.point_scale(Hemisphere::North, north);
            worst[2].add((Into::<f64>::into(here.convergence) - Into::<f64>::into(lon)).abs());
            worst[3].add(row.error("scale", here.scale));
        } else {
            worst[1].add(error / rho);
        }
    }
    let truth = Truth::read("grid_polar_inverse");
    for row in truth.exact_in::<T>(&["x", "y"]) {
        let (x, y) = (row.input::<T>("x"), row.input("y"));
        let place = map.inverse(Hemisphere::North, [x, y]).unwrap();
        worst[4].add(displacement(row, place));
        let south = map.inverse(Hemisphere::South, [x, -y]).unwrap();
        assert_eq!(south, LatLon::new(-place.lat(), place.lon()).unwrap());
    }
    worst[5].add(0.0);
    let found = worst.map(Worst::value);
    println!("polar stereographic, {}: {found:?}", T::NAME);
    let claimed = [
        [2e-9, 4e-16, 1e-13, 1e-15, 3e-9, 0.0],
        [1.2, 2e-7, 2e-5, 5e-7, 1.5, 0.0],
    ][T::CLAIM];
    assert!(
        found.iter().zip(claimed).all(|(found, claimed)| *found <= claimed),
        "{found:?}"
    );
}

#[test]
fn polar_stereographic_is_as_accurate_as_claimed() {
    polar::<f64>();
    polar::<f32>();
}

#[test]
fn hard_places_have_points() {
    let map = tm::<f64>();
    let at = |lat: f64, lon: f64| map.forward(LatLon::new(lat, lon).unwrap());
    // Poles, whatever the longitude; the other side; −0; ±90° on the equator.
    let [x, y] = at(90.0, 123.0);
    assert!(x.abs() < 1e-9 && (y - 10_001_965.729_312_723).abs() < 2e-9, "{x} {y}");
    assert_eq!(at(0.0, 180.0)[1], 2.0 * at(90.0, 0.0)[1]);
    assert_eq!(at(45.0, 180.0)[0].abs(), at(45.0, 0.0)[0].abs());
    assert!((at(45.0, 180.0)[1] + at(45.0, 0.0)[1] - 2.0 * y).abs() < 4e-9);
    assert_eq!(at(-0.0, 1.0)[1], 0.0);
    assert_eq!(at(0.0, -1.0)[0], -at(0.0, 1.0)[0]);
    for lon in [90.0, -90.0, 89.999_999, 82.6, 90.000_001] {
        let [x, y] = at(0.0, lon);
        assert!(x.is_finite() && y.is_finite(), "{lon}: {x} {y}");
    }
    // Across ±180° to a meridian on the other side.
    let east = TransverseMercator::<f64>::new(Ellipsoid::WGS84, 0.9996, 177.0).unwrap();
    let [a, b] = [-179.5, 180.5].map(|lon| east.forward(LatLon::new(-17.0, lon).unwrap()));
    assert_eq!(a, b);
    assert!((east.inverse(a).unwrap().lon() + 179.5).abs() < 1e-12);
    assert_eq!(TransverseMercator::new(Ellipsoid::WGS84, 0.9996, 537.0).unwrap(), east);
}

/// GeographicLib's `TransverseMercatorProj -t -e 6378137 0.0166015625 -k 1 -l 0 -p 10`, whose series is exact: next to the
/// flattest that is taken, and to 45°.
#[test]
fn flat_ellipsoids_to_45_degrees() {
    fn worst<T: Scalar>() -> f64 {
        let flat = Ellipsoid::new(T::of(6_378_137.0), T::of(0.0166015625)).unwrap();
        let map = TransverseMercator::new(flat, T::ONE, T::ZERO).unwrap();
        Worst::of(
            [
                [
                    -0.9718502163887024, -44.891021728515625, -5632336.5527720442, -150256.0856982162,
                ],
                [
                    -2.6243908405303955, -44.92381286621094, -5629295.1163287805, -405737.4058069029,
                ],
                [
                    -2.1109983921051025, -44.918914794921875, -5631899.3730401723, -326422.3966549188,
                ],
                [
                    -18.19786834716797, 30.77721405029297, 3396707.9353149426, -2269952.1991050043,
                ],
                [
                    82.12632751464844, -13.73795223236084, -211006.5441675505, 9069943.5853011273,
                ],
            ]
            .map(|[lat, lon, x, y]: [f64; 4]| {
                let [a, b] = map
                    .forward(LatLon::new(T::of(lat), T::of(lon)).unwrap())
                    .map(Into::into);
                (a - x).hypot(b - y)
            }),
        )
    }
    let (double, single) = (worst::<f64>(), worst::<f32>());
    assert!(double < 1e-5 && single < 2.2, "{double:e} {single}");
}

#[test]
fn constructors_refuse() {
    let flat = Ellipsoid::new(1.0, 0.02).unwrap();
    let new = TransverseMercator::new;
    assert!(matches!(new(flat, 1.0, 0.0), Err(InvalidMap::Flattening(why)) if why.0 == 0.02));
    assert_eq!(new(Ellipsoid::WGS84, 0.0, 0.0), Err(InvalidMap::Scale(0.0)));
    assert!(matches!(
        new(Ellipsoid::WGS84, f64::NAN, 0.0),
        Err(InvalidMap::Scale(_))
    ));
    assert_eq!(
        new(Ellipsoid::WGS84, 1.0, f64::INFINITY),
        Err(InvalidMap::Meridian(f64::INFINITY))
    );
    assert!(tm::<f64>().inverse([1.3e7, 0.0]).is_err());
    assert!(tm::<f64>().inverse([0.0, f64::NAN]).is_err());
    let polar = PolarStereographic::<f32>::new(Ellipsoid::WGS84, 1.0).unwrap();
    assert!(polar.inverse(Hemisphere::North, [f32::MAX, 0.0]).is_err());
    assert_eq!(
        polar.inverse(Hemisphere::North, [0.0, 0.0]).unwrap(),
        LatLon::new(90.0, 0.0).unwrap()
    );
    assert_eq!(polar.inverse(Hemisphere::South, [-0.0, -0.0]).unwrap().lat(), -90.0);
    assert!(polar.forward(Hemisphere::North, LatLon::new(-90.0, 10.0).unwrap())[0].is_finite());
}
