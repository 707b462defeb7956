//! Cameras of every kind over mountains: each place that a line of sight meets is in one tile, and there are
//! about as many tiles as the rule asks for.
//!
//! Lines of sight come from the matrix alone, and what they meet from walking along them over ground that is
//! a sum of waves; how many pixels a tile's ground covers is the sum of its small triangles that face the
//! eye.

use std::collections::HashSet;
use std::f64::consts::TAU;

use fastrand::Rng;
use terrella::cube::{Balanced, CubeMap, CubeProjection, FacePoint};
use terrella::terrain::{Camera, Detail, Enclosure, Heights, Horizon, Selection, Tile};
use terrella::{Ecef, Ellipsoid, Geodetic, LatLon, Shift};
use testkit::{maximum, minimum, parallel};

use crate::vector::{Vector, cross, dot, plus, unit};

fn ecef([x, y, z]: Vector) -> Ecef<f64> {
    Ecef::new(x, y, z).unwrap()
}

fn somewhere(rng: &mut Rng) -> Vector {
    loop {
        let v: Vector = std::array::from_fn(|_| 2.0 * rng.f64() - 1.0);
        if (0.01..=1.0).contains(&dot(v, v)) {
            return unit(v);
        }
    }
}

/// A wave of heights: sin(vector · normal + phase) times its height in metres.
struct Wave {
    vector: Vector,
    phase: f64,
    height: f64,
}

/// Mountains: two waves of each length from 30 km down to 100 m, all equally steep.
struct Ground<P> {
    map: CubeMap<f64, P>,
    mean: f64,
    waves: Vec<Wave>,
    /// Metres up per metre along, at most.
    steepest: f64,
}

impl<P: CubeProjection> Ground<P> {
    fn new(rng: &mut Rng, projection: P) -> Self {
        let ellipsoid = [Ellipsoid::WGS84, Ellipsoid::MARS, Ellipsoid::MOON][rng.usize(0..3)];
        let slope = 0.7 * 10_f64.powf(1.5 * rng.f64() - 2.0);
        let lengths = (0..9).flat_map(|k| [30_000.0 * 0.5_f64.powi(k); 2]);
        let waves: Vec<_> = lengths
            .map(|length| Wave {
                vector: somewhere(rng).map(|v| v * ellipsoid.a() * TAU / length),
                phase: TAU * rng.f64(),
                height: slope * length / TAU,
            })
            .collect();
        Self {
            map: CubeMap::new(ellipsoid, Shift::Authalic, projection).unwrap(),
            mean: 1000.0 * rng.f64(),
            steepest: slope * waves.len() as f64,
            waves,
        }
    }

    fn height(&self, normal: Vector) -> f64 {
        let wave = |w: &Wave| w.height * (dot(w.vector, normal) + w.phase).sin();
        self.mean + self.waves.iter().map(wave).sum::<f64>()
    }

    fn most(&self) -> f64 {
        self.mean + self.waves.iter().map(|w| w.height).sum::<f64>()
    }

    fn point(&self, point: FacePoint<f64>) -> Vector {
        let place = self.map.unproject(point);
        let height = self.height(place.to_direction().to_array());
        let place = Geodetic::new(place, height).unwrap();
        self.map.shifted().ellipsoid().to_ecef(place).to_array()
    }

