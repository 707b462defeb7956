//! What the page says of one projection.

use draw::page::escaped;
use terrella::cube::Profile;

use crate::distortion::{QUANTITIES, Quantity, face_size};
use crate::globe::CELLS;
use crate::indicatrix::ELLIPSES;
use crate::legend::legend;
use crate::page::Shown;
use crate::table::FIGURES;
use crate::{cross_file, ellipses_file, globe_file, map_file};

/// The article, with pictures of faces of `size` pixels.
pub fn article(shown: &Shown, size: u32) -> String {
    let (projection, title) = (shown.projection, shown.title());
    let Profile { also, idea, origin, .. } = *projection.profile();
    let paragraph = |class: &str, text: &str| match text {
        "" => String::new(),
        text => format!("<p class=\"{class}\">{}</p>\n", escaped(text)),
    };
    let fact = |name: &str, value: &str| format!("<div><dt>{name}</dt><dd>{value}</dd></div>\n");
    let figures: String = FIGURES.iter().map(|f| fact(f.name, &f.text(&shown.measures))).collect();
    let maps: String = QUANTITIES.iter().map(|quantity| map(shown, quantity, size)).collect();
    let [forward, inverse] = shown.methods();
    format!(
        r##"<article id="{projection}" aria-labelledby="{projection}-title">
<h2 id="{projection}-title">{title}</h2>
{also}{idea}<div class="pictures">
<figure><img class="cross" src="{cross}" width="{width}" height="{height}" alt="The Earth on the unfolded {title} cube: front, with Africa and Europe, between left and right; back at the far right; the Arctic above the front, Antarctica below." loading="lazy"></figure>
<figure><img class="globe" src="{globe}" width="{disc}" height="{disc}" alt="The globe, seen from above the Sahara, with the {CELLS} by {CELLS} grid of the {title} cube on the faces in sight." loading="lazy"></figure>
</div>
<div class="pictures">
<figure><img src="{ellipses}" width="{width}" height="{height}" alt="The unfolded {title} cube with coasts and {ELLIPSES} by {ELLIPSES} ellipses on each face: small circles on the ground, all of one size, as they appear on the cube." loading="lazy">
<figcaption>Circles on the ground, all of one size, as the cube shows them; on a crease each side has its own half</figcaption></figure>
<dl class="facts">
{keeps}{figures}{forward}{inverse}</dl>
</div>
<div class="maps">
{maps}</div>
{origin}</article>
"##,
        also = paragraph("also", also),
        idea = paragraph("idea", idea),
        cross = cross_file(projection),
        globe = globe_file(projection),
        ellipses = ellipses_file(projection),
        width = 4 * size,
        height = 3 * size,
        disc = size * 3 / 2,
        keeps = fact("Keeps", shown.keeps()),
        forward = fact("To the cube", forward),
        inverse = fact("Back", inverse),
        origin = paragraph("origin", origin),
    )
}

fn map(shown: &Shown, quantity: &Quantity, size: u32) -> String {
    let (projection, title, face) = (shown.projection, shown.title(), face_size(size));
    let range = (quantity.range)(&shown.measures.sphere);
    format!(
        "<figure><img src=\"{}\" width=\"{face}\" height=\"{}\" alt=\"{name} on the top and, below it, the front of the {title} cube, in \
         colours with lines of equal value and coasts: {range}.\" loading=\"lazy\">\n<figcaption>{name} <span>{range}</span></figcaption>\n{}</figure>\n",
        map_file(projection, quantity),
        2 * face,
        legend(quantity),
        name = quantity.name,
    )
}
