use terrella::cube::{Balanced, Corner, CubeMap, CubeProjection, Edge, FacePoint, Healpix, Numbering, Vertex};
use terrella::geodesic::Andoyer;
use terrella::terrain::{
    self, Adjacent, Along, Around, Base, BoundingSphere, Camera, Cap, Covering, Curve, Detail, Diagonal, Enclosure,
    Flatness, Heights, Hilbert, Horizon, InvalidBase, InvalidBox, InvalidCamera, InvalidDetail, InvalidHeights,
    InvalidKey, InvalidNumberedTile, InvalidPatch, InvalidPlace, InvalidRadius, InvalidSteps, InvalidTile,
    InvalidToken, Key, LatLonBox, Morton, Near, OrientedBox, Patch, Patches, Region, Relation, Ring, Selection, Series,
    Split, Symmetry, Tile, Vertices,
};
use terrella::{Direction, Ecef, Ellipsoid, LatLon, Meeting, Ray, Shift, Shifted};

use crate::bits::parts as scalar_parts;
use crate::{Arguments, Bits, Function, Hash, Scalar, Visitor};

/// The samples along an edge of a patch.
const SAMPLES: u32 = 5;

/// Displacements, normals or vertices of a patch.
type Grid = [[f32; (SAMPLES * SAMPLES) as usize]; 3];

const EMPTY: Grid = [[0.0; (SAMPLES * SAMPLES) as usize]; 3];

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    tiles::<T, V>(visitor);
    neighbours::<T, V>(visitor);
    keys::<T, V, Morton>(visitor, "Morton");
    keys::<T, V, Hilbert>(visitor, "Hilbert");
    numbered::<T, V>(visitor);
    rings::<T, V>(visitor);
    coverings::<T, V, _>(visitor, Vertex, "vertex");
    coverings::<T, V, _>(visitor, Balanced, "balanced");
    sights::<T, V>(visitor);
    heights::<T, V>(visitor);
    boxes::<T, V, _>(visitor, Vertex, "vertex");
    boxes::<T, V, _>(visitor, Healpix, "healpix");
    views::<T, V>(visitor);
    // Patches are made in double precision, whatever they are drawn in.
    if T::NAME == f64::NAME {
        symmetries(visitor);
        bases(visitor);
        patches(visitor, Vertex, "vertex");
        patches(visitor, Healpix, "healpix");
        splits(visitor);
        s2_cells(visitor);
    }
}

fn tile<T: Scalar>(arguments: &mut Arguments) -> Tile {
    loop {
        let level = arguments.below(31) as u8;
        if let Ok(tile) = Tile::containing(arguments.face_point::<T>(), level) {
            return tile;
        }
    }
}

fn corner(arguments: &mut Arguments) -> Corner {
    let index = arguments.below(4) as usize;
    Corner::ALL.get(index).copied().unwrap_or(Corner::UpLeft)
}

fn tiles<T: Scalar, V: Visitor>(visitor: &mut V) {
    let numbers = |arguments: &mut Arguments| {
        let level = arguments.below(33) as u8;
        let [i, j] = [arguments.below(1 << 12) as u32, arguments.below(1 << 12) as u32];
        (arguments.face(), level, i, j)
    };
    visitor.function::<T, _, _>("Tile::new", numbers, |(face, level, i, j)| {
        (Tile::new(face, level, i, j), Tile::root(face), Tile::distinct(level))
    });
    let inside = |arguments: &mut Arguments| (arguments.face_point::<T>(), arguments.below(33) as u8);
    visitor.function::<T, _, _>("Tile::containing", inside, |(point, level)| {
        Tile::containing(point, level)
    });
    let family = |arguments: &mut Arguments| (tile::<T>(arguments), arguments.below(31) as u8);
    visitor.function::<T, _, _>("Tile, its family", family, |(tile, level)| {
        let above = Tile::ancestor(tile, level);
        (
            Tile::parent(tile),
            Tile::children(tile),
            above,
            above.map(|above| Tile::contains(above, tile)),
        )
    });
    let places = |arguments: &mut Arguments| (tile::<T>(arguments), corner(arguments), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("Tile, its places", places, |(tile, corner, [s, t])| {
        let point = Tile::point(tile, [s.abs(), t]);
        let back = point.map(|point| Tile::place(tile, point));
        let nodes: [FacePoint<T>; 2] = [Tile::node(tile, [3, 7], 9), Tile::centre(tile)];
        let one: FacePoint<T> = Tile::corner(tile, corner);
        let all: [FacePoint<T>; 4] = Tile::corners(tile);
        (point, back, nodes, one, all)
    });
}

fn neighbours<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| {
        let edge = Edge::ALL.get(arguments.below(4) as usize).copied();
        (tile::<T>(arguments), edge.unwrap_or(Edge::Up), corner(arguments))
    };
    visitor.function::<T, _, _>("Tile::neighbour", draw, |(tile, edge, _)| Tile::neighbour(tile, edge));
    visitor.function::<T, _, _>("Tile::around", draw, |(tile, _, corner)| {
        (Tile::diagonal(tile, corner), Tile::around(tile, corner))
    });
    visitor.function::<T, _, _>("Tile::neighbours", draw, |(tile, edge, _)| {
        Tile::neighbours(tile, edge, Tile::level(tile) + 2)
    });
    visitor.function::<T, _, _>("Tile::diagonal_at", draw, |(tile, _, corner)| {
        let at = |level| Tile::diagonal_at(tile, corner, level);
        (at(Tile::level(tile) / 2), at(Tile::level(tile) + 2))
    });
}

