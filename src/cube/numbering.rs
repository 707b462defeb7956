use super::{Face, FacePoint, InvalidFace};
use crate::Real;
use crate::cube::InvalidFacePoint;

/// The face numbers and axes of another system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Numbering {
    /// Google's S2: faces 0 to 5 outward along X, Y, Z, −X, −Y, −Z.
    ///
    /// Face n is tile n + 1 of FV3 (the models of GFDL and GEOS), with the same axes, before FV3 turns its cube 10°
    /// to the west; and it is face n + 1 of MITgcm's cubed sphere.
    #[doc(alias("FV3", "GEOS", "GFDL", "MITgcm"))]
    S2,
    /// OpenGL's cube maps: +X, −X, +Y, −Y, +Z, −Z, with s to the right and t downward. OpenGL's axes are the
    /// usual ones of a renderer: its x is the Earth's Y, its y the north pole, its z the Earth's X.
    OpenGl,
    /// FITS WCS (Calabretta & Greisen 2002): 0 north, 1 to 4 around the equator from longitude 0, 5 south.
    Fits,
    /// The picture of three by two faces of equi-angular cube maps in video, as FFmpeg's `v360=eac` has it: face n
    /// is at column n mod 3 and row n / 3 from above. Left, front and right stand upright in the first row; below
    /// them bottom, back and top are turned, so that in a row neighbours share their edge.
    Eac,
}

impl Numbering {
    /// The number of a face, and the counter-clockwise quarter turns from this crate's axes to the other
    /// system's.
    const fn entry(self, face: Face) -> (u8, u8) {
        match (self, face) {
            (Self::S2, Face::Front) => (0, 0),
            (Self::S2, Face::Right) => (1, 0),
            (Self::S2, Face::Back) => (3, 1),
            (Self::S2, Face::Left) => (4, 1),
            (Self::S2, Face::Top) => (2, 3),
            (Self::S2, Face::Bottom) => (5, 0),
            (Self::OpenGl, Face::Front) => (4, 0),
            (Self::OpenGl, Face::Right) => (0, 0),
            (Self::OpenGl, Face::Back) => (5, 0),
            (Self::OpenGl, Face::Left) => (1, 0),
            (Self::OpenGl, Face::Top) => (2, 0),
            (Self::OpenGl, Face::Bottom) => (3, 0),
            (Self::Fits, Face::Front) => (1, 0),
            (Self::Fits, Face::Right) => (2, 0),
            (Self::Fits, Face::Back) => (3, 0),
            (Self::Fits, Face::Left) => (4, 0),
            (Self::Fits, Face::Top) => (0, 0),
            (Self::Fits, Face::Bottom) => (5, 0),
            (Self::Eac, Face::Front) => (1, 0),
            (Self::Eac, Face::Right) => (2, 0),
            (Self::Eac, Face::Back) => (4, 3),
            (Self::Eac, Face::Left) => (0, 0),
            (Self::Eac, Face::Top) => (5, 1),
            (Self::Eac, Face::Bottom) => (3, 1),
        }
    }

    /// The counter-clockwise quarter turns from this crate's axes to the other system's.
    #[inline(always)]
    pub(crate) const fn turns(self, face: Face) -> u8 {
        self.entry(face).1
    }

    /// The column and row of a square along this numbering's axes, where the last column and row is `last`.
    #[inline(always)]
    pub(crate) const fn to_square(self, face: Face, last: u32, square: [u32; 2]) -> [u32; 2] {
        let [i, j] = turned_square(square, last, self.turns(face));
        [i, if matches!(self, Self::OpenGl) { last - j } else { j }]
    }

    /// The column and row of a square along this crate's axes: the inverse of `to_square`.
    #[inline(always)]
    pub(crate) const fn square_of(self, face: Face, last: u32, [i, j]: [u32; 2]) -> [u32; 2] {
        let up = if matches!(self, Self::OpenGl) { last - j } else { j };
        turned_square([i, up], last, 4 - self.turns(face))
    }

    /// Returns this numbering's number of a face, in 0 to 5.
    ///
    /// ```
    /// use terrella::cube::{Face, Numbering};
    /// assert_eq!(Numbering::S2.number(Face::Top), 2);
    /// assert_eq!(Numbering::OpenGl.number(Face::Front), 4);
    /// assert_eq!(Numbering::Fits.face(0), Ok(Face::Top));
    /// ```
    #[must_use]
    pub const fn number(self, face: Face) -> u8 {
        self.entry(face).0
    }

    /// Returns the face of a number in 0 to 5.
    ///
    /// # Errors
    /// [`InvalidFace`] for a number above 5.
    pub const fn face(self, number: u8) -> Result<Face, InvalidFace> {
        let mut faces: &[Face] = &Face::ALL;
        while let [face, rest @ ..] = faces {
            if self.number(*face) == number {
                return Ok(*face);
            }
            faces = rest;
        }
        Err(InvalidFace(number))
    }

    /// Converts a point to this numbering. Returns the number of the face, and the coordinates in [−1, 1]
    /// along its axes.
    ///
    /// ```
    /// use terrella::cube::{Face, FacePoint, Numbering};
    /// let p = FacePoint::new(Face::Top, 0.25, 0.5).unwrap();
    /// assert_eq!(Numbering::S2.to_point(p), (2, 0.5, -0.25));
    /// assert_eq!(Numbering::OpenGl.to_point(p), (2, 0.25, -0.5));
    /// ```
    #[must_use]
    pub fn to_point<T: Real>(self, point: FacePoint<T>) -> (u8, T, T) {
        let (number, turns) = self.entry(point.face());
        let (x, y) = turned(point.x(), point.y(), turns);
        (number, x, if matches!(self, Self::OpenGl) { -y } else { y })
    }

    /// Converts a point from this numbering: the number of the face, and the coordinates in [−1, 1] along its
    /// axes.
    ///
    /// # Errors
    /// [`InvalidNumbered`] for a number above 5 or a coordinate outside [−1, 1].
    pub fn from_point<T: Real>(self, number: u8, x: T, y: T) -> Result<FacePoint<T>, InvalidNumbered<T>> {
        let face = self.face(number).map_err(InvalidNumbered::Face)?;
        let up = if matches!(self, Self::OpenGl) { -y } else { y };
        let (right, up) = turned(x, up, 4 - self.entry(face).1);
        FacePoint::new(face, right, up).map_err(|_| InvalidNumbered::Point(InvalidFacePoint { x, y }))
    }
}

/// (x, y) turned counter-clockwise by quarter circles: 0, 1 or 3 of them, because no numbering needs 2.
fn turned<T: Real>(x: T, y: T, quarters: u8) -> (T, T) {
    match quarters {
        1 => (-y, x),
        3 => (y, -x),
        _ => (x, y),
    }
}

/// The column and row of a square, turned in the same way.
const fn turned_square([i, j]: [u32; 2], last: u32, quarters: u8) -> [u32; 2] {
    match quarters {
        1 => [last - j, i],
        3 => [j, last - i],
        _ => [i, j],
    }
}

/// Why [`Numbering::from_point`] refused a point.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidNumbered<T> {
    /// The number of the face is above 5.
    Face(InvalidFace),
    /// A coordinate is outside [−1, 1].
    Point(InvalidFacePoint<T>),
}

impl<T: core::fmt::Debug> core::fmt::Display for InvalidNumbered<T> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Face(face) => face.fmt(f),
            Self::Point(point) => point.fmt(f),
        }
    }
}

impl<T: core::fmt::Debug> core::error::Error for InvalidNumbered<T> {}
