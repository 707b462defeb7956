//! Latitude, longitude and height of a point with twice the digits of `f64`.

use terrella::{Geodetic, Real};
use twofloat::TwoFloat;

/// The semi-major axis of WGS84 in metres.
pub const A: f64 = 6_378_137.0;

/// The nearest point of the ellipsoid: latitude and longitude by sine and cosine, the height in metres.
pub struct Reference {
    lat: [TwoFloat; 2],
    lon: [TwoFloat; 2],
    height: TwoFloat,
}

impl Reference {
    /// Of a point off the axis and north of the equator, where the nearest point is one.
    ///
    /// It is where (aρ/(s + a² − b²))² + (bz/s)² = 1 for a positive s. Newton's steps from below the solution do not pass it.
    pub fn new([x, y, z]: [f64; 3]) -> Self {
        let one = TwoFloat::from(1.0);
        let a = TwoFloat::from(A);
        let f = TwoFloat::from(1e9) / TwoFloat::from(298_257_223_563.0);
        let b = a * (one - f);
        let e2 = f * (TwoFloat::from(2.0) - f);
        let gap = a * a * e2;
        let [x, y, z] = [x, y, z].map(TwoFloat::from);
        let rho = (x * x + y * y).sqrt();
        let step = |s: TwoFloat| {
            let (u, v) = (a * rho / (s + gap), b * z / s);
            let (uu, vv) = (u * u, v * v);
            s + (uu + vv - one) / (uu / (s + gap) + vv / s) / TwoFloat::from(2.0)
        };
        let mut s = (b * z).max(a * rho - gap);
        for _ in 0..100 {
            let next = step(s);
            let done = (next - s).abs() <= s * TwoFloat::from(1e-30);
            s = next;
            if done {
                break;
            }
        }
        let (sin, cos) = (z / s, rho / (s + gap));
        let length = (sin * sin + cos * cos).sqrt();
        let (sin, cos) = (sin / length, cos / length);
        Self {
            lat: [sin, cos],
            lon: [y / rho, x / rho],
            height: rho * cos + z * sin - a * (one - e2 * sin * sin).sqrt(),
        }
    }

    /// How far off an answer is, in metres: its place on the ground, and its height.
    pub fn errors<T: Real + Into<f64>>(&self, found: Geodetic<T>) -> [f64; 2] {
        let turn = |[sin, cos]: [TwoFloat; 2], degrees: f64| {
            let (s, c) = TwoFloat::from(degrees).to_radians().sin_cos();
            f64::from(s * cos - c * sin)
        };
        let north = turn(self.lat, found.lat().into());
        let east = turn(self.lon, found.lon().into()) * f64::from(self.lat[1]);
        let up = TwoFloat::from(found.height().into()) - self.height;
        [A * north.hypot(east), f64::from(up).abs()]
    }
}