fn rings<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (tile::<T>(arguments), arguments.below(5) as u32);
    visitor.function::<T, _, _>("Tile::ring", draw, |(tile, steps)| {
        let disc = Tile::disc(tile, steps).map(Iterator::count);
        (Tile::ring(tile, steps), disc.map(|count| count as u64))
    });
    let two = |arguments: &mut Arguments| [tile::<T>(arguments), tile::<T>(arguments)];
    visitor.function::<T, _, _>("Tile::common_ancestor", two, |[tile, other]| {
        let [key, second] = [tile, other].map(Key::<Hilbert>::from);
        let above = Key::common_ancestor(key, second).map(Key::bits);
        (Tile::common_ancestor(tile, other), above)
    });
}

fn coverings<T: Scalar, V: Visitor, P: CubeProjection>(visitor: &mut V, projection: P, of: &'static str) {
    let Ok(map) = CubeMap::<T, _>::new(Ellipsoid::WGS84, Shift::Authalic, projection) else {
        return;
    };
    let name = |function| Function::of(function, of).calls(10);
    let around = |[place, other]: [LatLon<T>; 2]| {
        let ordered = place.lat() <= other.lat();
        let [south, north] = if ordered { [place, other] } else { [other, place] };
        LatLonBox::new(south.lat(), place.lon(), north.lat(), other.lon())
    };
    let draw = |arguments: &mut Arguments| (arguments.short::<T>(), arguments.place::<T>(), tile::<T>(arguments));
    visitor.visit::<T, _, _>(name("Covering, of a box"), draw, |(places, place, tile)| {
        around(places).map(|region| {
            let covering = Covering::new(map, region, 6).map(|outer| {
                let few = Covering::of_at_most(Covering::mixed(outer.clone()), 50);
                let few = few.map(|few| (Covering::level(&few), few.count() as u64));
                let inner = Covering::inner(outer.clone()).count() as u64;
                (
                    outer.fold(0, |sum: u64, tile| sum.wrapping_add(Key::<Hilbert>::from(tile).bits())),
                    few,
                    inner,
                )
            });
            (
                covering,
                LatLonBox::contains(&region, place),
                Region::relation(&region, &map, tile),
                region,
            )
        })
    });
    let draw = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.unit::<T>());
    visitor.visit::<T, _, _>(name("Covering, of a cap"), draw, |(centre, size)| {
        let method = Andoyer::new(Ellipsoid::WGS84).ok()?;
        let cap = Cap::new(method, centre, size * T::of(1e6));
        Some(cap.map(|cap| {
            let count = Covering::new(map, cap, 4).map(|covering| covering.count() as u64);
            (count, Cap::centre(&cap), Cap::radius(&cap))
        }))
    });
    visitor.visit::<T, _, _>(name("Covering, of what is near"), draw, |(place, size)| {
        let distance = |other: LatLon<T>| (other.lat() - place.lat()).abs() * T::of(1e5);
        let near = Near::new(distance, size * T::of(1e6), &[], &[]);
        near.map(|near| Covering::new(map, near, 3).map(|covering| covering.count() as u64))
    });
    visitor.visit::<T, _, _>(name("LatLonBox::of_tile"), tile::<T>, |tile| {
        LatLonBox::of_tile(&map, tile)
    });
    visitor.visit::<T, _, _>(name("Tile::area"), tile::<T>, |tile| Tile::area(tile, &map));
}

