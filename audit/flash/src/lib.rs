//! A symbol for each function that `run` links alone: from arguments as the function takes them, or, for what says `from numbers`,
//! from plain numbers through all constructors.

#![no_std]

use core::panic::PanicInfo;

use terrella::cube::{self, CubeMap, CubeProjection, FacePoint};
use terrella::distortion::{Ground, Jacobian, Singular};
use terrella::geodesic::{
    self, Direct, Geodesic, GeodesicError, GreatCircle, Inverse, Karney, PlanarArea, Plane, Vincenty,
};
use terrella::latitude::UnsupportedFlattening;
use terrella::scene::{Areas, Distances, Positions, Scene};
use terrella::{
    Direction, Ecef, Ellipsoid, Enu, Geodetic, InvalidDirection, InvalidLatLon, LatLon, LocalFrame, Shift, math,
};

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    loop {}
}

/// A function in both scalars, as the symbols `NAME_f64` and `NAME_f32`.
macro_rules! functions {
    ($($name:ident($($argument:ident: $type:ty),*) -> $result:ty $body:block)*) => {
        mod f64 {
            use super::*;
            type T = f64;
            $(
                #[unsafe(export_name = concat!(stringify!($name), "_f64"))]
                pub fn $name($($argument: $type),*) -> $result $body
            )*
        }
        mod f32 {
            use super::*;
            type T = f32;
            $(
                #[unsafe(export_name = concat!(stringify!($name), "_f32"))]
                pub fn $name($($argument: $type),*) -> $result $body
            )*
        }
    };
}

macro_rules! projections {
    ($($forward:ident $inverse:ident $both:ident $projection:ident;)*) => {
        functions! {
            $(
                $forward(direction: &Direction<T>) -> FacePoint<T> {
                    cube::$projection.project(*direction)
                }
                $inverse(point: &FacePoint<T>) -> Direction<T> {
                    cube::$projection.unproject(*point)
                }
                $both(direction: &mut Direction<T>, point: &mut FacePoint<T>) -> () {
                    let place = cube::$projection.project(*direction);
                    *direction = cube::$projection.unproject(*point);
                    *point = place;
                }
            )*
        }
    };
}

mod projections {
    use super::*;
    include!(concat!(env!("OUT_DIR"), "/projections.rs"));
}

type Line<T> = Result<Inverse<T>, GeodesicError<T>>;
type End<T> = Result<Direct<T>, GeodesicError<T>>;

macro_rules! methods {
    ($($inverse:ident $direct:ident $method:ident;)*) => {
        functions! {
            $(
                $inverse(method: &geodesic::$method<T>, from: &LatLon<T>, to: &LatLon<T>) -> Line<T> {
                    method.inverse(*from, *to)
                }
                $direct(method: &geodesic::$method<T>, from: &LatLon<T>, azimuth: T, distance: T) -> End<T> {
                    method.direct(*from, azimuth, distance)
                }
            )*
        }
    };
}

mod methods {
    use super::*;
    include!(concat!(env!("OUT_DIR"), "/methods.rs"));
}

fn places<T: terrella::Real>([lat1, lon1, lat2, lon2]: [T; 4]) -> Option<[LatLon<T>; 2]> {
    Some([LatLon::new(lat1, lon1).ok()?, LatLon::new(lat2, lon2).ok()?])
}

