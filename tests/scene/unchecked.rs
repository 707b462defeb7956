//! A scene makes what it has chosen without the checks of the public constructors: those of the scene imply them.

use fastrand::Rng;
use terrella::geodesic::{
    Andoyer, AnyMethod, Area, Flat, Gauss, Geodesic, GreatCircle, Karney, Method, PlanarArea, Plane,
};
use terrella::latitude::Shift;
use terrella::scene::{AnyArea, Figure, Scene, Surface};
use terrella::{Ellipsoid, LatLon, Real, Shifted};

use crate::draw::Drawn;

fn hold<T: Real>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    for _ in 0..300 {
        let mut drawn = Drawn::any(&mut rng, 1e3);
        let local = rng.bool();
        if local {
            drawn.scene = drawn.scene.local();
        }
        let rounded = |ellipsoid: Ellipsoid<f64>| Ellipsoid::new(T::of(ellipsoid.a()), T::of(ellipsoid.f())).unwrap();
        let ellipsoid = rounded(drawn.ellipsoid);
        let place = LatLon::new(T::of(0.5 * (drawn.south + drawn.north)), T::of(0.0)).unwrap();
        for &method in Scene::METHODS {
            let method = drawn.scene.distances_by::<T>(method).unwrap().solver();
            let checked = match method {
                AnyMethod::Plane(_) if local => AnyMethod::Plane(Plane::local(ellipsoid, place).unwrap()),
                AnyMethod::Plane(_) => AnyMethod::Plane(Plane::new(ellipsoid, place).unwrap()),
                AnyMethod::Flat(_) => AnyMethod::Flat(Flat::new(ellipsoid).unwrap()),
                AnyMethod::Gauss(_) => AnyMethod::Gauss(Gauss::new(ellipsoid).unwrap()),
                AnyMethod::GreatCircle(sphere) => AnyMethod::GreatCircle(GreatCircle::new(sphere.radius()).unwrap()),
                AnyMethod::Andoyer(_) => AnyMethod::Andoyer(Andoyer::new(ellipsoid).unwrap()),
                AnyMethod::Karney(_) => AnyMethod::Karney(Karney::new(ellipsoid).unwrap()),
                _ => panic!("{method:?}"),
            };
            assert_eq!(method, checked);
        }
        for surface in Surface::ALL {
            let method = drawn.scene.areas_by::<T>(surface).unwrap().solver();
            let checked = match method {
                AnyArea::Plane(_) if local => AnyArea::Plane(PlanarArea::local(ellipsoid, place).unwrap()),
                AnyArea::Plane(_) => AnyArea::Plane(PlanarArea::new(ellipsoid).unwrap()),
                AnyArea::Ellipsoid(_) => AnyArea::Ellipsoid(Area::new(ellipsoid).unwrap()),
                _ => panic!("{surface:?}"),
            };
            assert_eq!(method, checked);
        }
        let [sphere, shifted] = drawn.scene.figures().unwrap();
        for figure in [sphere, shifted, drawn.scene.within(0.0).figure().unwrap()] {
            for &shift in Shift::ALL {
                let checked = match figure {
                    Figure::Sphere { .. } => Shifted::new(figure.ground(), Shift::Geodetic),
                    Figure::Shifted { ellipsoid, .. } => Shifted::new(rounded(ellipsoid), Shift::Geocentric),
                    Figure::Ellipsoid { ellipsoid, .. } => Shifted::new(rounded(ellipsoid), shift),
                };
                assert_eq!(Ok(figure.shifted::<T>(shift)), checked);
            }
        }
    }
}

#[test]
fn the_same_as_with_the_checks() {
    hold::<f64>(7);
    hold::<f32>(8);
}

/// The sphere of the poles of the largest ellipsoid has a greater radius than any ellipsoid's equator.
#[test]
fn a_sphere_larger_than_the_largest_ellipsoid() {
    let largest = Ellipsoid::new(1e15, 0.01).unwrap();
    let poles = Scene::new(largest).latitudes(80.0, 90.0).up_to(1e13);
    let way = poles.distances_by::<f64>(Method::GreatCircle).unwrap();
    let (from, to) = (LatLon::new(90.0, 0.0).unwrap(), LatLon::new(89.5, 0.0).unwrap());
    let method = way.solver();
    assert!(matches!(method, AnyMethod::GreatCircle(sphere) if GreatCircle::new(sphere.radius()).is_err()));
    let found = method.inverse(from, to).unwrap().distance;
    let truth = Karney::new(largest).unwrap().inverse(from, to).unwrap().distance;
    assert!((found - truth).abs() <= way.bound().distance, "{found:e}, {truth:e}");
}
