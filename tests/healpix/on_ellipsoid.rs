//! HEALPix on an ellipsoid, against truth of 25 digits and against the sphere.

use fastrand::Rng;
use terrella::Ellipsoid;
use terrella::geodesic::Area;
use terrella::healpix::{self, OnEllipsoid, Pixel};
use testkit::scalar::Scalar;
use testkit::{Worst, table};

use super::{pixels, place, places, plane};

fn earth<T: Scalar>() -> OnEllipsoid<T> {
    let earth = Ellipsoid::<f64>::WGS84;
    OnEllipsoid::new(Ellipsoid::new(T::of(earth.a()), T::of(earth.f())).unwrap()).unwrap()
}

#[test]
fn places_are_in_their_pixels() {
    fn compare<T: Scalar>(depth: u8, share: f64) {
        let earth = earth::<T>();
        pixels("healpix_pixels_wgs84", depth, share, |place, depth| {
            earth.containing(place, depth)
        });
    }
    compare::<f64>(29, 1e-6);
    compare::<f32>(20, 0.1);
    compare::<f32>(12, 0.01);
}

#[test]
fn the_plane_is_as_accurate_as_claimed() {
    plane::<f64>("healpix_pixels_wgs84", 9.3e-16, |place| earth().to_plane(place));
    plane::<f32>("healpix_pixels_wgs84", 5e-7, |place| earth().to_plane(place));
}

#[test]
fn places_in_pixels_are_as_accurate_as_claimed() {
    fn worst<T: Scalar>(exact: i32) -> f64 {
        let earth = earth::<T>();
        let place_in = |pixel, inside| earth.place(pixel, inside);
        places("healpix_places_wgs84", exact, place_in, |point| earth.from_plane(point))
    }
    table::hold(
        "healpix::OnEllipsoid::place and from_plane",
        [worst::<f64>(20), worst::<f32>(0)],
    );
}

/// On a sphere the latitudes are the same, and so is every bit.
#[test]
fn on_a_sphere_nothing_changes() {
    let sphere = OnEllipsoid::new(Ellipsoid::sphere(6.4e6).unwrap()).unwrap();
    let mut rng = Rng::with_seed(41);
    for _ in 0..super::CASES {
        let (place, depth) = (place(&mut rng), rng.u8(..));
        let pixel = sphere.containing(place, depth);
        assert_eq!(pixel, Pixel::containing(place, depth));
        assert_eq!(sphere.to_plane(place), healpix::to_plane(place));
        let point = [8.0 * rng.f64(), 4.0 * rng.f64() - 2.0];
        assert_eq!(sphere.from_plane(point), healpix::from_plane(point));
        if let Ok(pixel) = pixel {
            assert_eq!(sphere.centre(pixel), pixel.centre());
            assert_eq!(sphere.corners(pixel), pixel.corners());
            let inside = [1.1 * rng.f64(), rng.f64()];
            assert_eq!(sphere.place(pixel, inside), pixel.place(inside));
        }
    }
}

#[test]
fn a_place_in_a_pixel_is_in_the_pixel() {
    let mut rng = Rng::with_seed(42);
    for f in [0.05, 1.0 / 298.257, -1.0 / 150.0] {
        let ground = OnEllipsoid::new(Ellipsoid::new(6.4e6, f).unwrap()).unwrap();
        for _ in 0..super::CASES {
            let depth = rng.u8(0..=29);
            let pixel = Pixel::new(depth, rng.u64(0..12 << (2 * depth))).unwrap();
            let inside = [(); 2].map(|()| 0.01 + 0.98 * rng.f64());
            let place = ground.place(pixel, inside).unwrap();
            assert_eq!(ground.containing(place, depth), Ok(pixel), "{f} {inside:?}");
        }
    }
}

/// The area of a pixel is that of a polygon of geodesics with many corners on its sides.
#[test]
fn pixels_have_the_area_of_polygons() {
    let earth = earth::<f64>();
    let areas = Area::new(Ellipsoid::WGS84).unwrap();
    let mut worst = Worst::default();
    for number in 0..48 {
        let pixel = Pixel::new(1, number).unwrap();
        let steps = 256;
        let shares = || (0..steps).map(|step| f64::from(step) / f64::from(steps));
        let sides = [
            shares().map(|along| [along, 0.0]).collect::<Vec<_>>(),
            shares().map(|along| [1.0, along]).collect(),
            shares().map(|along| [1.0 - along, 1.0]).collect(),
            shares().map(|along| [0.0, 1.0 - along]).collect(),
        ];
        let mut polygon = areas.polygon();
        for inside in sides.concat() {
            polygon.add(earth.place(pixel, inside).unwrap());
        }
        worst.add((polygon.area() / earth.area(pixel) - 1.0).abs());
    }
    let worst = worst.value();
    println!("areas: {worst:e}");
    assert!(worst <= 1e-5, "{worst:e}");
}

#[test]
fn what_has_no_authalic_latitude_is_refused() {
    let ellipsoid = Ellipsoid::new(1.0, 0.2).unwrap();
    assert_eq!(OnEllipsoid::new(ellipsoid).unwrap_err().0, 0.2);
    assert_eq!(earth::<f64>().ellipsoid(), Ellipsoid::WGS84);
}
