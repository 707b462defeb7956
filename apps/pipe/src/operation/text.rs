//! Places as text.

use clap::Args;
use terrella::grid::web_mercator::Tile;
use terrella::grid::{Geohash, PlusCode};
use terrella::{LatLon, NmeaLatLon};

use super::{Answer, Failure, Group, answer, group};
use crate::options::Nothing;
use crate::read::{Number, Rest};

pub const GROUP: Group = group! {
    "Places as text":
    "dms" "lat lon -> latitude longitude in degrees, minutes and seconds", dms(Decimals);
    "from-dms" "text of latitude and longitude, as LatLon parses it -> lat lon", from_dms(Nothing);
    "nmea" "lat lon -> ddmm.mmmm,N,dddmm.mmmm,E", nmea(Decimals);
    "from-nmea" "ddmm.mmmm,N,dddmm.mmmm,E -> lat lon", from_nmea(Nothing);
    "geohash" "lat lon -> letters", geohash(Letters);
    "from-geohash" "letters -> lat lon of the middle, south west north east", from_geohash(Nothing);
    "plus-code" "lat lon -> code", plus_code(Digits);
    "from-plus-code" "code -> lat lon of the middle, south west north east", from_plus_code(Nothing);
    "web-mercator-tile" "zoom lat lon -> zoom/x/y", tile(Nothing);
    "from-web-mercator-tile" "zoom/x/y -> south west north east", from_tile(Nothing);
};

/// Decimals of the last number.
#[derive(Args)]
pub struct Decimals {
    /// Decimals of a second, or of a minute of NMEA 0183, up to 12.
    #[arg(long, value_name = "N", default_value_t = 9)]
    decimals: u8,
}

/// Letters of a geohash.
#[derive(Args)]
pub struct Letters {
    /// How many letters, 1 to 12.
    #[arg(long, value_name = "N", default_value_t = 12)]
    letters: u8,
}

/// Digits of a plus code.
#[derive(Args)]
pub struct Digits {
    /// How many digits: 2, 4, 6, 8, 10 to 15.
    #[arg(long, value_name = "N", default_value_t = 10)]
    digits: u8,
}

fn dms<T: Number>(Decimals { decimals }: Decimals) -> Result<Answer, Failure> {
    answer(move |place: LatLon<T>| Ok(place.to_dms(decimals).to_string()))
}

fn from_dms<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|Rest(text)| Ok(text.parse::<LatLon<T>>().map_err(|why| why.to_string())?))
}

fn nmea<T: Number>(Decimals { decimals }: Decimals) -> Result<Answer, Failure> {
    answer(move |place: LatLon<T>| Ok(place.to_nmea(decimals).to_string()))
}

fn from_nmea<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|text: String| Ok(text.parse::<NmeaLatLon>()?.to_lat_lon::<T>()))
}

fn geohash<T: Number>(Letters { letters }: Letters) -> Result<Answer, Failure> {
    answer(move |place: LatLon<T>| Ok(Geohash::containing(place, letters)?.to_string()))
}

fn from_geohash<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|text: String| {
        let cell: Geohash = text.parse()?;
        Ok((cell.centre::<T>(), cell.bounds::<T>()))
    })
}

fn plus_code<T: Number>(Digits { digits }: Digits) -> Result<Answer, Failure> {
    answer(move |place: LatLon<T>| Ok(PlusCode::containing(place, digits)?.to_string()))
}

fn from_plus_code<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|text: String| {
        let code: PlusCode = text.parse()?;
        Ok((code.centre::<T>(), code.bounds::<T>()))
    })
}

fn tile<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|(zoom, place): (u8, LatLon<T>)| Ok(Tile::containing(place, zoom)?.to_string()))
}

fn from_tile<T: Number>(_: Nothing) -> Result<Answer, Failure> {
    answer(|text: String| Ok(text.parse::<Tile>()?.bounds::<T>()))
}
