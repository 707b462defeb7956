//! What scenes choose: a map of extents and tolerances, with the measured gain over Karney's distances in `f64` throughout, in batch against batch and one by one against one
//! by one.

use std::collections::BTreeMap;
use std::rc::Rc;

use image::{Rgb, RgbImage};
use terrella::Ellipsoid;
use terrella::geodesic::Method;
use terrella::scene::{Distances, Scalar, Scene};

use crate::bench::{Bench, Mode, Task};
use crate::chart;
use crate::distance::Timed;
use crate::set::Set;
use crate::truth;
use draw::svg::{Area, LogAxis, Svg};
use timing::points::Random;
use timing::record::Record;

pub const TITLE: &str = "The cheapest model of distances that keeps a tolerance";

/// The operation that the map is about.
const DISTANCE: &str = "distance";

/// The latitude of the field that everything is timed in, and half of its width in degrees.
const FIELD: [f64; 2] = [45.0, 0.05];

/// A method in a scalar.
type Kind = (Scalar, Method);

const SCALARS: [Scalar; 3] = [Scalar::Single, Scalar::Local, Scalar::Double];

/// A record's method and scalar.
fn key((scalar, method): Kind) -> [String; 2] {
    let method = method.to_string();
    match scalar {
        Scalar::Single => [method, "f32".to_owned()],
        Scalar::Local => [format!("{method} about an origin"), "f32".to_owned()],
        Scalar::Double => [method, "f64".to_owned()],
    }
}

/// Longest of the timed lines, in metres.
const LINE: f64 = 5000.0;

/// Times all methods of scenes in a scalar, on places and lines of a field.
pub fn run<T: truth::Scalar>(bench: &mut Bench) {
    let field = Scene::around(Ellipsoid::WGS84, FIELD[0], 1e4);
    for local in [false, true] {
        if local && T::DIGITS == f64::MANTISSA_DIGITS {
            break;
        }
        let points = bench.points;
        let mut random = Random::new(90);
        let mut column =
            |middle: f64, half: f64| -> Vec<f64> { (0..points).map(|_| middle + random.within(-half, half)).collect() };
        let [lat, lon] = if local { [0.0; 2] } else { [FIELD[0], 8.0] };
        let places = [lat, lon, lat, lon].map(|middle| column(middle, FIELD[1]));
        let lines = [(lat, FIELD[1]), (lon, FIELD[1]), (0.0, 180.0), (0.5 * LINE, 0.5 * LINE)];
        let lines = lines.map(|(middle, half)| column(middle, half));
        let task = |operation: &str, columns: &[Vec<f64>; 4]| Task {
            chart: "scene",
            operation: operation.to_owned(),
            inputs: vec![("field", Rc::new(Set::<T>::new(columns.to_vec())))],
            // Its errors are what `tests/scene` is about.
            truth: Set::new(vec![Vec::new(); 4]),
            error: Box::new(|_, _| f64::NAN),
        };
        let [inverse, distance] = ["inverse", DISTANCE].map(|operation| task(operation, &places));
        let direct = task("direct", &lines);
        let scalar = if T::DIGITS == f64::MANTISSA_DIGITS {
            Scalar::Double
        } else if local {
            Scalar::Local
        } else {
            Scalar::Single
        };
        let scene = if local { field.local() } else { field };
        for &method in Scene::METHODS {
            if local && method != Method::Plane {
                continue;
            }
            let way: Distances<T> = scene.distances_by(method).expect("a scene");
            let [name, _] = key((scalar, method));
            // Each by its own type, as where the scene is a constant.
            way.solver().visit(Timed {
                bench: &mut *bench,
                name: &name,
                inverse: &inverse,
                distance: &distance,
                direct: &direct,
            });
        }
    }
}

/// Cells of the map along each side.
const CELLS: u32 = 240;
const EXTENTS: [f64; 2] = [0.0, 7.3];
const TOLERANCES: [f64; 2] = [-9.0, 3.0];
const PLOT: f64 = 400.0;
const LEFT: f64 = 90.0;
const TOP: f64 = 110.0;

/// The key under the maps: rows of a column, its width, and the right ends of its numbers.
const ROWS: usize = 7;
const COLUMN: f64 = 500.0;
const IN_BATCH: f64 = 310.0;
const ONE_BY_ONE: f64 = 400.0;