    /// What 17 × 17 places of a tile say: about what a pyramid of lowest and highest samples has.
    fn sampled(&self, tile: Tile) -> Heights<f64> {
        let normal = |k: u32| {
            self.map
                .unproject(tile.node([k % 17, k / 17], 16))
                .to_direction()
                .to_array()
        };
        let heights = (0..17 * 17).map(|k| self.height(normal(k)));
        let [low, high] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], h| {
            [minimum(a, h), maximum(b, h)]
        });
        Heights::new(low, high).unwrap()
    }

    /// Bounds: that, and half a way between two places more; of large tiles what the waves say.
    fn heights(&self, tile: Tile) -> Heights<f64> {
        let normals: Vec<_> = (0..17 * 17)
            .map(|k| {
                self.map
                    .unproject(tile.node([k % 17, k / 17], 16))
                    .to_direction()
                    .to_array()
            })
            .collect();
        let middle = normals[8 * 17 + 8];
        let radius = normals.iter().map(|&n| plus(n, -1.0, middle)).map(|d| dot(d, d).sqrt());
        let radius = 1.02 * radius.fold(0.0, maximum);
        let (mut low, mut high) = (self.mean, self.mean);
        for wave in &self.waves {
            let (at, way) = (
                dot(wave.vector, middle) + wave.phase,
                radius * dot(wave.vector, wave.vector).sqrt(),
            );
            // Whether there is a place where the angle is this one and whole turns.
            let has = |angle: f64| angle + ((at - way - angle) / TAU).ceil() * TAU <= at + way;
            let [a, b] = [(at - way).sin(), (at + way).sin()];
            low += wave.height * if has(-TAU / 4.0) { -1.0 } else { minimum(a, b) };
            high += wave.height * if has(TAU / 4.0) { 1.0 } else { maximum(a, b) };
        }
        let rest = self.steepest * radius * self.map.shifted().ellipsoid().a() / 22.0;
        let sampled = self.sampled(tile);
        Heights::new(maximum(low, sampled.low() - rest), minimum(high, sampled.high() + rest)).unwrap()
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Perspective,
    Parallel,
    Mirrored,
    /// The middle of the picture is not where the view's axis is.
    OffAxis,
    /// The matrix is relative to a point that is not the centre of projection.
    Displaced,
}

const KINDS: [Kind; 5] = [
    Kind::Perspective,
    Kind::Parallel,
    Kind::Mirrored,
    Kind::OffAxis,
    Kind::Displaced,
];

#[derive(Clone, Copy, Debug)]
struct View {
    kind: Kind,
    /// What the matrix is relative to.
    eye: Vector,
    rows: [[f64; 4]; 3],
    /// The centre of projection; of parallel lines of sight the direction that they come from.
    source: Vector,
}

const SCREEN: [f64; 2] = [1280.0, 1024.0];

fn linear([x, y, z, _]: [f64; 4]) -> Vector {
    [x, y, z]
}

impl View {
    /// From 2 m to 2 km above the bottom of a valley, about level, or from 100 m to 10 000 km, downward.
    fn new(rng: &mut Rng, ground: &Ground<impl CubeProjection>, kind: Kind, low: bool) -> Self {
        let ellipsoid = ground.map.shifted().ellipsoid();
        let mut normal = somewhere(rng);
        for _ in 0..20 {
            let beside = unit(plus(normal, 3e-3 * rng.f64(), somewhere(rng)));
            if ground.height(beside) < ground.height(normal) {
                normal = beside;
            }
        }
        let [x, y, z] = normal;
        let place = LatLon::new(z.asin().to_degrees(), y.atan2(x).to_degrees()).unwrap();
        let above = if low {
            2.0 * 10_f64.powf(3.0 * rng.f64())
        } else {
            10_f64.powf(2.0 + 5.0 * rng.f64())
        };
        let place = Geodetic::new(place, ground.height(normal) + above).unwrap();
        let centre = ellipsoid.to_ecef(place).to_array();
        let tilt: f64 = if low { 40.0 + 60.0 * rng.f64() } else { 85.0 * rng.f64() };
        let (sin, cos) = tilt.to_radians().sin_cos();
        let ahead = unit(cross(normal, somewhere(rng)));
        let forward = plus(ahead.map(|v| v * sin), -cos, normal);
        let right = unit(cross(
            forward,
            if rng.bool() {
                plus(normal, 1e-3, ahead)
            } else {
                somewhere(rng)
            },
        ));
        let up = cross(right, forward);
        let half = (10.0 + 30.0 * rng.f64()).to_radians().tan();
        let row = |[x, y, z]: Vector, scale: f64| [x * scale, y * scale, z * scale, 0.0];
        let wide = half * SCREEN[0] / SCREEN[1];
        let mut view = Self {
            kind,
            eye: centre,
            rows: [row(right, 1.0 / wide), row(up, 1.0 / half), row(forward, 1.0)],
            source: centre,
        };
        let [across, upward, w] = &mut view.rows;
        match kind {
            Kind::Perspective => {}
            Kind::Parallel => {
                let size = above * half * (1.0 + 3.0 * rng.f64());
                *across = row(right, if rng.bool() { 0.8 } else { -0.8 } / size);
                *upward = row(up, 1.0 / size);
                *w = [0.0, 0.0, 0.0, 1.0 + rng.f64()];
                across[3] = 0.2 * (rng.f64() - 0.5);
                // From the side of the eye.
                let sign = dot(forward, centre).signum();
                view.source = forward.map(|v| v * sign);
            }
            Kind::Mirrored => {
                let mirrored = if rng.bool() { across } else { upward };
                *mirrored = mirrored.map(|v| -v);
            }
            Kind::OffAxis => {
                for row in [across, upward] {
                    let shear = 2.0 * rng.f64() - 1.0;
                    *row = std::array::from_fn(|k| row[k] + shear * w[k]);
                }
            }
            Kind::Displaced => {
                let way = somewhere(rng).map(|v| 10.0 * above * rng.f64() * v);
                view.eye = plus(centre, 1.0, way);
                for row in &mut view.rows {
                    row[3] = dot(linear(*row), way);
                }
            }
        }
        view
    }

