//! Projections and shifts, there and back.

use terrella::Shift;
use terrella::cube::Projection;

use crate::run::{answers, numbers};

fn text(rows: impl IntoIterator<Item = [f64; 3]>) -> String {
    rows.into_iter().map(|[a, b, c]| format!("{a} {b} {c}\n")).collect()
}

/// Unit vectors all over the sphere, on a spiral.
fn directions() -> impl Iterator<Item = [f64; 3]> {
    (0..2000).map(|i| {
        let z = 1.0 - f64::from(2 * i + 1) / 2000.0;
        let (sin, cos) = (f64::from(i) * 2.399_963_229_728_653).sin_cos();
        let r = (1.0 - z * z).sqrt();
        [r * cos, r * sin, z]
    })
}

fn unit([x, y, z]: [f64; 3]) -> [f64; 3] {
    let length = (x * x + y * y + z * z).sqrt();
    [x / length, y / length, z / length]
}

#[test]
fn every_projection_closes_its_round_trip() {
    for (scalar, tolerance) in [("f64", 1e-15), ("f32", 5e-7)] {
        let rounded = |v: f64| if scalar == "f32" { f64::from(v as f32) } else { v };
        let directions: Vec<_> = directions().map(|d| d.map(rounded)).collect();
        for projection in Projection::ALL {
            // The published pair of polynomials, which miss each other.
            let tolerance = if *projection == Projection::Cobe {
                6e-4
            } else {
                tolerance
            };
            let options = format!("--projection {projection} --scalar {scalar}");
            let on_cube = answers(&format!("forward {options}"), text(directions.iter().copied()));
            let back = numbers(&answers(&format!("inverse {options}"), on_cube));
            assert_eq!(back.len(), directions.len());
            for (&direction, back) in directions.iter().zip(back) {
                let expected = unit(direction);
                let miss = (0..3).map(|i| (back[i] - expected[i]).powi(2)).sum::<f64>().sqrt();
                assert!(miss <= tolerance, "{options}: {direction:?} comes back as {back:?}");
            }
        }
    }
}

#[test]
fn every_shift_closes_its_round_trip() {
    let positions = "-89.999 -179.5\n-45 12.25\n0 0\n1e-9 90\n41.8 45\n59.91 10.75\n90 0\n";
    for shift in Shift::ALL {
        for ellipsoid in ["wgs84", "moon", "1,1/10", "1,-1/9"] {
            let options = format!("--projection equi-edge --shift {shift} --ellipsoid {ellipsoid}");
            let back = answers(
                &format!("unproject {options}"),
                answers(&format!("project {options}"), positions),
            );
            for (line, back) in positions.lines().zip(numbers(&back)) {
                let lat: f64 = line.split(' ').next().unwrap().parse().unwrap();
                assert!(
                    (back[0] - lat).abs() < 5e-14,
                    "{options}: {line} comes back as {back:?}"
                );
            }
        }
    }
}

#[test]
fn axes_are_exact() {
    let axes = "1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n0 0 1\n0 0 -1\n";
    for projection in Projection::ALL {
        for scalar in ["f64", "f32"] {
            let options = format!("--projection {projection} --scalar {scalar}");
            let on_cube = answers(&format!("forward {options}"), axes);
            for (face, row) in numbers(&on_cube).into_iter().enumerate() {
                assert_eq!(row, [face as f64, 0.0, 0.0], "{options}");
            }
            let back = answers(&format!("inverse {options}"), on_cube);
            for (axis, row) in axes.lines().zip(numbers(&back)) {
                let axis: Vec<f64> = axis.split(' ').map(|v| v.parse().unwrap()).collect();
                assert_eq!(row, axis, "{options}");
            }
        }
    }
}

#[test]
fn ties_go_to_y_then_z_then_x() {
    for projection in Projection::ALL.iter().filter(|&&p| p != Projection::Healpix) {
        let on_cube = answers(
            &format!("forward --projection {projection}"),
            "1 1 0\n0 1 -1\n1 0 1\n-1 0 -1\n-2 2 0.5\n1 1 1\n1 -1 -1\n",
        );
        let faces: Vec<_> = numbers(&on_cube).iter().map(|row| row[0]).collect();
        assert_eq!(faces, [1.0, 1.0, 4.0, 5.0, 1.0, 1.0, 3.0], "{projection}");
    }
    assert_eq!(
        answers("forward --projection tangential", "1 1 1\n2 -2 1\n1 0.5 1"),
        "1\t-1.0\t1.0\n3\t1.0\t0.5\n4\t0.5\t-1.0\n"
    );
}

/// A cube that is turned and stretched: the face's centre is where it was put, and the way there and back closes.
#[test]
fn oblique_cubes_close_their_round_trip() {
    let centre = |options: &str| {
        let options = format!("--projection balanced {options}");
        numbers(&answers(&format!("project {options} --shift geodetic"), "47.5 8.25\n"))[0].clone()
    };
    for (options, face) in [
        ("--front 47.5,8.25,30", 0.0),
        ("--top 47.5,8.25,-100", 4.0),
        ("--top=47.5,8.25,0 --stretch 5", 4.0),
    ] {
        let found = centre(options);
        assert_eq!(found[0], face, "{options}: {found:?}");
        assert!(found[1].abs() < 1e-15 && found[2].abs() < 1e-15, "{options}: {found:?}");

        let directions: Vec<_> = directions().collect();
        let on_cube = answers(
            &format!("forward --projection balanced {options}"),
            text(directions.iter().copied()),
        );
        let back = numbers(&answers(&format!("inverse --projection balanced {options}"), on_cube));
        for (&direction, back) in directions.iter().zip(back) {
            let expected = unit(direction);
            let miss = (0..3).map(|i| (back[i] - expected[i]).powi(2)).sum::<f64>().sqrt();
            assert!(miss <= 5e-15, "{options}: {direction:?} comes back as {back:?}");
        }
    }
    assert_eq!(
        answers("forward --projection square --stretch 1", "1 0.5 0\n"),
        answers("forward --projection square", "1 0.5 0\n")
    );
}
