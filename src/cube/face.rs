use core::fmt;
use core::str::FromStr;

use super::{CubeProjection, Tangential};
use crate::name::unknown;
use crate::{Direction, Real};

/// A face of the cube. The numbers are those of Dimitrijević, Lambers & Rančić (2016), Table 4.1.
///
/// Every face has a right-handed local frame: right and up as seen from outside, and outward from the centre.
/// In Earth axes (X toward 0° N 0° E, Y toward 0° N 90° E, Z toward the north pole) it is
///
/// | face | centre | right | up | outward |
/// |---|---|---|---|---|
/// | 0 front | 0° N 0° E | Y | Z | X |
/// | 1 right | 0° N 90° E | −X | Z | Y |
/// | 2 back | 0° N 180° E | −Y | Z | −X |
/// | 3 left | 0° N 90° W | X | Z | −Y |
/// | 4 top | north pole | Y | −X | Z |
/// | 5 bottom | south pole | Y | X | −Z |
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
#[repr(u8)]
pub enum Face {
    /// Around 0° N, 0° E.
    Front = 0,
    /// Around 0° N, 90° E.
    Right = 1,
    /// Around 0° N, 180° E.
    Back = 2,
    /// Around 0° N, 90° W.
    Left = 3,
    /// Around the north pole.
    Top = 4,
    /// Around the south pole.
    Bottom = 5,
}

impl Face {
    /// All six faces, in the order of their numbers.
    pub const ALL: [Self; 6] = [
        Self::Front,
        Self::Right,
        Self::Back,
        Self::Left,
        Self::Top,
        Self::Bottom,
    ];

    /// Returns the number, in 0 to 5.
    #[must_use]
    #[inline(always)]
    pub const fn index(self) -> u8 {
        self as u8
    }

