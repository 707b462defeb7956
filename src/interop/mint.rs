//! [`Direction`], [`Ecef`], [`Enu`] and [`Ned`] to and from mint's vectors and points; the axes of a
//! [`LocalFrame`] as a matrix.

use mint::{ColumnMatrix3, Point3, Vector3};

use crate::{Direction, Ecef, Enu, InvalidDirection, InvalidEcef, LocalFrame, Ned, Real};

impl<T: Real> From<Direction<T>> for Vector3<T> {
    fn from(direction: Direction<T>) -> Self {
        direction.to_array().into()
    }
}

impl<T: Real> TryFrom<Vector3<T>> for Direction<T> {
    type Error = InvalidDirection<T>;

    fn try_from(vector: Vector3<T>) -> Result<Self, Self::Error> {
        Self::new(vector.x, vector.y, vector.z)
    }
}

macro_rules! positions {
    ($($vector:ident),*) => {$(
        impl<T: Real> From<Ecef<T>> for $vector<T> {
            fn from(point: Ecef<T>) -> Self {
                point.to_array().into()
            }
        }

        impl<T: Real> TryFrom<$vector<T>> for Ecef<T> {
            type Error = InvalidEcef<T>;

            fn try_from(vector: $vector<T>) -> Result<Self, Self::Error> {
                Self::new(vector.x, vector.y, vector.z)
            }
        }

        impl<T: Real> From<Enu<T>> for $vector<T> {
            /// x is east, y north, z up.
            fn from(Enu { east, north, up }: Enu<T>) -> Self {
                [east, north, up].into()
            }
        }

        impl<T: Real> From<$vector<T>> for Enu<T> {
            /// x is east, y north, z up.
            fn from($vector { x: east, y: north, z: up }: $vector<T>) -> Self {
                Self { east, north, up }
            }
        }

        impl<T: Real> From<Ned<T>> for $vector<T> {
            /// x is north, y east, z down.
            fn from(Ned { north, east, down }: Ned<T>) -> Self {
                [north, east, down].into()
            }
        }

        impl<T: Real> From<$vector<T>> for Ned<T> {
            /// x is north, y east, z down.
            fn from($vector { x: north, y: east, z: down }: $vector<T>) -> Self {
                Self { north, east, down }
            }
        }
    )*};
}

positions!(Vector3, Point3);

impl<T: Real> From<&LocalFrame<T>> for ColumnMatrix3<T> {
    /// The columns are east, north and up in Earth axes: the matrix rotates from the frame's axes to those of
    /// the Earth.
    fn from(frame: &LocalFrame<T>) -> Self {
        Self {
            x: frame.east().into(),
            y: frame.north().into(),
            z: frame.up().into(),
        }
    }
}
