//! Records as Markdown.

use timing::record::Record;

/// Prints a table for each chart: a line for each function, a column for each set of points.
pub fn print(records: &[Record]) {
    let mut charts: Vec<&str> = records.iter().map(|record| record.chart.as_str()).collect();
    charts.dedup();
    for chart in charts {
        let of_chart: Vec<&Record> = records.iter().filter(|record| record.chart == chart).collect();
        let all = ["random", "scan", "antipodal mix", "antipodal"];
        let inputs = all
            .iter()
            .filter(|&&input| of_chart.iter().any(|record| record.input == input));
        let inputs: Vec<&str> = inputs.copied().collect();
        println!("\n### {chart}\n");
        println!(
            "| operation | library | method | mode | {} | largest error, m |",
            inputs.join(" | ")
        );
        println!("|---|---|---|---|{}---|", "--:|".repeat(inputs.len()));
        let mut done: Vec<[&str; 6]> = Vec::new();
        for record in &of_chart {
            let function = function(record);
            if done.contains(&function) {
                continue;
            }
            done.push(function);
            let [_, operation, library, method, scalar, mode] = function;
            let scalar = if scalar == "f64" {
                String::new()
            } else {
                format!(", {scalar}")
            };
            let cells: Vec<String> = inputs
                .iter()
                .map(|&input| {
                    let at = of_chart
                        .iter()
                        .find(|other| self::function(other) == function && other.input == input);
                    at.map_or(String::new(), |record| cell(record))
                })
                .collect();
            let error = record.error;
            println!(
                "| {operation} | {library} | {method}{scalar} | {mode} | {} | {error:.1e} |",
                cells.join(" | ")
            );
        }
    }
}

/// All of the key but the set of points.
fn function(record: &Record) -> [&str; 6] {
    let [chart, operation, library, method, scalar, mode, _] = record.key();
    [chart, operation, library, method, scalar, mode]
}

/// The least time, and the share of failures if any.
fn cell(record: &Record) -> String {
    let digits = if record.ns_min < 100.0 { 1 } else { 0 };
    let time = format!("{:.digits$}", record.ns_min);
    match record.failures {
        0.0 => time,
        share if share < 1e-4 => format!("{time} (< 0.01 % fail)"),
        share => format!("{time} ({:.0} % fail)", share * 100.0),
    }
}
