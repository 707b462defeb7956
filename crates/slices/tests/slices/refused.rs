//! What constructors change, and what they refuse.

use core::convert::Infallible;
use terrella::batch::{self, InvalidBatch, cube::InvalidPoint, ellipsoid::InvalidGeodetic};
use terrella::cube::{CubeMap, CubeProjection, Face, InvalidFace, InvalidFacePoint, Outerra, Projection};
use terrella::frame::InvalidEnu;
use terrella::latitude::{Conversion, InvalidLatitude};
use terrella::{
    Direction, Ellipsoid, Geodetic, InvalidDirection, InvalidEcef, InvalidHeight, InvalidLatLon, LatLon, Latitude,
    LocalFrame, Shift, Shifted,
};

use super::{OverSlices, Scalar, bytes, compare, number, numbers, places, store};

fn not_kept<T: Scalar>() {
    // Vectors of any length, and longitudes beyond the half circle, as the constructors take them.
    let size = T::of(if T::EPSILON.into() > 1e-10 { 1e15 } else { 1e150 });
    let vectors = [1, 2, 3].map(|seed| {
        let column = numbers::<T>(seed, &[2.0, -1e-12, 1.0]);
        column
            .iter()
            .map(|&v| if v > T::of(1.5) { v * size } else { v })
            .collect::<Vec<_>>()
    });
    compare(
        "vectors",
        &vectors,
        &|[x, y, z]| {
            let place = Direction::new(x, y, z).unwrap().to_lat_lon();
            [place.lat(), place.lon()]
        },
        &|from, to| batch::position::to_lat_lon(from, to).unwrap(),
    );
    compare(
        "vectors on faces",
        &vectors,
        &|[x, y, z]| {
            let point = Projection::Balanced.project(Direction::new(x, y, z).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::cube::project(Projection::Balanced, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    let [lat, lon] = places::<T>();
    let lon: Vec<T> = lon
        .iter()
        .enumerate()
        .map(|(i, &lon)| lon * T::of((i % 7) as f64))
        .collect();
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Conformal, Projection::Healpix).unwrap();
    compare(
        "longitudes",
        &[lat.clone(), lon.clone()],
        &|[lat, lon]| {
            let point = map.project(LatLon::new(lat, lon).unwrap());
            [number(point.face()), point.x(), point.y()]
        },
        &|from, [face, x, y]| {
            let mut faces = vec![Face::Front; face.len()];
            batch::map::project(&map, from, &mut faces, [x, y]).unwrap();
            store(&faces, face);
        },
    );
    let earth = Ellipsoid::<T>::WGS84;
    compare(
        "longitudes with heights",
        &[lat.clone(), lon, lat],
        &|[lat, lon, height]| {
            let place = Geodetic::new(LatLon::new(lat, lon).unwrap(), height).unwrap();
            earth.to_ecef(place).to_array()
        },
        &|from, to| batch::ellipsoid::to_ecef(earth, from, to).unwrap(),
    );
}

#[test]
fn what_the_constructors_change_is_changed() {
    not_kept::<f64>();
    not_kept::<f32>();
}

/// A batch writes all but bad elements, which are NaN and counted; with a column that is too short it writes
/// nothing.
fn refuse<T: Scalar, E: PartialEq + core::fmt::Debug, const I: usize, const O: usize>(
    good: [f64; I],
    bad: &[([f64; I], E)],
    batch: &OverSlices<'_, T, I, O, Result<(), InvalidBatch<E>>>,
) {
    let mark = T::of(7.0);
    let columns = good.map(|value| vec![T::of(value); 200]);
    let lent = |columns: &[Vec<T>; I], results: &mut [Vec<T>; O]| {
        batch(
            columns.each_ref().map(|c| &c[..]),
            results.each_mut().map(|c| &mut c[..]),
        )
    };
    let mut expected = [(); O].map(|()| vec![mark; 200]);
    lent(&columns, &mut expected).unwrap();
    for (numbers, why) in bad {
        for places in [&[0][..], &[5], &[63, 64], &[7, 8, 150, 199], &[199]] {
            let mut columns = columns.clone();
            for &index in places {
                for (column, &value) in columns.iter_mut().zip(numbers) {
                    column[index] = T::of(value);
                }
            }
            let mut results = [(); O].map(|()| vec![mark; 200]);
            match lent(&columns, &mut results) {
                Err(InvalidBatch::Elements {
                    count,
                    first,
                    why: found,
                }) => {
                    assert_eq!((count, first), (places.len(), places[0]));
                    assert_eq!(format!("{found:?}"), format!("{why:?}"));
                }
                other => panic!("{other:?}"),
            }
            for index in 0..200 {
                let is_bad = places.contains(&index);
                let row = results.each_ref().map(|column| column[index].into());
                if is_bad {
                    // A column of faces has the front there.
                    assert!(row.iter().all(|v| v.is_nan() || *v == 0.0) && row.iter().any(|v| v.is_nan()));
                } else {
                    assert_eq!(row, expected.each_ref().map(|column| column[index].into()));
                }
            }
        }
    }
    for short in 0..I + O {
        let mut results = [(); O].map(|()| vec![mark; 200]);
        let length = |column: usize| if column == short { 199 } else { 200 };
        let mut outputs = results
            .iter_mut()
            .enumerate()
            .map(|(i, column)| &mut column[..length(I + i)]);
        let outputs = [(); O].map(|()| outputs.next().unwrap());
        let mut inputs = columns.iter().enumerate().map(|(i, column)| &column[..length(i)]);
        let inputs = [(); I].map(|()| inputs.next().unwrap());
        let (first, other) = if short == 0 { (199, 200) } else { (200, 199) };
        assert_eq!(batch(inputs, outputs), Err(InvalidBatch::Lengths { first, other }));
        assert!(results.iter().flatten().all(|&v| v == mark));
    }
}

fn every_refusal<T: Scalar + PartialEq>() {
    let of = |value: f64| T::of(value);
    let nan = f64::NAN;
    let infinite = f64::INFINITY;
    let vector = |[x, y, z]: [f64; 3]| {
        let why = InvalidDirection {
            x: of(x),
            y: of(y),
            z: of(z),
        };
        ([x, y, z], why)
    };
    let vectors = [[0.0, 0.0, 0.0], [nan, 1.0, 0.0], [0.0, infinite, 0.0], [0.0, 0.0, nan]].map(vector);
    let places = [
        ([nan, 0.0], InvalidLatLon::Latitude(of(nan))),
        ([90.001, 0.0], InvalidLatLon::Latitude(of(90.001))),
        ([-91.0, nan], InvalidLatLon::Latitude(of(-91.0))),
        ([1.0, nan], InvalidLatLon::Longitude(of(nan))),
        ([1.0, -infinite], InvalidLatLon::Longitude(of(-infinite))),
    ];
    let point = |[x, y]: [f64; 2]| {
        let why = InvalidPoint::Point(InvalidFacePoint { x: of(x), y: of(y) });
        ([x, y, 1.0], why)
    };
    let mut points = [[1.000_001, 0.0], [0.0, -2.0], [nan, 0.0], [0.5, nan]]
        .map(point)
        .to_vec();
    points.push(([0.0, 0.0, 6.0], InvalidPoint::Face(InvalidFace(6))));
    points.push(([nan, 0.0, 255.0], InvalidPoint::Face(InvalidFace(255))));
    let shifted = Shifted::new(Ellipsoid::<T>::WGS84, Shift::Authalic).unwrap();
    let map = CubeMap::new(Ellipsoid::<T>::WGS84, Shift::Authalic, Projection::Vertex).unwrap();
    let earth = Ellipsoid::<T>::WGS84;

    refuse::<T, _, 3, 2>([1.0, 0.0, 0.0], &vectors, &batch::position::to_lat_lon);
    refuse::<T, _, 3, 2>([3.0, 0.0, 0.0], &vectors, &|from, to| {
        batch::latitude::to_lat_lon(&shifted, from, to)
    });
    refuse::<T, _, 2, 3>([1.0, 0.0], &places, &batch::position::to_direction);
    refuse::<T, _, 2, 3>([1.0, 300.0], &places, &|from, to| {
        batch::latitude::to_direction(&shifted, from, to)
    });
    refuse::<T, _, 3, 3>([1.0, 0.0, 0.0], &vectors, &|from, [face, x, y]| {
        with_faces(face, |faces| {
            batch::cube::project(Projection::Vertex, from, faces, [x, y])
        })
    });
    refuse::<T, _, 2, 3>([1.0, 0.0], &places, &|from, [face, x, y]| {
        with_faces(face, |faces| batch::map::project(&map, from, faces, [x, y]))
    });
    refuse::<T, _, 3, 3>([0.5, 0.5, 4.0], &points, &|[x, y, numbers], to| {
        batch::cube::unproject(Projection::Vertex, &bytes(numbers), [x, y], to)
    });
    refuse::<T, _, 3, 2>([0.5, 0.5, 4.0], &points, &|[x, y, numbers], to| {
        batch::map::unproject(&map, &bytes(numbers), [x, y], to)
    });

    let conversion = Conversion::new(earth, Latitude::Geodetic, Latitude::Authalic).unwrap();
    let latitudes = [nan, 91.0, -100.0, infinite].map(|value| ([value], InvalidLatitude(of(value))));
    refuse::<T, _, 1, 1>([45.0], &latitudes, &|[from], [to]| {
        batch::latitude::degrees(&conversion, from, to)
    });
    refuse::<T, _, 1, 1>([0.5], &latitudes, &|[from], [to]| {
        batch::latitude::radians(&conversion, from, to)
    });

    let ecef = [[nan, 0.0, 0.0], [0.0, infinite, 0.0], [0.0, 0.0, -infinite]];
    let ecef = ecef.map(|[x, y, z]| {
        (
            [x, y, z],
            InvalidEcef {
                x: of(x),
                y: of(y),
                z: of(z),
            },
        )
    });
    refuse::<T, _, 3, 3>([7e6, 0.0, 0.0], &ecef, &|from, to| {
        batch::ellipsoid::to_geodetic(earth, from, to)
    });
    let mut geodetic: Vec<_> = places
        .iter()
        .map(|&([lat, lon], why)| ([lat, lon, 0.0], InvalidGeodetic::LatLon(why)))
        .collect();
    for height in [nan, infinite] {
        let why = InvalidHeight { height: of(height) };
        geodetic.push(([0.0, 200.0, height], InvalidGeodetic::Height(why)));
    }
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &geodetic, &|from, to| {
        batch::ellipsoid::to_ecef(earth, from, to)
    });

    let frame = LocalFrame::new(earth, Geodetic::default());
    refuse::<T, _, 3, 3>([7e6, 0.0, 0.0], &ecef, &|from, to| {
        batch::frame::to_aer(&frame, from, to)
    });
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &geodetic, &|from, to| {
        batch::frame::geodetic_to_aer(&frame, from, to)
    });
    let enu = |[east, north, up]: [f64; 3]| {
        let why = InvalidEnu {
            east: of(east),
            north: of(north),
            up: of(up),
        };
        ([east, north, up], why)
    };
    let enu = [[nan, 0.0, 0.0], [0.0, infinite, 0.0], [1.0, 2.0, -infinite]].map(enu);
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &enu, &|from, to| {
        batch::frame::enu_to_geodetic(&frame, from, to)
    });
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &enu, &|from, to| {
        batch::frame::enu_to_offset(&frame, from, to)
    });
    // At the origin on the x axis, up, east and north are x, y and z.
    let point = [(
        [0.0, 1.0, infinite],
        InvalidEcef {
            x: of(infinite),
            y: of(nan),
            z: of(nan),
        },
    )];
    refuse::<T, _, 3, 3>([1.0, 2.0, 3.0], &point, &|from, to| {
        batch::frame::from_enu(&frame, from, to)
    });
    refuse::<T, Infallible, 3, 3>([1.0, 2.0, 3.0], &[], &|from, to| {
        batch::frame::vector_to_enu(&frame, from, to)
    });
}

