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
