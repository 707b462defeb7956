//! Areas of rings.

use terrella::batch::{self, InvalidBatch, area::InvalidRing};
use terrella::geodesic::{Area, PlanarArea};
use terrella::scene::AnyArea;
use terrella::{Ellipsoid, LatLon};

use super::{judge, place};
use testkit::bytes::Bytes;
use testkit::scalar::Scalar;

/// Offsets and corners of rings of a few places again and again; some rings are beyond the last corner, or backwards.
pub(super) fn rings<T: Scalar>(bytes: &mut Bytes<'_>) {
    let mut offsets = vec![u32::from(bytes.byte() % 4 == 3)];
    for _ in 0..bytes.byte() % 12 {
        let size = bytes.byte();
        let last = offsets[offsets.len() - 1];
        let next = match size / 32 {
            7 => last.wrapping_sub(u32::from(size % 32)),
            6 => last.wrapping_add(8 * u32::from(size % 32)),
            _ => last.wrapping_add(u32::from(size % 8)),
        };
        offsets.push(next);
    }
    let length = offsets
        .iter()
        .filter(|&&offset| offset < 4000)
        .max()
        .copied()
        .unwrap_or(0);
    let length = (length as usize).saturating_sub(usize::from(bytes.byte() % 16 == 15));
    let stride = usize::from(bytes.byte());
    let ellipsoid = bytes.ellipsoid::<T>(-1.0 / 9.0, 0.1);
    let kind = bytes.byte() % 4;
    let few = {
        let (a, b) = bytes.pair::<T>();
        let [c, d] = [a, b].map(|about| bytes.place_about(about, false));
        let [a, b, c, d] = [a, b, c, d].map(|place| [place.lat(), place.lon()]);
        [a, b, c, d, place(bytes)]
    };
    // Bad places are few.
    let corner = |i: usize| few[(i * stride + i * i) % if i % 32 == 31 { 5 } else { 4 }];
    let corners = [0, 1].map(|column| (0..length).map(|i| corner(i)[column]).collect::<Vec<T>>());
    let corners = corners.each_ref().map(|column| &column[..]);
    let ring = |i: usize| {
        let [start, end] = [offsets[i], offsets[i + 1]].map(|offset| offset as usize);
        if start > end || end > length {
            return Err(InvalidRing::Offsets { start, end });
        }
        let corners = (start..end).map(|index| {
            let [lat, lon] = corner(index);
            LatLon::new(lat, lon).map_err(|why| InvalidRing::Corner { index, why })
        });
        corners.collect::<Result<Vec<_>, _>>()
    };
    let context = format!("{kind} {ellipsoid:?}: {offsets:?} of {few:?}, {stride}");
    let count = offsets.len() - 1;
    let nan = T::of(f64::NAN);
    let mut one = [vec![T::of(super::MARK); count]];
    let area = Area::new(ellipsoid).unwrap();
    match kind {
        0 | 1 => {
            let mut both = [(); 2].map(|()| vec![T::of(super::MARK); count]);
            let [areas, perimeters] = &mut both;
            let found = batch::area::polygons(&area, &offsets, corners, areas, perimeters);
            let measured = |i| {
                let mut polygon = area.polygon();
                ring(i)?.into_iter().for_each(|corner| polygon.add(corner));
                Ok([polygon.area(), polygon.perimeter()])
            };
            judge(&context, [nan; 2], &both, measured, found);
        }
        2 => {
            let plane = PlanarArea::new(Ellipsoid::WGS84).unwrap();
            let found = batch::area::fields(&plane, &offsets, corners, &mut one[0]);
            let measured = |i| Ok([AnyArea::Plane(plane).area(ring(i)?)]);
            judge(&context, [nan], &one, measured, found);
        }
        _ => {
            let area = AnyArea::Ellipsoid(area);
            let found = batch::scene::areas(&area, &offsets, corners, &mut one[0]);
            judge(&context, [nan], &one, |i| Ok([area.area(ring(i)?)]), found);
        }
    }
    let mut long = vec![T::of(super::MARK); count + 1];
    let unequal = batch::scene::areas(&AnyArea::Ellipsoid(area), &offsets, corners, &mut long);
    let lengths = InvalidBatch::Lengths {
        first: count,
        other: count + 1,
    };
    assert_eq!(unequal, Err(lengths));
}
