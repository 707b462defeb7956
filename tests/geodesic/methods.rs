//! Every method but Karney's, to be asked alike; Vincenty's where the ellipsoid is one for it.

use terrella::Ellipsoid;
use terrella::geodesic::{Geodesic, Method};

use testkit::truth::Scalar;

pub type Methods<T> = Vec<(Method, Box<dyn Geodesic<T>>)>;

pub fn methods<T: Scalar>(f: f64) -> Methods<T> {
    let earth = Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap();
    let others = Method::ALL.iter().filter(|&&method| method != Method::Karney);
    let boxed = |&method: &Method| -> Option<(Method, Box<dyn Geodesic<T>>)> {
        Some((method, Box::new(method.on(earth).ok()?)))
    };
    others.filter_map(boxed).collect()
}
