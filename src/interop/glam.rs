//! [`Direction`], [`Ecef`], [`Enu`] and [`Ned`] to and from glam's vectors; the axes of a [`LocalFrame`] as a
//! matrix.

use crate::{Direction, Ecef, Enu, InvalidDirection, InvalidEcef, LocalFrame, Ned};

macro_rules! vectors {
    ($($scalar:ident $vector:ident),*) => {$(
        impl From<Direction<$scalar>> for glam::$vector {
            fn from(direction: Direction<$scalar>) -> Self {
                Self::from_array(direction.to_array())
            }
        }

        impl TryFrom<glam::$vector> for Direction<$scalar> {
            type Error = InvalidDirection<$scalar>;

            fn try_from(vector: glam::$vector) -> Result<Self, Self::Error> {
                Self::new(vector.x, vector.y, vector.z)
            }
        }

        impl From<Ecef<$scalar>> for glam::$vector {
            fn from(point: Ecef<$scalar>) -> Self {
                Self::from_array(point.to_array())
            }
        }

        impl TryFrom<glam::$vector> for Ecef<$scalar> {
            type Error = InvalidEcef<$scalar>;

            fn try_from(vector: glam::$vector) -> Result<Self, Self::Error> {
                Self::new(vector.x, vector.y, vector.z)
            }
        }

        impl From<Enu<$scalar>> for glam::$vector {
            /// x is east, y north, z up.
            fn from(Enu { east, north, up }: Enu<$scalar>) -> Self {
                Self::new(east, north, up)
            }
        }

        impl From<glam::$vector> for Enu<$scalar> {
            /// x is east, y north, z up.
            fn from(vector: glam::$vector) -> Self {
                let [east, north, up] = vector.to_array();
                Self { east, north, up }
            }
        }

        impl From<Ned<$scalar>> for glam::$vector {
            /// x is north, y east, z down.
            fn from(Ned { north, east, down }: Ned<$scalar>) -> Self {
                Self::new(north, east, down)
            }
        }

        impl From<glam::$vector> for Ned<$scalar> {
            /// x is north, y east, z down.
            fn from(vector: glam::$vector) -> Self {
                let [north, east, down] = vector.to_array();
                Self { north, east, down }
            }
        }
    )*};
}

vectors!(f32 Vec3, f32 Vec3A, f64 DVec3);

macro_rules! matrices {
    ($($scalar:ident $matrix:ident),*) => {$(
        impl From<&LocalFrame<$scalar>> for glam::$matrix {
            /// The columns are east, north and up in Earth axes: the matrix rotates from the frame's axes to
            /// those of the Earth.
            fn from(frame: &LocalFrame<$scalar>) -> Self {
                Self::from_cols(frame.east().into(), frame.north().into(), frame.up().into())
            }
        }
    )*};
}

matrices!(f32 Mat3, f32 Mat3A, f64 DMat3);
