use super::Curve;
use super::key::sealed::Order;
use crate::cube::{Face, Numbering};
use crate::math::{gathered, spread};

/// Hilbert's curve, drawn through the six faces as S2 does it: of one level, each tile shares an edge with
/// the next.
///
/// It uses S2's face numbers and axes, so a tile of the [`S2Quadratic`](crate::cube::S2Quadratic) cube has
/// the id of the S2 cell that covers the same place. For a point exactly on the line between two cells, S2
/// may choose a different cell than [`Tile::containing`](super::Tile::containing);
/// [`Key::s2_leaf`](super::Key::s2_leaf) returns S2's choice.
///
/// The conversion uses no table and no loop over levels. Each level acts on the levels below it as a map of
/// two bits: whether the axes are exchanged, and whether they are reversed. The maps of all levels are
/// combined at once, with one long division and prefix sums over the bits.
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
#[doc(alias = "Hilbert curve")]
#[doc(alias = "S2 curve")]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Hilbert;

impl Curve for Hilbert {}

/// S2's number of each face, by this crate's number, four bits each.
const S2_NUMBERS: u32 = {
    let (mut numbers, mut rest) = (0, &Face::ALL as &[Face]);
    while let [face, others @ ..] = rest {
        numbers |= (Numbering::S2.number(*face) as u32) << (4 * face.index());
        rest = others;
    }
    numbers
};
/// This crate's number of each face, by S2's; 0 past the last.
const S2_FACES: u32 = {
    let (mut faces, mut rest) = (0, &Face::ALL as &[Face]);
    while let [face, others @ ..] = rest {
        faces |= (face.index() as u32) << (4 * Numbering::S2.number(*face));
        rest = others;
    }
    faces
};
/// Every other one of 30 bits, starting with the highest.
const ODD: u32 = 0x2aaa_aaaa;
/// The lowest 30 bits.
const ALL: u32 = 0x3fff_ffff;
/// Every other bit of 64, starting with the lowest.
const ALTERNATE: u64 = 0x5555_5555_5555_5555;

impl Order for Hilbert {
    #[inline(always)]
    fn number(face: Face) -> u8 {
        (S2_NUMBERS >> (4 * face.index())) as u8 & 7
    }

    #[inline(always)]
    fn face(number: u8) -> Face {
        Face::numbered((S2_FACES >> (4 * (number & 7))) as u8 & 7)
    }

    #[inline(always)]
    fn place(face: Face, i: u32, j: u32) -> u64 {
        let (i, j) = exchanged(face, reversed(face, (i, j)));
        // At each level let s (exchanged) and r (reversed) be the state that the levels above have produced.
        // Then the level's two binary digits are q = i ^ r ^ (s & d) and d = i ^ j, and the state (s, r)
        // becomes (s ^ !(q ^ d), r ^ (q & d)). If s and r trade places below every other level, each step is
        // an affine map in the field of four elements: (s, r) is multiplied by a factor and (c, e) is added.
        // The factor is 1 if d = 1, and alternately w and its inverse if d = 0.
        let d = i ^ j;
        let same = !d & ALL;
        let (high, low) = (d & i, same & !i);
        let (c, e) = (high | low & !ODD, high | low & ODD);
        // The product of the factors so far is w to the power of an alternating sum of bits modulo 3. A long
        // division by 3 computes that sum as its remainder.
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
        // Whether each level exchanges, and whether it reverses, the levels below it; then the combined
        // effect of all levels above.
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

/// Powers of w as (a, b) for a + bw: w to the power of a remainder modulo 3 at every other bit, and w to the
/// negative of that power at the other bits. `one` and `two` mark the bits where the remainder is 1 or 2.
#[inline(always)]
const fn power(one: u32, two: u32) -> (u32, u32) {
    (!(one ^ (one ^ two) & ODD), one | two)
}

/// The product of a + bw and c + ew at each bit, where w² = w + 1.
#[inline(always)]
const fn product((a, b): (u32, u32), (c, e): (u32, u32)) -> (u32, u32) {
    (a & c ^ b & e, b & c ^ (a ^ b) & e)
}

/// At each bit, the sum modulo 2 of all higher bits.
#[inline(always)]
const fn all_above(bits: u32) -> u32 {
    let x = bits >> 1;
    let x = x ^ x >> 1;
    let x = x ^ x >> 2;
    let x = x ^ x >> 4;
    let x = x ^ x >> 8;
    x ^ x >> 16
}

/// One bit for each face, by its index: whether the face's axes are exchanged to become the curve's axes. The
/// curve's axes are S2's, exchanged on the S2 faces of odd number.
const EXCHANGED: u8 = 0b11_1010;
/// One bit for each face: whether its columns are counted backwards before that.
const REVERSED_I: u8 = 0b01_0000;
/// One bit for each face: whether its rows are counted backwards before that.
const REVERSED_J: u8 = 0b00_1100;

/// Returns 30 ones if the face's bit is set in `set`, else 0.
#[inline(always)]
const fn mask(set: u8, face: Face) -> u32 {
    ((set >> face.index() & 1) as u32).wrapping_neg() & ALL
}

/// Exchanges column and row on the faces of [`EXCHANGED`].
#[inline(always)]
const fn exchanged(face: Face, (i, j): (u32, u32)) -> (u32, u32) {
    let change = (i ^ j) & mask(EXCHANGED, face);
    (i ^ change, j ^ change)
}

/// Counts columns or rows backwards on the faces of [`REVERSED_I`] and [`REVERSED_J`].
#[inline(always)]
const fn reversed(face: Face, (i, j): (u32, u32)) -> (u32, u32) {
    (i ^ mask(REVERSED_I, face), j ^ mask(REVERSED_J, face))
}
