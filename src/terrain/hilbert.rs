use super::Curve;
use super::key::sealed::Order;
use crate::cube::{Face, Numbering};
use crate::math::{gathered, spread};

/// Hilbert's curve, as S2 draws it through the six faces: each tile of a level shares an edge with the next.
///
/// With S2's faces and axes, so that a tile of the [`S2Quadratic`](crate::cube::S2Quadratic) cube has the
/// number of S2's cell in the same place. Of a place on a line between cells S2 may choose another one than
/// [`Tile::containing`](super::Tile::containing): [`Key::s2_leaf`](super::Key::s2_leaf) is S2's own.
///
/// Without a table or a loop: what a level does to the ones below is a map of two bits, whether the axes are exchanged and whether they are
/// reversed, and the maps of all levels are combined at once, by a long division and sums over leading bits.
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
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hilbert;

impl Curve for Hilbert {}

/// Every other of 30 bits, the first among them.
const ODD: u32 = 0x2aaa_aaaa;
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
        const FACES: [Face; 6] = [
            Face::Front,
            Face::Right,
            Face::Top,
            Face::Back,
            Face::Left,
            Face::Bottom,
        ];
        FACES.get(usize::from(number)).copied().unwrap_or(Face::Front)
    }

    #[inline(always)]
    fn place(face: Face, i: u32, j: u32) -> u64 {
        let (i, j) = exchanged(face, reversed(face, (i, j)));
        // At each level, with s (exchanged) and r (reversed) from the levels above, the two digits are q = i ^ r ^ (s & d) and d = i ^ j,
        // and (s, r) becomes (s ^ !(q ^ d), r ^ (q & d)). With s and r exchanged below every other level this is (s, r) = w(s, r) + (c, e)
        // in the field of four elements, where w is 1 for d = 1, and for d = 0 it and its inverse take turns.
        let d = i ^ j;
        let same = !d & ALL;
        let (high, low) = (d & i, same & !i);
        let (c, e) = (high | low & !ODD, high | low & ODD);
        // The power of w that the levels so far come to: an alternating sum of bits modulo 3, which is the remainder of a long division by 3.
        let quotient = same / 3;
        let one = same ^ quotient;
        let two = quotient << 1 & !one;
        let (c, e) = product(power(one, two), (c, e));
        let (c, e) = (all_above(c), all_above(e));
        let (c, e) = product(power(one >> 1, two >> 1), (c, e));
        let turn = (c ^ e) & !ODD;
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
        let i = high ^ s & low ^ r;
        let j = i ^ low;
        reversed(face, exchanged(face, (gathered(i), gathered(j))))
    }
}

/// w to the power of a remainder modulo 3 at every other bit, and to its negative at the others: (a, b) for a + bw.
#[inline(always)]
const fn power(one: u32, two: u32) -> (u32, u32) {
    (!(one ^ (one ^ two) & ODD), one | two)
}

/// The product with c + ew, where w² = w + 1.
#[inline(always)]
const fn product((a, b): (u32, u32), (c, e): (u32, u32)) -> (u32, u32) {
    (a & c ^ b & e, b & c ^ (a ^ b) & e)
}

/// At each bit, the sum modulo 2 of all above it.
#[inline(always)]
const fn all_above(bits: u32) -> u32 {
    let x = bits >> 1;
    let x = x ^ x >> 1;
    let x = x ^ x >> 2;
    let x = x ^ x >> 4;
    let x = x ^ x >> 8;
    x ^ x >> 16
}

/// By the bit of a face: whether its axes are exchanged on the way to the curve's, which are S2's, exchanged on S2's faces of odd number.
const EXCHANGED: u8 = 0b11_1010;
/// Whether its columns are counted backwards first.
const REVERSED_I: u8 = 0b01_0000;
/// Whether its rows are.
const REVERSED_J: u8 = 0b00_1100;

/// 30 ones if the face's bit is set, or none.
#[inline(always)]
const fn mask(set: u8, face: Face) -> u32 {
    ((set >> face.index() & 1) as u32).wrapping_neg() & ALL
}

#[inline(always)]
const fn exchanged(face: Face, (i, j): (u32, u32)) -> (u32, u32) {
    let change = (i ^ j) & mask(EXCHANGED, face);
    (i ^ change, j ^ change)
}

#[inline(always)]
const fn reversed(face: Face, (i, j): (u32, u32)) -> (u32, u32) {
    (i ^ mask(REVERSED_I, face), j ^ mask(REVERSED_J, face))
}
