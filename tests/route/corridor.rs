//! Corridors: how far their edges are from the line, and which places they hold.

use fastrand::Rng;
use terrella::geodesic::{Area, Geodesic, Karney};
use terrella::route::{Corridor, Fence, InvalidArc, Side};
use terrella::{Ellipsoid, LatLon};
use testkit::Worst;

fn earth() -> Karney<f64> {
    Karney::new(Ellipsoid::WGS84).unwrap()
}

fn at(lat: f64, lon: f64) -> LatLon<f64> {
    LatLon::new(lat, lon).unwrap()
}

/// How far a place is from a leg, by thirds of what is left.
fn from_leg(earth: &Karney<f64>, place: LatLon<f64>, from: LatLon<f64>, to: LatLon<f64>) -> f64 {
    let way = earth.inverse(from, to).unwrap();
    let line = earth.line(from, way.azimuth1).unwrap();
    let far = |along: f64| earth.distance(place, line.at(along).unwrap().position).unwrap();
    let (mut low, mut high) = (0.0, way.distance);
    for _ in 0..45 {
        let (one, two) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if far(one) < far(two) {
            high = two;
        } else {
            low = one;
        }
    }
    far(low)
}

fn from_line(earth: &Karney<f64>, place: LatLon<f64>, line: &[LatLon<f64>]) -> f64 {
    if line.len() == 1 {
        return earth.distance(place, line[0]).unwrap();
    }
    let legs = line.iter().zip(&line[1..]);
    legs.map(|(&from, &to)| from_leg(earth, place, from, to))
        .reduce(testkit::minimum)
        .unwrap()
}

/// A line that does not come back to itself: turns of at most 120°, legs far longer than the corridor is wide.
fn line(rng: &mut Rng, earth: &Karney<f64>, width: f64, legs: usize) -> Vec<LatLon<f64>> {
    let mut places = vec![at(170.0 * rng.f64() - 85.0, 360.0 * rng.f64() - 180.0)];
    let mut azimuth = 360.0 * rng.f64();
    for leg in 0..legs {
        let end = earth
            .direct(places[leg], azimuth, width * (8.0 + 30.0 * rng.f64()))
            .unwrap();
        places.push(end.position);
        azimuth = end.azimuth
            + if leg % 2 == 0 {
                120.0 * rng.f64()
            } else {
                -120.0 * rng.f64()
            };
    }
    places
}

#[test]
fn edges_are_within_the_tolerance() {
    let (earth, mut rng) = (earth(), Rng::with_seed(1));
    let area = Area::new(Ellipsoid::WGS84).unwrap();
    for (width, tolerance) in [(10.0, 0.1), (500.0, 5.0), (10_000.0, 50.0), (100_000.0, 3_000.0)] {
        let (mut inner, mut outer) = (Worst::default(), Worst::default());
        for legs in [1, 2, 3, 5] {
            let line = line(&mut rng, &earth, width, legs);
            let corridor = Corridor::new(&earth, &line, width, tolerance).unwrap();
            let corners: Vec<_> = corridor.outline().collect();
            let mut polygon = area.polygon();
            corners.iter().for_each(|&corner| polygon.add(corner));
            assert!(polygon.area() > 0.0, "{line:?}");
            for (i, &from) in corners.iter().enumerate() {
                let way = earth.inverse(from, corners[(i + 1) % corners.len()]).unwrap();
                for part in [0.0, 0.5] {
                    let place = earth.direct(from, way.azimuth1, way.distance * part).unwrap().position;
                    let apart = from_line(&earth, place, &line) - width;
                    inner.add(-apart);
                    outer.add(apart);
                }
            }
        }
        println!("corridor {width}: inner {inner:?} outer {outer:?}");
        assert!(
            inner.value() <= tolerance && outer.value() <= tolerance,
            "{width} {inner:?} {outer:?}"
        );
    }
}

