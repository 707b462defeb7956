//! The second and third pictures: maps of the square of ±1 degree about an antipode.

use std::hint::black_box;
use std::time::Instant;

use rayon::prelude::*;

use crate::pair::{Pair, Place, Scalar, Truth};
use crate::scale::{Scale, hatch_legend};
use crate::solver::{CLASSIC, Figure, Solver, radius};
use crate::svg::{Area, Svg};
use crate::units::{length, metres, percent, seconds};

/// Whose antipode it is. Neither number is round in binary.
const FROM: Place = Place { lat: 30.1, lon: 10.3 };
/// Half of the side of the square, in degrees.
const REACH: f64 = 1.0;
const COLUMNS: usize = 4;
const PANEL: f64 = 300.0;
/// Clocked calls in a row, and rounds over the map.
const CALLS: u32 = 2;
const ROUNDS: usize = 5;

/// Draws the errors, in metres.
pub fn errors(ours: &[Solver], theirs: &[Solver], earth: &Truth, side: u32) -> Result<Svg, String> {
    let sphere = Truth::sphere(radius());
    let of = |figure| ours.iter().filter(move |s| s.figure == figure);
    let on_sphere = of(Figure::Sphere).map(|s| (s, &sphere, " on the sphere"));
    let on_earth = of(Figure::Ellipsoid).map(|s| (s, earth, ""));
    let classic = theirs.iter().filter(|s| s.name == CLASSIC).map(|s| (s, earth, ""));
    let mut double = of(Figure::Sphere).filter(|s| s.scalar == Scalar::F64);
    let as_model = double.next_back().into_iter().map(|s| (s, earth, " as the Earth"));
    let panels: Vec<_> = on_sphere.chain(on_earth).chain(classic).chain(as_model).collect();
    let scale = Scale {
        exponents: [-9.0, 5.0],
        unit: metres,
    };
    let mut sheet = Sheet::new(panels.len());
    for (solver, truth, aside) in panels {
        let error = |pair: Pair| {
            let pair = pair.rounded(solver.scalar);
            solver.distance(pair).map(|found| (found - truth.distance(pair)).abs())
        };
        let cells: Vec<_> = pairs(side).into_par_iter().map(error).collect();
        let title = format!("{}, {}{aside}", solver.name, solver.scalar.name());
        sheet.add(&title, &note(&cells), scale, side, &cells)?;
    }
    let [x, y] = sheet.finish(scale, "error of the distance")?;
    let swatch = Area {
        x,
        y,
        width: 26.0,
        height: 14.0,
    };
    hatch_legend(&mut sheet.svg, swatch, "no answer")?;
    Ok(sheet.svg)
}

/// The largest error; or, where there are cells without an answer, their share.
fn note(cells: &[Option<f64>]) -> String {
    match cells.iter().filter(|cell| cell.is_none()).count() {
        0 => format!("≤ {}", length(cells.iter().copied().flatten().fold(0.0, f64::max))),
        none => format!("none for {}", percent(none as f64 / cells.len() as f64)),
    }
}

/// Draws the times, in seconds.
pub fn times(ours: &[Solver], theirs: &[Solver], side: u32) -> Result<Svg, String> {
    let exact = ours.iter().filter(|s| matches!(s.name, "Vincenty" | "Karney"));
    let panels: Vec<_> = exact.chain(theirs.iter().filter(|s| s.name == CLASSIC)).collect();
    let scale = Scale {
        exponents: [-7.0, -5.0],
        unit: seconds,
    };
    let mut sheet = Sheet::new(panels.len());
    for solver in panels {
        let pairs: Vec<_> = pairs(side)
            .into_iter()
            .map(|pair| pair.rounded(solver.scalar))
            .collect();
        let mut cells = vec![Some(f64::INFINITY); pairs.len()];
        // The shortest of a few rounds. One pair after the other: two at a time would disturb each other's clocks.
        for _ in 0..ROUNDS {
            for (cell, &pair) in cells.iter_mut().zip(&pairs) {
                *cell = cell.map(|best| best.min(time(solver, pair)));
            }
        }
        sheet.add(
            &format!("{}, {}", solver.name, solver.scalar.name()),
            "",
            scale,
            side,
            &cells,
        )?;
    }
    sheet.finish(scale, "time of one distance")?;
    Ok(sheet.svg)
}

