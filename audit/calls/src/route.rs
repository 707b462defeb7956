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