/// Long legs need corners beside them.
#[test]
fn beside_long_legs() {
    let earth = earth();
    let line = [at(50.0, 0.0), at(55.0, 60.0)];
    let corridor = Corridor::new(&earth, &line, 5_000.0, 1.0).unwrap();
    let corners: Vec<_> = corridor.outline().collect();
    assert!(corners.len() > 100, "{}", corners.len());
    let mut worst = Worst::default();
    for (i, &from) in corners.iter().enumerate() {
        let way = earth.inverse(from, corners[(i + 1) % corners.len()]).unwrap();
        let place = earth.direct(from, way.azimuth1, way.distance * 0.5).unwrap().position;
        worst.add((from_line(&earth, place, &line) - 5_000.0).abs());
    }
    assert!(worst.value() <= 1.0 && worst.value() > 0.3, "{worst:?}");
}

/// The union of the legs' corridors is the corridor, also where the outline overlaps itself.
#[test]
fn legs_one_by_one() {
    let (earth, mut rng) = (earth(), Rng::with_seed(2));
    let mut counts = [0; 2];
    for _ in 0..16 {
        let middle = at(160.0 * rng.f64() - 80.0, 360.0 * rng.f64() - 180.0);
        let near = |rng: &mut Rng| {
            earth
                .direct(middle, 360.0 * rng.f64(), 9_000.0 * rng.f64())
                .unwrap()
                .position
        };
        let line: Vec<_> = (0..rng.usize(1..6)).map(|_| near(&mut rng)).collect();
        let corridor = Corridor::new(&earth, &line, 1_000.0, 1.0).unwrap();
        let legs: Vec<Vec<_>> = (0..line.len().saturating_sub(1).max(1))
            .map(|leg| {
                if line.len() == 1 {
                    corridor.outline().collect()
                } else {
                    corridor.leg(leg).collect()
                }
            })
            .collect();
        assert_eq!(corridor.leg(line.len()).count(), 0);
        for _ in 0..50 {
            let place = near(&mut rng);
            let apart = from_line(&earth, place, &line) - 1_000.0;
            if apart.abs() < 1.5 {
                continue;
            }
            let holds = |ring: &Vec<_>| Fence::new(&earth, &[ring]).side(place) == Side::Inside;
            assert_eq!(legs.iter().any(holds), apart < 0.0, "{line:?} {place:?} {apart}");
            counts[usize::from(apart < 0.0)] += 1;
        }
    }
    assert!(counts.into_iter().all(|count| count > 100), "{counts:?}");
}

#[test]
fn repeated_places_and_none() {
    let earth = earth();
    let here = at(10.0, 20.0);
    let corners = |line: &[LatLon<f64>]| -> Vec<LatLon<f64>> {
        Corridor::new(&earth, line, 100.0, 1.0).unwrap().outline().collect()
    };
    assert!(corners(&[]).is_empty());
    for line in [[here; 1].as_slice(), &[here; 3]] {
        let circle = corners(line);
        assert!(circle.len() > 10);
        assert!(
            circle
                .iter()
                .all(|&corner| (earth.distance(here, corner).unwrap() - 100.0).abs() < 1e-8)
        );
    }
    let (one, two) = (at(10.0, 20.1), at(10.1, 20.1));
    assert_eq!(
        corners(&[here, one, two]),
        corners(&[here, here, one, one, one, two, two])
    );
    // There and back: no panic, no end without one.
    assert!(corners(&[here, one, here]).len() < 1000);
    for (width, tolerance) in [(0.0, 1.0), (1e7, 1.0), (f64::NAN, 1.0)] {
        let refused = Corridor::new(&earth, &[here], width, tolerance).unwrap_err();
        assert!(matches!(refused, InvalidArc::Radius(_)));
    }
    assert_eq!(
        Corridor::new(&earth, &[here], 1.0, 0.0).err(),
        Some(InvalidArc::Tolerance(0.0))
    );
}
