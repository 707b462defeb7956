//! Horizon culling against the line of sight itself.

use fastrand::Rng;
use terrella::cube::{CubeMap, Projection};
use terrella::terrain::{Camera, Enclosure, Heights, Horizon, Tile};
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon, Shift};
use testkit::{maximum, minimum};

use crate::sample;

type Point = [f64; 3];

fn shapes() -> [Ellipsoid<f64>; 5] {
    [
        Ellipsoid::WGS84,
        Ellipsoid::MOON,
        Ellipsoid::MARS,
        Ellipsoid::new(6.4e6, 0.3).unwrap(),
        Ellipsoid::new(6.4e6, -0.5).unwrap(),
    ]
}

fn direction(rng: &mut Rng) -> LatLon<f64> {
    let sine: f64 = 2.0 * rng.f64() - 1.0;
    LatLon::new(sine.asin().to_degrees(), 360.0 * rng.f64() - 180.0).unwrap()
}

fn at(ellipsoid: Ellipsoid<f64>, position: LatLon<f64>, height: f64) -> Ecef<f64> {
    ellipsoid.to_ecef(Geodetic::new(position, height).unwrap())
}

/// The least value of (x/a)² + (y/a)² + (z/b)² on the way from one point to another: below 1 it is blocked.
fn lowest_on_the_way(ellipsoid: Ellipsoid<f64>, eye: Ecef<f64>, point: Ecef<f64>) -> f64 {
    let scale = |p: Point| {
        let [x, y, z] = p;
        [x / ellipsoid.a(), y / ellipsoid.a(), z / ellipsoid.b()]
    };
    let (v, t) = (scale(eye.to_array()), scale(point.to_array()));
    let way: Point = std::array::from_fn(|k| t[k] - v[k]);
    let dot = |a: Point, b: Point| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
    let nearest = (-dot(v, way) / dot(way, way)).clamp(0.0, 1.0);
    let at: Point = std::array::from_fn(|k| v[k] + nearest * way[k]);
    dot(at, at)
}

/// An eye, and a point that is near its horizon more often than not.
fn pair(rng: &mut Rng, ellipsoid: Ellipsoid<f64>, highest: f64) -> (Ecef<f64>, Ecef<f64>) {
    let eye_height = 10_f64.powf(8.0 * rng.f64());
    let position = direction(rng);
    let height = highest * rng.f64().powi(3);
    let reach = minimum((2.0 * eye_height / ellipsoid.b()).sqrt(), 1.5) + (2.0 * height / ellipsoid.b()).sqrt();
    let reach = (reach * (0.5 + rng.f64())).to_degrees();
    let (sine, cosine) = (360.0 * rng.f64()).to_radians().sin_cos();
    let lat = (position.lat() + reach * cosine).clamp(-90.0, 90.0);
    let lon = position.lon() + reach * sine / maximum(position.lat().to_radians().cos(), 0.05);
    let point = LatLon::new(lat, lon).unwrap();
    (at(ellipsoid, position, eye_height), at(ellipsoid, point, height))
}

#[test]
fn hidden_is_what_the_ellipsoid_stands_before() {
    let mut rng = Rng::with_seed(1);
    for ellipsoid in shapes() {
        let (mut hidden, mut close) = (0, 0);
        for _ in 0..100_000 {
            let (eye, point) = pair(&mut rng, ellipsoid, 20_000.0);
            let least = lowest_on_the_way(ellipsoid, eye, point);
            let horizon = Horizon::new(ellipsoid, 0.0, eye);
            let hides = horizon.hides(point);
            // Points on the ground have a least of 1 but for rounding if they are seen.
            if (least - 1.0).abs() < 1e-13 {
                close += 1;
                continue;
            }
            assert_eq!(hides, least < 1.0, "{ellipsoid:?} {eye:?} {point:?} {least}");
            hidden += u32::from(hides);
        }
        assert!((20_000..80_000).contains(&hidden), "{hidden}");
        assert!(close < 10_000, "{close}");
    }
}

