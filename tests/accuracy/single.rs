//! `f32` against `f64`

use terrella::cube::{CubeProjection, FacePoint, Face, Projection};
use terrella::Direction;

/// xorshift
pub struct Rng(pub u64);
impl Rng {
    pub fn next(&mut self) -> u64 { self.0 ^= self.0 << 13; self.0 ^= self.0 >> 7; self.0 ^= self.0 << 17; self.0 }
    pub fn unit(&mut self) -> f64 { (self.next() >> 11) as f64 / (1u64 << 53) as f64 }
    pub fn signed(&mut self) -> f64 { 2.0 * self.unit() - 1.0 }
}

#[test]
fn wide() {
    let n: usize = std::env::var("N").ok().and_then(|s| s.parse().ok()).unwrap_or(200_000);
    for &p in Projection::ALL {
        let mut rng = Rng(88172645463325252);
        let (mut wf, mut wi) = ((0.0f64, [0.0f32; 3]), (0.0f64, [0.0f32; 2]));
        for k in 0..n {
            let near = |r: &mut Rng| match r.next() % 8 { 0 => 1.0, 1 => 1.0 - 1e-4 * r.unit(), 2 => 1e-3 * r.signed(), 3 => 0.0, _ => r.signed() };
            let (a, b) = (near(&mut rng), near(&mut rng));
            let b = if rng.next() % 8 == 0 { a * (1.0 + 1e-5 * rng.signed()) } else { b };
            let face = Face::from_index((k % 6) as u8).unwrap();
            let [x, y, z] = face.to_earth([a as f32, b as f32, 1.0f32]);
            let d = Direction::new(x, y, z).unwrap();
            let [x, y, z] = d.to_array();
            let dd = Direction::new(x as f64, y as f64, z as f64).unwrap();
            let q = p.project(d);
            let qq = p.project(dd);
            if q.face() == qq.face() {
                let e = (q.x() as f64 - qq.x()).abs().max((q.y() as f64 - qq.y()).abs());
                if e > wf.0 { wf = (e, d.to_array()) }
            }
            let (a, b) = (a.clamp(-1.0, 1.0) as f32, b.clamp(-1.0, 1.0) as f32);
            let d = p.unproject(FacePoint::new(face, a, b).unwrap()).to_array();
            let dd = p.unproject(FacePoint::new(face, a as f64, b as f64).unwrap()).to_array();
            let e = d.iter().zip(dd).map(|(a, b)| (*a as f64 - b).powi(2)).sum::<f64>().sqrt();
            if e > wi.0 { wi = (e, [a, b]) }
        }
        println!("{:18} forward {:.2e} {:?}  inverse {:.2e} {:?}", p.name(), wf.0, wf.1, wi.0, wi.1);
    }
}