    /// Returns the name: `front`, `right`, `back`, `left`, `top` or `bottom`. [`Display`](fmt::Display)
    /// writes it, and [`str::parse`] reads it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Front => "front",
            Self::Right => "right",
            Self::Back => "back",
            Self::Left => "left",
            Self::Top => "top",
            Self::Bottom => "bottom",
        }
    }

    /// Returns the face of a number in 0 to 5.
    ///
    /// # Errors
    /// [`InvalidFace`] for a number above 5.
    #[inline]
    pub const fn from_index(index: u8) -> Result<Self, InvalidFace> {
        match index {
            0 => Ok(Self::Front),
            1 => Ok(Self::Right),
            2 => Ok(Self::Back),
            3 => Ok(Self::Left),
            4 => Ok(Self::Top),
            5 => Ok(Self::Bottom),
            _ => Err(InvalidFace(index)),
        }
    }

    /// The face with a number in 0 to 5, for a number that is known to be one. The choice vectorises.
    #[inline(always)]
    pub(crate) fn of_number<T: Real>(number: T) -> Self {
        Self::numbered(number.to_byte())
    }

    /// The face with a number in 0 to 5, for a byte that is known to be one.
    #[inline(always)]
    pub(crate) const fn numbered(number: u8) -> Self {
        match number {
            0 => Self::Front,
            1 => Self::Right,
            2 => Self::Back,
            3 => Self::Left,
            4 => Self::Top,
            _ => Self::Bottom,
        }
    }

    /// Returns the face through which a ray from the centre of the cube leaves: that of the component with
    /// the largest absolute value. Of equal components, y goes before z, and z before x.
    ///
    /// ```
    /// use terrella::{Direction, cube::Face};
    /// assert_eq!(Face::containing(Direction::new(0.2, 0.1, -0.9)?), Face::Bottom);
    /// # Ok::<(), terrella::InvalidDirection<f64>>(())
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn containing<T: Real>(direction: Direction<T>) -> Self {
        Tangential.face(direction)
    }

    /// The top or bottom face if `polar`, else the side face of the longitude. Where |x| = |y|, it is that of
    /// the axis y.
    #[inline(always)]
    #[allow(clippy::indexing_slicing)] // eight entries for three bits
    pub(crate) fn of<T: Real>(polar: bool, direction: Direction<T>) -> Self {
        use Face::{Back, Bottom, Front, Left, Right, Top};
        const FACES: [Face; 8] = [Front, Back, Right, Left, Top, Bottom, Top, Bottom];
        let [x, y, z] = direction.to_array();
        let sideways = y.abs() >= x.abs();
        let negative = (polar & (z < T::ZERO)) | (!polar & ((sideways & (y < T::ZERO)) | (!sideways & (x < T::ZERO))));
        FACES[usize::from(4 * u8::from(polar) + 2 * u8::from(sideways & !polar) + u8::from(negative)) & 7]
    }

    /// Returns whether this is the top or the bottom face.
    #[must_use]
    #[inline(always)]
    pub const fn is_polar(self) -> bool {
        self as u8 >= 4
    }

    /// Rotates a vector from Earth axes to this face's frame (right, up, outward). Components are exchanged
    /// and negated.
    ///
    /// ```
    /// use terrella::cube::Face;
    /// assert_eq!(Face::Right.to_local([1.0, 2.0, 3.0]), [-1.0, 3.0, 2.0]);
    /// ```
    #[must_use]
    #[inline(always)]
    pub fn to_local<T: Real>(self, [x, y, z]: [T; 3]) -> [T; 3] {
        self.pick(&TO_LOCAL, [x, y, z])
    }

    /// Rotates a vector from this face's frame (right, up, outward) to Earth axes: the inverse of
    /// [`Face::to_local`].
    #[must_use]
    #[inline(always)]
    pub fn to_earth<T: Real>(self, [right, up, outward]: [T; 3]) -> [T; 3] {
        self.pick(&TO_EARTH, [right, up, outward])
    }

    /// The components that a table names, or their negatives. For random faces, a table is faster than a
    /// branch.
    #[inline(always)]
    #[allow(clippy::indexing_slicing)] // as many entries as there are numbers of that many bits
    fn pick<T: Real>(self, table: &[[u8; 3]; 8], [a, b, c]: [T; 3]) -> [T; 3] {
        let signed = [a, b, c, c, -a, -b, -c, -c];
        let [first, second, third] = table[usize::from(self as u8 & 7)];
        [
            signed[usize::from(first & 7)],
            signed[usize::from(second & 7)],
            signed[usize::from(third & 7)],
        ]
    }

    /// Returns the face across an edge, the edge's name there, and how that face's axes are turned.
    ///
    /// ```
    /// use terrella::cube::{Edge, Face};
    /// let beyond = Face::Front.neighbour(Edge::Up);
    /// assert_eq!((beyond.face, beyond.edge, beyond.turns), (Face::Top, Edge::Down, 0));
    /// assert_eq!(Face::Right.neighbour(Edge::Up).edge, Edge::Right);
    /// ```
    #[must_use]
    pub const fn neighbour(self, edge: Edge) -> Neighbour {
        use Edge::{Down, Left, Right, Up};
        let (face, meets) = match (self, edge) {
            (Self::Front, Right) => (Self::Right, Left),
            (Self::Front, Up) => (Self::Top, Down),
            (Self::Front, Left) => (Self::Left, Right),
            (Self::Front, Down) => (Self::Bottom, Up),
            (Self::Right, Right) => (Self::Back, Left),
            (Self::Right, Up) => (Self::Top, Right),
            (Self::Right, Left) => (Self::Front, Right),
            (Self::Right, Down) => (Self::Bottom, Right),
            (Self::Back, Right) => (Self::Left, Left),
            (Self::Back, Up) => (Self::Top, Up),
            (Self::Back, Left) => (Self::Right, Right),
            (Self::Back, Down) => (Self::Bottom, Down),
            (Self::Left, Right) => (Self::Front, Left),
            (Self::Left, Up) => (Self::Top, Left),
            (Self::Left, Left) => (Self::Back, Right),
            (Self::Left, Down) => (Self::Bottom, Left),
            (Self::Top, Right) => (Self::Right, Up),
            (Self::Top, Up) => (Self::Back, Up),
            (Self::Top, Left) => (Self::Left, Up),
            (Self::Top, Down) => (Self::Front, Up),
            (Self::Bottom, Right) => (Self::Right, Down),
            (Self::Bottom, Up) => (Self::Front, Down),
            (Self::Bottom, Left) => (Self::Left, Down),
            (Self::Bottom, Down) => (Self::Back, Down),
        };
        // Unfolded, the two edges coincide: `edge` pointing out is `meets` pointing in.
        let turns = (meets as u8 + 6 - edge as u8) % 4;
        Neighbour {
            face,
            edge: meets,
            turns,
        }
    }

    /// Returns the three faces that meet at a corner of this face, each with that corner's name in its own
    /// frame. This face is the first; the others follow counter-clockwise about the corner as seen from
    /// outside.
    ///
    /// ```
    /// use terrella::cube::{Corner, Face};
    /// let around = Face::Front.corner(Corner::UpRight);
    /// assert_eq!(around.map(|(face, _)| face), [Face::Front, Face::Right, Face::Top]);
    /// ```
    #[must_use]
    pub const fn corner(self, corner: Corner) -> [(Self, Corner); 3] {
        let (first, second) = corner.edges();
        let (a, b) = (self.neighbour(first), self.neighbour(second));
        // Counter-clockwise, edge `first` ends at the corner and edge `second` begins there. On the faces
        // across them it is the other way round.
        [
            (self, corner),
            (a.face, Corner::beginning(a.edge)),
            (b.face, Corner::ending(b.edge)),
        ]
    }
}

