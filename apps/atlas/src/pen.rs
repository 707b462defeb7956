//! Thin, translucent lines.

use tiny_skia::{Color, LineCap, LineJoin, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// A colour and a width.
#[derive(Clone, Copy)]
pub struct Pen {
    color: [u8; 4],
    width: f32,
}

impl Pen {
    /// Of red, green, blue and opacity, and a width in pixels of a picture 512 pixels high.
    pub const fn new(color: [u8; 4], width: f32) -> Self {
        Self { color, width }
    }

    /// Strokes all lines at once, so that where they cross they do not shine through each other.
    ///
    /// Points are in pixels. The round ends reach over the border of the picture and are cut there.
    pub fn draw<'a>(self, pixmap: &mut Pixmap, lines: impl Iterator<Item = &'a [[f32; 2]]>) {
        let mut path = PathBuilder::new();
        for line in lines {
            let mut last = [f32::NAN; 2];
            for (i, &[x, y]) in line.iter().enumerate() {
                if i == 0 {
                    path.move_to(x, y);
                } else if (x - last[0]).abs() + (y - last[1]).abs() > SHORTEST {
                    path.line_to(x, y);
                } else {
                    continue;
                }
                last = [x, y];
            }
        }
        let Some(path) = path.finish() else { return };
        let [r, g, b, a] = self.color;
        let mut paint = Paint::default();
        paint.set_color(Color::from_rgba8(r, g, b, a));
        let stroke = Stroke {
            width: (self.width * pixmap.height() as f32 / 512.0).max(THINNEST),
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            ..Stroke::default()
        };
        pixmap.stroke_path(&path, &paint, &stroke, Transform::identity(), None);
    }
}

/// Steps below this many pixels have no direction worth joining.
const SHORTEST: f32 = 1e-3;

/// Pixels.
const THINNEST: f32 = 0.5;
