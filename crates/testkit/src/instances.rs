//! Long generic functions that several suites call: those that are named here are compiled once, with this crate, and
//! each suite links them. (Below `opt-level = 2` the compiler takes an instance from a crate that has it.)

use terrella::cube::{CubeMap, CubeProjection, Projection};
use terrella::{Dual, Real};

/// Names all of them; nobody calls it.
pub fn instances() -> [[*const (); 7]; 2] {
    [of::<f64>(), of::<f32>()]
}

fn of<T: Real>() -> [*const (); 7] {
    [
        Projection::forward::<T> as *const (),
        Projection::inverse::<T> as *const (),
        Projection::inverse::<Dual<T, 2>> as *const (),
        Projection::is_polar::<T> as *const (),
        Projection::unproject::<T> as *const (),
        CubeMap::<T, Projection>::project as *const (),
        CubeMap::<T, Projection>::unproject as *const (),
    ]
}
