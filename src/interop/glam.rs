//! [`Direction`] to and from glam's vectors.

use crate::{Direction, InvalidDirection};

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
    )*};
}

vectors!(f32 Vec3, f32 Vec3A, f64 DVec3);
