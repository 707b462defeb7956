//! What scenes choose: a map of extents and tolerances, with the measured gain over Karney's distances in `f64` throughout.

use std::collections::BTreeMap;
use std::rc::Rc;

use image::{Rgb, RgbImage};
use terrella::geodesic::{Geodesic, Method, Visitor};
use terrella::scene::{Distances, Scalar, Scene};
use terrella::{Ellipsoid, LatLon};

use crate::bench::{Bench, Mode, Task};
use crate::chart;
use crate::set::{Set, each};
use crate::truth;
use draw::svg::{Area, LogAxis, Svg};
use timing::points::Random;
use timing::record::Record;

pub const TITLE: &str = "The cheapest model of distances that keeps a tolerance";

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

/// Times the distances of all methods of scenes in a scalar, between places of a field.
pub fn run<T: truth::Scalar>(bench: &mut Bench) {
    let field = Scene::around(Ellipsoid::WGS84, FIELD[0], 1e4);
    for local in [false, true] {
        if local && T::DIGITS == f64::MANTISSA_DIGITS {
            break;
        }
        let mut random = Random::new(90);
        let mut column = |middle: f64| -> Vec<f64> {
            let middle = if local { 0.0 } else { middle };
            (0..bench.points)
                .map(|_| middle + random.within(-FIELD[1], FIELD[1]))
                .collect()
        };
        let columns = [FIELD[0], 8.0, FIELD[0], 8.0].map(&mut column);
        let task = Task {
            chart: "scene",
            operation: "distance".to_owned(),
            inputs: vec![("field", Rc::new(Set::<T>::new(columns.into())))],
            // Its errors are what `tests/scene` is about.
            truth: Set::new(vec![Vec::new(); 4]),
            error: Box::new(|_, _| f64::NAN),
        };
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
            let [key, _] = key((scalar, method));
            // Each by its own type, as where the scene is a constant.
            way.solver().visit(Timed {
                bench,
                task: &task,
                key: &key,
            });
        }
    }
}

/// Times the distances of a method.
struct Timed<'a, T> {
    bench: &'a mut Bench,
    task: &'a Task<T>,
    key: &'a str,
}

impl<T: truth::Scalar> Visitor<T> for Timed<'_, T> {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        let pass = each(|[lat1, lon1, lat2, lon2]| {
            let way = method.inverse(LatLon::new(lat1, lon1).ok()?, LatLon::new(lat2, lon2).ok()?);
            Some([way.ok()?.distance])
        });
        self.bench.run(self.task, self.key, Mode::OneByOne, &pass);
    }
}

/// Cells of the map along each side.
const CELLS: u32 = 240;
const EXTENTS: [f64; 2] = [0.0, 7.3];
const TOLERANCES: [f64; 2] = [-9.0, 3.0];
const PLOT: f64 = 400.0;
const LEFT: f64 = 90.0;
const TOP: f64 = 110.0;

/// The map of what is chosen around a latitude, and of what is when none is known.
pub fn draw(records: &[Record], caption: &str) -> Result<Svg, String> {
    let times: BTreeMap<[String; 2], f64> = records
        .iter()
        .filter(|record| record.chart == "scene")
        .map(|record| ([record.method.clone(), record.scalar.clone()], record.ns_median))
        .collect();
    let time = |kind: Kind| times.get(&key(kind)).copied().unwrap_or(f64::INFINITY);
    let mut svg = Svg::new(1100.0, TOP + PLOT + 264.0);
    svg.text([LEFT, 34.0], "title", TITLE);
    svg.text(
        [LEFT, 58.0],
        "tick",
        "Scene::distances on WGS 84, and how many times as fast as Karney's in f64 it is, one by one",
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
    let karney = time((Scalar::Double, Method::Karney));
    for (i, kind) in kinds.iter().enumerate() {
        let [x, y] = [LEFT + 330.0 * (i % 3) as f64, TOP + PLOT + 84.0 + 26.0 * (i / 3) as f64];
        swatch(&mut svg, [x, y], colour(*kind));
        let gain = karney / time(*kind);
        svg.text(
            [x + 24.0, y],
            "",
            &format!("{}: {gain:.1} times", key(*kind).join(", ")),
        );
    }
    let y = TOP + PLOT + 84.0 + 26.0 * kinds.len().div_ceil(3) as f64;
    swatch(&mut svg, [LEFT, y], Rgb([0xe6; 3]));
    svg.text(
        [LEFT + 24.0, y],
        "",
        "nothing: an error that says what would be reached",
    );
    svg.text([LEFT, TOP + PLOT + 246.0], "tick", caption);
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
