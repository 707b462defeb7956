//! The floors of the library: a room imports from lower floors, or from its own without a circle.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;
use std::path::Path;
use std::{env, fs};

use testkit::generated;

/// The floors from the lowest up, each with its rooms and a few words for each.
const FLOORS: &[&[(&str, &str)]] = &[
    &[("name", "names and their errors")],
    &[("real", "the scalar: f32, f64, Dual")],
    &[("math", "kernels and their tables")],
    &[("dual", "derivatives"), ("simd", "wide instructions")],
    &[("position", "LatLon, Geodetic, Ecef, Direction")],
    &[
        ("ellipsoid", "a, f; Ecef both ways"),
        ("latitude", "auxiliary latitudes"),
    ],
    &[
        ("cube", "faces, projections"),
        ("geodesic", "distances, areas"),
        ("frame", "Enu, Ned, Aer"),
        ("healpix", "pixels"),
    ],
    &[
        ("route", "legs, fences, rhumb lines"),
        ("grid", "UTM, MGRS, geohash"),
        ("distortion", "Tissot, surveys"),
        ("terrain", "tiles, selection, vertices"),
    ],
    &[("scene", "the cheapest model that is enough")],
    &[("batch", "the same functions over slices")],
];

/// A room beside the floors, that imports from all of them and is imported by none.
const BESIDE: &str = "interop";

type Imports = BTreeMap<String, BTreeSet<String>>;

/// The text without comments and strings, so that links in the documentation do not count.
fn code(text: &str) -> String {
    let mut out = String::new();
    let mut quoted = false;
    for line in text.lines() {
        let mut chars = line.char_indices();
        while let Some((at, c)) = chars.next() {
            match c {
                '\\' if quoted => drop(chars.next()),
                '"' if !line[..at].ends_with('\'') => quoted = !quoted,
                _ if quoted => {}
                '/' if line[at..].starts_with("//") => break,
                _ => out.push(c),
            }
        }
        out.push('\n');
    }
    out
}

/// What `lib.rs` gives again under its own name, and the room that has it.
fn reexports() -> BTreeMap<String, String> {
    let text = code(&fs::read_to_string(root().join("src/lib.rs")).unwrap());
    let mut owners = BTreeMap::new();
    for statement in text.split(';').filter_map(|s| s.trim().strip_prefix("pub use ")) {
        let (room, names) = statement.split_once("::").unwrap();
        for name in names
            .split(['{', '}', ','])
            .map(str::trim)
            .filter(|name| !name.is_empty())
        {
            owners.insert(name.to_owned(), room.to_owned());
        }
    }
    owners
}

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The first names of all paths `crate::…` in a text.
fn paths(text: &str) -> Vec<String> {
    let first = |path: &str| {
        path.chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect::<String>()
    };
    let mut found = Vec::new();
    for rest in text.split("crate::").skip(1) {
        let Some(group) = rest.strip_prefix('{') else {
            found.push(first(rest));
            continue;
        };
        // A name stands at the start of a group, or behind a comma that is in no inner group.
        let mut depth = 0;
        let mut start = true;
        for (at, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => break,
                '}' => depth -= 1,
                ',' if depth == 0 => start = true,
                c if start && !c.is_whitespace() => {
                    found.push(first(&group[at..]));
                    start = false;
                }
                _ => {}
            }
        }
    }
    found
}

fn collect(path: &Path, room: &str, owners: &BTreeMap<String, String>, imports: &mut Imports) {
    if path.is_dir() {
        for entry in fs::read_dir(path).unwrap() {
            collect(&entry.unwrap().path(), room, owners, imports);
        }
    } else if path.extension().is_some_and(|extension| extension == "rs") {
        let text = code(&fs::read_to_string(path).unwrap());
        let is_top = path.parent() == Some(&root().join("src")) || path.ends_with(Path::new(room).join("mod.rs"));
        assert!(
            !text.contains(if is_top { "super::" } else { "super::super" }),
            "{}: write `crate::` in place of `super::`, so that the floor can be seen",
            path.display()
        );
        for name in paths(&text) {
            let target = owners.get(&name).unwrap_or(&name);
            if target != room {
                imports.entry(room.to_owned()).or_default().insert(target.clone());
            }
        }
    }
}

fn imports() -> Imports {
    let owners = reexports();
    let mut imports = Imports::new();
    for entry in fs::read_dir(root().join("src")).unwrap() {
        let path = entry.unwrap().path();
        let room = path.file_stem().unwrap().to_str().unwrap();
        if room != "lib" {
            imports.entry(room.to_owned()).or_default();
            collect(&path, room, &owners, &mut imports);
        }
    }
    imports
}

