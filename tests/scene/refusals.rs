use fastrand::Rng;
use terrella::Ellipsoid;
use terrella::cube::Projection;
use terrella::geodesic::Method;
use terrella::scene::{Order, Scene, SceneError, Surface};

fn earth() -> Scene {
    Scene::new(Ellipsoid::WGS84)
}

/// The same of every question.
fn refused(scene: Scene) -> SceneError {
    let error = scene.distances::<f64>().unwrap_err();
    // As text, for the sake of NaN.
    let same = |other: SceneError| assert_eq!(format!("{other:?}"), format!("{error:?}"));
    same(scene.distances::<f32>().unwrap_err());
    same(scene.positions::<f64>().unwrap_err());
    same(scene.geodetics::<f64>().unwrap_err());
    same(scene.geodetics_by::<f32>(Order::Full).unwrap_err());
    same(scene.areas::<f64>().unwrap_err());
    same(scene.areas_by::<f32>(Surface::Plane).unwrap_err());
    same(scene.distances_by::<f64>(Method::Karney).unwrap_err());
    same(scene.figure().unwrap_err());
    same(scene.tiles(Projection::Adjusted).unwrap_err());
    same(scene.scalar().unwrap_err());
    error
}

#[test]
fn what_is_no_scene_is_refused_with_its_value() {
    let flat = Ellipsoid::new(6.4e6, 0.011).unwrap();
    assert_eq!(refused(Scene::new(flat)), SceneError::Flattening(0.011));
    let long = Ellipsoid::new(6.4e6, -0.001).unwrap();
    assert_eq!(refused(Scene::new(long)), SceneError::Flattening(-0.001));
    assert_eq!(
        refused(earth().latitudes(10.0, 5.0)),
        SceneError::Latitudes([10.0, 5.0])
    );
    assert_eq!(
        refused(earth().latitudes(0.0, 91.0)),
        SceneError::Latitudes([0.0, 91.0])
    );
    assert_eq!(refused(earth().up_to(-1.0)), SceneError::Distances([0.0, -1.0]));
    assert_eq!(refused(earth().between(2.0, 1.0)), SceneError::Distances([2.0, 1.0]));
    assert_eq!(refused(earth().heights(1.0, 0.0)), SceneError::Heights([1.0, 0.0]));
    assert_eq!(refused(earth().heights(-7e6, 0.0)), SceneError::Heights([-7e6, 0.0]));
    assert_eq!(refused(earth().within(-1.0)), SceneError::Tolerance(-1.0));
    assert_eq!(refused(earth().azimuths(-1.0)), SceneError::Tolerance(-1.0));
    let around = Scene::around(Ellipsoid::WGS84, 100.0, 1e3);
    assert!(matches!(
        refused(around.latitudes(95.0, 100.0)),
        SceneError::Latitudes(_)
    ));
}

#[test]
fn no_number_is_refused() {
    for scene in [
        earth().latitudes(f64::NAN, 0.0),
        earth().latitudes(0.0, f64::NAN),
        earth().up_to(f64::NAN),
        earth().up_to(f64::INFINITY),
        earth().between(f64::NAN, 1.0),
        earth().heights(f64::NAN, 0.0),
        earth().heights(0.0, f64::INFINITY),
        earth().within(f64::NAN),
        earth().azimuths(f64::NAN),
        Scene::around(Ellipsoid::WGS84, f64::NAN, 1e3),
        Scene::around(Ellipsoid::WGS84, 0.0, f64::NAN),
    ] {
        refused(scene);
    }
}

#[test]
fn what_is_out_of_reach_is_told_with_what_is_not() {
    let SceneError::OutOfReach(reached) = earth().within(1e-12).distances::<f64>().unwrap_err() else {
        panic!()
    };
    assert_eq!(reached.distance, 7e-9);
    let SceneError::OutOfReach(reached) = earth().up_to(1e3).within(0.01).distances::<f32>().unwrap_err() else {
        panic!()
    };
    // Degrees in f32.
    assert!((1.0..3.0).contains(&reached.distance), "{reached:?}");
    // Azimuths between places that may be any distance apart.
    assert!(earth().within(1.0).azimuths(1e-3).distances::<f64>().is_err());
    assert!(
        earth()
            .between(1e3, 1e6)
            .within(1e3)
            .azimuths(1e-3)
            .distances::<f64>()
            .is_ok()
    );
}

/// Any bits: an answer or a refusal, and an answer keeps the tolerances.
#[test]
fn any_bits_are_answered() {
    let mut rng = Rng::with_seed(5);
    let mut answers = 0;
    for _ in 0..200_000 {
        let mut any = || match rng.u8(..3) {
            0 => f64::from_bits(rng.u64(..)),
            1 => (rng.f64() - 0.3) * 10_f64.powi(rng.i32(-3..9)),
            _ => [0.0, -0.0, 90.0, -90.0, 1e-300, f64::MAX][rng.usize(..6)],
        };
        let mut scene = match Ellipsoid::new(any(), 0.01 * any()) {
            Ok(ellipsoid) => Scene::new(ellipsoid),
            Err(_) => earth(),
        };
        for _ in 0..3 {
            scene = match any().to_bits() % 8 {
                0 => scene.latitudes(any(), any()),
                1 => scene.up_to(any()),
                2 => scene.between(any(), any()),
                3 => scene.heights(any(), any()),
                4 => scene.local(),
                5 => scene.azimuths(any()),
                _ => scene.within(any().abs()),
            };
        }
        if let Ok(way) = scene.distances::<f64>() {
            answers += 1;
            assert!(way.bound().distance >= 0.0);
            let _ = way.solver();
            assert!(scene.within(way.bound().distance).distances::<f64>().is_ok());
        }
        if let Ok(way) = scene.distances::<f32>() {
            assert!(way.bound().distance >= 0.0 && way.bound().azimuth >= 0.0);
        }
        if let Ok(positions) = scene.positions::<f32>() {
            assert!(positions.bound() >= 0.0);
        }
        if let Ok(geodetics) = scene.geodetics::<f32>() {
            assert!(geodetics.bound() >= 0.0);
            let _ = geodetics.solver();
        }
        if let Ok(areas) = scene.areas::<f32>() {
            assert!(areas.bound() >= 0.0);
            let _ = areas.solver();
        }
        if let Ok(figure) = scene.figure() {
            assert!(figure.bound() >= 0.0);
        }
        for &projection in Projection::ALL {
            let _ = scene.tiles(projection);
        }
    }
    assert!(answers > 1000, "{answers}");
}
