//! Places in rings of geodesics.

use std::fmt;

use terrella::LatLon;
use terrella::geodesic::Karney;
use terrella::route::{Fence, Side};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Planet;
use crate::read::Number;
use crate::write::{Columns, Row};

pub const GROUP: Group = group! {
    "Fences of geodesics":
    "contains" "lat lon, then lat lon of each corner of a ring -> inside, outside or edge", contains(Planet);
};

impl Row for Side {
    fn write(&self, columns: &mut Columns) -> fmt::Result {
        columns.put(self)
    }
}

fn contains<T: Number>(planet: Planet) -> Result<Answer, Failure> {
    let earth = Karney::new(planet.ellipsoid::<T>()?)?;
    answer(move |(place, ring): (LatLon<T>, Vec<LatLon<T>>)| Ok(Fence::new(&earth, &[&ring]).side(place)))
}
