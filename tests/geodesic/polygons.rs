//! Areas of polygons next to GeographicLib's: poles, opposite meridians, rings of several turns, repeated
//! corners, holes.

use geographiclib_rs::{Geodesic as Theirs, InverseGeodesic, PolygonArea as TheirPolygon, Winding};
use terrella::Ellipsoid;
use terrella::geodesic::{Area, Geodesic, Karney};
use testkit::Worst;

use crate::sample::{even, place, signed};
use testkit::truth::Scalar;

/// The area of the Earth's ellipsoid in m²: 40 digits, rounded.
const WHOLE: f64 = 510_065_621_724_088.44;

type Corners = Vec<(f64, f64)>;

fn drawn<T: Scalar>(area: &Area<T>, corners: &[(f64, f64)]) -> [f64; 2] {
    let mut polygon = area.polygon();
    for &(lat, lon) in corners {
        polygon.add(place(T::of(lat), T::of(lon)));
    }
    [polygon.area().into(), polygon.perimeter().into()]
}

fn theirs(wgs84: &Theirs, corners: &[(f64, f64)]) -> [f64; 2] {
    let mut polygon = TheirPolygon::new(wgs84, Winding::CounterClockwise);
    for &(lat, lon) in corners {
        polygon.add_point(lat, lon);
    }
    let (perimeter, area, _) = polygon.compute(true);
    [area, perimeter]
}

/// A corner: anywhere, on a grid of ten degrees, at a pole.
fn corner(rng: &mut fastrand::Rng) -> (f64, f64) {
    match rng.u8(0..8) {
        0 => (*rng.choice(&[90.0, -90.0]).unwrap(), 10.0 * f64::from(rng.i8(-18..=18))),
        1 | 2 => (10.0 * f64::from(rng.i8(-9..=9)), 10.0 * f64::from(rng.i8(-18..=18))),
        3 => (even(rng).0, *rng.choice(&[0.0, -0.0, 180.0, -180.0]).unwrap()),
        _ => even(rng),
    }
}

/// What may follow a corner: anything, the same, its longitude, the opposite meridian, exactly or nearly.
fn next(rng: &mut fastrand::Rng, (lat, lon): (f64, f64)) -> (f64, f64) {
    let opposite = if lon > 0.0 { lon - 180.0 } else { lon + 180.0 };
    match rng.u8(0..8) {
        0 => (lat, lon),
        1 => (even(rng).0, lon),
        2 | 3 => (even(rng).0, opposite),
        4 => {
            let beside = opposite + signed(rng) * 10f64.powi(-rng.i32(3..16));
            (even(rng).0, beside.clamp(-180.0, 180.0))
        }
        _ => corner(rng),
    }
}

/// A longitude brought to [−180, 180].
fn turned(lon: f64) -> f64 {
    lon - 360.0 * (lon / 360.0).round()
}

/// A polygon of one of the kinds.
fn polygon(rng: &mut fastrand::Rng) -> Corners {
    let mut corners = Corners::new();
    match rng.u8(0..3) {
        // Any corners.
        0 => {
            let mut at = corner(rng);
            for _ in 0..rng.usize(1..9) {
                corners.push(at);
                at = next(rng, at);
            }
        }
        // Up to six times round a pole.
        1 => {
            let turns = rng.u8(1..=6);
            let (south, width) = (180.0 * rng.f64() - 90.0, 40.0 * rng.f64());
            let whole = rng.bool();
            let start = if whole {
                30.0 * f64::from(rng.i8(-6..=6))
            } else {
                180.0 * signed(rng)
            };
            let steps = *rng.choice(&[2_u8, 3, 4, 6]).unwrap();
            for step in 0..turns * steps {
                let spread = if whole { 0.0 } else { 20.0 * signed(rng) };
                let lon = turned(start + 360.0 / f64::from(steps) * f64::from(step) + spread);
                corners.push(((south + width * rng.f64()).clamp(-90.0, 90.0), lon));
            }
        }
        // About a place.
        _ => {
            let (lat, lon) = corner(rng);
            let size = 10f64.powf(-5.0 * rng.f64()) * 40.0;
            let count = rng.usize(1..9);
            for i in 0..count {
                let (sin, cos) = (std::f64::consts::TAU * (i as f64 + 0.3 * rng.f64()) / count as f64).sin_cos();
                let corner = ((lat + size * sin).clamp(-90.0, 90.0), turned(lon + 2.0 * size * cos));
                corners.push(corner);
            }
        }
    }
    if rng.u8(0..4) == 0 {
        let at = rng.usize(0..corners.len());
        corners.insert(at, corners[at]);
    }
    if rng.bool() {
        corners.reverse();
    }
    corners
}

