//! The page over the pictures.

use crate::comparison::{self, Row};
use draw::page::escaped;

const STYLE: &str = include_str!("page.css");

/// A picture on the page.
pub struct Picture {
    /// Its file's name, without what follows the point.
    pub file: &'static str,
    pub title: &'static str,
    /// How to read it.
    pub legend: &'static str,
    /// What to conclude from it.
    pub conclusion: &'static str,
}

/// The whole page.
pub fn html(pictures: &[&Picture], rows: &[Row], pairs: usize) -> String {
    let figures: String = pictures.iter().map(|picture| figure(picture)).collect();
    let body = format!(
        r#"<header>
<h1>Where distances hold</h1>
<p class="lead">Every formula for the distance of two places is good somewhere. Between neighbours some lose their digits, over an ocean
some their model, and on the far side of the Earth, where every direction is nearly the shortest, some never come to an end. Here
is where.</p>
<p>All of it is measured on WGS84 while the page is made, with every method in <code>f64</code> and in <code>f32</code>. A method in
<code>f32</code> is given places that are rounded to <code>f32</code> first, and judged by the distance between those.</p>
</header>
<main>
{figures}<article aria-labelledby="comparison">
<h2 id="comparison">Next to other crates</h2>
<p class="note">{caption}</p>
<div class="scroll" role="region" aria-labelledby="comparison" tabindex="0">
{table}</div>
<p>{COMPARISON}</p>
</article>
</main>
<footer>
<p>Drawn by the program <code>stability</code> of the crate <code>terrella</code>.</p>
</footer>
"#,
        caption = escaped(&comparison::caption(pairs)),
        table = comparison::html(rows),
    );
    let description = "Errors and failures of the crate terrella's methods of distance, and of others.";
    draw::page::html("Where distances hold", description, STYLE, &body)
}

pub const DISTANCE: Picture = Picture {
    file: "distance",
    title: "From a millimetre to the antipode",
    legend: "The largest error among the pairs of each tenth of a decade. Left, the distance is counted from the first \
             place; right, from its antipode, since all that is hard happens there. Full lines are <code>f64</code>, \
             dashed ones <code>f32</code>. The bar at the top shows where a method gives no answer, the brighter the \
             more often. Haversine is under the great circle nearly everywhere.",
    conclusion: "In <code>f64</code> Karney stays within the nanometres that the reference itself is good for, from a \
                 millimetre to the antipode: without another reason, take it. Vincenty’s method of 1975 is within a \
                 tenth of a millimetre, and below a micrometre up to 100 km; from 90 km short of the antipode on it has \
                 no answer for some pairs, and nearer for most. It says so: ask Karney then. Andoyer costs a \
                 millionth of the distance and a bit, Andoyer’s second order a few billionths; both are for up to half \
                 of the way around, and tens of kilometres wrong at the end of it. Bowring holds a millimetre up to \
                 100 km; the flat model up to some kilometres, and less near a pole. The sphere is half a percent off \
                 at any distance, whatever the formula. In <code>f32</code> Vincenty, and in their range Bowring and \
                 the second Andoyer, keep seven digits of the distance, as far as they answer; Karney does so between \
                 neighbours, and keeps a metre or a few beyond.",
};

pub const ANTIPODE: Picture = Picture {
    file: "antipode",
    title: "The far side",
    legend: "The square of ±1° about the antipode of 30.1° N, 10.3° E, and the error of the distance to each place in \
             it; at the upper right the largest. The first row is measured against the sphere that these two methods \
             compute on, the rest against the Earth.",
    conclusion: "Karney is here what it is elsewhere: nanometres in <code>f64</code>, a metre or a few in \
                 <code>f32</code>, and an answer for every pair. Vincenty’s iteration has none in the hatched region, \
                 some 60 km to every side but along the meridian, and is right around it. Both of Andoyer’s formulas \
                 always answer, and are kilometres wrong. Haversine loses half of its digits: micrometres in <code>f64</code>, which \
                 no one will miss, but up to kilometres in <code>f32</code>; the great circle by Delambre’s formulas \
                 loses none. As a model of the Earth either is ten kilometres off anyway.",
};

pub const STEPS: Picture = Picture {
    file: "steps",
    title: "What the far side costs",
    legend: "How often a distance in the same square evaluates the longitude of its end; at the upper right the most, \
             or how many pairs have no answer.",
    conclusion: "Karney, by Newton’s steps, takes the same few nearly everywhere. Vincenty puts each longitude back \
                 into its equation; next to the antipode each step is nearly as long as the one before, and in the \
                 hatched region longer: dozens of evaluations where it answers, and a hundred, the bound, where it does \
                 not. Elsewhere on the Earth five are usual.",
};

pub const SECTION: Picture = Picture {
    file: "section",
    title: "Down to the centre of the Earth",
    legend: "From Earth-centred coordinates to latitude, longitude and height, over the section through the meridian \
             of 30° E: above up to 10 000 km, below the innermost 60 km. The error of latitude and longitude is what \
             it makes on the ground. The curves are the surface and, below, the evolute, inside which a point lies on \
             four verticals and not on two. Reference: the nearest point by Newton’s method with twice the digits of \
             <code>f64</code>.",
    conclusion: "There is no place where it fails, and no seam to see but those of rounding, where a number passes a \
                 power of two: a few nanometres in <code>f64</code> everywhere. In <code>f32</code> the place is \
                 within a metre, the height near the surface within millimetres and elsewhere within half of a metre. \
                 Only next to the cusp of the evolute, 43 km from the centre, where the latitude turns fastest, \
                 <code>f32</code> is some metres off.",
};

const COMPARISON: &str = "Of the crates in <code>f64</code>, <code>geographiclib-rs</code>, <code>geo</code>’s \
    <code>Geodesic</code> (which calls it), <code>geo3d</code> and this crate’s Karney agree to 15 nm and answer always. \
    Vincenty’s method, this crate’s and <code>geo</code>’s, answers one in four of the pairs near the antipode; both \
    say so, and what they do answer is right to a tenth of a millimetre. The columns headed wrong are those to look \
    at: the spherical formulas, the flat model, Bowring’s and Andoyer’s are given there what they are not made for, and say \
    nothing.";

fn figure(picture: &Picture) -> String {
    let Picture {
        file,
        title,
        legend,
        conclusion,
    } = picture;
    format!(
        "<article aria-labelledby=\"{file}\">\n<h2 id=\"{file}\">{title}</h2>\n<p class=\"note\">{legend}</p>\n\
         <figure><a href=\"{file}.png\"><img src=\"{file}.svg\" alt=\"{title}\"></a></figure>\n<p>{conclusion}</p>\n</article>\n"
    )
}