fn sights<T: Scalar, V: Visitor>(visitor: &mut V) {
    let two = |arguments: &mut Arguments| ([(); 2].map(|()| arguments.ecef::<T>()), arguments.unit::<T>());
    visitor.function::<T, _, _>("Ellipsoid::meet", two, |([start, other], height)| {
        Ray::through(start, other).map(|ray| {
            let meeting = Ellipsoid::meet(Ellipsoid::WGS84, &ray, height * T::of(1e4));
            let place = Meeting::distance(meeting).map(|distance| Ray::at(&ray, distance));
            let same = Ray::new(Ray::start(&ray), Direction::to_array(Ray::direction(&ray))).map(|_| ());
            (meeting, place, same)
        })
    });
    visitor.function::<T, _, _>("Ellipsoid::clearance", two, |([from, to], _)| {
        Ellipsoid::clearance(Ellipsoid::<T>::WGS84, from, to)
    });
    let draw = |arguments: &mut Arguments| (arguments.direction::<T>(), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("Camera::ray", draw, |(direction, place)| {
        [camera(direction), parallel(direction)].map(|camera| {
            let ray = Camera::ray(&camera?, place.map(|at| at * T::of(500.0)))?;
            Some((Ray::start(&ray), Ray::direction(&ray)))
        })
    });
}

fn keys<T: Scalar, V: Visitor, C: Curve>(visitor: &mut V, name: &'static str) {
    let name = |function| Function::of(function, name);
    let two = |arguments: &mut Arguments| (tile::<T>(arguments), tile::<T>(arguments), arguments.below(31) as u8);
    visitor.visit::<T, _, _>(name("Key, of a tile"), two, |(tile, other, level)| {
        let (key, other) = (Key::<C>::from(tile), Key::<C>::from(other));
        let above = Key::ancestor(key, level);
        let range = Key::range(key);
        (
            [Key::bits(key), Key::bits(*range.start()), Key::bits(*range.end())],
            Key::level(key),
            above.map(|above| (Key::bits(above), Key::contains(above, other))),
            Tile::from(key),
        )
    });
    let bits = |arguments: &mut Arguments| {
        let [high, low] = [arguments.below(1 << 23), arguments.below(1 << 23)];
        high << 41 | low << 18
    };
    visitor.visit::<T, _, _>(name("Key::new"), bits, |bits| Key::<C>::new(bits).map(Tile::from));
    let token = |arguments: &mut Arguments| {
        let tokens = ["4646541", "1", "c", "", "00000000000000001", "3g", "2ef59bd352b93ac3"];
        tokens.get(arguments.below(7) as usize).copied().unwrap_or_default()
    };
    visitor.visit::<T, _, _>(name("Key, from a token"), token, |token| {
        token.parse::<Key<C>>().map(Tile::from)
    });
}

fn numbered<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (tile::<T>(arguments), arguments.below(7) as u8);
    let numberings = [
        (Numbering::S2, "S2"),
        (Numbering::OpenGl, "OpenGL"),
        (Numbering::Fits, "FITS"),
        (Numbering::Eac, "EAC"),
    ];
    for (numbering, name) in numberings {
        let name = Function::of("Tile::to_numbering", name);
        visitor.visit::<T, _, _>(name, draw, |(tile, face)| {
            let (number, i, j) = Tile::to_numbering(tile, numbering);
            let back = [number, face].map(|face| Tile::from_numbering(numbering, face, Tile::level(tile), i, j));
            ([i, j], back)
        });
    }
    visitor.function::<T, _, _>("Tile::around_nearest", draw, |(tile, level)| {
        Tile::around_nearest(tile, level)
    });
    visitor.visit::<T, _, _>(Function::of("Tile::solid_angle", "vertex"), draw, |(tile, _)| {
        Tile::solid_angle::<T>(tile, Vertex)
    });
    visitor.visit::<T, _, _>(Function::of("Tile::solid_angle", "balanced"), draw, |(tile, _)| {
        Tile::solid_angle::<T>(tile, Balanced)
    });
}

