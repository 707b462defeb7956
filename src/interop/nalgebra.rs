//! [`Direction`], [`Ecef`], [`Enu`] and [`Ned`] to and from nalgebra's vectors and points; the axes of a
//! [`LocalFrame`] as a matrix and as a rotation.

use nalgebra::{Matrix3, Point3, Rotation3, UnitVector3, Vector3};

use crate::{Direction, Ecef, Enu, InvalidDirection, InvalidEcef, LocalFrame, Ned, Real};

impl<T: Real> From<Direction<T>> for Vector3<T> {
    fn from(direction: Direction<T>) -> Self {
        direction.to_array().into()
    }
}

impl<T: Real> From<Direction<T>> for UnitVector3<T> {
    fn from(direction: Direction<T>) -> Self {
        Self::new_unchecked(direction.into())
    }
}

impl<T: Real> TryFrom<Vector3<T>> for Direction<T> {
    type Error = InvalidDirection<T>;

    fn try_from(vector: Vector3<T>) -> Result<Self, Self::Error> {
        let [x, y, z] = vector.into();
        Self::new(x, y, z)
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
                let [x, y, z] = vector.into();
                Self::new(x, y, z)
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
            fn from(vector: $vector<T>) -> Self {
                let [east, north, up] = vector.into();
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
            fn from(vector: $vector<T>) -> Self {
                let [north, east, down] = vector.into();
                Self { north, east, down }
            }
        }
    )*};
}

positions!(Vector3, Point3);

impl<T: Real> From<&LocalFrame<T>> for Matrix3<T> {
    /// The columns are east, north and up in Earth axes: the matrix rotates from the frame's axes to those of
    /// the Earth.
    fn from(frame: &LocalFrame<T>) -> Self {
        [frame.east(), frame.north(), frame.up()]
            .map(Direction::to_array)
            .into()
    }
}

impl<T: Real> From<&LocalFrame<T>> for Rotation3<T> {
    /// The rotation from the frame's axes to those of the Earth.
    fn from(frame: &LocalFrame<T>) -> Self {
        Self::from_matrix_unchecked(frame.into())
    }
}
