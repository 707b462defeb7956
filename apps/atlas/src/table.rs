//! The table of all projections, and what its columns mean.

use draw::page::escaped;
use testkit::measure::{Measures, Surveys};

use crate::page::Shown;

/// A measured column.
pub struct Figure {
    /// Of the columns that stand together.
    group: &'static str,
    short: &'static str,
    /// Standing alone.
    pub name: &'static str,
    /// Of the first of a group, for the group; of others only if they need one.
    meaning: &'static str,
    decimals: usize,
    unit: &'static str,
    value: Value,
    best: Best,
}

/// Where a figure comes from.
enum Value {
    /// From places: every kind of face has its own.
    Survey(fn(&Surveys) -> f64),
    /// From the whole cube.
    Cube(fn(&Measures) -> f64),
}

#[derive(Clone, Copy, PartialEq)]
enum Best {
    Least,
    Greatest,
}

use Value::{Cube, Survey};

pub const FIGURES: &[Figure] = &[
    Figure {
        group: "Aspect",
        short: "min",
        name: "Aspect, least",
        meaning: "a cell’s width over its height on the ground, for very small cells: the smallest and the largest such value, the \
                  largest over the smallest, and the root of the mean square of what it is off from 1",
        decimals: 3,
        unit: "",
        value: Survey(|s| s.worst.aspect().min()),
        best: Best::Greatest,
    },
    Figure {
        group: "Aspect",
        short: "max",
        name: "Aspect, most",
        meaning: "",
        decimals: 3,
        unit: "",
        value: Survey(|s| s.worst.aspect().max()),
        best: Best::Least,
    },
    Figure {
        group: "Aspect",
        short: "ratio",
        name: "Aspect ratio",
        meaning: "",
        decimals: 3,
        unit: "",
        value: Survey(|s| s.worst.aspect().ratio()),
        best: Best::Least,
    },
    Figure {
        group: "Aspect",
        short: "RMSD",
        name: "Aspect RMSD",
        meaning: "",
        decimals: 3,
        unit: "",
        value: Survey(|s| s.usual.aspect().rmsd()),
        best: Best::Least,
    },
    Figure {
        group: "Width × height",
        short: "ratio",
        name: "Width × height ratio",
        meaning: "the same of width times height, over that of the cell in the middle of the front; more than the area where the \
                  grid is askew",
        decimals: 3,
        unit: "",
        value: Survey(Surveys::sides_ratio),
        best: Best::Least,
    },
    Figure {
        group: "Width × height",
        short: "RMSD",
        name: "Width × height RMSD",
        meaning: "",
        decimals: 3,
        unit: "",
        value: Survey(|s| s.usual.sides().rmsd()),
        best: Best::Least,
    },
    Figure {
        group: "True area",
        short: "ratio",
        name: "True area ratio",
        meaning: "ground area of the largest cell over that of the smallest",
        decimals: 3,
        unit: "",
        value: Survey(Surveys::area_ratio),
        best: Best::Least,
    },
    Figure {
        group: "Deformation",
        short: "ω max",
        name: "Deformation, most",
        meaning: "the most that any angle changes at a place, Tissot’s ω: the largest, and the root of the mean square",
        decimals: 1,
        unit: "°",
        value: Survey(|s| s.worst.deformation().max()),
        best: Best::Least,
    },
    Figure {
        group: "Deformation",
        short: "ω rms",
        name: "Deformation, rms",
        meaning: "",
        decimals: 1,
        unit: "°",
        value: Survey(|s| s.usual.deformation().rmsd()),
        best: Best::Least,
    },
    Figure {
        group: "Oversize",
        short: "ε",
        name: "Oversize ε",
        meaning: "the larger of the aspect ratio and the width × height ratio: ε of Dimitrijević, Lambers and Rančić (2016), how much \
                  finer a texture must be than cells all alike would need",
        decimals: 3,
        unit: "",
        value: Survey(Surveys::oversize),
        best: Best::Least,
    },
    Figure {
        group: "Crease",
        short: "inside",
        name: "Crease inside",
        meaning: "the sharpest turn, on the ground, of a straight line of the map that crosses a diagonal or midline of a face, \
                  and where it goes on from one face to the next",
        decimals: 1,
        unit: "°",
        value: Cube(Measures::inner_bend),
        best: Best::Least,
    },
    Figure {
        group: "Crease",
        short: "at edges",
        name: "Crease at edges",
        meaning: "",
        decimals: 1,
        unit: "°",
        value: Cube(|m| m.kinks.edges().max()),
        best: Best::Least,
    },
];

