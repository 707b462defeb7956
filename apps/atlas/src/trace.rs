//! Following a curve from place to place: finely where it is long, and cut exactly where it leaves.

/// A part of a curve that stays in one place: on one face, or in sight.
pub struct Piece<K> {
    pub place: K,
    pub points: Vec<[f64; 2]>,
}

#[derive(Clone, Copy)]
struct Sample<K> {
    t: f64,
    place: K,
    point: [f64; 2],
}

/// The difference of parameters below which two samples are one point of the curve. The rounding of t is less up to millions of steps.
const NEAR: f64 = 1e-9;

/// The pieces of a curve over t from 0 to `steps`, sampled at least at every whole t and with no gap above `longest`.
pub fn trace<K: Copy + PartialEq>(curve: impl Fn(f64) -> (K, [f64; 2]), steps: usize, longest: f64) -> Vec<Piece<K>> {
    let sample = |t| {
        let (place, point) = curve(t);
        Sample { t, place, point }
    };
    let mut last = sample(0.0);
    let mut pieces = vec![piece(last)];
    for step in 1..=steps {
        let next = sample(step as f64);
        follow(&sample, &mut pieces, last, next, longest);
        last = next;
    }
    pieces
}

/// Halves the way until both ends are in one place and near each other, or so near that the border is between them.
fn follow<K: Copy + PartialEq>(
    sample: &impl Fn(f64) -> Sample<K>,
    pieces: &mut Vec<Piece<K>>,
    from: Sample<K>,
    to: Sample<K>,
    longest: f64,
) {
    let together = from.place == to.place;
    let length = f64::hypot(to.point[0] - from.point[0], to.point[1] - from.point[1]);
    let fine = to.t - from.t < NEAR;
    if fine || (together && length <= longest) {
        match pieces.last_mut() {
            Some(piece) if together => piece.points.push(to.point),
            _ => pieces.push(piece(to)),
        }
    } else {
        let middle = sample(0.5 * (from.t + to.t));
        follow(sample, pieces, from, middle, longest);
        follow(sample, pieces, middle, to, longest);
    }
}

fn piece<K>(start: Sample<K>) -> Piece<K> {
    Piece {
        place: start.place,
        points: vec![start.point],
    }
}
