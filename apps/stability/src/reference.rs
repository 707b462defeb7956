//! Latitude, longitude and height of a point with twice the digits of `f64`.

use terrella::{Geodetic, Real};

use testkit::double::{Double, of, sin_cos_degrees};

/// The semi-major axis of WGS84 in metres.
pub const A: f64 = 6_378_137.0;

/// The nearest point of the ellipsoid: latitude and longitude by sine and cosine, the height in metres.
pub struct Reference {
    lat: [Double; 2],
    lon: [Double; 2],
    height: Double,
}

impl Reference {
    /// Of a point off the axis and north of the equator, where the nearest point is one.
    ///
    /// It is where (aρ/(s + a² − b²))² + (bz/s)² = 1 for a positive s. Newton's steps from below the solution do not pass it.
    pub fn new([x, y, z]: [f64; 3]) -> Self {
        let (one, two) = (of(1.0), of(2.0));
        let a = of(A);
        let f = of(1e9) / of(298_257_223_563.0);
        let b = a * (one - f);
        let e2 = f * (two - f);
        let gap = a * a * e2;
        let [x, y, z] = [x, y, z].map(of);
        let rho = (x * x + y * y).sqrt();
        let step = |s: Double| {
            let (u, v) = (a * rho / (s + gap), b * z / s);
            let (uu, vv) = (u * u, v * v);
            s + (uu + vv - one) / (uu / (s + gap) + vv / s) / two
        };
        let (polar, equatorial) = (b * z, a * rho - gap);
        let mut s = if polar > equatorial { polar } else { equatorial };
        for _ in 0..100 {
            let next = step(s);
            let done = (next - s).abs() <= s * of(1e-30);
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
        let turn = |[sin, cos]: [Double; 2], degrees: f64| {
            let (s, c) = sin_cos_degrees(degrees);
            (s * cos - c * sin).high
        };
        let north = turn(self.lat, found.lat().into());
        let east = turn(self.lon, found.lon().into()) * self.lat[1].high;
        let up = of(found.height().into()) - self.height;
        [A * north.hypot(east), up.high.abs()]
    }
}
