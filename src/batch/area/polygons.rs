//! Rings whose edges are geodesics. The edges of all rings go through lanes together, so that small rings are
//! as cheap as large ones; then each ring is summed in its order.

use super::{InvalidRing, every, rings_of};
use crate::batch::InvalidBatch;
use crate::batch::position::Pairs;
use crate::geodesic::{Area, Edge, Edges, PolygonArea};
use crate::simd::{BLOCK, Door, Element, Tally, lanes};
use crate::{InvalidLatLon, LatLon, Real};

/// With fewer corners the lanes do not pay.
const FEW: usize = 8;

type Ends<T> = ([T; 2], [T; 2]);

impl<T: Real> Element<Ends<T>> for Edges<T> {
    type Output = [T; 4];
    type Error = InvalidLatLon<T>;

    #[inline(always)]
    fn keeps(&self, ends: Ends<T>) -> bool {
        Pairs.keeps(ends)
    }

    #[inline(always)]
    fn mend(&self, ends: Ends<T>) -> Ends<T> {
        Pairs.mend(ends)
    }

    #[inline(always)]
    fn fast(&self, ([lat1, lon1], [lat2, lon2]): Ends<T>) -> ([T; 4], bool) {
        let (edge, found) = self.edge(LatLon::within(lat1, lon1), LatLon::within(lat2, lon2));
        (edge.row(), found)
    }

    fn one(&self, ([lat1, lon1], [lat2, lon2]): Ends<T>) -> Result<[T; 4], InvalidLatLon<T>> {
        let (from, to) = (LatLon::new(lat1, lon1)?, LatLon::new(lat2, lon2)?);
        Ok(self.any_edge(from, to).row())
    }
}

/// Edges on their way through lanes.
struct Queue<T, I> {
    solver: Edges<T>,
    ends: I,
    columns: [[T; BLOCK]; 4],
    rows: [[T; BLOCK]; 4],
    count: usize,
    next: usize,
}

impl<T: Real, I: Iterator<Item = Ends<T>>> Queue<T, I> {
    fn new(area: &Area<T>, ends: I) -> Self {
        Self {
            solver: Edges::new(area),
            ends,
            columns: [[T::ZERO; BLOCK]; 4],
            rows: [[T::ZERO; BLOCK]; 4],
            count: 0,
            next: 0,
        }
    }

    /// The next edge; NaN if a corner was refused.
    fn next(&mut self) -> Edge<T> {
        if self.next == self.count {
            self.fill();
        }
        let row = self.rows.each_ref().map(|column| column.get(self.next).copied());
        self.next += 1;
        Edge::of(row.map(|value| value.unwrap_or(T::ZERO)))
    }

    #[inline(never)]
    fn fill(&mut self) {
        let [lat1, lon1, lat2, lon2] = &mut self.columns;
        let from = lat1.iter_mut().zip(lon1);
        let slots = from.zip(lat2.iter_mut().zip(lon2));
        self.count = 0;
        for (((lat1, lon1), (lat2, lon2)), ends) in slots.zip(&mut self.ends) {
            ([*lat1, *lon1], [*lat2, *lon2]) = ends;
            self.count += 1;
        }
        self.next = 0;
        let count = self.count;
        let [lat1, lon1, lat2, lon2] = self
            .columns
            .each_ref()
            .map(|column| column.get(..count).unwrap_or_default());
        let rows = self
            .rows
            .each_mut()
            .map(|column| column.get_mut(..count).unwrap_or_default());
        lanes(self.solver, ([lat1, lon1], [lat2, lon2]), rows, &mut Tally::new());
    }
}

/// Sums all rings, and takes what is asked for of each.
fn sums<T: Real, O: Copy + TryInto<usize>, const N: usize>(
    area: &Area<T>,
    offsets: &[O],
    corners: [&[T]; 2],
    results: [&mut [T]; N],
    of: impl Fn(&PolygonArea<'_, T>) -> [T; N],
) -> Result<(), InvalidBatch<InvalidRing<T>>> {
    if !cfg!(lanes) || corners[0].len() < FEW {
        return every(offsets, corners, results, |ring| {
            let mut polygon = area.polygon();
            ring.each(|corner| polygon.add(corner))?;
            Ok(of(&polygon))
        });
    }
    let rings = rings_of(offsets, corners).flatten();
    let mut queue = Queue::new(area, rings.flat_map(|ring| ring.edges()));
    every(offsets, corners, results, |ring| {
        let mut polygon = area.polygon();
        for _ in 0..ring.corners[0].len() {
            polygon.join(queue.next());
        }
        let sums = of(&polygon);
        if sums.iter().any(|sum| !sum.is_finite()) {
            ring.each(|_| ())?;
        }
        Ok(sums)
    })
}

/// Measures rings whose edges are geodesics: areas in m² and perimeters in metres, with the bits of
/// [`PolygonArea`](crate::geodesic::PolygonArea).
///
/// On ellipsoids about as flat as the Earth's the edges of all rings go through lanes together, whatever the
/// rings' sizes; on others, and between nearly antipodal corners, they are solved one by one.
///
/// # Errors
/// [`InvalidBatch`] if slices have unequal lengths (there is an area and a perimeter for each ring), or if a
/// ring is refused: `first` is the ring's index, and its area and perimeter are NaN.
///
/// ```
/// use terrella::{Ellipsoid, batch::area, geodesic::Area};
/// let earth = Area::new(Ellipsoid::<f64>::WGS84)?;
/// let corners: [&[f64]; 2] = [&[0.0, 0.0, 90.0, 0.0, 0.0, -90.0], &[0.0, 90.0, 0.0, 0.0, 90.0, 0.0]];
/// let (mut areas, mut perimeters) = ([0.0; 2], [0.0; 2]);
/// area::polygons(&earth, &[0, 3, 6], corners, &mut areas, &mut perimeters)?;
/// assert_eq!(areas.map(|area| (area * 1e-9).round()), [63_758.0, -63_758.0]);
/// assert_eq!(perimeters.map(|length| (length * 1e-3).round()), [30_023.0; 2]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn polygons<T: Real, O: Copy + TryInto<usize>>(
    area: &Area<T>,
    offsets: &[O],
    corners: [&[T]; 2],
    areas: &mut [T],
    perimeters: &mut [T],
) -> Result<(), InvalidBatch<InvalidRing<T>>> {
    let both = |polygon: &PolygonArea<'_, T>| polygon.area_and_perimeter();
    sums(area, offsets, corners, [areas, perimeters], both)
}

/// The areas of [`polygons`] alone.
pub(in crate::batch) fn polygon_areas<T: Real, O: Copy + TryInto<usize>>(
    area: &Area<T>,
    offsets: &[O],
    corners: [&[T]; 2],
    areas: &mut [T],
) -> Result<(), InvalidBatch<InvalidRing<T>>> {
    sums(area, offsets, corners, [areas], |polygon| [polygon.area()])
}
