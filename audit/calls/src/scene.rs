use terrella::cube::Projection;
use terrella::geodesic::{Geodesic, Method, Plane};
use terrella::scene::{
    AnyArea, AnyOrder, Areas, Distances, Expansion, Figure, Geodetics, Order, Positions, Scene, Surface, View,
};
use terrella::{Ellipsoid, Shift};

use crate::{Arguments, Function, Scalar, Visitor};

/// A scene of any kind, mostly one that is right.
fn scene(arguments: &mut Arguments) -> Scene {
    let [size, lat, width, near, low, high] = arguments.units::<f64, 6>();
    let ellipsoid = Ellipsoid::new(6.4e6, 0.005 * (1.0 + size)).unwrap_or(Ellipsoid::WGS84);
    let scene = match arguments.below(3) {
        0 => Scene::new(ellipsoid),
        1 => Scene::around(ellipsoid, 90.0 * lat, 1e6 * (1.0 + width)),
        _ => Scene::latitudes(Scene::new(ellipsoid), 80.0 * lat, 80.0 * lat + 10.0 * width).up_to(2e4 * (1.0 + near)),
    };
    let scene = match arguments.below(4) {
        0 => Scene::local(Scene::up_to(scene, 1e3)),
        1 => Scene::azimuths(Scene::between(scene, 1e3, 1e5 * (1.0 + near)), 1e-3),
        _ => scene,
    };
    let scene = Scene::heights(scene, 1e3 * low, 1e4 * high);
    if arguments.below(2) == 0 {
        Scene::within(scene, 1e2 * (1.0 + size))
    } else {
        Scene::within_pixels(scene, 1.0, 1e-3, 1e4 * (1.0 + size))
    }
}

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>(
        "Expansion",
        |arguments| {
            (
                arguments.ellipsoid::<T>(),
                arguments.geodetic::<T>(),
                arguments.geodetic::<T>(),
            )
        },
        |(ellipsoid, origin, position)| {
            let about = Expansion::new(ellipsoid, origin);
            let local = Expansion::local(ellipsoid, origin);
            (
                Expansion::first_order(&about, position),
                Expansion::second_order(&about, position),
                Expansion::second_order(&local, position),
            )
        },
    );
    visitor.function::<T, _, _>(
        "Plane",
        |arguments| (arguments.ellipsoid::<T>(), arguments.short::<T>()),
        |(ellipsoid, [from, to])| {
            let plane = Plane::new(ellipsoid, from).ok()?;
            let local = Plane::local(ellipsoid, from).ok()?;
            Some((
                plane.inverse(from, to),
                local.inverse(to, from),
                plane.direct(from, to.lon(), to.lat()),
            ))
        },
    );
    // Scenes are asked in double precision, whatever they choose for.
    if T::NAME == f64::NAME {
        questions::<f64, V>(visitor);
        questions::<f32, V>(visitor);
    }
}

/// For a scalar.
fn questions<T: Scalar, V: Visitor>(visitor: &mut V) {
    let of = |name| Function::of(name, T::NAME);
    visitor.visit::<f64, _, _>(of("Scene, its questions"), scene, |scene| {
        let distances = Scene::distances::<T>(&scene);
        let positions = Scene::positions::<T>(&scene);
        let figure = Scene::figure(&scene);
        let tiles = Scene::tiles(&scene, Projection::Adjusted);
        (
            distances.ok().map(|way| {
                (
                    Method::instructions(Distances::method(&way)),
                    Distances::bound(&way).azimuth,
                )
            }),
            positions
                .ok()
                .map(|positions| (Positions::view(&positions) as u8, Positions::bound(&positions))),
            (
                Scene::scalar(&scene).ok().map(|scalar| scalar as u8),
                figure.ok().map(|figure| Figure::bound(&figure)),
            ),
            tiles.ok().map(|tiles| (tiles.plain, tiles.series)),
        )
    });
    visitor.visit::<f64, _, _>(
        of("Scene, by name"),
        |arguments| (scene(arguments), arguments.below(6) as usize),
        |(scene, index)| {
            let method = Scene::METHODS.get(index).copied().unwrap_or(Method::Plane);
            let view = View::ALL.get(index / 2).copied().unwrap_or(View::Full);
            let ways = Scene::distances_by::<T>(&scene, method)
                .ok()
                .map(|way| Distances::bound(&way).distance);
            let views = Scene::positions_by::<T>(&scene, view)
                .ok()
                .map(|positions| Positions::bound(&positions));
            let figures = Scene::figures(&scene)
                .ok()
                .map(|figures| figures.map(|figure| Figure::ground::<T>(&figure)));
            (ways, views, figures)
        },
    );
    visitor.visit::<f64, _, _>(
        of("Distances::solver"),
        |arguments| (scene(arguments), arguments.below(6) as usize, arguments.pair::<T>()),
        |(scene, index, [from, to])| {
            let method = Scene::METHODS.get(index).copied().unwrap_or(Method::Plane);
            let way = Scene::distances_by::<T>(&scene, method).ok()?;
            let method = Distances::solver(&way);
            Some((method.inverse(from, to), method.direct(from, to.lon(), to.lat())))
        },
    );
    visitor.visit::<f64, _, _>(
        of("Scene, areas"),
        |arguments| {
            (
                scene(arguments),
                arguments.below(2) as usize,
                arguments.short::<T>(),
                arguments.place::<T>(),
            )
        },
        |(scene, index, [a, b], c)| {
            let taken = Scene::areas::<T>(&scene).ok().map(|areas| Areas::surface(&areas) as u8);
            let surface = Surface::ALL.get(index).copied().unwrap_or(Surface::Plane);
            let areas = Scene::areas_by::<T>(&scene, surface).ok()?;
            let method = Areas::solver(&areas);
            Some((taken, Areas::bound(&areas), AnyArea::area(&method, [a, b, c])))
        },
    );
    visitor.visit::<f64, _, _>(
        of("Scene, Earth-centred points"),
        |arguments| (scene(arguments), arguments.below(4) as usize, arguments.ecef::<T>()),
        |(scene, index, point)| {
            let taken = Scene::geodetics::<T>(&scene)
                .ok()
                .map(|way| Geodetics::order(&way) as u8);
            let order = Order::ALL.get(index).copied().unwrap_or(Order::Full);
            let way = Scene::geodetics_by::<T>(&scene, order).ok()?;
            let solver = Geodetics::solver(&way);
            Some((taken, Geodetics::bound(&way), AnyOrder::to_geodetic(&solver, point)))
        },
    );
    visitor.visit::<f64, _, _>(
        of("AnyView::enu"),
        |arguments| {
            (
                scene(arguments),
                arguments.below(3) as usize,
                arguments.geodetic::<T>(),
                arguments.geodetic::<T>(),
            )
        },
        |(scene, index, origin, position)| {
            let view = View::ALL.get(index).copied().unwrap_or(View::Full);
            let positions = Scene::positions_by::<T>(&scene, view).ok()?;
            Some(terrella::scene::AnyView::enu(
                &Positions::about(&positions, origin),
                position,
            ))
        },
    );
    visitor.visit::<f64, _, _>(
        of("Figure::shifted"),
        |arguments| (scene(arguments), arguments.place::<T>()),
        |(scene, place)| {
            let figures = Scene::figures(&scene).ok()?;
            let direction = |figure: &Figure| Figure::shifted::<T>(figure, Shift::Authalic).to_direction(place);
            let [sphere, shifted] = &figures;
            Some((direction(sphere), direction(shifted)))
        },
    );
}
