//! The bars as tables: what is not met first, then all.

use std::fmt::Write;

use crate::bench::OURS;
use timing::record::Record;

/// What a record is held against.
#[derive(Clone, Copy)]
pub enum Against<'a> {
    /// To be at least so many times as fast as another.
    Faster(&'a Record, f64),
    /// To take at most so many times the time of another.
    Within(&'a Record, f64),
    /// To take at most so many nanoseconds.
    Nanoseconds(f64),
}

/// A table. Those of bars that all have a row and a column are grids.
#[derive(Clone, Copy, PartialEq)]
pub enum Section {
    Geodesics,
    Inputs,
    Places,
    Latitudes,
    Projections,
    Gnomonic,
    SingleGeodesics,
    SinglePlaces,
    SingleProjections,
}

impl Section {
    const ALL: [Self; 9] = [
        Self::Geodesics,
        Self::Inputs,
        Self::Places,
        Self::Latitudes,
        Self::Projections,
        Self::Gnomonic,
        Self::SingleGeodesics,
        Self::SinglePlaces,
        Self::SingleProjections,
    ];

    /// The heading, and what the numbers of a grid are.
    fn words(self) -> [&'static str; 2] {
        match self {
            Self::Geodesics => ["Geodesics", ""],
            Self::Inputs => [
                "Pairs that are not random",
                "Inverse problem in batch, f64: how many times the time of random pairs; at most 1.3 wanted.",
            ],
            Self::Places => ["Earth-centred coordinates", ""],
            Self::Latitudes => [
                "Auxiliary latitudes",
                "How many times as fast as geodesy; 4 wanted in batch, 1 one by one.",
            ],
            Self::Projections => ["Projections", ""],
            Self::Gnomonic => [
                "Projections against the gnomonic one",
                "Unit vectors in batch, f64: how many times the time; at most 6 wanted, 20 for conformal and cobe-exact.",
            ],
            Self::SingleGeodesics => ["Geodesics: f32 against f64", SINGLE],
            Self::SinglePlaces => ["Coordinates and latitudes: f32 against f64", SINGLE],
            Self::SingleProjections => ["Projections: f32 against f64", SINGLE],
        }
    }
}

const SINGLE: &str = "How many times as fast f32 is as f64, in batch; 2 wanted.";

/// A comparison.
pub struct Bar<'a> {
    pub section: Section,
    /// Row and column of a grid.
    pub cell: Option<[String; 2]>,
    /// The other side.
    pub what: String,
    pub ours: &'a Record,
    pub against: Against<'a>,
}

impl Bar<'_> {
    /// The number that is looked at.
    fn value(&self) -> f64 {
        match self.against {
            Against::Faster(other, _) => other.ns_min / self.ours.ns_min,
            Against::Within(other, _) => self.ours.ns_min / other.ns_min,
            Against::Nanoseconds(_) => self.ours.ns_min,
        }
    }

    /// 1 or more if it is met.
    fn margin(&self) -> f64 {
        match self.against {
            Against::Faster(_, least) => self.value() / least,
            Against::Within(_, most) | Against::Nanoseconds(most) => most / self.value(),
        }
    }

    fn is_met(&self) -> bool {
        self.margin() >= 1.0
    }

    /// A line of a list. `now`: whether a rival's record was measured beside terrella's.
    fn line(&self, now: &dyn Fn(&Record) -> bool) -> String {
        let ours = self.ours;
        let value = self.value();
        let (reached, wanted) = match self.against {
            Against::Faster(_, least) => (format!("{value:.2} × as fast"), format!("≥ {least}")),
            Against::Within(_, most) => (format!("{value:.2} × the time"), format!("≤ {most}")),
            Against::Nanoseconds(most) => (format!("{value:.2} ns"), format!("≤ {most} ns")),
        };
        let (other, measured) = match self.against {
            Against::Faster(other, _) | Against::Within(other, _) => {
                let is_now = other.library == OURS || now(other);
                (format!("{:.2}", other.ns_min), if is_now { "now" } else { "kept" })
            }
            Against::Nanoseconds(_) => (String::new(), "now"),
        };
        // A projection's method begins with its name, as its operation does.
        let method = ours.method.split_once("; ").map_or(&*ours.method, |(_, ground)| ground);
        format!(
            "| {}: {method}, {} | {} | {:.2} | {other} | {measured} | {reached} | {wanted} | {} |",
            ours.operation,
            ours.scalar,
            self.what,
            ours.ns_min,
            if self.is_met() { "met" } else { "**not met**" }
        )
    }
}

