//! Pixels of HEALPix.

use terrella::LatLon;
use terrella::batch::{self, healpix::InvalidPixelled};
use terrella::healpix::{InvalidPixel, OnEllipsoid, Pixel};

use super::terrain::{pieces, with_keys};
use super::{compare_or, judge, place};
use testkit::bytes::Bytes;
use testkit::scalar::Scalar;

/// Pixels that contain places, and centres of pixels, of any number.
pub(super) fn pixels<T: Scalar>(bytes: &mut Bytes<'_>) {
    let depth = bytes.byte() % 32;
    let surface = OnEllipsoid::<T>::new(bytes.ellipsoid(-0.1, 0.1)).unwrap();
    if bytes.flag() {
        compare_or(
            bytes,
            "containing",
            [T::ZERO; 4],
            place,
            |[lat, lon]| {
                if depth > Pixel::MAX_DEPTH {
                    return Err(InvalidPixelled::Pixel(InvalidPixel::Depth(depth)));
                }
                let place = LatLon::new(lat, lon).map_err(InvalidPixelled::Place)?;
                Ok(pieces(surface.containing(place, depth).unwrap().number()))
            },
            |places, columns| {
                with_keys(columns, |numbers| {
                    batch::healpix::containing(&surface, depth, places, numbers)
                })
            },
        );
        return;
    }
    let (count, stride) = (usize::from(bytes.byte()), usize::from(bytes.byte()));
    let few = [(); 4].map(|()| {
        let number = bytes.word();
        // Often there is such a pixel.
        let most = 12_u64.checked_shl(2 * u32::from(depth.min(29))).unwrap_or(u64::MAX);
        if bytes.byte() % 8 == 7 { number } else { number % most }
    });
    let numbers: Vec<u64> = (0..count).map(|i| few[(i * stride + i * i) % few.len()]).collect();
    let mut results = [(); 2].map(|()| vec![T::of(7.0); count]);
    let [lat, lon] = &mut results;
    let found = batch::healpix::centre(&surface, depth, &numbers, [lat, lon]);
    let one = |index: usize| {
        let centre = surface.centre(Pixel::new(depth, numbers[index])?);
        Ok([centre.lat(), centre.lon()])
    };
    judge(&format!("{numbers:?}"), [T::of(f64::NAN); 2], &results, one, found);
}
