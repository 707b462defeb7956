//! How the errors of a tile shrink with its level.

/// An error relative to the semi-major axis, by the level of a tile: `factor`·2^(−`thirds`·level/3) +
/// `coarse`·4^(−level). The second term is the larger one in the first levels only.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Decay {
    pub factor: f64,
    pub thirds: u64,
    pub coarse: f64,
}

impl Decay {
    /// The error at a level.
    pub const fn at(self, level: u8) -> f64 {
        self.factor * shrink(self.thirds * level as u64) + self.coarse * shrink(6 * level as u64)
    }
}

/// For a projection without creases: the displacement of a tile drawn by its corners, and the error of a
/// series of the second order.
pub(super) const fn smooth(displacement: f64, series: f64) -> [Decay; 2] {
    [decay(displacement, 6, 0.0), decay(series, 9, 0.0)]
}

/// The same for a projection that has creases inside its faces.
pub(super) const fn creased(displacement: f64, series: f64) -> [Decay; 2] {
    [decay(displacement, 3, 0.35), decay(series, 3, 0.35)]
}

pub(super) const fn decay(factor: f64, thirds: u64, coarse: f64) -> Decay {
    Decay { factor, thirds, coarse }
}

/// 2^(−thirds/3).
const fn shrink(thirds: u64) -> f64 {
    let part = match thirds % 3 {
        0 => 1.0,
        1 => 0.793_700_525_984_099_7,
        _ => 0.629_960_524_947_436_6,
    };
    part * f64::from_bits((1023 - thirds / 3) << 52)
}
