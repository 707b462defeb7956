//! Standard HEALPix (Górski and others 2005), of the sphere.

use terrella::LatLon;
use terrella::healpix::{Pixel, from_plane, to_plane};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Nothing;
use crate::read::Number;

pub const GROUP: Group = group! {
    "HEALPix: 2^depth pixels along a side of each of the twelve, in nested order":
    "healpix" "depth lat lon -> pixel", pixel(Nothing);
    "healpix-place"
        "depth pixel dx dy -> lat lon in it: dx to the north-east, dy to the north-west, 0 to 1", place(Nothing);
    "healpix-plane" "lat lon -> x y, in [0, 8) and [-2, 2], quarters of pi", plane(Nothing);
    "healpix-unplane" "x y in the plane -> lat lon", unplane(Nothing);
};

fn pixel<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(depth, place): (u8, LatLon<T>)| Ok(Pixel::containing(place, depth)?.number()))
}

fn place<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(depth, pixel, within): (u8, u64, [T; 2])| Ok(Pixel::new(depth, pixel)?.place(within)?))
}

fn plane<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|place: LatLon<T>| Ok(to_plane(place)))
}

fn unplane<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|point: [T; 2]| Ok(from_plane(point)?))
}
