//! Areas of fields about an origin, in both scalars, next to GeographicLib's and, where those are too coarse,
//! to areas of chords.

use geographiclib_rs::{DirectGeodesic, Geodesic as Theirs, InverseGeodesic, PolygonArea as TheirPolygon, Winding};
use terrella::geodesic::PlanarArea;
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;

use crate::sample::{place, signed};
use testkit::truth::Scalar;

type Corners = Vec<(f64, f64)>;

const EARTH: (f64, f64) = (6_378_137.0, 1.0 / 298.257_223_563);

fn ellipsoid<T: Scalar>((a, f): (f64, f64)) -> Ellipsoid<T> {
    Ellipsoid::new(T::of(a), T::of(f)).unwrap()
}

/// Of corners as offsets from an origin.
fn local<T: Scalar>(shape: (f64, f64), lat: f64, offsets: &[(f64, f64)]) -> f64 {
    let area = PlanarArea::<T>::local(ellipsoid(shape), place(T::of(lat), T::ZERO)).unwrap();
    let mut field = area.polygon();
    for &(north, east) in offsets {
        field.add(place(T::of(north), T::of(east)));
    }
    field.area().into()
}

/// Of corners as they are.
fn absolute<T: Scalar>(corners: &[(f64, f64)]) -> f64 {
    let area = PlanarArea::<T>::new(Ellipsoid::WGS84).unwrap();
    let mut field = area.polygon();
    for &(lat, lon) in corners {
        field.add(place(T::of(lat), T::of(lon)));
    }
    field.area().into()
}

/// GeographicLib's perimeter and area.
fn theirs(ellipsoid: &Theirs, corners: &[(f64, f64)]) -> [f64; 2] {
    let mut polygon = TheirPolygon::new(ellipsoid, Winding::CounterClockwise);
    for &(lat, lon) in corners {
        polygon.add_point(lat, lon);
    }
    let (perimeter, area, _) = polygon.compute(true);
    [perimeter, area]
}

fn cross(x: [f64; 3], y: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|i| x[(i + 1) % 3] * y[(i + 2) % 3] - x[(i + 2) % 3] * y[(i + 1) % 3])
}

/// The polygon of chords, seen from above its first corner: within 10⁻⁹ of the area to 100 m, where
/// GeographicLib is 10⁻³ m² off.
fn of_chords((a, f): (f64, f64), corners: &[(f64, f64)]) -> f64 {
    let e2 = f * (2.0 - f);
    let up = |(lat, lon): (f64, f64)| {
        let ((s, c), (sin, cos)) = (lat.to_radians().sin_cos(), lon.to_radians().sin_cos());
        [c * cos, c * sin, s]
    };
    let points: Vec<[f64; 3]> = corners
        .iter()
        .map(|&corner| {
            let [x, y, z] = up(corner);
            let n = a / (1.0 - e2 * z * z).sqrt();
            [n * x, n * y, n * (1.0 - e2) * z]
        })
        .collect();
    let from_first = |point: [f64; 3]| core::array::from_fn(|i| point[i] - points[0][i]);
    let above = up(corners[0]);
    let doubled = |pair: &[[f64; 3]]| {
        let normal = cross(from_first(pair[0]), from_first(pair[1]));
        (0..3).map(|i| normal[i] * above[i]).sum::<f64>()
    };
    0.5 * points.windows(2).map(doubled).sum::<f64>()
}

/// A place by its distance from the origin and its azimuth, as an offset that `f32` holds.
fn offset(earth: &Theirs, lat: f64, azimuth: f64, distance: f64) -> (f64, f64) {
    let (north, east): (f64, f64) = earth.direct(lat, 0.0, azimuth, distance);
    (f64::from((north - lat) as f32), f64::from(east as f32))
}

/// From a report of users: 16 989 m² by the general way in `f32`.
#[test]
fn an_octagon_of_three_metres() {
    let earth = Theirs::wgs84();
    let offsets: Corners = (0..8_u8)
        .map(|i| offset(&earth, 51.5, -45.0 * f64::from(i), 3.0))
        .collect();
    let right = 18.0 * 2f64.sqrt();
    for found in [local::<f64>(EARTH, 51.5, &offsets), local::<f32>(EARTH, 51.5, &offsets)] {
        assert!((found / right - 1.0).abs() < 1e-6, "{found} for {right}");
        assert_eq!(format!("{found:.2}"), "25.46");
    }
}

