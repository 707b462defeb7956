//! Compiles the shims in `shims/` into one shared library per rival and build of it, as far as the rivals are there:
//! against Debian's packages at -O2, and against what `sources.sh` built, at -O3 with link-time optimisation.
//! Each keeps its symbols to itself, so that two builds of one library can be loaded side by side.

use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

struct Rival {
    name: &'static str,
    package: &'static str,
    library: &'static str,
    /// Where `sources.sh` leaves headers and the static library, under its folder of that name.
    include: &'static [&'static str],
    archive: &'static str,
    /// What the static library needs.
    needs: &'static [&'static str],
}

const RIVALS: [Rival; 4] = [
    Rival {
        name: "geographiclib",
        package: "libgeographiclib-dev",
        library: "-lGeographicLib",
        include: &["include", "build/include"],
        archive: "build/src/libGeographicLib.a",
        needs: &[],
    },
    Rival {
        name: "proj",
        package: "libproj-dev",
        library: "-lproj",
        include: &["src"],
        archive: "build/lib/libproj.a",
        needs: &["-lsqlite3", "-lpthread", "-ldl"],
    },
    Rival {
        name: "wcslib",
        package: "wcslib-dev",
        library: "-lwcs",
        include: &["C", "build"],
        archive: "build/libwcs.a",
        needs: &[],
    },
    Rival {
        name: "s2geometry",
        package: "libs2-dev",
        library: "-ls2",
        include: &["src"],
        archive: "build/libs2.a",
        needs: &[],
    },
];

fn main() {
    let crate_root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("set by cargo"));
    let out = PathBuf::from(env::var("OUT_DIR").expect("set by cargo"));
    let target = env::var("CARGO_TARGET_DIR").map_or_else(|_| crate_root.join("target"), PathBuf::from);
    println!("cargo:rerun-if-changed=shims");
    println!("cargo:rerun-if-env-changed=CARGO_TARGET_DIR");
    // A routine from a paper, which needs no library: the version is its year.
    let shim = crate_root.join("shims/olson.cpp");
    if !compile(&shim, &out.join("olson-alone.so"), "1996", &["-O3".to_owned()], &[]) {
        println!("cargo:warning=without Olson's routine: apt-get install g++");
    }
    for rival in &RIVALS {
        let shim = crate_root.join("shims").join(rival.name).with_extension("cpp");
        let sources = target.join("sources").join(rival.name);
        println!("cargo:rerun-if-changed={}", sources.with_extension("version").display());

        let debian = installed(rival.package).map(|version| {
            let flags = ["-O2".to_owned()];
            let link = [rival.library.to_owned()];
            compile(
                &shim,
                &out.join(format!("{}-debian.so", rival.name)),
                &version,
                &flags,
                &link,
            )
        });
        if debian != Some(true) {
            println!(
                "cargo:warning=without {} of Debian: apt-get install {}",
                rival.name, rival.package
            );
        }

        let version = fs::read_to_string(sources.with_extension("version")).ok();
        let built = version.filter(|_| sources.join(rival.archive).exists()).map(|version| {
            let mut flags = vec!["-O3".to_owned(), "-flto".to_owned(), "-DNDEBUG".to_owned()];
            flags.extend(
                rival
                    .include
                    .iter()
                    .map(|folder| format!("-I{}", sources.join(folder).display())),
            );
            let mut link = vec![sources.join(rival.archive).display().to_string()];
            link.extend(rival.needs.iter().map(|&flag| flag.to_owned()));
            compile(
                &shim,
                &out.join(format!("{}-source.so", rival.name)),
                version.trim(),
                &flags,
                &link,
            )
        });
        if built != Some(true) {
            println!(
                "cargo:warning=without {} from source: ./sources.sh {}",
                rival.name, rival.name
            );
        }
    }
}

/// The version of an installed Debian package.
fn installed(package: &str) -> Option<String> {
    let query = Command::new("dpkg-query")
        .args(["-W", "-f=${db:Status-Status} ${Version}", package])
        .output()
        .ok()?;
    let text = String::from_utf8(query.stdout).ok()?;
    text.strip_prefix("installed ").map(str::to_owned)
}

fn compile(shim: &Path, library: &Path, version: &str, flags: &[String], link: &[String]) -> bool {
    let compiler = env::var("CXX").unwrap_or_else(|_| "c++".to_owned());
    let common = [
        "-std=c++17",
        "-shared",
        "-fPIC",
        "-fvisibility=hidden",
        "-fno-gnu-unique",
        "-Wl,-Bsymbolic",
        "-Wl,--exclude-libs,ALL",
        // WCSLIB's headers of the package are in a folder of their own; the other rivals have none of that name.
        "-isystem/usr/include/wcslib",
    ];
    let status = Command::new(compiler)
        .args(common)
        .args(flags)
        .arg(format!("-DVERSION=\"{version}\""))
        .arg(shim)
        .args(link)
        .arg("-o")
        .arg(library)
        .status();
    status.is_ok_and(|status| status.success())
}