fn s2_cells<V: Visitor>(visitor: &mut V) {
    visitor.function::<f64, _, _>("Key::s2_leaf", Arguments::direction::<f64>, |direction| {
        let leaf = Key::s2_leaf(direction);
        (Key::bits(leaf), Key::s2_edge_neighbours(leaf).map(Key::bits))
    });
    visitor.function::<f64, _, _>("Key::s2_leaf_of", Arguments::units::<f64, 3>, |vector| {
        Key::s2_leaf_of(vector).map(Key::bits)
    });
    let draw = |arguments: &mut Arguments| (arguments.below(7) as u8, arguments.units::<f64, 2>());
    visitor.function::<f64, _, _>("Key::s2_leaf_at", draw, |(face, [s, t])| {
        Key::s2_leaf_at(face, [s.abs(), t]).map(Key::bits)
    });
}

fn heights<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>("Heights::new", Arguments::units::<T, 2>, |[low, high]| {
        Heights::new(low, high).map(|heights| [Heights::low(heights), Heights::high(heights)])
    });
    let Ok(earth) = Shifted::new(Ellipsoid::<T>::WGS84, Shift::Geocentric) else {
        return;
    };
    visitor.function::<T, _, _>("terrain::lean", Arguments::geodetic::<T>, |place| {
        terrain::lean(&earth, place.lat_lon(), place.height())
    });
}

fn hills<T: Scalar>() -> Heights<T> {
    Heights::new(T::of(-500.0), T::of(9e3)).unwrap_or_default()
}

/// The boxes of an Earth.
fn enclosure<T: Scalar, P: CubeProjection>(projection: P) -> Option<Enclosure<T, P>> {
    let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection).ok()?;
    Some(Enclosure::new(map))
}

fn boxes<T: Scalar, V: Visitor, P: CubeProjection>(visitor: &mut V, projection: P, of: &'static str) {
    let Some(enclosure) = enclosure::<T, P>(projection) else {
        return;
    };
    let name = |function| Function::of(function, of);
    visitor.visit::<T, _, _>(name("Enclosure::of"), tile::<T>, |tile| {
        Enclosure::of(&enclosure, tile, hills())
    });
    if of == "vertex" {
        visitor.visit::<T, _, _>(name("Enclosure::new"), Arguments::ellipsoid::<T>, |ellipsoid| {
            let map = CubeMap::new(ellipsoid, Shift::Authalic, projection);
            map.map(|map| {
                let enclosure = Enclosure::new(map);
                let roots = terrella::cube::Face::ALL.map(Tile::root);
                (
                    Enclosure::map(&enclosure).shifted().ellipsoid(),
                    roots.map(|root| Enclosure::of(&enclosure, root, hills())),
                )
            })
        });
        let draw = |arguments: &mut Arguments| (tile::<T>(arguments), arguments.ecef::<T>());
        visitor.visit::<T, _, _>(name("OrientedBox, its measures"), draw, |(tile, point)| {
            let bounds = Enclosure::of(&enclosure, tile, hills());
            (
                OrientedBox::corners(&bounds),
                OrientedBox::sphere(&bounds),
                OrientedBox::distance(&bounds, point),
            )
        });
    }
}

/// From some 620 km above a place straight down, 90° wide and high.
fn camera<T: Scalar>(direction: Direction<T>) -> Option<Camera<T>> {
    let [x, y, z] = direction.to_array();
    let away = T::of(7e6);
    let eye = Ecef::new(x * away, y * away, z * away).ok()?;
    let matrix = [
        [-y, x, T::ZERO, T::ZERO],
        [-(z * x), -(z * y), x * x + y * y, T::ZERO],
        [T::ZERO; 4],
        [-x, -y, -z, T::ZERO],
    ];
    Camera::new(eye, matrix, [T::of(1024.0), T::of(768.0)]).ok()
}

/// The same without perspective, 10 000 km wide.
fn parallel<T: Scalar>(direction: Direction<T>) -> Option<Camera<T>> {
    let [x, y, z] = direction.to_array();
    let [away, scale] = [T::of(7e6), T::of(2e-7)];
    let eye = Ecef::new(x * away, y * away, z * away).ok()?;
    let matrix = [
        [-y * scale, x * scale, T::ZERO, T::ZERO],
        [-(z * x) * scale, -(z * y) * scale, (x * x + y * y) * scale, T::ZERO],
        [T::ZERO; 4],
        [T::ZERO, T::ZERO, T::ZERO, T::ONE],
    ];
    Camera::new(eye, matrix, [T::of(1024.0), T::of(768.0)]).ok()
}

