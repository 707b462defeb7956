//! The points that everything is timed on: the same for terrella and for its rivals.
//!
//! Sets come from a fixed seed, in random order and in scan order, each coordinate in a slice of its own. A branch
//! predictor learns a set of 8 000 to 16 000 points by heart, hence [`N`].
//! Sines and square roots here are the standard library's: the sets are equal for two programs on one machine.

/// Points in a set.
pub const N: usize = 131_072;

/// WGS84: equatorial radius in metres.
pub const WGS84_A: f64 = 6_378_137.0;
/// WGS84: flattening.
pub const WGS84_F: f64 = 1.0 / 298.257_223_563;

/// Splitmix64 (Steele, Lea & Flood 2014).
pub struct Random(u64);

impl Random {
    /// The generator of one set: `set` keeps sets apart.
    pub fn new(set: u64) -> Self {
        Self(0x7465_7272_656c_6c61 ^ (set << 32))
    }

    /// Uniform in [0, 1), a multiple of 2⁻⁵³.
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A unit vector, uniform on the sphere.
    fn vector(&mut self) -> [f64; 3] {
        let (z, lon) = (self.within(-1.0, 1.0), self.within(-180.0, 180.0).to_radians());
        let r = (1.0 - z * z).sqrt();
        [r * lon.cos(), r * lon.sin(), z]
    }
}

/// The order of a set.
#[derive(Clone, Copy, PartialEq)]
pub enum Order {
    /// Uniform and independent.
    Random,
    /// Row by row over a raster.
    Scan,
}

impl Order {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Random, Self::Scan];

    /// The word for a record's `input`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Scan => "scan",
        }
    }
}

/// Points on the faces of a cube, numbered and oriented as in `tests/truth/README.md`; x, y in [−1, 1].
pub struct FacePoints {
    /// 0 to 5.
    pub face: Vec<u8>,
    /// To the right.
    pub x: Vec<f64>,
    /// Upwards.
    pub y: Vec<f64>,
}

/// Random: uniform over the six faces. Scan: face after face, row after row, texel centres.
pub fn face_points(order: Order, n: usize) -> FacePoints {
    let mut random = Random::new(1);
    let side = (n as f64 / 6.0).sqrt().ceil() as usize;
    let centre = |k: usize| (2 * k + 1) as f64 / side as f64 - 1.0;
    let point = |i: usize| match order {
        Order::Random => {
            let face = random.within(0.0, 6.0) as u8;
            (face, random.within(-1.0, 1.0), random.within(-1.0, 1.0))
        }
        Order::Scan => ((i / (side * side)) as u8, centre(i % side), centre(i / side % side)),
    };
    let (face, (x, y)) = (0..n).map(point).map(|(face, x, y)| (face, (x, y))).unzip();
    FacePoints { face, x, y }
}

/// Unit vectors in Earth axes (X: 0° N 0° E, Y: 0° N 90° E, Z: north pole).
pub struct Directions {
    /// Towards 0° N 0° E.
    pub x: Vec<f64>,
    /// Towards 0° N 90° E.
    pub y: Vec<f64>,
    /// Towards the north pole.
    pub z: Vec<f64>,
}

/// Random: uniform on the sphere. Scan: the gnomonic images of the scan of [`face_points`].
pub fn directions(order: Order, n: usize) -> Directions {
    let vectors: Vec<[f64; 3]> = match order {
        Order::Random => {
            let mut random = Random::new(2);
            (0..n).map(|_| random.vector()).collect()
        }
        Order::Scan => {
            let points = face_points(order, n);
            (0..n)
                .map(|i| gnomonic(points.face[i], points.x[i], points.y[i]))
                .collect()
        }
    };
    let axis = |k: usize| vectors.iter().map(|v| v[k]).collect();
    Directions {
        x: axis(0),
        y: axis(1),
        z: axis(2),
    }
}

