use terrella::{Direction, Dms, DmsLatLon, Ecef, Ellipsoid, Geodetic, GeodeticSeries, LatLon, NmeaLatLon};

use crate::{Arguments, Function, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let two = Arguments::units::<T, 2>;
    let three = Arguments::units::<T, 3>;
    visitor.function::<T, _, _>("LatLon::new", two, |[lat, lon]| {
        LatLon::new(lat * T::of(100.0), lon * T::of(1000.0))
    });
    visitor.function::<T, _, _>("LatLon::from_radians", two, |[lat, lon]| {
        LatLon::from_radians(lat * T::of(1.6), lon * T::of(20.0))
    });
    visitor.function::<T, _, _>("LatLon::to_radians", Arguments::place::<T>, LatLon::to_radians);
    visitor.function::<T, _, _>("LatLon::to_dms", Arguments::place::<T>, |place| {
        let DmsLatLon { lat, lon } = LatLon::to_dms(place, 6);
        [lat, lon].map(|angle| {
            let parts = (Dms::minutes(angle), Dms::seconds(angle), Dms::fraction(angle));
            (
                Dms::is_negative(angle),
                u32::from(Dms::degrees(angle)),
                parts,
                Dms::digits(angle),
            )
        })
    });
    visitor.function::<T, _, _>("LatLon::to_nmea", Arguments::place::<T>, |place| {
        NmeaLatLon::to_lat_lon::<T>(LatLon::to_nmea(place, 4))
    });
    visitor.function::<T, _, _>("LatLon::to_direction", Arguments::place::<T>, LatLon::to_direction);
    visitor.function::<T, _, _>("Direction::new", three, |[x, y, z]| Direction::new(x, y, z));
    visitor.function::<T, _, _>(
        "Direction::to_lat_lon",
        Arguments::direction::<T>,
        Direction::to_lat_lon,
    );
    visitor.function::<T, _, _>(
        "Geodetic::new",
        |arguments| (arguments.place::<T>(), arguments.unit()),
        |(place, height)| (Geodetic::new(place, T::ONE / height), Geodetic::from(place)),
    );
    visitor.function::<T, _, _>("Ecef::new", three, |[x, y, z]| Ecef::new(x, y, T::ONE / z));
    ellipsoids::<T, V>(visitor);
}

/// Some of the named ellipsoids.
const NAMES: [&str; 8] = [
    "wgs84", "grs80", "clarke1866", "international1924", "airy1830", "bessel1841", "moon", "mars",
];

fn ellipsoids<T: Scalar, V: Visitor>(visitor: &mut V) {
    let two = Arguments::units::<T, 2>;
    visitor.function::<T, _, _>("Ellipsoid::new", two, |[a, f]| {
        (Ellipsoid::new(a * T::of(1e7), f * T::of(2.0)), Ellipsoid::sphere(a))
    });
    visitor.function::<T, _, _>("Ellipsoid, its radii", Arguments::ellipsoid::<T>, |e| {
        let shape = [Ellipsoid::b(e), Ellipsoid::n(e), Ellipsoid::e2(e), Ellipsoid::ep2(e)];
        let radii = [
            Ellipsoid::mean_radius(e),
            Ellipsoid::volumetric_radius(e),
            Ellipsoid::authalic_radius(e),
        ];
        (shape, radii)
    });
    visitor.function::<T, _, _>(
        "Ellipsoid::named",
        |arguments| arguments.below(9) as usize,
        |index| {
            let earths = [
                Ellipsoid::<T>::WGS84,
                Ellipsoid::GRS80,
                Ellipsoid::CLARKE1866,
                Ellipsoid::INTERNATIONAL1924,
                Ellipsoid::AIRY1830,
                Ellipsoid::BESSEL1841,
            ];
            let name = NAMES.get(index).copied().unwrap_or("nothing");
            (
                Ellipsoid::<T>::named(name).ok(),
                earths,
                [Ellipsoid::<T>::MOON, Ellipsoid::MARS],
            )
        },
    );
    let earth = Ellipsoid::WGS84;
    let mars = Ellipsoid::MARS;
    visitor.function::<T, _, _>("Ellipsoid::to_ecef", Arguments::geodetic::<T>, |place| {
        Ellipsoid::to_ecef(earth, place)
    });
    visitor.function::<T, _, _>("Ellipsoid::to_geodetic", Arguments::ecef::<T>, |point| {
        Ellipsoid::to_geodetic(earth, point)
    });
    let series = GeodeticSeries::new(mars);
    visitor.function::<T, _, _>("GeodeticSeries::second_order", Arguments::ecef::<T>, |point| {
        GeodeticSeries::second_order(&series, point)
    });
    visitor.function::<T, _, _>("GeodeticSeries::third_order", Arguments::ecef::<T>, |point| {
        GeodeticSeries::third_order(&series, point)
    });
    visitor.function::<T, _, _>("GeodeticSeries::fourth_order", Arguments::ecef::<T>, |point| {
        GeodeticSeries::fourth_order(&series, point)
    });
    let deep = |arguments: &mut Arguments| loop {
        let [x, y, z] = arguments.units().map(|part: T| part * T::of(6e4));
        if let Ok(point) = Ecef::new(x, y, z) {
            return point;
        }
    };
    visitor.visit::<T, _, _>(
        Function::of("Ellipsoid::to_geodetic", "near the centre"),
        deep,
        |point| Ellipsoid::to_geodetic(mars, point),
    );
}
