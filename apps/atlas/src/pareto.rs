//! Every projection as a point between two things that cannot both be had.

use std::fmt::Write;

use terrella::cube::Projection;

use draw::labels::{Area, around, place};
use draw::page::escaped;
use testkit::measure::Surveys;

use crate::page::Shown;

/// Width and height of a picture.
const SIZE: [f64; 2] = [960.0, 640.0];

/// The plot: left, top, right, bottom.
const PLOT: Area = [64.0, 24.0, 936.0, 576.0];

/// Aspect ratio times the ratio of width times height is at least ((π/2)/acos(⅓))²: the midline and the edge of a face, whose lengths on the
/// sphere are given, are equally long on the cube.
const BOUND: f64 = 1.628_4;

/// The least ratio of width times height that a search found for an aspect ratio.
const FRONT: [[f64; 2]; 8] = [
    [1.02, 1.72],
    [1.1, 1.60],
    [1.2, 1.47],
    [1.335, 1.335],
    [1.5, 1.21],
    [1.6, 1.15],
    [1.8, 1.065],
    [2.0, 1.006],
];

/// Where the three right angles of a corner become 120°, without a crease.
const CORNER: f64 = 31.0845;

/// The projections made for the crate.
fn is_own(projection: Projection) -> bool {
    projection.profile().origin.starts_with("Made for terrella")
}

/// One axis.
struct Axis {
    title: &'static str,
    from: f64,
    to: f64,
    logarithmic: bool,
    ticks: &'static [f64],
    unit: &'static str,
    value: fn(&Surveys) -> f64,
}

impl Axis {
    /// From 0 to 1 along the axis.
    fn position(&self, value: f64) -> f64 {
        let scaled = |v: f64| if self.logarithmic { v.ln() } else { v };
        (scaled(value) - scaled(self.from)) / (scaled(self.to) - scaled(self.from))
    }
}

const RATIOS: &[f64] = &[1.0, 1.2, 1.5, 2.0, 3.0, 4.0, 5.0];

/// Two axes, and what is drawn between them.
struct Chart {
    x: Axis,
    y: Axis,
}

impl Chart {
    /// A place in the picture; what is beyond an axis is at its end.
    fn at(&self, x: f64, y: f64) -> [f64; 2] {
        let [left, top, right, bottom] = PLOT;
        let (along, up) = (self.x.position(x).min(1.0), self.y.position(y).min(1.0));
        [left + along * (right - left), bottom - up * (bottom - top)]
    }

    fn line(&self, points: &[[f64; 2]]) -> Vec<[f64; 2]> {
        points.iter().map(|&[x, y]| self.at(x, y)).collect()
    }

    fn axes(&self) -> String {
        let [left, top, right, bottom] = PLOT;
        let mut text = String::new();
        for &value in self.x.ticks {
            let [x, _] = self.at(value, self.y.from);
            let _ = writeln!(
                text,
                "<path class=\"grid\" d=\"M{x:.1} {bottom}V{top}\"/><text class=\"tick\" x=\"{x:.1}\" y=\"{}\" text-anchor=\"middle\">{value}{}</text>",
                bottom + 22.0,
                self.x.unit
            );
        }
        for &value in self.y.ticks {
            let [_, y] = self.at(self.x.from, value);
            let _ = writeln!(
                text,
                "<path class=\"grid\" d=\"M{left} {y:.1}H{right}\"/><text class=\"tick\" x=\"{}\" y=\"{:.1}\" text-anchor=\"end\">{value}{}</text>",
                left - 9.0,
                y + 4.5,
                self.y.unit
            );
        }
        let _ = writeln!(
            text,
            "<text class=\"axis\" x=\"{right}\" y=\"{}\" text-anchor=\"end\">{} →</text>\
             <text class=\"axis\" transform=\"translate(16 {top}) rotate(-90)\" text-anchor=\"end\">{} →</text>",
            bottom + 48.0,
            self.x.title,
            self.y.title
        );
        text
    }

    /// The points with their names, clear of what is taken.
    fn points(&self, shown: &[Shown], taken: &[Area]) -> String {
        let titles: Vec<String> = shown.iter().map(Shown::title).collect();
        let mut points: Vec<_> = shown
            .iter()
            .zip(&titles)
            .map(|(shown, title)| {
                let [x, y] = [
                    (self.x.value)(&shown.measures.sphere),
                    (self.y.value)(&shown.measures.sphere),
                ];
                let beyond = [x > self.x.to, y > self.y.to];
                (self.at(x, y), title.as_str(), is_own(shown.projection), beyond)
            })
            .collect();
        // From the right, where there is room.
        points.sort_by(|a, b| b.0[0].total_cmp(&a.0[0]).then(a.1.cmp(b.1)));
        let mut text = String::new();
        for &([x, y], _, own, beyond) in &points {
            let class = if own { "own" } else { "point" };
            let _ = match beyond {
                [true, _] => writeln!(text, "<path class=\"{class}\" d=\"M{x:.1} {y:.1}l-14 -6v12z\"/>"),
                [_, true] => writeln!(text, "<path class=\"{class}\" d=\"M{x:.1} {y:.1}l-6 14h12z\"/>"),
                _ => writeln!(
                    text,
                    "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.5\"/>"
                ),
            };
        }
        // An arrow is behind its tip.
        let middle = |[x, y]: [f64; 2], beyond: [bool; 2]| match beyond {
            [true, _] => [x - 10.0, y],
            [_, true] => [x, y + 7.0],
            _ => [x, y],
        };
        let named: Vec<_> = points
            .iter()
            .map(|&(at, title, _, beyond)| (middle(at, beyond), title))
            .collect();
        for (label, &(from, _, own, _)) in place(&named, PLOT, taken).iter().zip(&points) {
            if let Some(end) = label.leader {
                let _ = writeln!(text, "<path class=\"leader\" d=\"{}\"/>", polyline(&[from, end]));
            }
            let class = if own { "name own" } else { "name" };
            let [x, y] = label.at;
            let _ = writeln!(
                text,
                "<text class=\"{class}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>",
                label.text
            );
        }
        text
    }

