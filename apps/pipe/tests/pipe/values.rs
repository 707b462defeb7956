//! A value from outside for every operation, in `f64` and in `f32`: `values.tsv`.

use crate::run::answers;

/// A row of the table.
pub struct Case {
    source: &'static str,
    pub command: &'static str,
    pub line: &'static str,
    expected: &'static str,
    /// How much of the value and of 1 `f32` may differ; none for text.
    single: Option<f64>,
}

/// The table.
pub fn cases() -> Vec<Case> {
    let rows = include_str!("values.tsv").lines().filter(|row| !row.starts_with('#'));
    let case = |row: &'static str| {
        let [source, command, line, expected, single] = row.split('\t').collect::<Vec<_>>()[..] else {
            panic!("not five columns: {row}");
        };
        Case {
            source,
            command,
            line,
            expected,
            single: (single != "text").then(|| single.parse().unwrap()),
        }
    };
    rows.map(case).collect()
}

/// Whether a number is the expected one to the digits given, and so much of it and of 1 beside; or a word is.
fn agrees(found: &str, expected: &str, allowed: f64) -> bool {
    let Ok(wanted) = expected.parse::<f64>() else {
        return found == expected;
    };
    let number: f64 = found.parse().unwrap();
    let decimals = expected.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let half_digit = 0.5001 * 0.1_f64.powi(decimals as i32);
    (number - wanted).abs() <= half_digit + allowed * (1.0 + wanted.abs())
}

#[test]
fn every_value_from_outside_comes_back() {
    let mut wrong = String::new();
    for Case {
        source,
        command,
        line,
        expected,
        single,
    } in cases()
    {
        for scalar in ["f64", "f32"] {
            let answer = answers(&format!("{command} --scalar {scalar}"), format!("{line}\n"));
            let found: Vec<_> = answer.split_whitespace().collect();
            let expected: Vec<_> = expected.split_whitespace().collect();
            assert!(found.len() >= expected.len(), "{source}: {command}: {answer}");
            for (found, expected) in found.into_iter().zip(expected) {
                let right = match (single, scalar) {
                    (None, _) => found == expected,
                    (Some(_), "f64") => agrees(found, expected, 0.0),
                    (Some(single), _) => agrees(found, expected, single),
                };
                if !right {
                    wrong += &format!("{source}: {command} --scalar {scalar} of {line}: {found} for {expected}\n");
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
}

#[test]
fn help_lists_every_operation_and_each_has_a_value() {
    let help = answers("--help", "");
    let listed: Vec<_> = help
        .lines()
        .filter(|line| line.contains(" -> "))
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(listed.len() > 50, "{help}");
    let cases = cases();
    for name in &listed {
        let tried = cases.iter().any(|case| case.command.split(' ').next() == Some(name));
        assert!(tried, "{name} has no value from outside");
        let own = answers(&format!("{name} --help"), "");
        assert!(own.contains(" -> ") && own.contains("--scalar"), "{own}");
    }
    for case in cases {
        assert!(
            listed.contains(&case.command.split(' ').next().unwrap()),
            "{}",
            case.command
        );
    }
}
