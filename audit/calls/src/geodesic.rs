use terrella::Ellipsoid;
use terrella::geodesic::{
    Andoyer, AndoyerSecond, Area, Bowring, Flat, Geodesic, GreatCircle, Haversine, Karney, Line, Linear, Method,
    PlanarArea, PlanarPolygon, PolygonArea, Profile, Vincenty, Visitor as MethodVisitor,
};

use crate::{Arguments, Function, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::<T>::WGS84;
    for &method in Method::ALL {
        if let Ok(solver) = Method::on(method, earth) {
            solver.visit(Both(visitor, Method::name(method)));
        }
    }
    for &method in Method::ALL {
        chosen::<T, V>(visitor, method);
    }
    visitor.function::<T, _, _>("the methods' constructors", Arguments::ellipsoid::<T>, |e| {
        let spheres = (
            Haversine::new(e.a()).map(drop),
            GreatCircle::new(e.f()).map(|sphere| sphere.radius()),
        );
        let near = (
            Flat::new(e).map(drop),
            Bowring::new(e).map(drop),
            Area::new(e).map(drop),
        );
        let far = (
            Andoyer::new(e).map(drop),
            AndoyerSecond::new(e).map(drop),
            Vincenty::new(e).map(drop),
        );
        (spheres, near, far, Karney::new(e).map(drop))
    });
    great_circle::<T, V>(visitor);
    karney::<T, V>(visitor);
    area::<T, V>(visitor);
}

/// Shows both problems of a method.
struct Both<'a, V>(&'a mut V, &'static str);

impl<T: Scalar, V: Visitor> MethodVisitor<T> for Both<'_, V> {
    type Output = ();

    fn visit<M: Geodesic<T>>(self, method: M) {
        both(self.0, &method, self.1);
    }
}

/// A method that is chosen at run time.
fn chosen<T: Scalar, V: Visitor>(visitor: &mut V, method: Method) {
    let of = |what| Function::of(what, Method::name(method));
    visitor.visit::<T, _, _>(
        of("Method, by name"),
        |_| Method::name(method),
        |name| name.parse().map(Method::name).ok(),
    );
    let places = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), arguments.pair::<T>());
    visitor.visit::<T, _, _>(of("Method::about"), places, |(ellipsoid, [from, to])| {
        Method::about(method, ellipsoid, from)
            .map(|method| (method.inverse(from, to), method.direct(from, to.lon(), to.lat())))
    });
    // Figures of a profile are in double precision, whatever they are about.
    if T::NAME == f64::NAME {
        let line = |arguments: &mut Arguments| arguments.units::<f64, 2>();
        visitor.visit::<f64, _, _>(of("Method::profile"), line, |[lat, part]| {
            let errors = Profile::worst_errors(Method::profile(method), 90.0 * lat, 2e7 * part);
            errors.map(|errors| errors.double.map(|error| Linear::at(error, 2e7 * part)))
        });
    }
}

fn both<T: Scalar, V: Visitor, M: Geodesic<T>>(visitor: &mut V, method: &M, name: &'static str) {
    let inverse = |name| Function::of("Geodesic::inverse", name);
    visitor.visit::<T, _, _>(inverse(name), Arguments::pair::<T>, |[from, to]| {
        Geodesic::inverse(method, from, to)
    });
    visitor.visit::<T, _, _>(
        Function::of("Geodesic::distance", name),
        Arguments::pair::<T>,
        |[from, to]| Geodesic::distance(method, from, to),
    );
    let start = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.units::<T, 2>());
    visitor.visit::<T, _, _>(
        Function::of("Geodesic::direct", name),
        start,
        |(from, [azimuth, distance])| Geodesic::direct(method, from, azimuth * T::of(180.0), distance * T::of(2e7)),
    );
}

fn straight<T: Scalar, V: Visitor, M: Geodesic<T>>(visitor: &mut V, method: &M, name: &'static str) {
    let function = |what| Function::of(what, name);
    visitor.visit::<T, _, _>(
        function("Geodesic::inverse, short"),
        Arguments::short::<T>,
        |[from, to]| Geodesic::inverse(method, from, to),
    );
    visitor.visit::<T, _, _>(
        function("Geodesic::inverse, nearly antipodal"),
        Arguments::antipodal::<T>,
        |[from, to]| Geodesic::inverse(method, from, to),
    );
    // What it says is no answer may be any number.
    visitor.visit::<T, _, _>(
        function("Geodesic::fast_inverse"),
        Arguments::pair::<T>,
        |[from, to]| {
            let (line, found) = Geodesic::fast_inverse(method, from, to);
            found.then_some(line)
        },
    );
    visitor.visit::<T, _, _>(
        function("Geodesic::far_inverse"),
        Arguments::antipodal::<T>,
        |[from, to]| {
            let (line, found) = Geodesic::far_inverse(method, from, to);
            found.then_some(line)
        },
    );
    let start = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.units::<T, 2>());
    visitor.visit::<T, _, _>(
        function("Geodesic::fast_direct"),
        start,
        |(from, [azimuth, distance])| {
            let distance = distance * T::of(2e7);
            let (end, found) = Geodesic::fast_direct(method, from, azimuth * T::of(180.0), distance);
            found.then_some(end)
        },
    );
}

