//! The vertices of a tile, from the eye: in single precision as a renderer would have them, in double precision for the truth, and for contrast in
//! single precision without the crate, and with heights along a sphere's normal.
//!
//! A mesh is the tile's samples and a rim around them: the edge again, lowered by a skirt that hides the gaps to coarser neighbours.

use terrella::cube::{CubeMap, Projection};
use terrella::terrain::{Base, Patches, Tile};
use terrella::{Ecef, Geodetic};

use crate::ground::{Ground, SAMPLES};
use crate::scalar::{Scalar, dot, lowered, normalised};

/// Vertices along the edge of a mesh.
pub const ACROSS: u32 = SAMPLES + 2;

/// Vertices in rows from below.
pub struct Mesh<T> {
    /// Metres from the eye, in Earth axes.
    pub vertices: Vec<[T; 3]>,
    /// The normal of the ellipsoid.
    pub normals: Vec<[T; 3]>,
    /// The normal of the terrain.
    pub slopes: Vec<[T; 3]>,
}

impl<T: Scalar> Mesh<T> {
    fn new(ground: &Ground, mut vertex: impl FnMut(usize, [u32; 2], bool) -> ([T; 3], [T; 3])) -> Self {
        let mut mesh = Self {
            vertices: Vec::new(),
            normals: Vec::new(),
            slopes: Vec::new(),
        };
        for index in 0..ACROSS * ACROSS {
            let ([m, n], is_rim) = node(index);
            let sample = (n * SAMPLES + m) as usize;
            let (vertex, normal) = vertex(sample, [m, n], is_rim);
            mesh.vertices.push(vertex);
            mesh.normals.push(normal);
            mesh.slopes
                .push(tilted(normal, ground.slopes[sample].map(T::from_double)));
        }
        mesh
    }
}

/// The sample of a mesh's vertex, and whether it is the lowered one of the rim.
pub fn node(index: u32) -> ([u32; 2], bool) {
    let place = [index % ACROSS, index / ACROSS];
    let node = place.map(|k| k.saturating_sub(1).min(SAMPLES - 1));
    (node, place.iter().zip(node).any(|(&k, n)| k != n + 1))
}

/// By the crate: bilinear patch, displacement and normal, from corners relative to the eye; all of it in single precision.
pub fn single(
    patches: &Patches<Projection>,
    tile: Tile,
    ground: &Ground,
    eye: Ecef<f64>,
    skirt: f64,
) -> Result<Mesh<f32>, String> {
    let count = ground.heights.len();
    let [mut ox, mut oy, mut oz] = [0; 3].map(|_| vec![0.0_f32; count]);
    let [mut nx, mut ny, mut nz] = [0; 3].map(|_| vec![0.0_f32; count]);
    // The ground in the corners: neighbours have the same.
    let last = SAMPLES - 1;
    let corners = [[last, last], [0, last], [0, 0], [last, 0]];
    let base = Base::new(corners.map(|[m, n]| ground.heights[(n * SAMPLES + m) as usize]));
    let base = base.map_err(|error| error.to_string())?;
    let patch = patches
        .fill(
            tile,
            base,
            SAMPLES,
            [&mut ox, &mut oy, &mut oz],
            [&mut nx, &mut ny, &mut nz],
        )
        .map_err(|error| error.to_string())?;
    let seen = patch.seen_from(eye);
    Ok(Mesh::new(ground, |i, place, is_rim| {
        let (displacement, normal) = ([ox[i], oy[i], oz[i]], [nx[i], ny[i], nz[i]]);
        let height = ground.heights[i] - base.at(place, SAMPLES) - if is_rim { skirt } else { 0.0 };
        (seen.at(place, SAMPLES, displacement, normal, height as f32), normal)
    }))
}

/// Without corners and patches, for contrast: Earth-centred coordinates in single precision, less the eye in single precision.
pub fn naive(truth: &Mesh<f64>, eye: Ecef<f64>) -> Mesh<f32> {
    let eye = eye.to_array();
    let rounded = |vertex: &[f64; 3]| std::array::from_fn(|k| (vertex[k] + eye[k]) as f32 - eye[k] as f32);
    Mesh {
        vertices: truth.vertices.iter().map(rounded).collect(),
        normals: truth.normals.iter().copied().map(lowered).collect(),
        slopes: truth.slopes.iter().copied().map(lowered).collect(),
    }
}

/// By the definition: latitude, longitude and height to Earth-centred coordinates, less the eye; all of it in double precision.
pub fn double(map: &CubeMap<f64, Projection>, ground: &Ground, eye: Ecef<f64>, skirt: f64) -> Mesh<f64> {
    along(map, ground, eye, skirt, |place| place.to_direction().to_array())
}

/// In double precision, but with heights along the normal of the sphere that the cube is mapped to.
pub fn leaning(map: &CubeMap<f64, Projection>, ground: &Ground, eye: Ecef<f64>, skirt: f64) -> Mesh<f64> {
    along(map, ground, eye, skirt, |place| {
        map.shifted().to_direction(place).to_array()
    })
}

fn along(
    map: &CubeMap<f64, Projection>,
    ground: &Ground,
    eye: Ecef<f64>,
    skirt: f64,
    upward: impl Fn(terrella::LatLon<f64>) -> [f64; 3],
) -> Mesh<f64> {
    let earth = map.shifted().ellipsoid();
    let eye = eye.to_array();
    Mesh::new(ground, |i, _, is_rim| {
        let place = ground.places[i];
        let foot = earth.to_ecef(Geodetic::from(place)).to_array();
        let upward = upward(place);
        let height = ground.heights[i] - if is_rim { skirt } else { 0.0 };
        let vertex = std::array::from_fn(|k| (foot[k] - eye[k]) + height * upward[k]);
        (vertex, place.to_direction().to_array())
    })
}

/// The normal of ground that rises by so much toward east and north.
fn tilted<T: Scalar>(normal: [T; 3], [east, north]: [T; 2]) -> [T; 3] {
    let [x, y, z] = normal;
    let out = (x * x + y * y).sqrt();
    // At a pole there is no east.
    if out == T::ZERO || (east == T::ZERO && north == T::ZERO) {
        return normal;
    }
    let [cos, sin] = [x / out, y / out];
    let to_east = [-sin, cos, T::ZERO];
    let to_north = [-(z * cos), -(z * sin), out];
    normalised(std::array::from_fn(|k| {
        normal[k] - east * to_east[k] - north * to_north[k]
    }))
}

/// How far a vertex is from the eye, in metres.
pub fn distance(vertex: [f64; 3]) -> f64 {
    dot(vertex, vertex).sqrt()
}
