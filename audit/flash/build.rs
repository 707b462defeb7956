//! Lists the projections for `projections!`, with three symbols and the type of each, and the methods for `methods!`,
//! with two symbols.

use std::fmt::Write;
use std::{env, fs, path::Path};

use terrella::cube::Projection;
use terrella::geodesic::Method;

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    let mut list = String::from("projections! {\n");
    for projection in Projection::ALL {
        let name = projection.name().replace('-', "_");
        writeln!(list, "    {name}_forward {name}_inverse {name}_both {projection:?};").unwrap();
    }
    list += "}\n";
    write("projections.rs", &list);

    let mut list = String::from("methods! {\n");
    for method in Method::ALL {
        let name = method.name().replace('-', "_");
        writeln!(list, "    {name}_inverse {name}_direct {method:?};").unwrap();
    }
    list += "}\n";
    write("methods.rs", &list);
}

fn write(name: &str, list: &str) {
    fs::write(Path::new(&env::var("OUT_DIR").unwrap()).join(name), list).unwrap();
}
