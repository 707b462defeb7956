use terrella::batch;
use terrella::geodesic::{Area, GreatCircle, Karney, PolygonArea};
use terrella::route::{Arc, Corridor, Crossing, EdgeCrossing, EdgeDistance, Fence, InvalidArc, Planar, Side, Turn};
use terrella::{Ellipsoid, LatLon};

use crate::batch::{function, into, lent, places};
use crate::{Arguments, Bits, Hash, POINTS, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let Ok(earth) = Karney::new(Ellipsoid::<T>::WGS84) else {
        return;
    };
    fences(visitor, &earth);
    planes::<T, V>(visitor);
    arcs(visitor, &earth);
    edges::<T, V>(visitor);
}

/// A place, and a ring about another: within a degree or so, or anywhere.
fn ring<T: Scalar>(arguments: &mut Arguments) -> (LatLon<T>, [LatLon<T>; 4]) {
    if arguments.below(2) == 0 {
        return (arguments.place(), [(); 4].map(|()| arguments.place()));
    }
    let [a, place] = arguments.short();
    let near = |lat: i8, lon: i8| {
        let degrees = |steps: i8| T::of(0.25) * T::of(f64::from(steps));
        LatLon::new(a.lat() * T::of(0.9) + degrees(lat), a.lon() + degrees(lon)).unwrap_or(a)
    };
    (place, [near(-1, -1), near(-1, 1), near(1, 1), near(1, -1)])
}

fn fences<T: Scalar, V: Visitor>(visitor: &mut V, earth: &Karney<T>) {
    visitor.function::<T, _, _>("Fence::new", ring::<T>, |(place, ring)| {
        let rings = [ring.as_slice()];
        let fence = Fence::new(earth, &rings);
        let [a, b, ..] = ring;
        let spans = (
            EdgeCrossing::<T>::northing(earth, place),
            EdgeCrossing::<T>::northings(earth, a, b),
            EdgeCrossing::<T>::crossing(earth, place, a, b),
        );
        (
            Fence::side(&fence, place),
            (Fence::contains(&fence, a), Fence::distance(&fence, place)),
            spans,
            EdgeCrossing::<T>::ends(earth, [[a, b], [b, a]].into_iter(), false),
        )
    });
    let Ok(sphere) = GreatCircle::new(Ellipsoid::<T>::WGS84.mean_radius()) else {
        return;
    };
    visitor.function::<T, _, _>("Fence::to_the_left", ring::<T>, |(place, ring)| {
        let rings = [ring.as_slice()];
        let fence = Fence::to_the_left(&sphere, &rings);
        let [a, b, ..] = ring;
        (
            Fence::side(&fence, place),
            Fence::distance(&fence, place),
            EdgeDistance::<T>::edge_distance(&sphere, place, a, b),
            EdgeDistance::<T>::edge_at_least(&sphere, place, a, b),
        )
    });
    let draw = |arguments: &mut Arguments| (ring::<T>(arguments), places::<T>(arguments));
    visitor.visit::<T, _, _>(function("batch::route::sides", ""), draw, |((_, ring), places)| {
        let rings = [ring.as_slice()];
        let mut sides = [Side::Outside; POINTS];
        let outcome = batch::route::sides(&Fence::new(earth, &rings), lent(&places), &mut sides);
        (sides, outcome)
    });
    visitor.visit::<T, _, _>(function("batch::route::distances", ""), draw, |((_, ring), places)| {
        let rings = [ring.as_slice()];
        let fence = Fence::new(&sphere, &rings);
        into(|[distances]| batch::route::distances(&fence, lent(&places), distances))
    });
}

fn planes<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| {
        let offset = LatLon::new(arguments.unit::<T>() * T::of(0.04), arguments.unit::<T>() * T::of(0.04));
        (arguments.short::<T>(), offset)
    };
    visitor.function::<T, _, _>("Planar::about", draw, |([origin, place], offset)| {
        let plane = Planar::about(Ellipsoid::WGS84, origin).ok()?;
        Some((
            Planar::origin(&plane),
            Planar::place(&plane, place),
            offset.map(|offset| Planar::offset(&plane, offset)),
        ))
    });
    let draw = |arguments: &mut Arguments| [(); 5].map(|()| arguments.units::<T, 2>().map(|part| part * T::of(5e3)));
    let Ok(plane) = LatLon::new(T::of(47.0), T::of(8.0)).map(|home| Planar::about(Ellipsoid::WGS84, home)) else {
        return;
    };
    let Ok(plane) = plane else { return };
    visitor.function::<T, _, _>("Fence, plane", draw, |[place, a, b, c, d]| {
        let ring = [a, b, c, d];
        let rings = [ring.as_slice()];
        let fence = Fence::new(&plane, &rings);
        (Fence::side(&fence, place), Fence::distance(&fence, place))
    });
}

