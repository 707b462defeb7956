//! Coverings, boxes of tiles and rings: what holds for any region and any tile.

use terrella::cube::{CubeMap, Projection};
use terrella::geodesic::Andoyer;
use terrella::terrain::{Cap, Covering, LatLonBox, Region, Relation, Tile};
use terrella::{Ecef, Ellipsoid, LatLon, Ray, Shift};

use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::Scalar;

properties! { box_has_its_places cap_has_its_centre bounds_hold rings rays }

fn map<T: Scalar>(bytes: &mut Bytes<'_>) -> CubeMap<T, Projection> {
    let projection = bytes.choice(Projection::ALL);
    CubeMap::new(Ellipsoid::WGS84, bytes.choice(Shift::ALL), projection).unwrap()
}

/// A place, and the tile that has it by all that is known: not one of the published pair of COBE, which disagree.
fn placed<T: Scalar>(map: &CubeMap<T, Projection>, place: LatLon<T>, level: u8) -> Option<Tile> {
    let tile = Tile::containing(map.project(place), level).unwrap();
    (map.projection() != Projection::Cobe).then_some(tile)
}

/// Any box or none; a tile with a place of the box is not apart from it, and so none above it is. Inside, it is not
/// apart. The covering ends.
fn box_has_its_places<T: Scalar>(bytes: &mut Bytes<'_>) {
    let map = map::<T>(bytes);
    let [south, west, north, east] = [(); 4].map(|()| bytes.anything::<T>());
    let (place, other) = (bytes.place::<T>(), bytes.place::<T>());
    let region = LatLonBox::new(south, west, north, east).unwrap_or_else(|_| {
        let ordered = place.lat() <= other.lat();
        let (low, high) = if ordered { (place, other) } else { (other, place) };
        LatLonBox::new(low.lat(), place.lon(), high.lat(), other.lon()).unwrap()
    });
    let corner = LatLon::new(region.south(), region.west()).unwrap();
    assert!(region.contains(corner), "{region:?}");
    let level = bytes.byte() % 21;
    for place in [corner, bytes.place()] {
        if let Some(tile) = placed(&map, place, level).filter(|_| region.contains(place)) {
            for above in (0..=level).map(|level| tile.ancestor(level).unwrap()) {
                let relation = region.relation(&map, above);
                assert!(
                    relation != Relation::Apart,
                    "{} {:?} {region:?} {above}",
                    T::NAME,
                    map.projection()
                );
            }
        }
    }
    assert!(Covering::new(map, region, 2).unwrap().count() <= 96);
}

/// Any radius or none; the tile of the centre meets the cap at every level; a wider cap has as many tiles.
fn cap_has_its_centre<T: Scalar>(bytes: &mut Bytes<'_>) {
    let (map, centre, radius) = (map::<T>(bytes), bytes.place::<T>(), bytes.anything::<T>());
    let method = Andoyer::new(Ellipsoid::<T>::WGS84).unwrap();
    let cap = Cap::new(method, centre, radius);
    assert_eq!(cap.is_ok(), radius >= T::ZERO);
    let cap = cap.unwrap_or(Cap::new(method, centre, T::of(1e7) * T::of(bytes.even().abs())).unwrap());
    if let Some(tile) = placed(&map, centre, bytes.byte() % 31) {
        assert!(
            cap.relation(&map, tile) != Relation::Apart,
            "{} {cap:?} {tile}",
            T::NAME
        );
    }
    let count = |region| Covering::new(map, region, 1).unwrap().count();
    let wider = Cap::new(method, centre, cap.radius() + cap.radius()).unwrap();
    assert!(count(wider) >= count(cap), "{} {cap:?}", T::NAME);
}

/// A place of a tile is in the tile's box; what is apart from the box is apart from the tile.
fn bounds_hold<T: Scalar>(bytes: &mut Bytes<'_>) {
    let map = map::<T>(bytes);
    let level = bytes.byte() % if T::CLAIM == 0 { 31 } else { 16 };
    let tile = Tile::containing(map.project(bytes.place::<T>()), level).unwrap();
    let bounds = LatLonBox::of_tile(&map, tile);
    let place = [(); 2].map(|()| bytes.within::<T>(1.0).abs());
    let there = map.unproject(tile.point(place).unwrap());
    assert!(
        bounds.contains(there),
        "{} {:?} {tile} {bounds:?} {there:?}",
        T::NAME,
        map.projection()
    );
    let area: f64 = tile.area(&map).into();
    assert!(area > 0.0 && area < 1.8e14, "{} {tile} {area}", T::NAME);
}

/// Who is in a ring has this tile in its ring.
fn rings<T: Scalar>(bytes: &mut Bytes<'_>) {
    let level = bytes.byte() % 31;
    let tile = Tile::containing(map::<T>(bytes).project(bytes.place::<T>()), level).unwrap();
    let steps = u32::from(bytes.byte() % 6);
    let Ok(ring) = tile.ring(steps) else {
        return assert!(steps > 1 << level);
    };
    let count = ring.clone().count() as u32;
    assert!(
        count <= (8 * steps).max(1) && (count > 0 || level < 3),
        "{tile} {steps} {count}"
    );
    let mut ring = ring;
    let beside = ring.nth(usize::from(bytes.byte()) % count.max(1) as usize);
    if let Some(other) = beside {
        assert!(
            other.ring(steps).unwrap().any(|back| back == tile),
            "{tile} {other} {steps}"
        );
        let above = tile.common_ancestor(other);
        assert!(above.is_none_or(|above| above.contains(tile) && above.contains(other)));
    }
}

/// Any ray and any height have an answer, and no distance is negative or no number.
fn rays<T: Scalar>(bytes: &mut Bytes<'_>) {
    let [start, other] = [(); 2].map(|()| {
        let [x, y, z] = [(); 3].map(|()| {
            if bytes.flag() {
                bytes.within::<T>(1e8)
            } else {
                bytes.finite()
            }
        });
        Ecef::new(x, y, z).unwrap_or(Ecef::new(T::of(7e6), T::ZERO, T::ZERO).unwrap())
    });
    let height = bytes.anything::<T>();
    let earth = Ellipsoid::<T>::WGS84;
    let _ = earth.clearance(start, other);
    if let Ok(ray) = Ray::through(start, other) {
        for height in [height, T::ZERO] {
            if let Some(distance) = earth.meet(&ray, height).distance() {
                assert!(
                    distance.partial_cmp(&T::ZERO) != Some(core::cmp::Ordering::Less) || height != T::ZERO,
                    "{} {ray:?} {height:?} {distance:?}",
                    T::NAME
                );
            }
        }
    }
}