/// The unit vector through a point of a face's plane.
fn gnomonic(face: u8, x: f64, y: f64) -> [f64; 3] {
    let scale = 1.0 / (1.0 + x * x + y * y).sqrt();
    let [u, v, w] = [x * scale, y * scale, scale];
    match face {
        0 => [w, u, v],
        1 => [-u, w, v],
        2 => [-w, -u, v],
        3 => [u, -w, v],
        4 => [-v, u, w],
        _ => [v, u, -w],
    }
}

/// Latitudes and longitudes in degrees.
pub struct LatLons {
    /// Latitude.
    pub lat: Vec<f64>,
    /// Longitude in [−180, 180].
    pub lon: Vec<f64>,
}

/// Random: uniform on the sphere. Scan: a raster twice as wide as high, row after row from the north, cell centres.
pub fn lat_lons(order: Order, n: usize) -> LatLons {
    let mut random = Random::new(3);
    let rows = (n as f64 / 2.0).sqrt().ceil() as usize;
    let (lat, lon) = (0..n)
        .map(|i| match order {
            Order::Random => lat_lon(random.vector()),
            Order::Scan => (
                90.0 - 180.0 * ((i / (2 * rows)) as f64 + 0.5) / rows as f64,
                180.0 * ((i % (2 * rows)) as f64 + 0.5) / rows as f64 - 180.0,
            ),
        })
        .unzip();
    LatLons { lat, lon }
}

fn lat_lon([x, y, z]: [f64; 3]) -> (f64, f64) {
    (z.atan2(x.hypot(y)).to_degrees(), y.atan2(x).to_degrees())
}

/// Pairs of places in degrees, for the inverse geodesic problem.
pub struct Pairs {
    /// Latitude of the first.
    pub lat1: Vec<f64>,
    /// Longitude of the first.
    pub lon1: Vec<f64>,
    /// Latitude of the second.
    pub lat2: Vec<f64>,
    /// Longitude of the second.
    pub lon2: Vec<f64>,
}

/// How the second place of a pair is chosen.
#[derive(Clone, Copy, PartialEq)]
pub enum Pairing {
    /// Both uniform on the sphere.
    Random,
    /// From one place to a raster in scan order.
    Scan,
    /// Random, but 20 % within 0.5° of the antipode, scattered among the others.
    AntipodalMix,
    /// All within 0.5° of the antipode.
    Antipodal,
    /// The second place is the first.
    Identical,
    /// Random longitudes, both places on the equator.
    Equator,
    /// Random, with longitudes of 0° to 360°.
    FullTurn,
}

impl Pairing {
    /// What rivals are timed on, too.
    pub const COMMON: [Self; 4] = [Self::Random, Self::Scan, Self::AntipodalMix, Self::Antipodal];

    /// Data as it also comes: to be computed about as fast as random pairs.
    pub const SPECIAL: [Self; 3] = [Self::Identical, Self::Equator, Self::FullTurn];

    /// The words for a record's `input`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Random => "random",
            Self::Scan => "scan",
            Self::AntipodalMix => "antipodal mix",
            Self::Antipodal => "antipodal",
            Self::Identical => "identical",
            Self::Equator => "equator",
            Self::FullTurn => "0 to 360",
        }
    }
}

/// Where lines in scan order begin, in degrees.
const HOME: (f64, f64) = (48.25, 11.5);

/// Pairs of places.
pub fn pairs(pairing: Pairing, n: usize) -> Pairs {
    let mut random = Random::new(4);
    let raster = lat_lons(Order::Scan, n);
    let share = match pairing {
        Pairing::AntipodalMix => 0.2,
        Pairing::Antipodal => 1.0,
        _ => 0.0,
    };
    let mut pair = |i: usize| {
        if pairing == Pairing::Scan {
            return (HOME, (raster.lat[i], raster.lon[i]));
        }
        let (from, other) = (random.vector(), random.vector());
        let to = if random.unit() < share {
            // `other`, made perpendicular, is a random direction to stray in.
            let dot: f64 = (0..3).map(|k| from[k] * other[k]).sum();
            let side: [f64; 3] = std::array::from_fn(|k| other[k] - dot * from[k]);
            let stray = 0.5_f64.to_radians() * random.unit().sqrt() / (1.0 - dot * dot).sqrt();
            std::array::from_fn(|k| stray.cos() * -from[k] + stray.sin() * side[k])
        } else {
            other
        };
        let ((lat1, lon1), (lat2, lon2)) = (lat_lon(from), lat_lon(to));
        match pairing {
            Pairing::Identical => ((lat1, lon1), (lat1, lon1)),
            Pairing::Equator => ((0.0, lon1), (0.0, lon2)),
            Pairing::FullTurn => ((lat1, lon1 + 180.0), (lat2, lon2 + 180.0)),
            _ => ((lat1, lon1), (lat2, lon2)),
        }
    };
    let ((lat1, lon1), (lat2, lon2)) = (0..n).map(&mut pair).unzip();
    Pairs { lat1, lon1, lat2, lon2 }
}

