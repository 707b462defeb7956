//! Angles alone.

use terrella::LatLon;
use terrella::math::{atan2_degrees, sin_cos_degrees};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Nothing;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Angles":
    "wrap" "lon -> the same longitude in [-180, 180]", wrap(Nothing);
    "sincosd" "degrees -> sine cosine", sine_and_cosine(Nothing);
    "atan2d" "y x -> degrees of the direction (x, y) from the x axis", arc_tangent(Nothing);
};

fn wrap<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|lon: T| Ok(LatLon::new(T::ZERO, lon)?.lon()))
}

fn sine_and_cosine<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|degrees: T| Ok(<[T; 2]>::from(sin_cos_degrees(degrees))))
}

fn arc_tangent<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|[y, x]: [T; 2]| Ok(atan2_degrees(y, x)))
}
