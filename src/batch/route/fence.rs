use crate::batch::InvalidBatch;
use crate::route::{EdgeCrossing, EdgeDistance, Fence, Side};
use crate::simd::Tally;
use crate::{InvalidLatLon, LatLon, Real};

/// Finds the sides of a fence that geodetic latitudes and longitudes in degrees are on, those of
/// [`Fence::side`]. A place that is refused is [`Side::Outside`].
///
/// Edges are only solved for places whose latitudes are near theirs and whose meridians they cross: most
/// places cost two comparisons an edge, those north and south of the fence two at all.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses a place.
///
/// ```
/// use terrella::geodesic::Karney;
/// use terrella::route::{Fence, Side};
/// use terrella::{Ellipsoid, LatLon, batch::route};
/// let earth = Karney::new(Ellipsoid::WGS84)?;
/// let ring = [LatLon::<f64>::new(0.0, 0.0)?, LatLon::new(0.0, 10.0)?, LatLon::new(10.0, 0.0)?];
/// let rings = [ring.as_slice()];
/// let mut sides = [Side::Edge; 2];
/// route::sides(&Fence::new(&earth, &rings), [&[1.0, 9.0], &[1.0, 9.0]], &mut sides)?;
/// assert_eq!(sides, [Side::Inside, Side::Outside]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "contains")]
pub fn sides<T: Real, G: EdgeCrossing<T, Place = LatLon<T>>>(
    fence: &Fence<'_, G, T>,
    places: [&[T]; 2],
    sides: &mut [Side],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    each(places, sides, Side::Outside, |place| fence.side(place))
}

/// Measures the distances in metres of places to the nearest edge of a fence, negative inside: those of
/// [`Fence::distance`].
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths, or [`LatLon::new`] refuses a place: its distance is NaN.
pub fn distances<T: Real, G: EdgeDistance<T, Place = LatLon<T>>>(
    fence: &Fence<'_, G, T>,
    places: [&[T]; 2],
    distances: &mut [T],
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    each(places, distances, T::of(f64::NAN), |place| fence.distance(place))
}

fn each<T: Real, V: Copy>(
    places: [&[T]; 2],
    results: &mut [V],
    nothing: V,
    find: impl Fn(LatLon<T>) -> V,
) -> Result<(), InvalidBatch<InvalidLatLon<T>>> {
    let [lat, lon] = places;
    let first = lat.len();
    if let Some(other) = [lon.len(), results.len()].into_iter().find(|&other| other != first) {
        return Err(InvalidBatch::Lengths { first, other });
    }
    let mut tally = Tally::new();
    for (index, ((&lat, &lon), result)) in lat.iter().zip(lon).zip(results).enumerate() {
        *result = tally.note(index, LatLon::new(lat, lon).map(&find), nothing);
    }
    match tally.refused() {
        Some((count, first, why)) => Err(InvalidBatch::Elements { count, first, why }),
        None => Ok(()),
    }
}
