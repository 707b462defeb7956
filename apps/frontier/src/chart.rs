//! Nanoseconds per point against largest error in metres, panel under panel.

use draw::labels::{Area, place};
use draw::svg::{LogAxis, Svg, Theme};
use draw::units::metres;

/// Dark on light, whatever the page around it.
pub const DAY: Theme = Theme {
    style: "\
text{font-family:'Liberation Sans','DejaVu Sans',Arial,sans-serif;font-size:13px;fill:#24292f}\
.title{font-size:21px;font-weight:bold}\
.panel{font-size:16px;font-weight:bold}\
.tick{fill:#57606a}.middle{text-anchor:middle}.end{text-anchor:end}\
.name{paint-order:stroke;stroke:#fcfcfa;stroke-width:3px;stroke-linejoin:round}\
.ours{fill:#004b7a}.theirs{fill:#9c4300}\
.grid{stroke:#e3e5e8;stroke-width:1}\
.frame{fill:none;stroke:#8c959f;stroke-width:1}\
.front{fill:none;stroke:#57606a;stroke-width:1.5;stroke-dasharray:5 4}\
.leader{stroke:#8c959f;stroke-width:0.8}\
.guide{stroke:#009e73;stroke-width:1.5;stroke-dasharray:2 3}\
.failed{fill:none;stroke:#24292f;stroke-width:1.6}",
    background: "#fcfcfa",
};

const WIDTH: f64 = 1100.0;
const LEFT: f64 = 108.0;
const RIGHT: f64 = 24.0;
/// Width of the column with a key.
const KEY: f64 = 236.0;
/// Above the first panel, between panels, and under the last.
const HEAD: f64 = 86.0 + LINE;
const BETWEEN: f64 = 92.0;
const FOOT: f64 = 40.0;
/// From line to line of the legend.
const LINE: f64 = 22.0;

/// Blue and vermilion of the palette of Okabe and Ito.
const OURS: &str = "#0072b2";
const THEIRS: &str = "#d55e00";

/// Marks closer than this share a name.
const HIDDEN: f64 = 9.0;

/// Errors below are drawn here.
const LEAST_ERROR: f64 = 1e-11;

/// What was measured of a function.
pub struct Mark {
    /// What stands beside it.
    pub label: String,
    pub ns: f64,
    /// In metres.
    pub error: f64,
    pub ours: bool,
    pub single: bool,
    pub batch: bool,
    /// Share of the points.
    pub failures: f64,
}

/// A plot.
pub struct Panel {
    pub title: String,
    pub marks: Vec<Mark>,
    /// What costs time and makes no error: nanoseconds, name.
    pub guides: Vec<(f64, String)>,
    /// What the labels stand for.
    pub key: Vec<(String, String)>,
}

/// Draws a chart with plots of a height.
pub fn draw(title: &str, caption: &str, panels: &[Panel], plot: f64) -> Svg {
    let height = HEAD + panels.len() as f64 * (plot + BETWEEN) + FOOT;
    let mut svg = Svg::new(WIDTH, height);
    svg.text([LEFT, 34.0], "title", title);
    legend(&mut svg, [LEFT, 58.0]);
    for (panel, i) in panels.iter().zip(0..) {
        let top = HEAD + f64::from(i) * (plot + BETWEEN) + 34.0;
        panel.draw(&mut svg, top, plot);
    }
    svg.text([LEFT, height - 18.0], "tick", caption);
    svg
}

