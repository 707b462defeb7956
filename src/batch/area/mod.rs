//! Measures the areas of many rings, by [`Area`](crate::geodesic::Area) or [`PlanarArea`].
//!
//! Rings are given as in GeoArrow: the latitudes and longitudes of all corners, ring after ring, and
//! `offsets`, of which ring i has its corners from the i-th to before the next. There is one offset more than
//! there are rings. Offsets are whole numbers of any type, for instance `i32`. A last corner that repeats the
//! first changes nothing.

use core::fmt;

mod polygons;

pub(super) use polygons::polygon_areas;
pub use polygons::polygons;

use super::InvalidBatch;
use super::position::Places;
use crate::geodesic::{PlanarArea, Tangent};
use crate::simd::{Behind, CHUNK, Kernel, Sink, Tally, head, lanes};
use crate::{InvalidLatLon, LatLon, Real};

/// Why a ring was refused.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidRing<T> {
    /// [`LatLon::new`] refuses a corner.
    Corner {
        /// The index of the first such corner in the slices.
        index: usize,
        /// Why it was refused.
        why: InvalidLatLon<T>,
    },
    /// The ring ends before it starts, or after the last corner.
    Offsets {
        /// The offset of its first corner; `usize::MAX` for a negative one.
        start: usize,
        /// The offset after its last corner; `usize::MAX` for a negative one.
        end: usize,
    },
}

impl<T: fmt::Debug> fmt::Display for InvalidRing<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Corner { index, why } => write!(f, "corner {index}: {why}"),
            Self::Offsets { start, end } => write!(f, "there are no corners {start} to {end}"),
        }
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidRing<T> {}

/// The corners of a ring, and the index of the first among all.
struct Ring<'a, T> {
    start: usize,
    corners: [&'a [T]; 2],
}

impl<'a, T: Real> Ring<'a, T> {
    /// From each corner to the next, and from the last to the first.
    fn edges(self) -> impl Iterator<Item = ([T; 2], [T; 2])> + use<'a, T> {
        let [lat, lon] = self.corners;
        let next = |column: &'a [T]| column.iter().skip(1).chain(column.first());
        let from = lat.iter().zip(lon);
        let to = next(lat).zip(next(lon));
        from.zip(to)
            .map(|((&lat1, &lon1), (&lat2, &lon2))| ([lat1, lon1], [lat2, lon2]))
    }

    /// The error for a corner.
    fn refused(&self, index: usize, why: InvalidLatLon<T>) -> InvalidRing<T> {
        let index = self.start + index;
        InvalidRing::Corner { index, why }
    }

    /// Hands on the corners one by one.
    fn each(&self, mut add: impl FnMut(LatLon<T>)) -> Result<(), InvalidRing<T>> {
        let [lat, lon] = self.corners;
        for (index, (&lat, &lon)) in lat.iter().zip(lon).enumerate() {
            add(LatLon::new(lat, lon).map_err(|why| self.refused(index, why))?);
        }
        Ok(())
    }
}

/// The rings, one after the other.
fn rings_of<'a, T: Real, O: Copy + TryInto<usize>>(
    offsets: &'a [O],
    [lat, lon]: [&'a [T]; 2],
) -> impl Iterator<Item = Result<Ring<'a, T>, InvalidRing<T>>> {
    let index = |&offset: &O| offset.try_into().unwrap_or(usize::MAX);
    let (starts, ends) = (offsets.iter().map(index), offsets.iter().skip(1).map(index));
    starts
        .zip(ends)
        .map(move |(start, end)| match (lat.get(start..end), lon.get(start..end)) {
            (Some(lat), Some(lon)) => Ok(Ring {
                start,
                corners: [lat, lon],
            }),
            _ => Err(InvalidRing::Offsets { start, end }),
        })
}

