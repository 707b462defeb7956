//! Areas of rings of geodesics: special edges, many small rings, other ellipsoids.

use terrella::batch::{self, InvalidBatch, area::InvalidRing};
use terrella::geodesic::Area;
use terrella::{Ellipsoid, LatLon};

use super::{Scalar, bits};

/// Rings of 0 to 9 corners that are at poles, on the equator, on common meridians and parallels, repeated, and
/// nearly antipodal.
fn rings<T: Scalar>(seed: u64, count: usize) -> (Vec<u32>, [Vec<T>; 2]) {
    let mut rng = fastrand::Rng::with_seed(seed);
    let (mut offsets, mut corners) = (vec![0], [const { Vec::<T>::new() }; 2]);
    let lats = [90.0, -90.0, 0.0, -0.0, 45.0, -45.0, 45.000_001, 1e-9];
    let lons = [180.0, -180.0, 0.0, -0.0, 0.5, -0.5, 90.0, 179.5, 190.0, -359.0, 1e-9];
    for _ in 0..count {
        let mut last = [T::ZERO; 2];
        for _ in 0..rng.usize(0..10) {
            let anywhere = [180.0 * rng.f64() - 90.0, 360.0 * rng.f64() - 180.0].map(T::of);
            let special = [rng.choice(lats).unwrap(), rng.choice(lons).unwrap()].map(T::of);
            let mixed = if rng.bool() {
                [last[0], special[1]]
            } else {
                [special[0], last[1]]
            };
            let near = [last[0] * T::of(0.999), last[1] + T::of(10f64.powf(-9.0 * rng.f64()))];
            last = match rng.u8(0..8) {
                0 | 1 => special,
                2 => mixed,
                3 => last,
                4 => [-last[0], last[1] + T::of(180.0)],
                5 | 6 => near,
                _ => anywhere,
            };
            corners[0].push(last[0]);
            corners[1].push(last[1]);
        }
        offsets.push(u32::try_from(corners[0].len()).unwrap());
    }
    (offsets, corners)
}

#[test]
fn rings_of_special_edges_are_the_same_bits() {
    fn both<T: Scalar>(f: f64) {
        let area = Area::new(Ellipsoid::new(T::of(6.4e6), T::of(f)).unwrap()).unwrap();
        for (seed, count) in [(1, 1), (2, 2), (3, 30), (4, 700)] {
            let (offsets, [mut lat, lon]) = rings::<T>(seed, count);
            for bad in [false, true] {
                if bad {
                    for index in [40, 41, 255, 256, 1000] {
                        if let Some(lat) = lat.get_mut(index) {
                            *lat = T::of(f64::NAN);
                        }
                    }
                }
                let (mut areas, mut perimeters) = (vec![T::of(7.0); count], vec![T::of(7.0); count]);
                let outcome = batch::area::polygons(&area, &offsets, [&lat, &lon], &mut areas, &mut perimeters);
                let (mut refused, mut count) = (None, 0);
                for (ring, window) in offsets.windows(2).enumerate() {
                    let mut polygon = area.polygon();
                    let mut wrong = None;
                    for index in window[0] as usize..window[1] as usize {
                        match LatLon::new(lat[index], lon[index]) {
                            Ok(corner) => polygon.add(corner),
                            Err(why) => {
                                wrong.get_or_insert(InvalidRing::Corner { index, why });
                            }
                        }
                    }
                    let mut expected = [polygon.area(), polygon.perimeter()];
                    if let Some(why) = wrong {
                        count += 1;
                        refused.get_or_insert((ring, why));
                        expected = [T::of(f64::NAN); 2];
                    }
                    let found = [areas[ring], perimeters[ring]];
                    assert_eq!(bits(&found), bits(&expected), "f = {f}, ring {ring}: {window:?}");
                }
                let expected = match refused {
                    Some((first, why)) => Err(InvalidBatch::Elements { count, first, why }),
                    None => Ok(()),
                };
                assert_eq!(format!("{outcome:?}"), format!("{expected:?}"));
            }
        }
    }
    for f in [1.0 / 298.257, 0.0, 1.0 / 160.0, -1.0 / 298.0, -1e-9, 0.1, -0.1] {
        both::<f64>(f);
        both::<f32>(f);
    }
}
