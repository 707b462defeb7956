//! Every method but Karney's, to be asked alike; Vincenty's where the ellipsoid is one for it.

use terrella::Ellipsoid;
use terrella::geodesic::{Andoyer, AndoyerSecond, Bowring, Flat, Geodesic, GreatCircle, Haversine, Vincenty};

use testkit::truth::Scalar;

pub type Methods<T> = Vec<(&'static str, Box<dyn Geodesic<T>>)>;

pub fn methods<T: Scalar>(f: f64) -> Methods<T> {
    let earth = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
    let mut methods: Methods<T> = vec![
        ("great circle", Box::new(GreatCircle::new(earth.mean_radius()).unwrap())),
        ("haversine", Box::new(Haversine::new(earth.mean_radius()).unwrap())),
        ("flat", Box::new(Flat::new(earth).unwrap())),
        ("bowring", Box::new(Bowring::new(earth).unwrap())),
        ("andoyer", Box::new(Andoyer::new(earth).unwrap())),
        ("andoyer, second order", Box::new(AndoyerSecond::new(earth).unwrap())),
    ];
    if let Ok(vincenty) = Vincenty::new(earth) {
        methods.push(("vincenty", Box::new(vincenty)));
    }
    methods
}
