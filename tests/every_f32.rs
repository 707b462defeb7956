//! Every `f32`: functions of one number over all that they take, against `f64`.
//!
//! `cargo test --release --test every_f32 -- --ignored --nocapture`: some minutes on two cores; it says the worst error and where.
//! The platform's `f64` functions are the reference; for latitudes, this crate's in `f64`, which are held to truth of 25 digits.
#![allow(missing_docs, clippy::unwrap_used, clippy::panic, clippy::indexing_slicing)] // tests

use std::f64::consts::{FRAC_PI_2, PI};

use terrella::cube::{CubeProjection, Face, Quadrilateralized, Vertex};
use terrella::latitude::Conversion;
use terrella::{Ellipsoid, Latitude, Real, math};
use testkit::{maximum, minimum, parallel, table};

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
    let ulp = maximum(binade * f64::from(f32::EPSILON), f64::from(f32::from_bits(1)));
    let found = f64::from(found);
    if found == exact {
        0.0
    } else {
        (found - exact).abs() / ulp
    }
}

/// All numbers from one to another, both of the same sign, in pieces for the cores.
fn pieces(from: f32, to: f32) -> impl Iterator<Item = std::ops::RangeInclusive<u32>> + Send {
    const PIECE: u32 = 1 << 20;
    let (first, last) = (from.to_bits(), to.to_bits());
    assert!(first <= last);
    (0..=(last - first) / PIECE).map(move |i| {
        let start = first + i * PIECE;
        start..=last.min(start.saturating_add(PIECE - 1))
    })
}

/// Numbers at a time, so that what is tried runs as wide as the machine is.
const BLOCK: usize = 64;

/// The worst of a function's results over all numbers from one to another of the same sign; and that of the opposite number each result is
/// the same, but for this sign. A sign of 0 says nothing.
fn over<const N: usize>(
    [from, to]: [f32; 2],
    signs: [f32; N],
    found: impl Fn(f32) -> [f32; N] + Sync,
    exact: impl Fn(f64) -> [f64; N] + Sync,
) -> [Worst; N] {
    let piece = |bits: std::ops::RangeInclusive<u32>| {
        let mut worst = [Worst::default(); N];
        let (first, last) = (*bits.start(), *bits.end());
        for start in (first..=last).step_by(BLOCK) {
            // Past the end the last one again.
            let at: [f32; BLOCK] = std::array::from_fn(|i| f32::from_bits(last.min(start.saturating_add(i as u32))));
            let results = at.map(&found);
            let opposite = at.map(|x| found(-x));
            for ((at, result), opposite) in at.into_iter().zip(results).zip(opposite) {
                let truth = exact(f64::from(at));
                for i in 0..N {
                    let mirrored = signs[i] * result[i];
                    assert!(
                        signs[i] == 0.0 || mirrored == opposite[i],
                        "{at:e} and its opposite: {:e} {:e}",
                        result[i],
                        opposite[i]
                    );
                    worst[i] = worst[i].or(Worst {
                        ulp: ulps(result[i], truth[i]),
                        at,
                    });
                }
            }
        }
        worst
    };
    let all = parallel::map(pieces(from, to), piece);
    all.into_iter()
        .fold([Worst::default(); N], |a, b| std::array::from_fn(|i| a[i].or(b[i])))
}

/// Says the worst error and holds it to a claim.
fn hold(what: &str, worst: Worst, claimed: f64) {
    println!("{what}: {:.3} ulp at {:e}, of {claimed}", worst.ulp, worst.at);
    assert!(worst.ulp <= claimed, "{what}: {worst:?} is over {claimed}");
}

fn claim(what: &str) -> f64 {
    table::claim(what)[1]
}

#[test]
#[ignore = "10⁹ numbers"]
fn sin_cos() {
    let limit = 100.0;
    let [sin, cos] = over(
        [0.0, limit],
        [-1.0, 1.0],
        |x| math::sin_cos(x).into(),
        |x| x.sin_cos().into(),
    );
    hold("math::sin_cos, sine", sin, claim("math::sin_cos"));
    hold("math::sin_cos, cosine", cos, claim("math::sin_cos"));
}

