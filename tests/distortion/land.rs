//! Surveys of chosen places only.

use terrella::cube::{Face, Projection};
use terrella::distortion::Survey;
use terrella::{Ellipsoid, Shift};

use crate::sphere::{at, on, unit_sphere};

#[test]
fn a_survey_of_everything_is_the_survey() {
    for &projection in Projection::ALL {
        let ground = on(Ellipsoid::<f64>::WGS84, Shift::Authalic, projection);
        let (mut all, mut kept) = (Survey::new(ground.fair_texel()), Survey::new(ground.fair_texel()));
        for n in [7, 140] {
            all.face(&ground, Face::Top, n);
            kept.face_where(&ground, Face::Top, n, |_| true);
            assert_eq!(all, kept, "{projection}");
        }
    }
}

#[test]
fn what_is_kept_and_the_rest_are_the_whole() {
    for &projection in Projection::ALL {
        for &shift in Shift::ALL {
            let ground = on(Ellipsoid::<f64>::WGS84, shift, projection);
            let [mut all, mut north, mut south] = [Survey::new(ground.fair_texel()); 3];
            for face in Face::ALL {
                all.face(&ground, face, 20);
                north.face_where(&ground, face, 20, |normal| normal.to_lat_lon().lat() > 40.0);
                south.face_where(&ground, face, 20, |normal| normal.to_lat_lon().lat() <= 40.0);
            }
            let count = |survey: &Survey<f64>| survey.area().count() + survey.skipped();
            assert!(count(&north) > 300 && count(&south) > 1000);
            assert_eq!(count(&all), count(&north) + count(&south));
            north.merge(&south);
            assert_eq!(
                (all.scale().min(), all.scale().max()),
                (north.scale().min(), north.scale().max())
            );
            assert_eq!(all.isotropy().max_at().is_some(), north.isotropy().max_at().is_some());
            assert!((all.area().mean() - north.area().mean()).abs() < 1e-13);
        }
    }
}

#[test]
fn the_latitude_is_geodetic() {
    for &shift in Shift::ALL {
        let ground = on(Ellipsoid::<f64>::WGS84, shift, Projection::Balanced);
        for face in Face::ALL {
            let mut survey = Survey::new(ground.fair_texel());
            let mut seen = Vec::new();
            survey.face_where(&ground, face, 9, |normal| {
                seen.push(normal);
                false
            });
            assert_eq!((survey.area().count(), survey.skipped(), seen.len()), (0, 0, 81));
            for (i, normal) in (0..81).zip(seen) {
                let place = |i: u32| f64::from(i) * (2.0 / 9.0) - 1.0;
                let expected = ground.map().unproject(at(face, place(i % 9), place(i / 9)));
                assert!((normal.to_lat_lon().lat() - expected.lat()).abs() < 1e-13, "{shift}");
                let apart = (normal.to_lat_lon().lon() - expected.lon()).abs() % 360.0;
                assert!(
                    testkit::minimum(apart, 360.0 - apart) * normal.to_lat_lon().lat().to_radians().cos() < 1e-13,
                    "{shift}"
                );
            }
        }
    }
}

#[test]
fn equal_areas_stay_equal_by_the_authalic_latitude_alone() {
    let ratio = |shift| {
        let ground = on(Ellipsoid::<f64>::WGS84, shift, Projection::Vertex);
        let mut survey = Survey::new(ground.fair_texel());
        for face in Face::ALL {
            survey.face_where(&ground, face, 50, |normal| normal.y() > 0.3);
        }
        survey.scale().ratio()
    };
    for &shift in Shift::ALL {
        let off = ratio(shift) - 1.0;
        assert_eq!(off < 1e-12, shift == Shift::Authalic, "{shift}: {off:e}");
    }
    let mut sphere = Survey::new(1.0);
    sphere.face_where(&unit_sphere::<f64, _>(Projection::Vertex), Face::Right, 50, |normal| {
        normal.y() > 0.3
    });
    assert!(sphere.scale().ratio() < 1.0 + 1e-13);
}
