//! The area and the perimeter of a ring whose edges are geodesics.

use terrella::geodesic::{Area, PolygonArea};
use terrella::{Ellipsoid, LatLon};

use crate::columns::{column, leave};
use crate::current::Current;
use crate::refusal::or_words;

static AREA: Current<Area<f64>> = Current::none();
static RING: Current<PolygonArea<'static, f64>> = Current::none();

/// Calls are about this ellipsoid from now on, or words.
#[unsafe(no_mangle)]
extern "C" fn area(a: f64, f: f64) -> bool {
    RING.put(None);
    let area = || or_words(Area::new(or_words(Ellipsoid::new(a, f))?));
    AREA.put(area())
}

/// Starts a ring.
#[unsafe(no_mangle)]
extern "C" fn ring() {
    RING.put(Some(AREA.get().polygon()));
}

/// Columns lat, lon: more corners of the ring. The number that was added: if less, the next is refused, with words.
#[unsafe(no_mangle)]
extern "C" fn ring_add(count: usize) -> usize {
    let ring = RING.get();
    // SAFETY: each column is lent once.
    let [lat, lon] = unsafe { [column::<f64>(0, count), column(1, count)] };
    for (index, (&mut lat, &mut lon)) in lat.iter_mut().zip(lon).enumerate() {
        let Some(corner) = or_words(LatLon::new(lat, lon)) else {
            return index;
        };
        ring.add(corner);
    }
    count
}

/// Leaves the ring's area and perimeter.
#[unsafe(no_mangle)]
extern "C" fn ring_measure() {
    let ring = RING.get();
    leave([ring.area(), ring.perimeter()]);
}
