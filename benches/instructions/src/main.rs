//! Calls each function over the same few hundred points, one function after the other; `run` counts the instructions.

mod cube;
mod geodesic;
mod points;
mod position;
mod sweep;

use points::Points;
use sweep::Sweep;
use terrella::Real;

fn every<T: Real>() {
    let points = Points::<T>::new();
    let sweep = Sweep::of::<T>();
    sweep.count("nothing", &points.units, |_| ());
    position::kernels(sweep, &points);
    position::positions(sweep, &points);
    position::latitudes(sweep, &points);
    position::frames(sweep, &points);
    cube::projections(sweep, &points);
    cube::distortion(sweep, &points);
    geodesic::methods(sweep, &points);
    geodesic::scene(sweep, &points);
    geodesic::great_circle(sweep, &points);
    geodesic::karney(sweep, &points);
}

fn main() {
    every::<f64>();
    every::<f32>();
}