/// Lines, for the direct geodesic problem.
pub struct Lines {
    /// Latitude in degrees.
    pub lat: Vec<f64>,
    /// Longitude in degrees.
    pub lon: Vec<f64>,
    /// Azimuth in degrees, in [−180, 180].
    pub azimuth: Vec<f64>,
    /// Length in metres, up to 20 000 km.
    pub distance: Vec<f64>,
}

/// Random: starts uniform on the sphere, azimuth and length uniform. Scan: from one place, length after length,
/// each round the compass.
pub fn lines(order: Order, n: usize) -> Lines {
    let mut random = Random::new(5);
    let raster = lat_lons(Order::Scan, n);
    let ((lat, lon), (azimuth, distance)) = (0..n)
        .map(|i| match order {
            Order::Random => (
                lat_lon(random.vector()),
                (random.within(-180.0, 180.0), random.within(0.0, 2e7)),
            ),
            Order::Scan => (HOME, (raster.lon[i], 2e7 * (90.0 - raster.lat[i]) / 180.0)),
        })
        .unzip();
    Lines {
        lat,
        lon,
        azimuth,
        distance,
    }
}

/// Places with height, and the same in Earth axes on WGS84.
pub struct Positions {
    /// Latitude in degrees.
    pub lat: Vec<f64>,
    /// Longitude in degrees.
    pub lon: Vec<f64>,
    /// Height in metres: −5 km to 20 km, one in eight up to 50 000 km.
    pub height: Vec<f64>,
    /// Earth axes, metres.
    pub x: Vec<f64>,
    /// Earth axes, metres.
    pub y: Vec<f64>,
    /// Earth axes, metres.
    pub z: Vec<f64>,
}

/// Over the places of [`lat_lons`]. Random: one height in eight is log-uniform from 20 km to 50 000 km, the others are
/// uniform. Scan: the height rises through both ranges from row to row, the same along a row.
pub fn positions(order: Order, n: usize) -> Positions {
    let mut random = Random::new(6);
    let LatLons { lat, lon } = lat_lons(order, n);
    let rise = |low: f64, at: f64| match low < 0.125 {
        true => 2e4 * 2500_f64.powf(at),
        false => -5e3 + 2.5e4 * at,
    };
    let height: Vec<f64> = (0..n)
        .map(|i| match order {
            Order::Random => rise(random.unit(), random.unit()),
            Order::Scan => {
                let at = (90.0 - lat[i]) / 180.0;
                rise(at, if at < 0.125 { at * 8.0 } else { (at - 0.125) / 0.875 })
            }
        })
        .collect();
    let e2 = WGS84_F * (2.0 - WGS84_F);
    let earth_axes = |i: usize| {
        let ((sin, cos), (sin_lon, cos_lon)) = (lat[i].to_radians().sin_cos(), lon[i].to_radians().sin_cos());
        let across = WGS84_A / (1.0 - e2 * sin * sin).sqrt();
        let r = (across + height[i]) * cos;
        ((r * cos_lon, r * sin_lon), (across * (1.0 - e2) + height[i]) * sin)
    };
    let ((x, y), z) = (0..n).map(earth_axes).unzip();
    Positions {
        lat,
        lon,
        height,
        x,
        y,
        z,
    }
}
