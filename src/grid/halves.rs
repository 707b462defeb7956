//! Angles by repeated halves, exactly.

use crate::Real;

/// In which of 2ᵏ equal parts of [−half, half) an angle in degrees lies; in the last of them from there on.
///
/// By whole numbers: no step rounds, and a boundary belongs to the part above it.
pub(super) fn part<T: Real>(angle: T, half: u8, bits: u8) -> u32 {
    // 2⁹⁶ parts of a degree, rounded down. Below 2⁻⁹⁶ there is only a sign.
    let size = angle.abs();
    let whole = size.floor().unsigned_abs();
    let mut rest = size - T::whole(whole.into());
    let mut fixed = u128::from(whole);
    for _ in 0..4 {
        rest *= T::of(16_777_216.0);
        let next = rest.floor().unsigned_abs();
        rest -= T::whole(next.into());
        fixed = fixed << 24 | u128::from(next);
    }
    let middle = u128::from(half) << 96;
    let mut left = if angle < T::ZERO {
        middle.saturating_sub(fixed).saturating_sub((rest > T::ZERO).into())
    } else {
        middle.saturating_add(fixed)
    };
    let all = middle << 1;
    left = left.min(all - 1);
    let mut part = 0;
    for _ in 0..bits {
        left <<= 1;
        let upper = left >= all;
        left -= if upper { all } else { 0 };
        part = part << 1 | u32::from(upper);
    }
    part
}

/// A longitude for [`part`]: 180 is −180.
pub(super) fn eastern<T: Real>(lon: T) -> T {
    if lon == T::of(180.0) { -lon } else { lon }
}

/// Where a boundary lies, in degrees: so many parts of 2ᵏ, or halves of parts, above −half. One rounding.
pub(super) fn boundary<T: Real>(parts: i64, half: u8, bits: u8) -> T {
    let all = 1_i64 << bits;
    let scaled = parts * 2 * i64::from(half) - i64::from(half) * all;
    let size = T::whole(scaled.unsigned_abs()) / T::whole(all.unsigned_abs());
    if scaled < 0 { -size } else { size }
}
