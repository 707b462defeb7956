//! Colours for lengths: a step of the logarithm is a step of the colour.

use colorous::VIRIDIS;

/// From one power of ten of metres to another.
#[derive(Clone, Copy)]
pub struct Scale {
    pub exponents: [i32; 2],
}

impl Scale {
    /// The colour of a length in metres; beyond the ends, that of the end.
    pub fn colour(self, metres: f32) -> [u8; 3] {
        let [from, to] = self.exponents.map(|exponent| exponent as f32);
        let along = (metres.max(f32::MIN_POSITIVE).log10() - from) / (to - from);
        VIRIDIS.eval_continuous(f64::from(along.clamp(0.0, 1.0))).into_array()
    }

    /// The legend.
    pub fn html(self) -> String {
        let [from, to] = self.exponents;
        let stops: Vec<_> = (0..=8)
            .map(|step| {
                let colour = VIRIDIS.eval_continuous(f64::from(step) / 8.0);
                format!("#{colour:x}")
            })
            .collect();
        let ticks: String = (from..=to)
            .map(|exponent| format!("<span>{}</span>", length(10f64.powi(exponent))))
            .collect();
        format!(
            "<div class=\"scale\"><div class=\"bar\" style=\"background:linear-gradient(90deg,{})\"></div><div class=\"ticks\">{ticks}</div></div>\n",
            stops.join(",")
        )
    }
}

/// In groups of three digits.
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let groups: Vec<_> = digits
        .as_bytes()
        .rchunks(3)
        .rev()
        .map(String::from_utf8_lossy)
        .collect();
    groups.join("\u{a0}")
}

/// Three digits at most, and the unit that suits them.
pub fn length(metres: f64) -> String {
    let units = [(1e3, "km"), (1.0, "m"), (1e-3, "mm"), (1e-6, "µm")];
    let (size, unit) = units
        .into_iter()
        .find(|&(size, _)| metres >= 0.9995 * size)
        .unwrap_or((1e-9, "nm"));
    let value = metres / size;
    let digits = match value {
        _ if (value - value.round()).abs() < 1e-9 => 0,
        ..9.995 => 2,
        ..99.95 => 1,
        _ => 0,
    };
    let text = format!("{value:.digits$}");
    match text.strip_suffix("000") {
        Some(thousands) if !thousands.is_empty() => format!("{thousands}\u{a0}000\u{a0}{unit}"),
        _ => format!("{text}\u{a0}{unit}"),
    }
}
