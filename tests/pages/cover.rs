//! The picture at the top of the README: the Earth in tiles of equal area, on the globe and on the unfolded cube.

use std::fmt::Write;
use std::fs;

use terrella::cube::{CubeMap, Face, FacePoint, Vertex};
use terrella::{Ellipsoid, LatLon, Shift};
use testkit::generated;

/// Tiles along an edge of a face.
const TILES: i32 = 24;

/// Colours of the sea and of the land, by face.
const COLOURS: [[&str; 2]; 6] = [
    ["#dce9f5", "#2f6f9f"],
    ["#e3f1e4", "#3c8a57"],
    ["#f3e6f1", "#8f5a94"],
    ["#fbeada", "#c57a2c"],
    ["#eeeeee", "#6c7680"],
    ["#f8f3d6", "#a8901f"],
];

/// Where a face is on the unfolded cube: column and row.
const NET: [[i32; 2]; 6] = [[1, 1], [2, 1], [3, 1], [0, 1], [1, 0], [1, 2]];

/// The globe: its centre, its radius, and where it is seen from.
const GLOBE: [f64; 2] = [205.0, 205.0];
const RADIUS: f64 = 185.0;
/// The globe's paths are in quarters.
const SCALE: f64 = 4.0;
const FROM: [f64; 2] = [32.0, 32.0];

/// The unfolded cube: its corner, and the edge of a face.
const CORNER: [i32; 2] = [505, 25];
const EDGE: i32 = 120;

/// The coasts, as closed rings of longitude and latitude.
fn land() -> Vec<Vec<[f64; 2]>> {
    let text = fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/crates/draw/data/land-110m.tsv")).unwrap();
    let mut rings: Vec<Vec<[f64; 2]>> = Vec::new();
    for row in text.lines().filter(|row| !row.starts_with('#')).skip(1) {
        let numbers: Vec<f64> = row.split('\t').map(|number| number.parse().unwrap()).collect();
        let ring = numbers[0] as usize;
        if rings.len() == ring {
            rings.push(Vec::new());
        }
        // Across the 180th meridian a ring goes on; along the south pole it is closed as it is.
        let last = rings[ring].last().map_or(numbers[1], |[lon, _]| *lon);
        let turns = if numbers[2] > -89.0 {
            ((last - numbers[1]) / 360.0).round()
        } else {
            0.0
        };
        rings[ring].push([numbers[1] + 360.0 * turns, numbers[2]]);
    }
    rings
}

/// Whether a place is inside an odd number of rings.
fn is_land(rings: &[Vec<[f64; 2]>], place: LatLon<f64>) -> bool {
    let is_inside = |ring: &Vec<[f64; 2]>, lon: f64| {
        let crosses = |[lon1, lat1]: [f64; 2], [lon2, lat2]: [f64; 2]| {
            (lat1 > place.lat()) != (lat2 > place.lat())
                && lon < lon1 + (place.lat() - lat1) / (lat2 - lat1) * (lon2 - lon1)
        };
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).filter(|&(&a, &b)| crosses(a, b)).count() % 2 == 1
    };
    let turns = [-360.0, 0.0, 360.0];
    let inside = |ring| turns.iter().any(|turn| is_inside(ring, place.lon() + turn));
    rings.iter().filter(|ring| inside(ring)).count() % 2 == 1
}

/// The picture's coordinates of a place on the globe, and how much it faces the eye.
fn seen(place: LatLon<f64>) -> ([f64; 2], f64) {
    let frame = terrella::LocalFrame::new(
        Ellipsoid::sphere(1.0).unwrap(),
        terrella::Geodetic::new(LatLon::new(FROM[0], FROM[1]).unwrap(), 0.0).unwrap(),
    );
    let enu = frame.vector_to_enu(place.to_direction().to_array());
    ([GLOBE[0] + RADIUS * enu.east, GLOBE[1] - RADIUS * enu.north], enu.up)
}

#[derive(Default)]
struct Paths {
    /// The tiles of the net, and those seen of the globe, as paths: of the sea and of the land.
    net: [String; 2],
    globe: [String; 2],
}

fn at(i: i32) -> f64 {
    f64::from(2 * i - TILES) / f64::from(TILES)
}

