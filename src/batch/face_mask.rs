use crate::Real;
use crate::math::select;

/// A face as the results of comparisons. They are as wide as the coordinates, so that axes are chosen by
/// masks, many points at a time; [`Face::to_local`](crate::cube::Face::to_local) looks them up in a table.
#[derive(Clone, Copy)]
pub(super) struct FaceMask<T> {
    /// Top or bottom.
    polar: bool,
    /// Right or left.
    sideways: bool,
    /// 1 or −1, the sign of the outward axis.
    sign: T,
}

impl<T: Real> FaceMask<T> {
    /// The face of a direction: top or bottom if `polar`, else a side face.
    #[inline(always)]
    pub(super) fn toward(polar: bool, [x, y, z]: [T; 3]) -> Self {
        let sideways = y.abs() >= x.abs();
        Self {
            polar,
            sideways,
            sign: T::ONE.copysign(select(polar, z, select(sideways, y, x))),
        }
    }

    /// The face's number.
    #[inline(always)]
    pub(super) fn number(self) -> T {
        let half = T::of(0.5);
        select(
            self.polar,
            T::of(4.5) - half * self.sign,
            select(self.sideways, T::of(2.0), T::ONE) - self.sign,
        )
    }

    /// The face with a number.
    #[inline(always)]
    pub(super) fn of(number: T) -> Self {
        let polar = number > T::of(3.5);
        Self {
            polar,
            sideways: (number - T::of(2.0)).abs() == T::ONE,
            sign: T::ONE.copysign(select(polar, T::of(4.5), T::of(1.5)) - number),
        }
    }

    /// As [`Face::to_local`](crate::cube::Face::to_local).
    #[inline(always)]
    pub(super) fn to_local(self, [x, y, z]: [T; 3]) -> [T; 3] {
        [
            select(self.polar, y, self.sign * select(self.sideways, -x, y)),
            select(self.polar, self.sign * -x, z),
            self.sign * select(self.polar, z, select(self.sideways, y, x)),
        ]
    }

    /// As [`Face::to_earth`](crate::cube::Face::to_earth).
    #[inline(always)]
    pub(super) fn to_earth(self, [right, up, outward]: [T; 3]) -> [T; 3] {
        [
            self.sign * select(self.polar, -up, select(self.sideways, -right, outward)),
            select(self.polar, right, self.sign * select(self.sideways, outward, right)),
            select(self.polar, self.sign * outward, up),
        ]
    }
}