/// 7552 m² by the general way in `f32`, whose own corners enclose 7636.785.
#[test]
fn a_field_of_a_thousandth_of_a_degree() {
    let corners = [(52.0, 5.0), (52.0, 5.001), (52.001, 5.001), (52.001, 5.0)];
    let rounded = corners.map(|(lat, lon)| (f64::from(lat as f32), f64::from(lon as f32)));
    assert!((absolute::<f64>(&corners) - 7641.537).abs() < 0.001);
    assert!((absolute::<f64>(&rounded) - 7636.785).abs() < 0.001);
    assert!((absolute::<f32>(&rounded) - 7636.785).abs() < 0.005);
    let offsets = [(0.0, 0.0), (0.0, 0.001), (0.001, 0.001), (0.001, 0.0)];
    assert!((local::<f32>(EARTH, 52.0, &offsets) - 7641.537).abs() < 0.005);
}

/// A field of so many metres across, not far from round, its middle so far from the origin.
fn field(rng: &mut fastrand::Rng, earth: &Theirs, lat: f64, size: f64, reach: f64) -> Corners {
    let (turn, count) = (std::f64::consts::TAU * rng.f64(), rng.usize(3..12));
    (0..count)
        .map(|i| {
            let angle = std::f64::consts::TAU * (i as f64 + 0.5 * rng.f64()) / count as f64;
            let radius = 0.5 * size * (0.7 + 0.3 * signed(rng));
            let (east, north) = (
                reach * turn.cos() + radius * angle.cos(),
                reach * turn.sin() + radius * angle.sin(),
            );
            offset(earth, lat, east.atan2(north).to_degrees(), east.hypot(north))
        })
        .collect()
}

/// The largest error, as a part of the area, of fields at latitudes to 89.9°.
fn worst_of_fields(size: f64, reach: f64) -> [f64; 2] {
    let earth = Theirs::wgs84();
    let mut rng = fastrand::Rng::with_seed(12);
    let mut worst = [Worst::default(); 2];
    for lat in [0.0, 12.0, 30.0, 51.5, -51.5, 70.0, 80.0, 85.0, -89.0, 89.9] {
        let lat = f64::from(lat as f32);
        for _ in 0..60 {
            let offsets = field(&mut rng, &earth, lat, size, reach);
            let corners: Corners = offsets.iter().map(|&(north, east)| (lat + north, east)).collect();
            let right = if size <= 100.0 {
                of_chords(EARTH, &corners)
            } else {
                theirs(&earth, &corners)[1]
            };
            for (worst, found) in worst
                .iter_mut()
                .zip([local::<f64>(EARTH, lat, &offsets), local::<f32>(EARTH, lat, &offsets)])
            {
                worst.add((found / right - 1.0).abs());
            }
        }
    }
    worst.map(Worst::value)
}

/// The table of the documentation.
#[test]
fn fields_to_ten_kilometres_and_far_beyond() {
    for (size, reach, allowed) in [
        (6.0, 0.0, [1e-8, 1e-6]),
        (6.0, 1e4, [1e-8, 1e-6]),
        (100.0, 1e4, [1e-8, 1e-6]),
        (1e4, 5e3, [3e-8, 1e-6]),
        (2e4, 0.0, [3e-8, 1e-6]),
        (1e5, 0.0, [6e-7, 2e-6]),
        (2e5, 0.0, [2e-6, 3e-6]),
        (100.0, 2e5, [1e-8, 1e-6]),
    ] {
        let worst = worst_of_fields(size, reach);
        println!("{size} m at {reach} m: {:.1e}, f32 {:.1e}", worst[0], worst[1]);
        assert!(
            worst[0] < allowed[0] && worst[1] < allowed[1],
            "{size} {reach}: {worst:?}"
        );
    }
}

