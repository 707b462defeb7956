//! The places that a row of cells is measured by: corners and centres, side by side.

use super::unfolded::{across, along};
use crate::cube::{CubeProjection, Edge, Face};
use crate::latitude::{Turn, normal, with_correction};
use crate::math::min;
use crate::simd::{BLOCK, Kernel, sweep};
use crate::{Direction, Ellipsoid, Real, Shifted};

/// The number of places that are computed together: for a microcontroller's stack not a whole block.
const PART: usize = BLOCK / 2;

/// The number of cells that are measured together: they need the centres on both sides of them.
pub(super) const WIDTH: usize = PART - 2;

/// Places side by side: x, y and z, in authalic radii.
type Strip<T> = [[T; PART]; 3];

/// The cells of a face, n × n.
pub(super) struct Strips<'a, T, P> {
    projection: P,
    shifted: &'a Shifted<T>,
    face: Face,
    n: u32,
    /// Half of a cell's width.
    half: T,
    /// The reciprocal of the authalic radius.
    scale: T,
}

impl<'a, T: Real, P: CubeProjection> Strips<'a, T, P> {
    pub(super) fn new(projection: P, shifted: &'a Shifted<T>, face: Face, n: u32) -> Self {
        Self {
            projection,
            shifted,
            face,
            n,
            half: T::ONE / T::whole(u64::from(n)),
            scale: T::ONE / shifted.ellipsoid().authalic_radius(),
        }
    }

    /// The coordinate of the side between two cells. The last one may round to a number beyond the face.
    fn corner(&self, index: u32) -> T {
        min(T::whole(u64::from(index)) * (self.half + self.half) - T::ONE, T::ONE)
    }

    /// The coordinate of the centre of the cell before that of an index. What is beyond the face is not used.
    pub(super) fn centre(&self, index: u32) -> T {
        min(self.corner(index) - self.half, T::ONE)
    }

    /// The coordinates of centres, from the cell before the first.
    pub(super) fn centres(&self, start: u32) -> [T; PART] {
        let mut centres = [T::ZERO; PART];
        for (centre, index) in centres.iter_mut().zip(start..) {
            *centre = self.centre(index);
        }
        centres
    }

    /// For `here` cells of a row, their corners counter-clockwise, their centres, and those to the right,
    /// above, to the left and below.
    pub(super) fn around(&self, start: u32, row: u32, here: usize) -> [Part<T>; 9] {
        let centres = self.centres(start);
        let mut corners = [T::ZERO; PART];
        for (corner, index) in corners.iter_mut().zip(start..) {
            *corner = self.corner(index);
        }
        let (low, high) = (
            self.level(&corners, self.corner(row)),
            self.level(&corners, self.corner(row + 1)),
        );
        let y = self.centre(row + 1);
        let mut middle = self.level(&centres, y);
        if start == 0 {
            self.replace(&mut middle, 0, Edge::Left, y);
        }
        if start + here as u32 == self.n {
            self.replace(&mut middle, here + 1, Edge::Right, y);
        }
        let above = if row + 1 == self.n {
            self.beyond(Edge::Up, &centres)
        } else {
            self.level(&centres, self.centre(row + 2))
        };
        let below = if row == 0 {
            self.beyond(Edge::Down, &centres)
        } else {
            self.level(&centres, self.centre(row))
        };
        [
            Part(low, 0),
            Part(low, 1),
            Part(high, 1),
            Part(high, 0),
            Part(middle, 1),
            Part(middle, 2),
            Part(above, 1),
            Part(middle, 0),
            Part(below, 1),
        ]
    }

    /// The places of a row.
    fn level(&self, xs: &[T; PART], y: T) -> Strip<T> {
        self.places(self.face, xs, &[y; PART])
    }

    /// The centres beyond an edge.
    fn beyond(&self, edge: Edge, along_it: &[T; PART]) -> Strip<T> {
        let points = along_it.map(|s| across(self.face, edge, along(edge, s, self.half)).1);
        let face = self.face.neighbour(edge).face;
        self.places(face, &points.map(|[x, _]| x), &points.map(|[_, y]| y))
    }

    /// Puts the centre beyond an edge in its place.
    fn replace(&self, strip: &mut Strip<T>, index: usize, edge: Edge, y: T) {
        let (face, [x, y]) = across(self.face, edge, along(edge, y, self.half));
        let [x, y, z] = self.projection.vector(face, [x, y]);
        let normal = self.shifted.normal(Direction::within(x, y, z));
        let place = self.shifted.ellipsoid().foot(normal).map(|metres| metres * self.scale);
        for (column, value) in strip.iter_mut().zip(place) {
            if let Some(slot) = column.get_mut(index) {
                *slot = value;
            }
        }
    }

    fn places(&self, face: Face, xs: &[T; PART], ys: &[T; PART]) -> Strip<T> {
        let mut directions = [[T::ZERO; PART]; 3];
        let mut places = directions;
        let projection = self.projection;
        sweep(
            ToDirection { projection, face },
            [xs.as_slice(), ys.as_slice()],
            directions.each_mut().map(<[T; PART]>::as_mut_slice),
        );
        let (ellipsoid, scale) = (self.shifted.ellipsoid(), self.scale);
        let [_, correction] = self.shifted.corrections();
        with_correction!(&correction, turn => {
            let turn = *turn;
            sweep(
                ToPlace { ellipsoid, turn, scale },
                directions.each_ref().map(<[T; PART]>::as_slice),
                places.each_mut().map(<[T; PART]>::as_mut_slice),
            );
        });
        places
    }
}

/// A strip and where in it the first cell's place is.
pub(super) struct Part<T>(Strip<T>, usize);

impl<T> Part<T> {
    /// The places of so many cells.
    pub(super) fn columns(&self, here: usize) -> [&[T]; 3] {
        let Self(strip, first) = self;
        strip
            .each_ref()
            .map(|column| column.get(*first..first + here).unwrap_or_default())
    }
}

/// The kernel from a point of a face to its direction.
#[derive(Clone, Copy)]
struct ToDirection<P> {
    projection: P,
    face: Face,
}

impl<T: Real, P: CubeProjection> Kernel<[T; 2]> for ToDirection<P> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, point: [T; 2]) -> [T; 3] {
        self.projection.vector(self.face, point)
    }
}

/// The kernel from a direction to the place on the ground.
#[derive(Clone, Copy)]
struct ToPlace<T, C> {
    ellipsoid: Ellipsoid<T>,
    turn: C,
    scale: T,
}

impl<T: Real, C: Turn<T>> Kernel<[T; 3]> for ToPlace<T, C> {
    type Output = [T; 3];

    #[inline(always)]
    fn apply(&self, [x, y, z]: [T; 3]) -> [T; 3] {
        let normal = normal(&self.turn, Direction::within(x, y, z));
        self.ellipsoid.foot(normal).map(|metres| metres * self.scale)
    }
}