/// Of parallel lines of sight, against the line itself: how deep it goes into the ellipsoid, scaled to a unit
/// sphere, before it comes to the point.
fn lowest_toward(ellipsoid: Ellipsoid<f64>, point: Point, toward: Point) -> f64 {
    let scale = |[x, y, z]: Point| [x / ellipsoid.a(), y / ellipsoid.a(), z / ellipsoid.b()];
    let (t, d) = (scale(point), scale(toward));
    let dot = |a: Point, b: Point| (0..3).map(|k| a[k] * b[k]).sum::<f64>();
    let nearest = maximum(-dot(t, d) / dot(d, d), 0.0);
    let at: Point = std::array::from_fn(|k| t[k] + nearest * d[k]);
    dot(at, at)
}

/// In both precisions, with rows of any length and sense; single precision may hide less.
#[test]
fn parallel_lines_of_sight_are_hidden_by_the_ellipsoid_before_them() {
    let mut rng = Rng::with_seed(7);
    for ellipsoid in shapes() {
        let single = Ellipsoid::new(ellipsoid.a() as f32, ellipsoid.f() as f32).unwrap();
        // Exactly the same shape in double precision.
        let double = Ellipsoid::new(f64::from(single.a()), f64::from(single.f())).unwrap();
        let (mut hidden, mut both) = (0, 0);
        for _ in 0..20_000 {
            let vector = |rng: &mut Rng| [0; 3].map(|_| (1e-5 * (rng.f64() - 0.5)) as f32);
            let [right, up] = [vector(&mut rng), vector(&mut rng)];
            let eye = at(double, direction(&mut rng), 10_f64.powf(8.0 * rng.f64())).to_array();
            let eye = eye.map(|v| f64::from(v as f32));
            let wide = |v: [f32; 3]| v.map(f64::from);
            let across = {
                let ([a, b, c], [d, e, f]) = (wide(right), wide(up));
                [b * f - c * e, c * d - a * f, a * e - b * d]
            };
            // Rows as a camera has them: at an angle.
            let square = |[x, y, z]: Point| x * x + y * y + z * z;
            if square(across) < 0.3 * square(wide(right)) * square(wide(up)) {
                continue;
            }
            let height: f64 = (0..3)
                .map(|k| across[k] * eye[k] / [double.a(), double.a(), double.b()][k].powi(2))
                .sum();
            let toward = across.map(|v| v * height.signum());
            // Somewhere, or not far from where the shadow begins.
            let place = at(double, direction(&mut rng), 20_000.0 * rng.f64()).to_array();
            let place = place.map(|v| f64::from(v as f32));
            let camera = |scale: f64| {
                let row = |v: [f32; 3]| [wide(v)[0], wide(v)[1], wide(v)[2], 0.25].map(|v| v * scale);
                [row(right), row(up), [0.0; 4], [0.0, 0.0, 0.0, 2.0]]
            };
            let [x, y, z] = eye;
            let view = Camera::new(Ecef::new(x, y, z).unwrap(), camera(3.0), [100.0; 2]).unwrap();
            let horizon = Horizon::of(double, 0.0, &view);
            let [x, y, z] = place;
            let hides = horizon.hides(Ecef::new(x, y, z).unwrap());
            let least = lowest_toward(double, place, toward);
            assert!(
                (least - 1.0).abs() < 1e-12 || hides == (least < 1.0),
                "{double:?} {place:?} {least}"
            );
            hidden += u32::from(hides);
            let [x, y, z] = eye.map(|v| v as f32);
            let rows = camera(1.0).map(|row| row.map(|v| v as f32));
            let view = Camera::new(Ecef::new(x, y, z).unwrap(), rows, [100.0; 2]).unwrap();
            let [x, y, z] = place.map(|v| v as f32);
            let narrow = Horizon::of(single, 0.0, &view).hides(Ecef::new(x, y, z).unwrap());
            assert!(!narrow || least < 1.0, "{double:?} {place:?} {least}");
            both += u32::from(narrow);
        }
        assert!(hidden > 5_000 && both * 10 > hidden * 9, "{hidden} {both}");
    }
}

