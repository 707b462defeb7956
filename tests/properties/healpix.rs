//! Pixels of HEALPix: both numbers, neighbours by their corners, and where places are, on the sphere and on ellipsoids.

use terrella::healpix::{Corner, InvalidPixel, OnEllipsoid, Pixel, Side, from_plane, to_plane};
use terrella::{Ellipsoid, LatLon};

use testkit::bytes::Bytes;
use testkit::scalar::Scalar;
use testkit::table::claim;
use testkit::vector::apart;
use testkit::{minimum, properties};

properties! { numbers neighbours place_is_true containing ellipsoid any }

/// A pixel of a depth to the largest that is given: anywhere, or along the sides of a base pixel.
fn pixel(bytes: &mut Bytes<'_>, deepest: u8) -> Pixel {
    let depth = bytes.byte() % (deepest + 1);
    let part = (1_u64 << (2 * depth)) - 1;
    let base = u64::from(bytes.byte() % 12) << (2 * depth);
    let number = bytes.word();
    // Ones and zeros in one coordinate or both.
    let kept = bytes.choice(&[u64::MAX, 0, 0x5555_5555_5555_5555, 0xaaaa_aaaa_aaaa_aaaa]);
    let filled = if bytes.flag() { !kept } else { 0 };
    Pixel::new(depth, base | (number & kept | filled) & part).unwrap()
}

/// A part of a pixel's side, at least a hundredth from its ends.
fn inside<T: Scalar>(bytes: &mut Bytes<'_>) -> [T; 2] {
    [(); 2].map(|()| T::of(0.5 + 0.49 * bytes.within::<f64>(1.0)))
}

fn doubled<T: Scalar>(place: LatLon<T>) -> LatLon<f64> {
    LatLon::new(place.lat().into(), place.lon().into()).unwrap()
}

fn vector<T: Scalar>(place: LatLon<T>) -> [f64; 3] {
    doubled(place).to_direction().to_array()
}

/// The Earth in a scalar, and the same ellipsoid in `f64`.
fn earths<T: Scalar>() -> (OnEllipsoid<T>, OnEllipsoid<f64>) {
    let earth = Ellipsoid::<T>::WGS84;
    let exact = Ellipsoid::new(earth.a().into(), earth.f().into()).unwrap();
    (OnEllipsoid::new(earth).unwrap(), OnEllipsoid::new(exact).unwrap())
}

/// Any number is refused in both schemes or in none; the schemes have the same pixels; rings go from north to south.
fn numbers<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (depth, number) = (bytes.byte(), bytes.word() >> (bytes.byte() % 64));
    let (nested, ring) = (Pixel::new(depth, number), Pixel::from_ring(depth, number));
    assert_eq!(nested.err(), ring.err(), "{depth} {number}");
    let refused = match nested {
        Err(InvalidPixel::Depth(refused)) => refused == depth && depth > 29,
        Err(why) => why == InvalidPixel::Number { depth, number },
        Ok(_) => depth <= 29,
    };
    assert!(refused, "{depth} {number}");
    let pixel = nested.unwrap_or_else(|_| pixel(bytes, Pixel::MAX_DEPTH));
    let (depth, number) = (pixel.depth(), pixel.number());
    let count = 12_u64 << (2 * depth);
    let ring = pixel.ring_number();
    assert!(number < count && ring < count, "{pixel:?}");
    assert_eq!(Pixel::from_ring(depth, ring), Ok(pixel));
    let beside = [ring.wrapping_sub(1), ring + 1, bytes.word() % count].map(|ring| Pixel::from_ring(depth, ring));
    for other in beside.into_iter().flatten() {
        let [here, there] = [pixel, other].map(|pixel| Into::<f64>::into(pixel.centre::<T>().lat()));
        let order = other.ring_number().cmp(&ring);
        assert!(
            (here - there).abs() <= 90.0 * 4.0 * T::EPSILON.into() || here.total_cmp(&there) == order,
            "{pixel:?} {other:?} {here} {there}"
        );
    }
}

/// Who has a neighbour is a neighbour; across a side two corners are the same, across a corner one is.
fn neighbours<T: Scalar>(bytes: &mut Bytes<'_>) {
    let pixel = pixel(bytes, Pixel::MAX_DEPTH);
    let claimed = 2.0 * claim("healpix::Pixel::place and healpix::from_plane")[T::CLAIM];
    let shared = |other: Pixel, mine: &[usize]| {
        let [ours, theirs] = [pixel, other].map(|pixel| pixel.corners::<T>().map(vector));
        for &at in mine {
            let nearest = theirs.into_iter().map(|corner| apart(ours[at], corner)).reduce(minimum);
            assert!(
                nearest.is_some_and(|apart| apart <= claimed),
                "{pixel:?} {other:?} {at}: {nearest:?}"
            );
        }
    };
    // South, east, north, west.
    for (side, ends) in Side::ALL.into_iter().zip([[0, 3], [3, 2], [2, 1], [1, 0]]) {
        let other = pixel.neighbour(side);
        assert!(
            other != pixel && Side::ALL.map(|side| other.neighbour(side)).contains(&pixel),
            "{pixel:?} {side:?}"
        );
        shared(other, &ends);
    }
    for (corner, at) in Corner::ALL.into_iter().zip([0, 3, 2, 1]) {
        if let Some(other) = pixel.diagonal(corner) {
            let back = Corner::ALL.map(|corner| other.diagonal(corner));
            assert!(back.contains(&Some(pixel)), "{pixel:?} {corner:?}");
            shared(other, &[at]);
        }
    }
}

