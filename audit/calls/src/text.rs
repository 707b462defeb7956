use terrella::LatLon;
use terrella::grid::web_mercator::{BeyondTiles, InvalidTile, Tile};
use terrella::grid::{self, Geohash, InvalidGeohash, InvalidPlusCode, PlusCode};

use crate::{Arguments, Bits, Hash, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.below(16) as u8);
    visitor.function::<T, _, _>("Geohash::containing", draw, |(place, length)| {
        Geohash::containing(place, length).map(|cell| {
            let around = [Geohash::neighbour(cell, -1, 2), Geohash::parent(cell)];
            (
                (Geohash::bounds::<T>(cell), Geohash::centre::<T>(cell)),
                (Geohash::length(cell), around, Geohash::neighbours(cell)),
            )
        })
    });
    visitor.function::<T, _, _>("PlusCode::containing", draw, |(place, length)| {
        PlusCode::containing(place, length)
    });
    let texts = [
        "7FG49QCJ+2V", "CFX30000+", "9QCJ+2VX", "+G6", "8FWC2345+A6", "G+", "22222222+22", "12",
    ];
    let draw = move |arguments: &mut Arguments| {
        let text = texts.get(arguments.below(8) as usize).copied().unwrap_or_default();
        (text, arguments.place::<T>())
    };
    visitor.function::<T, _, _>("PlusCode::recovered", draw, |(text, near)| {
        PlusCode::recovered(text, near)
    });
    let draw = |arguments: &mut Arguments| (arguments.short::<T>(), arguments.below(16) as u8);
    visitor.function::<T, _, _>("PlusCode::shortened", draw, |([place, near], length)| {
        let code = PlusCode::containing(place, length)?;
        Ok::<_, InvalidPlusCode>(PlusCode::shortened(code, near).is_some())
    });
    web_mercator::<T, V>(visitor);
}

fn web_mercator<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>("grid::web_mercator::to_plane", Arguments::place::<T>, |place| {
        grid::web_mercator::to_plane(place)
    });
    let point = |arguments: &mut Arguments| arguments.units::<T, 2>().map(|unit| unit * T::of(2e7));
    visitor.function::<T, _, _>("grid::web_mercator::from_plane", point, |point| {
        grid::web_mercator::from_plane(point)
    });
    let draw = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.below(32) as u8);
    visitor.function::<T, _, _>("web_mercator::Tile::containing", draw, |(place, zoom)| {
        let resolution = grid::web_mercator::resolution(zoom, LatLon::lat(place));
        (
            resolution,
            Tile::containing(place, zoom).map(|tile| (tile, Tile::bounds::<T>(tile))),
        )
    });
    let draw = |arguments: &mut Arguments| {
        let [x, y] = [(); 2].map(|()| arguments.below(1 << 20) as u32);
        (arguments.below(32) as u8, x, y)
    };
    visitor.function::<T, _, _>("web_mercator::Tile::new", draw, |(zoom, x, y)| {
        let tile = Tile::new(zoom, x, y)?;
        Ok::<_, InvalidTile>((Tile::quadkey(tile).0, Tile::parent(tile), Tile::children(tile)))
    });
}

impl Bits for Geohash {
    fn add_to(&self, hash: &mut Hash) {
        (Geohash::bounds::<f32>(*self), Geohash::length(*self)).add_to(hash);
    }
}

impl Bits for PlusCode {
    fn add_to(&self, hash: &mut Hash) {
        let place = (PlusCode::bounds::<f32>(*self), PlusCode::centre::<f32>(*self));
        (place, PlusCode::length(*self)).add_to(hash);
    }
}

impl Bits for Tile {
    fn add_to(&self, hash: &mut Hash) {
        (Tile::zoom(*self), Tile::x(*self), Tile::y(*self)).add_to(hash);
    }
}

impl Bits for InvalidTile {
    fn add_to(&self, hash: &mut Hash) {
        (self.zoom, self.x, self.y).add_to(hash);
    }
}

impl<T: Scalar> Bits for BeyondTiles<T> {
    fn add_to(&self, hash: &mut Hash) {
        self.0.add_to(hash);
    }
}

impl Bits for InvalidGeohash {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Length(length) => (*length as u64, None),
            Self::Letter { at, found } => (*at as u64, Some(u32::from(*found))),
        }
        .add_to(hash);
    }
}

impl Bits for InvalidPlusCode {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Length(length) => (0, u64::from(*length)),
            Self::Separator { at } => (1, *at as u64),
            Self::Padding { at } => (2, *at as u64),
            Self::Digit { at, .. } => (3, *at as u64),
            Self::Short => (4_u8, 0),
            _ => (5, 0),
        }
        .add_to(hash);
    }
}
