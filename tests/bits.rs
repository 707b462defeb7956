//! The same bits everywhere: a hash of what every function gives for fixed arguments, equal with and without `std`, in debug and
//! release builds, on every machine.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic)] // tests

use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Projection, QuadCube};
use terrella::frame::{Aer, LocalFrame};
use terrella::geodesic::{Area, Geodesic, Method};
use terrella::latitude::Conversion;
use terrella::{Direction, Ecef, Ellipsoid, Geodetic, LatLon, Latitude, Real, Shift, Shifted, math};

/// FNV-1a over the bits of `f64` values; an `f32` is exact in one.
struct Hash(u64);

impl Hash {
    fn add<T: Into<f64>>(&mut self, values: impl IntoIterator<Item = T>) {
        for value in values {
            for byte in value.into().to_bits().to_le_bytes() {
                self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
            }
        }
    }
}

/// Arguments that need no library: a linear congruential generator of multiples of 2⁻²³ in [−1, 1).
struct Arguments(u64);

impl Arguments {
    fn next<T: Real>(&mut self) -> T {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        T::of(f64::from((self.0 >> 40) as u32) / 8_388_608.0 - 1.0)
    }
}

fn hash(what: fn(&mut Arguments, &mut Hash)) -> u64 {
    let mut arguments = Arguments(7);
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    for _ in 0..2000 {
        what(&mut arguments, &mut hash);
    }
    hash.0
}

fn kernels<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let (x, y): (T, T) = (arguments.next(), arguments.next());
    let (a, b) = math::sin_cos(x * T::of(90.0));
    let (c, d) = math::sin_cos_degrees(x * T::of(720.0));
    hash.add([
        a,
        b,
        c,
        d,
        math::tan(x * T::of(0.75)),
        math::atan(x / y),
        math::atan2(x, y),
    ]);
    hash.add([
        math::atan2_degrees(x, y),
        math::cbrt(x),
        math::exp_m1(x),
        math::log2(y.abs()),
        x.abs().sqrt(),
    ]);
}

fn positions<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let (x, y, z): (T, T, T) = (arguments.next(), arguments.next(), arguments.next());
    let position = LatLon::new(x * T::of(90.0), y * T::of(1000.0)).unwrap();
    hash.add([position.lon()]);
    hash.add(position.to_direction().to_array());
    let direction = Direction::new(x, y, z).unwrap();
    hash.add(direction.to_array());
    hash.add([direction.to_lat_lon().lat(), direction.to_lat_lon().lon()]);
}

fn latitudes<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let x = arguments.next::<T>() * T::of(90.0);
    let ellipsoid = Ellipsoid::new(T::of(6.4e6), arguments.next::<T>() * T::of(0.1)).unwrap();
    hash.add([ellipsoid.authalic_radius(), ellipsoid.volumetric_radius()]);
    for &latitude in Latitude::ALL {
        let there = Conversion::new(ellipsoid, Latitude::Geodetic, latitude).unwrap();
        let back = Conversion::new(ellipsoid, latitude, Latitude::Geodetic).unwrap();
        let value = there.degrees(x).unwrap();
        hash.add([value, back.degrees(value).unwrap()]);
    }
}

fn shifts<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let position = LatLon::new(
        arguments.next::<T>() * T::of(90.0),
        arguments.next::<T>() * T::of(180.0),
    )
    .unwrap();
    for &shift in Shift::ALL {
        let shifted = Shifted::new(Ellipsoid::wgs84(), shift).unwrap();
        let direction = shifted.to_direction(position);
        hash.add(direction.to_array());
        hash.add([shifted.to_lat_lon(direction).lat()]);
    }
}

