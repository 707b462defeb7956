//! From a value to its place on a scale, and to a colour.
//!
//! Ratios lie about 1 on a logarithm, so their colours diverge: from near white through orange to brown above, and through sky to dark blue
//! below. Both arms go through Oklab at one pace, with the same fall of lightness: equal steps look equal, lightness alone says how far from
//! 1 a value is, and blue and orange are told apart by every kind of colour vision. In the ready-made purple to orange the steps differ by a factor of 2.5
//! from place to place, and its arms by their lightness. Angles begin at 0 and take cividis, which was made to be uniform and to look alike with and without red-green
//! blindness.

use colorous::CIVIDIS;

/// A scale that one quantity has on every picture.
#[derive(Clone, Copy)]
pub enum Scale {
    /// From 2⁻ⁿ to 2ⁿ.
    Ratio(u8),
    /// From 0 to so many degrees.
    Degrees(u8),
}

/// A value that the scale names.
pub struct Tick {
    pub value: f64,
    pub label: &'static str,
}

/// Lines of equal value to an octave.
const LINES_AN_OCTAVE: u8 = 4;

/// Degrees from one line of equal value to the next.
const DEGREES_A_LINE: usize = 5;

impl Scale {
    /// The place of a value, from 0 to 1; beyond its ends the scale goes no further.
    pub fn position(self, value: f64) -> f64 {
        let position = match self {
            Self::Ratio(octaves) => 0.5 + 0.5 * value.log2() / f64::from(octaves),
            Self::Degrees(most) => value / f64::from(most),
        };
        position.clamp(0.0, 1.0)
    }

    /// The colour of a place.
    pub fn color(self, position: f64) -> [u8; 3] {
        match self {
            Self::Ratio(_) => diverging(2.0 * position - 1.0),
            Self::Degrees(_) => CIVIDIS.eval_continuous(position).into_array(),
        }
    }

    /// Values along which a line is drawn.
    pub fn lines(self) -> Vec<f64> {
        match self {
            Self::Ratio(octaves) => {
                let most = i32::from(octaves * LINES_AN_OCTAVE);
                (1 - most..most)
                    .map(|i| f64::from(i) / f64::from(LINES_AN_OCTAVE))
                    .map(f64::exp2)
                    .collect()
            }
            Self::Degrees(most) => (0..most).step_by(DEGREES_A_LINE).skip(1).map(f64::from).collect(),
        }
    }

    /// Values that are written.
    pub const fn ticks(self) -> &'static [Tick] {
        const fn tick(value: f64, label: &'static str) -> Tick {
            Tick { value, label }
        }
        match self {
            Self::Ratio(1) => {
                const {
                    &[
                        tick(0.5, "½"),
                        tick(std::f64::consts::FRAC_1_SQRT_2, "0.71"),
                        tick(1.0, "1"),
                        tick(std::f64::consts::SQRT_2, "1.41"),
                        tick(2.0, "2"),
                    ]
                }
            }
            Self::Ratio(_) => {
                const {
                    &[
                        tick(0.25, "¼"),
                        tick(0.5, "½"),
                        tick(1.0, "1"),
                        tick(2.0, "2"),
                        tick(4.0, "4"),
                    ]
                }
            }
            Self::Degrees(_) => {
                const {
                    &[
                        tick(0.0, "0°"),
                        tick(10.0, "10°"),
                        tick(20.0, "20°"),
                        tick(30.0, "30°"),
                        tick(40.0, "40°"),
                        tick(50.0, "50°"),
                    ]
                }
            }
        }
    }
}

/// Lightness, green to red and blue to yellow.
type Oklab = [f64; 3];

const MIDDLE: Oklab = [0.97, 0.0, 0.0];
const ORANGE: [Oklab; 2] = [[0.70, 0.080, 0.115], [0.38, 0.065, 0.076]];
const BLUE: [Oklab; 2] = [[0.70, -0.052, -0.130], [0.38, -0.034, -0.094]];

/// The colour of a place from −1 to 1: along the two sides of an arm at one pace.
fn diverging(place: f64) -> [u8; 3] {
    let [bright, dark] = if place < 0.0 { BLUE } else { ORANGE };
    let (first, second) = (distance(MIDDLE, bright), distance(bright, dark));
    let way = place.abs() * (first + second);
    srgb(if way < first {
        between(MIDDLE, bright, way / first)
    } else {
        between(bright, dark, (way - first) / second)
    })
}

fn distance(from: Oklab, to: Oklab) -> f64 {
    (0..3).map(|i| (to[i] - from[i]).powi(2)).sum::<f64>().sqrt()
}

fn between(from: Oklab, to: Oklab, part: f64) -> Oklab {
    std::array::from_fn(|i| from[i] + part * (to[i] - from[i]))
}

/// Ottosson, *A perceptual color space for image processing* (2020).
fn srgb([lightness, a, b]: Oklab) -> [u8; 3] {
    let l = (lightness + 0.396_337_777_4 * a + 0.215_803_757_3 * b).powi(3);
    let m = (lightness - 0.105_561_345_8 * a - 0.063_854_172_8 * b).powi(3);
    let s = (lightness - 0.089_484_177_5 * a - 1.291_485_548_0 * b).powi(3);
    let linear = [
        4.076_741_662_1 * l - 3.307_711_591_3 * m + 0.230_969_929_2 * s,
        -1.268_438_004_6 * l + 2.609_757_401_1 * m - 0.341_319_396_5 * s,
        -0.004_196_086_3 * l - 0.703_418_614_7 * m + 1.707_614_701_0 * s,
    ];
    linear.map(|v| {
        let coded = if v <= 0.003_130_8 {
            12.92 * v
        } else {
            1.055 * v.powf(1.0 / 2.4) - 0.055
        };
        (255.0 * coded.clamp(0.0, 1.0)).round() as u8
    })
}
