//! What scenes choose.

use terrella::batch::{self, ellipsoid::InvalidGeodetic};
use terrella::scene::{Scene, View};
use terrella::{Ellipsoid, Geodetic, LatLon};

use super::line::{checked, end, line};
use super::{compare, entry, pair, place};
use testkit::bytes::Bytes;
use testkit::scalar::Scalar;

pub(super) fn answers<T: Scalar>(bytes: &mut Bytes<'_>) {
    let latitude = bytes.choice(&[0.0, -33.0, 47.0, 70.0]);
    let scene = Scene::around(Ellipsoid::WGS84, latitude, 1e5).up_to(1e5);
    if bytes.flag() {
        let view = bytes.choice(&View::ALL);
        let origin = LatLon::new(T::of(latitude), bytes.within(180.0)).unwrap();
        let origin = Geodetic::new(origin, bytes.within(1e4)).unwrap();
        let view = scene.positions_by::<T>(view).unwrap().about(origin);
        compare(
            bytes,
            "enu",
            |bytes| {
                let [lat, lon] = place(bytes);
                [lat, lon, entry(bytes, 1e5)]
            },
            |[lat, lon, height]| {
                let place = LatLon::new(lat, lon).map_err(InvalidGeodetic::LatLon)?;
                let place = Geodetic::new(place, height).map_err(InvalidGeodetic::Height)?;
                let enu = view.enu(place);
                Ok([enu.east, enu.north, enu.up])
            },
            |places, enu| batch::scene::enu(&view, places, enu),
        );
        return;
    }
    let method = bytes.choice(Scene::METHODS);
    let method = scene.distances_by::<T>(method).unwrap().solver();
    if bytes.flag() {
        compare(
            bytes,
            "inverse",
            pair,
            |[lat1, lon1, lat2, lon2]| line(&method, checked([lat1, lon1])?, checked([lat2, lon2])?),
            |[lat1, lon1, lat2, lon2], lines| batch::scene::inverse(method, [lat1, lon1], [lat2, lon2], lines),
        );
    } else {
        compare(
            bytes,
            "direct",
            |bytes| {
                let [lat, lon] = place(bytes);
                [lat, lon, entry(bytes, 400.0), entry(bytes, 1e6)]
            },
            |[lat, lon, azimuth, distance]| end(&method, checked([lat, lon])?, azimuth, distance),
            |[lat, lon, azimuth, distance], ends| batch::scene::direct(method, [lat, lon], azimuth, distance, ends),
        );
    }
}
