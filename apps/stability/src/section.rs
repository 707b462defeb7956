//! The fourth picture: from Earth-centred coordinates to latitude, longitude and height, over a section of the Earth.

use rayon::prelude::*;
use terrella::{Ecef, Ellipsoid, Real};

use crate::pair::Scalar;
use crate::reference::{A, Reference};
use crate::scale::Scale;
use draw::svg::{Area, Svg};
use draw::units::{length, metres};

/// The longitude of the section in degrees.
const LON: f64 = 30.0;
/// What the two rows of maps reach to, in metres, and how far apart their ticks are.
const REACHES: [[f64; 2]; 2] = [[1e7, 2e6], [6e4, 1e4]];
const PANEL: f64 = 290.0;

/// Draws the maps.
pub fn draw(side: u32) -> Result<Svg, String> {
    let mut svg = Svg::new(1400.0, 880.0);
    for (row, [reach, tick]) in (0_u8..).zip(REACHES) {
        for (pair, scalar) in (0_u8..).zip(Scalar::ALL) {
            let errors = errors(scalar, reach, side)?;
            for (of_pair, name) in ["place on the ground", "height"].into_iter().enumerate() {
                let column = 2.0 * f64::from(pair) + of_pair as f64;
                let area = Area {
                    x: 90.0 + column * (PANEL + 36.0),
                    y: 44.0 + f64::from(row) * (PANEL + 90.0),
                    width: PANEL,
                    height: PANEL,
                };
                let cells: Vec<_> = errors.iter().map(|e| Some(e[of_pair])).collect();
                svg.image(area, &scale(scalar).map(side, &cells))?;
                svg.text([area.x, area.y - 12.0], "", &format!("{name}, {}", scalar.name()));
                let worst = cells.iter().copied().flatten().fold(0.0, f64::max);
                svg.text(
                    [area.right(), area.y - 12.0],
                    "small end",
                    &format!("≤ {}", length(worst)),
                );
                curves(&mut svg, area, reach);
                svg.frame(area);
                ticks(&mut svg, area, reach, tick, column == 0.0);
            }
        }
    }
    for (pair, scalar) in (0_u8..).zip(Scalar::ALL) {
        let area = Area {
            x: 90.0 + f64::from(pair) * 2.0 * (PANEL + 36.0),
            y: 822.0,
            width: 2.0 * PANEL + 36.0,
            height: 14.0,
        };
        scale(scalar).legend(&mut svg, area, &format!("error, {}", scalar.name()))?;
    }
    Ok(svg)
}

fn scale(scalar: Scalar) -> Scale {
    Scale {
        exponents: match scalar {
            Scalar::F64 => [-12.0, -8.0],
            Scalar::F32 => [-3.0, 1.0],
        },
        unit: metres,
    }
}

/// The errors of place and height in metres, row by row from the north.
fn errors(scalar: Scalar, reach: f64, side: u32) -> Result<Vec<[f64; 2]>, String> {
    let (sin, cos) = LON.to_radians().sin_cos();
    let along = |i: u32| reach * (f64::from(i) + 0.5) / f64::from(side);
    let cell = |i: u32| {
        let (rho, z) = (along(i % side), along(side - 1 - i / side));
        let point = [rho * cos, rho * sin, z].map(|x| scalar.round(x));
        match scalar {
            Scalar::F64 => found(point, |x| x),
            Scalar::F32 => found(point, |x| x as f32),
        }
    };
    (0..side * side).into_par_iter().map(cell).collect()
}

fn found<T: Real + Into<f64>>(point: [f64; 3], to: impl Fn(f64) -> T) -> Result<[f64; 2], String> {
    let [x, y, z] = point.map(to);
    let ecef = Ecef::new(x, y, z).map_err(|error| error.to_string())?;
    let geodetic = Ellipsoid::<T>::WGS84.to_geodetic(ecef);
    Ok(Reference::new(point).errors(geodetic))
}

/// The surface of the Earth and its evolute.
fn curves(svg: &mut Svg, area: Area, reach: f64) {
    let b = Ellipsoid::<f64>::WGS84.b();
    let e2 = Ellipsoid::<f64>::WGS84.e2();
    let place = |rho: f64, z: f64| {
        [
            area.x + rho / reach * area.width,
            area.bottom() - z / reach * area.height,
        ]
    };
    let parametric = |f: &dyn Fn(f64, f64) -> [f64; 2]| -> Vec<_> {
        (0..=90)
            .map(|degrees| f64::from(degrees).to_radians().sin_cos())
            .map(|(s, c)| f(s, c))
            .collect()
    };
    let surface = |s: f64, c: f64| place(A * c, b * s);
    let evolute = |s: f64, c: f64| place(A * e2 * c.powi(3), A * e2 * A / b * s.powi(3));
    if reach > A {
        svg.polyline(&parametric(&surface), "lead", "#ffffff");
    } else {
        svg.polyline(&parametric(&evolute), "lead", "#ffffff");
    }
}

fn ticks(svg: &mut Svg, area: Area, reach: f64, tick: f64, named: bool) {
    let axis = area.bottom() + 36.0;
    svg.text(
        [area.x + 0.5 * area.width, axis],
        "small middle",
        "distance from the axis, km",
    );
    if named {
        svg.upright(
            [area.x - 62.0, area.y + 0.5 * area.height],
            "small middle",
            "distance from the equator’s plane, km",
        );
    }
    for i in 0..=(reach / tick) as u32 {
        let value = tick * f64::from(i);
        let along = value / reach;
        let text = format!("{:.0}", value / 1e3);
        svg.text(
            [area.x + along * area.width, area.bottom() + 17.0],
            "small middle",
            &text,
        );
        if named {
            svg.text(
                [area.x - 8.0, area.bottom() - along * area.height + 5.0],
                "small end",
                &text,
            );
        }
    }
}
