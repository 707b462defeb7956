use super::minimax::ATAN;
use super::{descent, either, halves, max, min, mirrored, negated, select};
use crate::Real;

/// Returns the arc tangent of `x` in radians, in [−π/2, π/2].
///
/// The error is below 0.85 ulp for finite `x`. The arc tangent of an infinity is NaN.
///
/// ```
/// assert_eq!(terrella::math::atan(1.0_f64), core::f64::consts::FRAC_PI_4);
/// ```
#[must_use]
#[inline(always)]
pub fn atan<T: Real>(x: T) -> T {
    radians(x, T::ONE)
}

/// The angle from the x axis to the point (x, y) in radians, for |y| ≤ x and x far from the ends of the scalar's
/// range, with the error of [`atan2`].
#[inline(always)]
pub(crate) fn atan2_eighth<T: Real>(y: T, x: T) -> T {
    let (high, small) = Reduced::of(x, y.abs(), T::ONE, T::ONE).base_and_rest();
    (high + small).copysign(y)
}

/// Returns the angle from the x axis to the point (x, y) in radians, in [−π, π].
///
/// The error is below 0.85 ulp for finite coordinates of any size. Signs of zero count as for `f64::atan2`:
/// the angle of (0, 0) is 0, of (−0, 0) it is π. The result is NaN if a coordinate is infinite or NaN.
///
/// ```
/// assert_eq!(terrella::math::atan2(1.0_f64, -1.0), 0.75 * core::f64::consts::PI);
/// ```
#[must_use]
#[inline(always)]
pub fn atan2<T: Real>(y: T, x: T) -> T {
    radians(y, x)
}

/// Returns the angle from the x axis to the point (x, y) in degrees, in [−180, 180].
///
/// The error is below 0.85 ulp; angles on the axes and the diagonals are exact. Signs of zero, infinities and
/// NaN have the same effect as for [`atan2`].
///
/// ```
/// assert_eq!(terrella::math::atan2_degrees(-1.0_f32, 1.0), -45.0);
/// assert_eq!(terrella::math::atan2_degrees(0.0_f64, -1.0), 180.0);
/// ```
#[must_use]
#[cfg_attr(not(small), inline(always))]
pub fn atan2_degrees<T: Real>(y: T, x: T) -> T {
    let reduced = Reduced::new(y, x);
    let (high, small) = reduced.degrees();
    reduced.opened((high, small), (T::of(90.0), T::ZERO)).copysign(y)
}

/// [`atan2_degrees`], turned away from y = 0 by a small angle in radians: rounded once.
///
/// The larger coordinate must be far from the ends of the scalar's range; x ≥ 0, or the small angle 0.
#[cfg_attr(not(small), inline(always))]
pub(crate) fn turned_degrees<T: Real>(y: T, x: T, turn: T) -> T {
    let reduced = Reduced::of_moderate(y, x);
    let (high, small) = reduced.degrees();
    let turn = T::of(180.0 / core::f64::consts::PI) * turn;
    let small = small + reduced.flat * turn;
    reduced.opened((high, small), (T::of(90.0), T::ZERO)).copysign(y)
}

/// The angle from the x axis to the point (x, y), y ≥ 0: a multiple of 45° as a count, and the rest in
/// radians, at most π/8 and within 1.5 ulp.
///
/// It takes half the arithmetic of [`atan2`]. Squares of the coordinates must be normal numbers; (0, 0) gives
/// 0.
#[cfg_attr(not(small), inline(always))]
pub(crate) fn octant<T: Real>(y: T, x: T) -> (T, T) {
    let width = x.abs();
    let (low, high) = (min(y, width), max(width, y));
    let middle = either(low > high * T::of(core::f64::consts::SQRT_2 - 1.0), T::ONE);
    let least = T::pick(1e-300, 1e-37);
    let tangent = (low - middle * high) / max(high + middle * low, least);
    let z = tangent * tangent;
    let curve = halves(z, T::terms(ATAN.f64.len(), ATAN.f32.len()), |i| {
        T::coefficient(&ATAN, i)
    });
    let rest = tangent + tangent * z * curve;
    let (steep, back) = (y > width, x < T::ZERO);
    let eighths = mirrored(back, T::of(4.0), mirrored(steep, T::of(2.0), middle));
    (eighths, negated(steep != back, rest))
}

/// The same angle in radians, as a sum of two numbers.
#[inline(always)]
pub(crate) fn octant_radians<T: Real>(y: T, x: T) -> (T, T) {
    let (eighths, rest) = octant(y, x);
    // π/4 in two parts, the first so short that four times it is exact.
    let high = eighths * T::pick(core::f64::consts::FRAC_PI_4, 1_647_099.0 / 2_097_152.0);
    (
        high,
        eighths * T::pick(3.061_616_997_868_383e-17, 1.569_582_4e-7) + rest,
    )
}

/// The same angle in degrees.
#[inline(always)]
pub(crate) fn octant_degrees<T: Real>(y: T, x: T) -> T {
    let (eighths, rest) = octant(y, x);
    eighths * T::of(45.0) + rest * T::of(180.0 / core::f64::consts::PI)
}

#[cfg_attr(not(small), inline(always))]
fn radians<T: Real>(y: T, x: T) -> T {
    Reduced::new(y, x).radians().copysign(y)
}