fn face(map: &CubeMap<f64, Vertex>, rings: &[Vec<[f64; 2]>], face: Face) -> Paths {
    let mut paths = Paths::default();
    let [column, row] = NET[usize::from(face.index())];
    let [left, top] = [CORNER[0] + column * EDGE, CORNER[1] + row * EDGE];
    let place = |x: f64, y: f64| map.unproject(FacePoint::new(face, x, y).unwrap());
    let half = 1.0 / f64::from(TILES);
    write!(paths.net[0], "M{left},{top}h{EDGE}v{EDGE}h-{EDGE}z").unwrap();
    let step = EDGE / TILES;
    for j in 0..TILES {
        let mut run = 0;
        for i in 0..=TILES {
            let is_land = i < TILES && is_land(rings, place(at(i) + half, at(j) + half));
            if is_land {
                run += 1;
            } else if run > 0 {
                let [x, y] = [left + (i - run) * step, top + EDGE - (j + 1) * step];
                let width = run * step;
                write!(paths.net[1], "M{x},{y}h{width}v{step}h-{width}z").unwrap();
                run = 0;
            }
            if i == TILES {
                continue;
            }
            let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|[i, j]| seen(place(at(i), at(j))));
            if corners.iter().all(|(_, up)| *up > 0.0) {
                let path = &mut paths.globe[usize::from(is_land)];
                let mut last = [0, 0];
                for (n, (to, _)) in corners.iter().enumerate() {
                    let to = to.map(|v| (SCALE * v).round() as i32);
                    let [dx, dy] = [to[0] - last[0], to[1] - last[1]];
                    let before = if dx < 0 {
                        ["M", "l", "", ""]
                    } else {
                        ["M", "l", " ", " "]
                    };
                    let between = if dy < 0 { "" } else { " " };
                    write!(path, "{}{dx}{between}{dy}", before[n]).unwrap();
                    last = to;
                }
                path.push('z');
            }
        }
    }
    paths
}

fn picture() -> String {
    let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, Vertex).unwrap();
    let rings = land();
    let mut text = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1010 410\" width=\"1010\" height=\"410\" role=\"img\">\
         <title>The Earth in 6 × 24 × 24 tiles of equal area, on the globe and on the unfolded cube</title>\n\
         <rect width=\"1010\" height=\"410\" rx=\"8\" fill=\"#fff\"/>\n",
    );
    writeln!(
        text,
        "<circle cx=\"{}\" cy=\"{}\" r=\"{RADIUS}\" fill=\"#dfe6ec\"/>",
        GLOBE[0], GLOBE[1]
    )
    .unwrap();
    for (colours, &side) in COLOURS.iter().zip(&Face::ALL) {
        let paths = face(&map, &rings, side);
        for (kind, colour) in colours.iter().enumerate() {
            let quarters = " stroke=\"#fff\" stroke-width=\"2.4\" transform=\"scale(.25)\"";
            for (path, more) in [(&paths.globe[kind], quarters), (&paths.net[kind], "")] {
                if !path.is_empty() {
                    writeln!(text, "<path d=\"{path}\" fill=\"{colour}\"{more}/>").unwrap();
                }
            }
        }
        // The lines between the tiles of the net.
        let [column, row] = NET[usize::from(side.index())];
        let [left, top] = [CORNER[0] + column * EDGE, CORNER[1] + row * EDGE];
        let mut lines = String::new();
        for i in (0..=EDGE).step_by((EDGE / TILES) as usize) {
            write!(lines, "M{left},{}h{EDGE}M{},{top}v{EDGE}", top + i, left + i).unwrap();
        }
        writeln!(
            text,
            "<path d=\"{lines}\" fill=\"none\" stroke=\"#fff\" stroke-width=\"0.4\"/>\
             <path d=\"M{left},{top}h{EDGE}v{EDGE}h-{EDGE}z\" fill=\"none\" stroke=\"#43525f\" stroke-width=\"1.2\"/>"
        )
        .unwrap();
    }
    text +=
        "<path d=\"M408,205h58m-14,-10l14,10l-14,10\" fill=\"none\" stroke=\"#43525f\" stroke-width=\"3\"/>\n</svg>\n";
    text
}

#[test]
fn the_cover_shows_the_tiles() {
    generated::file("docs/cover.svg", &picture());
}
