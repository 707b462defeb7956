//! Every projection's rank by each criterion, by groups of criteria, and overall.
//!
//! In kind after Dimitrijević & Strobl, *Hexahedral projections: a comprehensive review and ranking* (ISPRS
//! International Journal of Geo-Information 14(3), 122, 2025).

use draw::page::escaped;

use crate::page::Shown;

/// A measure that projections are ranked by.
struct Criterion {
    group: &'static str,
    /// The heading of its column.
    short: &'static str,
    name: &'static str,
    /// What it tells, and whom.
    use_of: &'static str,
    decimals: usize,
    unit: &'static str,
    value: fn(&Shown) -> f64,
    better: Better,
}

#[derive(Clone, Copy, PartialEq)]
enum Better {
    Less,
    More,
}

use Better::{Less, More};

const CRITERIA: &[Criterion] = &[
    Criterion {
        group: "Areas",
        short: "ratio",
        name: "Area ratio",
        use_of: "The largest cell’s area over the smallest’s bounds the worst case: memory, or the number of samples in a cell.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.sphere.area_ratio(),
        better: Less,
    },
    Criterion {
        group: "Areas",
        short: "rms",
        name: "Area, rms",
        use_of: "The root of the mean square deviation of areas from their mean tells how even samples in all cells are; Zucker and \
                 Higashi (2018) optimised by it.",
        decimals: 4,
        unit: "",
        value: |s| s.measures.sphere.fair.area().rmsd(),
        better: Less,
    },
    Criterion {
        group: "Areas",
        short: "scale",
        name: "Areal scale, most",
        use_of: "The largest deviation of the areal scale from its fair share (D_A of Lambers, 2019) shows where a picture on the cube \
                 is wasteful or coarse.",
        decimals: 3,
        unit: "",
        value: areal_scale,
        better: Less,
    },
    Criterion {
        group: "Areas",
        short: "land",
        name: "Area on land, rms",
        use_of: "The same as the rms of areas, on land only and on the ellipsoid, for data that the sea has none of.",
        decimals: 4,
        unit: "",
        value: |s| s.land.area().rmsd(),
        better: Less,
    },
    Criterion {
        group: "Shapes",
        short: "ω",
        name: "Deformation, most",
        use_of: "Tissot’s ω bounds how wrong any angle can be that is measured on the map.",
        decimals: 1,
        unit: "°",
        value: |s| s.measures.sphere.worst.deformation().max(),
        better: Less,
    },
    Criterion {
        group: "Shapes",
        short: "a/b",
        name: "Isotropy, rms",
        use_of: "How far a small circle is drawn out, a/b of Tissot’s indicatrix (D_I of Lambers, 2019), in the mean: for filters and \
                 noise that should look alike in all directions.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.sphere.usual.isotropy().rmsd(),
        better: Less,
    },
    Criterion {
        group: "Shapes",
        short: "aspect",
        name: "Aspect ratio",
        use_of: "Width over height of texels, largest over smallest, tells how anisotropic a renderer’s filter has to be.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.sphere.worst.aspect().ratio(),
        better: Less,
    },
    Criterion {
        group: "Shapes",
        short: "land",
        name: "Isotropy on land, rms",
        use_of: "The same as the rms of isotropy, on land only and on the ellipsoid, for maps of coasts, roads and fields.",
        decimals: 3,
        unit: "",
        value: |s| s.land.isotropy().rmsd(),
        better: Less,
    },
    Criterion {
        group: "Continuity",
        short: "inside",
        name: "Kink inside",
        use_of: "The sharpest turn of a straight line inside a face matters where derivatives are taken across diagonals and midlines: \
                 flows, slopes, splines.",
        decimals: 1,
        unit: "°",
        value: |s| s.measures.inner_bend(),
        better: Less,
    },
    Criterion {
        group: "Continuity",
        short: "edges",
        name: "Kink at edges, rms",
        use_of: "The turn of a line that goes on to the next face, in the mean, is what a stencil or a brush meets at an edge of the cube.",
        decimals: 1,
        unit: "°",
        value: |s| s.measures.kinks.edges().rmsd(),
        better: Less,
    },
    Criterion {
        group: "Cells",
        short: "edge",
        name: "Edge ratio",
        use_of: "The longest edge of any cell over the shortest, as S2 has it, bounds the time step of a simulation on the grid.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.cells.edge().ratio(),
        better: Less,
    },
    Criterion {
        group: "Cells",
        short: "diagonal",
        name: "Diagonal ratio",
        use_of: "The longest diagonal of any cell over the shortest, as S2 has it, tells which level covers a circle with how many cells.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.cells.diagonal().ratio(),
        better: Less,
    },
    Criterion {
        group: "Cells",
        short: "compact",
        name: "Compactness, least",
        use_of: "Area over the square of the perimeter, 0.785 for a square and 1 for a circle, tells how well the worst cell stands for a \
                 place.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.cells.compactness().min(),
        better: More,
    },
    Criterion {
        group: "Cells",
        short: "spacing",
        name: "Spacing of neighbours",
        use_of: "The largest over the smallest distance from a cell’s centre to its four neighbours’ tells how far steps on the grid are \
                 from steps on the ground.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.cells.spacing().max(),
        better: Less,
    },
    Criterion {
        group: "Cells",
        short: "ε",
        name: "Oversize ε",
        use_of: "How much finer a texture must be than cells all alike would need (Dimitrijević, Lambers and Rančić, 2016): for terrain \
                 and games.",
        decimals: 3,
        unit: "",
        value: |s| s.measures.sphere.oversize(),
        better: Less,
    },
];