/// The map of what is chosen around a latitude, and of what is when none is known.
pub fn draw(records: &[Record], caption: &str) -> Result<Svg, String> {
    let times = |mode: Mode| -> BTreeMap<[String; 2], f64> {
        let fits =
            |record: &&Record| record.chart == "scene" && record.operation == DISTANCE && record.mode == mode.name();
        let time = |record: &Record| ([record.method.clone(), record.scalar.clone()], record.ns_min);
        records.iter().filter(fits).map(time).collect()
    };
    let (batch, single) = (times(Mode::Batch), times(Mode::OneByOne));
    let of = |times: &BTreeMap<[String; 2], f64>, kind: Kind| times.get(&key(kind)).copied().unwrap_or(f64::INFINITY);
    let time = |kind: Kind| of(&batch, kind);
    let mut svg = Svg::new(1100.0, TOP + PLOT + 348.0);
    svg.text([LEFT, 34.0], "title", TITLE);
    svg.text(
        [LEFT, 58.0],
        "tick",
        "Scene::distances on WGS 84. Of its answers in f32 and f64, what is fastest in batch; and how many times as fast as Karney's in f64 that is",
    );
    let around: fn(f64) -> Scene = |extent| Scene::around(Ellipsoid::WGS84, FIELD[0], 0.5 * extent);
    let anywhere: fn(f64) -> Scene = |extent| Scene::new(Ellipsoid::WGS84).up_to(extent);
    let mut kinds = Vec::new();
    for (scene, title, left) in [
        (around, "Around a place at latitude 45", LEFT),
        (anywhere, "At any latitude", LEFT + PLOT + 110.0),
    ] {
        let frame = Area {
            x: left,
            y: TOP,
            width: PLOT,
            height: PLOT,
        };
        let mut picture = RgbImage::new(CELLS, CELLS);
        for (column, row, pixel) in picture.enumerate_pixels_mut() {
            let at = |[low, high]: [f64; 2], cell: u32| {
                10_f64.powf(low + (high - low) * (f64::from(cell) + 0.5) / f64::from(CELLS))
            };
            let asked = scene(at(EXTENTS, column)).within(at(TOLERANCES, CELLS - 1 - row));
            let answers = SCALARS.map(|scalar| Some((scalar, chosen(asked, scalar)?)));
            let least = answers.into_iter().flatten().map(time).fold(f64::INFINITY, f64::min);
            // Differences of less than a tenth are none.
            let kind = answers.into_iter().flatten().find(|&kind| time(kind) <= 1.1 * least);
            *pixel = kind.map_or(Rgb([0xe6; 3]), colour);
            if let Some(kind) = kind
                && !kinds.contains(&kind)
            {
                kinds.push(kind);
            }
        }
        svg.text([left, TOP - 14.0], "panel", title);
        svg.image(frame, &picture)?;
        axes(&mut svg, frame);
    }
    kinds.sort_by(|a, b| time(*a).total_cmp(&time(*b)));
    let karney = (Scalar::Double, Method::Karney);
    let gain = |times: &BTreeMap<[String; 2], f64>, kind: Kind| format!("{:.1}", of(times, karney) / of(times, kind));
    let head = TOP + PLOT + 84.0;
    for column in 0..kinds.len().div_ceil(ROWS).max(1) {
        for (at, text) in [(IN_BATCH, "in batch"), (ONE_BY_ONE, "one by one")] {
            svg.text([LEFT + COLUMN * column as f64 + at, head], "tick end", text);
        }
    }
    for (i, kind) in kinds.iter().enumerate() {
        let [x, y] = [LEFT + COLUMN * (i / ROWS) as f64, head + 26.0 * (i % ROWS + 1) as f64];
        swatch(&mut svg, [x, y], colour(*kind));
        svg.text([x + 24.0, y], "", &key(*kind).join(", "));
        svg.text([x + IN_BATCH, y], "end", &gain(&batch, *kind));
        svg.text([x + ONE_BY_ONE, y], "end", &gain(&single, *kind));
    }
    let y = head + 26.0 * (ROWS + 1) as f64;
    swatch(&mut svg, [LEFT, y], Rgb([0xe6; 3]));
    svg.text(
        [LEFT + 24.0, y],
        "",
        "nothing: an error that says what would be reached",
    );
    svg.text([LEFT, TOP + PLOT + 330.0], "tick", caption);
    Ok(svg)
}

fn chosen(scene: Scene, scalar: Scalar) -> Option<Method> {
    match scalar {
        Scalar::Single => scene.distances::<f32>().ok().map(|way| way.method()),
        Scalar::Local => scene.local().distances::<f32>().ok().map(|way| way.method()),
        Scalar::Double => scene.distances::<f64>().ok().map(|way| way.method()),
    }
}

/// A hue of the palette of Okabe and Ito for a method, paler for fewer digits.
fn colour((scalar, method): Kind) -> Rgb<u8> {
    let hue = match method {
        Method::Plane => [0x00, 0x9e, 0x73],
        Method::Flat => [0x56, 0xb4, 0xe9],
        Method::Gauss => [0xd5, 0x5e, 0x00],
        Method::GreatCircle => [0xe6, 0x9f, 0x00],
        Method::Andoyer => [0xcc, 0x79, 0xa7],
        _ => [0x3c, 0x3c, 0x3c],
    };
    let pale = match scalar {
        Scalar::Single => 0.6,
        Scalar::Local => 0.35,
        Scalar::Double => 0.0,
    };
    Rgb(hue.map(|part| (f64::from(part) + pale * (255.0 - f64::from(part))) as u8))
}

fn swatch(svg: &mut Svg, [x, y]: [f64; 2], Rgb([r, g, b]): Rgb<u8>) {
    svg.add(format_args!(
        "<rect x=\"{x:.1}\" y=\"{:.1}\" width=\"16\" height=\"16\" fill=\"#{r:02x}{g:02x}{b:02x}\"/>",
        y - 13.0
    ));
}

fn axes(svg: &mut Svg, frame: Area) {
    let x = LogAxis {
        exponents: EXTENTS,
        ends: [frame.x, frame.right()],
    };
    let y = LogAxis {
        exponents: TOLERANCES,
        ends: [frame.bottom(), frame.y],
    };
    for power in x.powers(2) {
        let at = x.at(10_f64.powi(power));
        svg.grid_line([at, frame.bottom()], [at, frame.bottom() + 6.0]);
        svg.text([at, frame.bottom() + 22.0], "tick middle", &draw::units::metres(power));
    }
    for power in y.powers(3) {
        let at = y.at(10_f64.powi(power));
        svg.grid_line([frame.x - 6.0, at], [frame.x, at]);
        svg.text([frame.x - 10.0, at + 4.5], "tick end", &draw::units::metres(power));
    }
    svg.frame(frame);
    svg.text(
        [frame.x + 0.5 * PLOT, frame.bottom() + 46.0],
        "middle",
        "farthest distance",
    );
    svg.upright([frame.x - 62.0, frame.y + 0.5 * PLOT], "middle", "tolerance");
}

/// The document, dark on light.
pub fn document(svg: &Svg) -> String {
    svg.document(TITLE, &chart::DAY)
}