/// The difference of two areas; of halves of the ellipsoid, but for so much, that of their sizes: the sign is
/// rounding's.
fn apart(found: f64, right: f64, rounding: f64) -> f64 {
    let half = |area: f64| area.abs() >= 0.5 * WHOLE - rounding;
    if half(found) && half(right) {
        (found.abs() - right.abs()).abs()
    } else {
        (found - right).abs()
    }
}

/// Whether two longitudes are 180° apart, exactly: both can be had from the other.
fn opposite(lon1: f64, lon2: f64) -> bool {
    let turn = lon2 - lon1;
    turn.abs() == 180.0 && lon1 + turn == lon2 && lon2 - turn == lon1
}

/// Whether an edge joins opposite places: over either pole it is as short, and ours is the line that starts to the
/// north.
fn antipodal(corners: &[(f64, f64)]) -> bool {
    let first = corners.iter().cycle().skip(1);
    corners
        .iter()
        .zip(first)
        .any(|(&(lat1, lon1), &(lat2, lon2))| lat1 + lat2 == 0.0 && opposite(lon1, lon2))
}

/// Whether an edge has neighbours as short, whose area is another: nearly antipodal places, not on one circle
/// of meridians.
fn ill_conditioned(wgs84: &Theirs, corners: &[(f64, f64)]) -> bool {
    let first = corners.iter().cycle().skip(1);
    corners.iter().zip(first).any(|(&(lat1, lon1), &(lat2, lon2))| {
        let lengths: (f64, f64, f64, f64, f64, f64, f64) = wgs84.inverse(lat1, lon1, lat2, lon2);
        let (s12, _, _, m12, ..) = lengths;
        s12 > 1e6 && m12 < 0.1 * s12 && !opposite(lon1, lon2)
    })
}

/// The worst of so many polygons: of the areas in f64, well- and ill-conditioned, of those in f32 of the same
/// corners rounded, next to f64, and of the perimeters in f64.
fn worst(seeds: core::ops::Range<u64>, each: u32) -> [f64; 4] {
    let of_seed = |seed| {
        let wgs84 = Theirs::wgs84();
        let double = Area::<f64>::new(Ellipsoid::WGS84).unwrap();
        let single = Area::<f32>::new(Ellipsoid::WGS84).unwrap();
        let mut rng = fastrand::Rng::with_seed(seed);
        let mut worst = [Worst::default(); 4];
        for _ in 0..each {
            let corners = polygon(&mut rng);
            if antipodal(&corners) {
                continue;
            }
            let ([area, around], [their_area, their_around]) = (drawn(&double, &corners), theirs(&wgs84, &corners));
            let error = apart(area, their_area, 1.0);
            let ill = ill_conditioned(&wgs84, &corners);
            // Of nearly antipodal corners the documentation says how much.
            let allowed = if ill { 1e4 } else { 0.02 * corners.len() as f64 + 0.3 };
            assert!(error < allowed, "{corners:?}: {area} {their_area}");
            worst[usize::from(ill)].add(error);
            let error = (around - their_around).abs();
            assert!(
                error < 1e-8 * corners.len() as f64 + 1e-7,
                "{corners:?}: {around} {their_around}"
            );
            worst[3].add(error);
            let rounded: Corners = corners
                .iter()
                .map(|&(lat, lon)| (f64::from(lat as f32), f64::from(lon as f32)))
                .collect();
            if !ill_conditioned(&wgs84, &rounded) && !antipodal(&rounded) {
                let ([area, _], [right, _]) = (drawn(&single, &rounded), drawn(&double, &rounded));
                let error = apart(area, right, 1e8);
                assert!(
                    error < 6e7 + 1e7 * corners.len() as f64,
                    "f32 {rounded:?}: {area} {right}"
                );
                worst[2].add(error);
            }
        }
        worst.map(Worst::value)
    };
    let all = testkit::parallel::map(seeds, of_seed);
    core::array::from_fn(|i| Worst::of(all.iter().map(|worst| worst[i])))
}