    fn camera(&self) -> Camera<f64> {
        let [x, y, w] = self.rows;
        // A depth that makes no sense, for nobody is to look at it.
        Camera::new(ecef(self.eye), [x, y, [7.0, -3.0, 0.1, 1e9], w], SCREEN).unwrap()
    }

    fn clip(&self, point: Vector) -> Vector {
        let way = plus(point, -1.0, self.eye);
        self.rows.map(|row| dot(linear(row), way) + row[3])
    }

    /// The line of sight of a place of the picture in [−1, 1]²: a point, and the direction.
    fn ray(&self, [x, y]: [f64; 2]) -> [Vector; 2] {
        let [across, upward, w] = self.rows;
        let plane = |row: [f64; 4], x: f64| plus(linear(row), -x, linear(w));
        let way = unit(cross(plane(across, x), plane(upward, y)));
        if self.kind != Kind::Parallel {
            let sign = dot(way, linear(w)).signum();
            return [self.source, way.map(|v| v * sign)];
        }
        let (a, b) = (linear(across), linear(upward));
        let (p, q) = (x * w[3] - across[3], y * w[3] - upward[3]);
        // The two rows are at right angles.
        let point = plus(plus(self.eye, p / dot(a, a), a), q / dot(b, b), b);
        let way = way.map(|v| -v * dot(way, self.source).signum());
        // From outside of the planet.
        let nearest = plus(point, -dot(point, way), way);
        let away = maximum(7e6_f64.powi(2) - dot(nearest, nearest), 0.0).sqrt();
        [plus(nearest, -away, way), way]
    }

    /// Where the eye is from a point.
    fn toward(&self, point: Vector) -> Vector {
        if self.kind == Kind::Parallel {
            self.source
        } else {
            plus(self.source, -1.0, point)
        }
    }
}

/// Where a line of sight first meets the ground that has this height above the ellipsoid.
fn first_hit(
    ellipsoid: Ellipsoid<f64>,
    [from, way]: [Vector; 2],
    [steepest, highest]: [f64; 2],
    ground: impl Fn(Vector) -> f64,
) -> Option<Geodetic<f64>> {
    let mut gone = 0.0;
    for _ in 0..3000 {
        let point = plus(from, gone, way);
        let place = ellipsoid.to_geodetic(ecef(point));
        let above = place.height() - highest;
        let gap = if above > 10.0 {
            above
        } else {
            let gap = place.height() - ground(place.lat_lon().to_direction().to_array());
            // From below there is nothing to see.
            if gone == 0.0 && gap < 0.0 {
                return None;
            }
            if gap < 1e-3 {
                return Some(place);
            }
            maximum(gap / (1.0 + steepest), 1e-7 * gone)
        };
        gone += gap;
        if gone > 3e8 {
            return None;
        }
    }
    None // grazing
}

/// Whether a place is in one of the tiles and in one only.
fn is_once(tiles: &HashSet<Tile>, map: &CubeMap<f64, impl CubeProjection>, place: LatLon<f64>) -> bool {
    let point = map.project(place);
    let holds = |level: &u8| Tile::containing(point, *level).is_ok_and(|tile| tiles.contains(&tile));
    (0..=FINEST).filter(holds).count() == 1
}