/// Sine and cosine of degrees, reduced to 45° exactly.
fn exact_degrees(x: f64) -> [f64; 2] {
    let quarters = (x / 90.0).round();
    let (sin, cos) = (x - 90.0 * quarters).to_radians().sin_cos();
    match quarters as i64 & 3 {
        0 => [sin, cos],
        1 => [cos, -sin],
        2 => [-sin, -cos],
        _ => [-cos, sin],
    }
}

#[test]
#[ignore = "10⁹ numbers"]
fn sin_cos_degrees() {
    let found = |x| math::sin_cos_degrees(x).into();
    // Up to a sine of 10⁻³⁷ products are subnormal.
    let small = 5.7e-36_f32;
    let [sin, _] = over([0.0, small], [-1.0, 1.0], found, exact_degrees);
    hold("math::sin_cos_degrees, sine below 1e-37", sin, 1.5);
    let [sin, cos] = over([small, 1e6], [-1.0, 1.0], found, exact_degrees);
    hold("math::sin_cos_degrees, sine", sin, claim("math::sin_cos_degrees"));
    hold("math::sin_cos_degrees, cosine", cos, claim("math::sin_cos_degrees"));
}

#[test]
#[ignore = "10⁹ numbers"]
fn beyond_their_limits_they_are_not_numbers() {
    let not_a_number = |limit: f32, found: fn(f32) -> (f32, f32)| {
        parallel::for_each(pieces(limit.next_up(), f32::from_bits(0x7FFF_FFFF)), |bits| {
            for x in bits.map(f32::from_bits) {
                let ((a, b), (c, d)) = (found(x), found(-x));
                assert!(a.is_nan() && b.is_nan() && c.is_nan() && d.is_nan(), "{x:e}");
            }
        });
    };
    not_a_number(100.0, math::sin_cos);
    not_a_number(1e6, math::sin_cos_degrees);
}

#[test]
#[ignore = "10⁹ numbers"]
fn tan() {
    let limit = std::f32::consts::FRAC_PI_4;
    let [worst] = over([0.0, limit], [-1.0], |x| [math::tan(x)], |x| [x.tan()]);
    hold("math::tan", worst, claim("math::tan"));
}

#[test]
#[ignore = "2·10⁹ numbers"]
fn atan() {
    let [worst] = over([0.0, f32::MAX], [-1.0], |x| [math::atan(x)], |x| [x.atan()]);
    hold("math::atan", worst, claim("math::atan"));
}

#[test]
#[ignore = "2·10⁹ numbers"]
fn cbrt() {
    let all = [f32::MIN_POSITIVE, f32::INFINITY];
    let [worst] = over(all, [-1.0], |x| [math::cbrt(x)], |x| [x.cbrt()]);
    hold("math::cbrt", worst, claim("math::cbrt"));
}

#[test]
#[ignore = "2·10⁹ numbers"]
fn sqrt() {
    let [worst] = over([0.0, f32::INFINITY], [0.0], |x| [Real::sqrt(x)], |x| [x.sqrt()]);
    hold("Real::sqrt", worst, 0.5);
}

#[test]
#[ignore = "5·10⁹ numbers"]
fn logarithms_and_powers() {
    let either_sign = |found: fn(f32) -> f32, exact: fn(f64) -> f64, from: f32, to: f32| {
        let part = |ends| over(ends, [0.0], |x| [found(x)], |x| [exact(x)])[0];
        part([0.0, to]).or(part([-0.0, from]))
    };
    // From where the result is −1 to where it is the largest number.
    let worst = either_sign(math::exp_m1, f64::exp_m1, -120.0, 88.722_83);
    hold("math::exp_m1", worst, claim("math::exp_m1"));
    let [worst] = over(
        [f32::from_bits(1), f32::MAX],
        [0.0],
        |x| [math::log2(x)],
        |x| [x.log2()],
    );
    hold("math::log2", worst, claim("math::log2"));
}