fn say(polygons: u32, [well, ill, single, around]: [f64; 4]) {
    println!(
        "{polygons} polygons: area {well:.2e} m², ill-conditioned {ill:.2e} m², f32 {single:.2e} m²; perimeter {around:.2e} m"
    );
}

#[test]
fn areas_are_those_of_geographiclib() {
    say(20_000, worst(0..20, 1000));
}

/// `cargo test --release --test geodesic -- --ignored --nocapture polygons`
#[test]
#[ignore = "10⁶ polygons"]
fn areas_are_those_of_geographiclib_ten_to_the_six() {
    say(1_000_000, worst(20..1020, 1000));
}

/// Of f64 and f32.
fn both(corners: &[(f64, f64)]) -> [f64; 2] {
    let [double, _] = drawn(&Area::<f64>::new(Ellipsoid::WGS84).unwrap(), corners);
    let [single, _] = drawn(&Area::<f32>::new(Ellipsoid::WGS84).unwrap(), corners);
    [double, single]
}

fn is(corners: &[(f64, f64)], right: f64, why: &str) {
    let [double, single] = both(corners);
    assert!((double - right).abs() < 1.0, "{why}: {double} for {right}");
    assert!(
        (single - right).abs() < 1e7 * (corners.len() + 2) as f64,
        "{why}, f32: {single} for {right}"
    );
}

/// Edges that span 180° of longitude, exactly or after rounding: found by comparing random polygons with
/// GeographicLib 2.1.
#[test]
fn edges_between_opposite_meridians() {
    let octant = WHOLE / 8.0;
    is(&[(0.0, -180.0), (0.0, -90.0), (90.0, 0.0)], octant, "an octant");
    is(
        &[(0.0, 0.0), (0.0, 90.0), (90.0, -90.0)],
        octant,
        "its pole written otherwise",
    );
    is(
        &[(60.0, -180.0), (60.0, -170.0), (90.0, 0.0)],
        952_075_453_908.0,
        "a cell of the 10° grid",
    );
    is(
        &[(80.0, 90.0), (80.0, -90.0), (70.0, 0.0)],
        2_525_694_870_693.0,
        "over the pole, westward",
    );
    is(
        &[(45.0, -120.0), (45.0, -60.0), (45.0, 60.0)],
        24_244_455_919_336.0,
        "over the pole, eastward",
    );
    is(
        &[(-20.0, -80.0), (40.0, 130.0), (60.0, -50.0)],
        -65_479_721_606_497.0,
        "three continents",
    );
}

