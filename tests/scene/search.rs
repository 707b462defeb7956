use std::f64::consts::PI;

use terrella::geodesic::{Andoyer, Flat, Gauss, Geodesic, GreatCircle, Karney};
use terrella::{Ellipsoid, LatLon};
use testkit::maximum;

use crate::draw::turned;

/// The largest errors of distance and azimuths of lines from a latitude, over all azimuths; and the farthest latitude that they reach.
fn largest(method: &impl Geodesic<f64>, karney: &Karney<f64>, lat: f64, distance: f64) -> [f64; 3] {
    (0..180).fold([0.0, 0.0, lat], |[off, turn, steepest], step| {
        let from = LatLon::new(lat, 0.0).unwrap();
        let to = karney
            .direct(from, 2.0 * (f64::from(step) + 0.37), distance)
            .unwrap()
            .position;
        let (truth, way) = (karney.inverse(from, to).unwrap(), method.inverse(from, to).unwrap());
        [
            maximum(off, (truth.distance - way.distance).abs()),
            maximum(
                maximum(turn, turned(truth.azimuth1, way.azimuth1)),
                turned(truth.azimuth2, way.azimuth2),
            ),
            maximum(steepest, to.lat()),
        ]
    })
}

/// Where the factors of the formulas are from: what a search finds, over the form without its margin. The margins are 1.25 and 1.2.
///
/// `cargo test --release --test scene factors -- --nocapture` prints it.
#[test]
fn factors_of_the_formulas() {
    let mut worst = [0.0_f64; 7];
    for f in [0.0, 1.0 / 298.257_223_563, 0.01] {
        let ellipsoid = Ellipsoid::new(6_378_137.0, f).unwrap();
        let karney = Karney::new(ellipsoid).unwrap();
        let flat = Flat::new(ellipsoid).unwrap();
        let gauss = Gauss::new(ellipsoid).unwrap();
        let r = ellipsoid.b() * (1.0 - f);
        for lat in [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0] {
            for s in [1e4, 3e4, 1e5, 3e5, 1e6, 3e6] {
                let [off, turn, steepest] = largest(&flat, &karney, lat, s);
                let tan = steepest.to_radians().tan();
                if s < 0.5 * r && s * tan < 0.5 * r {
                    let ratios = [
                        off / (s.powi(3) / (24.0 * r * r) * (0.26 + 1.13 * tan * tan)),
                        turn / ((s / r).powi(2) * (0.033 + 0.027 * tan * tan)),
                    ];
                    println!("flat, f {f:.4}, latitude {lat}, {s:e} m: {ratios:.3?}");
                    for k in 0..2 {
                        worst[k] = maximum(worst[k], ratios[k]);
                    }
                    let [off, turn, _] = largest(&gauss, &karney, lat, s);
                    let (u, tan2) = (s / r, tan * tan);
                    // Of distances alone: Bowring's direct problem is in the formula of `bounds` instead of 0.63 f².
                    let steep = maximum(0.0009 + 0.0037 * tan2, 0.000_53 * tan2 * tan2);
                    let distance = s * u * u * (0.63 * f * f + u * u * steep);
                    let azimuth = u * u * (0.24 * f * f + 0.045 * f * u + u * u * (0.0007 + 0.000_55 * tan2 * tan2));
                    // Less what the truth is off.
                    let ratios = [(off - 1.2e-8) / distance, (turn - 1.5e-8 / s) / azimuth];
                    println!("gauss, f {f:.4}, latitude {lat}, {s:e} m: {ratios:.3?}");
                    for k in 0..2 {
                        worst[5 + k] = maximum(worst[5 + k], ratios[k]);
                    }
                }
            }
        }
        if f == 0.0 {
            continue;
        }
        let (andoyer, sphere) = (
            Andoyer::new(ellipsoid).unwrap(),
            GreatCircle::new(ellipsoid.a()).unwrap(),
        );
        for degrees in [
            1.0, 10.0, 30.0, 60.0, 90.0, 105.0, 120.0, 135.0, 150.0, 160.0, 170.0, 175.0, 177.0, 178.0,
        ] {
            let sigma = f64::to_radians(degrees);
            let (x, short) = (maximum(2.0 / PI * sigma - 1.0, 0.0), PI - sigma);
            for lat in [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0] {
                let s = sigma * ellipsoid.b();
                let [off, turn, _] = largest(&andoyer, &karney, lat, s);
                let [_, turn_on_sphere, _] = largest(&sphere, &karney, lat, s);
                // A line from the south leads over flatter latitudes.
                let ratios = [
                    off / (ellipsoid.a() * f * f * (sigma / 8.0 + 1.08 * x / short)),
                    turn / (f * f * (0.33 + 2.9 * (sigma / (PI * short)).powi(2))),
                    turn_on_sphere / (f * (1.0 + 1.45 * x * x / short)),
                ];
                println!("andoyer and sphere, f {f:.4}, {degrees}°, latitude {lat}: {ratios:.3?}");
                for k in 0..3 {
                    worst[2 + k] = maximum(worst[2 + k], ratios[k]);
                }
            }
        }
    }
    println!("{worst:.3?}");
    let margins = [1.25, 1.25, 1.2, 1.2, 1.2, 1.25, 1.25];
    for (found, margin) in worst.into_iter().zip(margins) {
        assert!(found < margin && margin < 1.35 * found, "{worst:?}");
    }
}