const FINEST: u8 = 20;
const RATIO: f64 = 1.5;
const SAMPLES: u32 = 512;

fn detail() -> Detail<f64> {
    Detail::new(SAMPLES, RATIO, FINEST).unwrap()
}

/// One scene: how many places were visible.
fn misses_none(projection: impl CubeProjection, seed: u64, kind: Kind, low: bool, rays: usize) -> usize {
    let mut rng = Rng::with_seed(seed);
    let ground = Ground::new(&mut rng, projection);
    let view = View::new(&mut rng, &ground, kind, low);
    let ellipsoid = ground.map.shifted().ellipsoid();
    let enclosure = Enclosure::new(ground.map);
    let whole = Heights::new(-2_000.0, ground.most()).unwrap();
    let filter = if rng.u8(0..4) == 0 {
        detail().anisotropic(4.0).unwrap()
    } else {
        detail()
    };
    let known: HashSet<_> = Selection::new(&enclosure, view.camera(), filter, |tile| ground.heights(tile)).collect();
    let unknown: HashSet<_> = Selection::new(&enclosure, view.camera(), detail(), |_| whole).collect();
    let mut visible = 0;
    for _ in 0..rays {
        let at = [2.0 * rng.f64() - 1.0, 2.0 * rng.f64() - 1.0];
        let bounds = [ground.steepest, ground.most()];
        let of_ground = first_hit(ellipsoid, view.ray(at), bounds, |n| ground.height(n));
        let of_range = [-2_000.0, 0.0, whole.high()].map(|level| {
            let place = first_hit(ellipsoid, view.ray(at), [0.0, level], |_| level);
            (place, &unknown)
        });
        for (place, tiles) in of_range.into_iter().chain([(of_ground, &known)]) {
            let Some(place) = place else { continue };
            let [x, y, w] = view.clip(ellipsoid.to_ecef(place).to_array());
            let apart = [x / w - at[0], y / w - at[1]].map(f64::abs);
            assert!(
                w > 0.0 && apart[0] < 1e-4 && apart[1] < 1e-4,
                "{apart:?} {place:?} {view:?}"
            );
            visible += 1;
            assert!(
                is_once(tiles, &ground.map, place.lat_lon()),
                "seed {seed} low {low} {place:?} {view:?}"
            );
        }
    }
    visible
}

pub fn none_is_missed(projection: impl CubeProjection + Sync, scenes: u64, rays: usize) -> usize {
    let all: Vec<_> = (0..scenes)
        .flat_map(|seed| {
            KINDS
                .iter()
                .flat_map(move |&kind| [false, true].map(|low| (seed, kind, low)))
        })
        .collect();
    let visible = parallel::map(all, |(seed, kind, low)| misses_none(projection, seed, kind, low, rays));
    visible.into_iter().sum()
}

#[test]
fn no_visible_place_is_missed() {
    let visible = none_is_missed(Balanced, 4, 25);
    assert!(visible > 1_500, "{visible}");
}

#[test]
#[ignore = "a million: cargo test --release --test terrain -- --ignored --nocapture a_million_visible_places"]
fn a_million_visible_places() {
    let visible = none_is_missed(Balanced, 120, 400);
    println!("{visible} places seen, none missed");
    assert!(visible > 1_000_000, "{visible}");
}

/// The pixels of a tile's ground, and whether any of it is before the eye; infinitely many where only some
/// is.
fn pixels(ground: &Ground<impl CubeProjection>, view: &View, tile: Tile) -> (f64, bool) {
    const PARTS: u32 = 16;
    let point = |m, n| ground.point(tile.node([m, n], PARTS));
    let points: Vec<_> = (0..=PARTS)
        .flat_map(|n| (0..=PARTS).map(move |m| point(m, n)))
        .collect();
    let clipped: Vec<_> = points.iter().map(|&p| view.clip(p)).collect();
    let before = clipped.iter().filter(|[_, _, w]| *w > 0.0).count();
    if before < clipped.len() {
        return (f64::INFINITY, before > 0);
    }
    let pixel = |k: usize| {
        let [x, y, w] = clipped[k];
        [0.5 * SCREEN[0] * x / w, 0.5 * SCREEN[1] * y / w]
    };
    let mut sum = 0.0;
    let row = PARTS as usize + 1;
    for k in (0..PARTS as usize * row).filter(|k| k % row < row - 1) {
        for [a, b, c] in [[k, k + 1, k + row + 1], [k, k + row + 1, k + row]] {
            let outward = cross(plus(points[b], -1.0, points[a]), plus(points[c], -1.0, points[a]));
            if dot(outward, view.toward(points[a])) > 0.0 {
                let [p, q, r] = [a, b, c].map(pixel);
                sum += 0.5 * ((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])).abs();
            }
        }
    }
    (sum, true)
}