/// With terrain below the ellipsoid only that is hidden which the ground at the greatest depth hides, whatever is above it.
#[test]
fn nothing_is_hidden_by_ground_that_may_not_be_there() {
    let mut rng = Rng::with_seed(2);
    for ellipsoid in shapes() {
        let mut hidden = 0;
        for _ in 0..4_000 {
            let lowest: f64 = [-430.0, -11_000.0, -100_000.0, 500.0][rng.usize(0..4)];
            let (eye, point) = pair(&mut rng, ellipsoid, 20_000.0);
            let (eye, point) = (deeper(ellipsoid, eye, lowest), deeper(ellipsoid, point, lowest));
            if !Horizon::new(ellipsoid, lowest, eye).hides(point) {
                continue;
            }
            hidden += 1;
            let (v, t) = (eye.to_array(), point.to_array());
            let least = (0..=200)
                .map(|n| {
                    let s = f64::from(n) / 200.0;
                    let [x, y, z] = std::array::from_fn(|k| v[k] + s * (t[k] - v[k]));
                    ellipsoid.to_geodetic(Ecef::new(x, y, z).unwrap()).height()
                })
                .fold(f64::INFINITY, minimum);
            // Between the samples it may be lower still.
            let step = (0..3).map(|k| (t[k] - v[k]).powi(2)).sum::<f64>() / 40_000.0;
            assert!(
                least <= lowest + step / (8.0 * minimum(ellipsoid.b(), ellipsoid.a()) * 0.2) + 1e-6,
                "{least} {lowest}"
            );
        }
        assert!(hidden > 400, "{hidden}");
    }
}

/// The same place, its height counted from the greatest depth.
fn deeper(ellipsoid: Ellipsoid<f64>, point: Ecef<f64>, lowest: f64) -> Ecef<f64> {
    let place = ellipsoid.to_geodetic(point);
    at(ellipsoid, place.lat_lon(), place.height() + lowest)
}

#[test]
fn from_inside_nothing_is_hidden() {
    let mut rng = Rng::with_seed(3);
    for ellipsoid in shapes() {
        for _ in 0..2_000 {
            let (place, point) = (direction(&mut rng), direction(&mut rng));
            let point = at(ellipsoid, point, 20_000.0 * rng.f64() - 15_000.0);
            // Under the ellipsoid, and without terrain that deep.
            let below = at(ellipsoid, place, -1.0 - 10_000.0 * rng.f64());
            assert!(!Horizon::new(ellipsoid, 0.0, below).hides(point));
            // With it, an eye in a valley sees what is near.
            let horizon = Horizon::new(ellipsoid, -11_000.0, below);
            assert!(!horizon.hides(below));
            let opposite = LatLon::new(-place.lat(), place.lon() + 180.0).unwrap();
            let outside = at(ellipsoid, place, 10.0);
            assert!(Horizon::new(ellipsoid, -11_000.0, outside).hides(at(ellipsoid, opposite, 0.0)));
            // Depths that leave no planet.
            for lowest in [
                -minimum(ellipsoid.a(), ellipsoid.b()),
                -1e9,
                f64::NEG_INFINITY,
                f64::NAN,
            ] {
                assert!(!Horizon::new(ellipsoid, lowest, outside).hides(at(ellipsoid, opposite, 0.0)));
            }
        }
        let centre = Ecef::new(0.0, 0.0, 0.0).unwrap();
        assert!(!Horizon::new(ellipsoid, 0.0, centre).hides(at(ellipsoid, LatLon::default(), 1.0)));
    }
}

#[test]
fn points_below_are_hidden_beyond_the_horizon_only() {
    let mut rng = Rng::with_seed(4);
    for ellipsoid in shapes() {
        for _ in 0..20_000 {
            let (eye, point) = pair(&mut rng, ellipsoid, 5_000.0);
            let horizon = Horizon::new(ellipsoid, 0.0, eye);
            let [x, y, z] = point.to_array();
            let sunk = |s: f64| Ecef::new(s * x, s * y, s * z).unwrap();
            // All the way down below a hidden point.
            if horizon.hides(point) {
                for s in [0.9999, 0.9, 0.5, 0.0] {
                    assert!(horizon.hides(sunk(s)), "{s}");
                }
            }
            // Right below the eye it is as if seen.
            let [x, y, z] = eye.to_array();
            let least = lowest_on_the_way(ellipsoid, eye, Ecef::new(0.0, 0.0, 0.0).unwrap());
            assert_eq!(least, 0.0);
            let size = (x * x + y * y) / ellipsoid.a().powi(2) + z * z / ellipsoid.b().powi(2);
            let s = 0.999 / size.sqrt();
            // The plane of the horizon is 1/|V| from the centre.
            if s * size > 1.0 + 1e-9 {
                assert!(!horizon.hides(Ecef::new(s * x, s * y, s * z).unwrap()));
            }
        }
    }
}

