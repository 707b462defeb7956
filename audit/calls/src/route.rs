use terrella::Ellipsoid;
use terrella::route::heading::UndefinedMean;
use terrella::route::{self, Rhumb, RhumbLine};
use terrella::{batch, geodesic::GeodesicError};

use crate::batch::{columns, function, into, lent, places};
use crate::{Arguments, Bits, Hash, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    rhumb_lines::<T, V>(visitor);
    headings::<T, V>(visitor);
}

fn rhumb_lines<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>("Rhumb::new", Arguments::ellipsoid::<T>, |ellipsoid| {
        Rhumb::new(ellipsoid).map(|rhumb| Rhumb::ellipsoid(&rhumb).f())
    });
    let Ok(rhumb) = Rhumb::new(Ellipsoid::<T>::WGS84) else {
        return;
    };
    visitor.function::<T, _, _>("Rhumb::inverse", Arguments::pair::<T>, |[from, to]| {
        let line = Rhumb::inverse(&rhumb, from, to);
        [line.distance, line.azimuth, line.area]
    });
    visitor.function::<T, _, _>("Rhumb::distance", Arguments::pair::<T>, |[from, to]| {
        Rhumb::distance(&rhumb, from, to)
    });
    let way = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("Rhumb::direct", way, |(from, [azimuth, distance])| {
        let end = Rhumb::direct(&rhumb, from, azimuth * T::of(180.0), distance * T::of(2e7));
        end.map(|end| (end.position, [end.longitude, end.area]))
    });
    visitor.function::<T, _, _>("RhumbLine::at", way, |(from, [azimuth, distance])| {
        let line = Rhumb::line(&rhumb, from, azimuth * T::of(180.0))?;
        let end = RhumbLine::at(&line, distance * T::of(1e7))?;
        Ok::<_, GeodesicError<T>>((RhumbLine::azimuth(&line), end.position, end.longitude))
    });
    visitor.function::<T, _, _>("Rhumb::line_between", Arguments::pair::<T>, |[from, to]| {
        let line = Rhumb::line_between(&rhumb, from, to);
        let length = RhumbLine::length(&line);
        let end = RhumbLine::at(&line, length * T::of(0.5)).map(|end| end.position);
        (RhumbLine::start(&line), length, end)
    });
    let draw = |arguments: &mut Arguments| (places::<T>(arguments), places::<T>(arguments));
    visitor.visit::<T, _, _>(function("batch::route::rhumb_inverse", ""), draw, |(from, to)| {
        into(|lines| batch::route::rhumb_inverse(&rhumb, lent(&from), lent(&to), lines))
    });
    visitor.visit::<T, _, _>(function("batch::route::rhumb_area", ""), draw, |(from, to)| {
        into(|[areas]| batch::route::rhumb_area(&rhumb, lent(&from), lent(&to), areas))
    });
    let draw = |arguments: &mut Arguments| {
        (
            places::<T>(arguments),
            columns::<T, 2>(arguments, [T::of(180.0), T::of(2e7)]),
        )
    };
    visitor.visit::<T, _, _>(
        function("batch::route::rhumb_direct", ""),
        draw,
        |(from, [azimuth, distance])| {
            into(|ends| batch::route::rhumb_direct(&rhumb, lent(&from), &azimuth, &distance, ends))
        },
    );
}

fn headings<T: Scalar, V: Visitor>(visitor: &mut V) {
    let two = |arguments: &mut Arguments| arguments.units::<T, 2>().map(|unit| unit * T::of(720.0));
    visitor.function::<T, _, _>("route::heading::difference", two, |[from, to]| {
        let wrapped = [route::heading::to_circle(from), route::heading::to_half_circles(from)];
        (wrapped, route::heading::difference(from, to))
    });
    visitor.function::<T, _, _>("route::heading::mean", two, |headings| route::heading::mean(&headings));
}

impl<T: Scalar> Bits for UndefinedMean<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Empty => None,
            Self::Heading { index, heading } => Some((Some(*index as u64), Some(*heading))),
            Self::Balanced => Some((None, None)),
        }
        .add_to(hash);
    }
}
use terrella::batch;
use terrella::geodesic::{GreatCircle, Karney};
use terrella::route::{Closest, Legs, OnPath, Reach, TangentPlane, Track};
use terrella::{Ellipsoid, LatLon};

use crate::batch::{function, into, lent, places};
use crate::{Arguments, Bits, Function, Hash, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    legs::<T, V>(visitor);
}

impl Bits for Reach {
    fn add_to(&self, hash: &mut Hash) {
        hash.add(*self as u64);
    }
}