/// Polygons of any shape, their edges crossing: the error over perimeter and diameter, where the factors of
/// the documentation are from.
#[test]
fn factors_of_the_bound() {
    for (f, diameter) in [
        (0.0, 8e5),
        (EARTH.1, 2e4),
        (EARTH.1, 4e5),
        (0.01, 2e4),
        (0.01, 2e5),
        (0.01, 8e5),
    ] {
        let shape = (EARTH.0, f);
        let earth = Theirs::new(shape.0, shape.1);
        let mut rng = fastrand::Rng::with_seed(13);
        let mut worst = [Worst::default(); 2];
        for case in 0..3000_usize {
            let lat = if case % 2 == 0 {
                90.0 * rng.f64()
            } else {
                [0.0, 10.0, 45.0, 80.0, 89.0][case / 2 % 5]
            };
            let lat = f64::from(lat as f32);
            // Anywhere in a disc, or on its rim, one after the other.
            let (count, turn, rim) = (rng.usize(3..8), 360.0 * rng.f64(), rng.bool());
            let offsets: Corners = (0..count)
                .map(|i| {
                    let (azimuth, part) = if rim {
                        (turn - (i as f64 + 0.6 * rng.f64()) * 360.0 / count as f64, 1.0)
                    } else {
                        (360.0 * rng.f64(), rng.f64().sqrt())
                    };
                    offset(&earth, lat, azimuth, 0.5 * diameter * part)
                })
                .collect();
            let corners: Corners = offsets.iter().map(|&(north, east)| (lat + north, east)).collect();
            let [perimeter, right] = theirs(&earth, &corners);
            let across = corners
                .iter()
                .flat_map(|one| corners.iter().map(move |other| (one, other)));
            let across = across.map(|(one, other)| -> f64 { earth.inverse(one.0, one.1, other.0, other.1) });
            let across = Worst::of(across);
            let found = [local::<f64>(shape, lat, &offsets), local::<f32>(shape, lat, &offsets)];
            for (worst, found) in worst.iter_mut().zip(found) {
                worst.add((found - right).abs() / (across * perimeter));
            }
        }
        let worst = worst.map(Worst::value);
        let square = (diameter / (shape.0 * (1.0 - f) * (1.0 - f))).powi(2);
        let form = 0.03 * f * (2.0 - f) * square + 0.025 * square * square;
        println!(
            "f {f:.4}, {diameter} m: {:.2e} of {form:.2e}, f32 {:.2e}",
            worst[0], worst[1]
        );
        assert!(worst[0] < 1.1 * form && worst[0] > 0.8 * form, "{worst:?} {form}");
        assert!(worst[1] < 1.25 * form + 1.2e-7, "{worst:?} {form}");
    }
}

/// Round a pole, over the 180th meridian, clockwise, with a corner twice, and what encloses nothing.
#[test]
fn any_place_and_any_way_round() {
    let earth = Theirs::wgs84();
    let cap: Corners = (0..12_u8).map(|i| (89.95, 30.0 * f64::from(i) - 180.0)).collect();
    let fields = [
        cap.clone(),
        cap.iter().map(|&(lat, lon)| (-lat, lon)).collect(),
        vec![(90.0, 10.0), (89.99, -60.0), (89.98, 70.0)],
        vec![(-16.8, 179.99), (-16.8, -179.99), (-16.78, -179.99), (-16.78, 179.99)],
        vec![
            (64.1, -21.9),
            (64.1, -21.9),
            (64.11, -21.9),
            (64.11, -21.93),
            (64.11, -21.93),
        ],
    ];
    for mut corners in fields {
        for _ in 0..2 {
            let [_, right] = theirs(&earth, &corners);
            let found = absolute::<f64>(&corners);
            assert!((found / right - 1.0).abs() < 1e-7, "{corners:?}: {found} {right}");
            corners.reverse();
        }
    }
    for corners in [
        vec![],
        vec![(5.0, 6.0)],
        vec![(5.0, 6.0), (5.1, 6.1)],
        vec![(5.0, 6.0); 4],
    ] {
        assert_eq!(absolute::<f64>(&corners), 0.0);
        assert_eq!(absolute::<f32>(&corners), 0.0);
    }
}

/// Far beyond what it is for: a number still.
#[test]
fn corners_anywhere() {
    fn check<T: Scalar>() {
        let mut rng = fastrand::Rng::with_seed(14);
        for a in [1e-15, 6.4e6, 1e15] {
            let area = PlanarArea::local(ellipsoid::<T>((a, 1.0 / 300.0)), place(T::of(50.0), T::ZERO)).unwrap();
            for _ in 0..1000 {
                let mut field = area.polygon();
                for _ in 0..5 {
                    let corner: LatLon<T> = place(T::of(90.0 * signed(&mut rng)), T::of(180.0 * signed(&mut rng)));
                    field.add(corner);
                    let found: f64 = field.area().into();
                    assert!(found.is_finite() && found.abs() < 1e3 * a * a, "{corner:?}: {found}");
                }
            }
        }
    }
    check::<f64>();
    check::<f32>();
    let prolate = Ellipsoid::new(6.4e6, -0.02).unwrap();
    assert_eq!(PlanarArea::new(prolate).unwrap_err().0, -0.02);
}