    fn svg(&self, description: &str, background: &str, shown: &[Shown], taken: Vec<Area>) -> String {
        let [width, height] = SIZE;
        format!(
            "<svg class=\"chart\" viewBox=\"0 0 {width} {height}\" role=\"img\" aria-label=\"{}\">\n{}{background}{}</svg>\n",
            escaped(description),
            self.axes(),
            self.points(shown, &taken)
        )
    }
}

/// Aspect against width times height: what ε is made of.
pub fn texels(shown: &[Shown]) -> String {
    let chart = Chart {
        x: Axis {
            title: "aspect ratio",
            from: 0.96,
            to: 3.7,
            logarithmic: true,
            ticks: &RATIOS[..5],
            unit: "",
            value: |s| s.worst.aspect().ratio(),
        },
        y: Axis {
            title: "width × height ratio",
            from: 0.94,
            to: 6.0,
            logarithmic: true,
            ticks: RATIOS,
            unit: "",
            value: Surveys::sides_ratio,
        },
    };
    let bound = chart.line(&[[1.0, BOUND], [BOUND, 1.0]]);
    let impossible = chart.line(&[[1.0, BOUND], [BOUND, 1.0], [1.0, 1.0]]);
    let front = chart.line(&FRONT);
    let mut background = format!(
        "<path class=\"impossible\" d=\"{}Z\"/><path class=\"bound\" d=\"{}\"/><path class=\"front\" d=\"{}\"/>\n",
        polyline(&impossible),
        polyline(&bound),
        polyline(&front)
    );
    let mut taken = Vec::new();
    for oversize in [2.0, 3.0] {
        let corner = chart.line(&[[1.0, oversize], [oversize, oversize], [oversize, 1.0]]);
        let [x, y] = corner[1];
        let _ = writeln!(
            background,
            "<path class=\"even\" d=\"{}\"/><text class=\"tick\" x=\"{}\" y=\"{}\" text-anchor=\"end\">ε = {oversize}</text>",
            polyline(&corner),
            x - 6.0,
            y + 16.0
        );
        taken.push([x - 58.0, y, x, y + 20.0]);
        taken.extend(corner.windows(2).flat_map(|ends| boxes(ends[0], ends[1])));
    }
    let note = chart.at(1.012, 1.025);
    let _ = writeln!(
        background,
        "<text class=\"tick\" x=\"{:.1}\" y=\"{:.1}\">proved: nothing here</text>",
        note[0], note[1]
    );
    taken.push([note[0], note[1] - 16.0, note[0] + 140.0, note[1] + 4.0]);
    for line in [&bound, &front] {
        taken.extend(line.windows(2).flat_map(|ends| boxes(ends[0], ends[1])));
    }
    let description = "Every projection as a point: aspect ratio to the right, ratio of width times height upward, both on \
                       logarithmic axes, with the bound that no projection passes and the best that a search has found. The \
                       figures are in the table.";
    chart.svg(description, &background, shown, taken)
}

/// True area against angles.
pub fn shapes(shown: &[Shown]) -> String {
    let chart = Chart {
        x: Axis {
            title: "true area ratio",
            from: 0.95,
            to: 6.0,
            logarithmic: true,
            ticks: RATIOS,
            unit: "",
            value: Surveys::area_ratio,
        },
        y: Axis {
            title: "largest deformation ω",
            from: -2.5,
            to: 55.0,
            logarithmic: false,
            ticks: &[0.0, 10.0, 20.0, 30.0, 40.0, 50.0],
            unit: "°",
            value: |s| s.worst.deformation().max(),
        },
    };
    let corner = chart.line(&[[0.95, CORNER], [6.0, CORNER]]);
    let [right, y] = corner[1];
    let background = format!(
        "<path class=\"bound\" d=\"{}\"/><text class=\"tick\" x=\"{right}\" y=\"{}\" text-anchor=\"end\">31.08°: 90° at a corner become 120°</text>\n",
        polyline(&corner),
        y + 20.0
    );
    let mut taken = boxes(corner[0], corner[1]);
    taken.push([right - 250.0, y + 4.0, right, y + 26.0]);
    let description = "Every projection as a point: ratio of true areas to the right, on a logarithmic axis, and the largest \
                       angular deformation upward, with the line of 31.08 degrees on which most of them lie. The figures are in the table.";
    chart.svg(description, &background, shown, taken)
}

/// Boxes along a line, to keep names off it.
fn boxes(from: [f64; 2], to: [f64; 2]) -> Vec<Area> {
    let steps = (f64::hypot(to[0] - from[0], to[1] - from[1]) / 4.0).ceil();
    (0..=steps as u32)
        .map(|step| f64::from(step) / steps.max(1.0))
        .map(|t| around(std::array::from_fn(|i| from[i] + t * (to[i] - from[i])), 1.5))
        .collect()
}

fn polyline(points: &[[f64; 2]]) -> String {
    let points: Vec<_> = points.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect();
    format!("M{}", points.join("L"))
}
