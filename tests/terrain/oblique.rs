//! Terrain on cubes that are turned and stretched: what holds of the plain ones holds of them.

use fastrand::Rng;
use terrella::cube::{Balanced, CubeMap, CubeProjection, Edge, Face, Projection, Rotation, Stretched, Turned};
use terrella::terrain::{Base, Camera, Detail, Enclosure, Heights, Patches, Selection, Tile};
use terrella::{Ecef, Ellipsoid, LatLon, Shift};
use testkit::{maximum, minimum, parallel};

use crate::bounds::contains;
use crate::edges::edge_agrees;
use crate::patch::{flat_enough, map};
use crate::sample;
use crate::vector::{length, minus};
use crate::visible::none_is_missed;

type Oblique<P> = Turned<Stretched<P>>;

/// The front face anywhere, and stretched by a factor.
fn oblique<P: CubeProjection>(rng: &mut Rng, projection: P, factor: f64) -> Oblique<P> {
    let place = LatLon::new(180.0 * rng.f64() - 90.0, 360.0 * rng.f64()).unwrap();
    let rotation = Rotation::facing(Face::Front, place.to_direction(), 360.0 * rng.f64()).unwrap();
    Turned::new(Stretched::new(projection, factor).unwrap(), rotation)
}

const FACTORS: [f64; 5] = [1.0, 1.3, 0.4, 5.0, 16.0];

#[test]
fn tiles_are_in_their_boxes() {
    let shapes = [
        Ellipsoid::WGS84,
        Ellipsoid::new(6.4e6, 0.1).unwrap(),
        Ellipsoid::new(6.4e6, -1.0 / 9.0).unwrap(),
        Ellipsoid::new(1.0, 0.5).unwrap(),
        Ellipsoid::new(1.0, -1.0).unwrap(),
    ];
    parallel::for_each(Projection::ALL, |&projection| {
        let mut rng = Rng::with_seed(1);
        for shift in [Shift::Geodetic, Shift::Parametric, Shift::Authalic] {
            for ellipsoid in shapes {
                for factor in FACTORS {
                    let Ok(map) = CubeMap::new(ellipsoid, shift, oblique(&mut rng, projection, factor)) else {
                        continue;
                    };
                    for face in Face::ALL {
                        for level in 0..=2 {
                            for n in 0..1 << (2 * level) {
                                let tile = Tile::new(face, level, n % (1 << level), n >> level).unwrap();
                                contains::<f64, _>(map, tile, 0.0, 0.0);
                            }
                        }
                    }
                    for _ in 0..20 {
                        let tile = sample::tile(&mut rng);
                        let height = |rng: &mut Rng| {
                            f64::from((ellipsoid.a() * 10_f64.powf(-8.0 * rng.f64()) * (2.0 * rng.f64() - 0.8)) as f32)
                        };
                        let (a, b) = (height(&mut rng), height(&mut rng));
                        contains::<f64, _>(map, tile, minimum(a, b), maximum(a, b));
                        contains::<f32, _>(map, tile, minimum(a, b), maximum(a, b));
                    }
                }
            }
        }
    });
}

/// A box around the whole planet is for the coarsest tiles alone, and for none of a cube that is only turned.
#[test]
fn boxes_are_no_larger_than_need_be() {
    let mut rng = Rng::with_seed(2);
    for factor in FACTORS {
        for &projection in Projection::ALL {
            let map = CubeMap::new(Ellipsoid::WGS84, Shift::Authalic, oblique(&mut rng, projection, factor)).unwrap();
            let enclosure = Enclosure::new(map);
            for face in Face::ALL {
                for level in 0..=4 {
                    let last = (1 << level) - 1;
                    let tile = Tile::new(face, level, rng.u32(0..=last), rng.u32(0..=last)).unwrap();
                    let bounds = enclosure.of(tile, Heights::default());
                    let [a, _, c, _] = Patches::new(map)
                        .of(tile, Base::default())
                        .corners()
                        .map(Ecef::to_array);
                    let [x, y, _] = bounds.half();
                    let whole = x > 6.378e6;
                    let most = maximum(factor, 1.0 / factor);
                    let coarse = factor != 1.0 && f64::from(1 << level) <= most;
                    assert!(!whole || coarse, "{projection} {factor} {tile:?}");
                    let slim = x.hypot(y) < 2.5 * length(minus(a, c));
                    assert!(whole || slim, "{projection} {factor} {tile:?}");
                }
            }
        }
    }
}

