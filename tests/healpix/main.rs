//! Standard HEALPix against truth of 25 digits, with which healpy and cdshealpix agree, and against itself.
#![allow(
    missing_docs, clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing
)] // tests

mod neighbours;
mod on_ellipsoid;
mod ring;

use fastrand::Rng;
use terrella::LatLon;
use terrella::healpix::{self, InvalidPixel, InvalidPixelPlace, OutsidePlane, Pixel};
use testkit::Worst;
use testkit::table;
use testkit::truth::{Row, Scalar, Truth};

fn place_of<T: Scalar>(row: Row<'_>) -> LatLon<T> {
    LatLon::new(row.input("lat"), row.input("lon")).unwrap()
}

/// How far a place is from the truth, in radians on the sphere.
fn displacement<T: Scalar>(row: Row<'_>, place: LatLon<T>) -> f64 {
    let turn = row.error("lon", place.lon());
    let turn = testkit::minimum(turn, (turn - 360.0).abs()) * row.value("lat").to_radians().cos();
    row.error("lat", place.lat()).hypot(turn).to_radians()
}

/// Every pixel of the file is right that is farther from the pixel's edge than a share of a pixel of depth 29, or of `depth`.
fn pixels<T: Scalar>(
    name: &str,
    depth: u8,
    share: f64,
    containing: impl Fn(LatLon<T>, u8) -> Result<Pixel, InvalidPixel>,
) {
    let truth = Truth::read(name);
    let mut compared = 0;
    for row in truth.exact_in::<T>(&["lat", "lon"]) {
        let number: u64 = row.text("pixel").parse().unwrap();
        let up = Pixel::MAX_DEPTH - depth;
        let rest = |shift: u32| {
            (0..u32::from(up))
                .map(|k| (number >> (2 * k + shift) & 1) << k)
                .sum::<u64>() as f64
        };
        let last = f64::from(1_u32 << up) - 1.0;
        let margin = if up == 0 {
            row.value("margin")
        } else {
            let [x, y] = [rest(0), rest(1)].map(|rest| testkit::minimum(rest, last - rest));
            testkit::minimum(x, y) / (last + 1.0)
        };
        if margin > share {
            let found = containing(place_of::<T>(row), depth).unwrap();
            assert_eq!(
                found.number(),
                number >> (2 * up),
                "{} {}",
                row.text("lat"),
                row.text("lon")
            );
            compared += 1;
        }
    }
    println!("{compared} pixels of depth {depth}");
    assert!(compared > 200, "{compared}");
}

#[test]
fn places_are_in_their_pixels() {
    pixels::<f64>("healpix_pixels", 29, 1e-6, Pixel::containing);
    pixels::<f32>("healpix_pixels", 20, 0.1, Pixel::containing);
    pixels::<f32>("healpix_pixels", 12, 0.01, Pixel::containing);
}

fn plane<T: Scalar>(name: &str, claimed: f64, to_plane: impl Fn(LatLon<T>) -> [T; 2]) {
    let truth = Truth::read(name);
    let mut worst = Worst::default();
    for row in truth.exact_in::<T>(&["lat", "lon"]) {
        let [x, y] = to_plane(place_of::<T>(row));
        let across = row.error("x", x);
        worst.add(testkit::minimum(across, (across - 8.0).abs()).hypot(row.error("y", y)));
    }
    let worst = worst.value();
    println!("to the plane, {}: {worst:e}", T::NAME);
    assert!(worst <= claimed, "{worst:e}");
}

#[test]
fn the_plane_is_as_accurate_as_claimed() {
    plane::<f64>("healpix_pixels", 8.6e-16, healpix::to_plane);
    plane::<f32>("healpix_pixels", 4.6e-7, healpix::to_plane);
}

/// The largest error of places in pixels, and of those from the plane.
fn places<T: Scalar>(
    name: &str,
    exact: i32,
    place_in: impl Fn(Pixel, [T; 2]) -> Result<LatLon<T>, InvalidPixelPlace<T>>,
    from_plane: impl Fn([T; 2]) -> Result<LatLon<T>, OutsidePlane<T>>,
) -> f64 {
    let truth = Truth::read(name);
    let (mut worst, mut worst_back) = (Worst::default(), Worst::default());
    for row in truth.exact_in::<T>(&["dx", "dy"]) {
        let (depth, number) = (row.value("depth") as u8, row.text("pixel").parse().unwrap());
        let pixel = Pixel::new(depth, number).unwrap();
        let inside = [row.input::<T>("dx"), row.input::<T>("dy")];
        let place = place_in(pixel, inside).unwrap();
        worst.add(displacement(row, place));
        if i32::from(depth) <= exact {
            let [x, y] = exact_plane(pixel, inside.map(Into::into)).map(|v| T::lift(v).unwrap());
            let place = from_plane([x, y]).unwrap();
            worst_back.add(displacement(row, place));
        }
    }
    let [worst, worst_back] = [worst, worst_back].map(Worst::value);
    println!("places, {}: {worst:e}, from the plane {worst_back:e}", T::NAME);
    testkit::maximum(worst, worst_back)
}

