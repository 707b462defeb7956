//! How far the vertices of two meshes are apart.

use testkit::maximum;

use crate::mesh::{Mesh, distance, node};
use crate::scalar::Scalar;

/// Nearer than this, the claim is a length; beyond, a part of the distance.
const NEAR: f64 = 1_000.0;

/// Of all vertices of the tiles of a frame.
#[derive(Default)]
pub struct Difference {
    /// The largest within 1 km of the eye, in metres.
    pub near: f64,
    /// The largest beyond, as a part of the distance.
    pub beyond: f64,
    /// All of them, in metres.
    lengths: Vec<f32>,
}

impl Difference {
    /// Takes in a mesh and its truth; returns what is between them for every vertex, in metres.
    pub fn add<T: Scalar + Into<f64>>(&mut self, mesh: &Mesh<T>, truth: &Mesh<f64>) -> Vec<f32> {
        let mut lengths = Vec::with_capacity(truth.vertices.len());
        for (index, (vertex, truth)) in mesh.vertices.iter().zip(&truth.vertices).enumerate() {
            let apart = distance(std::array::from_fn(|k| vertex[k].into() - truth[k]));
            lengths.push(apart as f32);
            let (_, is_rim) = node(index as u32);
            if is_rim {
                continue;
            }
            self.lengths.push(apart as f32);
            let away = distance(*truth);
            if away <= NEAR {
                self.near = maximum(self.near, apart);
            } else {
                self.beyond = maximum(self.beyond, apart / away);
            }
        }
        lengths
    }

    /// The largest, in metres.
    pub fn largest(&self) -> f64 {
        self.lengths.iter().copied().fold(0.0, maximum).into()
    }

    /// As many are larger as are smaller: metres.
    pub fn median(&self) -> f64 {
        let mut lengths = self.lengths.clone();
        let middle = lengths.len() / 2;
        if lengths.is_empty() {
            return 0.0;
        }
        let (_, median, _) = lengths.select_nth_unstable_by(middle, f32::total_cmp);
        f64::from(*median)
    }
}
