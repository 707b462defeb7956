use super::minimax::ATAN;
use super::{halves, max, min, select};
use crate::Real;

/// Arc tangent in radians, in [−π/2, π/2].
///
/// Within 0.85 ulp.
///
/// ```
/// assert_eq!(terrella::math::atan(1.0_f64), core::f64::consts::FRAC_PI_4);
/// ```
#[must_use]
#[inline]
pub fn atan<T: Real>(x: T) -> T {
    let (high, low) = Reduced::new(x.abs(), T::ONE).radians();
    (high + low).copysign(x)
}

/// The angle of the point (x, y) from the x axis, in radians, in [−π, π].
///
/// Within 0.85 ulp, for numbers of any size. The signs of zero count as in C's `atan2`, and (0, 0) gives 0 or π.
///
/// ```
/// assert_eq!(terrella::math::atan2(1.0_f64, -1.0), 0.75 * core::f64::consts::PI);
/// ```
#[must_use]
#[inline]
pub fn atan2<T: Real>(y: T, x: T) -> T {
    let (high, low) = Reduced::new(y.abs(), x.abs()).radians();
    let pi = T::pick(core::f64::consts::PI, core::f32::consts::PI);
    let pi_low = T::pick(1.224_646_799_147_353_2e-16, -8.742_277_7e-8);
    opened(high, low, pi, pi_low, x).copysign(y)
}

/// The angle of the point (x, y) from the x axis, in degrees, in [−180, 180].
///
/// Within 0.85 ulp, exact on the axes and the diagonals; signs of zero as for [`atan2`].
///
/// ```
/// assert_eq!(terrella::math::atan2_degrees(-1.0_f32, 1.0), -45.0);
/// assert_eq!(terrella::math::atan2_degrees(0.0_f64, -1.0), 180.0);
/// ```
#[must_use]
#[inline]
pub fn atan2_degrees<T: Real>(y: T, x: T) -> T {
    let (high, low) = Reduced::new(y.abs(), x.abs()).degrees();
    opened(high, low, T::of(180.0), T::ZERO, x).copysign(y)
}

/// The angle of the point (x, y), y ≥ 0, from the x axis: a multiple of 45° and the rest in radians, within π/8 and 1.5 ulp.
///
/// Half the arithmetic of [`atan2`], for numbers whose squares are normal; (0, 0) gives 0.
#[inline(always)]
pub(crate) fn octant<T: Real>(y: T, x: T) -> (T, T) {
    let width = x.abs();
    let (low, high) = (min(y, width), max(y, width));
    let middle = low > high * T::of(core::f64::consts::SQRT_2 - 1.0);
    let least = T::pick(1e-300, 1e-37);
    let tangent = select(middle, low - high, low) / max(select(middle, low + high, high), least);
    let z = tangent * tangent;
    let curve = halves(z, T::terms(ATAN.f64.len(), ATAN.f32.len()), |i| {
        T::coefficient(&ATAN, i)
    });
    let rest = tangent + tangent * z * curve;
    let steep = y > width;
    let m = select(middle, T::ONE, T::ZERO);
    let (m, rest) = (select(steep, T::of(2.0) - m, m), select(steep, -rest, rest));
    let back = x < T::ZERO;
    (select(back, T::of(4.0) - m, m), select(back, -rest, rest))
}

/// The angle `high + low` of the first quadrant, or a half circle less it where x is negative; rounded once.
#[inline(always)]
fn opened<T: Real>(high: T, low: T, half_circle: T, half_circle_low: T, x: T) -> T {
    let rest = half_circle - high;
    let lost = (half_circle - rest) - high;
    let negative = T::ONE.copysign(x) < T::ZERO;
    select(negative, rest, high) + select(negative, (lost + half_circle_low) - low, low)
}

/// An angle of the first quadrant as a base angle, whose tangent is 0, ½, 1, 2 or ∞, and a remainder whose tangent is at
/// most 7/16: fdlibm's reduction, with one quotient for all.
struct Reduced<T> {
    /// Whether the angle belongs to the first base, to one of the first two, three, four.
    within: [bool; 4],
    tangent: T,
    /// What to add to the tangent.
    lost: T,
}