/// An angle between an axis and a diagonal, as the sum of a base angle, whose tangent is 0, ½ or 1, and a
/// remainder, whose tangent is at most 7/16 in size: fdlibm's reduction, with one division for all.
struct Reduced<T> {
    /// −1 if the angle is from the y axis, otherwise 1.
    flat: T,
    /// 1 or −1, the sign of x.
    side: T,
    /// 1 or 0: whether the base angle is at least the second, and the third. A factor of 0 or 1 chooses
    /// without a branch on any machine.
    beyond: [T; 2],
    tangent: T,
    /// What to add to the tangent.
    lost: T,
}

impl<T: Real> Reduced<T> {
    #[inline(always)]
    fn new(y: T, x: T) -> Self {
        let side = T::ONE.copysign(x);
        let (y, x) = (y.abs(), x.abs());
        // In this order a NaN on either side is one of the two.
        let (larger, smaller) = (max(x, y), min(y, x));
        // Far from the ends of the scalar's range: 2^±200 (2^±40) brings there what is not.
        let grow = T::pick(1.606_938_044_258_990_3e60, 1.099_511_6e12);
        let shrink = T::pick(6.223_015_277_861_142e-61, 9.094_947e-13);
        let scale = select(
            larger < T::pick(1e-200, 1e-20),
            grow,
            select(larger > T::pick(1e200, 1e20), shrink, T::ONE),
        );
        Self::of(larger * scale, smaller * scale, descent(y, x), side)
    }

    /// For coordinates of which the larger is far from the ends of the scalar's range.
    #[inline(always)]
    fn of_moderate(y: T, x: T) -> Self {
        let side = T::ONE.copysign(x);
        let (y, x) = (y.abs(), x.abs());
        Self::of(max(x, y), min(y, x), descent(y, x), side)
    }

    #[inline(always)]
    fn of(larger: T, smaller: T, flat: T, side: T) -> Self {
        let beyond = [
            either(smaller > larger * T::of(7.0 / 16.0), T::ONE),
            either(smaller > larger * T::of(11.0 / 16.0), T::ONE),
        ];
        let base = (beyond[0] + beyond[1]) * T::of(0.5);
        let numerator = smaller - larger * base;
        let denominator = larger + smaller * base;
        let inverse = T::ONE / (denominator + either(larger == T::ZERO, T::ONE));
        let tangent = numerator * inverse;
        // What the roundings lost: for a small angle it would be half of the error and more.
        let (th, tl) = tangent.split();
        let (dh, dl) = denominator.split();
        let product = tangent * denominator;
        let rounding = ((th * dh - product) + th * dl + tl * dh) + tl * dl;
        Self {
            flat,
            side,
            beyond,
            tangent,
            lost: ((numerator - product) - rounding) * inverse,
        }
    }

    /// 0 or one of two numbers, by the base angle. The numbers are within a factor of two of each other, or
    /// the second is 0.
    #[inline(always)]
    fn base(&self, second: T, third: T) -> T {
        self.beyond[0] * second + self.beyond[1] * (third - second)
    }

    /// The base angle and the rest in radians.
    #[inline(always)]
    fn base_and_rest(&self) -> (T, T) {
        let [eighth, eighth_low] = Self::eighth();
        let high = self.base(T::pick(0.463_647_609_000_806_1, 0.463_647_6), eighth);
        let low = self.base(T::pick(2.269_877_745_296_168_7e-17, 5.012_158_7e-9), eighth_low);
        let r = self.tangent;
        let z = r * r;
        (high, r + (r * z * z.polynomial(&ATAN) + (self.lost + low)))
    }

    /// π/4 and its rounding error.
    #[inline(always)]
    fn eighth() -> [T; 2] {
        [
            T::pick(core::f64::consts::FRAC_PI_4, core::f32::consts::FRAC_PI_4),
            T::pick(3.061_616_997_868_383e-17, -2.185_569_4e-8),
        ]
    }

    /// The angle from the x axis to the point in radians, in [0, π].
    #[inline(always)]
    fn radians(self) -> T {
        let [eighth, eighth_low] = Self::eighth();
        let two = T::of(2.0);
        self.opened(self.base_and_rest(), (two * eighth, two * eighth_low))
    }

    /// The base angle and the rest in degrees.
    #[inline(always)]
    fn degrees(&self) -> (T, T) {
        let high = self.base(T::pick(26.565_051_177_077_99, 26.565_052), T::of(45.0));
        let low = self.base(T::pick(-6.673_432_494_950_659e-16, -8.553_927e-7), T::ZERO);
        // 180/π is split so that its head times the remainder's head is exact.
        let k1 = T::pick(57.295_779_228_210_45, 57.281_25);
        let k2 = T::pick(2.848_718_716_580_481_4e-7, 0.014_529_513);
        let r = self.tangent;
        let z = r * r;
        let (head, tail) = r.split();
        let curve = r * z * z.polynomial(&ATAN) * (k1 + k2);
        let small = head * k1 + (curve + (tail * k1 + r * k2 + (self.lost * k1 + low)));
        (high, small)
    }

    /// The angle from the x axis to the point, in [0, π]; rounded once.
    #[inline(always)]
    fn opened(&self, (high, small): (T, T), (quarter, quarter_low): (T, T)) -> T {
        let sign = self.flat * self.side;
        // From 0, a quarter or half of the circle.
        let quarters = T::ONE - T::of(0.5) * (self.side + sign);
        let from = quarter * quarters;
        let signed = sign * high;
        let angle = from + signed;
        let lost = (from - angle) + signed;
        angle + ((lost + quarter_low * quarters) + sign * small)
    }
}
