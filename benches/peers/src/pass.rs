//! A pass of a library's function over a set of points, and the set itself.

use std::array::from_fn;
use std::ops::Range;

/// Points: up to four coordinates, and a face where one is known or wanted.
#[derive(Clone, Default)]
pub struct Set {
    /// 0 to 5.
    pub face: Vec<u8>,
    /// The coordinates, each of the same length.
    pub columns: Vec<Vec<f64>>,
}

impl Set {
    /// Points without faces.
    pub fn new(columns: Vec<Vec<f64>>) -> Self {
        Self {
            face: vec![0; columns[0].len()],
            columns,
        }
    }

    /// Points on faces.
    pub fn on(face: Vec<u8>, columns: Vec<Vec<f64>>) -> Self {
        Self { face, columns }
    }

    /// Room for the results of `n` points.
    pub fn room(n: usize) -> Self {
        Self {
            face: vec![0; n],
            columns: vec![vec![f64::NAN; n]; 3],
        }
    }

    /// How many.
    pub fn len(&self) -> usize {
        self.face.len()
    }

    /// A column changed: for other units.
    pub fn map(mut self, column: usize, change: impl Fn(f64) -> f64) -> Self {
        self.columns[column]
            .iter_mut()
            .for_each(|value| *value = change(*value));
        self
    }

    /// The same points, those of a face together.
    pub fn sorted_by_face(&self) -> Self {
        let mut order: Vec<usize> = (0..self.len()).collect();
        order.sort_by_key(|&i| self.face[i]);
        Self {
            face: order.iter().map(|&i| self.face[i]).collect(),
            columns: self
                .columns
                .iter()
                .map(|column| order.iter().map(|&i| column[i]).collect())
                .collect(),
        }
    }
}

/// Reads the points of the first set that the range tells, fills the second. A point that fails gives a first result that is not finite.
pub type Pass = Box<dyn Fn(&Set, &mut Set, Range<usize>)>;

/// The pass that calls `function` once per point: `I` coordinates in, `O` results out.
pub fn each<const I: usize, const O: usize>(function: impl Fn([f64; I]) -> [f64; O] + 'static) -> Pass {
    Box::new(move |set, room, range| {
        let n = range.len();
        let inputs: [&[f64]; I] = from_fn(|k| &set.columns[k][range.clone()]);
        let mut columns = room.columns.iter_mut();
        let outputs: [&mut [f64]; O] = from_fn(|_| &mut columns.next().expect("three columns of room")[range.clone()]);
        for i in 0..n {
            let results = function(from_fn(|k| inputs[k][i]));
            for k in 0..O {
                outputs[k][i] = results[k];
            }
        }
    })
}