functions! {
    sin_cos_degrees(x: T) -> (T, T) { math::sin_cos_degrees(x) }
    atan2_degrees(y: T, x: T) -> T { math::atan2_degrees(y, x) }
    lat_lon_new(lat: T, lon: T) -> Result<LatLon<T>, InvalidLatLon<T>> { LatLon::new(lat, lon) }
    lat_lon_to_direction(place: &LatLon<T>) -> Direction<T> { place.to_direction() }
    direction_new(v: &[T; 3]) -> Result<Direction<T>, InvalidDirection<T>> { Direction::new(v[0], v[1], v[2]) }
    direction_to_lat_lon(direction: &Direction<T>) -> LatLon<T> { direction.to_lat_lon() }
    to_ecef(ellipsoid: &Ellipsoid<T>, place: &Geodetic<T>) -> Ecef<T> { ellipsoid.to_ecef(*place) }
    to_geodetic(ellipsoid: &Ellipsoid<T>, point: &Ecef<T>) -> Geodetic<T> { ellipsoid.to_geodetic(*point) }
    great_circle_distance(sphere: &GreatCircle<T>, from: &LatLon<T>, to: &LatLon<T>) -> Option<T> {
        Some(sphere.inverse(*from, *to).ok()?.distance)
    }
    great_circle_radians(sphere: &GreatCircle<T>, from: &[T; 2], to: &[T; 2]) -> T {
        sphere.distance_radians(*from, *to)
    }
    great_circle_angle(from: &Direction<T>, to: &Direction<T>) -> T { GreatCircle::angle_radians(*from, *to) }
    jacobian(ground: &Ground<T, cube::Quadrilateralized>, point: &FacePoint<T>) -> Result<Jacobian<T>, Singular<T>> {
        ground.jacobian(*point)
    }
    great_circle_distance_from_numbers(radius: T, numbers: &[T; 4]) -> Option<T> {
        let [from, to] = places(*numbers)?;
        Some(GreatCircle::new(radius).ok()?.inverse(from, to).ok()?.distance)
    }
    vincenty_inverse_from_numbers(numbers: &[T; 4]) -> Option<Inverse<T>> {
        let [from, to] = places(*numbers)?;
        Vincenty::new(Ellipsoid::WGS84).ok()?.inverse(from, to).ok()
    }
    karney_inverse_from_numbers(numbers: &[T; 4]) -> Option<Inverse<T>> {
        let [from, to] = places(*numbers)?;
        Karney::new(Ellipsoid::WGS84).ok()?.inverse(from, to).ok()
    }
    karney_direct_from_numbers(lat: T, lon: T, azimuth: T, distance: T) -> Option<Direct<T>> {
        let from = LatLon::new(lat, lon).ok()?;
        Karney::new(Ellipsoid::WGS84).ok()?.direct(from, azimuth, distance).ok()
    }
    map_project_from_numbers(lat: T, lon: T) -> Option<FacePoint<T>> {
        let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, cube::Quadrilateralized).ok()?;
        Some(map.project(LatLon::new(lat, lon).ok()?))
    }
    map_unproject(map: &CubeMap<T, cube::Quadrilateralized>, point: &FacePoint<T>) -> LatLon<T> { map.unproject(*point) }
    map_new(ellipsoid: &Ellipsoid<T>, shift: Shift)
        -> Result<CubeMap<T, cube::Quadrilateralized>, UnsupportedFlattening<T>> {
        CubeMap::new(*ellipsoid, shift, cube::Quadrilateralized)
    }
    enu_from_numbers(from: &[T; 3], to: &[T; 3]) -> Option<Enu<T>> {
        let place = |[lat, lon, height]: [T; 3]| Geodetic::new(LatLon::new(lat, lon).ok()?, height).ok();
        Some(LocalFrame::new(Ellipsoid::WGS84, place(*from)?).geodetic_to_enu(place(*to)?))
    }
    // A kilometre to five centimetres: the compiler chooses, and links no more than was chosen.
    scene_field_distance(from: &LatLon<T>, to: &LatLon<T>) -> Option<T> {
        const WAY: Distances<T> = match FIELD.within(0.05).distances() {
            Ok(way) => way,
            Err(_) => panic!(),
        };
        Some(WAY.solver().inverse(*from, *to).ok()?.distance)
    }
    plane_distance_from_place(place: &LatLon<T>, from: &LatLon<T>, to: &LatLon<T>) -> Option<T> {
        Some(Plane::local(Ellipsoid::WGS84, *place).ok()?.inverse(*from, *to).ok()?.distance)
    }
    scene_field_area(corners: &[LatLon<T>]) -> T {
        const AREAS: Areas<T> = match FIELD.within(0.05).areas() {
            Ok(areas) => areas,
            Err(_) => panic!(),
        };
        AREAS.solver().area(corners.iter().copied())
    }
    planar_area_about_place(place: &LatLon<T>, corners: &[LatLon<T>]) -> Option<T> {
        let mut field = PlanarArea::local(Ellipsoid::WGS84, *place).ok()?.polygon();
        for corner in corners {
            field.add(*corner);
        }
        Some(field.area())
    }
    scene_field_position(origin: &Geodetic<T>, position: &Geodetic<T>) -> Enu<T> {
        const SEEN: Positions<T> = match FIELD.within(0.05).positions() {
            Ok(positions) => positions,
            Err(_) => panic!(),
        };
        SEEN.about(*origin).enu(*position)
    }
}

const FIELD: Scene = Scene::around(Ellipsoid::WGS84, 47.4, 1000.0).local();

/// Any scene, asked at run time: what has to be linked then.
#[unsafe(export_name = "scene_any_distance_f64")]
pub fn scene_any_distance(scene: &Scene, from: &LatLon<f64>, to: &LatLon<f64>) -> Option<f64> {
    let way: Distances<f64> = scene.distances().ok()?;
    Some(way.solver().inverse(*from, *to).ok()?.distance)
}
