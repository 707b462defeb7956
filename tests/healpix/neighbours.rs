//! Neighbours and corners: what the numbers say, and where the pixels are.

use std::collections::{BTreeMap, BTreeSet};

use fastrand::Rng;
use terrella::LatLon;
use terrella::healpix::{Corner, Pixel, Side};

use super::ring::all;

/// A point as whole numbers: the same for all pixels that meet there.
fn point(place: LatLon<f64>) -> [i64; 3] {
    place.to_direction().to_array().map(|x| (x * 1e9).round() as i64)
}

/// Pixels are neighbours by where they are: beyond a side if they share two corners, beyond a corner if they share one.
#[test]
fn neighbours_share_corners() {
    for depth in 0..=5 {
        let mut meeting = BTreeMap::<_, BTreeSet<_>>::new();
        for pixel in all(depth) {
            for corner in pixel.corners() {
                meeting.entry(point(corner)).or_default().insert(pixel);
            }
        }
        assert_eq!(meeting.values().filter(|pixels| pixels.len() == 3).count(), 8);
        assert!(meeting.values().all(|pixels| (3..=4).contains(&pixels.len())));
        for pixel in all(depth) {
            let [south, east, north, west] = pixel.corners().map(|corner| meeting[&point(corner)].clone());
            let beyond_side = |a: &BTreeSet<Pixel>, b: &BTreeSet<Pixel>| -> Vec<Pixel> {
                a.intersection(b).copied().filter(|&other| other != pixel).collect()
            };
            let mut beyond = BTreeSet::from([pixel]);
            for (side, [a, b]) in [
                (Side::SouthWest, [&south, &west]),
                (Side::NorthWest, [&north, &west]),
                (Side::NorthEast, [&north, &east]),
                (Side::SouthEast, [&south, &east]),
            ] {
                let neighbour = pixel.neighbour(side);
                assert_eq!(beyond_side(a, b), [neighbour], "{pixel:?} {side:?}");
                beyond.insert(neighbour);
            }
            for (corner, meeting) in [
                (Corner::South, &south),
                (Corner::West, &west),
                (Corner::North, &north),
                (Corner::East, &east),
            ] {
                let others: Vec<_> = meeting.difference(&beyond).copied().collect();
                let diagonal: Vec<_> = pixel.diagonal(corner).into_iter().collect();
                assert_eq!(others, diagonal, "{pixel:?} {corner:?}");
            }
        }
    }
}

/// Who has a neighbour is a neighbour, in any depth; and all are listed in the order of healpy.
#[test]
fn neighbours_have_each_other() {
    let mut rng = Rng::with_seed(31);
    for _ in 0..20_000 {
        let depth = rng.u8(0..=29);
        let count = 12_u64 << (2 * depth);
        // Often at the seams: numbers of ones and zeros.
        let number = match rng.u8(0..3) {
            0 => rng.u64(0..count),
            1 => count / 12 * rng.u64(1..=12) - 1,
            _ => count / 12 * rng.u64(0..12) + (rng.u64(0..count / 12) & 0x5555_5555_5555_5555 << rng.u8(0..2)),
        };
        let pixel = Pixel::new(depth, number).unwrap();
        let sides = Side::ALL.map(|side| pixel.neighbour(side));
        let corners = Corner::ALL.map(|corner| pixel.diagonal(corner));
        let listed = pixel.neighbours();
        for at in 0..4 {
            assert_eq!(listed[2 * at], Some(sides[at]));
            assert_eq!(listed[2 * at + 1], corners[(at + 1) % 4]);
            assert!(
                Side::ALL.map(|side| sides[at].neighbour(side)).contains(&pixel),
                "{pixel:?}"
            );
            if let Some(diagonal) = corners[at] {
                assert!(
                    Corner::ALL
                        .map(|corner| diagonal.diagonal(corner))
                        .contains(&Some(pixel)),
                    "{pixel:?}"
                );
            }
        }
        let missing = corners.iter().filter(|corner| corner.is_none()).count();
        assert!(missing <= if depth == 0 { 2 } else { 1 }, "{pixel:?}");
    }
}

/// The corners are the places at the corners of the pixel's square.
#[test]
fn corners_are_places_in_the_pixel() {
    for pixel in all(3) {
        let places = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|inside| pixel.place(inside).unwrap());
        assert_eq!(pixel.corners(), places);
        let places = [[0.0_f32, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]].map(|inside| pixel.place(inside).unwrap());
        assert_eq!(pixel.corners(), places);
        assert_eq!(u64::from(pixel.base()), pixel.number() >> 6);
    }
}
