//! Where pairs of segments intersect.

use crate::batch::InvalidBatch;
use crate::batch::engine::solve_by;
use crate::route::Intersections;
use crate::simd::{Sink, Source};
use crate::{InvalidLatLon, LatLon, Real};

/// Finds where pairs of segments intersect, with the bits of [`Intersections::of_segments`]: each segment by
/// latitude and longitude of both ends, in degrees; the results are both displacements in metres, latitude
/// and longitude. They are NaN where segments do not intersect, which is no error.
///
/// Segments are taken one by one: the number of steps depends on them.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses an end.
///
/// ```
/// use terrella::{Ellipsoid, batch::route, route::Intersections};
/// let intersections = Intersections::new(Ellipsoid::<f64>::WGS84)?;
/// let one: [&[f64]; 4] = [&[50.0, 50.0], &[-10.0, -10.0], &[60.0, 60.0], &[10.0, 10.0]];
/// let other: [&[f64]; 4] = [&[60.0, 0.0], &[-10.0, 0.0], &[50.0, 1.0], &[10.0, 1.0]];
/// let [mut x, mut y, mut lat, mut lon] = [[0.0; 2]; 4];
/// route::of_segments(&intersections, one, other, [&mut x, &mut y, &mut lat, &mut lon])?;
/// assert!((lat[0] - 56.035).abs() < 1e-3 && lat[1].is_nan());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn of_segments<T: Real>(
    intersections: &Intersections<T>,
    one: [&[T]; 4],
    other: [&[T]; 4],
    met: [&mut [T]; 4],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let segment = |[lat1, lon1, lat2, lon2]: [T; 4]| {
        Ok(intersections.segment(LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?))
    };
    let find = |(one, other): ([T; 4], [T; 4])| {
        let met = intersections.of_segments(&segment(one)?, &segment(other)?);
        let columns = met.map(|met| {
            let position = met.position;
            [met.displacement1, met.displacement2, position.lat(), position.lon()]
        });
        Ok(columns.unwrap_or([T::of(f64::NAN); 4]))
    };
    solve_by((one, other), met, find, |source, mut sink, tally| {
        for index in 0..source.len() {
            sink.push(tally.note(index, find(source.at(index)), [T::of(f64::NAN); 4]));
        }
    })
}