/// Faces in place of a column of numbers.
fn with_faces<T: Scalar, E>(column: &mut [T], work: impl FnOnce(&mut [Face]) -> Result<(), E>) -> Result<(), E> {
    // The mark where nothing is written.
    let mut faces = vec![Face::Left; column.len()];
    let result = work(&mut faces);
    for (slot, face) in column.iter_mut().zip(faces).filter(|(_, face)| *face != Face::Left) {
        *slot = number(face);
    }
    result
}

#[test]
fn refused_elements_are_nan_and_counted() {
    every_refusal::<f64>();
    every_refusal::<f32>();
}

/// The same call with a number of elements, a bad one among them, against one by one.
#[test]
fn all_lengths() {
    let [lat, lon] = places::<f64>();
    let map = CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, Outerra).unwrap();
    for length in 0..=200 {
        let mut lat = lat[..length].to_vec();
        // In the west, as 180 to 360.
        let lon: Vec<f64> = lon[..length].iter().map(|lon| lon.rem_euclid(360.0)).collect();
        let bad: Vec<usize> = [length / 2, length.wrapping_sub(1)]
            .into_iter()
            .filter(|i| i % 3 == 1)
            .collect();
        for &index in bad.iter().filter(|&&index| index < length) {
            lat[index] = f64::NAN;
        }
        let (mut faces, mut x, mut y) = (vec![9; length], vec![7.0; length], vec![7.0; length]);
        let found = batch::map::project(&map, [&lat, &lon], &mut faces, [&mut x, &mut y]);
        let mut refused = Vec::new();
        for index in 0..length {
            match LatLon::new(lat[index], lon[index]) {
                Ok(place) => {
                    let point = map.project(place);
                    let expected = (point.face().index(), point.x().to_bits(), point.y().to_bits());
                    assert_eq!((faces[index], x[index].to_bits(), y[index].to_bits()), expected);
                }
                Err(_) => {
                    assert!(faces[index] == 0 && x[index].is_nan() && y[index].is_nan());
                    refused.push(index);
                }
            }
        }
        match (found, refused.first()) {
            (Ok(()), None) => {}
            (Err(InvalidBatch::Elements { count, first, .. }), Some(&index)) => {
                assert_eq!((count, first), (refused.len(), index));
            }
            other => panic!("{length}: {other:?}"),
        }
    }
}