/// The largest deviation of the areal scale from 1, at the middles of cells.
fn areal_scale(shown: &Shown) -> f64 {
    let scale = shown.measures.sphere.fair.scale();
    (scale.max() - 1.0).max(1.0 - scale.min())
}

impl Criterion {
    /// What is written for a value.
    fn written(&self, value: f64) -> String {
        if value.is_finite() {
            format!("{value:.*}{}", self.decimals, self.unit)
        } else {
            "∞".to_owned()
        }
    }

    /// The values as they are compared: those that are written alike are equal, and less is better.
    fn scores(&self, shown: &[Shown]) -> Vec<f64> {
        let digits = 10.0_f64.powi(self.decimals as i32);
        let sign = if self.better == Less { 1.0 } else { -1.0 };
        shown
            .iter()
            .map(|s| sign * ((self.value)(s) * digits).round())
            .map(|score| if score.is_nan() { f64::INFINITY } else { score })
            .collect()
    }
}

/// For each score, 1 and one more for each that is better.
fn ranks(scores: &[f64]) -> Vec<usize> {
    scores
        .iter()
        .map(|score| 1 + scores.iter().filter(|other| *other < score).count())
        .collect()
}

/// The mean of several columns, in tenths.
fn means(columns: &[&[f64]]) -> Vec<f64> {
    let rows = columns.first().map_or(0, |column| column.len());
    (0..rows)
        .map(|row| {
            let sum: f64 = columns.iter().map(|column| column[row]).sum();
            sum / columns.len() as f64
        })
        .collect()
}

/// A column of the table.
struct Column {
    short: &'static str,
    ranks: Vec<usize>,
    /// What stands below each rank.
    notes: Vec<String>,
}

impl Column {
    /// Ranks by means of ranks.
    fn of_means(short: &'static str, means: &[f64]) -> Self {
        let rounded: Vec<f64> = means.iter().map(|mean| (mean * 10.0).round()).collect();
        Self {
            short,
            ranks: ranks(&rounded),
            notes: means.iter().map(|mean| format!("{mean:.1}")).collect(),
        }
    }
}

