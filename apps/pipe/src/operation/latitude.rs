//! Auxiliary latitudes.

use terrella::latitude::Conversion;

use super::{Answer, Failure, Group, answer, group};
use crate::options::Latitudes;
use crate::read::Number;

pub const GROUP: Group = group! {
    "Auxiliary latitudes":
    "latitude" "latitude -> another of the same place; the isometric one is dimensionless", latitude(Latitudes);
};

fn latitude<T: Number>(options: Latitudes) -> Result<Answer, Failure> {
    let Latitudes { from, to, .. } = options;
    let conversion = Conversion::<T>::new(options.planet.ellipsoid()?, from, to)?;
    let convert = if options.radians {
        Conversion::radians
    } else {
        Conversion::degrees
    };
    answer(move |latitude: T| Ok(convert(&conversion, latitude)?))
}
