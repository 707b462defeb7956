//! Standard HEALPix (Górski and others 2005), of the sphere or of an ellipsoid.

use std::fmt;

use terrella::LatLon;
use terrella::healpix::Pixel;

use super::{Answer, Failure, Group, answer, group};
use crate::options::{Pixels, Scheme, SphereOrPlanet};
use crate::read::Number;
use crate::write::{Columns, Row};

pub const GROUP: Group = group! {
    "HEALPix: 2^depth pixels along a side of each of the twelve, in nested order, or with --ring by rings":
    "healpix" "depth lat lon -> pixel", pixel(Pixels);
    "healpix-place"
        "depth pixel dx dy -> lat lon in it: dx to the north-east, dy to the north-west, 0 to 1", place(Pixels);
    "healpix-corners" "depth pixel -> lat lon of its southern, eastern, northern, western corner", corners(Pixels);
    "healpix-neighbours"
        "depth pixel -> the pixels SW W NW N NE E SE S of it, -1 where there is none", neighbours(Scheme);
    "healpix-plane" "lat lon -> x y, in [0, 8) and [-2, 2], quarters of pi", plane(SphereOrPlanet);
    "healpix-unplane" "x y in the plane -> lat lon", unplane(SphereOrPlanet);
};

impl Scheme {
    /// The pixel of a depth and a number.
    fn pixel(&self, depth: u8, number: u64) -> Result<Pixel, Failure> {
        let of = if self.ring { Pixel::from_ring } else { Pixel::new };
        Ok(of(depth, number)?)
    }

    fn number(&self, pixel: Pixel) -> u64 {
        if self.ring { pixel.ring_number() } else { pixel.number() }
    }
}

/// A number, or −1 for none.
struct OrNone(Option<u64>);

impl Row for OrNone {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        match self.0 {
            Some(number) => number.write(columns),
            None => columns.put(-1),
        }
    }
}

fn pixel<T: Number>(Pixels { scheme, surface }: Pixels) -> Result<Answer, Failure> {
    let surface = surface.healpix()?;
    answer(move |(depth, place): (u8, LatLon<T>)| Ok(scheme.number(surface.containing(place, depth)?)))
}

fn place<T: Number>(Pixels { scheme, surface }: Pixels) -> Result<Answer, Failure> {
    let surface = surface.healpix()?;
    answer(move |(depth, number, within): (u8, u64, [T; 2])| Ok(surface.place(scheme.pixel(depth, number)?, within)?))
}

fn corners<T: Number>(Pixels { scheme, surface }: Pixels) -> Result<Answer, Failure> {
    let surface = surface.healpix::<T>()?;
    answer(move |(depth, number): (u8, u64)| Ok(surface.corners(scheme.pixel(depth, number)?)))
}

fn neighbours<T: Number>(scheme: Scheme) -> Result<Answer, Failure> {
    answer(move |(depth, number): (u8, u64)| {
        let around = scheme.pixel(depth, number)?.neighbours();
        Ok(around.map(|pixel| OrNone(pixel.map(|pixel| scheme.number(pixel)))))
    })
}

fn plane<T: Number>(surface: SphereOrPlanet) -> Result<Answer, Failure> {
    let surface = surface.healpix()?;
    answer(move |place: LatLon<T>| Ok(surface.to_plane(place)))
}

fn unplane<T: Number>(surface: SphereOrPlanet) -> Result<Answer, Failure> {
    let surface = surface.healpix()?;
    answer(move |point: [T; 2]| Ok(surface.from_plane(point)?))
}
