//! Numbers and their units in words.

/// A power of ten of metres, in the unit that suits it.
pub fn metres(exponent: i32) -> String {
    match exponent {
        3.. => power(exponent - 3, "km"),
        _ => small(exponent, "m"),
    }
}

fn small(exponent: i32, unit: &str) -> String {
    let (prefix, of_prefix) = match exponent {
        0.. => ("", exponent),
        -3.. => ("m", exponent + 3),
        -6.. => ("µ", exponent + 6),
        -9.. => ("n", exponent + 9),
        -12.. => ("p", exponent + 12),
        _ => ("f", exponent + 15),
    };
    power(of_prefix, &format!("{prefix}{unit}"))
}

fn power(exponent: i32, unit: &str) -> String {
    let digits = format!("{:.0}", 10f64.powi(exponent));
    // A thin space between thousands.
    match digits.split_at_checked(digits.len().saturating_sub(3)) {
        Some((thousands, rest)) if thousands.len() > 1 => format!("{thousands}\u{2009}{rest} {unit}"),
        _ => format!("{digits} {unit}"),
    }
}

/// Two digits and the unit that suits them.
pub fn length(metres: f64) -> String {
    if metres.is_nan() {
        return "–".to_owned();
    }
    if metres < 1e-13 {
        return "0".to_owned();
    }
    let units = [(1e3, "km"), (1.0, "m"), (1e-3, "mm"), (1e-6, "µm"), (1e-9, "nm")];
    let (size, unit) = units
        .into_iter()
        .find(|&(size, _)| metres >= size)
        .unwrap_or((1e-12, "pm"));
    let value = metres / size;
    format!("{value:.*} {unit}", usize::from(value < 9.95))
}

/// A share of one.
pub fn percent(share: f64) -> String {
    match share {
        0.0 => "0".to_owned(),
        1.0 => "100 %".to_owned(),
        share if share < 1e-4 => "< 0.01 %".to_owned(),
        share => format!("{:.2} %", 100.0 * share),
    }
}
