use terrella::scene::Model;

/// What a model is said to cost is what was counted, and models are in order of it.
#[test]
fn instructions_are_those_counted() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/instructions/counts.tsv");
    let counts = std::fs::read_to_string(file).expect("the repository");
    let mut cheapest = 0;
    for model in Model::ALL {
        let name = match model {
            Model::Sphere => "great-circle".to_owned(),
            other => format!("{other:?}").to_lowercase(),
        };
        let line = counts
            .lines()
            .find_map(|line| line.strip_prefix(&format!("inverse, {name}\t")));
        let counted: f64 = line.and_then(|line| line.split('\t').next()).unwrap().parse().unwrap();
        let said = f64::from(model.instructions());
        assert!((counted / said - 1.0).abs() < 0.1, "{name}: {said}, counted {counted}");
        assert!(model.instructions() >= cheapest);
        cheapest = model.instructions();
    }
}