/// Two lines: what the marks' shapes mean, and the rest.
fn legend(svg: &mut Svg, [x, y]: [f64; 2]) {
    let columns = (0..4).map(|column| x + 150.0 * f64::from(column));
    for ((single, batch, name), x) in [
        (false, true, "f64 in batch"),
        (false, false, "f64 one by one"),
        (true, true, "f32 in batch"),
        (true, false, "f32 one by one"),
    ]
    .into_iter()
    .zip(columns.clone())
    {
        symbol(svg, [x + 6.0, y - 4.5], single, batch, OURS);
        svg.text([x + 20.0, y], "", name);
    }
    let (below, middle) = (y + LINE, y + LINE - 4.5);
    for ((colour, name), x) in [(OURS, "terrella"), (THEIRS, "others")]
        .into_iter()
        .zip(columns.clone())
    {
        svg.add(format_args!(
            "<rect x=\"{x:.1}\" y=\"{:.1}\" width=\"12\" height=\"12\" fill=\"{colour}\"/>",
            middle - 6.0
        ));
        svg.text([x + 20.0, below], "", name);
    }
    let mut columns = columns.skip(2);
    if let (Some(x), Some(wide)) = (columns.next(), columns.next()) {
        cross(svg, [x + 6.0, middle]);
        svg.text([x + 20.0, below], "", "fails for some");
        svg.polyline(&[[wide, middle], [wide + 28.0, middle]], "front", "");
        svg.text([wide + 36.0, below], "", "nothing is faster and more exact");
    }
}

/// A circle for `f64`, a triangle for `f32`; filled for batch.
fn symbol(svg: &mut Svg, [x, y]: [f64; 2], single: bool, batch: bool, colour: &str) {
    let fill = if batch { colour } else { "#fcfcfa" };
    let paint = format!("fill=\"{fill}\" fill-opacity=\"0.85\" stroke=\"{colour}\" stroke-width=\"1.6\"");
    if single {
        svg.add(format_args!(
            "<path d=\"M{x:.1} {:.1}l5.2 9h-10.4z\" {paint}/>",
            y - 6.0
        ));
    } else {
        svg.add(format_args!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4.3\" {paint}/>"));
    }
}

fn cross(svg: &mut Svg, [x, y]: [f64; 2]) {
    let (x, y) = (x - 7.0, y - 7.0);
    svg.add(format_args!(
        "<path class=\"failed\" d=\"M{x:.1} {y:.1}l14 14m0 -14l-14 14\"/>"
    ));
}

/// The exponents of ten that hold all values, with room for names at both ends.
fn exponents(values: impl Iterator<Item = f64>, [below, above]: [f64; 2]) -> [f64; 2] {
    let [low, high] = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| {
        [low.min(value), high.max(value)]
    });
    [low.log10() - below, high.log10() + above]
}

impl Panel {
    fn draw(&self, svg: &mut Svg, top: f64, plot: f64) {
        let right = WIDTH - RIGHT - if self.key.is_empty() { 0.0 } else { KEY };
        let frame: Area = [LEFT, top, right, top + plot];
        let error = |mark: &Mark| mark.error.max(LEAST_ERROR);
        let times = self.marks.iter().map(|mark| mark.ns);
        let x = LogAxis {
            exponents: exponents(times.chain(self.guides.iter().map(|&(ns, _)| ns)), [0.25, 0.35]),
            ends: [LEFT, right],
        };
        let y = LogAxis {
            exponents: exponents(self.marks.iter().map(error), [1.4, 1.4]),
            ends: [top + plot, top],
        };
        let at = |mark: &Mark| [x.at(mark.ns), y.at(error(mark))];

        svg.text([LEFT, top - 12.0], "panel", &self.title);
        axes(svg, &x, &y);
        let mut taken = Vec::new();
        for (ns, name) in &self.guides {
            let along = x.at(*ns);
            svg.add(format_args!(
                "<path class=\"guide\" d=\"M{along:.1} {top:.1}V{:.1}\"/>",
                top + plot
            ));
            svg.upright([along - 5.0, top + 0.5 * plot], "name middle", name);
            taken.push([along - 18.0, top, along + 3.0, top + plot]);
        }
        svg.polyline(
            &front(&self.marks)
                .iter()
                .map(|&[ns, m]| [x.at(ns), y.at(m.max(LEAST_ERROR))])
                .collect::<Vec<_>>(),
            "front",
            "",
        );

        for mark in &self.marks {
            let colour = if mark.ours { OURS } else { THEIRS };
            symbol(svg, at(mark), mark.single, mark.batch, colour);
            if mark.failures > 0.0 {
                cross(svg, at(mark));
            }
        }
        let clusters = clusters(&self.marks, at);
        let named: Vec<_> = clusters.iter().map(|(at, name, _)| (*at, name.as_str())).collect();
        for (label, ([x1, y1], _, ours)) in place(&named, frame, &taken).iter().zip(&clusters) {
            if let Some([x2, y2]) = label.leader {
                svg.add(format_args!(
                    "<path class=\"leader\" d=\"M{x1:.1} {y1:.1}L{x2:.1} {y2:.1}\"/>"
                ));
            }
            let class = if *ours { "name ours" } else { "name theirs" };
            svg.text(label.at, class, label.text);
        }
        for ((short, long), i) in self.key.iter().zip(0..) {
            let line = top + 12.0 + 18.0 * f64::from(i);
            svg.text([right + 34.0, line], "end", short);
            svg.text([right + 42.0, line], "", long);
        }
    }
}

