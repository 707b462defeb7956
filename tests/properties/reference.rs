//! The way from the plane to the sphere by the formulas as they are published, in twice the digits of `f64`: what the
//! projections are held to in both directions.

use terrella::cube::Projection;

use testkit::double::{Double, PI, of};

type Plane = [Double; 2];
type Vector = [Double; 3];

const EQUI_EDGE: Double = Double {
    high: 0.6154797086703874,
    low: -2.990485656135119e-17,
};
const SEPARABLE: Double = Double {
    high: 0.724013050605694,
    low: 1.762939342182131e-17,
};
const LAMBERS: Double = Double {
    high: 0.8747445087291941,
    low: 2.724949428716816e-17,
};

fn third() -> Double {
    of(1.0) / of(3.0)
}

/// u = tan(θx)/tan θ in both coordinates.
fn tangents([x, y]: Plane, theta: Double) -> Vector {
    let unit = theta.tan();
    [(x * theta).tan() / unit, (y * theta).tan() / unit, of(1.0)]
}

/// A function of the longer and the shorter coordinate, both positive, in the octant where they are.
fn octant([x, y]: Plane, map: impl Fn(Double, Double) -> Vector) -> Vector {
    let steep = y.abs() > x.abs();
    let (long, short) = if steep { (y.abs(), x.abs()) } else { (x.abs(), y.abs()) };
    let [major, minor, outward] = map(long, short);
    let (right, up) = if steep { (minor, major) } else { (major, minor) };
    let signed = |v: Double, sign: Double| if sign.high.is_sign_negative() { -v } else { v };
    [signed(right, x), signed(up, y), outward]
}

/// Dimitrijević, Lambers & Rančić (2016), 4.13 and 4.14 solved for the plane.
fn quadrilateralized(point: Plane) -> Vector {
    octant(point, |long, short| {
        if long == of(0.0) {
            return [long, short, of(1.0)];
        }
        let angle = short / long * PI / of(12.0);
        let (sin, cos) = angle.sin_cos();
        let t = sin / (cos - of(0.5).sqrt());
        let edge = of(1.0) - of(1.0) / (of(2.0) + t * t).sqrt();
        let h = long * long * edge;
        // √(h(2 − h)/(1 + t²))
        let major = long * (edge * (of(2.0) - h) / (of(1.0) + t * t)).sqrt();
        [major, t * major, of(1.0) - h]
    })
}

/// Nowell's, 4.15 of the same paper, at z = 1.
fn cartesian([x, y]: Plane) -> Vector {
    let (xx, yy) = (x * x, y * y);
    [
        x * (of(0.5) - yy / of(6.0)).sqrt(),
        y * (of(0.5) - xx / of(6.0)).sqrt(),
        (of(1.0) - (xx + yy) / of(2.0) + xx * yy * third()).sqrt(),
    ]
}

/// 4.18 and 4.20 of the same paper.
fn healpix(point: Plane, polar: bool) -> Vector {
    let along = |share: Double| (share * PI / of(4.0)).tan();
    if !polar {
        let [x, y] = point;
        let height = y * of(2.0) * third();
        let t = along(x);
        let radius = ((of(1.0) - height * height) / (of(1.0) + t * t)).sqrt();
        return [t * radius, height, radius];
    }
    octant(point, |sigma, short| {
        if sigma == of(0.0) {
            return [sigma, short, of(1.0)];
        }
        let t = along(short / sigma);
        let square = sigma * sigma * third();
        // √(1 − (1 − σ²/3)²)
        let radius = sigma * (third() * (of(2.0) - square)).sqrt() / (of(1.0) + t * t).sqrt();
        [radius, t * radius, of(1.0) - square]
    })
}

