//! The page that shows the pictures.

use std::path::Path;

use terrella::cube::{CubeMap, Projection};

use crate::catalogue::{self, Entry};
use crate::cli::Options;
use crate::globe::{self, CELLS, Grid};
use crate::measure::Measures;
use crate::{cross_file, globe_file};

/// The page's colour, around the pictures too.
pub const BACKGROUND: [u8; 3] = [0x0d, 0x11, 0x18];

/// The side of the square that a sketch is drawn in: fine enough for whole numbers.
const SKETCH: u16 = 800;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// A projection on the page.
pub struct Shown {
    projection: Projection,
    entry: Option<&'static Entry>,
    measures: Measures,
    sketch: Grid,
}

impl Shown {
    /// Gathers what is told about the projection of a map.
    pub fn of(map: &CubeMap<f64, Projection>) -> Self {
        let projection = map.projection();
        Self {
            projection,
            entry: catalogue::entry(projection),
            measures: Measures::of(projection),
            sketch: globe::sketch(map, SKETCH),
        }
    }

    fn title(&self) -> String {
        escaped(self.entry.map_or(self.projection.name(), |entry| entry.title))
    }

    fn keeps(&self) -> &'static str {
        match (self.measures.is_equal_area(), self.measures.is_conformal()) {
            (true, _) => "area",
            (_, true) => "angles",
            _ => "–",
        }
    }

    fn methods(&self) -> [&'static str; 2] {
        self.entry
            .map_or(["–"; 2], |entry| [entry.forward.name(), entry.inverse.name()])
    }
}

/// The whole page.
pub fn html(options: &Options, shown: &[Shown]) -> String {
    format!(
        r##"<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>An atlas of the cube</title>
<meta name="description" content="The Earth on the faces of a cube, in every projection of the crate terrella.">
<style>
{STYLE}</style>
</head>
<body>
<header>
<h1>An atlas of the cube</h1>
<p class="lead">A globe does not lie flat, but it can be pressed into a box. On six square faces nothing crowds at the poles, and squares
are what computers are good at: so the sky, the weather and the planets of games are kept on cubes. There are many ways to make the round
straight, and none has everything: equal areas, true angles, cells all alike, a formula that is quick. Here they are side by side.</p>
<p>For each projection there is the cube, unfolded, with the map of the Earth on it and a line every 15 degrees of latitude and longitude;
and the globe, with a grid of {CELLS} by {CELLS} cells laid over each face and carried back to the ground. The edges of the cube are
golden. What the cells of that grid look like on the globe is what a projection does to squares.</p>
</header>
<nav aria-label="Projections">
<ul class="sheet">
{sheet}</ul>
</nav>
<main>
<section aria-labelledby="comparison">
<h2 id="comparison">Comparison</h2>
<div class="scroll" role="region" aria-labelledby="comparison" tabindex="0">
<table>
<thead>
<tr><th scope="col" aria-sort="none">Projection</th><th scope="col" aria-sort="none">Keeps</th>{headings}<th scope="col" aria-sort="none">Sphere to cube</th><th scope="col" aria-sort="none">Cube to sphere</th></tr>
</thead>
<tbody>
{rows}</tbody>
</table>
</div>
<dl class="legend">
{legend}<div><dt>Sphere to cube, cube to sphere</dt><dd>how a place is found: <em>algebraic</em> takes arithmetic and square roots only, <em>closed
form</em> trigonometric functions too, <em>iteration</em> a few steps of Newton’s method</dd></div>
</dl>
<p class="note">All figures were measured on the sphere while this page was made, the best of each column in gold. The area ratio of a
conformal cube has no bound, since its cells vanish in the corners.</p>
</section>
{sections}</main>
<footer>
<p>Drawn by the example <code>atlas</code> of the crate <code>terrella</code>: {size} pixels to the edge of a face; map
<code>{input}</code>; ellipsoid <code>{ellipsoid}</code>, laid on the sphere by its {shift} latitude. Imagery: NASA Blue Marble, unless
another map was given. Coastline: Natural Earth. Both are in the public domain.</p>
</footer>
<script>
{SCRIPT}</script>
</body>
</html>
"##,
        sheet = shown.iter().map(sheet_item).collect::<String>(),
        headings = FIGURES.iter().map(heading).collect::<String>(),
        rows = shown.iter().map(|s| row(s, shown)).collect::<String>(),
        legend = FIGURES.iter().map(legend).collect::<String>(),
        sections = shown.iter().map(|s| section(s, options.size)).collect::<String>(),
        size = options.size,
        input = escaped(&file_name(&options.input)),
        ellipsoid = escaped(&options.ellipsoid_name),
        shift = options.shift,
    )
}

/// A measured column of the comparison.
struct Figure {
    name: &'static str,
    meaning: &'static str,
    decimals: usize,
    unit: &'static str,
    value: fn(&Measures) -> f64,
}

const FIGURES: &[Figure] = &[
    Figure {
        name: "Area ratio",
        meaning: "ground area of the largest cell over that of the smallest, for very small cells",
        decimals: 3,
        unit: "",
        value: |m| m.area_ratio,
    },
    Figure {
        name: "Aspect ratio",
        meaning: "a cell’s width over its height on the ground: the largest such value over the smallest",
        decimals: 3,
        unit: "",
        value: Measures::aspect_ratio,
    },
    Figure {
        name: "Oversize",
        meaning: "the larger of the aspect ratio and the same ratio of width times height: ε of Dimitrijević, Lambers and Rančić \
                  (2016), how much finer a texture must be than cells all alike would need",
        decimals: 3,
        unit: "",
        value: |m| m.oversize,
    },
    Figure {
        name: "Deformation",
        meaning: "the most that any angle changes, Tissot’s ω",
        decimals: 1,
        unit: "°",
        value: |m| m.deformation,
    },
    Figure {
        name: "Crease inside",
        meaning: "the sharpest turn, on the ground, of a straight grid line inside a face",
        decimals: 1,
        unit: "°",
        value: |m| m.inner_bend,
    },
    Figure {
        name: "Crease at edges",
        meaning: "the same where it goes on from one face to the next",
        decimals: 1,
        unit: "°",
        value: |m| m.edge_bend,
    },
];

