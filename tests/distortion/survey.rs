//! Surveys against counting one by one, for all sizes; faces that differ from each other; short scalars.

use terrella::cube::{Face, Healpix, Projection, Quadrilateralized};
use terrella::distortion::{Statistic, Survey};
use terrella::{Ellipsoid, Shift};

use crate::sphere::{at, on, unit_sphere};

#[test]
fn blocks_count_as_single_places_do() {
    for &projection in Projection::ALL {
        let ground = on(Ellipsoid::<f64>::WGS84, Shift::Authalic, projection);
        for n in [1, 7, 32, 65, 100] {
            let reference = ground.central_texel();
            let mut blocks = Survey::new(reference);
            blocks.face(&ground, Face::Top, n);
            let mut single = Survey::new(reference);
            let mut skipped = 0;
            for i in 0..n * n {
                let place = |i: u32| f64::from(i) * (2.0 / f64::from(n)) - 1.0;
                let point = at(Face::Top, place(i % n), place(i / n));
                match ground.jacobian(point) {
                    Ok(jacobian) => single.include(point, &jacobian),
                    Err(_) => skipped += 1,
                }
            }
            assert_eq!(blocks.skipped(), skipped);
            for (a, b) in [
                (blocks.aspect(), single.aspect()),
                (blocks.sides(), single.sides()),
                (blocks.area(), single.area()),
                (blocks.deformation(), single.deformation()),
            ] {
                assert_eq!(a.count(), b.count());
                if b.count() > 0 {
                    assert_eq!((a.min(), a.max()), (b.min(), b.max()), "{projection}, {n}");
                    assert_eq!((a.min_at(), a.max_at()), (b.min_at(), b.max_at()), "{projection}, {n}");
                    assert!((a.mean() - b.mean()).abs() <= 1e-13 * b.mean().abs());
                    assert!((a.rmsd() - b.rmsd()).abs() <= 1e-13);
                }
            }
        }
    }
}

#[test]
fn faces_that_differ_are_all_seen() {
    let ground = unit_sphere::<f64, _>(Healpix);
    let mut whole = Survey::new(ground.central_texel());
    whole.sphere(&ground, 101);
    let mut parts = Survey::new(ground.central_texel());
    for face in Face::ALL {
        let mut part = Survey::new(ground.central_texel());
        part.face(&ground, face, 101);
        parts.merge(&part);
    }
    assert_eq!(whole.aspect().count(), 6 * 101 * 101);
    assert_eq!(
        (whole.aspect().min(), whole.aspect().max()),
        (parts.aspect().min(), parts.aspect().max())
    );
    assert!((whole.aspect().mean() - parts.aspect().mean()).abs() < 1e-14);
    assert!((whole.deformation().rmsd() - parts.deformation().rmsd()).abs() < 1e-12);
    assert!(whole.aspect().max_at().unwrap().face().is_polar());
    let mut side = Survey::new(ground.central_texel());
    side.face(&ground, Face::Front, 101);
    assert!(side.aspect().ratio() < 1.81 && whole.aspect().ratio() > 3.2);
}

#[test]
fn singular_places_are_counted() {
    let ground = unit_sphere::<f64, _>(Quadrilateralized);
    let mut survey = Survey::new(ground.central_texel());
    survey.sphere(&ground, 10);
    assert_eq!((survey.skipped(), survey.area().count()), (6, 6 * 99));
}

#[test]
fn millions_of_f32_add_up() {
    let mut sum = Statistic::about(1.0_f32);
    let point = at(Face::Front, 0.0, 0.0);
    for _ in 0..20_000_000 {
        sum.include(point, 1.1);
    }
    assert_eq!(sum.count(), 20_000_000);
    assert!((sum.mean() - 1.1).abs() < 1e-6 && (sum.rmsd() - 0.1).abs() < 1e-6);
}

#[test]
fn nothing_has_no_extremes() {
    let none = Statistic::about(1.0_f64);
    assert!(none.min().is_nan() && none.max().is_nan() && none.mean().is_nan() && none.rmsd().is_nan());
    assert!(none.min_at().is_none() && none.max_at().is_none());
    let mut survey = Survey::new(1.0);
    survey.face(&unit_sphere::<f64, _>(Quadrilateralized), Face::Front, 0);
    assert_eq!(survey.aspect().count(), 0);
}

#[test]
#[ignore = "a measurement: run it in release, alone"]
fn how_long_16_million_places_take() {
    for &projection in Projection::ALL {
        for (what, ground) in [
            ("sphere", unit_sphere::<f64, _>(projection)),
            ("WGS84, authalic", on(Ellipsoid::WGS84, Shift::Authalic, projection)),
        ] {
            let start = std::time::Instant::now();
            let mut survey = Survey::new(ground.central_texel());
            survey.face(&ground, Face::Front, 4000);
            println!("{projection}, {what}: {:.2} s", start.elapsed().as_secs_f64());
            assert_eq!(survey.aspect().count() + survey.skipped(), 16_000_000);
        }
    }
}
