//! Ring numbers: their definition, and both ways.

use fastrand::Rng;
use terrella::healpix::{InvalidPixel, Pixel};

/// Every pixel of a depth.
pub fn all(depth: u8) -> impl Iterator<Item = Pixel> {
    (0..12 << (2 * depth)).map(move |number| Pixel::new(depth, number).unwrap())
}

/// The definition: from north to south, and eastward from longitude 0.
#[test]
fn rings_go_from_north_to_south_and_eastward() {
    for depth in 0..=6 {
        let mut centres: Vec<_> = all(depth)
            .map(|pixel| {
                let centre = pixel.centre::<f64>();
                // Centres of one ring have the same latitude up to rounding.
                let lat = (-centre.lat() * 1e9).round() as i64;
                (lat, (centre.lon().rem_euclid(360.0) * 1e9) as i64, pixel)
            })
            .collect();
        centres.sort_unstable();
        for (at, (.., pixel)) in centres.into_iter().enumerate() {
            assert_eq!(pixel.ring_number(), at as u64, "{pixel:?}");
            assert_eq!(Pixel::from_ring(depth, at as u64), Ok(pixel));
        }
    }
}

/// The first and the last pixel of rings: a square root that is not exact is off by a ring there.
#[test]
fn ends_of_rings_are_in_their_rings() {
    let mut rng = Rng::with_seed(21);
    for _ in 0..20_000 {
        let depth = rng.u8(1..=29);
        let (side, count) = (1 << depth, 12_u64 << (2 * depth));
        let ring = match rng.u8(0..3) {
            0 => 1 + rng.u64(0..side).min(2),
            1 => side - rng.u64(0..side).min(2),
            _ => rng.u64(1..=side),
        };
        let first = 2 * ring * (ring - 1);
        for number in [first, first + ring - 1, first + ring, first + 4 * ring - 1] {
            for number in [number, count - 1 - number] {
                let pixel = Pixel::from_ring(depth, number).unwrap();
                assert_eq!(pixel.ring_number(), number, "{depth}");
            }
        }
        // The corner of the first pixel's base pixel: y is the largest, and x counts rings.
        let start = Pixel::from_ring(depth, first).unwrap();
        let ones = |number: u64| {
            (0..29)
                .filter(|k| number >> (2 * k) & 1 == 1)
                .map(|k| 1 << k)
                .sum::<u64>()
        };
        assert_eq!(
            [ones(start.number()), ones(start.number() >> 1) & (side - 1)],
            [side - ring, side - 1]
        );
    }
}

#[test]
fn any_number_comes_back() {
    let mut rng = Rng::with_seed(22);
    for _ in 0..100_000 {
        let depth = rng.u8(0..=29);
        let number = rng.u64(0..12 << (2 * depth));
        let pixel = Pixel::from_ring(depth, number).unwrap();
        assert_eq!((pixel.depth(), pixel.ring_number()), (depth, number));
        let pixel = Pixel::new(depth, number).unwrap();
        assert_eq!(Pixel::from_ring(depth, pixel.ring_number()), Ok(pixel));
    }
}

#[test]
fn what_is_no_ring_number_is_refused() {
    for depth in 30..=u8::MAX {
        assert_eq!(Pixel::from_ring(depth, 0), Err(InvalidPixel::Depth(depth)));
    }
    for depth in 0..=29 {
        let count = 12_u64 << (2 * depth);
        for number in [count, u64::MAX] {
            assert_eq!(
                Pixel::from_ring(depth, number),
                Err(InvalidPixel::Number { depth, number })
            );
        }
    }
}

#[test]
fn constants_are_computed_when_compiling() {
    const FIRST: Result<Pixel, InvalidPixel> = Pixel::from_ring(29, 0);
    const NUMBER: u64 = match FIRST {
        Ok(pixel) => pixel.number(),
        Err(_) => 0,
    };
    assert_eq!(NUMBER, (1 << 58) - 1);
}