impl<T: Scalar> Bits for Closest<T> {
    fn add_to(&self, hash: &mut Hash) {
        ((self.distance, self.position), (self.along, self.reach)).add_to(hash);
    }
}

impl<T: Scalar> Bits for Track<T> {
    fn add_to(&self, hash: &mut Hash) {
        [self.across, self.along].add_to(hash);
    }
}

impl<T: Scalar> Bits for OnPath<T> {
    fn add_to(&self, hash: &mut Hash) {
        (self.leg, self.closest).add_to(hash);
    }
}

/// A place anywhere, and a leg.
fn place_and_leg<T: Scalar>(arguments: &mut Arguments) -> (LatLon<T>, [LatLon<T>; 2]) {
    let leg = match arguments.below(4) {
        0 => arguments.short(),
        1 => arguments.antipodal(),
        _ => arguments.pair(),
    };
    (arguments.place(), leg)
}

fn legs<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::<T>::WGS84;
    let draw = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), arguments.place::<T>());
    visitor.function::<T, _, _>("TangentPlane::new", draw, |(ellipsoid, origin)| {
        let local = TangentPlane::local(ellipsoid, origin).map(drop);
        (TangentPlane::new(ellipsoid).map(drop), local)
    });
    if let (Ok(karney), Ok(sphere), Ok(plane)) = (
        Karney::new(earth),
        GreatCircle::new(earth.mean_radius()),
        TangentPlane::new(earth),
    ) {
        on_surface(visitor, &karney, "karney", place_and_leg::<T>);
        on_surface(visitor, &sphere, "great-circle", place_and_leg::<T>);
        on_surface(visitor, &plane, "tangent-plane", |arguments| {
            let [place, start] = arguments.short::<T>();
            (place, [start, arguments.place()])
        });
    }
}

/// What a surface with legs does.
fn on_surface<T: Scalar, S: Legs<T>, V: Visitor>(
    visitor: &mut V,
    surface: &S,
    name: &'static str,
    draw: impl Fn(&mut Arguments) -> (LatLon<T>, [LatLon<T>; 2]) + Copy,
) {
    let of = |what| Function::of(what, name);
    visitor.visit::<T, _, _>(of("Legs::closest"), draw, |(place, [start, end])| {
        Legs::closest(surface, place, start, end)
    });
    visitor.visit::<T, _, _>(of("Legs::track"), draw, |(place, [start, end])| {
        Legs::track(surface, place, start, end)
    });
    visitor.visit::<T, _, _>(of("Legs::at_least"), draw, |(place, [start, end])| {
        Legs::at_least(surface, place, start, end)
    });
    visitor.visit::<T, _, _>(of("Legs::closest_on"), draw, |(place, [start, end])| {
        let leg = Legs::leg(surface, start, end);
        let beside = (
            Legs::closest_on(surface, &leg, place),
            Legs::track_beside(surface, &leg, place),
        );
        (Legs::length(surface, &leg), beside)
    });
    let path = |arguments: &mut Arguments| (draw(arguments), arguments.pair::<T>());
    visitor.visit::<T, _, _>(
        of("Legs::closest_of_path").calls(64),
        path,
        |((place, [a, b]), [c, d])| Legs::closest_of_path(surface, place, [a, b, c, d]),
    );
    visitor.visit::<T, _, _>(
        of("Legs::closest_of_ring").calls(64),
        path,
        |((place, [a, b]), [c, d])| Legs::closest_of_ring(surface, place, [a, b, c, d]),
    );
    let columns = |arguments: &mut Arguments| (draw(arguments), places::<T>(arguments));
    visitor.visit::<T, _, _>(
        function("batch::route::closest", name),
        columns,
        |((ship, [start, end]), places)| {
            (
                into(|found| batch::route::closest(surface, lent(&places), start, end, found)),
                into(|found| {
                    let found = found.map(|column| column.get_mut(1..).unwrap_or_default());
                    batch::route::leg_closest(surface, ship, lent(&places), found)
                }),
            )
        },
    );
    visitor.visit::<T, _, _>(
        function("batch::route::tracks", name),
        columns,
        |((ship, [start, end]), places)| {
            (
                into(|tracks| batch::route::tracks(surface, lent(&places), start, end, tracks)),
                into(|tracks| {
                    let tracks = tracks.map(|column| column.get_mut(1..).unwrap_or_default());
                    batch::route::leg_tracks(surface, ship, lent(&places), tracks)
                }),
            )
        },
    );
}
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
            Fence::contains(&fence, a),
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
