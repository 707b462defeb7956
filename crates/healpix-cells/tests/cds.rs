//! Pixels of HEALPix, their numbers, corners and neighbours, against those of cdshealpix.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // a test may fail loudly

use cdshealpix::compass_point::MainWind;
use cdshealpix::{nested, ring};
use fastrand::Rng;
use terrella::LatLon;
use terrella::healpix::Pixel;

/// Every pixel to a depth.
fn all(depth: u8) -> impl Iterator<Item = Pixel> {
    (0..=depth).flat_map(|depth| (0..12 << (2 * depth)).map(move |number| Pixel::new(depth, number).unwrap()))
}

/// Pixels of the largest depth: anywhere, along sides of the base pixels, and in their corners.
fn deepest(count: u32, seed: u64) -> impl Iterator<Item = Pixel> {
    let mut rng = Rng::with_seed(seed);
    (0..count).map(move |_| {
        let side = 1_u64 << Pixel::MAX_DEPTH;
        let [x, y] = [(); 2].map(|()| match rng.u8(0..4) {
            0 => rng.u64(0..3),
            1 => side - 1 - rng.u64(0..3),
            _ => rng.u64(0..side),
        });
        let spread = |x: u64| (0..29).map(|k| (x >> k & 1) << (2 * k)).sum::<u64>();
        let number = rng.u64(0..12) << 58 | spread(x) | spread(y) << 1;
        Pixel::new(Pixel::MAX_DEPTH, number).unwrap()
    })
}

/// Deeper, cds takes the square root of a number that `f64` rounds, and is off by a ring, or overflows: at depth 29 for
/// 576 460 751 229 681 663, the last of its ring.
const EXACT_ROOTS: u8 = 25;

fn same_ring(pixel: Pixel) {
    let layer = nested::get(pixel.depth());
    let number = layer.to_ring(pixel.number());
    assert_eq!(pixel.ring_number(), number, "{pixel:?}");
    assert_eq!(Pixel::from_ring(pixel.depth(), number), Ok(pixel));
    if pixel.depth() <= EXACT_ROOTS {
        assert_eq!(layer.from_ring(number), pixel.number(), "{pixel:?}");
    }
}

#[test]
fn ring_numbers_are_those_of_cds() {
    all(8).for_each(same_ring);
    deepest(100_000, 1).for_each(same_ring);
    let mut rng = Rng::with_seed(2);
    for _ in 0..100_000 {
        let depth = rng.u8(0..=29);
        same_ring(Pixel::new(depth, rng.u64(0..12 << (2 * depth))).unwrap());
    }
}

fn same_neighbours(pixel: Pixel) {
    use MainWind::{E, N, NE, NW, S, SE, SW, W};
    let theirs = nested::neighbours(pixel.depth(), pixel.number(), false);
    let theirs = [SW, W, NW, N, NE, E, SE, S].map(|wind| theirs.get(wind).copied());
    assert_eq!(
        pixel.neighbours().map(|pixel| pixel.map(Pixel::number)),
        theirs,
        "{pixel:?}"
    );
}

#[test]
fn neighbours_are_those_of_cds() {
    all(6).for_each(same_neighbours);
    deepest(100_000, 3).for_each(same_neighbours);
}

/// The distance of a place from cds's longitude and latitude, in radians.
fn apart(place: LatLon<f64>, (lon, lat): (f64, f64)) -> f64 {
    let ours = place.to_direction().to_array();
    let theirs = [lat.cos() * lon.cos(), lat.cos() * lon.sin(), lat.sin()];
    (0..3).map(|at| (ours[at] - theirs[at]).powi(2)).sum::<f64>().sqrt()
}

fn same_corners(pixel: Pixel) {
    let (depth, number) = (pixel.depth(), pixel.number());
    for (ours, theirs) in pixel.corners().into_iter().zip(nested::vertices(depth, number)) {
        let apart = apart(ours, theirs);
        assert!(apart <= 2e-15, "{pixel:?}: {ours:?}, {theirs:?}, {apart:e}");
    }
    assert!(
        apart(pixel.centre(), nested::center(depth, number)) <= 2e-15,
        "{pixel:?}"
    );
}

#[test]
fn corners_are_those_of_cds() {
    all(6).for_each(same_corners);
    deepest(100_000, 4).for_each(same_corners);
}

/// How near a place is to the edges of its pixel, in pixels, as cds says.
fn margin(depth: u8, lon: f64, lat: f64) -> f64 {
    let (_, dx, dy) = nested::hash_with_dxdy(depth, lon, lat);
    [dx, 1.0 - dx, dy, 1.0 - dy]
        .into_iter()
        .reduce(testkit::minimum)
        .unwrap()
}

/// The rounding of a sine and of the longitude in radians, in pixels of the largest depth.
const ROUNDING: f64 = 1e-6;

/// Random places are in the pixels in which cds has them, except those on an edge but for rounding.
fn places(count: u32, seed: u64) {
    let mut rng = Rng::with_seed(seed);
    let mut differ = 0;
    for _ in 0..count {
        let lat = (2.0 * rng.f64() - 1.0).asin().to_degrees();
        let place = LatLon::new(lat, 360.0 * rng.f64() - 180.0).unwrap();
        let (lat, lon) = (place.lat().to_radians(), place.lon().to_radians());
        for depth in [0, 3, 8, 15, 20, 29] {
            let pixel = Pixel::containing(place, depth).unwrap();
            let both = (pixel.number(), pixel.ring_number());
            let theirs = (nested::hash(depth, lon, lat), ring::hash(1 << depth, lon, lat));
            if both != theirs {
                let margin = margin(depth, lon, lat);
                let context = format!("{place:?} {depth}: {both:?}, {theirs:?}, {margin:e}");
                assert!(depth == 29 && margin <= ROUNDING, "{context}");
                println!("{context}");
                differ += 1;
            }
        }
    }
    println!("{differ} of {count} differ");
}

#[test]
fn places_are_in_the_pixels_of_cds() {
    places(100_000, 5);
}

#[test]
#[ignore = "ten million"]
fn ten_million_places_are_in_the_pixels_of_cds() {
    places(10_000_000, 6);
}