fn axes(svg: &mut Svg, x: &LogAxis, y: &LogAxis) {
    let ([left, right], [bottom, top]) = (x.ends, y.ends);
    for exponent in y.powers(1) {
        let at = y.at(10f64.powi(exponent));
        svg.grid_line([left, at], [right, at]);
        svg.text([left - 8.0, at + 4.5], "tick end", &metres(exponent));
    }
    for exponent in -3..7 {
        for digit in [1.0, 2.0, 5.0] {
            let ns = digit * 10f64.powi(exponent);
            if (x.exponents[0]..x.exponents[1]).contains(&ns.log10()) {
                svg.grid_line([x.at(ns), bottom], [x.at(ns), top]);
                svg.text([x.at(ns), bottom + 18.0], "tick middle", &nanoseconds(ns));
            }
        }
    }
    svg.text([right, bottom + 38.0], "tick end", "time per point →");
    svg.upright([left - 92.0, top], "tick end", "largest error →");
    svg.add(format_args!(
        "<rect class=\"frame\" x=\"{left:.1}\" y=\"{top:.1}\" width=\"{:.1}\" height=\"{:.1}\"/>",
        right - left,
        bottom - top
    ));
}

fn nanoseconds(ns: f64) -> String {
    match ns {
        1000.0.. => format!("{} µs", (ns / 1000.0).round()),
        1.0.. => format!("{} ns", ns.round()),
        _ => format!("{ns:.1} ns"),
    }
}

/// Marks alike that all but hide each other: where they are, their names in one, whether they are terrella's. From the right, where there
/// is room.
fn clusters(marks: &[Mark], at: impl Fn(&Mark) -> [f64; 2]) -> Vec<([f64; 2], String, bool)> {
    let mut marks: Vec<&Mark> = marks.iter().collect();
    marks.sort_by(|a, b| b.ns.total_cmp(&a.ns).then(a.error.total_cmp(&b.error)));
    let look = |mark: &Mark| [mark.ours, mark.single, mark.batch];
    let mut clusters: Vec<(&Mark, Vec<&str>)> = Vec::new();
    for mark in marks {
        let [x, y] = at(mark);
        let hides = |other: &Mark| {
            let [other_x, other_y] = at(other);
            look(other) == look(mark) && (x - other_x).hypot(y - other_y) < HIDDEN
        };
        match clusters.iter_mut().find(|(other, _)| hides(other)) {
            Some((_, names)) => names.push(&mark.label),
            None => clusters.push((mark, vec![&mark.label])),
        }
    }
    let joined = |(mark, names): (&Mark, Vec<&str>)| (at(mark), names.join(", "), mark.ours);
    clusters.into_iter().map(joined).collect()
}

/// The steps below which nothing is: of all that never fails, what nothing is faster and more exact than.
fn front(marks: &[Mark]) -> Vec<[f64; 2]> {
    let mut whole: Vec<_> = marks
        .iter()
        .filter(|mark| mark.failures == 0.0)
        .map(|mark| [mark.ns, mark.error])
        .collect();
    whole.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    let mut steps: Vec<[f64; 2]> = Vec::new();
    for [ns, error] in whole {
        match steps.last() {
            Some(&[_, best]) if error >= best => {}
            Some(&[_, best]) => steps.extend([[ns, best], [ns, error]]),
            None => steps.extend([[ns, f64::MAX], [ns, error]]),
        }
    }
    steps.extend(steps.last().map(|&[_, best]| [f64::MAX, best]));
    steps
}