impl<T: Real> Reduced<T> {
    #[inline(always)]
    fn new(y: T, x: T) -> Self {
        // Far from the ends of the scalar's range: 2^±200 (2^±40) brings there what is not.
        let larger = max(x, y);
        let grow = T::pick(1.606_938_044_258_990_3e60, 1.099_511_6e12);
        let shrink = T::pick(6.223_015_277_861_142e-61, 9.094_947e-13);
        let small = larger < T::pick(1e-200, 1e-20);
        let large = larger > T::pick(1e200, 1e20);
        let scale = select(small, grow, select(large, shrink, T::ONE));
        let (y, x) = (y * scale, x * scale);
        let within = [7.0 / 16.0, 11.0 / 16.0, 16.0 / 11.0, 16.0 / 7.0].map(|limit| y <= x * T::of(limit));
        let base = |table: [f64; 5]| entry(within, table.map(T::of));
        // Sine and cosine of the base angle but for a common factor: the numerator is exact.
        let sine = base([0.0, 0.5, 1.0, 1.0, 1.0]);
        let cosine = base([1.0, 1.0, 1.0, 0.5, 0.0]);
        let numerator = y * cosine - x * sine;
        let denominator = x * cosine + y * sine;
        let denominator = select(denominator == T::ZERO, T::ONE, denominator);
        let tangent = numerator / denominator;
        // What the quotient's rounding lost: for a small angle it would be half of the error.
        let (th, tl) = tangent.split();
        let (dh, dl) = denominator.split();
        let product = tangent * denominator;
        let rounding = ((th * dh - product) + th * dl + tl * dh) + tl * dl;
        let lost = ((numerator - product) - rounding) / denominator;
        Self { within, tangent, lost }
    }

    /// Base angle and the rest, in radians.
    #[inline(always)]
    fn radians(self) -> (T, T) {
        let high = [
            T::ZERO,
            T::pick(0.463_647_609_000_806_1, 0.463_647_6),
            T::pick(core::f64::consts::FRAC_PI_4, core::f32::consts::FRAC_PI_4),
            T::pick(1.1071487177940904, 1.1071488),
            T::pick(core::f64::consts::FRAC_PI_2, core::f32::consts::FRAC_PI_2),
        ];
        let low = [
            T::ZERO,
            T::pick(2.269_877_745_296_168_7e-17, 5.012_158_7e-9),
            T::pick(3.061_616_997_868_383e-17, -2.185_569_4e-8),
            T::pick(9.40447137356638e-17, -4.872355e-08),
            T::pick(6.123_233_995_736_766e-17, -4.371_138_8e-8),
        ];
        let r = self.tangent;
        let z = r * r;
        let small = r + (r * z * z.polynomial(&ATAN) + (self.lost + entry(self.within, low)));
        (entry(self.within, high), small)
    }

    /// Base angle and the rest, in degrees.
    #[inline(always)]
    fn degrees(self) -> (T, T) {
        let high = [
            T::ZERO,
            T::pick(26.565_051_177_077_99, 26.565_052),
            T::of(45.0),
            T::pick(63.43494882292201, 63.434948),
            T::of(90.0),
        ];
        let low = [
            T::ZERO,
            T::pick(-6.673_432_494_950_659e-16, -8.553_927e-7),
            T::ZERO,
            T::pick(6.673432494950659e-16, 8.5539273e-07),
            T::ZERO,
        ];
        // 180/π is split so that its head times the remainder's head is exact.
        let k1 = T::pick(57.295_779_228_210_45, 57.281_25);
        let k2 = T::pick(2.848_718_716_580_481_4e-7, 0.014_529_513);
        let r = self.tangent;
        let z = r * r;
        let (head, tail) = r.split();
        let curve = r * z * z.polynomial(&ATAN) * (k1 + k2);
        let small = curve + (tail * k1 + r * k2 + (self.lost * k1 + entry(self.within, low)));
        (entry(self.within, high), head * k1 + small)
    }
}

/// The entry of the table that belongs to the base angle.
#[inline(always)]
fn entry<T: Copy>(within: [bool; 4], [t0, t1, t2, t3, t4]: [T; 5]) -> T {
    let [first, second, third, fourth] = within;
    select(first, t0, select(second, t1, select(third, t2, select(fourth, t3, t4))))
}
