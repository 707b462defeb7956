//! Every `f32`: functions of one number over all that they take, against `f64`.
//!
//! `cargo test --release --test every_f32 -- --ignored --nocapture`: some minutes on two cores; it says the worst error and where.
//! The platform's `f64` functions are the reference; for latitudes, this crate's in `f64`, which are held to truth of 25 digits.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)] // tests

use std::f64::consts::{FRAC_PI_2, PI};

use rayon::prelude::*;
use terrella::cube::{CubeProjection, Face, Quadrilateralized, Vertex};
use terrella::latitude::Conversion;
use terrella::{Ellipsoid, Latitude, Real, math};

#[allow(dead_code)] // shared
#[path = "accuracy/table.rs"]
mod table;

/// The largest error, and where.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    ulp: f64,
    at: f32,
}

impl Worst {
    fn or(self, other: Self) -> Self {
        // A NaN is worse than any number.
        if other.ulp > self.ulp || other.ulp.is_nan() {
            other
        } else {
            self
        }
    }
}

/// |found − exact| in units of the last place of the exact, the smallest subnormal at least.
fn ulps(found: f32, exact: f64) -> f64 {
    let binade = f64::from_bits(exact.to_bits() & 0x7FF0_0000_0000_0000);
    let ulp = (binade * f64::from(f32::EPSILON)).max(f64::from(f32::from_bits(1)));
    let found = f64::from(found);
    if found == exact {
        0.0
    } else {
        (found - exact).abs() / ulp
    }
}

/// All numbers from one to another, both of the same sign, in pieces for the cores.
fn pieces(from: f32, to: f32) -> impl ParallelIterator<Item = std::ops::RangeInclusive<u32>> {
    const PIECE: u32 = 1 << 20;
    let (first, last) = (from.to_bits(), to.to_bits());
    assert!(first <= last);
    (0..=(last - first) / PIECE).into_par_iter().map(move |i| {
        let start = first + i * PIECE;
        start..=last.min(start.saturating_add(PIECE - 1))
    })
}

/// The worst of a function's results over all numbers from one to another of the same sign: what it gives, and what it should.
fn over<const N: usize>(from: f32, to: f32, judge: impl Fn(f32) -> [(f32, f64); N] + Sync) -> [Worst; N] {
    let piece = |bits: std::ops::RangeInclusive<u32>| {
        let mut worst = [Worst::default(); N];
        for bits in bits {
            let at = f32::from_bits(bits);
            for (worst, (found, exact)) in worst.iter_mut().zip(judge(at)) {
                *worst = worst.or(Worst {
                    ulp: ulps(found, exact),
                    at,
                });
            }
        }
        worst
    };
    pieces(from, to)
        .map(piece)
        .reduce(|| [Worst::default(); N], |a, b| std::array::from_fn(|i| a[i].or(b[i])))
}

/// Says the worst error and holds it to a claim.
fn hold(what: &str, worst: Worst, claimed: f64) {
    println!("{what}: {:.3} ulp at {:e}, of {claimed}", worst.ulp, worst.at);
    assert!(worst.ulp <= claimed, "{what}: {worst:?} is over {claimed}");
}

fn claim(what: &str) -> f64 {
    table::claim(what)[1]
}

/// That a function is odd, or even, in every bit, over numbers from 0 on.
fn mirrors(to: f32, pair: impl Fn(f32) -> (f32, f32) + Sync) {
    pieces(0.0, to).for_each(|bits| {
        for bits in bits {
            let (positive, negative) = pair(f32::from_bits(bits));
            assert!(
                positive.to_bits() == negative.to_bits(),
                "at {:e}",
                f32::from_bits(bits)
            );
        }
    });
}

#[test]
#[ignore = "10⁹ numbers"]
fn sin_cos() {
    let limit = 100.0;
    let [sin, cos] = over(0.0, limit, |x| {
        let ((s, c), (sin, cos)) = (math::sin_cos(x), f64::from(x).sin_cos());
        [(s, sin), (c, cos)]
    });
    hold("math::sin_cos, sine", sin, claim("math::sin_cos"));
    hold("math::sin_cos, cosine", cos, claim("math::sin_cos"));
    mirrors(limit, |x| (math::sin_cos(x).0, -math::sin_cos(-x).0));
    mirrors(limit, |x| (math::sin_cos(x).1, math::sin_cos(-x).1));
    pieces(limit.next_up(), f32::from_bits(0x7FFF_FFFF)).for_each(|bits| {
        for x in bits.map(f32::from_bits) {
            let ((a, b), (c, d)) = (math::sin_cos(x), math::sin_cos(-x));
            assert!(a.is_nan() && b.is_nan() && c.is_nan() && d.is_nan(), "{x:e}");
        }
    });
}

