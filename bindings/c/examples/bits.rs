//! What tests/bits.c prints, by the crate itself.

use terrella::cube::{CubeMap, Vertex};
use terrella::geodesic::{Geodesic, Karney};
use terrella::route::Legs;
use terrella::{Ellipsoid, Geodetic, LatLon, Shift};

/// FNV-1a.
struct Hash(u64);

impl Hash {
    fn add(&mut self, word: u64) {
        for byte in word.to_le_bytes() {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x100_0000_01b3);
        }
    }

    fn all(&mut self, numbers: impl IntoIterator<Item = f64>) {
        numbers.into_iter().for_each(|number| self.add(number.to_bits()));
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut state = 1_u64;
    let mut draw = |from: f64, to: f64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        from + (to - from) * (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let mut hash = Hash(0xcbf2_9ce4_8422_2325);
    let wgs84 = Ellipsoid::<f64>::WGS84;
    let (earth, earth_f32) = (Karney::new(wgs84)?, Karney::new(Ellipsoid::<f32>::WGS84)?);
    let cube = CubeMap::new(wgs84, Shift::Authalic, Vertex)?;
    for _ in 0..200 {
        let [lat1, lon1, lat2, lon2] = [90.0, 180.0, 90.0, 180.0].map(|most| draw(-most, most));
        let (from, to) = (LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?);
        let line = earth.inverse(from, to)?;
        hash.all([line.distance, line.azimuth1, line.azimuth2]);
        let end = earth.direct(from, line.azimuth1, line.distance)?;
        hash.all([end.position.lat(), end.position.lon(), end.azimuth]);
        hash.all(wgs84.to_ecef(Geodetic::new(from, lat2)?).to_array());
        let point = cube.project(from);
        hash.add(point.face().index().into());
        hash.all([point.x(), point.y()]);
        let closest = earth.closest(LatLon::new(10.0, 20.0)?, from, to);
        hash.all([closest.distance, closest.along]);
        let single = |lat: f64, lon: f64| LatLon::new(lat as f32, lon as f32);
        let line = earth_f32.inverse(single(lat1, lon1)?, single(lat2, lon2)?)?;
        hash.add(line.distance.to_bits().into());
        hash.add(line.azimuth1.to_bits().into());
    }
    println!("{:016x}", hash.0);
    Ok(())
}