/// Half of these failed in f32, a quarter in f64.
#[test]
fn triangles_with_an_edge_between_opposite_meridians() {
    fn check<T: Scalar>(allowed: f64) {
        let mut rng = fastrand::Rng::with_seed(16);
        let wgs84 = Theirs::wgs84();
        let area = Area::<T>::new(Ellipsoid::WGS84).unwrap();
        for _ in 0..2000 {
            let ((lat1, lon), (lat2, _), third) = (even(&mut rng), even(&mut rng), even(&mut rng));
            let rounded = |x: f64| -> f64 { T::of(x).into() };
            let opposite = if lon > 0.0 { lon - 180.0 } else { lon + 180.0 };
            let corners = [(lat1, lon), (lat2, opposite), third].map(|(lat, lon)| (rounded(lat), rounded(lon)));
            if ill_conditioned(&wgs84, &corners) {
                continue;
            }
            let ([found, _], [right, _]) = (drawn(&area, &corners), theirs(&wgs84, &corners));
            let error = apart(found, right, allowed);
            assert!(error < allowed, "{} {corners:?}: {found} {right}", T::NAME);
        }
    }
    check::<f64>(0.3);
    check::<f32>(6e7);
}

/// GeographicLib's Planimeter21 to Planimeter29 and their like to the south: a remainder, not one
/// subtraction.
#[test]
fn rings_that_run_several_times_round_a_pole() {
    let once = 39_433_884_866_571.43;
    let ring = [(45.0, 60.0), (45.0, 180.0), (45.0, -60.0)];
    let back = [(45.0, -60.0), (45.0, 180.0), (45.0, 60.0)];
    for turns in 1..=40_u8 {
        let all = f64::from(turns) * once;
        let area = all - WHOLE * (all / WHOLE).round();
        is(&ring.repeat(turns.into()), area, &format!("{turns} times"));
        is(&back.repeat(turns.into()), -area, &format!("{turns} times back"));
    }
    is(&ring.repeat(4), 157_735_539_466_286.0, "four times");
    let south = [(-60.0, 0.0), (-60.0, 120.0), (-60.0, -120.0)];
    is(&south.repeat(4), -63_188_102_786_336.0, "four times in the south");
}

/// To the left of the corners' way, positive, either way round: the range is open below.
#[test]
fn a_half_of_the_ellipsoid_is_positive() {
    let half = 0.5 * WHOLE;
    let circle = |lon: f64| {
        let opposite = turned(lon + 180.0);
        [
            vec![(0.0, lon), (90.0, lon), (0.0, opposite), (-90.0, opposite)],
            vec![(90.0, 25.0), (-40.0, lon), (30.0, opposite)],
        ]
    };
    let equator = vec![(0.0, 0.0), (0.0, 120.0), (0.0, -120.0)];
    let mut hemispheres = vec![equator.clone(), equator.repeat(3)];
    for lon in [0.0, -180.0, 180.0, 10.0, -77.0, 90.0, 120.0, -45.5] {
        hemispheres.extend(circle(lon));
    }
    for mut corners in hemispheres {
        for _ in 0..2 {
            let [double, single] = both(&corners);
            assert!((double - half).abs() < 0.1, "{corners:?}: {double}");
            assert!((single - half).abs() < 4e7, "{corners:?}: {single}");
            corners.reverse();
        }
    }
}

/// What encloses nothing, however it is written.
#[test]
fn what_encloses_nothing() {
    for corners in [
        vec![],
        vec![(1.0, 1.0)],
        vec![(1.0, 1.0), (2.0, 2.0)],
        vec![(9.0, -1e-14), (9.0, 180.0), (9.0, 0.0)],
        vec![(9.0, 1e-14), (9.0, 0.0), (9.0, 180.0)],
        vec![(9.0, 1e-14), (9.0, 180.0), (9.0, 0.0)],
        vec![(9.0, -1e-14), (9.0, 0.0), (9.0, 180.0)],
        vec![(66.5, 0.0), (66.5, 180.0), (66.5, -0.0)],
        vec![(66.5, -0.0), (66.5, -180.0), (66.5, 0.0)],
        vec![(90.0, 0.0), (90.0, 120.0), (90.0, -120.0)],
        vec![(-90.0, 0.0), (-90.0, 90.0), (-90.0, 180.0), (-90.0, -90.0)],
        vec![(50.0, 180.0), (50.0, -180.0), (50.0, 180.0)],
        vec![(90.0, 10.0), (20.0, 30.0), (90.0, 50.0)],
        vec![
            (-90.0, 10.0),
            (-90.0, 170.0),
            (20.0, 30.0),
            (-90.0, -50.0),
            (-90.0, -150.0),
        ],
    ] {
        is(&corners, 0.0, &format!("{corners:?}"));
    }
}

