//! [`CubeProjection`] and its members, one file each; [`Projection`] lists them and picks one at run time.

use core::fmt;
use core::str::FromStr;

use super::{Face, FacePoint};
use crate::math::{max, min, sin_cos_degrees};
use crate::name::unknown;
use crate::{Direction, Real};

mod algebraic;
mod balanced;
mod cartesian;
mod cobe;
mod conformal;
mod healpix;
mod outerra;
mod quadrilateralized;
mod s2_quadratic;
mod square;
mod tangent;
mod vertex;

pub use cobe::QuadCube;

/// A map between the sphere and the six faces of a cube.
///
/// To add one, implement [`forward`](Self::forward) and [`inverse`](Self::inverse); all else follows, at both precisions.
///
/// ```
/// use terrella::cube::{CubeProjection, Face};
/// use terrella::{Direction, Real};
///
/// #[derive(Clone, Copy)]
/// struct Gnomonic;
///
/// impl CubeProjection for Gnomonic {
///     fn forward<T: Real>(&self, _: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
///         [right / outward, up / outward]
///     }
///     fn inverse<T: Real>(&self, _: Face, [x, y]: [T; 2]) -> [T; 3] {
///         let length = (x * x + y * y + T::ONE).sqrt();
///         [x / length, y / length, T::ONE / length]
///     }
/// }
///
/// let point = Gnomonic.project(Direction::new(2.0, 1.0, 0.0)?);
/// assert_eq!((point.face(), point.x(), point.y()), (Face::Front, 0.5, 0.0));
/// # Ok::<(), terrella::InvalidDirection<f64>>(())
/// ```
pub trait CubeProjection: Copy {
    /// From a vector in the face's frame (right, up, outward), of unit length but for rounding, to (x, y).
    ///
    /// Only the direction of the vector counts: no result depends on the rounding of its length.
    #[must_use]
    fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2];

    /// From (x, y) in [−1, 1]² to the unit vector in the face's frame (right, up, outward).
    #[must_use]
    fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3];

    /// Whether a direction is mapped to the top or the bottom: where z is the largest component, unless the projection cuts its caps
    /// otherwise.
    #[must_use]
    #[inline(always)]
    fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
        let [x, y, z] = direction.to_array();
        (z.abs() > y.abs()) & (z.abs() >= x.abs())
    }

    /// The face that a direction is mapped to: the top or the bottom, or the side of its longitude; of equal |x| and |y| the axis y.
    #[must_use]
    #[inline(always)]
    fn face<T: Real>(&self, direction: Direction<T>) -> Face {
        Face::of(self.is_polar(direction), direction)
    }

    /// From a direction to its place on the cube.
    #[must_use]
    #[inline(always)]
    fn project<T: Real>(&self, direction: Direction<T>) -> FacePoint<T> {
        let face = self.face(direction);
        let [x, y] = on_face(self.forward(face, face.to_local(direction.to_array())));
        FacePoint::within(face, x, y)
    }

    /// Whether a latitude and a longitude are all that the projection asks for: then a [`CubeMap`](super::CubeMap) goes by
    /// [`project_place`](Self::project_place) and [`unproject_place`](Self::unproject_place), and not through directions.
    const TAKES_PLACES: bool = false;

    /// From sine and cosine of a latitude on the sphere, and a longitude in [−180, 180] degrees, to the face's number, x and y.
    ///
    /// ```
    /// use terrella::cube::{CubeProjection, Face, Healpix};
    /// let (sin, cos) = (0.6, 0.8);
    /// let [number, x, y] = Healpix.project_place((sin, cos), 99.0);
    /// assert_eq!((number, x, y), (f64::from(Face::Right.index()), 0.2, 1.5 * sin));
    /// ```
    #[must_use]
    #[inline(always)]
    fn project_place<T: Real>(&self, latitude: (T, T), lon: T) -> [T; 3] {
        let point = self.project(Direction::from_angles(latitude, sin_cos_degrees(lon)));
        [T::from_byte(point.face().index()), point.x(), point.y()]
    }

    /// From a face's number, x and y to sine and cosine of the latitude on the sphere, and the longitude in [−180, 180] degrees.
    ///
    /// ```
    /// use terrella::cube::{CubeProjection, Healpix};
    /// assert_eq!(Healpix.unproject_place([1.0, 0.2, 0.0]), ((0.0, 1.0), 99.0));
    /// ```
    #[must_use]
    #[inline(always)]
    fn unproject_place<T: Real>(&self, [number, x, y]: [T; 3]) -> ((T, T), T) {
        let direction = self.unproject(FacePoint::within(Face::of_number(number), x, y));
        ((direction.z(), direction.cos_lat()), direction.lon())
    }

    /// Does a task with the projection itself: one that stands for another hands that on, so that a loop chooses once.
    #[inline(always)]
    fn with<W: ProjectionTask>(self, task: W) -> W::Output {
        task.run(self)
    }

    /// From a place on the cube to its direction.
    #[must_use]
    #[inline(always)]
    fn unproject<T: Real>(&self, point: FacePoint<T>) -> Direction<T> {
        let local = self.inverse(point.face(), [point.x(), point.y()]);
        let [x, y, z] = point.face().to_earth(local);
        Direction::within(x, y, z)
    }
}

