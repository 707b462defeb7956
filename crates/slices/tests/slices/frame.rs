//! Local frames.

use terrella::batch::{self, InvalidBatch};
use terrella::frame::GeodeticOffset;
use terrella::{Aer, Ecef, Ellipsoid, Enu, Geodetic, LatLon, LocalFrame, Ned};

use super::{ENDS, Scalar, bits, compare, numbers, places, scaled};

/// All of a frame, about an origin: the conversions to and from three kinds of axes.
fn every_frame<T: Scalar>(frame: &LocalFrame<T>) {
    fn enu<T: Scalar>([east, north, up]: [T; 3]) -> Enu<T> {
        Enu { east, north, up }
    }
    fn ned<T: Scalar>([north, east, down]: [T; 3]) -> Ned<T> {
        Ned { north, east, down }
    }
    fn aer<T: Scalar>([azimuth, elevation, range]: [T; 3]) -> Aer<T> {
        Aer {
            azimuth,
            elevation,
            range,
        }
    }
    let of_enu = |Enu { east, north, up }: Enu<T>| [east, north, up];
    let of_ned = |Ned { north, east, down }: Ned<T>| [north, east, down];
    let of_aer = |Aer {
                      azimuth,
                      elevation,
                      range,
                  }: Aer<T>| [azimuth, elevation, range];
    let of_offset = |GeodeticOffset { lat, lon, height }: GeodeticOffset<T>| [lat, lon, height];
    let of_place = |place: Geodetic<T>| [place.lat(), place.lon(), place.height()];
    let nothing = [T::of(f64::NAN); 3];
    let point = |[x, y, z]: [T; 3]| Ecef::new(x, y, z).unwrap();
    let place = |[lat, lon, height]: [T; 3]| Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
    let [lat, lon] = places::<T>();
    let points = [11, 12, 13].map(|seed| scaled(&numbers(seed, ENDS), 7e6));
    let places = [lat.clone(), lon.clone(), scaled(&numbers(10, ENDS), 1e7)];
    // From the origin to the centre of the Earth and beyond, and far into space; not finite as a point.
    let far = f64::from(f32::MAX);
    let rows = |units: [f64; 3]| {
        let special = [0.0, -0.0, 1.0, -1.0, 1e3, 1e-6, 1e-20, f64::INFINITY, f64::NAN, far];
        let mut columns = units.map(|unit| scaled(&numbers(14, &special), unit));
        for (seed, column) in (15..).zip(&mut columns) {
            column.rotate_left(seed);
        }
        columns
    };
    let along = rows([1e7; 3]);
    let aers = rows([200.0, 90.0, 1e7]);
    macro_rules! compare {
        ($columns:expr, $name:ident, |$row:ident| $one:expr) => {
            compare(
                stringify!($name),
                $columns,
                &|$row| $one,
                &|from: [&[T]; 3], into| {
                    let row = |i: usize| from.each_ref().map(|column| column[i]);
                    let refused = (0..from[0].len()).filter(|&i| {
                        let $row = row(i);
                        let result: [T; 3] = $one;
                        // The open conversions keep NaN.
                        result.iter().all(|value| bits(&[*value]) == bits(&nothing[..1]))
                    });
                    let refused: Vec<_> = refused.collect();
                    match batch::frame::$name(frame, from, into) {
                        Err(InvalidBatch::Elements { count, first, .. }) => {
                            assert_eq!((count, Some(&first)), (refused.len(), refused.first()))
                        }
                        other => assert_eq!(other, Ok(())),
                    }
                },
            )
        };
    }
    compare!(&points, to_enu, |row| of_enu(frame.to_enu(point(row))));
    compare!(&points, to_ned, |row| of_ned(frame.to_ned(point(row))));
    compare!(&points, to_aer, |row| of_aer(frame.to_aer(point(row))));
    compare!(&places, geodetic_to_enu, |row| of_enu(
        frame.geodetic_to_enu(place(row))
    ));
    compare!(&places, geodetic_to_ned, |row| of_ned(
        frame.geodetic_to_ned(place(row))
    ));
    compare!(&places, geodetic_to_aer, |row| of_aer(
        frame.geodetic_to_aer(place(row))
    ));
    compare!(&along, from_enu, |row| frame
        .from_enu(enu(row))
        .map_or(nothing, Ecef::to_array));
    compare!(&along, from_ned, |row| frame
        .from_ned(ned(row))
        .map_or(nothing, Ecef::to_array));
    compare!(&aers, from_aer, |row| frame
        .from_aer(aer(row))
        .map_or(nothing, Ecef::to_array));
    compare!(&along, enu_to_geodetic, |row| frame
        .enu_to_geodetic(enu(row))
        .map_or(nothing, of_place));
    compare!(&along, ned_to_geodetic, |row| frame
        .ned_to_geodetic(ned(row))
        .map_or(nothing, of_place));
    compare!(&aers, aer_to_geodetic, |row| frame
        .aer_to_geodetic(aer(row))
        .map_or(nothing, of_place));
    compare!(&along, enu_to_offset, |row| frame
        .enu_to_offset(enu(row))
        .map_or(nothing, of_offset));
    compare!(&places, offset_to_enu, |row| {
        let [lat, lon, height] = row;
        of_enu(frame.offset_to_enu(GeodeticOffset { lat, lon, height }))
    });
    compare!(&along, vector_to_enu, |row| of_enu(frame.vector_to_enu(row)));
    compare!(&along, vector_from_enu, |row| frame.vector_from_enu(enu(row)));
}

#[test]
fn frames_are_the_same_bits() {
    fn both<T: Scalar>() {
        for [lat, lon, height] in [
            [47.0, 8.0, 400.0],
            [-90.0, 30.0, 0.0],
            [0.5, -180.0, -4e6],
            [60.0, 179.5, 1e9],
        ] {
            let place = LatLon::new(T::of(lat), T::of(lon)).unwrap();
            let origin = Geodetic::new(place, T::of(height)).unwrap();
            every_frame(&LocalFrame::new(Ellipsoid::WGS84, origin));
        }
        every_frame(&LocalFrame::new(
            Ellipsoid::new(T::of(1e6), T::of(0.3)).unwrap(),
            Geodetic::default(),
        ));
    }
    both::<f64>();
    both::<f32>();
}
