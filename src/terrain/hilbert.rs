use super::Curve;
use super::key::sealed::Order;
use super::morton::{gathered, spread};
use crate::cube::{Face, Numbering};

/// Hilbert's curve, as S2 draws it through the six faces: each tile of a level shares an edge with the next.
///
/// With S2's faces and axes, so that a tile of the [`S2Quadratic`](crate::cube::S2Quadratic) cube has the number of S2's cell in the same place.
///
/// Without a table or a loop, in some 90 (there) and 60 (back) operations on words: what a level does to the ones below is a map of two bits,
/// whether the axes are exchanged and whether they are reversed, and the maps of all levels are combined in five rounds, pairs of 1, 2, 4, …
/// levels at a time (a parallel prefix: Hillis & Steele, CACM 29, 1986).
///
/// ```
/// use terrella::cube::{CubeProjection, Face, S2Quadratic};
/// use terrella::terrain::{Hilbert, Key, Tile};
/// use terrella::LatLon;
///
/// let paris = S2Quadratic.project(LatLon::new(48.8566_f64, 2.3522)?.to_direction());
/// let key = Key::<Hilbert>::from(Tile::containing(paris, 12)?);
/// assert_eq!(key.to_string(), "47e66e1"); // S2's cell there
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Hilbert;

impl Curve for Hilbert {}

/// The levels of even number, counting from the coarsest as 0, among 30 bits.
const EVEN: u32 = 0x2aaa_aaaa;
/// 30 bits.
const ALL: u32 = 0x3fff_ffff;
/// Every other bit.
const ALTERNATE: u64 = 0x5555_5555_5555_5555;

impl Order for Hilbert {
    #[inline(always)]
    fn number(face: Face) -> u8 {
        Numbering::S2.number(face)
    }

    #[inline(always)]
    fn face(number: u8) -> Face {
        match number {
            0 => Face::Front,
            1 => Face::Right,
            2 => Face::Top,
            3 => Face::Back,
            4 => Face::Left,
            _ => Face::Bottom,
        }
    }

    #[inline(always)]
    fn place(face: Face, i: u32, j: u32) -> u64 {
        let (i, j) = to_curve(face, i, j);
        // At each level, with s (exchanged) and r (reversed) from the levels above, the two digits are q = r ^ (s ? j : i) and d = i ^ j,
        // and (s, r) becomes (s ^ !(q ^ d), r ^ (q & d)): an affine map over two elements. Exchanged at every other level, its linear
        // part is a power of one matrix of order 3, [[a, b], [b, a ^ b]]; [c, e] is the rest.
        let d = i ^ j;
        let same = !d & ALL;
        let (mut a, mut b) = (d | !EVEN & ALL, same);
        let (high, low) = (d & i, same & !i);
        let (mut c, mut e) = (high | low & !EVEN, high | low & EVEN);
        for shift in [1, 2, 4, 8, 16] {
            let (a0, b0, c0, e0) = (a >> shift, b >> shift, c >> shift, e >> shift);
            c ^= a & c0 ^ b & e0;
            e ^= b & c0 ^ (a ^ b) & e0;
            (a, b) = (a & a0 ^ b & b0, a & b0 ^ b & (a0 ^ b0));
        }
        // What the levels above have done, and no longer exchanged.
        let (c, e) = (c >> 1, e >> 1);
        let turn = (c ^ e) & !EVEN;
        let (s, r) = (c ^ turn, e ^ turn);
        spread(i ^ r ^ s & d) << 1 | spread(d)
    }

    #[inline(always)]
    fn square(face: Face, place: u64) -> (u32, u32) {
        let (low, high) = (place & ALTERNATE, place >> 1 & ALTERNATE);
        // Whether the level exchanges, and whether it reverses, the levels below: then all above it together.
        let mut state = (!(high ^ low) & ALTERNATE | (high & low) << 1) & ((1 << 60) - 1);
        for shift in [2, 4, 8, 16, 32] {
            state ^= state >> shift;
        }
        let state = state >> 2;
        let (s, r) = (state & ALTERNATE, state >> 1 & ALTERNATE);
        let swapped = s & low ^ r;
        let i = high ^ swapped;
        let j = i ^ low;
        from_curve(face, gathered(i), gathered(j))
    }
}

/// The reversals of columns and rows, and then whether they are exchanged, from a face's axes to those of the curve: S2's axes, exchanged on its
/// faces of odd number.
#[inline(always)]
const fn orientation(face: Face) -> (u32, u32, bool) {
    match face {
        Face::Front => (0, 0, false),
        Face::Right | Face::Bottom => (0, 0, true),
        Face::Back => (0, ALL, false),
        Face::Left => (0, ALL, true),
        Face::Top => (ALL, 0, true),
    }
}

#[inline(always)]
const fn to_curve(face: Face, i: u32, j: u32) -> (u32, u32) {
    let (reverse_i, reverse_j, exchanged) = orientation(face);
    let (i, j) = (i ^ reverse_i, j ^ reverse_j);
    if exchanged { (j, i) } else { (i, j) }
}

#[inline(always)]
const fn from_curve(face: Face, i: u32, j: u32) -> (u32, u32) {
    let (reverse_i, reverse_j, exchanged) = orientation(face);
    let (i, j) = if exchanged { (j, i) } else { (i, j) };
    (i ^ reverse_i, j ^ reverse_j)
}