/// Measures all rings.
fn every<T: Real, O: Copy + TryInto<usize>, const N: usize>(
    offsets: &[O],
    corners: [&[T]; 2],
    mut results: [&mut [T]; N],
    mut measure: impl FnMut(Ring<'_, T>) -> Result<[T; N], InvalidRing<T>>,
) -> Result<(), InvalidBatch<InvalidRing<T>>> {
    let [lat, lon] = corners;
    let rings = offsets.len().saturating_sub(1);
    let (first, other) = match results.other_length(rings) {
        Some(other) => (rings, other),
        None => (lat.len(), lon.len()),
    };
    if first != other {
        return Err(InvalidBatch::Lengths { first, other });
    }
    let mut tally = Tally::new();
    for (index, ring) in rings_of(offsets, corners).enumerate() {
        let result = ring.and_then(&mut measure);
        results.push(tally.note(index, result, [T::of(f64::NAN); N]));
    }
    match tally.refused() {
        Some((count, first, why)) => Err(InvalidBatch::Elements { count, first, why }),
        None => Ok(()),
    }
}

/// With fewer corners the lanes do not pay.
const FEW: usize = 16;

/// From latitudes and longitudes to east and north in the plane at a ring's first corner.
#[derive(Clone, Copy)]
struct ToPlane<T> {
    first: LatLon<T>,
    tangent: Tangent<T>,
}

impl<T: Real> Kernel<[T; 2]> for ToPlane<T> {
    type Output = [T; 2];

    #[inline(always)]
    fn apply(&self, [lat, lon]: [T; 2]) -> [T; 2] {
        self.tangent.seen(self.first, LatLon::within(lat, lon))
    }
}

/// Measures fields of up to some hundred kilometres: areas in m², with the bits of
/// [`PlanarPolygon`](crate::geodesic::PlanarPolygon).
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths (there is an area for each ring), or if a ring is refused:
/// `first` is the ring's index, and its area is NaN.
///
/// ```
/// use terrella::{Ellipsoid, LatLon, batch::area, geodesic::PlanarArea};
/// let about = PlanarArea::local(Ellipsoid::WGS84, LatLon::new(47.397_742_f32, 8.545_594)?)?;
/// let (north, east) = ([0.0, 0.0, 0.0005, 0.0006], [0.0, 0.0008, 0.0009, 0.0]);
/// let mut areas = [0.0];
/// area::fields(&about, &[0, 4], [&north, &east], &mut areas)?;
/// assert!((areas[0] - 3944.617).abs() < 0.004);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn fields<T: Real, O: Copy + TryInto<usize>>(
    area: &PlanarArea<T>,
    offsets: &[O],
    corners: [&[T]; 2],
    areas: &mut [T],
) -> Result<(), InvalidBatch<InvalidRing<T>>> {
    every(offsets, corners, [areas], |ring| {
        let mut polygon = area.polygon();
        let [&[lat, ref north @ ..], &[lon, ref east @ ..]] = ring.corners else {
            return Ok([polygon.area()]);
        };
        if !cfg!(lanes) || north.len() < FEW {
            ring.each(|corner| polygon.add(corner))?;
            return Ok([polygon.area()]);
        }
        let first = LatLon::new(lat, lon).map_err(|why| ring.refused(0, why))?;
        let tangent = area.tangent(first);
        polygon.add(first);
        let mut rest = [north, east];
        let mut plane = [[T::ZERO; CHUNK]; 2];
        let mut tally = Tally::new();
        while let here @ 1.. = rest[0].len().min(CHUNK) {
            let columns = plane
                .each_mut()
                .map(|column| column.get_mut(..here).unwrap_or_default());
            lanes(
                Behind(Places, ToPlane { first, tangent }),
                head(&mut rest, here),
                columns,
                &mut tally,
            );
            let [east, north] = &plane;
            for (&east, &north) in east.iter().zip(north).take(here) {
                polygon.reach(&tangent, [east, north]);
            }
        }
        match tally.refused() {
            Some((_, index, why)) => Err(ring.refused(1 + index, why)),
            None => Ok([polygon.area()]),
        }
    })
}
