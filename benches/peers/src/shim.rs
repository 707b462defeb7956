//! The shared libraries that `build.rs` makes of `shims/`.

use std::ffi::{CStr, c_char};
use std::path::Path;

use libloading::Library;

use crate::pass::Pass;

type Function = unsafe extern "C" fn(usize, *mut u8, *const *const f64, *const *mut f64);

/// One build of a rival in C or C++.
pub struct Shim {
    /// Name, version and build.
    pub library: String,
    handle: &'static Library,
}

impl Shim {
    /// The builds of a rival that there are, the missing ones named on the error stream.
    pub fn all(name: &str, called: &str) -> Vec<Self> {
        Self::of(name, called, &[("debian", "Debian"), ("source", "-O3 LTO")])
    }

    /// What is in the shim itself, no library beside it.
    pub fn alone(name: &str, called: &str) -> Vec<Self> {
        Self::of(name, called, &[("alone", "-O3")])
    }

    fn of(name: &str, called: &str, builds: &[(&str, &str)]) -> Vec<Self> {
        let shims = builds.iter().filter_map(|(suffix, build)| {
            let path = Path::new(env!("OUT_DIR")).join(format!("{name}-{suffix}.so"));
            if !path.exists() {
                eprintln!("missing: {called} ({build}), see README.md");
                return None;
            }
            // SAFETY: a library that build.rs compiled; its initialisers are the rivals' own.
            let handle: &'static Library = match unsafe { Library::new(&path) } {
                Ok(handle) => Box::leak(Box::new(handle)),
                Err(why) => {
                    eprintln!("missing: {called} ({build}): {why}");
                    return None;
                }
            };
            // SAFETY: pass.h defines it so.
            let version = unsafe {
                let version = handle
                    .get::<unsafe extern "C" fn() -> *const c_char>(b"version")
                    .expect("in pass.h");
                CStr::from_ptr(version()).to_string_lossy()
            };
            Some(Self {
                library: format!("{called} {version} ({build})"),
                handle,
            })
        });
        shims.collect()
    }

    /// A function of the shim.
    pub fn pass(&self, name: &str) -> Pass {
        // SAFETY: every exported function but `version` is a pass.
        let function: Function =
            *unsafe { self.handle.get(name.as_bytes()) }.unwrap_or_else(|why| panic!("{name}: {why}"));
        Box::new(move |set, room, range| {
            let face = room.face[range.clone()].as_mut_ptr();
            let inputs: Vec<*const f64> = set
                .columns
                .iter()
                .map(|column| column[range.clone()].as_ptr())
                .collect();
            let columns = room.columns.iter_mut();
            let outputs: Vec<*mut f64> = columns.map(|column| column[range.clone()].as_mut_ptr()).collect();
            // SAFETY: a pass reads and writes n values of as many columns as its inputs and results are, which the
            // tables of this program give it; all of them and `face` hold the range, as their slices show.
            unsafe { function(range.len(), face, inputs.as_ptr(), outputs.as_ptr()) }
        })
    }
}