/// From pole to pole and back, on ellipsoids of every flattening: a lune.
#[test]
fn lunes() {
    for f in [-1.0 / 9.0, -0.01, -1e-10, 0.0, 1e-10, 1.0 / 298.257_223_563, 0.01, 0.1] {
        let ellipsoid = Ellipsoid::new(6.4e6, f).unwrap();
        let area = Area::<f64>::new(ellipsoid).unwrap();
        let whole = 8.0 * drawn(&area, &[(0.0, 0.0), (0.0, 90.0), (90.0, 90.0)])[0];
        for (west, east, share) in [
            (0.0, 90.0, 0.25),
            (-30.0, 60.0, 0.25),
            (170.0, -100.0, 0.25),
            (20.0, 21.0, 1.0 / 360.0),
        ] {
            let [lune, _] = drawn(&area, &[(90.0, west), (-90.0, west), (-90.0, east), (90.0, east)]);
            assert!((lune - share * whole).abs() < 0.3, "{f} {west} {east}: {lune}");
            let [lune, _] = drawn(
                &area,
                &[(90.0, west), (0.0, west), (-90.0, 5.0), (10.0, east), (90.0, -7.0)],
            );
            assert!((lune - share * whole).abs() < 0.3, "{f} {west} {east}: {lune}");
        }
    }
}

/// Which pole the edge between opposite meridians goes over is the same for its azimuths, its area and the
/// way along it.
#[test]
fn areas_and_azimuths_take_the_same_pole() {
    fn check<T: Scalar>(allowed: f64) {
        let area = Area::<T>::new(Ellipsoid::WGS84).unwrap();
        let karney = Karney::<T>::new(Ellipsoid::WGS84).unwrap();
        let mut rng = fastrand::Rng::with_seed(17);
        for case in 0..2000 {
            let lat = |rng: &mut fastrand::Rng| f64::from(rng.i8(-89..=89));
            let (lat1, lat2) = (lat(&mut rng), lat(&mut rng));
            // A third of them antipodal.
            let lat2 = if case % 3 == 0 { -lat1 } else { lat2 };
            let (lon1, lon2) = *rng
                .choice(&[(0.0, 180.0), (0.0, -180.0), (10.0, -170.0), (-170.0, 10.0)])
                .unwrap();
            let (from, to) = (place(T::of(lat1), T::of(lon1)), place(T::of(lat2), T::of(lon2)));
            let line = karney.solve(from, to).inverse;
            assert_eq!(karney.inverse(from, to).unwrap(), line);
            let azimuth: f64 = line.azimuth1.into();
            let north = azimuth == 0.0;
            assert!(north || azimuth.abs() == 180.0, "{azimuth}");
            assert!(north == (lat1 + lat2 > 0.0) || lat1 + lat2 == 0.0, "{from:?} {to:?}");
            let east = lon2 > lon1;
            let right = if north == east { 0.25 * WHOLE } else { -0.25 * WHOLE };
            let under: f64 = area.under(from, to).into();
            assert!((under - right).abs() < allowed, "{from:?} {to:?}: {under} {right}");
        }
    }
    check::<f64>(0.1);
    check::<f32>(2e7);
}

