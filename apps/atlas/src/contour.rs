//! Lines of equal value, by marching squares: open at the border of the picture, where the crate `contour` closes them into rings.

/// A short straight line, in pixels.
pub type Segment = [[f32; 2]; 2];

/// The lines on which a field has a value. The field is given at the pixel centres of a square of `size`, row by row.
pub fn contour(field: &[f64], size: usize, value: f64) -> Vec<Segment> {
    // A field that is equal to the value everywhere but for rounding has no line.
    let value = value + 1e-9;
    let mut segments = Vec::new();
    for row in 0..size - 1 {
        for column in 0..size - 1 {
            let corners = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[right, down]| {
                let (x, y) = (column + right, row + down);
                ([x as f64 + 0.5, y as f64 + 0.5], field[y * size + x])
            });
            let mut ends = (0..4).filter_map(|i| crossing(corners[i], corners[(i + 1) % 4], value));
            while let (Some(from), Some(to)) = (ends.next(), ends.next()) {
                segments.push([from, to]);
            }
        }
    }
    segments
}

/// Where the value is between two places, if it is.
fn crossing((from, a): ([f64; 2], f64), (to, b): ([f64; 2], f64), value: f64) -> Option<[f32; 2]> {
    ((a < value) != (b < value)).then(|| {
        let along = (value - a) / (b - a);
        std::array::from_fn(|i| (from[i] + along * (to[i] - from[i])) as f32)
    })
}
