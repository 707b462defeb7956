//! Cells against S2's published constants, and what must hold for every projection.

use terrella::cube::{Adjusted, CubeProjection, Face, Projection, S2Quadratic, Tangential};
use terrella::distortion::{Cells, Statistic};
use terrella::{Ellipsoid, Shift};
use testkit::{Worst, maximum};

use crate::sphere::{on, unit_sphere};

fn of<P: CubeProjection>(projection: P, face: Face, n: u32) -> Cells<f64> {
    let mut cells = Cells::new();
    cells.face(&unit_sphere(projection), face, n);
    cells
}

/// Radians to the mean side of a cell.
fn side() -> f64 {
    (4.0 * std::f64::consts::PI / 6.0).sqrt()
}

/// What S2 publishes for a projection, `s2metrics.cc`: derivatives, so the limits of cells of high levels.
struct Published {
    span: [f64; 3],
    edge: [f64; 3],
    diagonal: [f64; 3],
    area: [f64; 2],
    edge_aspect: f64,
}

const ROOT_2: f64 = std::f64::consts::SQRT_2;
const PI: f64 = std::f64::consts::PI;
const ROOT_3: f64 = 1.732_050_807_568_877_2;

/// Least, largest and mean (of areas the mean is 4π/6 for all, of spans π/2).
const LINEAR: Published = Published {
    span: [1.0, 2.0, PI / 2.0],
    edge: [2.0 * ROOT_2 / 3.0, 2.0, 1.440_034_192_955_603_643],
    diagonal: [2.0 * ROOT_2 / 3.0, 2.0 * ROOT_2, 2.031_817_866_418_812_674],
    area: [4.0 / (3.0 * ROOT_3), 4.0],
    edge_aspect: ROOT_2,
};
const TAN: Published = Published {
    span: [PI / 2.0, PI / 2.0, PI / 2.0],
    edge: [PI / (2.0 * ROOT_2), PI / 2.0, 1.461_667_032_546_739_266],
    diagonal: [PI * ROOT_2 / 3.0, PI * ROOT_2 / ROOT_3, 2.063_623_197_195_635_753],
    area: [PI * PI / (4.0 * ROOT_2), PI * PI / 4.0],
    edge_aspect: ROOT_2,
};
const QUADRATIC: Published = Published {
    span: [4.0 / 3.0, 1.704_897_179_199_218_452, PI / 2.0],
    edge: [2.0 * ROOT_2 / 3.0, 1.704_897_179_199_218_452, 1.459_213_746_386_106_062],
    diagonal: [8.0 * ROOT_2 / 9.0, 2.438_654_594_434_021_032, 2.060_422_738_998_471_683],
    area: [8.0 * ROOT_2 / 9.0, 2.635_799_256_963_161_491],
    edge_aspect: 1.442_615_274_452_682_920,
};

/// A part of the measures.
type Part = fn(&Cells<f64>) -> &Statistic<f64>;

/// The limit of values for n, 2n and 4n cells, whose error is a sum of multiples of 1/n and of 1/n².
fn limit([coarse, middle, fine]: [f64; 3]) -> f64 {
    let [first, second] = [2.0 * middle - coarse, 2.0 * fine - middle];
    (4.0 * second - first) / 3.0
}

fn hold_to<P: CubeProjection>(name: &str, projection: P, published: &Published, near: f64) {
    let each = [128, 256, 512].map(|n| of(projection, Face::Right, n));
    let (mut extremes, mut means) = (Worst::default(), Worst::default());
    let mean_area = 4.0 * PI / 6.0;
    let parts: [(Part, f64, [f64; 3]); 4] = [
        (Cells::span, side(), published.span),
        (Cells::edge, side(), published.edge),
        (Cells::diagonal, side(), published.diagonal),
        (
            Cells::area,
            mean_area,
            [published.area[0], published.area[1], mean_area],
        ),
    ];
    for (part, unit, [least, most, mean]) in parts {
        let each = each.each_ref().map(part);
        for (value, expected) in [
            (limit(each.map(Statistic::min)), least),
            (limit(each.map(Statistic::max)), most),
        ] {
            extremes.add((value * unit - expected).abs());
        }
        means.add((limit(each.map(Statistic::mean)) * unit - mean).abs());
        // S2 says that the bounds hold for cells of all levels.
        let [_, _, fine] = each;
        assert!(fine.min() * unit >= least * (1.0 - 1e-9) && fine.max() * unit <= most * (1.0 + 1e-9));
    }
    for (part, expected) in [
        (Cells::edge_aspect as Part, published.edge_aspect),
        (Cells::diagonal_aspect, ROOT_3),
    ] {
        extremes.add((limit(each.each_ref().map(part).map(Statistic::max)) - expected).abs());
    }
    println!("{name}: extremes {:.1e}, means {:.1e}", extremes.value(), means.value());
    assert!(extremes.value() < near, "{name}: {:e}", extremes.value());
    assert!(means.value() < 1e-9, "{name}: {:e}", means.value());
}

#[test]
fn the_constants_of_s2() {
    hold_to("linear", Tangential, &LINEAR, 1e-6);
    hold_to("tan", Adjusted, &TAN, 1e-6);
    // Some of its extremes lie inside the face, between the centres of cells.
    hold_to("quadratic", S2Quadratic, &QUADRATIC, 1e-4);
}

