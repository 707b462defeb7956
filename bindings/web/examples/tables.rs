//! Writes `tables.js`: the crate's names of ellipsoids, projections and shifts, in the order of their indices.

use terrella::cube::Projection;
use terrella::{Ellipsoid, NAMED, Shift};

fn main() {
    println!("// Made by bindings/web/build from the crate's lists.\n");
    println!("/** Semi-major axis in metres and flattening of the ellipsoids that have a name. */");
    println!("export const ellipsoids = {{");
    for name in NAMED {
        let ellipsoid = Ellipsoid::<f64>::named(name).expect("a name of the list");
        println!("  {name:?}: {{ a: {:?}, f: {:?} }},", ellipsoid.a(), ellipsoid.f());
    }
    println!("}};");
    let projections: Vec<_> = Projection::ALL.iter().map(|projection| projection.name()).collect();
    println!("\n/** The names of the projections. */\nexport const projections = {projections:?};");
    let shifts: Vec<_> = Shift::ALL.iter().map(|shift| shift.name()).collect();
    println!(
        "\n/** The names of the latitudes by which an ellipsoid becomes a sphere. */\nexport const shifts = {shifts:?};"
    );
}