/// Sine and cosine of degrees, reduced to 45° exactly.
fn exact_degrees(x: f32) -> (f64, f64) {
    let x = f64::from(x);
    let quarters = (x / 90.0).round();
    let (sin, cos) = (x - 90.0 * quarters).to_radians().sin_cos();
    match quarters as i64 & 3 {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[test]
#[ignore = "10⁹ numbers"]
fn sin_cos_degrees() {
    let limit = 1e6;
    let [sin, cos] = over(0.0, limit, |x| {
        let ((s, c), (sin, cos)) = (math::sin_cos_degrees(x), exact_degrees(x));
        [(s, sin), (c, cos)]
    });
    hold("math::sin_cos_degrees, sine", sin, claim("math::sin_cos_degrees"));
    hold("math::sin_cos_degrees, cosine", cos, claim("math::sin_cos_degrees"));
    mirrors(limit, |x| (math::sin_cos_degrees(x).0, -math::sin_cos_degrees(-x).0));
    mirrors(limit, |x| (math::sin_cos_degrees(x).1, math::sin_cos_degrees(-x).1));
}

#[test]
#[ignore = "10⁹ numbers"]
fn tan() {
    let limit = std::f32::consts::FRAC_PI_4;
    let [worst] = over(0.0, limit, |x| [(math::tan(x), f64::from(x).tan())]);
    hold("math::tan", worst, claim("math::tan"));
    mirrors(limit, |x| (math::tan(x), -math::tan(-x)));
}

#[test]
#[ignore = "2·10⁹ numbers"]
fn atan() {
    let [worst] = over(0.0, f32::INFINITY, |x| [(math::atan(x), f64::from(x).atan())]);
    hold("math::atan", worst, claim("math::atan"));
    mirrors(f32::INFINITY, |x| (math::atan(x), -math::atan(-x)));
}

#[test]
#[ignore = "2·10⁹ numbers"]
fn cbrt() {
    let [worst] = over(f32::MIN_POSITIVE, f32::INFINITY, |x| {
        [(math::cbrt(x), f64::from(x).cbrt())]
    });
    hold("math::cbrt", worst, claim("math::cbrt"));
    mirrors(f32::INFINITY, |x| (math::cbrt(x), -math::cbrt(-x)));
}

#[test]
#[ignore = "2·10⁹ numbers"]
fn sqrt() {
    let [worst] = over(0.0, f32::INFINITY, |x| [(Real::sqrt(x), f64::from(x).sqrt())]);
    hold("Real::sqrt", worst, 0.5);
}

#[test]
#[ignore = "5·10⁹ numbers"]
fn logarithms_and_powers() {
    // To where the result is the largest number, and where it is −1.
    let power = |x: f32| [(math::exp_m1(x), f64::from(x).exp_m1())];
    let [above] = over(0.0, 88.722_83, power);
    let [below] = over(-0.0, -120.0, power);
    hold("math::exp_m1", above.or(below), claim("math::exp_m1"));
    let [worst] = over(f32::from_bits(1), f32::MAX, |x| [(math::log2(x), f64::from(x).log2())]);
    hold("math::log2", worst, claim("math::log2"));
}

/// Of the quadrilateralized cube the two functions of one number, which its edges show: y there of the gnomonic coordinate, and back.
#[test]
#[ignore = "2·10⁹ numbers"]
fn quadrilateralized() {
    let forward = |t: f32| {
        // The vector rounded to unit length has a coordinate of its own.
        let length = (2.0 + f64::from(t) * f64::from(t)).sqrt();
        let [long, short] = [1.0 / length, f64::from(t) / length].map(|v| v as f32);
        let [_, y] = Quadrilateralized.forward(Face::Front, [long, short, long]);
        let t = f64::from(short) / f64::from(long);
        [(y, 12.0 / PI * (t.atan() - (t / (2.0 + t * t).sqrt()).atan()))]
    };
    let inverse = |m: f32| {
        let [right, up, _] = Quadrilateralized.inverse(Face::Front, [1.0, m]);
        let angle = PI / 12.0 * f64::from(m);
        let t = angle.sin() / (angle.cos() - std::f64::consts::FRAC_1_SQRT_2);
        // The component itself: the other is the secant's inverse.
        [(up, t / (2.0 + t * t).sqrt()), (right, 1.0 / (2.0 + t * t).sqrt())]
    };
    let [m] = over(0.0, 1.0, forward);
    hold("quadrilateralized, y on the edge", m, 2.0);
    let [up, right] = over(0.0, 1.0, inverse);
    hold("quadrilateralized, a component on the edge", up, 3.0);
    hold("quadrilateralized, the other", right, 2.0);
}

/// Of the vertex cube, likewise, on the midline.
#[test]
#[ignore = "2·10⁹ numbers"]
fn vertex() {
    let third = (1.0_f64 / 3.0).sqrt();
    let forward = |u: f32| {
        let [x, _] = Vertex.forward(Face::Front, [u, 0.0, 1.0]);
        // The area of the triangle between the corner, the centre and the point of the midline.
        let u = f64::from(u);
        let (sin, cos) = (u / (1.0 + u * u).sqrt(), 1.0 / (1.0 + u * u).sqrt());
        let area = 2.0 * (sin * third).atan2(1.0 + third + cos + (sin + cos) * third);
        [(x, 12.0 / PI * area)]
    };
    let inverse = |t: f32| {
        let [right, _, outward] = Vertex.inverse(Face::Front, [t, 0.0]);
        let tangent = (PI / 24.0 * f64::from(t)).tan();
        let k = (3f64.sqrt() - 1.0) / std::f64::consts::SQRT_2;
        let half = std::f64::consts::SQRT_2 * tangent / (k * (1.0 - tangent));
        let square = half * half;
        [
            (right, 2.0 * half / (1.0 + square)),
            (outward, (1.0 - square) / (1.0 + square)),
        ]
    };
    let [t] = over(0.0, 1.0, forward);
    hold("vertex, x on the midline", t, 4.0);
    let [right, outward] = over(0.0, 1.0, inverse);
    hold("vertex, a component on the midline", right, 4.0);
    hold("vertex, the other", outward, 2.0);
}

/// Latitudes on the Earth from 2⁻²⁰ on, below which they are in proportion; in radians.
#[test]
#[ignore = "2·10⁹ numbers"]
fn latitudes() {
    let (single, double) = (Ellipsoid::<f32>::wgs84(), {
        let earth = Ellipsoid::<f32>::wgs84();
        Ellipsoid::new(f64::from(earth.a()), f64::from(earth.f())).unwrap()
    });
    let quarter = FRAC_PI_2 as f32;
    for &kind in &Latitude::ALL[1..] {
        for (from, to) in [(Latitude::Geodetic, kind), (kind, Latitude::Geodetic)] {
            let (single, double) = (
                Conversion::new(single, from, to).unwrap(),
                Conversion::new(double, from, to).unwrap(),
            );
            let limit = if from == Latitude::Isometric { 17.0 } else { quarter };
            let error = |x: f32| {
                // The scalar's right angle is less than one: π/2 rounds down in f64, up in f32.
                let exact =
                    double.radians(f64::from(x).min(if from == Latitude::Isometric { 40.0 } else { FRAC_PI_2 }));
                (f64::from(single.radians(x).unwrap()), exact.unwrap())
            };
            let worst = pieces(2f32.powi(-20), limit.next_down())
                .map(|bits| {
                    let mut worst = (0.0, 0.0);
                    for x in bits.map(f32::from_bits) {
                        let (found, exact) = error(x);
                        let scale = if to == Latitude::Isometric {
                            exact.abs().max(1.0)
                        } else {
                            1.0
                        };
                        let error = (found - exact).abs() / scale;
                        worst = if error <= worst.0 { worst } else { (error, x) };
                    }
                    worst
                })
                .reduce(|| (0.0, 0.0), |a, b| if b.0 <= a.0 { a } else { b });
            let claimed = claim(match (from, to) {
                (_, Latitude::Isometric) => "isometric latitude, relative to 1 or more",
                (Latitude::Geodetic, _) => "latitude of a geodetic one",
                _ => "geodetic latitude of another",
            });
            println!("{from} to {to}: {:.2e} at {:e}, of {claimed:e}", worst.0, worst.1);
            assert!(worst.0 <= claimed, "{from} to {to}: {worst:?}");
        }
    }
}
