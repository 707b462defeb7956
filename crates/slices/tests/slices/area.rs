//! Areas of rings.

use terrella::batch::{self, InvalidBatch, area::InvalidRing};
use terrella::geodesic::{Area, PlanarArea};
use terrella::scene::AnyArea;
use terrella::{Ellipsoid, LatLon};

use super::{Scalar, bits};

/// Rings of 0 to 300 corners, about places and anywhere.
fn every_ring<T: Scalar>() {
    let mut rng = fastrand::Rng::with_seed(43);
    let mut offsets = vec![0_i32];
    let mut corners = [const { Vec::<T>::new() }; 2];
    for count in [0, 1, 2, 3, 4, 15, 16, 17, 18, 64, 65, 100, 256, 257, 258, 300] {
        let middle = [89.9 * (2.0 * rng.f64() - 1.0), 360.0 * rng.f64()];
        let size = [0.01, 1.0, 30.0][rng.usize(0..3)];
        for _ in 0..count {
            let lat = (middle[0] + size * (rng.f64() - 0.5)).clamp(-90.0, 90.0);
            corners[0].push(T::of(lat));
            corners[1].push(T::of(middle[1] + size * (rng.f64() - 0.5)));
        }
        offsets.push(corners[0].len() as i32);
    }
    // One that is too long, one backwards, one that starts below 0; then a good one.
    offsets.extend([i32::MAX, 30, 10, -1, 0, 4]);
    let rings = offsets.len() - 1;
    let [lat, lon] = &mut corners;
    let bad = [0, 3, 12, 290].map(|i| offsets[12] as usize + i);
    for sabotaged in [false, true] {
        if sabotaged {
            for &index in &bad {
                lat[index] = T::of(f64::NAN);
            }
        }
        let area = Area::new(Ellipsoid::<T>::WGS84).unwrap();
        let planes = [
            PlanarArea::new(Ellipsoid::<T>::WGS84).unwrap(),
            PlanarArea::local(Ellipsoid::<T>::WGS84, LatLon::new(T::of(-3.0), T::ZERO).unwrap()).unwrap(),
        ];
        let ring = |i: usize| {
            let range = usize::try_from(offsets[i]).ok()?..usize::try_from(offsets[i + 1]).ok()?;
            let (lat, lon) = (lat.get(range.clone())?, lon.get(range)?);
            let corners = lat.iter().zip(lon).map(|(&lat, &lon)| LatLon::new(lat, lon));
            corners.collect::<Result<Vec<_>, _>>().ok()
        };
        let refused: Vec<_> = (0..rings).filter(|&i| ring(i).is_none()).collect();
        let check = |result: Result<(), InvalidBatch<InvalidRing<T>>>| match result {
            Err(InvalidBatch::Elements { count, first, why }) => {
                assert_eq!((count, first), (refused.len(), refused[0]));
                let sabotaged = matches!(why, InvalidRing::Corner { index, .. } if index == bad[0]);
                assert!(
                    sabotaged
                        || why
                            == InvalidRing::Offsets {
                                start: offsets[first] as usize,
                                end: i32::MAX as usize
                            }
                );
            }
            other => panic!("{other:?}"),
        };
        let nan = T::of(f64::NAN);
        let [mut areas, mut perimeters] = [(); 2].map(|()| vec![T::of(7.0); rings]);
        check(batch::area::polygons(
            &area,
            &offsets,
            [lat, lon],
            &mut areas,
            &mut perimeters,
        ));
        for i in 0..rings {
            let [found, length] = ring(i).map_or([nan; 2], |corners| {
                let mut polygon = area.polygon();
                corners.into_iter().for_each(|corner| polygon.add(corner));
                [polygon.area(), polygon.perimeter()]
            });
            assert_eq!(bits(&[areas[i], perimeters[i]]), bits(&[found, length]), "ring {i}");
        }
        let solvers = [
            AnyArea::Ellipsoid(area),
            AnyArea::Plane(planes[0]),
            AnyArea::Plane(planes[1]),
        ];
        for solver in solvers {
            check(batch::scene::areas(&solver, &offsets, [lat, lon], &mut areas));
            for (i, area) in areas.iter().enumerate() {
                let found = ring(i).map_or(nan, |corners| solver.area(corners));
                assert_eq!(bits(&[*area]), bits(&[found]), "ring {i}");
            }
        }
    }
    let plane = PlanarArea::new(Ellipsoid::<T>::WGS84).unwrap();
    let mut areas = vec![T::ZERO; 3];
    let refused = batch::area::fields(&plane, &[0_usize, 1, 2], [&lat[..2], &lon[..2]], &mut areas);
    assert_eq!(refused, Err(InvalidBatch::Lengths { first: 2, other: 3 }));
    let refused = batch::area::fields(&plane, &[0_usize, 1], [&lat[..2], &lon[..1]], &mut areas[..1]);
    assert_eq!(refused, Err(InvalidBatch::Lengths { first: 2, other: 1 }));
    assert_eq!(batch::area::fields::<T, u32>(&plane, &[], [&[], &[]], &mut []), Ok(()));
}

#[test]
fn rings_are_the_same_bits() {
    every_ring::<f64>();
    every_ring::<f32>();
}
