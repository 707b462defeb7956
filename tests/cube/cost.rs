use terrella::cube::Projection;

/// To two digits.
fn rounded(count: f64) -> f64 {
    let unit = 10f64.powf(count.log10().floor() - 1.0);
    (count / unit).round() * unit
}

/// What a projection is said to cost is what was counted, to within a unit of the second digit.
#[test]
fn instructions_are_those_counted() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/instructions/counts.tsv");
    let counts = std::fs::read_to_string(file).expect("the repository");
    for &projection in Projection::ALL {
        let profile = projection.profile();
        for (function, said) in [("project", profile.forward), ("unproject", profile.inverse)] {
            let line = counts
                .lines()
                .find_map(|line| line.strip_prefix(&format!("{function}, {projection}\t")));
            let counted: Vec<f64> = line.unwrap().split('\t').map(|count| count.parse().unwrap()).collect();
            let said = said.instructions.map(f64::from);
            for (counted, said) in counted.into_iter().zip(said) {
                assert!(
                    rounded(said) == said && (counted / said - 1.0).abs() < 0.05,
                    "{function}, {projection}: {said}, counted {counted}"
                );
            }
        }
    }
}
