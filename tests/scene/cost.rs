use terrella::geodesic::Method;
use terrella::scene::Scene;

/// What a method is said to cost is what was counted, and methods are in order of it.
#[test]
fn instructions_are_those_counted() {
    let file = concat!(env!("CARGO_MANIFEST_DIR"), "/benches/instructions/counts.tsv");
    let counts = std::fs::read_to_string(file).expect("the repository");
    for &method in Method::ALL {
        let line = counts
            .lines()
            .find_map(|line| line.strip_prefix(&format!("inverse, {method}\t")));
        let counted: f64 = line.and_then(|line| line.split('\t').next()).unwrap().parse().unwrap();
        let said = f64::from(method.instructions());
        assert!(
            (counted / said - 1.0).abs() < 0.1,
            "{method}: {said}, counted {counted}"
        );
    }
    for methods in [Method::ALL, Scene::METHODS] {
        assert!(methods.is_sorted_by_key(|method| method.instructions()));
    }
}
