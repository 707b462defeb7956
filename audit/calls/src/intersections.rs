use terrella::batch;
use terrella::geodesic::{Karney, Line, Passage};
use terrella::route::{Intersection, Intersections, IntersectionsWithin, InvalidStep, Overlap, Segment};
use terrella::{Ellipsoid, LatLon};

use crate::batch::{columns, function, into, lent};
use crate::{Arguments, Bits, Hash, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::<T>::WGS84;
    if let (Ok(karney), Ok(intersections)) = (Karney::new(earth), Intersections::new(earth)) {
        intersect(visitor, &karney, &intersections);
        segments(visitor, &karney, &intersections);
    }
}

/// Two lines, by their starts and azimuths.
fn two_lines<T: Scalar>(arguments: &mut Arguments) -> ([LatLon<T>; 2], [T; 2]) {
    (
        arguments.pair(),
        arguments.units::<T, 2>().map(|part| part * T::of(180.0)),
    )
}

fn intersect<T: Scalar, V: Visitor>(visitor: &mut V, karney: &Karney<T>, intersections: &Intersections<T>) {
    let lines = |places: [LatLon<T>; 2], azimuths: [T; 2]| {
        let ([place1, place2], [azimuth1, azimuth2]) = (places, azimuths);
        Ok::<_, terrella::geodesic::GeodesicError<T>>((
            Karney::line(karney, place1, azimuth1)?,
            Karney::line(karney, place2, azimuth2)?,
        ))
    };
    visitor.function::<T, _, _>("Intersections::new", Arguments::ellipsoid::<T>, |ellipsoid| {
        Intersections::new(ellipsoid).map(drop)
    });
    visitor.function::<T, _, _>("Intersections::closest", two_lines::<T>, |(places, azimuths)| {
        lines(places, azimuths).map(|(one, other)| Intersections::closest(intersections, &one, &other))
    });
    visitor.function::<T, _, _>("Intersections::closest_to", two_lines::<T>, |(places, azimuths)| {
        let (one, other) = lines(places, azimuths)?;
        let origin = azimuths.map(|azimuth| azimuth * T::of(1e5));
        Intersections::closest_to(intersections, &one, &other, origin)
    });
    visitor.function::<T, _, _>("Intersections::next", two_lines::<T>, |([place, _], azimuths)| {
        let [azimuth1, azimuth2] = azimuths;
        Intersections::next(intersections, place, azimuth1, azimuth2)
    });
    visitor.visit::<T, _, _>(
        function("Intersections::within", ""),
        two_lines::<T>,
        |(places, azimuths)| {
            let (one, other) = lines(places, azimuths)?;
            let mut all = Intersections::within(intersections, &one, &other, T::of(3e7))?;
            let most = IntersectionsWithin::most(&all);
            Ok::<_, terrella::geodesic::GeodesicError<T>>((most, all.next(), all.next()))
        },
    );
    visitor.visit::<T, _, _>(
        function("Intersections::within_of", ""),
        two_lines::<T>,
        |(places, azimuths)| {
            let (one, other) = lines(places, azimuths)?;
            let origin = azimuths.map(|azimuth| azimuth * T::of(1e5));
            Intersections::within_of(intersections, &one, &other, T::of(3e7), origin).map(|mut all| all.next())
        },
    );
    visitor.function::<T, _, _>("Line, what it passes", two_lines::<T>, |(places, azimuths)| {
        let (line, _) = lines(places, azimuths)?;
        let [_, place] = places;
        let vertices = (Line::northernmost(&line), Line::southernmost(&line));
        let met = (
            Line::meets_parallel(&line, place.lat()),
            Line::meets_meridian(&line, place.lon()),
        );
        Ok::<_, terrella::geodesic::GeodesicError<T>>((vertices, met, Line::unrolled(&line, T::of(3e7))))
    });
}

fn segments<T: Scalar, V: Visitor>(visitor: &mut V, karney: &Karney<T>, intersections: &Intersections<T>) {
    let two = |arguments: &mut Arguments| (arguments.short::<T>(), arguments.short::<T>());
    visitor.function::<T, _, _>("Intersections::of_segments", two, |([a, b], [c, d])| {
        let (one, other) = (Segment::new(karney, a, b), Segment::new(karney, c, d));
        Intersections::of_segments(intersections, &one, &other)
    });
    visitor.function::<T, _, _>("Segment::new", Arguments::pair::<T>, |[from, to]| {
        let segment = Segment::new(karney, from, to);
        let points = (Segment::midpoint(&segment), Segment::fraction(&segment, T::of(0.3)));
        let extremes = (Segment::northernmost(&segment), Segment::southernmost(&segment));
        let met = (
            Segment::meets_parallel(&segment, T::of(10.0)),
            Segment::meets_meridian(&segment, T::of(20.0)),
        );
        (
            Segment::length(&segment),
            Segment::ends(&segment),
            points,
            extremes,
            met,
        )
    });
    visitor.function::<T, _, _>("Segment::waypoints", Arguments::pair::<T>, |[from, to]| {
        let segment = Segment::new(karney, from, to);
        let line = Line::at(Segment::line(&segment), T::ONE);
        let chords = Segment::chords(&segment, T::of(1e3)).map(|mut points| (points.len(), points.nth(1)));
        let parts = Segment::parts(&segment, 3).nth(2);
        (
            line,
            Segment::waypoints(&segment, T::of(1e6)).map(|mut points| points.nth(1)),
            chords,
            parts,
        )
    });
    visitor.visit::<T, _, _>(
        function("Segment::densified", ""),
        Arguments::pair::<T>,
        |[from, to]| {
            let segment = Segment::new(karney, from, to);
            Segment::densified(&segment, T::of(1e4)).map(|mut points| (points.next(), points.next()))
        },
    );
    let ends = |arguments: &mut Arguments| {
        let units = [T::of(90.0), T::of(180.0), T::of(90.0), T::of(180.0)];
        (columns::<T, 4>(arguments, units), columns::<T, 4>(arguments, units))
    };
    visitor.visit::<T, _, _>(function("batch::route::of_segments", ""), ends, |(one, other)| {
        into(|met| batch::route::of_segments(intersections, lent(&one), lent(&other), met))
    });
}

crate::bits::parts! {
    Passage |passage| (passage.distance, passage.point);
    Intersection |met| (
        [met.displacement1, met.displacement2],
        met.position,
        met.overlap.map(|overlap| overlap == Overlap::Parallel),
    );
    InvalidStep |why| match why {
        InvalidStep::NotPositive(metres) => (false, *metres),
        InvalidStep::TooSmall(metres) => (true, *metres),
    };
}
