//! The first picture: error against distance, from neighbours to the antipode.

use rayon::prelude::*;

use crate::pair::{Pair, Place, Scalar, Truth};
use crate::solver::Solver;
use draw::svg::{Area, LogAxis, Svg};
use draw::units::metres;

/// Bins to a power of ten.
const FINE: i32 = 10;
/// The exponents of the shortest distance, and of a quarter of the way around.
const SPAN: [i32; 2] = [-3, 7];
/// The exponents of the smallest and largest error.
const ERRORS: [f64; 2] = [-9.0, 8.0];
/// What GeographicLib is known to, in metres.
const FLOOR: f64 = 15e-9;

/// What the distance of a pair is counted from.
#[derive(Clone, Copy)]
enum Side {
    /// The first place.
    Near,
    /// Its antipode.
    Far,
}

/// A pair, what a chart calls its distance, and the true one.
struct Case {
    pair: Pair,
    bin: usize,
    truth: f64,
}

/// What a method did in a bin.
#[derive(Clone, Copy, Default)]
struct Bin {
    worst: f64,
    answers: usize,
    failures: usize,
}

/// Draws the chart.
pub fn draw(ours: &[Solver], truth: &Truth, per_bin: usize) -> Svg {
    let mut svg = Svg::new(1410.0, 830.0);
    let [left, right] = [
        Area {
            x: 90.0,
            y: 96.0,
            width: 540.0,
            height: 660.0,
        },
        Area {
            x: 646.0,
            y: 96.0,
            width: 540.0,
            height: 660.0,
        },
    ];
    let errors = LogAxis {
        exponents: ERRORS,
        ends: [left.bottom(), left.y],
    };
    let span = SPAN.map(f64::from);
    let near = LogAxis {
        exponents: span,
        ends: [left.x, left.right()],
    };
    let far = LogAxis {
        exponents: span,
        ends: [right.right(), right.x],
    };
    for (area, axis) in [(left, near), (right, far)] {
        svg.fill(
            Area {
                y: errors.at(FLOOR),
                height: area.bottom() - errors.at(FLOOR),
                ..area
            },
            "#8d97a7",
            0.12,
        );
        for exponent in axis.powers(1) {
            let x = axis.at(10f64.powi(exponent));
            svg.grid_line([x, area.y], [x, area.bottom()]);
            if exponent % 3 == 0 {
                svg.text([x, area.bottom() + 20.0], "small middle", &metres(exponent));
            }
        }
        for exponent in errors.powers(1) {
            let y = errors.at(10f64.powi(exponent));
            svg.grid_line([area.x, y], [area.right(), y]);
        }
    }
    for exponent in errors.powers(3) {
        let y = errors.at(10f64.powi(exponent)) + 5.0;
        svg.text([left.x - 10.0, y], "small end", &metres(exponent));
    }
    svg.upright(
        [20.0, left.y + 0.5 * left.height],
        "middle",
        "largest error of the distance",
    );
    let below = left.bottom() + 48.0;
    svg.text(
        [left.x + 0.5 * left.width, below],
        "middle",
        "distance from the first place",
    );
    svg.text(
        [right.x + 0.5 * right.width, below],
        "middle",
        "what is left to its antipode",
    );
    let note = "below 15 nm: not told apart from the reference, geographiclib-rs";
    svg.text([right.x + 10.0, errors.at(FLOOR) - 8.0], "small", note);
    svg.text(
        [right.x - 8.0, left.y - 10.0],
        "small middle",
        "10 000 km: a quarter of the way around",
    );
    svg.text([left.x, 36.0], "", "full lines f64");
    svg.polyline(&[[left.x + 104.0, 31.0], [left.x + 156.0, 31.0]], "line", "#d5dae3");
    svg.text(
        [left.x + 190.0, 36.0],
        "",
        "dashed f32, its places rounded to f32 first",
    );
    svg.polyline(
        &[[left.x + 540.0, 31.0], [left.x + 592.0, 31.0]],
        "line dashed",
        "#d5dae3",
    );

    let cases = |side| Scalar::ALL.map(|scalar| cases(truth, side, scalar, per_bin));
    let (near_cases, far_cases) = (cases(Side::Near), cases(Side::Far));
    let mut labels = Vec::new();
    let mut strips = 0;
    for solver in ours {
        let class = if solver.scalar == Scalar::F64 {
            "line"
        } else {
            "line dashed"
        };
        let scalar = Scalar::ALL.iter().position(|&s| s == solver.scalar).unwrap_or_default();
        let mut end = None;
        let mut failed = false;
        let strip = left.y + 8.0 + 14.0 * f64::from(strips);
        for (cases, axis) in [(&near_cases, near), (&far_cases, far)] {
            let bins = measure(solver, &cases[scalar]);
            let enough = |bin: &Bin| bin.answers + bin.failures > per_bin / 4;
            let points: Vec<_> = (0_i32..)
                .zip(&bins)
                .filter(|(_, bin)| enough(bin) && bin.answers > 0)
                .map(|(i, bin)| [axis.at(middle(i)), errors.at(bin.worst)])
                .collect();
            svg.polyline(&points, class, solver.colour);
            end = points.first().copied();
            for (i, bin) in (0_i32..).zip(&bins).filter(|(_, bin)| bin.failures > 0) {
                failed = true;
                let share = bin.failures as f64 / (bin.answers + bin.failures) as f64;
                let width = (axis.at(middle(1)) - axis.at(middle(0))).abs();
                let area = Area {
                    x: axis.at(middle(i)) - 0.5 * width,
                    y: strip,
                    width,
                    height: 9.0,
                };
                svg.fill(area, solver.colour, 0.15 + 0.85 * share);
            }
        }
        if failed {
            strips += 1;
            let text = format!("no answer: {} {}", solver.name, solver.scalar.name());
            svg.text([left.right() - 10.0, strip + 9.0], "small end", &text);
        }
        if let Some(end) = end {
            labels.push((end, solver));
        }
    }
    svg.frame(left);
    svg.frame(right);
    label(&mut svg, right, labels);
    svg
}

