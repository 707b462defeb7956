//! What the planet hides.

use terrella::Ecef;
use terrella::terrain::Horizon;

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Horizon":
    "horizon"
        "lowest ground, X Y Z of the eye, X Y Z of a place -> 1 if the planet hides it, 0 if not", horizon(Planet);
};

fn horizon<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let ellipsoid = planet.ellipsoid::<T>()?;
    answer(move |(lowest, eye, place): (T, Ecef<T>, Ecef<T>)| Ok(Horizon::new(ellipsoid, lowest, eye).hides(place)))
}