/// The area under the way along a line is that under the line to where it ends.
#[test]
fn areas_along_lines() {
    let area = Area::<f64>::new(Ellipsoid::WGS84).unwrap();
    let karney = Karney::<f64>::new(Ellipsoid::WGS84).unwrap();
    let wgs84 = Theirs::wgs84();
    let mut rng = fastrand::Rng::with_seed(18);
    for _ in 0..5000 {
        let ((lat1, lon1), (lat2, lon2)) = (corner(&mut rng), corner(&mut rng));
        // At a pole the line to it ends, and the edge turns.
        if lat1.abs() == 90.0 || lat2.abs() == 90.0 || ill_conditioned(&wgs84, &[(lat1, lon1), (lat2, lon2)]) {
            continue;
        }
        let (from, to) = (place(lat1, lon1), place(lat2, lon2));
        let way = karney.solve(from, to).inverse;
        let (under, along) = (
            area.under(from, to),
            area.under_direct(from, way.azimuth1, way.distance).unwrap(),
        );
        // Over a pole a line has an east only by the signs of zeros.
        let over = (lon2 - lon1).abs() == 180.0;
        let error = if over {
            apart(2.0 * under, 2.0 * along, 1.0)
        } else {
            (under - along).abs()
        };
        assert!(error < 0.3, "{from:?} {to:?}: {under} {along}");
    }
}

/// What lies to the left and to the right, and clockwise areas, next to GeographicLib's `reverse` and `sign`.
#[test]
fn areas_of_either_side() {
    let area = Area::<f64>::new(Ellipsoid::WGS84).unwrap();
    let wgs84 = Theirs::wgs84();
    let mut rng = fastrand::Rng::with_seed(21);
    for _ in 0..2000 {
        let corners = polygon(&mut rng);
        let mut ours = area.polygon();
        for &(lat, lon) in &corners {
            ours.add(place(lat, lon));
        }
        let theirs = |winding, sign| {
            let mut polygon = TheirPolygon::new(&wgs84, winding);
            corners.iter().for_each(|&(lat, lon)| polygon.add_point(lat, lon));
            polygon.compute(sign).1
        };
        // Of halves and of nothing the sign is rounding's.
        if ours.area().abs() < 1e4 || ours.area().abs() > 0.5 * WHOLE - 1e6 {
            continue;
        }
        let found = [ours.area(), ours.clockwise_area(), ours.left_area(), ours.right_area()];
        let right = [
            theirs(Winding::CounterClockwise, true),
            theirs(Winding::Clockwise, true),
            theirs(Winding::CounterClockwise, false),
            theirs(Winding::Clockwise, false),
        ];
        for (found, right) in found.into_iter().zip(right) {
            assert!((found - right).abs() < 2.0, "{corners:?} {found} {right}");
        }
    }
    let mut half = area.polygon();
    for lon in [0.0, 120.0, -120.0] {
        half.add(place(0.0, lon));
    }
    let halves = [half.area(), half.clockwise_area(), half.left_area(), half.right_area()];
    assert!(
        halves.into_iter().all(|area| (area - WHOLE / 2.0).abs() < 0.1),
        "{halves:?}"
    );
    let none = area.polygon();
    assert_eq!(
        [none.area(), none.clockwise_area(), none.left_area(), none.right_area()],
        [0.0; 4]
    );
}