fn views<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (arguments.ecef::<T>(), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("Camera::new", draw, |(eye, pixels)| {
        Camera::new(eye, [[T::ONE; 4]; 4], pixels).map(|camera| Camera::eye(&camera))
    });
    let draw = |arguments: &mut Arguments| (arguments.direction::<T>(), arguments.ecef::<T>());
    visitor.function::<T, _, _>("Camera::pixel", draw, |(direction, point)| {
        camera(direction).map(|camera| Camera::pixel(&camera, point))
    });
    visitor.function::<T, _, _>("Horizon::hides", draw, |(direction, point)| {
        let eye = camera(direction).map(|camera| Camera::eye(&camera));
        eye.map(|eye| Horizon::hides(&Horizon::new(Ellipsoid::WGS84, T::of(-500.0), eye), point))
    });
    visitor.function::<T, _, _>("Detail::new", Arguments::units::<T, 2>, |[ratio, most]| {
        let most = T::of(16.0) * most;
        let levels = [8, 31].map(|finest| Detail::new(512, ratio, finest));
        let samples = Detail::new(0, ratio, 8).map(|_| ());
        (
            samples,
            levels.map(|detail| detail.and_then(|detail| Detail::anisotropic(detail, most)).map(|_| ())),
        )
    });
    let Some(enclosure) = enclosure::<T, _>(Vertex) else {
        return;
    };
    let draw = |arguments: &mut Arguments| (arguments.direction::<T>(), tile::<T>(arguments));
    visitor.function::<T, _, _>("Enclosure::coverage", draw, |(direction, tile)| {
        let bounds = Enclosure::of(&enclosure, tile, hills());
        [camera(direction), parallel(direction)].map(|camera| {
            let camera = camera?;
            let horizon = Horizon::of(Ellipsoid::WGS84, T::of(-500.0), &camera);
            Some((
                Enclosure::coverage(&enclosure, &camera, tile, hills()),
                Camera::sees(&camera, &bounds),
                Horizon::hides_box(&horizon, &bounds),
            ))
        })
    });
    let details = [Detail::new(256, T::of(1.5), 6), {
        let detail = Detail::new(256, T::of(1.5), 6);
        detail.and_then(|detail| Detail::anisotropic(detail, T::of(16.0)))
    }];
    for (detail, name) in details.into_iter().zip(["coverage", "anisotropic"]) {
        let function = Function::of("Selection", name).calls(4);
        visitor.visit::<T, _, _>(function, Arguments::direction::<T>, |direction| {
            let detail = detail.ok()?;
            let mut hash = Hash::default();
            for camera in [camera(direction)?, parallel(direction)?] {
                let tiles = Selection::new(&enclosure, camera, detail, |_| hills());
                tiles.for_each(|tile| tile.add_to(&mut hash));
            }
            Some(hash.value())
        });
    }
}

fn lent(grid: &Grid) -> [&[f32]; 3] {
    grid.each_ref().map(<[f32; 25]>::as_slice)
}

fn slots(grid: &mut Grid) -> [&mut [f32]; 3] {
    grid.each_mut().map(<[f32; 25]>::as_mut_slice)
}

fn grid(arguments: &mut Arguments) -> Grid {
    EMPTY.map(|column| column.map(|_| arguments.unit::<f32>()))
}

fn symmetries<V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (tile::<f64>(arguments), arguments.units::<f32, 3>());
    visitor.function::<f64, _, _>("Tile::representative", draw, |(tile, vector)| {
        let (representative, symmetry) = Tile::representative(tile);
        (
            representative,
            Symmetry::place(symmetry, [1, 3], SAMPLES),
            Symmetry::vector(symmetry, vector),
        )
    });
    let draw = |arguments: &mut Arguments| (tile::<f64>(arguments), grid(arguments));
    visitor.function::<f64, _, _>("Symmetry::fill", draw, |(tile, known)| {
        let (_, symmetry) = Tile::representative(tile);
        let mut carried = EMPTY;
        let outcome = Symmetry::fill(symmetry, SAMPLES, lent(&known), slots(&mut carried));
        let refused = Symmetry::fill(symmetry, 1, lent(&known), slots(&mut EMPTY.clone()));
        (carried, outcome, refused)
    });
}

