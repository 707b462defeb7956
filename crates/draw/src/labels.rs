//! Names beside points, none over another.

/// A box: left, top, right, bottom.
pub type Area = [f64; 4];

/// A name that found its place.
pub struct Label<'a> {
    pub text: &'a str,
    /// The left end of the baseline.
    pub at: [f64; 2],
    /// The far end of a line from the point to the name, if it is not beside it.
    pub leader: Option<[f64; 2]>,
}

/// Height of a name, with what is around it.
const HEIGHT: f64 = 18.0;

/// From a point to its name beside it, and to one at the end of a line, from near to far.
const BESIDE: f64 = 9.0;
const AWAY: [f64; 9] = [20.0, 32.0, 45.0, 60.0, 76.0, 94.0, 114.0, 136.0, 160.0];

/// Directions in the order in which they are liked: for names beside their points, and for the others. Points come from the right, so
/// that lines that lean to the right leave room for the next.
const DIRECTIONS: [[f64; 2]; 8] = [
    [1.0, 0.0],
    [1.0, -0.7],
    [1.0, 0.7],
    [-1.0, 0.0],
    [-1.0, -0.7],
    [-1.0, 0.7],
    [0.0, -1.0],
    [0.0, 1.0],
];
const LEANING: [[f64; 2]; 8] = [
    [0.5, -1.0],
    [0.5, 1.0],
    [0.0, -1.0],
    [0.0, 1.0],
    [1.0, -0.7],
    [1.0, 0.7],
    [-0.5, -1.0],
    [-0.5, 1.0],
];

/// Half the side of the box around a point, around a place on a line, and around a point to which a name close by would seem to belong.
const POINT: f64 = 6.0;
const STROKE: f64 = 2.0;
const VICINITY: f64 = 16.0;

/// Finds places for names at points, within a frame and clear of what is taken already.
pub fn place<'a>(points: &[([f64; 2], &'a str)], frame: Area, taken: &[Area]) -> Vec<Label<'a>> {
    let mut taken = taken.to_vec();
    taken.extend(points.iter().map(|&(point, _)| around(point, POINT)));
    let mut labels = Vec::new();
    for &(point, text) in points {
        let places: Vec<_> = DIRECTIONS
            .map(|direction| (BESIDE, direction))
            .into_iter()
            .chain(
                AWAY.into_iter()
                    .flat_map(|distance| LEANING.map(|direction| (distance, direction))),
            )
            .map(|(distance, direction)| beside(point, text, distance, direction))
            .collect();
        let is_readable = |&(area, leader): &(Area, Option<[f64; 2]>)| {
            let inside = area[0] > frame[0] && area[1] > frame[1] && area[2] < frame[2] && area[3] < frame[3];
            let is_far = |&(other, _): &([f64; 2], &str)| {
                leader.is_some() || other == point || !overlap(area, around(other, VICINITY))
            };
            inside && taken.iter().all(|&other| !overlap(area, other)) && points.iter().all(is_far)
        };
        let is_free = |place: &(Area, Option<[f64; 2]>)| {
            let line = place.1.map(|end| along(point, end)).unwrap_or_default();
            let crosses = |&part: &Area| taken.iter().any(|&other| overlap(part, other));
            is_readable(place) && !line.iter().any(crosses)
        };
        // Where there is no room, a line crosses others; where there is none at all, names overlap.
        let mut best = places.iter().find(|&place| is_free(place));
        best = best.or_else(|| places.iter().find(|&place| is_readable(place)));
        let Some(&(area, leader)) = best.or(places.first()) else {
            continue;
        };
        taken.push(area);
        taken.extend(leader.map(|end| along(point, end)).unwrap_or_default());
        labels.push(Label {
            text,
            at: [area[0] + 2.0, area[3] - 5.0],
            leader,
        });
    }
    labels
}

/// The box of a name in a direction from a point, and the end of a line to it.
fn beside(point: [f64; 2], text: &str, distance: f64, direction: [f64; 2]) -> (Area, Option<[f64; 2]>) {
    let half = [0.5 * width(text), 0.5 * HEIGHT];
    let end: [f64; 2] = std::array::from_fn(|i| point[i] + distance * direction[i]);
    let middle: [f64; 2] =
        std::array::from_fn(|i| end[i] + half[i] * direction[i].signum() * f64::from(direction[i] != 0.0));
    let area = [
        middle[0] - half[0],
        middle[1] - half[1],
        middle[0] + half[0],
        middle[1] + half[1],
    ];
    (area, (distance > BESIDE).then_some(end))
}

/// The width of a name in letters 14 high, rather too wide than too narrow.
fn width(text: &str) -> f64 {
    let letter = |c: char| match c {
        'i' | 'l' | 'j' | 't' | 'f' | 'r' | ' ' | ',' | '-' => 5.5,
        c if c.is_lowercase() => 8.6,
        _ => 10.0,
    };
    text.chars().map(letter).sum::<f64>() + 4.0
}

/// Boxes along a line that leaves a point, from outside the point's own box.
fn along(from: [f64; 2], to: [f64; 2]) -> Vec<Area> {
    let length = f64::hypot(to[0] - from[0], to[1] - from[1]);
    (0..)
        .map(|step| POINT * 1.5 + STROKE + 3.0 * f64::from(step))
        .take_while(|&way| way < length - STROKE)
        .map(|way| {
            around(
                std::array::from_fn(|i| from[i] + way / length * (to[i] - from[i])),
                STROKE,
            )
        })
        .collect()
}

/// A box about a place.
pub fn around([x, y]: [f64; 2], half: f64) -> Area {
    [x - half, y - half, x + half, y + half]
}

fn overlap(a: Area, b: Area) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}