impl Figure {
    fn text(&self, measures: &Measures) -> String {
        self.written((self.value)(measures))
    }

    fn written(&self, value: f64) -> String {
        if value.is_finite() {
            format!("{value:.*}{}", self.decimals, self.unit)
        } else {
            "∞".to_owned()
        }
    }
}

fn sheet_item(shown: &Shown) -> String {
    let (projection, title) = (shown.projection, shown.title());
    let (inner, edges) = (path(&shown.sketch.inner), path(&shown.sketch.edges));
    format!(
        "<li><a href=\"#{projection}\"><svg class=\"globe\" viewBox=\"0 0 {SKETCH} {SKETCH}\" aria-hidden=\"true\">\
         <path d=\"{inner}\"/><path class=\"edges\" d=\"{edges}\"/></svg><span>{title}</span></a></li>\n"
    )
}

/// Lines in the language of SVG, rounded to whole units.
fn path(lines: &[Vec<[f32; 2]>]) -> String {
    let line = |points: &Vec<[f32; 2]>| {
        let points: Vec<_> = points.iter().map(|[x, y]| format!("{x:.0} {y:.0}")).collect();
        format!("M{}", points.join(" "))
    };
    lines.iter().map(line).collect()
}

fn heading(figure: &Figure) -> String {
    format!(
        "<th scope=\"col\" class=\"number\" aria-sort=\"none\">{}</th>",
        figure.name
    )
}

fn legend(figure: &Figure) -> String {
    format!(
        "<div><dt>{}</dt><dd>{}</dd></div>\n",
        figure.name,
        escaped(figure.meaning)
    )
}

fn row(shown: &Shown, all: &[Shown]) -> String {
    let cell = |figure: &Figure| {
        let value = (figure.value)(&shown.measures);
        let least = all.iter().map(|s| (figure.value)(&s.measures)).fold(value, f64::min);
        // Figures that read the same are equally good.
        let is_best = all.len() > 1 && figure.written(value) == figure.written(least);
        let class = if is_best { "number best" } else { "number" };
        let sorted_by = if value.is_finite() { value } else { f64::MAX };
        format!(
            "<td class=\"{class}\" data-value=\"{sorted_by:e}\">{}</td>",
            figure.written(value)
        )
    };
    let figures: String = FIGURES.iter().map(cell).collect();
    let [forward, inverse] = shown.methods();
    format!(
        "<tr><th scope=\"row\"><a href=\"#{}\">{}</a></th><td>{}</td>{figures}<td>{forward}</td><td>{inverse}</td></tr>\n",
        shown.projection,
        shown.title(),
        shown.keeps(),
    )
}

fn section(shown: &Shown, size: u32) -> String {
    let (projection, title) = (shown.projection, shown.title());
    let [also, idea, origin] = shown
        .entry
        .map_or([""; 3], |entry| [entry.also, entry.idea, entry.origin]);
    let paragraph = |class: &str, text: &str| match text {
        "" => String::new(),
        text => format!("<p class=\"{class}\">{}</p>\n", escaped(text)),
    };
    let fact = |name: &str, value: &str| format!("<div><dt>{name}</dt><dd>{value}</dd></div>\n");
    let figures: String = FIGURES.iter().map(|f| fact(f.name, &f.text(&shown.measures))).collect();
    let [narrow, wide] = shown.measures.aspect;
    let [forward, inverse] = shown.methods();
    format!(
        r##"<article id="{projection}" aria-labelledby="{projection}-title">
<h2 id="{projection}-title">{title}</h2>
{also}{idea}<div class="pictures">
<figure><img class="cross" src="{cross}" width="{width}" height="{height}" alt="The Earth on the unfolded {title} cube: front, with Africa and Europe, between left and right; back at the far right; the Arctic above the front, Antarctica below." loading="lazy"></figure>
<figure><img class="globe" src="{globe}" width="{disc}" height="{disc}" alt="The globe, seen from above the Sahara, with the {CELLS} by {CELLS} grid of the {title} cube on the faces in sight." loading="lazy"></figure>
</div>
<dl class="facts">
{keeps}{figures}{range}{forward}{inverse}</dl>
{origin}</article>
"##,
        also = paragraph("also", also),
        idea = paragraph("idea", idea),
        cross = cross_file(projection),
        globe = globe_file(projection),
        width = 4 * size,
        height = 3 * size,
        disc = size * 3 / 2,
        keeps = fact("Keeps", shown.keeps()),
        range = fact("Width : height", &format!("{narrow:.2} to {wide:.2}")),
        forward = fact("Sphere to cube", forward),
        inverse = fact("Cube to sphere", inverse),
        origin = paragraph("origin", origin),
    )
}

fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}

fn escaped(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '&' => "&amp;".to_owned(),
            '<' => "&lt;".to_owned(),
            '>' => "&gt;".to_owned(),
            '"' => "&quot;".to_owned(),
            c => c.to_string(),
        })
        .collect()
}
