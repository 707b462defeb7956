//! The second and third pictures: maps of the square of ±1 degree about an antipode.

use rayon::prelude::*;
use terrella::geodesic::{Karney, Surface, Vincenty};
use terrella::{Ellipsoid, LatLon, Real};

use crate::pair::{Pair, Place, Scalar, Truth};
use crate::scale::{Scale, hatch_legend};
use crate::solver::{Solver, radius};
use draw::svg::{Area, Svg};
use draw::units::{length, metres, percent};

/// Whose antipode it is. Neither number is round in binary.
const FROM: Place = Place { lat: 30.1, lon: 10.3 };
/// Half of the side of the square, in degrees.
const REACH: f64 = 1.0;
const COLUMNS: usize = 4;
const PANEL: f64 = 300.0;

/// Draws the errors, in metres.
pub fn errors(ours: &[Solver], earth: &Truth, side: u32) -> Result<Svg, String> {
    let sphere = Truth::sphere(radius());
    let of = |surface| ours.iter().filter(move |s| s.surface == surface);
    let on_sphere = of(Surface::Sphere).map(|s| (s, &sphere, " on the sphere"));
    let on_earth = of(Surface::Ellipsoid).map(|s| (s, earth, ""));
    let mut double = of(Surface::Sphere).filter(|s| s.scalar == Scalar::F64);
    let as_model = double.next_back().into_iter().map(|s| (s, earth, " as the Earth"));
    let panels: Vec<_> = on_sphere.chain(on_earth).chain(as_model).collect();
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
        sheet.add(&title, &note(&cells, length), scale, side, &cells)?;
    }
    sheet.finish(scale, "error of the distance")
}

/// The largest value in words; or, where there are cells without an answer, their share.
fn note(cells: &[Option<f64>], words: impl Fn(f64) -> String) -> String {
    match cells.iter().filter(|cell| cell.is_none()).count() {
        0 => format!("≤ {}", words(cells.iter().copied().flatten().fold(0.0, f64::max))),
        none => format!("none for {}", percent(none as f64 / cells.len() as f64)),
    }
}

/// Draws how often the methods that iterate evaluate the longitude.
pub fn steps(side: u32) -> Result<Svg, String> {
    fn both<T: Real>(
        lift: impl Fn(f64) -> T + Copy + Sync,
    ) -> Result<[impl Fn(Pair) -> Option<f64> + Sync; 2], String> {
        let earth = Ellipsoid::<T>::WGS84;
        let vincenty = Vincenty::new(earth).map_err(|why| why.to_string())?;
        let karney = Karney::new(earth).map_err(|why| why.to_string())?;
        let count = move |pair: Pair, is_karney: bool| {
            let place = |p: Place| LatLon::new(lift(p.lat), lift(p.lon)).ok();
            let (from, to) = (place(pair.from)?, place(pair.to)?);
            let evaluations = if is_karney {
                Some(karney.solve(from, to).evaluations)
            } else {
                vincenty.evaluations(from, to)
            };
            evaluations.map(|count| count as f64)
        };
        Ok([false, true].map(|is_karney| move |pair| count(pair, is_karney)))
    }
    let scale = Scale {
        exponents: [0.0, 2.0],
        unit: |exponent| 10_u32.pow(exponent.unsigned_abs()).to_string(),
    };
    let mut sheet = Sheet::new(4);
    let mut draw = |title: &str, count: &(dyn Fn(Pair) -> Option<f64> + Sync)| {
        let cells: Vec<_> = pairs(side).into_par_iter().map(count).collect();
        sheet.add(title, &note(&cells, |most| most.to_string()), scale, side, &cells)
    };
    let [vincenty, karney] = both::<f64>(|x| x)?;
    draw("Vincenty, f64", &vincenty)?;
    draw("Karney, f64", &karney)?;
    let [vincenty, karney] = both::<f32>(|x| x as f32)?;
    draw("Vincenty, f32", &vincenty)?;
    draw("Karney, f32", &karney)?;
    sheet.finish(scale, "evaluations of the longitude")
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
        // The legend takes the next place, and a row of its own needs less height.
        let row = PANEL + 54.0;
        let last = if panels.is_multiple_of(COLUMNS) { 200.0 } else { row };
        Self {
            svg: Svg::new(1400.0, 40.0 + (panels / COLUMNS) as f64 * row + last),
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
            if self.drawn.is_multiple_of(COLUMNS) {
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
        if self.drawn.is_multiple_of(COLUMNS) {
            let middle = [area.x - 52.0, area.y + 0.5 * PANEL];
            self.svg.upright(middle, "small middle", "north of the antipode");
        }
        self.drawn += 1;
        Ok(())
    }

    /// The maps with their legend.
    fn finish(mut self, scale: Scale, title: &str) -> Result<Svg, String> {
        let place = Self::place(self.drawn);
        let bar = Area {
            x: place.x + 16.0,
            y: place.y + 110.0,
            width: PANEL - 32.0,
            height: 14.0,
        };
        scale.legend(&mut self.svg, bar, title)?;
        let swatch = Area {
            x: bar.x,
            y: bar.bottom() + 50.0,
            width: 26.0,
            height: 14.0,
        };
        hatch_legend(&mut self.svg, swatch, "no answer")?;
        Ok(self.svg)
    }
}