/// How many tiles there are if each is split while its ground covers more pixels than the ratio times its
/// samples.
fn by_the_rule(ground: &Ground<impl CubeProjection>, view: &View) -> usize {
    let enclosure = Enclosure::new(ground.map);
    let camera = view.camera();
    let roots = terrella::cube::Face::ALL.map(Tile::root);
    let lows = roots.iter().map(|&root| ground.sampled(root).low());
    let lowest = lows.fold(f64::INFINITY, minimum);
    let horizon = Horizon::of(ground.map.shifted().ellipsoid(), lowest, &camera);
    let (mut left, mut count) = (roots.to_vec(), 0);
    while let Some(tile) = left.pop() {
        let bounds = enclosure.of(tile, ground.sampled(tile));
        if !camera.sees(&bounds) || horizon.hides_box(&bounds) {
            continue;
        }
        let (pixels, before) = pixels(ground, view, tile);
        if tile.level() < FINEST && pixels > RATIO * f64::from(SAMPLES * SAMPLES) {
            left.extend(tile.children().unwrap());
        } else {
            count += usize::from(before);
        }
    }
    count
}

/// The number of tiles, and how many the rule asks for.
fn counts(seed: u64, kind: Kind, low: bool) -> Option<[usize; 2]> {
    let mut rng = Rng::with_seed(seed);
    let ground = Ground::new(&mut rng, Balanced);
    let view = View::new(&mut rng, &ground, kind, low);
    // Parallel lines of sight that graze mountains meet one side of them only, whose tiles are split alone:
    // which side that is, a range of heights does not say.
    if kind == Kind::Parallel && dot(view.source, unit(view.eye)) < 0.17 {
        return None;
    }
    // Something is seen.
    let ellipsoid = ground.map.shifted().ellipsoid();
    let bounds = [ground.steepest, ground.most()];
    first_hit(ellipsoid, view.ray([0.0; 2]), bounds, |n| ground.height(n))?;
    let enclosure = Enclosure::new(ground.map);
    let tiles = Selection::new(&enclosure, view.camera(), detail(), |tile| ground.sampled(tile));
    Some([tiles.count(), by_the_rule(&ground, &view)])
}

fn counts_are_within_two(scenes: u64) {
    for kind in KINDS {
        for low in [false, true] {
            let found = parallel::map(0..scenes, |seed| Some((seed, counts(seed, kind, low)?)));
            let mut found: Vec<_> = found.into_iter().flatten().collect();
            let share = |&(_, [count, asked]): &(u64, [usize; 2])| count as f64 / asked as f64;
            found.sort_by(|a, b| share(a).total_cmp(&share(b)));
            let [first, median, last] = [0, found.len() / 2, found.len() - 1].map(|k| share(&found[k]));
            println!("{kind:?}, low {low}: {first:.2} to {last:.2}, median {median:.2}");
            for (seed, [count, asked]) in found {
                let is_within = 2 * count >= asked && count <= 2 * asked;
                assert!(is_within, "{kind:?} low {low} seed {seed}: {count} of {asked}");
            }
        }
    }
}

#[test]
fn there_are_as_many_tiles_as_the_rule_asks_for() {
    counts_are_within_two(5);
}

#[test]
#[ignore = "1000 scenes: cargo test --release --test terrain -- --ignored --nocapture as_many_tiles_over_many_scenes"]
fn as_many_tiles_over_many_scenes() {
    counts_are_within_two(100);
}
