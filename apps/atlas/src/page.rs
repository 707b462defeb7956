//! The page that shows the pictures.

use std::path::Path;

use terrella::cube::{CubeMap, Face, Projection};
use terrella::distortion::{Ground, Survey};

use draw::page::escaped;

use crate::article::article;
use crate::cli::Options;
use crate::globe::{self, CELLS, Grid};
use crate::land::Land;
use crate::orientation::{self, Orientation};
use crate::{legend, multiples, pareto, ranking, table};
use testkit::measure::Measures;

/// The side of the square that a sketch is drawn in: fine enough for whole numbers.
const SKETCH: u16 = 800;

/// Places along the edge of a face where land is looked for.
const LAND: u32 = 128;

const STYLE: &str = include_str!("page.css");
const SCRIPT: &str = include_str!("page.js");

/// A projection on the page.
pub struct Shown {
    pub projection: Projection,
    pub measures: Measures,
    /// Of the land, on the ellipsoid.
    pub land: Survey<f64>,
    /// The cube turned for the land, if that gains anything.
    pub orientation: Option<Orientation>,
    sketch: Grid,
}

impl Shown {
    /// Gathers what is told about the projection of a map.
    pub fn of(map: &CubeMap<f64, Projection>, land: &Land) -> Self {
        let projection = map.projection();
        let ground = Ground::new(*map);
        let mut dry = Survey::new(ground.fair_texel());
        for face in Face::ALL {
            dry.face_where(&ground, face, LAND, |normal| land.holds(normal));
        }
        Self {
            projection,
            measures: Measures::of(projection),
            land: dry,
            orientation: orientation::search(projection, land),
            sketch: globe::sketch(map, SKETCH),
        }
    }

    /// Its name.
    pub fn title(&self) -> String {
        escaped(self.projection.profile().title)
    }

    /// What it leaves as it is.
    pub fn keeps(&self) -> &'static str {
        match (self.measures.is_equal_area(), self.measures.sphere.is_conformal()) {
            (true, _) => "area",
            (_, true) => "angles",
            _ => "–",
        }
    }

    /// How it is computed to the cube and back.
    pub fn methods(&self) -> [&'static str; 2] {
        let profile = self.projection.profile();
        [profile.forward, profile.inverse].map(|evaluation| evaluation.formula.name())
    }
}

/// The whole page.
pub fn html(options: &Options, shown: &[Shown]) -> String {
    let body = format!(
        r##"{definitions}<header>
<h1>An atlas of the cube</h1>
<p class="lead">A globe does not lie flat, but it can be pressed into a box. On six square faces nothing crowds at the poles, and squares
are what computers are good at: so the sky, the weather and the planets of games are kept on cubes. There are many ways to make the round
straight, and none has everything: equal areas, true angles, cells all alike, a formula that is quick. Here they are side by side.</p>
<p>For each projection there is the cube, unfolded, with the map of the Earth on it and a line every 15 degrees of latitude and longitude;
and the globe, with a grid of {CELLS} by {CELLS} cells laid over each face and carried back to the ground. The edges of the cube are
golden. What the cells of that grid look like on the globe is what a projection does to squares. The figures are in the
<a href="#comparison">comparison</a>, who is best at what in the <a href="#ranking">ranking</a>, where to turn the cube in
<a href="#orientation">turned for the land</a>, and what the figures mean is drawn as <a href="#bargains">points in a plane</a> and in
<a href="#side-by-side">colours on the faces</a>.</p>
</header>
<nav aria-label="Projections">
<ul class="sheet">
{sheet}</ul>
</nav>
<main>
<section aria-labelledby="comparison">
<h2 id="comparison">Comparison</h2>
<div class="scroll" role="region" aria-labelledby="comparison" tabindex="0">
{table}</div>
<dl class="legend">
{meanings}<div><dt>Method</dt><dd>how a place is found on the cube, and on the ground: <em>algebraic</em> takes arithmetic and square roots only,
<em>closed form</em> trigonometric functions too, <em>iteration</em> a few steps of Newton’s method</dd></div>
</dl>
<p class="note">All figures and colours were measured on the sphere while this page was made, by dual numbers, the best of each column in
gold; a heading that is pressed sorts by its column. The areas of a conformal cube have no bound, since its cells vanish in the corners.</p>
</section>
{ranking}{orientation}<section aria-labelledby="bargains">
<h2 id="bargains">Bargains</h2>
<p>What is won in the shape of cells is paid in their size. Each point is a projection, and better is down and to the left. Those
in gold were made for terrella.</p>
<figure class="plot">
<div class="scroll" role="region" aria-label="Aspect ratio against width × height ratio" tabindex="0">
{texels}</div>
<figcaption>Both ratios are 1 for cells all alike. Below the straight line is nothing, which can be proved for maps as symmetric as the
square: a midline of a face and its edge are arcs of different lengths, and equally long on the cube. The curve is the best that a search
over smooth maps of that kind found. On each dotted corner the oversize ε is the same. The conformal cube is far above.</figcaption>
</figure>
<figure class="plot">
<div class="scroll" role="region" aria-label="True area ratio against the largest deformation" tabindex="0">
{shapes}</div>
<figcaption>At a corner three right angles of the cube are three angles of 120° on the ground. A smooth map as symmetric as the square cannot hide that,
and has ω = 31.08° there or more; most have their largest there. Creases go below the line (quadrilateralized, vertex), and so does the conformal cube, far to the right, whose cells
vanish at the corners.</figcaption>
</figure>
</section>
{multiples}{articles}</main>
<footer>
<p>Drawn by the program <code>atlas</code> of the crate <code>terrella</code>: {size} pixels to the edge of a face; map
<code>{input}</code>; ellipsoid <code>{ellipsoid}</code>, laid on the sphere by its {shift} latitude. Imagery: NASA Blue Marble, unless
another map was given. Coastline: Natural Earth. Both are in the public domain.</p>
</footer>
<script>
{SCRIPT}</script>
"##,
        definitions = legend::definitions(),
        sheet = shown.iter().map(sheet_item).collect::<String>(),
        table = table::table(shown),
        meanings = table::meanings(),
        ranking = ranking::section(shown),
        orientation = orientation::section(shown),
        texels = pareto::texels(shown),
        shapes = pareto::shapes(shown),
        multiples = multiples::section(shown),
        articles = shown.iter().map(|s| article(s, options.size)).collect::<String>(),
        size = options.size,
        input = escaped(&file_name(&options.input)),
        ellipsoid = escaped(&options.ellipsoid_name),
        shift = options.shift,
    );
    let description = "The Earth on the faces of a cube, in every projection of the crate terrella.";
    draw::page::html("An atlas of the cube", description, STYLE, &body)
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

fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or(path.as_os_str())
        .to_string_lossy()
        .into_owned()
}