/// In single precision never more is hidden than in double: rounding is on the safe side.
#[test]
fn rounding_hides_nothing() {
    let mut rng = Rng::with_seed(5);
    for ellipsoid in shapes() {
        let single = Ellipsoid::new(ellipsoid.a() as f32, ellipsoid.f() as f32).unwrap();
        // Exactly the same shape in double precision.
        let double = Ellipsoid::new(f64::from(single.a()), f64::from(single.f())).unwrap();
        let (mut both, mut only) = (0, 0);
        for _ in 0..100_000 {
            let (eye, point) = pair(&mut rng, double, 20_000.0);
            let round = |p: Ecef<f64>| p.to_array().map(|v| v as f32);
            let (v, t) = (round(eye), round(point));
            let wide = |[x, y, z]: [f32; 3]| Ecef::new(x.into(), y.into(), z.into()).unwrap();
            let narrow = |[x, y, z]: [f32; 3]| Ecef::new(x, y, z).unwrap();
            let exact = lowest_on_the_way(double, wide(v), wide(t)) < 1.0;
            let hides = Horizon::new(single, 0.0, narrow(v)).hides(narrow(t));
            assert!(exact || !hides, "{v:?} {t:?}");
            both += u32::from(hides);
            only += u32::from(exact && !hides);
        }
        assert!(both > 10_000 && only < both / 5, "{both} {only}");
    }
}

/// A tile whose box is hidden is hidden, and most hidden tiles have hidden boxes.
#[test]
fn tiles_are_hidden_with_their_boxes() {
    let mut rng = Rng::with_seed(6);
    for projection in [Projection::Quadrilateralized, Projection::Healpix, Projection::Balanced] {
        let ellipsoid = Ellipsoid::<f64>::WGS84;
        let map = CubeMap::new(ellipsoid, Shift::Authalic, projection).unwrap();
        let enclosure = Enclosure::new(map);
        let heights = Heights::new(-500.0, 2_000.0).unwrap();
        let (mut hidden, mut found) = (0, 0);
        for _ in 0..20_000 {
            let eye = at(ellipsoid, direction(&mut rng), 10_f64.powf(2.0 + 5.0 * rng.f64()));
            let horizon = Horizon::new(ellipsoid, -500.0, eye);
            let level = rng.u8(1..8);
            let tile: Tile = sample::tile_of(&mut rng, level);
            let all = (0..81_u32).all(|n| {
                let node = tile.node([n % 9, n / 9], 8);
                horizon.hides(at(ellipsoid, map.unproject(node), 2_000.0))
            });
            let boxed = horizon.hides_box(&enclosure.of(tile, heights));
            assert!(all || !boxed, "{projection} {tile:?}");
            hidden += u32::from(all);
            found += u32::from(boxed);
        }
        assert!(
            hidden > 8_000 && f64::from(found) > 0.9 * f64::from(hidden),
            "{projection} {found} of {hidden}"
        );
    }
}

#[test]
fn the_horizon_is_as_far_as_it_should() {
    let ellipsoid = Ellipsoid::<f64>::sphere(6_371_000.0).unwrap();
    let eye = at(ellipsoid, LatLon::default(), 1000.0);
    let horizon = Horizon::new(ellipsoid, 0.0, eye);
    let seen = (0..200_000)
        .take_while(|n| {
            let lon = f64::from(*n) * 1e-5;
            !horizon.hides(at(ellipsoid, LatLon::new(0.0, lon).unwrap(), 0.0))
        })
        .count();
    let angle = (6_371_000.0_f64 / 6_372_000.0).acos().to_degrees();
    assert!((seen as f64 * 1e-5 - angle).abs() < 2e-5, "{seen} {angle}");
}