fn floor(room: &str) -> usize {
    let found = FLOORS
        .iter()
        .position(|rooms| rooms.iter().any(|(name, _)| *name == room));
    match found {
        Some(floor) => floor,
        None => panic!("src/{room} has no floor: give it one in tests/pages/architecture.rs"),
    }
}

/// All rooms that a room imports, and what those import.
fn below<'a>(imports: &'a Imports, room: &str) -> BTreeSet<&'a str> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&str> = imports[room].iter().map(String::as_str).collect();
    while let Some(next) = open.pop() {
        if found.insert(next) {
            open.extend(imports[next].iter().map(String::as_str));
        }
    }
    found
}

#[test]
fn a_room_imports_from_lower_floors_or_its_own() {
    let imports = imports();
    for (room, targets) in imports.iter().filter(|(room, _)| *room != BESIDE) {
        for target in targets {
            assert!(
                floor(target) <= floor(room),
                "src/{room} imports the higher src/{target}"
            );
            assert!(
                !below(&imports, target).contains(room.as_str()),
                "src/{room} and src/{target} import each other"
            );
        }
    }
    for (room, _) in FLOORS.concat() {
        assert!(imports.contains_key(room), "src/{room} is not there");
    }
}

#[test]
fn the_picture_shows_the_floors() {
    generated::file("docs/architecture.svg", &picture(&imports()));
}

/// What a room imports, without what it would have by way of another import.
fn direct<'a>(imports: &'a Imports, room: &str) -> Vec<&'a str> {
    let mut names: Vec<&str> = imports[room].iter().map(String::as_str).collect();
    let all = names.clone();
    names.retain(|name| {
        !all.iter()
            .any(|other| other != name && below(imports, other).contains(name))
    });
    names.sort_by_key(|name| std::cmp::Reverse(floor(name)));
    names
}

const WIDTH: usize = 920;
const STEP: usize = 66;

fn picture(imports: &Imports) -> String {
    let height = FLOORS.len() * STEP + 20;
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {height}\" width=\"{WIDTH}\" \
         height=\"{height}\" role=\"img\" font-family=\"sans-serif\">\
         <title>The floors of terrella: a room imports from lower floors</title>\n\
         <rect width=\"{WIDTH}\" height=\"{height}\" rx=\"8\" fill=\"#fff\"/>\n"
    );
    let side = 160;
    let across = WIDTH - side - 30;
    for (level, rooms) in FLOORS.iter().enumerate() {
        let y = 10 + (FLOORS.len() - 1 - level) * STEP;
        let gap = 10;
        let width = (across - gap * (rooms.len() - 1)) / rooms.len();
        for (i, (room, words)) in rooms.iter().enumerate() {
            let below = match direct(imports, room).join(", ") {
                names if names.is_empty() => String::new(),
                names => format!("uses {names}"),
            };
            room_box(
                &mut text,
                [10 + i * (width + gap), y, width, STEP - 8],
                [room, words, &below],
            );
        }
    }
    let all = [WIDTH - side, 10, side - 10, FLOORS.len() * STEP - 8];
    room_box(&mut text, all, [BESIDE, "glam, mint, serde, …", "uses every floor"]);
    text + "</svg>\n"
}

fn room_box(text: &mut String, [x, y, width, height]: [usize; 4], [room, words, below]: [&str; 3]) {
    let (middle, line) = (x + width / 2, y + height / 2);
    let fill = if ["real", "math", "name", "dual", "simd"].contains(&room) {
        "#e8edf3"
    } else if room == BESIDE {
        "#f5f0e6"
    } else {
        "#dcebf7"
    };
    writeln!(
        text,
        "<rect x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{height}\" rx=\"5\" fill=\"{fill}\" stroke=\"#5b7185\"/>\
         <g text-anchor=\"middle\"><text x=\"{middle}\" y=\"{}\" font-size=\"16\" font-weight=\"bold\" \
         fill=\"#14283a\">{room}</text><text x=\"{middle}\" y=\"{}\" font-size=\"12\" fill=\"#14283a\">{words}</text>\
         <text x=\"{middle}\" y=\"{}\" font-size=\"11\" fill=\"#51677b\">{below}</text></g>",
        line - 10,
        line + 6,
        line + 22,
    )
    .unwrap();
}