/// The point of the plane, exact for pixels that are not too small.
fn exact_plane(pixel: Pixel, [dx, dy]: [f64; 2]) -> [f64; 2] {
    let across = f64::from(1_u32 << pixel.depth());
    let index = |shift: u32| {
        (0..u32::from(pixel.depth()))
            .map(|k| (pixel.number() >> (2 * k + shift) & 1) << k)
            .sum::<u64>() as f64
    };
    let (a, b) = ((index(0) + dx) / across, (index(1) + dy) / across);
    let base = pixel.number() >> (2 * pixel.depth());
    let (row, column) = ((base / 4) as f64, (base % 4) as f64);
    let x = 2.0 * column + f64::from(u8::from(row != 1.0)) + a - b;
    [x.rem_euclid(8.0), 1.0 - row + a + b - 1.0]
}

#[test]
fn places_in_pixels_are_as_accurate_as_claimed() {
    let name = "healpix_places";
    let worst = [
        places::<f64>(name, 20, Pixel::place, healpix::from_plane),
        places::<f32>(name, 0, Pixel::place, healpix::from_plane),
    ];
    table::hold("healpix::Pixel::place and healpix::from_plane", worst);
}

/// astropy-healpix #34, #38 and #93: next to the pole 1 − |z| has no digits left, and a place and its pixel part.
#[test]
fn next_to_the_poles_pixels_are_where_places_are() {
    let mut rng = Rng::with_seed(1);
    for _ in 0..100_000 {
        let off = 10_f64.powf(-14.0 * rng.f64());
        let lat = (90.0 - off).copysign(rng.f64() - 0.5);
        let lon = 360.0 * rng.f64() - 180.0;
        let place = LatLon::new(lat, lon).unwrap();
        let pixel = Pixel::containing(place, 29).unwrap();
        let centre = pixel.centre::<f64>();
        let apart = |a: LatLon<f64>, b: LatLon<f64>| {
            let [a, b] = [a, b].map(|place| place.to_direction().to_array());
            (0..3).map(|at| (a[at] - b[at]).powi(2)).sum::<f64>().sqrt()
        };
        // Half of the diagonal of a pixel of this depth next to a pole.
        let apart = apart(place, centre);
        assert!(apart <= 2.5e-9, "{place:?} {pixel:?} {centre:?} {apart:e}");
    }
    for (lat, lon, base) in [
        (90.0, 0.0, 0),
        (90.0, 89.9, 0),
        (90.0, 90.0, 1),
        (90.0, 180.0, 2),
        (90.0, -180.0, 2),
        (90.0, -90.0, 3),
        (90.0, -1e-300, 3),
        (-90.0, 45.0, 8),
        (-90.0, -0.0, 8),
    ] {
        for depth in 0..=29 {
            let pixel = Pixel::containing(LatLon::new(lat, lon).unwrap(), depth).unwrap();
            let last = if lat > 0.0 { (1_u64 << (2 * depth)) - 1 } else { 0 };
            assert_eq!(pixel.number(), (base << (2 * depth)) + last, "{lat} {lon} {depth}");
        }
    }
}

/// healpy's `ang2pix(nside, lon, lat, lonlat=True, nest=True)`.
#[test]
fn base_pixels_are_where_healpy_has_them() {
    for (lat, lon, base) in [
        (0.0, 0.0, 4),
        (0.0, 44.9, 4),
        (0.0, 45.1, 5),
        (0.0, 90.0, 5),
        (0.0, -45.1, 7),
        (0.0, -44.9, 4),
        (0.0, 180.0, 6),
        (0.0, -180.0, 6),
        (41.81, 45.0, 0),
        (-41.81, 45.0, 8),
        (60.0, -135.0, 2),
        (-60.0, -45.0, 11),
    ] {
        let pixel = Pixel::containing(LatLon::new(lat, lon).unwrap(), 0).unwrap();
        assert_eq!(pixel.number(), base, "{lat} {lon}");
    }
    let vega = LatLon::new(38.78369, 279.23473).unwrap();
    assert_eq!(Pixel::containing(vega, 9).unwrap().number(), 954_011);
}

#[test]
fn base_pixels_have_equal_areas() {
    let mut rng = Rng::with_seed(2);
    let count = 240_000;
    let mut hits = [0_i32; 192];
    for _ in 0..count {
        let lat = (2.0 * rng.f64() - 1.0).asin().to_degrees();
        let place = LatLon::new(lat, 360.0 * rng.f64() - 180.0).unwrap();
        hits[Pixel::containing(place, 2).unwrap().number() as usize] += 1;
    }
    for (pixel, hits) in hits.into_iter().enumerate() {
        assert!((hits - count / 192).abs() < 200, "{pixel}: {hits}");
    }
}