/// Of the quadrilateralized cube the two functions of one number, which its edges show: y there of the gnomonic coordinate, and the
/// components of the direction, back.
#[test]
#[ignore = "2·10⁹ numbers"]
fn quadrilateralized() {
    // The vector rounded to unit length has a coordinate of its own.
    let unit = |t: f32| {
        let length = (2.0 + f64::from(t) * f64::from(t)).sqrt();
        [1.0 / length, f64::from(t) / length].map(|v| v as f32)
    };
    let [m] = over(
        [0.0, 1.0],
        [-1.0],
        |t| {
            let [long, short] = unit(t);
            [Quadrilateralized.forward(Face::Front, [long, short, long])[1]]
        },
        |t| {
            let [long, short] = unit(t as f32).map(f64::from);
            let t = short / long;
            [12.0 / PI * (t.atan() - (t / (2.0 + t * t).sqrt()).atan())]
        },
    );
    hold("quadrilateralized, y on the edge", m, 3.6);
    let [right, up] = over(
        [0.0, 1.0],
        [1.0, -1.0],
        |m| {
            let [right, up, _] = Quadrilateralized.inverse(Face::Front, [1.0, m]);
            [right, up]
        },
        |m| {
            let (sin, cos) = (PI / 12.0 * m).sin_cos();
            let t = sin / (cos - std::f64::consts::FRAC_1_SQRT_2);
            let length = (2.0 + t * t).sqrt();
            [1.0 / length, t / length]
        },
    );
    hold("quadrilateralized, to the right on the edge", right, 1.5);
    hold("quadrilateralized, up on the edge", up, 3.0);
}

/// Of the vertex cube, likewise, on the midline.
#[test]
#[ignore = "2·10⁹ numbers"]
fn vertex() {
    let third = (1.0_f64 / 3.0).sqrt();
    let [t] = over(
        [0.0, 1.0],
        [-1.0],
        |u| [Vertex.forward(Face::Front, [u, 0.0, 1.0])[0]],
        |u| {
            // The area of the triangle between the corner, the centre and the point of the midline.
            let cos = 1.0 / (1.0 + u * u).sqrt();
            let sin = u * cos;
            [24.0 / PI * (sin * third).atan2(1.0 + third + cos + (sin + cos) * third)]
        },
    );
    hold("vertex, x on the midline", t, 4.2);
    let [right, outward] = over(
        [0.0, 1.0],
        [-1.0, 1.0],
        |t| {
            let [right, _, outward] = Vertex.inverse(Face::Front, [t, 0.0]);
            [right, outward]
        },
        |t| {
            let tangent = (PI / 24.0 * t).tan();
            let k = (3f64.sqrt() - 1.0) / std::f64::consts::SQRT_2;
            let half = std::f64::consts::SQRT_2 * tangent / (k * (1.0 - tangent));
            let square = half * half;
            [2.0 * half / (1.0 + square), (1.0 - square) / (1.0 + square)]
        },
    );
    hold("vertex, to the right on the midline", right, 4.2);
    hold("vertex, outward on the midline", outward, 2.1);
}

/// Latitudes on the Earth from 2⁻²⁰ on, below which they are in proportion; in radians.
#[test]
#[ignore = "2·10⁹ numbers"]
fn latitudes() {
    let (single, double) = (Ellipsoid::<f32>::WGS84, {
        let earth = Ellipsoid::<f32>::WGS84;
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
                let exact = double.radians(minimum(
                    f64::from(x),
                    if from == Latitude::Isometric { 40.0 } else { FRAC_PI_2 },
                ));
                (f64::from(single.radians(x).unwrap()), exact.unwrap())
            };
            let all = parallel::map(pieces(2f32.powi(-20), limit.next_down()), |bits| {
                let mut worst = (testkit::Worst::default(), 0.0);
                for x in bits.map(f32::from_bits) {
                    let (found, exact) = error(x);
                    let scale = if to == Latitude::Isometric {
                        maximum(exact.abs(), 1.0)
                    } else {
                        1.0
                    };
                    if worst.0.add((found - exact).abs() / scale) {
                        worst.1 = x;
                    }
                }
                worst
            });
            let worst = all
                .into_iter()
                .reduce(|mut a, b| if a.0.add(b.0.value()) { b } else { a })
                .map(|(worst, x)| (worst.value(), x))
                .unwrap();
            let claimed = claim(match (from, to) {
                (_, Latitude::Isometric) => "isometric latitude, relative to 1 or more",
                (Latitude::Geodetic, _) => "latitude of a geodetic one",
                (Latitude::Isometric, _) => "geodetic latitude of an isometric one",
                _ => "geodetic latitude of another",
            });
            println!("{from} to {to}: {:.2e} at {:e}, of {claimed:e}", worst.0, worst.1);
            assert!(worst.0 <= claimed, "{from} to {to}: {worst:?}");
        }
    }
}
