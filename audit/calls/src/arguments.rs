use terrella::cube::{Face, FacePoint};
use terrella::{Direction, Ecef, Ellipsoid, Geodetic, LatLon, Real};

/// Arguments that need no library: a linear congruential generator (Knuth's MMIX) of multiples of 2⁻²³ in [−1, 1).
///
/// A scalar is made without a detour through the other one.
pub struct Arguments {
    state: u64,
    limits: bool,
}

impl Arguments {
    /// Ordinary arguments.
    #[must_use]
    pub fn new() -> Self {
        Self {
            state: 7,
            limits: false,
        }
    }

    /// With a limit in place of every eighth number or so: ±0, ±1, ±½, ±2⁻³⁰.
    #[must_use]
    pub fn with_limits() -> Self {
        Self {
            limits: true,
            ..Self::new()
        }
    }

    fn draw(&mut self) -> u64 {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        self.state >> 40
    }

    /// A number in [−1, 1).
    pub fn unit<T: Real>(&mut self) -> T {
        let drawn = self.draw();
        let number = T::whole(drawn) * T::of(1.0 / 8_388_608.0) - T::ONE;
        if !self.limits || !self.draw().is_multiple_of(8) {
            return number;
        }
        let limit = match drawn % 4 {
            0 => T::ZERO,
            1 => T::ONE,
            2 => T::of(0.5),
            _ => T::of(1.0 / 1_073_741_824.0),
        };
        limit.copysign(number)
    }

    /// Several numbers in [−1, 1).
    pub fn units<T: Real, const N: usize>(&mut self) -> [T; N] {
        [(); N].map(|()| self.unit())
    }

    /// A whole number below a limit of less than 2²⁴.
    pub fn below(&mut self, limit: u64) -> u64 {
        (self.draw() * limit) >> 24
    }

    /// Any place.
    pub fn place<T: Real>(&mut self) -> LatLon<T> {
        loop {
            let [lat, lon]: [T; 2] = self.units();
            if let Ok(place) = LatLon::new(lat * T::of(90.0), lon * T::of(180.0)) {
                return place;
            }
        }
    }

    /// Any two places.
    pub fn pair<T: Real>(&mut self) -> [LatLon<T>; 2] {
        [self.place(), self.place()]
    }

    /// Two places not farther apart than 0.1° in latitude and in longitude.
    pub fn short<T: Real>(&mut self) -> [LatLon<T>; 2] {
        let from = self.place::<T>();
        self.beside(from, from.lat(), from.lon(), T::of(0.1))
    }

    /// Two places, the second at most 0.5° from the first's antipode in latitude and in longitude.
    pub fn antipodal<T: Real>(&mut self) -> [LatLon<T>; 2] {
        let from = self.place::<T>();
        self.beside(from, -from.lat(), from.lon() + T::of(180.0), T::of(0.5))
    }

    fn beside<T: Real>(&mut self, from: LatLon<T>, lat: T, lon: T, spread: T) -> [LatLon<T>; 2] {
        loop {
            let [north, east]: [T; 2] = self.units();
            if let Ok(to) = LatLon::new(lat + spread * north, lon + spread * east) {
                return [from, to];
            }
        }
    }

    /// Any direction.
    pub fn direction<T: Real>(&mut self) -> Direction<T> {
        loop {
            let [x, y, z] = self.units();
            if let Ok(direction) = Direction::new(x, y, z) {
                return direction;
            }
        }
    }

    /// Any face.
    pub fn face(&mut self) -> Face {
        loop {
            if let Ok(face) = Face::from_index(self.below(6) as u8) {
                return face;
            }
        }
    }

    /// Any point of a face.
    pub fn face_point<T: Real>(&mut self) -> FacePoint<T> {
        loop {
            let [x, y] = self.units();
            if let Ok(point) = FacePoint::new(self.face(), x, y) {
                return point;
            }
        }
    }

    /// Any place up to 100 km high.
    pub fn geodetic<T: Real>(&mut self) -> Geodetic<T> {
        loop {
            let height = (self.unit::<T>() + T::ONE) * T::of(5e4);
            if let Ok(place) = Geodetic::new(self.place(), height) {
                return place;
            }
        }
    }

    /// Any point up to some 11 000 km from the Earth's centre.
    pub fn ecef<T: Real>(&mut self) -> Ecef<T> {
        loop {
            let [x, y, z] = self.units().map(|part: T| part * T::of(6.5e6));
            if let Ok(point) = Ecef::new(x, y, z) {
                return point;
            }
        }
    }

    /// Any ellipsoid with |f| ≤ 0.1.
    pub fn ellipsoid<T: Real>(&mut self) -> Ellipsoid<T> {
        loop {
            if let Ok(ellipsoid) = Ellipsoid::new(T::of(6.4e6), self.unit::<T>() * T::of(0.1)) {
                return ellipsoid;
            }
        }
    }
}

impl Default for Arguments {
    fn default() -> Self {
        Self::new()
    }
}