/// van Leeuwen & Strebe's slice and dice about the corner of the cube.
fn vertex(point: Plane) -> Vector {
    octant(point, |x, y| {
        let r = of(1.0) - y;
        let corner = [(of(1.0) / of(3.0)).sqrt(); 3];
        if r == of(0.0) {
            return corner;
        }
        let t = (x - y) / r;
        let tangent = (t * PI / of(24.0)).tan();
        let k = (of(3.0).sqrt() - of(1.0)) / of(2.0).sqrt();
        let half = of(2.0).sqrt() * tangent / (k * (of(1.0) - tangent));
        let square = half * half;
        let midline = [
            of(2.0) * half / (of(1.0) + square),
            of(0.0),
            (of(1.0) - square) / (of(1.0) + square),
        ];
        let dot = |a: Vector, b: Vector| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let along = dot(corner, midline);
        let versine = r * r * (of(1.0) - along);
        let beside: Vector = core::array::from_fn(|i| midline[i] - corner[i] * along);
        let sine = (versine * (of(2.0) - versine)).sqrt() / dot(beside, beside).sqrt();
        core::array::from_fn(|i| corner[i] * (of(1.0) - versine) + beside[i] * sine)
    })
}

/// 10⁸Pᵢⱼ of the published inverse of COBE's cube, u = x + x(1 − x²)ΣPᵢⱼx²ⁱy²ʲ: row j, column i.
const COBE: [&[i32]; 7] = [
    &[
        -27_292_696, -7_629_969, -22_797_056, 54_852_384, -62_930_065, 25_795_794, 2_584_375,
    ],
    &[
        -2_819_452, -1_471_565, 48_051_509, -174_114_454, 171_547_508, -53_022_337,
    ],
    &[27_058_160, -56_800_938, 30_803_317, 98_938_102, -83_180_469],
    &[-60_441_560, 150_880_086, -93_678_576, 8_693_841],
    &[93_412_077, -141_601_920, 33_887_446],
    &[-63_915_306, 52_032_238],
    &[14_381_585],
];

fn cobe([x, y]: Plane) -> Vector {
    let half = |x: Double, y: Double| {
        let (xx, yy) = (x * x, y * y);
        let horner = |sum: Double, factor: Double, next: Double| sum * factor + next;
        let row = |row: &&[i32]| row.iter().rev().fold(of(0.0), |sum, &c| horner(sum, xx, of(c.into())));
        let sum = COBE.iter().rev().fold(of(0.0), |sum, r| horner(sum, yy, row(r)));
        x + x * (of(1.0) - xx) * sum / of(1e8)
    };
    [half(x, y), half(y, x), of(1.0)]
}

/// u = x(1 + p(b₀ + p(b₁ + b₂q))).
fn balanced([x, y]: Plane) -> Vector {
    let (p, q) = (of(1.0) - x * x, of(1.0) - y * y);
    let [b0, b1, b2] = [-22.0, 9.0, -11.0].map(|b| of(b) / of(100.0));
    let half = |x, p, q| x * (of(1.0) + p * (b0 + p * (b1 + b2 * q)));
    [half(x, p, q), half(y, q, p), of(1.0)]
}

/// u = x(1 + (1 − x²)P(x², y²)), v likewise: P from its coefficients cᵢⱼ of x²ⁱy²ʲ, which are whole numbers times the
/// unit.
fn edge_keeping([x, y]: Plane, coefficients: &[(usize, usize, i32)], unit: f64) -> Vector {
    let half = |x: Double, y: Double| {
        let power = |square: Double, n: usize| (0..n).fold(of(1.0), |product, _| product * square);
        let sum = coefficients.iter().fold(of(0.0), |sum, &(i, j, c)| {
            sum + of(c.into()) * power(x * x, i) * power(y * y, j)
        });
        x * (of(1.0) + (of(1.0) - x * x) * sum / of(unit))
    };
    [half(x, y), half(y, x), of(1.0)]
}

const EVEN: [(usize, usize, i32); 10] = [
    (0, 0, -2766),
    (0, 1, 340),
    (0, 2, -1908),
    (0, 3, 4685),
    (0, 4, -1989),
    (1, 0, -954),
    (1, 3, 235),
    (2, 1, -2125),
    (2, 2, 1374),
    (5, 0, -137),
];
const COMPACT: [(usize, usize, i32); 8] = [
    (0, 0, -242),
    (2, 0, 32),
    (1, 1, 183),
    (1, 2, -1119),
    (1, 3, 904),
    (3, 1, -69),
    (0, 2, 483),
    (0, 3, -375),
];