/// Heights of some kilometres in the corners.
fn base(arguments: &mut Arguments) -> Base {
    let corners = [(); 4].map(|()| 1e4 * arguments.unit::<f64>());
    Base::new(corners).unwrap_or_default()
}

fn bases<V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| [(); 4].map(|()| 1e4 * arguments.unit::<f64>());
    visitor.function::<f64, _, _>("Base::new", draw, |corners| {
        let level = Base::from(hills::<f64>());
        [Base::new(corners), Ok(level)]
            .map(|base| base.map(|base| (Base::corners(base), Base::at(base, [1, 3], SAMPLES))))
    });
}

fn patches<V: Visitor, P: CubeProjection>(visitor: &mut V, projection: P, of: &'static str) {
    let Ok(map) = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, projection) else {
        return;
    };
    let patches = Patches::new(map);
    let name = |function| Function::of(function, of);
    let draw = |arguments: &mut Arguments| (tile::<f64>(arguments), base(arguments));
    visitor.visit::<f64, _, _>(name("Patches::fill").calls(32), draw, |(tile, base)| {
        let (mut displacements, mut normals) = (EMPTY, EMPTY);
        let patch = Patches::fill(
            &patches,
            tile,
            base,
            SAMPLES,
            slots(&mut displacements),
            slots(&mut normals),
        );
        (patch, displacements, normals)
    });
    let draw = |arguments: &mut Arguments| {
        (
            (tile::<f64>(arguments), base(arguments)),
            arguments.ecef::<f64>(),
            arguments.units::<f32, 2>(),
        )
    };
    visitor.visit::<f64, _, _>(name("Patches::series"), draw, |((tile, base), camera, place)| {
        let series = Patches::series(&patches, tile, base);
        series.map(|series| (series, Series::origin(&series, camera), Series::offset(&series, place)))
    });
    if of != "vertex" {
        return;
    }
    visitor.visit::<f64, _, _>(name("Patches::of"), draw, |((tile, base), camera, place)| {
        let patch = Patches::of(&patches, tile, base);
        let seen = Patch::seen_from(&patch, camera);
        let normals = Patch::normals(&patch);
        let plain = Vertices::plain(&seen, place, normals, 120.0);
        (patch, Vertices::corners(&seen), plain)
    });
    let draw = |arguments: &mut Arguments| {
        let seen = (tile::<f64>(arguments), arguments.ecef::<f64>());
        (seen, grid(arguments), grid(arguments))
    };
    visitor.visit::<f64, _, _>(
        name("Vertices::fill").calls(32),
        draw,
        |((tile, camera), displacements, normals)| {
            let seen = Patch::seen_from(&Patches::of(&patches, tile, Base::default()), camera);
            let [heights, ..] = displacements;
            let mut vertices = EMPTY;
            let outcome = Vertices::fill(
                &seen,
                SAMPLES,
                lent(&displacements),
                lent(&normals),
                &heights,
                slots(&mut vertices),
            );
            let one = Vertices::at(&seen, [1, 3], SAMPLES, [0.5, 0.25, 0.75], [1.0, 0.0, 0.0], 120.0);
            (vertices, outcome, one)
        },
    );
    let level = |arguments: &mut Arguments| arguments.below(31) as u8;
    visitor.visit::<f64, _, _>(name("Patches::flatness").calls(1), level, |level| {
        let sphere = Patches::map(&patches).shifted().ellipsoid();
        (Patches::flatness(&patches, level), sphere)
    });
    visitor.visit::<f64, _, _>(
        name("Patches::plain_level").calls(1),
        Arguments::unit::<f64>,
        |tolerance| Patches::plain_level(&patches, 1e5 * (2.0 + tolerance), hills()),
    );
    visitor.visit::<f64, _, _>(name("Patches::skirt").calls(1), level, |level| {
        Patches::skirt(&patches, level, 65, hills())
    });
    visitor.visit::<f64, _, _>(name("Patches::truncation").calls(1), level, |level| {
        Patches::truncation(&patches, level)
    });
}