/// Latitude and longitude, azimuths and lengths, area and perimeter.
type ByEdges = ((f64, f64), &'static [(f64, f64)], f64, f64);

/// Polygons by edges: as by their corners, if the edges are shortest lines; and GeographicLib 2.1.2's `AddEdge` for lines
/// of several circuits, over poles, along the equator and backwards.
#[test]
fn polygons_by_edges() {
    let area = Area::<f64>::new(Ellipsoid::WGS84).unwrap();
    let karney = Karney::new(Ellipsoid::<f64>::WGS84).unwrap();
    let mut rng = fastrand::Rng::with_seed(22);
    for _ in 0..2000 {
        let mut corners: Vec<_> = polygon(&mut rng)
            .into_iter()
            .map(|(lat, lon)| place(lat, lon))
            .collect();
        corners.dedup();
        let (mut by_corners, mut by_edges) = (area.polygon(), area.polygon());
        let mut short = true;
        for (i, &corner) in corners.iter().enumerate() {
            by_corners.add(corner);
            if i == 0 {
                by_edges.add(corner);
                continue;
            }
            let line = karney.inverse(corners[i - 1], corner).unwrap();
            let poles = corners[i - 1].lat().abs() == 90.0 || corner.lat().abs() == 90.0;
            let across = (corner.lon() - corners[i - 1].lon()).abs();
            short &= line.distance < 1.9e7 && !poles && across % 180.0 != 0.0;
            by_edges.add_edge(line.azimuth1, line.distance).unwrap();
        }
        if !short {
            continue;
        }
        let apart = (by_corners.area() - by_edges.area()).abs();
        assert!(
            apart < 50.0 || WHOLE - apart < 50.0 || by_corners.area().abs() > 0.5 * WHOLE - 50.0,
            "{corners:?} {apart}"
        );
        assert!((by_corners.perimeter() - by_edges.perimeter()).abs() < 1e-6);
        assert!((by_corners.length() - by_edges.length()).abs() < 1e-6);
    }
    let cases: [ByEdges; 5] = [
        (
            (10.0, 20.0),
            &[(45.0, 25000000.0), (120.0, 30000000.0)],
            -251042298707392.91,
            69958237.938332736,
        ),
        (
            (0.0, 0.0),
            &[(0.0, 50000000.0), (90.0, 100000000.0)],
            127644889087263.78,
            160011792.8949188,
        ),
        (
            (-30.0, -170.0),
            &[(-0.0, 45000000.0), (-90.0, 30000000.0)],
            -31962172292491.945,
            85069844.588330626,
        ),
        (
            (80.0, 10.0),
            &[(10.0, 20000000.0), (-120.0, -5000000.0), (170.0, 90000000.0)],
            -205869649800250.12,
            119593265.39392339,
        ),
        (
            (5.0, -0.0),
            &[(180.0, 15000000.0), (-180.0, 60000000.0), (45.0, 100000.0)],
            254846253509716.44,
            80163235.914716601,
        ),
    ];
    for (start, edges, right, perimeter) in cases {
        let mut polygon = area.polygon();
        assert_eq!(polygon.add_edge(0.0, 1.0), Ok(None));
        polygon.add(place(start.0, start.1));
        for &(azimuth, length) in edges {
            polygon.add_edge(azimuth, length).unwrap();
        }
        assert!(
            apart(polygon.area(), right, 1.0) < 20.0,
            "{start:?} {edges:?} {} {right}",
            polygon.area()
        );
        assert!((polygon.perimeter() - perimeter).abs() < 1e-6, "{start:?} {edges:?}");
    }
    let mut polygon = area.polygon();
    polygon.add(place(1.0, 2.0));
    let before = polygon;
    assert!(polygon.add_edge(f64::NAN, 1.0).is_err() && polygon.add_edge(0.0, f64::INFINITY).is_err());
    assert_eq!(polygon, before);
}

/// A square with a hole, added as two rings.
#[test]
fn rings_add_up() {
    let area = Area::<f64>::new(Ellipsoid::WGS84).unwrap();
    let outer = [(0.0, -5.0), (0.0, 5.0), (10.0, 5.0), (10.0, -5.0)];
    let hole = [(4.0, -1.0), (6.0, -1.0), (6.0, 1.0), (4.0, 1.0)];
    let mut both = area.polygon();
    let mut sum = [0.0; 2];
    for ring in [outer, hole] {
        let mut one = area.polygon();
        for (lat, lon) in ring {
            both.add(place(lat, lon));
            one.add(place(lat, lon));
        }
        both.close();
        sum = [sum[0] + one.area(), sum[1] + one.perimeter()];
    }
    assert!((both.area() - sum[0]).abs() < 1e-2 && (both.perimeter() - sum[1]).abs() < 1e-6);
    assert_eq!(both.length(), both.perimeter());
}