fn great_circle<T: Scalar, V: Visitor>(visitor: &mut V) {
    let Ok(sphere) = GreatCircle::new(T::of(6_371_000.0)) else {
        return;
    };
    visitor.function::<T, _, _>(
        "GreatCircle::distance_radians",
        Arguments::units::<T, 4>,
        |[a, b, c, d]| {
            (
                GreatCircle::distance_radians(&sphere, [a, b], [c, d]),
                GreatCircle::radius(&sphere),
            )
        },
    );
    visitor.function::<T, _, _>("Geodesic::fast_distance", Arguments::pair::<T>, |[from, to]| {
        let (number, found) = Geodesic::fast_distance(&sphere, from, to);
        found.then_some(Geodesic::finish_distance(&sphere, number))
    });
    let directions = |arguments: &mut Arguments| [arguments.direction::<T>(), arguments.direction()];
    visitor.function::<T, _, _>("GreatCircle::angle_radians", directions, |[a, b]| {
        GreatCircle::angle_radians(a, b)
    });
    visitor.function::<T, _, _>("GreatCircle::midpoint", Arguments::pair::<T>, |[from, to]| {
        GreatCircle::midpoint(&sphere, from, to)
    });
    let pair_and = |arguments: &mut Arguments| (arguments.pair::<T>(), arguments.unit::<T>());
    visitor.function::<T, _, _>("GreatCircle::intermediate", pair_and, |([from, to], fraction)| {
        GreatCircle::intermediate(&sphere, from, to, fraction)
    });
    let three = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.pair::<T>());
    visitor.function::<T, _, _>("GreatCircle::cross_track", three, |(place, [start, end])| {
        GreatCircle::cross_track(&sphere, place, start, end)
    });
    visitor.function::<T, _, _>("GreatCircle::along_track", three, |(place, [start, end])| {
        GreatCircle::along_track(&sphere, place, start, end)
    });
}

fn karney<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::<T>::WGS84;
    let (Ok(karney), Ok(vincenty)) = (Karney::new(earth), Vincenty::new(earth)) else {
        return;
    };
    straight(visitor, &karney, "karney");
    straight(visitor, &vincenty, "vincenty");
    visitor.function::<T, _, _>("Vincenty::evaluations", Arguments::antipodal::<T>, |[from, to]| {
        Vincenty::evaluations(&vincenty, from, to)
    });
    visitor.function::<T, _, _>("Karney::solve", Arguments::pair::<T>, |[from, to]| {
        Karney::solve(&karney, from, to)
    });
    let start = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.unit::<T>());
    visitor.function::<T, _, _>("Karney::line", start, |(from, azimuth)| {
        Karney::line(&karney, from, azimuth * T::of(180.0)).map(drop)
    });
    let Ok(line) = Karney::line(&karney, Arguments::new().place(), T::of(30.0)) else {
        return;
    };
    visitor.function::<T, _, _>("Line::at", Arguments::unit::<T>, |distance| {
        Line::at(&line, distance * T::of(2e7))
    });
    let flat = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), arguments.pair::<T>());
    visitor.visit::<T, _, _>(
        Function::of("Karney::solve", "any ellipsoid"),
        flat,
        |(ellipsoid, [from, to])| {
            Karney::new(ellipsoid).map(|karney| {
                // To an integer, ties to even.
                let shift = T::of(1.5) / T::EPSILON;
                let azimuth = (to.lon() + shift) - shift;
                let line = Karney::line(&karney, from, azimuth).and_then(|line| Line::at(&line, to.lon() * T::of(1e5)));
                (Karney::solve(&karney, from, to), line)
            })
        },
    );
}

fn area<T: Scalar, V: Visitor>(visitor: &mut V) {
    let Ok(area) = Area::new(Ellipsoid::<T>::WGS84) else {
        return;
    };
    visitor.function::<T, _, _>("Area::under", Arguments::pair::<T>, |[from, to]| {
        Area::under(&area, from, to)
    });
    let start = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("Area::under_direct", start, |(from, [azimuth, distance])| {
        Area::under_direct(&area, from, azimuth * T::of(180.0), distance * T::of(2e7))
    });
    let three = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.pair::<T>());
    visitor.function::<T, _, _>("PolygonArea, triangle", three, |(a, [b, c])| {
        let mut polygon = Area::polygon(&area);
        PolygonArea::add(&mut polygon, a);
        PolygonArea::add(&mut polygon, b);
        PolygonArea::add(&mut polygon, c);
        (PolygonArea::area(&polygon), PolygonArea::perimeter(&polygon))
    });
    let field = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), three(arguments), arguments.short::<T>());
    visitor.function::<T, _, _>(
        "PlanarArea, triangles",
        field,
        |(ellipsoid, (origin, [a, b]), [c, d])| {
            let local = PlanarArea::local(ellipsoid, origin).ok()?;
            let absolute = PlanarArea::new(ellipsoid).ok()?;
            Some([local, absolute].map(|area| {
                let mut polygon = PlanarArea::polygon(&area);
                for corner in [a, b, c, d] {
                    PlanarPolygon::add(&mut polygon, corner);
                }
                PlanarPolygon::area(&polygon)
            }))
        },
    );
}
