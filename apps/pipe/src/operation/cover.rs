//! Tiles that cover a region, and what a tile covers.

use terrella::LatLon;
use terrella::geodesic::Karney;
use terrella::terrain::{Cap, Covering, LatLonBox, Region, Tile};

use super::cell::{Cell, Token};
use super::{Answer, Failure, Group, answer, group};
use crate::options::{Cover, Tiles};
use crate::read::Number;

pub const GROUP: Group = group! {
    "Coverings by tiles, written as tokens in the order of S2's ids":
    "cover"
        "south west north east -> the tiles that touch the box, or with --inner are inside", of_box(Cover);
    "cover-cap" "lat lon radius -> the same of what is within a distance on the ellipsoid", of_cap(Cover);
    "tile-bounds" "token -> south west north east, the longitudes -180 180 around a pole", bounds(Tiles);
    "tile-area" "token -> square metres on the ellipsoid", area(Tiles);
};

/// The most tiles of a line: 50 MB of tokens.
const MOST: usize = 1 << 22;

impl Cover {
    fn of<T: Number>(&self, region: impl Region<T> + Clone) -> Result<Vec<Token>, Failure> {
        let mut covering = Covering::new(self.tiles.map::<T>()?, region, self.level)?;
        if self.inner {
            covering = covering.inner();
        }
        if self.mixed {
            covering = covering.mixed();
        }
        if let Some(most) = self.most {
            covering = covering.of_at_most(most).ok_or("no level has so few tiles")?;
        }
        let mut cells: Vec<Cell> = covering.take(MOST + 1).map(Cell::from).collect();
        if cells.len() > MOST {
            return Err(format!("more than {MOST} tiles").into());
        }
        cells.sort();
        Ok(cells.into_iter().map(Token).collect())
    }
}

fn of_box<T: Number>(cover: Cover) -> Result<Answer, Failure> {
    answer(move |[south, west, north, east]: [T; 4]| cover.of(LatLonBox::new(south, west, north, east)?))
}

fn of_cap<T: Number>(cover: Cover) -> Result<Answer, Failure> {
    let method = Karney::new(cover.tiles.planet.ellipsoid::<T>()?)?;
    answer(move |(centre, radius): (LatLon<T>, T)| cover.of(Cap::new(method, centre, radius)?))
}

fn bounds<T: Number>(tiles: Tiles) -> Result<Answer, Failure> {
    let map = tiles.map::<T>()?;
    answer(move |cell: Cell| {
        let bounds = LatLonBox::of_tile(&map, cell.into());
        Ok([bounds.south(), bounds.west(), bounds.north(), bounds.east()])
    })
}

fn area<T: Number>(tiles: Tiles) -> Result<Answer, Failure> {
    let map = tiles.map::<T>()?;
    answer(move |cell: Cell| Ok(Tile::from(cell).area(&map)))
}
