//! Converts positions to east, north and up of an origin, and back, by a [`LocalFrame`](crate::LocalFrame);
//! also to north, east and down, and to azimuth, elevation and range.

mod offset;
mod place;
mod point;
mod vector;

pub use offset::{enu_to_offset, offset_to_enu};
pub use place::{aer_to_geodetic, enu_to_geodetic, geodetic_to_aer, geodetic_to_enu, geodetic_to_ned, ned_to_geodetic};
pub use point::{from_aer, from_enu, from_ned, to_aer, to_enu, to_ned};
pub use vector::{vector_from_enu, vector_to_enu};

use crate::{Aer, Enu, Ned, Real};

/// Three numbers from an origin: [`Enu`], [`Ned`] or [`Aer`].
trait Axes<T>: From<Enu<T>> + Into<Enu<T>> + Copy {
    fn of(row: [T; 3]) -> Self;

    fn row(self) -> [T; 3];
}

macro_rules! axes {
    ($($name:ident { $a:ident, $b:ident, $c:ident })*) => {$(
        impl<T: Real> Axes<T> for $name<T> {
            #[inline(always)]
            fn of([$a, $b, $c]: [T; 3]) -> Self {
                Self { $a, $b, $c }
            }

            #[inline(always)]
            fn row(self) -> [T; 3] {
                [self.$a, self.$b, self.$c]
            }
        }
    )*};
}

axes! {
    Enu { east, north, up }
    Ned { north, east, down }
    Aer { azimuth, elevation, range }
}

/// The components of an [`Enu`] that is given in other axes.
#[inline(always)]
fn enu<T: Real, A: Axes<T>>(row: [T; 3]) -> Enu<T> {
    A::of(row).into()
}
