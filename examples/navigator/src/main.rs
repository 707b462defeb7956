//! Flies a route of four waypoints inside a fence, on an emulated Cortex-M4F and in `f32`: across and along each leg,
//! and how far the fence is.
//!
//! Places are degrees north and east of home. A receiver gives them as whole numbers of 1e-7 degrees: their difference
//! from home is exact, where a latitude in `f32` has 0.4 m.

#![no_std]
#![no_main]

use core::panic::PanicInfo;

use cortex_m_rt::entry;
use cortex_m_semihosting::debug::{EXIT_FAILURE, EXIT_SUCCESS, exit};
use cortex_m_semihosting::hprintln;
use terrella::math::{atan2, sin_cos};
use terrella::route::{Fence, Legs, Planar, Side, TangentPlane};
use terrella::{Ellipsoid, LatLon};

/// A fix as receivers give it: 1e-7 degrees.
type Fix = [i32; 2];

const HOME: Fix = [473_977_420, 85_455_940];

const ROUTE: [Fix; 5] = [
    HOME,
    [474_057_420, 85_475_940],
    [474_077_420, 85_655_940],
    [473_957_420, 85_685_940],
    HOME,
];

const FENCE: [Fix; 5] = [
    [473_917_420, 85_415_940],
    [473_917_420, 85_725_940],
    [474_107_420, 85_705_940],
    [474_107_420, 85_435_940],
    [473_997_420, 85_425_940],
];

/// Metres a second: of the aircraft, and of the wind to the east and to the north.
const SPEED: f32 = 18.0;
const WIND: [f32; 2] = [-3.0, 4.0];

/// Degrees from home.
fn offset([lat, lon]: Fix) -> Option<LatLon<f32>> {
    let degrees = |fix: i32, home: i32| (fix - home) as f32 * 1e-7;
    LatLon::new(degrees(lat, HOME[0]), degrees(lon, HOME[1])).ok()
}

/// A waypoint is reached within so many metres.
const REACHED: f32 = 25.0;

/// The flight; none if a constant is no place.
fn fly() -> Option<()> {
    let home = LatLon::new(HOME[0] as f32 * 1e-7, HOME[1] as f32 * 1e-7).ok()?;
    let earth = Ellipsoid::WGS84;
    let (legs, plane) = (TangentPlane::local(earth, home).ok()?, Planar::about(earth, home).ok()?);
    let mut corners = [[0.0; 2]; FENCE.len()];
    for (corner, fix) in corners.iter_mut().zip(FENCE) {
        *corner = plane.offset(offset(fix)?);
    }
    let rings = [corners.as_slice()];
    let fence = Fence::new(&plane, &rings);

    let mut at = HOME;
    let mut time = 0;
    hprintln!("second\tleg\talong m\tacross cm\tto the fence m");
    for (number, ends) in ROUTE.windows(2).enumerate() {
        let &[from, to] = ends else { return None };
        let leg = legs.leg(offset(from)?, offset(to)?);
        let length = legs.length(&leg);
        loop {
            let place = offset(at)?;
            let track = legs.track_beside(&leg, place);
            let here = plane.offset(place);
            if time % 20 == 0 {
                let [along, across, left] =
                    [track.along, 100.0 * track.across, -fence.distance(here)].map(|v| v as i32);
                hprintln!("{}\t{}\t{}\t{}\t{}", time, number + 1, along, across, left);
            }
            if fence.side(here) != Side::Inside {
                hprintln!("{}\tthe fence is crossed", time);
                return None;
            }
            if track.along > length - REACHED {
                break;
            }
            // Toward a point of the leg 60 m ahead, with the wind.
            let (course, gone) = (atan2(track.across, 60.0), leg_course(&plane, [from, to])?);
            let (sin, cos) = sin_cos(gone - course);
            let [east, north] = [SPEED * sin + WIND[0], SPEED * cos + WIND[1]];
            at = moved(at, [east, north]);
            time += 1;
        }
    }
    hprintln!("{}\thome", time);
    Some(())
}

/// The azimuth of a leg in the plane, in radians.
fn leg_course(plane: &Planar<f32>, [from, to]: [Fix; 2]) -> Option<f32> {
    let ([e, n], [east, north]) = (plane.offset(offset(from)?), plane.offset(offset(to)?));
    Some(atan2(east - e, north - n))
}

/// What the receiver tells a second later.
fn moved([lat, lon]: Fix, [east, north]: [f32; 2]) -> Fix {
    // 1e-7 degrees of latitude and longitude at home, in metres.
    [lat + (north / 0.011_117) as i32, lon + (east / 0.007_551) as i32]
}

#[entry]
fn main() -> ! {
    end(fly().is_some())
}

fn end(well: bool) -> ! {
    loop {
        exit(if well { EXIT_SUCCESS } else { EXIT_FAILURE });
    }
}

#[panic_handler]
fn panic(_: &PanicInfo) -> ! {
    end(false)
}
