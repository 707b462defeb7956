//! Cells of Google's S2: tiles by the curve, the faces' numbers and the axes of S2.

use std::collections::BTreeSet;

use terrella::cube::{Corner, CubeProjection, Edge, Numbering, Projection};
use terrella::terrain::{Hilbert, InvalidTile, Key, Tile};
use terrella::{Direction, LatLon};

use super::{Answer, Failure, Group, answer, group};
use crate::options::{Cells, Nothing};
use crate::read::{Count, Fields, Number, Read};
use crate::write::{Columns, Row};

pub const GROUP: Group = group! {
    "Cells of S2, written as ids of 16 hexadecimal digits":
    "cell" "lat lon level -> the cell there, of the sphere", of_place(Cells);
    "cell-xyz" "X Y Z level -> the cell there", of_vector(Cells);
    "cell-st" "face s t level -> the cell there, s and t in [0, 1]", of_st(Nothing);
    "cell-ij" "face i j level -> the cell of a column and a row", of_ij(Nothing);
    "cell-info" "token -> face level i j, X Y Z and lat lon of the centre", info(Cells);
    "cell-parent" "token [level] -> its parent, or its ancestor of a level", parent(Nothing);
    "cell-tile-parent" "token -> the token of its parent", parent_token(Nothing);
    "cell-children" "token -> its children", children(Nothing);
    "cell-range" "token -> the first and the last leaf in it", range(Nothing);
    "cell-contains"
        "token token -> 1 if the first holds the second, 0 if not: by keys, and by tiles", contains(Nothing);
    "cell-edges-ordered" "token -> its neighbours below, to the right, above and to the left", edges(Nothing);
    "cell-all" "token level -> all cells of the level around it, at most 10 levels finer", around(Nothing);
    "cell-vertex" "token level -> the cells of a coarser level around the vertex nearest to it", vertex(Nothing);
    "cell-corners" "token -> X Y Z of its corners, counter-clockwise from (1, 1) of this crate's axes", corners(Cells);
    "cell-area" "token -> steradians between the great circles through its corners", area(Cells);
    "token" "token, %XX for what is no letter or digit -> id", id(Nothing);
    "key" "id -> token", token(Nothing);
    "s2-st" "X Y Z of any length -> S2's face s t, s and t in [0, 1]", st(Cells);
    "s2-xyz" "S2's face s t -> X Y Z on the unit sphere", of_face(Cells);
};

pub(super) type Cell = Key<Hilbert>;

/// How many levels finer the cells around another can be: 2¹⁰ of them along each edge.
const FINER: u8 = 10;

/// A cell as its token.
impl Read for Cell {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        Ok(decoded(fields.text()?)?.parse()?)
    }
}

/// A cell as its id.
struct Id(Cell);

impl Read for Id {
    const COLUMNS: Count = Count::exactly(1);

    fn read(fields: &mut Fields) -> Result<Self, Failure> {
        let text = fields.text()?;
        let bits = u64::from_str_radix(text, 16).map_err(|_| format!("{text:?} is no id"))?;
        Ok(Self(Key::new(bits)?))
    }
}

/// As its id.
impl Row for Cell {
    fn write(&self, columns: &mut Columns) -> std::fmt::Result {
        columns.put(format_args!("{:016x}", self.bits()))
    }
}

/// As its token.
pub(super) struct Token(pub Cell);

impl Row for Token {
    fn write(&self, columns: &mut Columns) -> std::fmt::Result {
        columns.put(self.0)
    }
}

/// A text in which %XX stands for the byte XX.
fn decoded(text: &str) -> Result<String, Failure> {
    let mut parts = text.split('%');
    let mut bytes = parts.next().unwrap_or_default().as_bytes().to_vec();
    for part in parts {
        let (byte, rest) = part.split_at_checked(2).ok_or("% without two digits")?;
        bytes.push(u8::from_str_radix(byte, 16).map_err(|_| "% without two digits")?);
        bytes.extend_from_slice(rest.as_bytes());
    }
    Ok(String::from_utf8(bytes)?)
}

/// The cell of a direction: S2's own choice with S2's projection, the tile with another.
fn cell_of<T: Number>(projection: Projection, direction: Direction<T>, level: u8) -> Result<Cell, Failure> {
    if projection == Projection::S2Quadratic {
        return ancestor(Key::s2_leaf_of(direction.to_array().map(Into::into))?, level);
    }
    Ok(Tile::containing(projection.project(direction), level)?.into())
}

