//! The pictures of the projections' pages: the cells of a face on the sphere.
#![allow(missing_docs, clippy::unwrap_used)] // a test may fail loudly

use std::fmt::Write;

use terrella::cube::{CubeProjection, Face, FacePoint, Projection};
use testkit::generated;

/// Cells along an edge, and steps along a cell.
const CELLS: i32 = 8;
const STEPS: i32 = 3;

/// The sphere's radius in the picture.
const RADIUS: f64 = 500.0;

/// The picture's coordinates of a place: the view from above the middle of the face.
fn seen(face: Face, place: [f64; 3]) -> [i32; 2] {
    let [right, up, _] = face.to_local(place);
    [right, -up].map(|v| (RADIUS * v).round() as i32)
}

/// A line of the grid, as a path with relative coordinates.
fn line(projection: Projection, face: Face, at: i32, transposed: bool) -> String {
    let across = f64::from(2 * at - CELLS) / f64::from(CELLS);
    let places = (0..=CELLS * STEPS).map(|step| {
        let along = f64::from(2 * step) / f64::from(CELLS * STEPS) - 1.0;
        let [x, y] = if transposed { [across, along] } else { [along, across] };
        seen(
            face,
            projection.unproject(FacePoint::new(face, x, y).unwrap()).to_array(),
        )
    });
    let mut text = String::new();
    let mut last = [0, 0];
    for [x, y] in places {
        if text.is_empty() {
            write!(text, "M{x},{y}").unwrap();
            text.push('l');
        } else if [x, y] != last {
            let [dx, dy] = [x - last[0], y - last[1]];
            let space = if text.ends_with('l') || dx < 0 { "" } else { " " };
            write!(text, "{space}{dx},{dy}").unwrap();
        }
        last = [x, y];
    }
    text
}

/// Whether the polar faces are other than those of the sides.
fn has_two_kinds(projection: Projection) -> bool {
    projection.inverse(Face::Front, [0.5, 0.25]) != projection.inverse(Face::Top, [0.5, 0.25])
}

fn picture(projection: Projection) -> String {
    let faces: &[Face] = if has_two_kinds(projection) {
        &[Face::Front, Face::Top]
    } else {
        &[Face::Front]
    };
    let width = 1100 * faces.len() - 80;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-510 -510 {width} 1020\" width=\"{}\" height=\"204\" role=\"img\" \
         fill=\"none\" stroke=\"currentColor\" stroke-width=\"4\">\
         <title>The cells of the projection {projection} on the sphere</title>\n",
        width / 5
    );
    for (i, &face) in faces.iter().enumerate() {
        let cells = (0..=CELLS).flat_map(|at| [line(projection, face, at, false), line(projection, face, at, true)]);
        let cells: String = cells.collect();
        writeln!(
            text,
            "<g transform=\"translate({})\"><circle r=\"500\"/><path d=\"{cells}\"/></g>",
            1100 * i
        )
        .unwrap();
    }
    text + "</svg>\n"
}

#[test]
fn the_pictures_show_the_projections() {
    for &projection in Projection::ALL {
        let name = format!("src/cube/projection/pictures/{projection}.svg");
        generated::file(&name, &picture(projection));
    }
}
