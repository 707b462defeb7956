//! Criteria against an independent program, on the same places: `tests/truth/make_criteria.py`.

use terrella::cube::{Face, Projection};
use terrella::distortion::{Cells, Kinks, Statistic, Survey};
use testkit::Worst;
use testkit::truth::Truth;

use crate::sphere::{at, unit_sphere};

/// The numbers of places and cells that the program takes.
const COLUMNS: u32 = 30;
const ROWS: u32 = 32;
const CELLS: u32 = 16;
const PLACES: u32 = 40;

/// Minimum, maximum, mean and RMSD: all NaN if one of the values was.
fn figures(statistic: &Statistic<f64>) -> [f64; 4] {
    let seen = [statistic.min(), statistic.max(), statistic.mean(), statistic.rmsd()];
    if statistic.mean().is_finite() {
        seen
    } else {
        [f64::NAN; 4]
    }
}

struct Measured {
    texels: Survey<f64>,
    cells: Cells<f64>,
    kinks: Kinks<f64>,
}

impl Measured {
    fn of(projection: Projection, face: Face) -> Self {
        let ground = unit_sphere(projection);
        let mut texels = Survey::new(ground.fair_texel());
        let middle = |i: u32, n: u32| f64::from(2 * i + 1) / f64::from(n) - 1.0;
        for i in 0..COLUMNS * ROWS {
            let point = at(face, middle(i % COLUMNS, COLUMNS), middle(i / COLUMNS, ROWS));
            texels.include(point, &ground.jacobian(point).unwrap());
        }
        let (mut cells, mut kinks) = (Cells::new(), Kinks::new());
        cells.face(&ground, face, CELLS);
        kinks.face(&ground, face, PLACES);
        assert_eq!(kinks.skipped(), 0);
        Self { texels, cells, kinks }
    }

    fn statistic(&self, criterion: &str) -> &Statistic<f64> {
        let Self { texels, cells, kinks } = self;
        match criterion {
            "texel-area" => texels.area(),
            "texel-scale" => texels.scale(),
            "texel-isotropy" => texels.isotropy(),
            "cell-area" => cells.area(),
            "cell-edge" => cells.edge(),
            "cell-diagonal" => cells.diagonal(),
            "cell-span" => cells.span(),
            "cell-edge-aspect" => cells.edge_aspect(),
            "cell-diagonal-aspect" => cells.diagonal_aspect(),
            "cell-compactness" => cells.compactness(),
            "cell-spacing" => cells.spacing(),
            "kink-edges" => kinks.edges(),
            "kink-diagonals" => kinks.diagonals(),
            "kink-midlines" => kinks.midlines(),
            other => panic!("no criterion {other}"),
        }
    }
}

#[test]
fn every_figure_of_the_other_program() {
    let truth = Truth::read("criteria");
    for face in [Face::Front, Face::Bottom] {
        let mut known: Option<(String, Measured)> = None;
        let (mut worst, mut worst_kink, mut seen) = (Worst::default(), Worst::default(), 0);
        for row in truth.exact_in::<f64>(&[]) {
            let name = row.text("map");
            if known.as_ref().is_none_or(|(known, _)| known != name) {
                known = Some((name.to_owned(), Measured::of(name.parse().unwrap(), face)));
            }
            let criterion = row.text("criterion");
            let (_, measured) = known.as_ref().unwrap();
            let expected = ["min", "max", "mean", "rmsd"].map(|column| row.value(column));
            for (seen, expected) in figures(measured.statistic(criterion)).into_iter().zip(expected) {
                let error = (seen - expected).abs();
                let kink = criterion.starts_with("kink");
                if kink {
                    worst_kink.add(error)
                } else {
                    worst.add(error)
                };
                let most = if kink { 1e-6 } else { 1e-9 };
                assert!(error <= most, "{name}, {criterion}: {seen} is not {expected}");
            }
            seen += 1;
        }
        println!("{face:?}: {:.1e}, kinks {:.1e}°", worst.value(), worst_kink.value());
        assert!(seen > 100 && worst.value() <= 1e-9 && worst_kink.value() <= 1e-6);
    }
}