fn splits<V: Visitor>(visitor: &mut V) {
    let two = |arguments: &mut Arguments| [arguments.ecef::<f64>(), arguments.ecef()];
    visitor.function::<f64, _, _>("Split::new", two, |points| {
        let [point, camera] = points.map(Split::new);
        (Split::high(point), Split::low(point), Split::seen_from(point, camera))
    });
}

/// A type by the parts that its own functions or fields give.
macro_rules! parts {
    ($($type:ty |$value:ident| $parts:expr;)*) => {$(
        impl Bits for $type {
            fn add_to(&self, hash: &mut Hash) {
                let $value = self;
                $parts.add_to(hash);
            }
        }
    )*};
}

parts! {
    Tile |t| (Tile::face(*t), Tile::level(*t), Tile::i(*t), Tile::j(*t));
    Adjacent |a| (a.tile, a.edge, a.turns);
    Diagonal |d| (d.tile, d.corner, d.turns);
    Patch |p| (Patch::corners(p), Patch::normals(p));
    Series |s| (Series::anchor(s), Series::coefficients(s));
    Flatness |f| [f.displacement, f.turning];
    InvalidBase |why| why.0;
    InvalidKey |why| why.0;
    InvalidTile |why| match why {
        InvalidTile::Level(level) => (*level, None),
        InvalidTile::Column { level, i } => (*level, Some((false, *i))),
        InvalidTile::Row { level, j } => (*level, Some((true, *j))),
    };
    InvalidNumberedTile |why| match why {
        InvalidNumberedTile::Face(face) => (Some(*face), None),
        InvalidNumberedTile::Tile(tile) => (None, Some(*tile)),
    };
    InvalidToken |why| match why {
        InvalidToken::Length(length) => (Some(*length), None, None),
        InvalidToken::Digit(character) => (None, Some(u32::from(*character)), None),
        InvalidToken::Key(key) => (None, None, Some(*key)),
    };
    InvalidSteps |why| (why.level, why.steps);
    Relation |relation| *relation as u32;
    InvalidPatch |why| match why {
        InvalidPatch::Samples(samples) => (Some(*samples), None),
        InvalidPatch::Length { expected, length } => (None, Some([*expected, *length])),
    };
}

impl Bits for Around {
    fn add_to(&self, hash: &mut Hash) {
        Around::as_slice(self).iter().for_each(|tile| tile.add_to(hash));
    }
}

impl Bits for Ring {
    fn add_to(&self, hash: &mut Hash) {
        self.clone().for_each(|tile| tile.add_to(hash));
    }
}

impl Bits for Along {
    fn add_to(&self, hash: &mut Hash) {
        (Along::edge(self), Along::turns(self), self.len()).add_to(hash);
        (*self).for_each(|tile| tile.add_to(hash));
    }
}

scalar_parts! {
    OrientedBox |b| (OrientedBox::centre(b), OrientedBox::axes(b), OrientedBox::half(b));
    BoundingSphere |s| (s.centre, s.radius);
    LatLonBox |b| [
        LatLonBox::south(b), LatLonBox::west(b), LatLonBox::north(b), LatLonBox::east(b), LatLonBox::width(b),
    ];
    InvalidBox |why| match why {
        InvalidBox::Corner(why) => (Some(*why), None),
        InvalidBox::Order { south, north } => (None, Some([*south, *north])),
    };
    InvalidRadius |why| why.0;
    Meeting |meeting| match meeting {
        Meeting::Misses => (0_u32, None),
        Meeting::Touches(distance) => (1, Some(*distance)),
        Meeting::Enters(distance) => (2, Some(*distance)),
        Meeting::Leaves(distance) => (3, Some(*distance)),
    };
    InvalidHeights |why| [why.low, why.high];
    InvalidPlace |why| [why.s, why.t];
    InvalidCamera |why| match why {
        InvalidCamera::Matrix(entry) => (false, *entry),
        InvalidCamera::Pixels(count) => (true, *count),
        _ => (true, T::ZERO),
    };
    InvalidDetail |why| match why {
        InvalidDetail::Ratio(ratio) => (Some((false, *ratio)), None),
        InvalidDetail::Anisotropy(most) => (Some((true, *most)), None),
        InvalidDetail::Level(tile) => (None, Some(*tile)),
        _ => (None, None),
    };
}
