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