/// The names of the lines, where they end, moved apart.
fn label(svg: &mut Svg, area: Area, mut labels: Vec<([f64; 2], &Solver)>) {
    labels.sort_by(|(a, _), (b, _)| a[1].total_cmp(&b[1]));
    let apart = 20.0;
    let mut places: Vec<f64> = labels.iter().map(|(end, _)| end[1]).collect();
    for i in 1..places.len() {
        places[i] = places[i].max(places[i - 1] + apart);
    }
    // Back up from the bottom, if that is where they crowd.
    let mut limit = area.bottom() + 30.0;
    for place in places.iter_mut().rev() {
        *place = place.min(limit);
        limit = *place - apart;
    }
    let x = area.right();
    for (([end_x, end_y], solver), y) in labels.into_iter().zip(places) {
        svg.polyline(
            &[[end_x, end_y], [x + 4.0, end_y], [x + 22.0, y]],
            "lead",
            solver.colour,
        );
        let text = format!("{}, {}", solver.name, solver.scalar.name());
        svg.coloured_text([x + 27.0, y + 5.0], solver.colour, &text);
    }
}

/// The distance in the middle of a bin.
fn middle(bin: i32) -> f64 {
    10f64.powf(f64::from(SPAN[0]) + (f64::from(bin) + 0.5) / f64::from(FINE))
}

/// Pairs of places at all distances, rounded, with the truth for what they were rounded to.
fn cases(truth: &Truth, side: Side, scalar: Scalar, per_bin: usize) -> Vec<Case> {
    let bins = (SPAN[1] - SPAN[0]) * FINE;
    (0..bins)
        .into_par_iter()
        .flat_map_iter(|wanted| {
            // The same places for both scalars.
            let mut rng = fastrand::Rng::with_seed(7 * wanted as u64 + side as u64);
            (0..per_bin).filter_map(move |_| {
                let from = Place::anywhere(&mut rng);
                let origin = match side {
                    Side::Near => from,
                    Side::Far => from.antipode(),
                };
                let exponent = f64::from(SPAN[0]) + (f64::from(wanted) + rng.f64()) / f64::from(FINE);
                let to = truth.destination(origin, 360.0 * rng.f64(), 10f64.powf(exponent));
                let pair = Pair { from, to }.rounded(scalar);
                let distance = truth.distance(pair);
                let shown = match side {
                    Side::Near => distance,
                    Side::Far => truth.distance(Pair {
                        from: pair.from.antipode(),
                        to: pair.to,
                    }),
                };
                let bin = ((shown.log10() - f64::from(SPAN[0])) * f64::from(FINE)).floor();
                (0.0..f64::from(bins)).contains(&bin).then_some(Case {
                    pair,
                    bin: bin as usize,
                    truth: distance,
                })
            })
        })
        .collect()
}

fn measure(solver: &Solver, cases: &[Case]) -> Vec<Bin> {
    let found: Vec<_> = cases.par_iter().map(|case| solver.distance(case.pair)).collect();
    let mut bins = vec![Bin::default(); ((SPAN[1] - SPAN[0]) * FINE) as usize];
    for (case, found) in cases.iter().zip(found) {
        let bin = &mut bins[case.bin];
        match found {
            Some(found) => {
                bin.answers += 1;
                bin.worst = bin.worst.max((found - case.truth).abs());
            }
            None => bin.failures += 1,
        }
    }
    bins
}
