//! The bar that says which colour is which value.

use std::fmt::Write;

use crate::distortion::{QUANTITIES, Quantity};

/// Width and height of a legend, and of its bar.
const SIZE: [f64; 2] = [280.0, 34.0];
const BAR: [f64; 2] = [256.0, 10.0];

/// Colours in the gradient of a bar.
const STOPS: u32 = 32;

/// The legends of all quantities, once, to be used by [`legend`].
pub fn definitions() -> String {
    let symbols: String = QUANTITIES.iter().map(symbol).collect();
    format!("<svg class=\"definitions\" aria-hidden=\"true\">\n{symbols}</svg>\n")
}

/// The legend of a quantity.
pub fn legend(quantity: &Quantity) -> String {
    let [width, height] = SIZE;
    let ticks = quantity.scale.ticks();
    let from_to = match (ticks.first(), ticks.last()) {
        (Some(first), Some(last)) => format!("{} to {}", first.label, last.label),
        _ => String::new(),
    };
    format!(
        "<svg class=\"scale\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"Colours of {} from {from_to}\">\
         <use href=\"#scale-{}\"/></svg>\n",
        quantity.name.to_lowercase(),
        quantity.key,
    )
}

fn symbol(quantity: &Quantity) -> String {
    let (scale, key) = (quantity.scale, quantity.key);
    let ([width, height], [bar, thickness]) = (SIZE, BAR);
    let left = (width - bar) / 2.0;
    let mut text =
        format!("<symbol id=\"scale-{key}\" viewBox=\"0 0 {width} {height}\">\n<linearGradient id=\"colours-{key}\">");
    for stop in 0..=STOPS {
        let position = f64::from(stop) / f64::from(STOPS);
        let [red, green, blue] = scale.color(position);
        let _ = write!(
            text,
            "<stop offset=\"{position:.3}\" stop-color=\"#{red:02x}{green:02x}{blue:02x}\"/>"
        );
    }
    let _ = write!(
        text,
        "</linearGradient>\n<rect x=\"{left}\" y=\"1\" width=\"{bar}\" height=\"{thickness}\" fill=\"url(#colours-{key})\"/>\n"
    );
    for tick in scale.ticks() {
        let x = left + bar * scale.position(tick.value);
        let (from, to, below) = (1.0, thickness + 5.0, thickness + 19.0);
        let _ = writeln!(
            text,
            "<path d=\"M{x:.1} {from}V{to}\" stroke=\"currentColor\"/>\
             <text x=\"{x:.1}\" y=\"{below}\" fill=\"currentColor\" text-anchor=\"middle\">{}</text>",
            tick.label
        );
    }
    text + "</symbol>\n"
}