const LIST: &str =
    "| terrella | against | ns | other ns | other measured | reached | wanted | |\n|---|---|--:|--:|---|--:|--:|---|";

/// All tables. `now`: whether a rival's record was measured beside terrella's.
pub fn markdown(bars: &[Bar], now: &dyn Fn(&Record) -> bool) -> String {
    let short: Vec<&Bar> = bars.iter().filter(|bar| !bar.is_met()).collect();
    let mut text = format!(
        "# Bars\n\n{} of {} are met. \"now\": measured in this run or given as just measured; \"kept\": from \
         benches/peers/peers.csv, taken in another run. Random points unless said. In grids, what is not met is \
         **bold**.\n",
        bars.len() - short.len(),
        bars.len()
    );
    let (grids, lists): (Vec<&Bar>, _) = short.into_iter().partition(|bar| bar.cell.is_some());
    if !lists.is_empty() {
        list(&mut text, "Not met", &lists, now);
    }
    if !grids.is_empty() {
        let _ = writeln!(text, "\n## Not met in grids\n");
    }
    for section in Section::ALL {
        let of = |bar: &&&Bar| bar.section == section;
        let count = grids.iter().filter(of).count();
        let Some(worst) = grids.iter().filter(of).min_by(|a, b| a.margin().total_cmp(&b.margin())) else {
            continue;
        };
        let [title, _] = section.words();
        let all = bars.iter().filter(|bar| bar.section == section).count();
        let cell = worst.cell.as_ref().map_or_else(String::new, |cell| cell.join(", "));
        let _ = writeln!(
            text,
            "* {title}: {count} of {all}, at worst {:.2} ({cell})",
            worst.value()
        );
    }
    for section in Section::ALL {
        let bars: Vec<&Bar> = bars.iter().filter(|bar| bar.section == section).collect();
        let [title, numbers] = section.words();
        if bars.is_empty() {
            continue;
        }
        if bars.iter().all(|bar| bar.cell.is_some()) {
            grid(&mut text, title, numbers, &bars);
        } else {
            list(&mut text, title, &bars, now);
        }
    }
    text
}

fn list(text: &mut String, title: &str, bars: &[&Bar], now: &dyn Fn(&Record) -> bool) {
    let lines: Vec<String> = bars.iter().map(|bar| bar.line(now)).collect();
    let _ = writeln!(text, "\n## {title}\n\n{LIST}\n{}", lines.join("\n"));
}

fn grid(text: &mut String, title: &str, numbers: &str, bars: &[&Bar]) {
    let names = |axis: usize| {
        let mut names: Vec<&str> = Vec::new();
        for name in bars.iter().filter_map(|bar| Some(bar.cell.as_ref()?[axis].as_str())) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        names
    };
    let columns = names(1);
    let _ = writeln!(
        text,
        "\n## {title}\n\n{numbers}\n\n| | {} |\n|---|{}",
        columns.join(" | "),
        "--:|".repeat(columns.len())
    );
    for row in names(0) {
        let number = |column: &&str| {
            let at = |bar: &&&Bar| bar.cell.as_ref().is_some_and(|cell| cell == &[row, *column]);
            match bars.iter().find(at) {
                Some(bar) if bar.is_met() => format!("{:.2}", bar.value()),
                Some(bar) => format!("**{:.2}**", bar.value()),
                None => String::new(),
            }
        };
        let numbers: Vec<String> = columns.iter().map(number).collect();
        let _ = writeln!(text, "| {row} | {} |", numbers.join(" | "));
    }
}
