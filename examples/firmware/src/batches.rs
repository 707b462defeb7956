//! The stack of the deepest batches, without their arguments and results.

use calls::{POINTS, Scalar};
use cortex_m_semihosting::hprintln;
use terrella::batch::{geodesic, map};
use terrella::cube::{CubeMap, Face, Quadrilateralized};
use terrella::geodesic::Karney;
use terrella::{Ellipsoid, Shift};

use crate::stack::depth;

/// Prints a line for each.
pub fn show<T: Scalar>() {
    let earth = Ellipsoid::<T>::WGS84;
    let (Ok(karney), Ok(cube)) = (
        Karney::new(earth),
        CubeMap::new(earth, Shift::Authalic, Quadrilateralized),
    ) else {
        return;
    };
    // Longitudes that are wrapped.
    let (lat, lon) = ([T::of(30.0); POINTS], [T::of(200.0); POINTS]);
    let (far, azimuth) = ([T::of(-29.9); POINTS], [T::of(20.5); POINTS]);
    let [mut a, mut b, mut c, mut d] = [[T::ZERO; POINTS]; 4];
    let mut faces = [Face::Front; POINTS];
    let line = |name: &str, call: &mut dyn FnMut() -> bool| {
        let mut well = false;
        let bytes = depth(&mut || well = call());
        hprintln!(
            "{}\t{}\t{}{}",
            name,
            T::NAME,
            bytes,
            if well { "" } else { "\tREFUSED" }
        );
    };
    line("batch::geodesic::inverse", &mut || {
        geodesic::inverse(&karney, [&lat, &lon], [&far, &azimuth], [&mut a, &mut b, &mut c]).is_ok()
    });
    line("batch::geodesic::direct", &mut || {
        geodesic::direct(&karney, [&lat, &lon], &azimuth, &lat, [&mut a, &mut b, &mut c]).is_ok()
    });
    line("batch::map::project", &mut || {
        map::project(&cube, [&lat, &lon], &mut faces, [&mut a, &mut b]).is_ok()
    });
    line("batch::map::unproject", &mut || {
        map::unproject(&cube, &faces, [&a, &b], [&mut c, &mut d]).is_ok()
    });
}
