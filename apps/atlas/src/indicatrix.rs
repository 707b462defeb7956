//! Tissot's ellipses: what small circles on the ground, all of one size, become on the unfolded cube.

use std::fmt::Write;

use terrella::cube::{CubeMap, Face, Projection};
use terrella::distortion::{Ground, Jacobian};

use crate::cross::{cell, on, pieces};
use crate::geography::Line;
use testkit::measure::{sphere, texel};

/// The edge of a face in the picture's units: fine enough for whole numbers.
const FACE: u32 = 800;

/// Around the cube, for what is larger than its cell.
const MARGIN: u32 = 24;

/// Ellipses along the edge of a face. Even: none is on a midline.
pub const ELLIPSES: u32 = 6;

/// Radius of an ellipse that is not deformed, over the distance to the next.
const RADIUS: f64 = 0.27;

/// How far from a place its sides are measured.
const BESIDE: f64 = 1e-6;

/// Corners of what is drawn on a crease: four of them on it.
const CORNERS: u32 = 48;

/// Steps of a coast that are shorter are left out.
const SHORTEST: f32 = 4.0;

/// Draws the unfolded cube.
pub fn svg(map: &CubeMap<f64, Projection>, coastline: &[Line]) -> String {
    let coast = pieces(map, coastline, FACE);
    let (width, height) = (4 * FACE + 2 * MARGIN, 3 * FACE + 2 * MARGIN);
    let mut text =
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-{MARGIN} -{MARGIN} {width} {height}\">\n");
    text += "<style>rect{fill:#131d2c;stroke:#3a4659;stroke-width:3}\
             path,ellipse{fill:#f0c878;fill-opacity:.2;stroke:#f0c878;stroke-width:4;stroke-linejoin:round}\
             .coast{fill:none;stroke:#a9bbd4;stroke-width:3.4}</style>\n";
    for face in Face::ALL {
        let (column, row) = cell(face);
        let (x, y) = (column * FACE, row * FACE);
        let _ = writeln!(
            text,
            "<g transform=\"translate({x} {y})\"><rect width=\"{FACE}\" height=\"{FACE}\"/>"
        );
        let _ = writeln!(
            text,
            "<path class=\"coast\" d=\"{}\"/>",
            on(face, &coast).map(path).collect::<String>()
        );
        text += &ellipses(map.projection(), face);
        text += "</g>\n";
    }
    text + "</svg>\n"
}

fn ellipses(projection: Projection, face: Face) -> String {
    let ground = sphere(projection);
    let circle = RADIUS * 2.0 / f64::from(ELLIPSES) * ground.unit();
    let at = |index: u32| f64::from(2 * index + 1) / f64::from(ELLIPSES) - 1.0;
    (0..ELLIPSES * ELLIPSES)
        .filter_map(|index| indicatrix(&ground, face, [at(index % ELLIPSES), at(index / ELLIPSES)], circle))
        .collect()
}

/// What a circle on the ground, of a radius in metres, becomes: an ellipse, or on a crease one part of an ellipse on each side.
fn indicatrix(ground: &Ground<f64, Projection>, face: Face, [x, y]: [f64; 2], circle: f64) -> Option<String> {
    let beside = |[right, up]: [f64; 2]| texel(ground, face, [x + BESIDE * right, y + BESIDE * up]);
    let first = beside([1.0, 0.0])?;
    let is_creased = [[-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]
        .into_iter()
        .filter_map(beside)
        .any(|other| (other.aspect() / first.aspect() - 1.0).abs() > 1e-3);
    if !is_creased {
        return Some(ellipse([x, y], circle, &first));
    }
    let half = f64::from(FACE) / 2.0;
    let corner = |index: u32| {
        let (up, right) = (f64::from(index) / f64::from(CORNERS) * std::f64::consts::TAU).sin_cos();
        let texel = beside([right, up])?;
        let step: [f64; 2] = std::array::from_fn(|i| right * texel.by_x[i] + up * texel.by_y[i]);
        let far = circle / f64::hypot(step[0], step[1]);
        Some(format!(
            "{:.1} {:.1}",
            half * (1.0 + x + far * right),
            half * (1.0 - y - far * up)
        ))
    };
    let corners: Vec<_> = (0..CORNERS).filter_map(corner).collect();
    Some(format!("<path d=\"M{}Z\"/>\n", corners.join("L")))
}

/// The ellipse of a circle on the ground, of a radius in metres: where the texel's lengths are least it is longest.
fn ellipse([x, y]: [f64; 2], circle: f64, texel: &Jacobian<f64>) -> String {
    let half = f64::from(FACE) / 2.0;
    let [shortest, longest] = texel.extremes();
    let ([a, b], [c, d]) = (texel.by_x, texel.by_y);
    let (slant, stretch) = (a * c + b * d, texel.width().powi(2) - texel.height().powi(2));
    // Of the direction on the face in which a step is longest on the ground; y is downward in the picture.
    let angle = -0.5 * (2.0 * slant).atan2(stretch).to_degrees();
    format!(
        "<ellipse rx=\"{:.1}\" ry=\"{:.1}\" transform=\"translate({:.0} {:.0}) rotate({angle:.1})\"/>\n",
        half * circle / longest,
        half * circle / shortest,
        half * (1.0 + x),
        half * (1.0 - y),
    )
}

/// A line in whole steps.
fn path(line: &[[f32; 2]]) -> String {
    let mut text = String::new();
    let mut last = [0.0; 2];
    for (index, &point) in line.iter().enumerate() {
        let point = point.map(f32::round);
        let [right, down] = [point[0] - last[0], point[1] - last[1]];
        let is_end = index + 1 == line.len();
        if index == 0 {
            let _ = write!(text, "M{} {}l", point[0], point[1]);
        } else if is_end || right.abs() + down.abs() >= SHORTEST {
            let _ = write!(text, "{right} {down} ");
        } else {
            continue;
        }
        last = point;
    }
    text
}
