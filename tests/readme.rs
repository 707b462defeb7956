//! The README's table of projections, measured afresh.
#![allow(missing_docs, clippy::unwrap_used, clippy::indexing_slicing)] // tests

use terrella::cube::{CubeProjection, Faces, Kept, Profile, Projection};
use terrella::geodesic::Method;
use testkit::{generated, measure, table};

fn number(value: f64, digits: usize) -> String {
    if value.is_finite() {
        format!("{value:.digits$}")
    } else {
        "∞".into()
    }
}

#[test]
fn errors_are_as_claimed() {
    generated::section("README.md", "| | unit | `f64` | `f32` |", &table::markdown());
}

#[test]
fn properties_are_as_measured_and_shown() {
    let mut table = String::from(
        "| projection | keeps | area ratio | aspect ratio | ε | ω | to the cube | back |\n|---|---|---|---|---|---|---|---|\n",
    );
    for &projection in Projection::ALL {
        let &Profile {
            keeps,
            area_ratio: area,
            aspect_ratio: aspect,
            oversize,
            deformation,
            forward,
            inverse,
            ..
        } = projection.profile();
        let m = measure::Measures::of(projection);
        let measured = [
            m.sphere.area_ratio(),
            m.sphere.worst.aspect().ratio(),
            m.sphere.oversize(),
            m.sphere.worst.deformation().max(),
        ];
        // Half of the last digit that is shown.
        let tolerances = [5e-4, 5e-4, 5e-4, 5e-2];
        let claimed = [area, aspect, oversize, deformation];
        let holds = |i: usize| claimed[i] == measured[i] || (claimed[i] - measured[i]).abs() < tolerances[i];
        assert!(
            (0..4).all(holds),
            "{projection}: measured area_ratio: {:.3}, aspect_ratio: {:.3}, oversize: {:.3}, deformation: {:.1}",
            measured[0],
            measured[1],
            measured[2],
            measured[3],
        );
        assert_eq!(m.is_equal_area(), keeps == Some(Kept::Areas), "{projection}");
        assert_eq!(
            m.has_two_kinds(),
            projection.faces() == Faces::SideAndPolar,
            "{projection}"
        );
        assert_eq!(m.sphere.is_conformal(), keeps == Some(Kept::Angles), "{projection}");
        let keeps = match keeps {
            Some(Kept::Areas) => "areas",
            Some(Kept::Angles) => "angles",
            Some(Kept::GreatCircles) => "great circles",
            _ => "",
        };
        let [to, from] = [forward, inverse].map(|e| format!("{}, {}", e.formula.name(), e.instructions[0]));
        table += &format!(
            "| {projection} | {keeps} | {} | {} | {} | {:.1}° | {to} | {from} |\n",
            number(area, 3),
            number(aspect, 3),
            number(oversize, 3),
            deformation
        );
    }
    generated::section("README.md", "| projection | keeps |", &table);
}

/// What a page says of when to take another projection compares the two. Its figures are those of their profiles.
#[test]
fn choices_are_made_by_the_figures_of_profiles() {
    // The angle of creases, which `creases_are_where_they_should_be` holds.
    let others = ["5"];
    let mut compared = 0;
    for &projection in Projection::ALL {
        let file = format!("src/cube/projection/{}.rs", projection.profile().name.replace('-', "_"));
        let source = std::fs::read_to_string(&file).unwrap();
        let (_, rest) = source.split_once("choose: \"").unwrap();
        let (choice, _) = rest.split_once("\",\n").unwrap();
        let named = |other: &&Projection| **other == projection || choice.contains(&format!("[`{other:?}`]"));
        let mut figures: Vec<String> = others.map(String::from).to_vec();
        for other in Projection::ALL.iter().filter(named) {
            let profile = other.profile();
            let ratios = [profile.area_ratio, profile.aspect_ratio, profile.oversize];
            figures.extend(ratios.map(|ratio| number(ratio, 3)));
            figures.push(number(profile.deformation, 1));
            figures.extend([profile.forward, profile.inverse].map(|e| e.instructions[0].to_string()));
        }
        // Not names as `S2Quadratic`, nor the 1 in `2.1 to 1`.
        for word in choice.split(|c: char| !c.is_alphanumeric() && c != '.') {
            let word = word.trim_end_matches('.');
            if word.starts_with(|c: char| c.is_ascii_digit()) && word != "1" {
                assert!(
                    figures.iter().any(|figure| figure == word),
                    "{projection}: {word} of {figures:?}"
                );
                compared += 1;
            }
        }
    }
    assert!(compared > 40, "{compared} figures");
}

/// The table of methods, whose type is named by `link`.
fn methods(link: impl Fn(Method) -> String) -> String {
    let mut table = String::from("| method | name | model | good to | instructions |\n|---|---|---|---|--:|\n");
    for &method in Method::ALL {
        let profile = method.profile();
        table += &format!(
            "| {} | `{method}` | {} | {} | {} |\n",
            link(method),
            profile.model,
            profile.good_to,
            profile.instructions
        );
    }
    table
}

#[test]
fn methods_are_shown() {
    let plain = methods(|method| format!("`{method:?}`"));
    generated::section("README.md", "| method | name | model |", &plain);
    let linked = methods(|method| format!("[`{method:?}`]"));
    generated::file("src/geodesic/methods.md", &linked);
}

#[test]
fn creases_are_where_they_should_be() {
    let [balanced, vertex, quadrilateralized] =
        [Projection::Balanced, Projection::Vertex, Projection::Quadrilateralized].map(measure::Measures::of);
    for smooth in [Projection::Even, Projection::Creaseless].map(measure::Measures::of) {
        assert!(smooth.inner_bend() < 0.1, "{}", smooth.inner_bend());
    }
    assert!(balanced.inner_bend() < 0.1, "balanced is smooth inside a face");
    assert!(
        vertex.inner_bend() < 5.0 && vertex.kinks.edges().max() < 0.1,
        "vertex is nearly smooth everywhere"
    );
    assert!(
        quadrilateralized.inner_bend() > 20.0,
        "quadrilateralized is creased along the diagonals"
    );
}

#[test]
fn texels_of_equal_area_cubes_are_askew() {
    let [quadrilateralized, healpix] = [Projection::Quadrilateralized, Projection::Healpix].map(measure::Measures::of);
    let near = |measured: f64, exact: f64| assert!((measured - exact).abs() < 1e-6, "{measured} {exact}");
    near(quadrilateralized.sphere.sides_ratio(), 1.041_903);
    let [side, polar] = healpix.kinds.map(|surveys| surveys.sides_ratio());
    near(side, 1.0);
    near(polar, (1.0 + std::f64::consts::PI.powi(2) / 16.0).sqrt());
}
