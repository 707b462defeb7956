//! Lists the projections for `projections!`: three symbols and the type of each.

use std::fmt::Write;
use std::{env, fs, path::Path};

use terrella::cube::Projection;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let mut list = String::from("projections! {\n");
    for projection in Projection::ALL {
        let name = projection.name().replace('-', "_");
        writeln!(list, "    {name}_forward {name}_inverse {name}_both {projection:?};").unwrap();
    }
    list += "}\n";
    fs::write(Path::new(&env::var("OUT_DIR").unwrap()).join("projections.rs"), list).unwrap();
}
