use terrella::cube::Projection;
use terrella::geodesic::{Area, Geodesic, GreatCircle, Karney, Method, Plane, Visitor};
use terrella::scene::Scene;
use terrella::{Ellipsoid, LatLon, Real};

use crate::points::{Pair, Points};
use crate::sweep::Sweep;

/// Both problems by one method, named by its own type.
fn both<T: Real>(sweep: Sweep, method: impl Geodesic<T>, name: &str, pairs: &[Pair<T>]) {
    let karney = Karney::new(Ellipsoid::WGS84).unwrap();
    let starts: Vec<_> = pairs
        .iter()
        .map(|&[from, to]| {
            let way = karney.solve(from, to).inverse;
            (from, way.azimuth1, way.distance)
        })
        .collect();
    sweep.count(&format!("inverse, {name}"), pairs, |[from, to]| {
        method.inverse(from, to)
    });
    sweep.count(&format!("direct, {name}"), &starts, |(from, azimuth, distance)| {
        method.direct(from, azimuth, distance)
    });
}

/// Counts both problems of a method.
struct Both<'a, T> {
    sweep: Sweep,
    name: &'a str,
    pairs: &'a [Pair<T>],
}

impl<T: Real> Visitor<T> for Both<'_, T> {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        both(self.sweep, method, self.name, self.pairs);
    }
}

pub fn methods<T: Real>(sweep: Sweep, points: &Points<T>) {
    for (pairs, kind) in [
        (&points.ordinary, ""),
        (&points.short, ", short"),
        (&points.antipodal, ", nearly antipodal"),
    ] {
        // What holds about one place is in `scene`.
        for method in Method::ALL.iter().filter(|method| !method.needs_place()) {
            let name = &format!("{method}{kind}");
            method.on(Ellipsoid::WGS84).unwrap().visit(Both { sweep, name, pairs });
        }
    }
}

/// The flat model about a place, and what it costs to choose it.
pub fn scene<T: Real>(sweep: Sweep, points: &Points<T>) {
    let origin = LatLon::new(T::of(47.4), T::of(8.5)).unwrap();
    both(
        sweep,
        Plane::new(Ellipsoid::WGS84, origin).unwrap(),
        "plane",
        &points.short,
    );
    let scenes: Vec<_> = points
        .units
        .iter()
        .map(|&[x, y]| {
            let [lat, size] = [x, y].map(|unit| unit.to_string().parse::<f64>().unwrap());
            Scene::around(Ellipsoid::WGS84, 80.0 * lat, 1e5 * (1.1 + size)).within(1e-3)
        })
        .collect();
    sweep.count("Scene::distances", &scenes, |scene| scene.distances::<T>());
    sweep.count("Scene::positions", &scenes, |scene| scene.positions::<T>());
    sweep.count("Scene::figure", &scenes, |scene| scene.figure());
    sweep.count("Scene::tiles", &scenes, |scene| scene.tiles(Projection::Adjusted));
}

pub fn great_circle<T: Real>(sweep: Sweep, points: &Points<T>) {
    let sphere = GreatCircle::new(T::of(6_371_000.0)).unwrap();
    let pairs = &points.ordinary;
    let angles: Vec<_> = points.units.iter().map(|&[x, y]| ([x, y], [y, x + y])).collect();
    let directions: Vec<_> = pairs
        .iter()
        .map(|pair| pair.map(|place| place.to_direction()))
        .collect();
    let threes: Vec<_> = pairs
        .iter()
        .zip(&points.short)
        .map(|(&[a, b], &[_, c])| (a, b, c))
        .collect();
    sweep.count("GreatCircle::distance_radians", &angles, |(from, to)| {
        sphere.distance_radians(from, to)
    });
    sweep.count("GreatCircle::angle_radians", &directions, |[a, b]| {
        GreatCircle::angle_radians(a, b)
    });
    sweep.count("GreatCircle::intermediate", pairs, |[a, b]| {
        sphere.intermediate(a, b, T::of(0.25))
    });
    sweep.count("GreatCircle::midpoint", pairs, |[a, b]| sphere.midpoint(a, b));
    sweep.count("GreatCircle::cross_track", &threes, |(a, b, c)| {
        sphere.cross_track(c, a, b)
    });
    sweep.count("GreatCircle::along_track", &threes, |(a, b, c)| {
        sphere.along_track(c, a, b)
    });
}

pub fn karney<T: Real>(sweep: Sweep, points: &Points<T>) {
    let earth = Ellipsoid::WGS84;
    let (karney, area) = (Karney::new(earth).unwrap(), Area::new(earth).unwrap());
    let pairs = &points.ordinary;
    let starts: Vec<_> = points
        .places
        .iter()
        .zip(&points.units)
        .map(|(&place, &[x, y])| (place, x, y))
        .collect();
    let (azimuth, distance) = (|x| x * T::of(180.0), |y| y * T::of(2e7));
    let line = karney.line(points.places[0], T::of(30.0)).unwrap();
    sweep.count("Karney::solve", pairs, |[from, to]| karney.solve(from, to));
    sweep.count("Karney::line", &starts, |(place, x, _)| karney.line(place, azimuth(x)));
    sweep.count("Line::at", &starts, |(_, _, y)| line.at(distance(y)));
    sweep.count("Area::under", pairs, |[from, to]| area.under(from, to));
    sweep.count("Area::under_direct", &starts, |(place, x, y)| {
        area.under_direct(place, azimuth(x), distance(y))
    });
    sweep.count("PolygonArea, triangle", pairs, |[from, to]| {
        let mut polygon = area.polygon();
        for corner in [from, to, points.places[0]] {
            polygon.add(corner);
        }
        polygon.area()
    });
}