fn arcs<T: Scalar, V: Visitor>(visitor: &mut V, earth: &Karney<T>) {
    let draw = |arguments: &mut Arguments| (arguments.pair::<T>(), arguments.units::<T, 4>());
    visitor.function::<T, _, _>("Arc::new", draw, |([centre, place], [radius, azimuth, sweep, part])| {
        let arc = Arc::new(
            earth,
            centre,
            radius * T::of(5e6),
            azimuth * T::of(180.0),
            sweep * T::of(361.0),
        )?;
        let length = Arc::length(&arc);
        let corners =
            Arc::corners(&arc, Arc::radius(&arc) * T::of(0.05)).map(|mut corners| [corners.next(), corners.last()]);
        Ok::<_, InvalidArc<T>>((
            (
                Arc::centre(&arc),
                Arc::sweep(&arc),
                length,
                Arc::at(&arc, length * part),
            ),
            (Arc::start(&arc), Arc::end(&arc), corners),
            (
                Arc::abeam(&arc, place),
                Arc::distance(&arc, place),
                Arc::cross_track(&arc, place),
            ),
        ))
    });
    visitor.function::<T, _, _>("Arc::between", draw, |([centre, place], [radius, lat, lon, _])| {
        let other = LatLon::new(lat * T::of(90.0), lon * T::of(180.0)).unwrap_or(place);
        let turn = if radius < T::ZERO { Turn::Left } else { Turn::Right };
        let radius = T::abs(radius) * T::of(1e6);
        let sweep = Arc::between(earth, centre, radius, place, other, turn).map(|arc| Arc::sweep(&arc));
        (
            sweep,
            Arc::circle(earth, centre, radius).map(|circle| Arc::end(&circle)),
        )
    });
    let draw = |arguments: &mut Arguments| ([arguments.short::<T>(), arguments.short()], arguments.unit::<T>());
    visitor.function::<T, _, _>("Corridor::new", draw, |([[a, b], [c, d]], width)| {
        let line = [a, b, c, d];
        let width = width * T::of(1e4);
        let corridor = Corridor::new(earth, &line, width, width * T::of(0.1))?;
        let leg = Iterator::last(Corridor::leg(&corridor, 0));
        let mut outline = Corridor::outline(&corridor);
        Ok::<_, InvalidArc<T>>((leg, [(); 24].map(|()| outline.next())))
    });
}

/// Polygons by edges, as rings and as lines.
fn edges<T: Scalar, V: Visitor>(visitor: &mut V) {
    let Ok(area) = Area::new(Ellipsoid::<T>::WGS84) else {
        return;
    };
    let draw = |arguments: &mut Arguments| (arguments.pair::<T>(), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("PolygonArea::add_edge", draw, |([from, to], [azimuth, length])| {
        let mut polygon = Area::polygon(&area);
        PolygonArea::add(&mut polygon, from);
        let end = PolygonArea::add_edge(&mut polygon, azimuth * T::of(180.0), length * T::of(5e7));
        PolygonArea::add(&mut polygon, to);
        let length = PolygonArea::length(&polygon);
        PolygonArea::close(&mut polygon);
        let sides = [PolygonArea::left_area(&polygon), PolygonArea::right_area(&polygon)];
        (end, length, PolygonArea::clockwise_area(&polygon), sides)
    });
}

impl Bits for Side {
    fn add_to(&self, hash: &mut Hash) {
        (*self as u8).add_to(hash);
    }
}

impl Bits for Crossing {
    fn add_to(&self, hash: &mut Hash) {
        (*self as u8).add_to(hash);
    }
}

impl<T: Scalar> Bits for InvalidArc<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Radius(value) | Self::Azimuth(value) | Self::Sweep(value) | Self::Tolerance(value) => {
                value.add_to(hash)
            }
            _ => (),
        }
    }
}
