//! Keys: against a loop over bits, and as a sorted table uses them.

use std::collections::BTreeSet;

use fastrand::Rng;
use terrella::cube::{Edge, Face, FacePoint};
use terrella::terrain::{Curve, Hilbert, InvalidKey, InvalidToken, Key, Morton, Tile};

use crate::sample;

#[test]
fn morton_keys_alternate_columns_and_rows() {
    let mut rng = Rng::with_seed(4);
    for _ in 0..100_000 {
        let tile = sample::tile(&mut rng);
        let mut bits = u64::from(tile.face().index());
        for level in (0..tile.level()).rev() {
            bits = bits << 2 | u64::from(tile.j() >> level & 1) << 1 | u64::from(tile.i() >> level & 1);
        }
        let key = Key::<Morton>::from(tile);
        assert_eq!(key.bits(), (bits << 1 | 1) << (2 * (30 - tile.level())), "{tile:?}");
        assert_eq!((Tile::from(key), key.level()), (tile, tile.level()));
        if let Some(children) = tile.children() {
            assert!(children.map(Key::<Morton>::from).is_sorted());
        }
    }
}

fn families<C: Curve>(seed: u64) {
    let mut rng = Rng::with_seed(seed);
    for _ in 0..50_000 {
        let tile = sample::tile(&mut rng);
        let key = Key::<C>::from(tile);
        assert_eq!(key.ancestor(key.level() + 1), None);
        let up = rng.u8(0..=key.level());
        assert_eq!(key.ancestor(up), Some(tile.ancestor(up).unwrap().into()));
        // A tile that may or may not be inside.
        let other = match rng.u8(0..3) {
            0 => sample::tile(&mut rng),
            1 => sample::tile_of(&mut rng, up),
            _ => {
                let down = rng.u8(0..=Tile::MAX_LEVEL - tile.level());
                let inside = |rng: &mut Rng, index: u32| (index << down) + rng.u32(0..1 << down);
                let (i, j) = (inside(&mut rng, tile.i()), inside(&mut rng, tile.j()));
                let level = tile.level() + down;
                Tile::new(tile.face(), level, i.saturating_sub(rng.u32(0..2)), j).unwrap()
            }
        };
        let other_key = Key::<C>::from(other);
        assert_eq!(key.contains(other_key), tile.contains(other), "{tile:?} {other:?}");
        assert_eq!(
            key.range().contains(&other_key),
            tile.contains(other),
            "{tile:?} {other:?}"
        );
        for end in [key.range().start(), key.range().end()] {
            assert_eq!(end.level(), Tile::MAX_LEVEL);
            assert!(tile.contains((*end).into()));
        }
    }
    // A sorted table finds what lies in a tile.
    let all: BTreeSet<Key<C>> = (0..20_000).map(|_| sample::tile(&mut rng).into()).collect();
    for _ in 0..200 {
        let level = rng.u8(0..4);
        let tile = sample::tile_of(&mut rng, level);
        let found: Vec<_> = all.range(Key::<C>::from(tile).range()).copied().collect();
        let sought: Vec<_> = all.iter().copied().filter(|&key| tile.contains(key.into())).collect();
        assert_eq!(found, sought);
    }
}

#[test]
fn a_range_holds_a_family() {
    families::<Morton>(5);
    families::<Hilbert>(6);
}

/// One step along Hilbert's curve crosses an edge, from face to face too, and from the last tile to the first.
#[test]
fn the_hilbert_curve_is_continuous() {
    let touch = |a: Tile, b: Tile| Edge::ALL.iter().any(|&edge| a.neighbour(edge).tile == b);
    for level in 0..=6 {
        let count = 1_u32 << level;
        let tiles = Face::ALL
            .into_iter()
            .flat_map(|face| (0..count * count).map(move |n| Tile::new(face, level, n % count, n / count).unwrap()));
        let keys: BTreeSet<Key<Hilbert>> = tiles.map(Key::from).collect();
        assert_eq!(keys.len(), 6 << (2 * level));
        let order: Vec<Tile> = keys.into_iter().map(Tile::from).collect();
        for (at, &tile) in order.iter().enumerate() {
            let next = order[(at + 1) % order.len()];
            assert!(touch(tile, next), "{tile:?} {next:?}");
        }
    }
    let mut rng = Rng::with_seed(7);
    for _ in 0..100_000 {
        let tile = sample::tile(&mut rng);
        let key = Key::<Hilbert>::from(tile).bits();
        let step = 2 * (key & key.wrapping_neg());
        if let Ok(next) = Key::<Hilbert>::new(key.wrapping_add(step)) {
            assert!(touch(tile, next.into()), "{tile:?} {next:?}");
        }
    }
}