#[test]
fn what_is_no_pixel_is_refused() {
    for depth in 30..=u8::MAX {
        assert_eq!(Pixel::new(depth, 0), Err(InvalidPixel::Depth(depth)));
        let place = LatLon::new(0.0, 0.0).unwrap();
        assert_eq!(Pixel::containing(place, depth), Err(InvalidPixel::Depth(depth)));
    }
    for depth in 0..=29 {
        let count = 12_u64 << (2 * depth);
        assert!(Pixel::new(depth, count - 1).is_ok());
        for number in [count, u64::MAX] {
            assert_eq!(Pixel::new(depth, number), Err(InvalidPixel::Number { depth, number }));
        }
    }
    let pixel = Pixel::new(3, 100).unwrap();
    for bad in [-f64::EPSILON, 1.0 + f64::EPSILON, f64::NAN, f64::INFINITY] {
        let refused = pixel.place([0.5, bad]).unwrap_err();
        assert_eq!((refused.dx, refused.dy.to_bits()), (0.5, bad.to_bits()));
        assert!(pixel.place([bad, 0.5]).is_err());
    }
    for (x, y) in [
        (-0.1, 0.0),
        (8.1, 0.0),
        (1.0, 2.1),
        (0.5, 1.75),
        (f64::NAN, 0.0),
        (1.0, f64::NAN),
    ] {
        let refused = healpix::from_plane([x, y]).unwrap_err();
        assert_eq!([refused.x.to_bits(), refused.y.to_bits()], [x.to_bits(), y.to_bits()]);
    }
    let said = [
        InvalidPixel::Depth(30).to_string(),
        InvalidPixel::Number { depth: 1, number: 48 }.to_string(),
        healpix::from_plane([0.5, 1.75]).unwrap_err().to_string(),
        pixel.place([0.5, 1.5]).unwrap_err().to_string(),
    ];
    assert_eq!(
        said,
        [
            "depth 30 is not in 0 to 29",
            "pixel 48 is not in 0 to 12·4^1 - 1",
            "(0.5, 1.75) is outside HEALPix's plane",
            "(0.5, 1.5) is not in [0, 1]²"
        ]
    );
}

fn same_pixel<T: Scalar>(depth: u8, number: u64, inside: [T; 2]) {
    let pixel = Pixel::new(depth, number % (12 << (2 * depth))).unwrap();
    let place = pixel.place(inside).unwrap();
    assert_eq!(Pixel::containing(place, depth), Ok(pixel), "{inside:?}");
}

/// How many random inputs are tried.
const CASES: u32 = 4000;

fn place(rng: &mut Rng) -> LatLon<f64> {
    LatLon::new(90.0 * (2.0 * rng.f64() - 1.0), 180.0 * (2.0 * rng.f64() - 1.0)).unwrap()
}

#[test]
fn a_place_in_a_pixel_is_in_the_pixel() {
    let mut rng = Rng::with_seed(11);
    for _ in 0..CASES {
        let (depth, number) = (rng.u8(0..=29), rng.u64(..));
        let [x, y] = [(); 2].map(|()| 0.01 + 0.98 * rng.f64());
        same_pixel(depth, number, [x, y]);
        same_pixel(depth.min(16), number, [x as f32, y as f32]);
    }
}

#[test]
fn a_pixel_is_in_its_parent() {
    let mut rng = Rng::with_seed(12);
    for _ in 0..CASES {
        let (place, depth) = (place(&mut rng), rng.u8(1..=29));
        let number = |depth| Pixel::containing(place, depth).unwrap().number();
        assert_eq!(number(depth) >> 2, number(depth - 1), "{place:?} {depth}");
    }
}

#[test]
fn the_plane_comes_back() {
    let mut rng = Rng::with_seed(13);
    for _ in 0..CASES {
        let place = place(&mut rng);
        let back = healpix::from_plane(healpix::to_plane(place)).unwrap();
        let [a, b] = [place, back].map(|place| place.to_direction().to_array());
        let apart = (0..3).map(|at| (a[at] - b[at]).powi(2)).sum::<f64>().sqrt();
        assert!(apart <= 2e-15, "{place:?} {back:?}");
    }
}

/// From any numbers at all: no panic, and what is given is a place.
#[test]
fn any_input_is_handled() {
    let mut rng = Rng::with_seed(14);
    for _ in 0..CASES {
        let [x, y] = [(); 2].map(|()| f32::from_bits(rng.u32(..)));
        let [dx, dy] = [(); 2].map(|()| f64::from_bits(rng.u64(..)));
        let (depth, number) = (rng.u8(..), rng.u64(..) >> rng.u32(0..64));
        for point in [[x, y], [x.abs() % 8.0, y % 2.0]] {
            if let Ok(place) = healpix::from_plane(point) {
                assert!(place.lat().abs() <= 90.0 && place.lon().abs() <= 180.0, "{point:?}");
            }
        }
        if let Ok(pixel) = Pixel::new(depth % 32, number) {
            for inside in [[dx, dy], [dx.abs() % 1.0, dy.abs() % 1.0]] {
                if let Ok(place) = pixel.place(inside) {
                    let found = place.lat().abs() <= 90.0 && place.lon().abs() <= 180.0;
                    assert!(found, "{pixel:?} {inside:?}");
                }
            }
        }
    }
}