#[test]
fn a_face_is_one_cell() {
    let cells = of(Tangential, Face::Top, 1);
    let edge = (1.0_f64 / 3.0).acos() / side();
    for (seen, expected) in [
        (cells.area().max(), 1.0),
        (cells.edge().min(), edge),
        (cells.edge().max(), edge),
        (cells.diagonal().max(), (-1.0_f64 / 3.0).acos() / side()),
        (cells.span().max(), PI / 2.0 / side()),
        (cells.edge_aspect().max(), 1.0),
        (
            cells.compactness().max(),
            (4.0 * PI / 6.0) * (4.0 * PI * 5.0 / 6.0) / (4.0 * (1.0_f64 / 3.0).acos()).powi(2),
        ),
        (cells.spacing().max(), 1.0),
    ] {
        assert!((seen - expected).abs() < 1e-14, "{seen} is not {expected}");
    }
}

#[test]
fn rounding_grows_with_n() {
    // Planes at equal angles: every span is that angle, and so are the edges along a midline, the longest.
    for n in [10, 100, 400] {
        let cells = of(Adjusted, Face::Back, n);
        let off = |length: f64| (length * side() / (PI / 2.0) - 1.0).abs();
        let (edge, n) = (off(cells.edge().max()), f64::from(n));
        let span = maximum(off(cells.span().min()), off(cells.span().max()));
        println!("{n}: edge {:.1e} n, span {:.1e} n²", edge / n, span / (n * n));
        assert!(edge < n * 2e-15 && span < n * n * 1e-16, "{edge:e} {span:e}");
    }
}

#[test]
fn areas_add_up_and_every_cell_has_its_measures() {
    for &projection in Projection::ALL {
        for n in [1, 2, 5, 62, 63] {
            let mut cells = Cells::new();
            cells.sphere(&unit_sphere::<f64, _>(projection), n);
            let count = 6 * u64::from(n).pow(2);
            for (statistic, each) in [
                (cells.area(), 1),
                (cells.edge(), 4),
                (cells.diagonal(), 2),
                (cells.span(), 2),
                (cells.edge_aspect(), 1),
                (cells.diagonal_aspect(), 1),
                (cells.compactness(), 1),
                (cells.spacing(), 1),
            ] {
                assert_eq!(statistic.count(), each * count, "{projection}, {n}");
                assert!(statistic.mean().is_finite(), "{projection}, {n}");
                assert!(statistic.min() > 0.0, "{projection}, {n}");
            }
            assert!(cells.compactness().max() < 0.92, "{projection}, {n}");
            // The geodesic polygons tile the sphere.
            assert!(
                (cells.area().mean() - 1.0).abs() < 1e-12,
                "{projection}, {n}: {}",
                cells.area().mean()
            );
        }
    }
}

#[test]
fn halves_make_the_whole() {
    let ground = unit_sphere::<f64, _>(Projection::Healpix);
    let (mut whole, mut parts) = (Cells::new(), Cells::new());
    whole.sphere(&ground, 20);
    for face in Face::ALL {
        let mut part = Cells::new();
        part.face(&ground, face, 20);
        parts.merge(&part);
    }
    assert_eq!(whole.spacing().max(), parts.spacing().max());
    assert_eq!(whole.area().count(), parts.area().count());
    assert!((whole.compactness().mean() - parts.compactness().mean()).abs() < 1e-14);
}

#[test]
fn single_precision_sees_the_same() {
    for (&projection, n) in Projection::ALL.iter().flat_map(|p| [(p, 32), (p, 200)]) {
        let mut short = Cells::new();
        short.face(&unit_sphere::<f32, _>(projection), Face::Top, n);
        let long = of(projection, Face::Top, n);
        let apart = |pairs: &[(&Statistic<f32>, &Statistic<f64>)]| {
            Worst::of(pairs.iter().flat_map(|(short, long)| {
                [
                    (short.min(), long.min()),
                    (short.max(), long.max()),
                    (short.mean(), long.mean()),
                ]
                .map(|(short, long)| (f64::from(short) / long - 1.0).abs())
            }))
        };
        let error = apart(&[
            (short.area(), long.area()),
            (short.edge(), long.edge()),
            (short.diagonal(), long.diagonal()),
            (short.compactness(), long.compactness()),
            (short.spacing(), long.spacing()),
        ]);
        let of_spans = apart(&[(short.span(), long.span())]);
        let n = f64::from(n);
        println!("{projection}, {n}: {:.1e} n, {:.1e} n²", error / n, of_spans / (n * n));
        assert!(error < n * 1e-6, "{projection}, {n}: {error:e}");
        assert!(of_spans < n * n * 5e-8, "{projection}, {n}: {of_spans:e}");
    }
}

#[test]
fn on_the_ellipsoid_by_every_shift() {
    for &shift in Shift::ALL {
        for n in [8, 64] {
            let ground = on(Ellipsoid::<f64>::WGS84, shift, Projection::Vertex);
            let mut cells = Cells::new();
            cells.sphere(&ground, n);
            let sphere = of(Projection::Vertex, Face::Front, n);
            // The whole planet, but for the approximation by the authalic sphere.
            let error = (cells.area().mean() - 1.0).abs() * f64::from(n * n);
            assert!(error < 2e-3, "{shift}, {n}: {error:e}");
            // Flattening changes no measure by more than a few times itself.
            let change = cells.edge().max() / sphere.edge().max() - 1.0;
            assert!(change.abs() < 0.01, "{shift}: {change}");
            if shift == Shift::Authalic {
                let largest = maximum(cells.area().ratio(), sphere.area().ratio());
                assert!((cells.area().ratio() / largest - 1.0).abs() < 0.02);
            }
        }
    }
}