impl Figure {
    fn value(&self, measures: &Measures) -> f64 {
        match self.value {
            Survey(value) => value(&measures.sphere),
            Cube(value) => value(measures),
        }
    }

    /// The figure of a projection, in words.
    pub fn text(&self, measures: &Measures) -> String {
        self.written(self.value(measures))
    }

    fn written(&self, value: f64) -> String {
        if value.is_finite() {
            format!("{value:.*}{}", self.decimals, self.unit)
        } else {
            "∞".to_owned()
        }
    }

    fn cell(&self, value: f64, is_best: bool) -> String {
        let class = if is_best { "number best" } else { "number" };
        let sorted_by = if value.is_finite() { value } else { f64::MAX };
        format!(
            "<td class=\"{class}\" data-value=\"{sorted_by:e}\">{}</td>",
            self.written(value)
        )
    }

    /// Figures that read the same are equally good.
    fn is_best(&self, value: f64, all: &[Shown]) -> bool {
        let better = if self.best == Best::Least { f64::min } else { f64::max };
        let best = all.iter().map(|s| self.value(&s.measures)).fold(value, better);
        all.len() > 1 && self.written(value) == self.written(best)
    }
}

/// The comparison of projections.
pub fn table(shown: &[Shown]) -> String {
    let heading = |figure: &Figure| {
        format!(
            "<th scope=\"col\" class=\"number\" aria-sort=\"none\">{}</th>",
            figure.short
        )
    };
    let groups: String = FIGURES
        .chunk_by(|a, b| a.group == b.group)
        .map(|group| {
            format!(
                "<th scope=\"colgroup\" colspan=\"{}\">{}</th>",
                group.len(),
                group[0].group
            )
        })
        .collect();
    format!(
        "<table>\n<caption class=\"hidden\">Every projection in figures. Each heading of a column sorts the table by it.</caption>\n<thead>\n\
         <tr><td colspan=\"2\"></td>{groups}<th scope=\"colgroup\" colspan=\"2\">Method</th></tr>\n\
         <tr><th scope=\"col\" aria-sort=\"none\">Projection</th><th scope=\"col\" aria-sort=\"none\">Keeps</th>{}\
         <th scope=\"col\" aria-sort=\"none\">to the cube</th><th scope=\"col\" aria-sort=\"none\">back</th></tr>\n\
         </thead>\n<tbody>\n{}</tbody>\n</table>\n",
        FIGURES.iter().map(heading).collect::<String>(),
        shown.iter().map(|s| rows(s, shown)).collect::<String>()
    )
}

/// What the columns mean.
pub fn meanings() -> String {
    FIGURES
        .iter()
        .filter(|figure| !figure.meaning.is_empty())
        .map(|figure| {
            format!(
                "<div><dt>{}</dt><dd>{}</dd></div>\n",
                figure.group,
                escaped(figure.meaning)
            )
        })
        .collect()
}

/// A projection, and each kind of face if they differ.
fn rows(shown: &Shown, all: &[Shown]) -> String {
    let (projection, title) = (shown.projection, shown.title());
    let figures: String = FIGURES
        .iter()
        .map(|figure| {
            let value = figure.value(&shown.measures);
            figure.cell(value, figure.is_best(value, all))
        })
        .collect();
    let link = |name: &str| format!("<th scope=\"row\"><a href=\"#{projection}\">{title}</a>{name}</th>");
    let mut text = row("", &link(""), &figures, shown);
    if shown.measures.has_two_kinds() {
        for (surveys, name) in shown.measures.kinds.iter().zip([", side face", ", polar face"]) {
            let cell = |figure: &Figure| match figure.value {
                Survey(value) => figure.cell(value(surveys), false),
                Cube(_) => format!("<td class=\"number\" data-value=\"{:e}\">–</td>", f64::MAX),
            };
            let figures: String = FIGURES.iter().map(cell).collect();
            text += &row(" class=\"part\"", &link(name), &figures, shown);
        }
    }
    text
}

fn row(class: &str, heading: &str, figures: &str, shown: &Shown) -> String {
    let [forward, inverse] = shown.methods();
    format!(
        "<tr{class}>{heading}<td>{}</td>{figures}<td>{forward}</td><td>{inverse}</td></tr>\n",
        shown.keeps()
    )
}
