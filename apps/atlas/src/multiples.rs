//! All projections side by side, one quantity at a time.

use crate::distortion::{QUANTITIES, Quantity};
use crate::legend::legend;
use crate::map_file;
use crate::page::Shown;

/// The section.
pub fn section(shown: &[Shown]) -> String {
    let quantities: String = QUANTITIES
        .iter()
        .map(|quantity| side_by_side(quantity, shown))
        .collect();
    format!(
        r##"<section aria-labelledby="side-by-side">
<h2 id="side-by-side">Side by side</h2>
<p>One face of every cube, coloured by what happens to a small texel, or cell of the grid, there. In each of the four sets a colour means the same for every projection.
The thin lines join places of one value: 19&nbsp;% more (the fourth root of 2) from line to line, the thicker one at 1, and 5 degrees more for angles. So a face
that is all one colour treats its cells alike, and many lines close together are a steep change.</p>
<p>The face is the front, around 0° N 0° E, and the others of a cube are like it. Only HEALPix has two kinds, and its top is shown too.</p>
{quantities}</section>
"##
    )
}

fn side_by_side(quantity: &Quantity, shown: &[Shown]) -> String {
    let items: String = shown.iter().map(|s| item(quantity, s)).collect();
    format!(
        "<div class=\"set\">\n<h3 id=\"set-{key}\">{name}</h3>\n<p>{reading}</p>\n{legend}<ul class=\"multiples\" aria-labelledby=\"set-{key}\">\n\
         {items}</ul>\n</div>\n",
        key = quantity.key,
        name = quantity.name,
        reading = quantity.reading,
        legend = legend(quantity),
    )
}

fn item(quantity: &Quantity, shown: &Shown) -> String {
    let (projection, title) = (shown.projection, shown.title());
    let kinds: &[(&str, &str, usize)] = if shown.measures.has_two_kinds() {
        &[("", ", side", 0), (" class=\"top\"", ", polar", 1)]
    } else {
        &[("", "", 0)]
    };
    kinds
        .iter()
        .map(|&(class, kind, index)| {
            format!(
                "<li><a href=\"#{projection}\"><img{class} src=\"{}\" alt=\"\" loading=\"lazy\"><span>{title}{kind}</span>\
                 <small>{}</small></a></li>\n",
                map_file(projection, quantity),
                (quantity.range)(&shown.measures.kinds[index])
            )
        })
        .collect()
}