#[test]
fn edges_have_the_same_bits_from_both_sides() {
    parallel::for_each(Projection::ALL, |&projection| {
        let mut rng = Rng::with_seed(3);
        for factor in FACTORS {
            for _ in 0..3 {
                let patches = map(Ellipsoid::WGS84, Shift::Authalic, oblique(&mut rng, projection, factor));
                for face in Face::ALL {
                    for edge in Edge::ALL {
                        let level = rng.u8(0..=30);
                        let last = (1_u32 << level) - 1;
                        let along = rng.u32(0..=last);
                        let [i, j] = match edge {
                            Edge::Right => [last, along],
                            Edge::Up => [along, last],
                            Edge::Left => [0, along],
                            Edge::Down => [along, 0],
                        };
                        edge_agrees(&mut rng, &patches, Tile::new(face, level, i, j).unwrap(), edge, 8);
                    }
                }
            }
        }
    });
}

#[test]
fn flatness_is_a_bound() {
    parallel::for_each(Projection::ALL, |&projection| {
        let mut rng = Rng::with_seed(4);
        for factor in [1.0, 5.0, 16.0] {
            let patches = map(Ellipsoid::WGS84, Shift::Authalic, oblique(&mut rng, projection, factor));
            for level in [0, 1, 2, 4, 8, 13] {
                let [displacement, turning] = flat_enough(&patches, level, 60);
                println!("{projection} {factor} {level} {displacement} {turning}");
                assert!(displacement >= 1.0 && turning >= 1.0, "{projection} {factor} {level}");
            }
        }
    });
}

/// A series is as near as said, in any tile.
#[test]
fn series_are_within_their_bound() {
    let mut rng = Rng::with_seed(5);
    for factor in FACTORS {
        let patches = map(Ellipsoid::WGS84, Shift::Authalic, oblique(&mut rng, Balanced, factor));
        for level in [4, 7, 10] {
            let bound = patches.truncation(level);
            for _ in 0..300 {
                let tile = sample::tile_of(&mut rng, level);
                let series = patches.series(tile, Base::default()).unwrap();
                let offset = series.offset([1.0, 1.0]).map(f64::from);
                let [corner, ..] = patches.of(tile, Base::default()).corners().map(Ecef::to_array);
                let apart = minus(minus(corner, series.anchor().to_array()), offset);
                let rounding = 3e-7 * length(offset);
                assert!(
                    length(apart) <= bound + rounding,
                    "{factor} {tile:?} {} {bound}",
                    length(apart)
                );
            }
        }
    }
}

#[test]
fn no_visible_place_is_missed() {
    let mut rng = Rng::with_seed(6);
    for factor in FACTORS {
        let projection = oblique(&mut rng, Balanced, factor);
        let visible = none_is_missed(projection, 1, 25);
        assert!(visible > 300, "{factor}: {visible}");
    }
}

/// A tile that spans half of the planet is split, however few pixels its ground seems to cover.
#[test]
fn wide_tiles_are_split() {
    let stretched = Stretched::new(Balanced, 16.0).unwrap();
    let enclosure = Enclosure::new(CubeMap::new(Ellipsoid::<f64>::WGS84, Shift::Authalic, stretched).unwrap());
    let eye = Ecef::new(6.378e9, 0.0, 0.0).unwrap();
    let matrix = [
        [0.0, 2.0, 0.0, 0.0],
        [0.0, 0.0, 2.0, 0.0],
        [0.0; 4],
        [-1.0, 0.0, 0.0, 0.0],
    ];
    let camera = Camera::new(eye, matrix, [64.0, 64.0]).unwrap();
    let wide = Tile::root(Face::Bottom);
    assert_eq!(enclosure.coverage(&camera, wide, Heights::default()), f64::INFINITY);
    for anisotropic in [false, true] {
        let detail = Detail::new(512, 1.5, 20).unwrap();
        let detail = if anisotropic {
            detail.anisotropic(4.0).unwrap()
        } else {
            detail
        };
        let tiles: Vec<_> = Selection::new(&enclosure, camera, detail, |_| Heights::default()).collect();
        assert!(!tiles.contains(&wide) && tiles.len() < 60, "{tiles:?}");
        let seen = stretched.project(LatLon::new(0.0, 0.0).unwrap().to_direction());
        let holds = |level| Tile::containing::<f64>(seen, level).is_ok_and(|tile| tiles.contains(&tile));
        assert_eq!((0..=20).filter(|&level| holds(level)).count(), 1);
    }
}
