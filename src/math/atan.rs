use super::minimax::ATAN;
use super::select;
use crate::Real;

/// Arc tangent in radians, in [−π/2, π/2].
///
/// Within 0.9 ulp, for |x| up to a quarter of the largest number.
///
/// ```
/// assert_eq!(terrella::math::atan(1.0_f64), core::f64::consts::FRAC_PI_4);
/// ```
#[must_use]
#[inline]
pub fn atan<T: Real>(x: T) -> T {
    Reduced::new(x.abs(), T::ONE).radians().copysign(x)
}

/// The angle of the point (x, y) from the x axis, in radians, in [−π, π].
///
/// Within 0.9 ulp, for |x| and |y| up to a quarter of the largest number. The signs of zero count as in C's `atan2`, and
/// (0, 0) gives 0 or π.
///
/// ```
/// assert_eq!(terrella::math::atan2(1.0_f64, -1.0), 0.75 * core::f64::consts::PI);
/// ```
#[must_use]
#[inline]
pub fn atan2<T: Real>(y: T, x: T) -> T {
    let right = Reduced::new(y.abs(), x.abs()).radians();
    let pi = T::pick(core::f64::consts::PI, core::f32::consts::PI);
    let pi_low = T::pick(1.224_646_799_147_353_2e-16, -8.742_277_7e-8);
    select(is_negative(x), pi - (right - pi_low), right).copysign(y)
}

/// The angle of the point (x, y) from the x axis, in degrees, in [−180, 180].
///
/// Within 0.9 ulp, exact on the axes and the diagonals; range and signs of zero as for [`atan2`].
///
/// ```
/// assert_eq!(terrella::math::atan2_degrees(-1.0_f32, 1.0), -45.0);
/// assert_eq!(terrella::math::atan2_degrees(0.0_f64, -1.0), 180.0);
/// ```
#[must_use]
#[inline]
pub fn atan2_degrees<T: Real>(y: T, x: T) -> T {
    let right = Reduced::new(y.abs(), x.abs()).degrees();
    select(is_negative(x), T::of(180.0) - right, right).copysign(y)
}

#[inline(always)]
fn is_negative<T: Real>(x: T) -> bool {
    T::ONE.copysign(x) < T::ZERO
}

/// An angle of the first quadrant as a base angle, whose tangent is 0, ½, 1, 1½ or ∞, and a remainder whose tangent is at
/// most 7/16: fdlibm's reduction, with the one quotient taken after it.
struct Reduced<T> {
    /// Whether the angle belongs to the first base, to one of the first two, three, four.
    within: [bool; 4],
    tangent: T,
}

impl<T: Real> Reduced<T> {
    #[inline(always)]
    fn new(y: T, x: T) -> Self {
        let within = [0.4375, 0.6875, 1.1875, 2.4375].map(|limit| y < x * T::of(limit));
        let base = |table: [f64; 5]| entry(within, table.map(T::of));
        // Sine and cosine of the base angle but for a common factor.
        let sine = base([0.0, 0.5, 1.0, 1.5, 1.0]);
        let cosine = base([1.0, 1.0, 1.0, 1.0, 0.0]);
        let numerator = y * cosine - x * sine;
        let denominator = x * cosine + y * sine;
        let tangent = numerator / select(denominator == T::ZERO, T::ONE, denominator);
        Self { within, tangent }
    }

    #[inline(always)]
    fn radians(self) -> T {
        let high = [
            T::ZERO,
            T::pick(0.463_647_609_000_806_1, 0.463_647_6),
            T::pick(0.785_398_163_397_448_3, 0.785_398_2),
            T::pick(0.982_793_723_247_329, 0.982_793_75),
            T::pick(1.570_796_326_794_896_6, 1.570_796_4),
        ];
        let low = [
            T::ZERO,
            T::pick(2.269_877_745_296_168_7e-17, 5.012_158_7e-9),
            T::pick(3.061_616_997_868_383e-17, -2.185_569_4e-8),
            T::pick(1.390_331_103_123_099_8e-17, -2.513_142_4e-8),
            T::pick(6.123_233_995_736_766e-17, -4.371_138_8e-8),
        ];
        let r = self.tangent;
        let z = r * r;
        entry(self.within, high) + (r + (r * z * z.polynomial(&ATAN) + entry(self.within, low)))
    }

    #[inline(always)]
    fn degrees(self) -> T {
        let high = [
            T::ZERO,
            T::pick(26.565_051_177_077_99, 26.565_052),
            T::of(45.0),
            T::pick(56.309_932_474_020_215, 56.309_933),
            T::of(90.0),
        ];
        let low = [
            T::ZERO,
            T::pick(-6.673_432_494_950_659e-16, -8.553_927e-7),
            T::ZERO,
            T::pick(-1.867_705_613_655_168e-15, -2.347_200_2e-7),
            T::ZERO,
        ];
        // 180/π is split so that its head times the remainder's head is exact.
        let k1 = T::pick(57.295_779_228_210_45, 57.281_25);
        let k2 = T::pick(2.848_718_716_580_481_4e-7, 0.014_529_513);
        let r = self.tangent;
        let z = r * r;
        let (head, tail) = r.split();
        let curve = r * z * z.polynomial(&ATAN) * (k1 + k2);
        let small = curve + (tail * k1 + r * k2) + entry(self.within, low);
        entry(self.within, high) + (head * k1 + small)
    }
}

/// The entry of the table that belongs to the base angle.
#[inline(always)]
fn entry<T: Copy>(within: [bool; 4], [t0, t1, t2, t3, t4]: [T; 5]) -> T {
    let [first, second, third, fourth] = within;
    select(first, t0, select(second, t1, select(third, t2, select(fourth, t3, t4))))
}