/// What is to be done with a projection of any type: see [`CubeProjection::with`].
///
/// ```
/// use terrella::cube::{CubeProjection, Projection, ProjectionTask};
///
/// struct Size;
///
/// impl ProjectionTask for Size {
///     type Output = usize;
///     fn run<P: CubeProjection>(self, _: P) -> usize {
///         size_of::<P>()
///     }
/// }
///
/// assert_eq!(Projection::Vertex.with(Size), 0);
/// ```
pub trait ProjectionTask {
    /// What comes of it.
    type Output;

    /// Does it.
    fn run<P: CubeProjection>(self, projection: P) -> Self::Output;
}

macro_rules! projections {
    ($($module:ident::$variant:ident $name:literal,)*) => {
        $(pub use $module::$variant;)*

        /// The projections of this crate, to pick one at run time.
        ///
        /// Code that knows its projection names the type instead, and links nothing of the others.
        ///
        /// ```
        /// use terrella::{Direction, cube::{CubeProjection, Projection}};
        /// let projection: Projection = "quadrilateralized".parse().unwrap();
        /// let p = projection.project(Direction::new(0.0, 0.0, 1.0).unwrap());
        /// assert_eq!((p.x(), p.y()), (0.0, 0.0));
        /// ```
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
        #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
        #[non_exhaustive]
        pub enum Projection {
            $(
                #[doc = concat!("[`", stringify!($variant), "`](struct@", stringify!($variant), "), \"", $name, "\".")]
                $variant,
            )*
        }

        impl Projection {
            /// All of them.
            pub const ALL: &[Self] = &[$(Self::$variant),*];

            /// The name, in lower case.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$variant => $name,)*
                }
            }
        }

        // Not inlined: each function is as long as all projections together.
        impl CubeProjection for Projection {
            fn forward<T: Real>(&self, face: Face, local: [T; 3]) -> [T; 2] {
                match self {
                    $(Self::$variant => $module::$variant.forward(face, local),)*
                }
            }

            fn inverse<T: Real>(&self, face: Face, point: [T; 2]) -> [T; 3] {
                match self {
                    $(Self::$variant => $module::$variant.inverse(face, point),)*
                }
            }

            fn with<W: ProjectionTask>(self, task: W) -> W::Output {
                match self {
                    $(Self::$variant => task.run($module::$variant),)*
                }
            }

            fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
                match self {
                    $(Self::$variant => $module::$variant.is_polar(direction),)*
                }
            }
        }
    };
}

projections! {
    tangent::Tangential "tangential",
    tangent::Adjusted "adjusted",
    outerra::Outerra "outerra",
    cobe::Cobe "cobe",
    cobe::CobeExact "cobe-exact",
    quadrilateralized::Quadrilateralized "quadrilateralized",
    cartesian::Cartesian "cartesian",
    healpix::Healpix "healpix",
    s2_quadratic::S2Quadratic "s2-quadratic",
    tangent::EquiEdge "equi-edge",
    algebraic::Algebraic "algebraic",
    vertex::Vertex "vertex",
    conformal::Conformal "conformal",
    balanced::Balanced "balanced",
    square::Square "square",
    tangent::Separable "separable",
}

impl fmt::Display for Projection {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

unknown!(UnknownProjection, "projection", Projection::ALL.iter());

impl FromStr for Projection {
    type Err = UnknownProjection;

    fn from_str(name: &str) -> Result<Self, UnknownProjection> {
        Self::ALL
            .iter()
            .copied()
            .find(|p| p.name() == name)
            .ok_or_else(|| UnknownProjection::new(name))
    }
}

/// Coordinates that rounding has not led off the face.
#[inline(always)]
pub(crate) fn on_face<T: Real>(coordinates: [T; 2]) -> [T; 2] {
    coordinates.map(|v| max(min(v, T::ONE), -T::ONE))
}

/// The unit vector of gnomonic coordinates (u, v): one square root, one division.
#[inline(always)]
fn from_gnomonic<T: Real>([u, v]: [T; 2]) -> [T; 3] {
    normalise([u, v, T::ONE])
}

/// The unit vector of a vector near unit length.
///
/// On a cube's edge two components agree; the order of the sum keeps the result the same from both faces.
#[inline(always)]
fn normalise<T: Real>([x, y, z]: [T; 3]) -> [T; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}