/// The section.
pub fn section(shown: &[Shown]) -> String {
    if shown.len() < 2 {
        return String::new();
    }
    let single: Vec<Column> = CRITERIA
        .iter()
        .map(|criterion| Column {
            short: criterion.short,
            ranks: ranks(&criterion.scores(shown)),
            notes: shown.iter().map(|s| criterion.written((criterion.value)(s))).collect(),
        })
        .collect();
    let as_numbers: Vec<Vec<f64>> = single
        .iter()
        .map(|column| column.ranks.iter().map(|&rank| rank as f64).collect())
        .collect();
    let mut first = 0;
    let groups: Vec<(&str, usize, Vec<f64>)> = CRITERIA
        .chunk_by(|a, b| a.group == b.group)
        .map(|group| {
            let columns: Vec<&[f64]> = as_numbers[first..first + group.len()]
                .iter()
                .map(Vec::as_slice)
                .collect();
            first += group.len();
            (group[0].group, group.len(), means(&columns))
        })
        .collect();
    let of_groups: Vec<&[f64]> = groups.iter().map(|(_, _, means)| means.as_slice()).collect();
    let overall = Column::of_means("overall", &means(&of_groups));
    let mut order: Vec<usize> = (0..shown.len()).collect();
    order.sort_by_key(|&row| overall.ranks[row]);
    let mut columns = vec![overall];
    columns.extend(groups.iter().map(|(group, _, means)| Column::of_means(group, means)));
    let by_groups = columns.len();
    columns.extend(single);

    let spans: String = groups
        .iter()
        .map(|(group, length, _)| format!("<th scope=\"colgroup\" colspan=\"{length}\">{group}</th>"))
        .collect();
    let headings: String = columns
        .iter()
        .map(|column| {
            format!(
                "<th scope=\"col\" class=\"number\" aria-sort=\"none\">{}</th>",
                column.short.to_lowercase()
            )
        })
        .collect();
    let rows: String = order.iter().map(|&row| self::row(&shown[row], &columns, row)).collect();
    let uses: String = CRITERIA
        .iter()
        .map(|criterion| {
            format!(
                "<div><dt>{}</dt><dd>{}</dd></div>\n",
                escaped(criterion.name),
                escaped(criterion.use_of)
            )
        })
        .collect();
    format!(
        r##"<section aria-labelledby="ranking">
<h2 id="ranking">Ranking</h2>
<p>Which cube is best depends on what it is for. Here each criterion has a column, with the rank of a projection and below it the
figure; 1 is the best, and figures that read the same share a rank. A group’s rank goes by the mean of its ranks, and the overall
rank by the mean of the four groups, each mean below its rank.</p>
<div class="scroll" role="region" aria-labelledby="ranking" tabindex="0">
<table class="ranks">
<caption class="hidden">Every projection’s rank overall, by groups and by each criterion. Each heading of a column sorts the table by it.</caption>
<thead>
<tr><td></td><th scope="colgroup" colspan="{by_groups}">Ranks</th>{spans}</tr>
<tr><th scope="col" aria-sort="none">Projection</th>{headings}</tr>
</thead>
<tbody>
{rows}</tbody>
</table>
</div>
<dl class="legend">
{uses}</dl>
<p class="note">Cells are those of faces divided into 64 × 64. A rank tells nothing of distances: look at the figures, and leave out what your
use does not need. Ranked in kind after Dimitrijević and Strobl, <cite>Hexahedral projections: a comprehensive review and ranking</cite>
(ISPRS International Journal of Geo-Information 14(3), 122, 2025).</p>
</section>
"##
    )
}

fn row(shown: &Shown, columns: &[Column], row: usize) -> String {
    let cells: String = columns
        .iter()
        .map(|column| {
            let (rank, note) = (column.ranks[row], &column.notes[row]);
            let class = if rank == 1 { "number best" } else { "number" };
            format!("<td class=\"{class}\" data-value=\"{rank}\">{rank}<small>{note}</small></td>")
        })
        .collect();
    format!(
        "<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th>{cells}</tr>\n",
        shown.projection,
        shown.title()
    )
}

#[cfg(test)]
mod tests {
    use super::{means, ranks};

    #[test]
    fn equal_scores_share_a_rank() {
        assert_eq!(ranks(&[3.0, 1.0, 3.0, 2.0, f64::INFINITY]), [3, 1, 3, 2, 5]);
        assert_eq!(means(&[&[1.0, 4.0], &[2.0, 8.0]]), [1.5, 6.0]);
    }
}