/// The time of one answer in seconds.
fn time(solver: &Solver, pair: Pair) -> f64 {
    let start = Instant::now();
    for _ in 0..CALLS {
        let _ = black_box(solver.distance(black_box(pair)));
    }
    start.elapsed().as_secs_f64() / f64::from(CALLS)
}

/// The pairs of a map, row by row from the north.
fn pairs(side: u32) -> Vec<Pair> {
    let middle = FROM.antipode();
    let offset = |i: u32| REACH * ((2.0 * f64::from(i) + 1.0) / f64::from(side) - 1.0);
    let cell = |row, column| Pair {
        from: FROM,
        to: Place {
            lat: middle.lat - offset(row),
            lon: middle.lon + offset(column),
        },
    };
    (0..side)
        .flat_map(|row| (0..side).map(move |column| cell(row, column)))
        .collect()
}

/// Maps side by side, and their legend in the last place.
struct Sheet {
    svg: Svg,
    drawn: usize,
    panels: usize,
}

impl Sheet {
    fn new(panels: usize) -> Self {
        let rows = panels / COLUMNS + 1;
        Self {
            svg: Svg::new(1400.0, 40.0 + rows as f64 * (PANEL + 54.0)),
            drawn: 0,
            panels,
        }
    }

    fn place(panel: usize) -> Area {
        let (row, column) = (panel / COLUMNS, panel % COLUMNS);
        Area {
            x: 84.0 + column as f64 * (PANEL + 26.0),
            y: 40.0 + row as f64 * (PANEL + 54.0),
            width: PANEL,
            height: PANEL,
        }
    }

    fn add(&mut self, title: &str, note: &str, scale: Scale, side: u32, cells: &[Option<f64>]) -> Result<(), String> {
        let area = Self::place(self.drawn);
        self.svg.text([area.x, area.y - 10.0], "", title);
        self.svg.text([area.right(), area.y - 10.0], "small end", note);
        self.svg.image(area, &scale.map(side, cells))?;
        self.svg.frame(area);
        let is_lowest = self.drawn + COLUMNS >= self.panels;
        for (along, class, degrees) in [
            (0.0, "small", "−1°"),
            (0.5, "small middle", "0°"),
            (1.0, "small end", "+1°"),
        ] {
            if is_lowest {
                self.svg
                    .text([area.x + along * PANEL, area.bottom() + 18.0], class, degrees);
            }
            if self.drawn % COLUMNS == 0 {
                let y = area.bottom() - along * PANEL + 5.0;
                self.svg.text([area.x - 8.0, y], "small end", degrees);
            }
        }
        if is_lowest {
            self.svg.text(
                [area.x + 0.5 * PANEL, area.bottom() + 36.0],
                "small middle",
                "east of the antipode",
            );
        }
        if self.drawn % COLUMNS == 0 {
            let middle = [area.x - 52.0, area.y + 0.5 * PANEL];
            self.svg.upright(middle, "small middle", "north of the antipode");
        }
        self.drawn += 1;
        Ok(())
    }

    /// Draws the legend; returns where there is room for more.
    fn finish(&mut self, scale: Scale, title: &str) -> Result<[f64; 2], String> {
        let place = Self::place(self.drawn);
        let bar = Area {
            x: place.x + 16.0,
            y: place.y + 110.0,
            width: PANEL - 32.0,
            height: 14.0,
        };
        scale.legend(&mut self.svg, bar, title)?;
        Ok([bar.x, bar.bottom() + 50.0])
    }
}