/// For each face, the components that are right, up and outward: 0, 1, 2 for X, Y, Z, and 4 more for the
/// negative. The last two rows belong to no face.
const TO_LOCAL: [[u8; 3]; 8] = [
    [1, 2, 0],
    [4, 2, 1],
    [5, 2, 4],
    [0, 2, 5],
    [1, 4, 2],
    [1, 0, 6],
    [0; 3],
    [0; 3],
];

/// For each face, the components that are X, Y and Z: 0, 1, 2 for right, up, outward, and 4 more for the
/// negative.
const TO_EARTH: [[u8; 3]; 8] = [
    [2, 0, 1],
    [4, 2, 1],
    [6, 4, 1],
    [0, 6, 1],
    [5, 0, 2],
    [1, 0, 6],
    [0; 3],
    [0; 3],
];

/// The error for a number above 5, which no face has.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidFace(pub u8);

impl fmt::Display for Face {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

impl FromStr for Face {
    type Err = UnknownFace;

    fn from_str(name: &str) -> Result<Self, UnknownFace> {
        let mut faces = Self::ALL.into_iter();
        faces
            .find(|face| face.name() == name)
            .ok_or_else(|| UnknownFace::new(name))
    }
}

unknown!(UnknownFace, "face", Face::ALL.iter());

impl fmt::Display for InvalidFace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "face {} is not in 0 to 5", self.0)
    }
}

impl core::error::Error for InvalidFace {}

/// An edge of a face, counter-clockwise from x = 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Edge {
    /// x = 1.
    Right = 0,
    /// y = 1.
    Up = 1,
    /// x = −1.
    Left = 2,
    /// y = −1.
    Down = 3,
}

impl Edge {
    /// All four edges, counter-clockwise from x = 1.
    pub const ALL: [Self; 4] = [Self::Right, Self::Up, Self::Left, Self::Down];

    /// The edge of a number modulo 4.
    #[inline(always)]
    pub(crate) const fn turned(number: u8) -> Self {
        match number % 4 {
            0 => Self::Right,
            1 => Self::Up,
            2 => Self::Left,
            _ => Self::Down,
        }
    }
}

/// The face across an edge of a face.
///
/// For linear coordinates (u, v) ∈ [−1, 1]² on both faces: a point (u, v) beyond the edge has, on the
/// neighbour, the coordinates (u, v) − 2e turned counter-clockwise by `turns` quarter circles, where e is the
/// edge's outward unit vector.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Neighbour {
    /// The face across the edge.
    pub face: Face,
    /// The shared edge, as that face calls it.
    pub edge: Edge,
    /// Counter-clockwise quarter turns, 0 to 3, that take this face's unfolded frame to the neighbour's.
    pub turns: u8,
}

/// A corner of a face.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[repr(u8)]
pub enum Corner {
    /// (1, 1).
    UpRight = 0,
    /// (−1, 1).
    UpLeft = 1,
    /// (−1, −1).
    DownLeft = 2,
    /// (1, −1).
    DownRight = 3,
}

impl Corner {
    /// All four corners, counter-clockwise from (1, 1).
    pub const ALL: [Self; 4] = [Self::UpRight, Self::UpLeft, Self::DownLeft, Self::DownRight];

    /// The corner of a number modulo 4.
    #[inline(always)]
    pub(crate) const fn turned(number: u8) -> Self {
        match number % 4 {
            0 => Self::UpRight,
            1 => Self::UpLeft,
            2 => Self::DownLeft,
            _ => Self::DownRight,
        }
    }

    /// Returns the edge that ends and the edge that begins at this corner, going round counter-clockwise.
    #[must_use]
    pub const fn edges(self) -> (Edge, Edge) {
        match self {
            Self::UpRight => (Edge::Right, Edge::Up),
            Self::UpLeft => (Edge::Up, Edge::Left),
            Self::DownLeft => (Edge::Left, Edge::Down),
            Self::DownRight => (Edge::Down, Edge::Right),
        }
    }

    /// The corner at which an edge ends, going round counter-clockwise.
    const fn ending(edge: Edge) -> Self {
        match edge {
            Edge::Right => Self::UpRight,
            Edge::Up => Self::UpLeft,
            Edge::Left => Self::DownLeft,
            Edge::Down => Self::DownRight,
        }
    }

    /// The corner at which an edge begins, going round counter-clockwise.
    const fn beginning(edge: Edge) -> Self {
        match edge {
            Edge::Right => Self::DownRight,
            Edge::Up => Self::UpRight,
            Edge::Left => Self::UpLeft,
            Edge::Down => Self::DownLeft,
        }
    }
}
