//! From SVG to pixels.

use std::sync::Arc;

use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::{Database, Family, Query};
use resvg::usvg::{Options, Tree};

/// Pixels to a unit of the drawing.
const ZOOM: f32 = 1.5;

/// The machine's fonts.
pub struct Fonts(Arc<Database>);

impl Fonts {
    /// Finds them; there may be none.
    pub fn find() -> Self {
        let mut fonts = Database::new();
        fonts.load_system_fonts();
        let sans_serif = Query {
            families: &[Family::SansSerif],
            ..Query::default()
        };
        if fonts.query(&sans_serif).is_none() {
            let any = fonts
                .faces()
                .find(|face| !face.monospaced)
                .or_else(|| fonts.faces().next());
            if let Some((name, _)) = any.and_then(|face| face.families.first()).cloned() {
                fonts.set_sans_serif_family(name);
            }
        }
        Self(Arc::new(fonts))
    }

    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

/// The picture as a PNG.
pub fn png(svg: &str, fonts: &Fonts) -> Result<Vec<u8>, String> {
    let options = Options {
        fontdb: Arc::clone(&fonts.0),
        ..Options::default()
    };
    let tree = Tree::from_str(svg, &options).map_err(|error| error.to_string())?;
    let size = tree
        .size()
        .to_int_size()
        .scale_by(ZOOM)
        .ok_or("the picture has no size")?;
    let mut pixels = Pixmap::new(size.width(), size.height()).ok_or("the picture has no size")?;
    resvg::render(&tree, Transform::from_scale(ZOOM, ZOOM), &mut pixels.as_mut());
    pixels.encode_png().map_err(|error| error.to_string())
}