/// (xA(x, y), yA(y, x), 1 + z₂₀(p² + q²) + z₂₁(p²q + pq²)).
fn square([x, y]: Plane) -> Vector {
    let (xx, yy) = (x * x, y * y);
    let (p, q) = (of(1.0) - xx, of(1.0) - yy);
    // Decimals of 17 places, exactly.
    let decimal = |first: f64, last: f64| (of(first) + of(last) / of(1e9)) / of(1e8);
    let (b02, z20, z21) = (
        decimal(-14_466_724.0, -146_108_473.0),
        decimal(-4_735_555.0, -476_289_911.0),
        decimal(12_576_117.0, 646_754_637.0),
    );
    [
        x * (of(1.0) + b02 * p * yy * yy + z20 * q * q),
        y * (of(1.0) + b02 * q * xx * xx + z20 * p * p),
        of(1.0) + z20 * (p * p + q * q) + z21 * (p * p * q + p * q * q),
    ]
}

/// The arc tangent of a number in [−1, 1]: that of `f64`, and what it lost.
fn atan(t: Double) -> Double {
    let near = of(t.high.atan());
    let tangent = near.tan();
    near + (t - tangent) / (of(1.0) + t * tangent)
}

/// Grimm & Niebruegge's, from angles along great circles.
fn continuous([x, y]: Plane) -> Vector {
    let root = of(2.0).sqrt();
    let u = root * (x * atan(of(1.0) / root)).tan();
    let secant = (of(1.0) + u * u).sqrt();
    [u, (y * atan(of(1.0) / secant)).tan() * secant, of(1.0)]
}

/// Arvo's, with cos(πx/3) by its half angle.
fn arvo([x, y]: Plane) -> Vector {
    let t = (x * PI / of(6.0)).tan();
    let cosine = (of(1.0) - t * t) / (of(1.0) + t * t);
    [
        of(2.0).sqrt() * t / (of(1.0) - t * t).sqrt(),
        y / (of(1.0) + (of(1.0) - y * y) * cosine).sqrt(),
        of(1.0),
    ]
}

/// 360Lib's HEC.
fn hybrid_equi_angular([x, y]: Plane, polar: bool) -> Vector {
    let along = |w: Double| (w * PI / of(4.0)).tan();
    let bulge = of(2.0) / of(5.0) * (of(1.0) - x * x) * (of(1.0) - y * y);
    let v = if polar { along(y) } else { y / (of(1.0) + bulge) };
    [along(x), v, of(1.0)]
}

/// Zucker & Higashi's, with 10¹³ times its coefficients.
fn cobe_refit([x, y]: Plane) -> Vector {
    let [alpha, a, b, c, d, e] = [
        7_239_512_349_520.0, -941_180_085_824.0, 409_125_981_187.0, -623_272_690_881.0, 275_922_480_902.0,
        342_217_026_979.0,
    ]
    .map(|numerator| of(numerator) / of(1e13));
    let half = |x: Double, y: Double| {
        let (xx, yy) = (x * x, y * y);
        let sum = (a + b * yy + c * xx) * xx + (d + e * yy) * yy;
        x * (alpha + (of(1.0) - alpha) * xx + (of(1.0) - xx) * sum)
    };
    [half(x, y), half(y, x), of(1.0)]
}