/// A place in a pixel is where the same formulas in `f64` have it.
fn place_is_true<T: Scalar>(bytes: &mut Bytes<'_>) {
    let pixel = pixel(bytes, Pixel::MAX_DEPTH);
    let within = [(); 2].map(|()| bytes.within::<T>(1.0).abs());
    let (earth, exact) = earths::<T>();
    let double = within.map(Into::<f64>::into);
    let claimed = |what| claim(what)[T::CLAIM];
    let error = apart(
        vector(pixel.place(within).unwrap()),
        vector(pixel.place(double).unwrap()),
    );
    assert!(
        error <= claimed("healpix::Pixel::place and healpix::from_plane"),
        "{pixel:?} {within:?}: {error:e}"
    );
    let error = apart(
        vector(earth.place(pixel, within).unwrap()),
        vector(exact.place(pixel, double).unwrap()),
    );
    assert!(
        error <= claimed("healpix::OnEllipsoid::place and from_plane"),
        "{pixel:?} {within:?}: {error:e}"
    );
}

/// A place is in the square of the plane that its pixel is, and in the pixels of all smaller depths around that one.
fn containing<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (place, depth) = (bytes.place::<T>(), bytes.byte() % 30);
    let pixel = Pixel::containing(place, depth).unwrap();
    let context = || format!("{} {place:?} {pixel:?}", T::NAME);
    let coarse = bytes.byte() % (depth + 1);
    let around = Pixel::new(coarse, pixel.number() >> (2 * (depth - coarse)));
    assert_eq!(Pixel::containing(place, coarse), around, "{}", context());
    let exact = doubled(place);
    in_square::<T>(pixel, to_plane(exact));
    let (earth, true_earth) = earths::<T>();
    in_square::<T>(earth.containing(place, depth).unwrap(), true_earth.to_plane(exact));
    let back = vector(from_plane(to_plane(place)).unwrap());
    assert!(apart(back, vector(place)) <= 4.0 * T::EPSILON.into(), "{}", context());
}

/// A point of the plane is in a pixel, up to what is claimed: on the Earth 12 nm, in `f32` 1.7 m.
fn in_square<T: Scalar>(pixel: Pixel, [x, y]: [f64; 2]) {
    let south = southern_corner(pixel);
    let [east, north] = [(x - south[0] + 4.0).rem_euclid(8.0) - 4.0, y - south[1]];
    let size = 2.0 / f64::from(1_u32 << pixel.depth());
    // A base pixel is 2 wide, which is 6520 km.
    let rounding = 2.0 * [12e-9, 1.7][T::CLAIM] / 6.52e6;
    for along in [north + east, north - east] {
        assert!(
            (-rounding..=size + rounding).contains(&along),
            "{} {pixel:?} {x} {y}: {along} of {size}",
            T::NAME
        );
    }
}

/// The southern corner of a pixel in the plane.
fn southern_corner(pixel: Pixel) -> [f64; 2] {
    let of = |shift: u8| {
        let bits = (0..pixel.depth()).map(|k| (pixel.number() >> (2 * k + shift) & 1) << k);
        bits.sum::<u64>() as f64 / f64::from(1_u32 << pixel.depth())
    };
    let (x, y) = (of(0), of(1));
    let (row, column) = (f64::from(pixel.base() / 4), f64::from(pixel.base() % 4));
    let middle = 2.0 * column + f64::from(u8::from(row != 1.0));
    [middle + x - y, x + y - row]
}

/// On any ellipsoid a place in a pixel is in the pixel, and so are its centre and what is within its corners.
fn ellipsoid<T: Scalar>(bytes: &mut Bytes<'_>) {
    let ground = OnEllipsoid::<T>::new(bytes.ellipsoid(-0.1, 0.1)).unwrap();
    let deepest = if T::CLAIM == 0 { Pixel::MAX_DEPTH } else { 14 };
    let (pixel, within) = (pixel(bytes, deepest), inside::<T>(bytes));
    let place = ground.place(pixel, within).unwrap();
    let context = || format!("{} {ground:?} {pixel:?} {within:?} {place:?}", T::NAME);
    assert_eq!(ground.containing(place, pixel.depth()), Ok(pixel), "{}", context());
    let centre = ground.centre(pixel);
    assert_eq!(ground.containing(centre, pixel.depth()), Ok(pixel), "{}", context());
    let plane = ground.to_plane(place);
    let back = ground.from_plane(plane).unwrap();
    let error = apart(vector(back), vector(place));
    assert!(error <= 8.0 * T::EPSILON.into(), "{}: {error:e}", context());
}

/// Any numbers at all: what is given is a place, and what is refused says why.
fn any<T: Scalar>(bytes: &mut Bytes<'_>) {
    let pixel = pixel(bytes, Pixel::MAX_DEPTH);
    let [x, y] = [bytes.anything::<T>(), bytes.anything()];
    let ground = OnEllipsoid::<T>::new(bytes.ellipsoid(-0.1, 0.1)).unwrap();
    let is_place = |place: LatLon<T>| place.lat().abs() <= T::of(90.0) && place.lon().abs() <= T::of(180.0);
    let inside = |v: T| v >= T::ZERO && v <= T::ONE;
    for place in [pixel.place([x, y]), ground.place(pixel, [x, y])] {
        match place {
            Ok(place) => assert!(is_place(place) && inside(x) && inside(y), "{pixel:?} {x:?} {y:?}"),
            Err(why) => {
                assert!(!(inside(x) && inside(y)));
                assert_eq!([why.dx.bits(), why.dy.bits()], [x.bits(), y.bits()]);
            }
        }
    }
    for place in [from_plane([x, y]), ground.from_plane([x, y])] {
        match place {
            Ok(place) => assert!(is_place(place), "{x:?} {y:?} {place:?}"),
            Err(why) => assert_eq!([why.x.bits(), why.y.bits()], [x.bits(), y.bits()]),
        }
    }
}
