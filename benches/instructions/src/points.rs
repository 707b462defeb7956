use terrella::cube::{Face, FacePoint};
use terrella::{Direction, Geodetic, LatLon, Real};

/// How many of each.
const COUNT: usize = 256;

/// Two places.
pub type Pair<T> = [LatLon<T>; 2];

/// What the functions are called with: the same in every run and on every machine.
pub struct Points<T> {
    /// Numbers in [−1, 1).
    pub units: Vec<[T; 2]>,
    /// Vectors no longer than 1.
    pub vectors: Vec<[T; 3]>,
    pub directions: Vec<Direction<T>>,
    pub face_points: Vec<FacePoint<T>>,
    /// Evenly on the sphere.
    pub places: Vec<LatLon<T>>,
    /// Up to 100 km high.
    pub geodetics: Vec<Geodetic<T>>,
    /// Two of the places.
    pub ordinary: Vec<Pair<T>>,
    /// At most 0.1° apart in latitude and in longitude.
    pub short: Vec<Pair<T>>,
    /// The second at most 0.5° from the first's antipode in latitude and in longitude.
    pub antipodal: Vec<Pair<T>>,
}

/// A linear congruential generator (Knuth's MMIX) of multiples of 2⁻²³ in [−1, 1).
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        f64::from((self.0 >> 40) as u32) / 8_388_608.0 - 1.0
    }

    fn vector(&mut self) -> [f64; 3] {
        loop {
            let [x, y, z] = [self.next(), self.next(), self.next()];
            if (0.01..=1.0).contains(&(x * x + y * y + z * z)) {
                return [x, y, z];
            }
        }
    }
}

fn many<T>(mut make: impl FnMut() -> T) -> Vec<T> {
    (0..COUNT).map(|_| make()).collect()
}

/// The places, each with one near a place that depends on it, by at most `spread` degrees of latitude and longitude.
fn beside<T: Real>(
    places: &[LatLon<T>],
    random: &mut Random,
    spread: f64,
    other: impl Fn(LatLon<T>) -> [T; 2],
) -> Vec<Pair<T>> {
    let mut beside = |place: LatLon<T>| {
        let [lat, lon] = other(place);
        loop {
            let lat = lat + T::of(spread * random.next());
            let lon = lon + T::of(spread * random.next());
            if let Ok(near) = LatLon::new(lat, lon) {
                return [place, near];
            }
        }
    };
    places.iter().map(|&place| beside(place)).collect()
}

impl<T: Real> Points<T> {
    pub fn new() -> Self {
        let mut random = Random(1600);
        let vectors = many(|| random.vector().map(T::of));
        let directions: Vec<_> = vectors
            .iter()
            .map(|&[x, y, z]| Direction::new(x, y, z).unwrap())
            .collect();
        let places: Vec<_> = directions.iter().map(|direction| direction.to_lat_lon()).collect();
        let units = many(|| [random.next(), random.next()].map(T::of));
        let mut faces = Face::ALL.iter().cycle();
        Self {
            face_points: units
                .iter()
                .map(|&[x, y]| FacePoint::new(*faces.next().unwrap(), x, y).unwrap())
                .collect(),
            geodetics: places
                .iter()
                .map(|&place| Geodetic::new(place, T::of(5e4 + 5e4 * random.next())).unwrap())
                .collect(),
            ordinary: places.iter().zip(places.iter().rev()).map(|(&a, &b)| [a, b]).collect(),
            short: beside(&places, &mut random, 0.1, |place| [place.lat(), place.lon()]),
            antipodal: beside(&places, &mut random, 0.5, |place| {
                [-place.lat(), place.lon() + T::of(180.0)]
            }),
            units,
            vectors,
            directions,
            places,
        }
    }
}