/// The direction of a point, in the face's frame (right, up, outward), of any length; none for a projection without a closed formula
/// back, or that is newer than this file: it is judged in `f32` alone, next to `f64`, and by the truth.
pub fn inverse(projection: Projection, polar: bool, point: [f64; 2]) -> Option<[Double; 3]> {
    let [x, y] = point.map(of);
    let quadratic = |x: Double| x * (of(2.0) + x.abs()) * third();
    let algebraic = |x: Double| {
        let square = of(7569.0) / of(10_000.0);
        x / (of(1.0) + square - square * x * x).sqrt()
    };
    let everitt = |x: Double| {
        let e = of(14_511.0) / of(10_000.0);
        let root = (e * e - of(4.0) * (e - of(1.0)) * x.abs()).sqrt();
        of(2.0) * x / (e + root)
    };
    let fifth = |x: Double| {
        let [a, b, c] = [745_558_715_593.0, 130_546_850_193.0, 123_894_434_214.0].map(|c| of(c) / of(1e12));
        x * (a + x * x * (b + x * x * c))
    };
    let unicube = |x: Double| {
        let sine = (x * PI / of(6.0)).sin_cos().0;
        sine / (of(0.5) - sine * sine).sqrt()
    };
    Some(match projection {
        Projection::Tangential => [x, y, of(1.0)],
        Projection::Adjusted => tangents([x, y], PI / of(4.0)),
        // atan 1/√2, acos 2^(−5/12) and atan 1.1968
        Projection::EquiEdge => tangents([x, y], EQUI_EDGE),
        Projection::Separable => tangents([x, y], SEPARABLE),
        Projection::Lambers => tangents([x, y], LAMBERS),
        Projection::ZuckerHigashi => tangents([x, y], of(868_734_829_276.0) / of(1e12)),
        Projection::Outerra => {
            let bulge = (of(2.0).sqrt() - of(1.0)) / of(2.0);
            [x, y, of(1.0) + bulge * (of(1.0) - x * x) * (of(1.0) - y * y)]
        }
        Projection::Cobe => cobe([x, y]),
        Projection::Quadrilateralized => quadrilateralized([x, y]),
        Projection::Cartesian => cartesian([x, y]),
        Projection::Healpix => healpix([x, y], polar),
        Projection::S2Quadratic => [quadratic(x), quadratic(y), of(1.0)],
        Projection::Algebraic => [algebraic(x), algebraic(y), of(1.0)],
        Projection::Everitt => [everitt(x), everitt(y), of(1.0)],
        Projection::Polynomial5 => [fifth(x), fifth(y), of(1.0)],
        Projection::Unicube => [unicube(x), unicube(y), of(1.0)],
        Projection::Vertex => vertex([x, y]),
        Projection::Balanced => balanced([x, y]),
        Projection::Square => square([x, y]),
        Projection::Continuous => continuous([x, y]),
        Projection::Arvo => arvo([x, y]),
        Projection::HybridEquiAngular => hybrid_equi_angular([x, y], polar),
        Projection::CobeRefit => cobe_refit([x, y]),
        Projection::Even => edge_keeping([x, y], &EVEN, 1e4),
        Projection::Compact => edge_keeping([x, y], &COMPACT, 1e3),
        // `CobeExact` and `Conformal` have no formula as short, `Tanh` has a logarithm.
        _ => return None,
    })
}

/// [`inverse`], rounded to a unit vector in `f64` and what that lost.
pub fn direction(projection: Projection, polar: bool, point: [f64; 2]) -> Option<[[f64; 2]; 3]> {
    let vector = inverse(projection, polar, point)?;
    let square = vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2];
    let length = square.sqrt();
    Some(vector.map(|v| {
        let unit = v / length;
        [unit.high, unit.low]
    }))
}

/// The formulas above and the arithmetic under them, against the truth.
#[cfg(test)]
mod tests {
    use terrella::cube::{Face, Projection};
    use testkit::Worst;

    use super::direction;
    use testkit::truth::Truth;

    #[test]
    fn the_reference_is_the_truth() {
        for &projection in Projection::ALL {
            if direction(projection, false, [0.0; 2]).is_none() {
                continue;
            }
            let mut worst = Worst::default();
            for row in Truth::read(&format!("cube_{projection}_inverse")).exact_in::<f64>(&["x", "y"]) {
                let face = Face::from_index(row.value("face") as u8).unwrap();
                let local = direction(projection, face.is_polar(), [row.value("x"), row.value("y")]).unwrap();
                let [high, low] = [0, 1].map(|part| face.to_earth(local.map(|component| component[part])));
                // The truth's columns are the paper's axes, in the order of the Earth's.
                for (i, column) in ["vz", "vx", "vy"].into_iter().enumerate() {
                    worst.add((row.deviation(column, high[i]) + low[i]).abs());
                }
            }
            let worst = worst.value();
            println!("{projection}: {worst:.1e}");
            assert!(worst < 1e-20, "{projection}: {worst:e}");
        }
    }
}