#[test]
fn numbers_that_are_no_keys_are_refused() {
    for bits in [
        0,
        1 << 1,
        1 << 61,
        6 << 61 | 1,
        u64::MAX,
        0b110 << 61 | 1 << 60,
        1 << 59,
    ] {
        assert_eq!(Key::<Hilbert>::new(bits), Err(InvalidKey(bits)), "{bits:#x}");
    }
    assert_eq!(InvalidKey(2).to_string(), "0x0000000000000002 is not the key of a tile");
}

#[test]
fn texts_that_are_no_tokens_are_refused() {
    let parse = |token: &str| token.parse::<Key<Morton>>().unwrap_err();
    assert_eq!(parse(""), InvalidToken::Length(0));
    assert_eq!(parse("10000000000000000"), InvalidToken::Length(17));
    assert_eq!(parse("4g"), InvalidToken::Digit('g'));
    assert_eq!(parse("+1"), InvalidToken::Digit('+'));
    assert_eq!(parse("X"), InvalidToken::Digit('X'));
    assert_eq!(parse("f"), InvalidToken::Key(InvalidKey(0xf << 60)));
    assert_eq!(parse("0"), InvalidToken::Key(InvalidKey(0)));
    let said = [parse(""), parse("4g"), parse("f")].map(|e| e.to_string());
    assert_eq!(
        said,
        [
            "expected a token of 1 to 16 bytes, got 0",
            "'g' is not a hexadecimal digit",
            "0xf000000000000000 is not the key of a tile"
        ]
    );
    assert_eq!("1".parse::<Key<Morton>>().map(Tile::from), Ok(Tile::root(Face::Front)));
    assert_eq!("5".parse::<Key<Hilbert>>().map(Tile::from), Ok(Tile::root(Face::Top)));
    assert_eq!(
        format!("{:?}", Key::<Hilbert>::from(Tile::root(Face::Top))),
        "Hilbert(5)"
    );
}

/// Of any number that is a key, the tile and the text come back.
#[test]
fn keys_come_back() {
    let mut rng = Rng::with_seed(9);
    for _ in 0..4000 {
        let zeros = rng.u32(0..64);
        if let Ok(key) = Key::<Hilbert>::new(rng.u64(..) >> zeros << zeros) {
            assert_eq!(Key::from(Tile::from(key)), key);
            assert_eq!(key.to_string().parse(), Ok(key));
        }
    }
}

#[test]
fn any_text_is_handled() {
    let mut rng = Rng::with_seed(10);
    for _ in 0..4000 {
        let text: String = (0..rng.usize(0..40)).map(|_| rng.char(..)).collect();
        let digits: String = (0..rng.usize(0..=18))
            .map(|_| {
                let digit = rng.digit(16);
                if rng.bool() { digit.to_ascii_uppercase() } else { digit }
            })
            .collect();
        for token in [text, digits] {
            if let Ok(key) = token.parse::<Key<Morton>>() {
                assert_eq!(key.to_string(), token.trim_end_matches('0').to_lowercase());
            }
        }
    }
}

/// A point is in the tile of the key of any of its descendants.
#[test]
fn a_point_has_one_chain_of_keys() {
    let mut rng = Rng::with_seed(8);
    for _ in 0..20_000 {
        let point: FacePoint<f64> = sample::point(&mut rng);
        let leaf = Key::<Hilbert>::from(Tile::containing(point, Tile::MAX_LEVEL).unwrap());
        for level in 0..=Tile::MAX_LEVEL {
            let tile = Tile::containing(point, level).unwrap();
            assert_eq!(leaf.ancestor(level), Some(tile.into()));
        }
    }
}