fn projections<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let [x, y, z]: [T; 3] = [(); 3].map(|()| arguments.next());
    let direction = Direction::new(x, y, z).unwrap();
    for &projection in Projection::ALL {
        let point = projection.project(direction);
        hash.add([T::of(f64::from(point.face().index())), point.x(), point.y()]);
        for face in [Face::Left, Face::Top] {
            hash.add(projection.unproject(FacePoint::new(face, x, y).unwrap()).to_array());
        }
    }
    hash.add(
        QuadCube::COBE
            .unproject(FacePoint::new(Face::Back, x, y).unwrap())
            .to_array(),
    );
    let map = CubeMap::new(Ellipsoid::wgs84(), Shift::Authalic, Projection::Vertex).unwrap();
    let place = map.unproject(FacePoint::new(Face::Bottom, x, y).unwrap());
    hash.add([place.lat(), place.lon()]);
}

fn geodesics<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let [a, b, c, d]: [T; 4] = [(); 4].map(|()| arguments.next());
    let (quarter, half) = (T::of(90.0), T::of(180.0));
    let (from, to) = (
        LatLon::new(a * quarter, b * half).unwrap(),
        LatLon::new(c * quarter, d * half).unwrap(),
    );
    for &method in Method::ALL {
        let method = method.on(Ellipsoid::wgs84()).unwrap();
        let inverse = method.inverse(from, to).unwrap();
        let direct = method.direct(from, b * half, a * T::of(2e7)).unwrap();
        hash.add([inverse.distance, inverse.azimuth1, inverse.azimuth2]);
        hash.add([direct.position.lat(), direct.position.lon(), direct.azimuth]);
    }
    hash.add([Area::new(Ellipsoid::wgs84()).unwrap().under(from, to)]);
}

fn frames<T: Real + Into<f64>>(arguments: &mut Arguments, hash: &mut Hash) {
    let [a, b, c]: [T; 3] = [(); 3].map(|()| arguments.next());
    let place = Geodetic::new(LatLon::new(a * T::of(90.0), b * T::of(180.0)).unwrap(), c * T::of(1e6)).unwrap();
    let earth = Ellipsoid::wgs84();
    let ecef = earth.to_ecef(place);
    let back = earth.to_geodetic(Ecef::new(b * T::of(1e7), c * T::of(1e7), a * T::of(1e7)).unwrap());
    hash.add(ecef.to_array());
    hash.add([back.lat(), back.lon(), back.height()]);
    let enu = LocalFrame::new(earth, place).geodetic_to_enu(back);
    let aer = Aer::from(enu);
    hash.add([enu.east, enu.north, enu.up, aer.azimuth, aer.elevation, aer.range]);
}

#[test]
fn bits_are_the_same_everywhere() {
    let found = [
        ("kernels", hash(kernels::<f64>), hash(kernels::<f32>)),
        ("positions", hash(positions::<f64>), hash(positions::<f32>)),
        ("latitudes", hash(latitudes::<f64>), hash(latitudes::<f32>)),
        ("shifts", hash(shifts::<f64>), hash(shifts::<f32>)),
        ("projections", hash(projections::<f64>), hash(projections::<f32>)),
        ("geodesics", hash(geodesics::<f64>), hash(geodesics::<f32>)),
        ("frames", hash(frames::<f64>), hash(frames::<f32>)),
    ];
    // A change of the arithmetic changes these on purpose; a change of machine or features never does.
    let expected = [
        ("kernels", 0x1dc6_e8a7_4dba_14b1, 0xb9fd_ad13_6959_8646),
        ("positions", 0x5013_a304_7c7f_81ba, 0xa542_bc46_2967_22c2),
        ("latitudes", 0x9ecb_5e2d_7b36_67c0, 0x1e7e_e8ab_df88_b2dd),
        ("shifts", 0x9f8a_6de9_64eb_96a7, 0x0b31_1567_8350_ddc4),
        ("projections", 0xa36a_6de4_0666_118b, 0x3c87_581e_5f85_c502),
        ("geodesics", 0x687c_5c9a_871a_b66c, 0x3d37_fb63_da8e_2795),
        ("frames", 0x6c20_bb81_c99d_1714, 0xfecc_2a71_20f6_c652),
    ];
    assert_eq!(found, expected, "found {found:#x?}");
}
