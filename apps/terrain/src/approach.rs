//! The way down: where the eye is in each frame, and what it looks at.

use terrella::terrain::{Camera, InvalidCamera};
use terrella::{Ecef, Ellipsoid, Enu, LatLon, LocalFrame};

use crate::elevation::Elevation;

/// What is looked at: a valley of the Cumberland Mountains.
const AIM: [f64; 2] = [36.505, -84.205];

/// Where the light comes from, at the aim, as on maps: degrees clockwise from north, and up.
const SUN: [f64; 2] = [315.0, 42.0];

/// From the middle of the picture to its upper edge, in degrees.
const HALF_VIEW: f64 = 25.0;

/// Width to height.
pub const ASPECT: [u32; 2] = [8, 5];

/// Metres above the ground, degrees from straight down, and degrees clockwise from north.
pub const STATIONS: [[f64; 3]; 10] = [
    [1.0e7, 0.0, 0.0],
    [3.0e6, 5.0, 0.0],
    [1.0e6, 15.0, 0.0],
    [3.0e5, 15.0, 0.0],
    [1.0e5, 20.0, -10.0],
    [3.0e4, 40.0, -30.0],
    [1.0e4, 58.0, -50.0],
    [3.0e3, 68.0, -70.0],
    [1.0e3, 74.0, -90.0],
    [2.0e2, 80.0, -110.0],
];

/// What is seen from a station.
pub struct View {
    /// Metres above the ground.
    pub height: f64,
    pub eye: Ecef<f64>,
    /// To the right, up and forward, in Earth axes, the first two as long as half of the picture at a distance of 1.
    pub axes: [[f64; 3]; 3],
    /// The direction of the sun.
    pub sun: [f64; 3],
}

impl View {
    /// From a station above the ground.
    pub fn new(earth: Ellipsoid<f64>, elevation: &Elevation, station: [f64; 3]) -> Result<Self, String> {
        let [height, tilt, azimuth] = station;
        let place = aim().map_err(|error| error.to_string())?;
        let (ground, _) = elevation.at(place);
        let at = terrella::Geodetic::new(place, ground).map_err(|error| error.to_string())?;
        let frame = LocalFrame::new(earth, at);
        let ([sin, cos], [east, north]) = (sin_cos(tilt), sin_cos(azimuth));
        let vector = |right: f64, ahead: f64, up: f64| {
            frame.vector_from_enu(Enu {
                east: right * north + ahead * east,
                north: ahead * north - right * east,
                up,
            })
        };
        let forward = vector(0.0, sin, -cos);
        let origin = frame.origin_ecef().to_array();
        let back = |distance: f64| {
            let [x, y, z] = std::array::from_fn(|axis| origin[axis] - distance * forward[axis]);
            Ecef::new(x, y, z).map_err(|error| error.to_string())
        };
        // The distance at which the eye is as high above the ground as it should be.
        let (mut near, mut far) = (0.0, 4.0 * height / cos);
        for _ in 0..60 {
            let middle = 0.5 * (near + far);
            let eye = earth.to_geodetic(back(middle)?);
            let above = eye.height() - elevation.at(eye.lat_lon()).0;
            *(if above < height { &mut near } else { &mut far }) = middle;
        }
        let half = HALF_VIEW.to_radians().tan();
        let wide = half * f64::from(ASPECT[0]) / f64::from(ASPECT[1]);
        let ([sun_east, sun_north], [sun_up, sun_out]) = (sin_cos(SUN[0]), sin_cos(SUN[1]));
        Ok(Self {
            height,
            eye: back(far)?,
            axes: [
                vector(1.0, 0.0, 0.0).map(|v| v * wide),
                vector(0.0, cos, sin).map(|v| v * half),
                forward,
            ],
            sun: frame.vector_from_enu(Enu {
                east: sun_east * sun_out,
                north: sun_north * sun_out,
                up: sun_up,
            }),
        })
    }

    /// The rows of the matrix for x, y and w.
    pub fn rows(&self) -> [[f64; 3]; 3] {
        let [right, up, forward] = self.axes;
        let scaled = |axis: [f64; 3]| axis.map(|v| v / dot(axis, axis));
        [scaled(right), scaled(up), forward]
    }

    /// For the selection of tiles.
    pub fn camera(&self, [width, height]: [u32; 2]) -> Result<Camera<f64>, InvalidCamera<f64>> {
        let [x, y, w] = self.rows().map(|[a, b, c]| [a, b, c, 0.0]);
        Camera::new(self.eye, [x, y, [0.0; 4], w], [f64::from(width), f64::from(height)])
    }
}

/// The place that is looked at.
pub fn aim() -> Result<LatLon<f64>, terrella::InvalidLatLon<f64>> {
    LatLon::new(AIM[0], AIM[1])
}

fn sin_cos(degrees: f64) -> [f64; 2] {
    let (sin, cos) = degrees.to_radians().sin_cos();
    [sin, cos]
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