fn ancestor(cell: Cell, level: u8) -> Result<Cell, Failure> {
    if level > Tile::MAX_LEVEL {
        return Err(InvalidTile::Level(level).into());
    }
    let finer = || format!("level {level} is finer than the cell's, {}", cell.level());
    Ok(cell.ancestor(level).ok_or_else(finer)?)
}

fn sorted(tiles: impl IntoIterator<Item = Tile>) -> Vec<Cell> {
    let cells: BTreeSet<_> = tiles.into_iter().map(Cell::from).collect();
    cells.into_iter().collect()
}

fn of_place<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    answer(move |(place, level): (LatLon<T>, u8)| cell_of(projection, place.to_direction(), level))
}

fn of_vector<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    answer(move |(vector, level): ([T; 3], u8)| {
        if projection == Projection::S2Quadratic {
            return ancestor(Key::s2_leaf_of(vector.map(Into::into))?, level);
        }
        let [x, y, z] = vector;
        cell_of(projection, Direction::new(x, y, z)?, level)
    })
}

fn of_st<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(face, st, level): (u8, [T; 2], u8)| ancestor(Key::s2_leaf_at(face, st.map(Into::into))?, level))
}

fn of_ij<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(face, [i, j], level): (u8, [u32; 2], u8)| {
        Ok(Cell::from(Tile::from_numbering(Numbering::S2, face, level, i, j)?))
    })
}

fn info<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    answer(move |cell: Cell| {
        let tile = Tile::from(cell);
        let (face, i, j) = tile.to_numbering(Numbering::S2);
        let centre: Direction<T> = projection.unproject(tile.centre());
        Ok(([face, tile.level()], [i, j], centre, centre.to_lat_lon()))
    })
}

fn parent<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(cell, level): (Cell, Option<u8>)| match level {
        Some(level) => ancestor(cell, level),
        None => Ok(tile_parent(cell)?.into()),
    })
}

fn parent_token<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|cell: Cell| Ok(Token(tile_parent(cell)?.into())))
}

fn tile_parent(cell: Cell) -> Result<Tile, Failure> {
    Ok(Tile::from(cell).parent().ok_or("a face has no parent")?)
}

fn children<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|cell: Cell| Ok(sorted(Tile::from(cell).children().ok_or("a leaf has no children")?)))
}

fn range<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|cell: Cell| {
        let (first, last) = cell.range().into_inner();
        Ok([first, last])
    })
}

fn contains<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|[outer, inner]: [Cell; 2]| Ok([outer.contains(inner), Tile::from(outer).contains(inner.into())]))
}

fn edges<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|cell: Cell| Ok(cell.s2_edge_neighbours()))
}

fn around<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(cell, level): (Cell, u8)| {
        if level > cell.level() + FINER {
            return Err(format!(
                "level {level} is more than {FINER} finer than the cell's, {}",
                cell.level()
            )
            .into());
        }
        let tile = Tile::from(cell);
        let mut tiles = Vec::new();
        for edge in Edge::ALL {
            tiles.extend(tile.neighbours(edge, level)?);
        }
        for corner in Corner::ALL {
            tiles.extend(tile.diagonal_at(corner, level)?.map(|beyond| beyond.tile));
        }
        Ok(sorted(tiles))
    })
}

fn vertex<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(cell, level): (Cell, u8)| {
        let coarser = || format!("level {level} is not coarser than the cell's, {}", cell.level());
        let around = Tile::from(cell).around_nearest(level).ok_or_else(coarser)?;
        Ok(sorted(around.as_slice().iter().map(|&(tile, _)| tile)))
    })
}

fn corners<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    answer(move |cell: Cell| {
        let corners = Tile::from(cell).corners::<T>();
        Ok(corners.map(|corner| projection.unproject(corner)))
    })
}

fn area<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    answer(move |cell: Cell| Ok(Tile::from(cell).solid_angle::<T>(projection)))
}

fn id<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|cell: Cell| Ok(cell))
}

fn token<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|Id(cell): Id| Ok(Token(cell)))
}

fn st<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    let half = T::of(0.5);
    answer(move |direction: Direction<T>| {
        let (face, u, v) = Numbering::S2.to_point(projection.project(direction));
        Ok((face, [u, v].map(|u| half * u + half)))
    })
}

fn of_face<T: Number>(Cells { projection }: Cells) -> Result<Answer, Failure> {
    let two = T::of(2.0);
    answer(move |(face, [s, t]): (u8, [T; 2])| {
        let point = Numbering::S2.from_point(face, two * s - T::ONE, two * t - T::ONE)?;
        Ok(projection.unproject(point))
    })
}
