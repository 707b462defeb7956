use core::fmt;

use super::plane::{Facet, Spot, belt, cap, middle};
use crate::math::{either, gathered, select, spread};
use crate::{LatLon, Real};

/// A pixel of standard HEALPix, identified by its depth and its number in the nested scheme.
///
/// [`ring_number`](Self::ring_number) and [`from_ring`](Self::from_ring) convert to the ring scheme and back.
///
/// At depth k (`order` in other libraries) a base pixel has `nside` × `nside` pixels, with `nside` = 2ᵏ. The
/// first four bits of a number are the base pixel: 0 to 3 about the north pole, eastward from longitude 0; 4
/// to 7 on the equator, with 4 centred on longitude 0; 8 to 11 about the south pole. Two bits follow for each
/// level. The lower bit of each pair belongs to x, which increases from the southern corner to the eastern
/// one; the higher bit belongs to y, which increases from the southern corner to the western one.
///
/// ```
/// use terrella::healpix::Pixel;
/// use terrella::LatLon;
/// let vega = LatLon::new(38.783_69, 279.234_73)?;
/// let pixel = Pixel::containing(vega, 9)?;
/// assert_eq!((pixel.depth(), pixel.number()), (9, 954_011));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[doc(alias = "HEALPix nested")]
#[doc(alias = "NESTED")]
#[doc(alias = "ang2pix")]
#[doc(alias = "HEALPix")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Pixel {
    depth: u8,
    number: u64,
}

impl Pixel {
    /// The largest depth, 29. A pixel of this depth is 1.2 cm wide on the Earth.
    pub const MAX_DEPTH: u8 = 29;

    /// Creates the pixel of a depth (0 to 29) and a number (0 to 12·4^depth − 1).
    ///
    /// # Errors
    /// [`InvalidPixel`] if the depth is above 29, or the number is not in 0 to 12·4^depth − 1.
    #[inline]
    pub const fn new(depth: u8, number: u64) -> Result<Self, InvalidPixel> {
        if depth > Self::MAX_DEPTH {
            return Err(InvalidPixel::Depth(depth));
        }
        if number >> (2 * depth) >= 12 {
            return Err(InvalidPixel::Number { depth, number });
        }
        Ok(Self { depth, number })
    }

    /// Returns the pixel of a depth that contains a place, given by its latitude and longitude on the sphere.
    ///
    /// A place on a line between two pixels belongs to the pixel that HEALPix's C library chooses: the one
    /// north or east of the line in the equatorial zone, and the one away from the pole in a polar cap.
    ///
    /// The pixel is correct if the place is farther from the pixel's edges than the rounding error of its
    /// sine: on the Earth 12 nm in `f64` and 1.5 m in `f32`. No digits are lost next to a pole.
    ///
    /// ```
    /// use terrella::healpix::Pixel;
    /// use terrella::LatLon;
    /// assert_eq!(Pixel::containing(LatLon::new(41.81, 45.0)?, 0)?.number(), 0);
    /// assert_eq!(Pixel::containing(LatLon::new(0.0, 0.0)?, 0)?.number(), 4);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPixel::Depth`] if the depth is above 29.
    #[doc(alias = "ang2pix_nest")]
    #[inline]
    pub fn containing<T: Real>(place: LatLon<T>, depth: u8) -> Result<Self, InvalidPixel> {
        Self::checked(Facet::of_place(place), depth)
    }

    /// The pixel of a depth that contains a place, if there is such a depth.
    #[inline(always)]
    pub(super) fn checked<T: Real>(facet: Facet<T>, depth: u8) -> Result<Self, InvalidPixel> {
        if depth > Self::MAX_DEPTH {
            return Err(InvalidPixel::Depth(depth));
        }
        Ok(Self::of(facet, depth))
    }

    /// The pixel of a depth that contains a place.
    #[inline(always)]
    pub(crate) fn of<T: Real>(facet: Facet<T>, depth: u8) -> Self {
        let Facet {
            quarter,
            turn,
            height,
            outward,
        } = facet;
        let last = (1_u32 << depth) - 1;
        let across = T::whole(1 << depth);
        let index = |share: T| ((share * across).floor() as u32).min(last);
        let (zero, half) = (T::ZERO, T::of(0.5));
        let north = height > zero;
        // Two lines between base pixels cross on the equator in the middle of the quarter; one of them rises
        // to the east.
        let slope = half * height;
        let (rising, falling) = (turn + slope, turn - slope);
        let wrapped = |share: T| share + either(share < zero, T::ONE);
        let belt = [index(wrapped(rising)), last - index(wrapped(falling))];
        let base = match (rising >= zero, falling >= zero) {
            (true, false) => quarter,
            (false, true) => 8 + quarter,
            (true, true) => 4 + (quarter + 1) % 4,
            (false, false) => 4 + quarter,
        };
        let (east, west) = (index((half + turn) * outward), index((half - turn) * outward));
        let cap = select(north, [last - west, last - east], [east, west]);
        let polar = select(north, quarter, 8 + quarter);
        let (base, square) = select(facet.is_cap(), (polar, cap), (base, belt));
        Self::within(depth, base, square)
    }

    /// Creates the pixel of a base pixel, column and row that are known to be in range.
    #[inline(always)]
    pub(super) const fn within(depth: u8, base: u8, [x, y]: [u32; 2]) -> Self {
        Self {
            depth,
            number: (base as u64) << (2 * depth) | spread(x) | spread(y) << 1,
        }
    }

    /// The pixel of a depth and a number that are known to be in range, or whose results are not used.
    #[inline(always)]
    pub(crate) const fn numbered(depth: u8, number: u64) -> Self {
        Self { depth, number }
    }

    /// Returns the depth, 0 to 29.
    #[must_use]
    #[inline(always)]
    pub const fn depth(self) -> u8 {
        self.depth
    }

    /// Returns the number in the nested scheme, 0 to 12·4^depth − 1.
    #[must_use]
    #[inline(always)]
    pub const fn number(self) -> u64 {
        self.number
    }

    /// Returns the number of the base pixel, 0 to 11.
    #[must_use]
    #[inline(always)]
    pub const fn base(self) -> u8 {
        (self.number >> (2 * self.depth)) as u8
    }

    /// The largest column and row of this depth.
    #[inline(always)]
    pub(super) const fn last(self) -> u32 {
        (1 << self.depth) - 1
    }

    /// Column and row in the base pixel, from its southern corner.
    #[inline(always)]
    pub(super) const fn square(self) -> [u32; 2] {
        let last = self.last();
        [gathered(self.number) & last, gathered(self.number >> 1) & last]
    }

    /// Returns the centre of the pixel: latitude and longitude on the sphere.
    #[doc(alias = "pix2ang_nest")]
    #[must_use]
    #[inline]
    pub fn centre<T: Real>(self) -> LatLon<T> {
        self.middle().on_sphere()
    }

    /// Returns the corners of the pixel: south, east, north, west, which is counter-clockwise.
    ///
    /// Their errors are those of [`place`](Self::place). The longitude of a pole is that of the middle of the
    /// base pixel.
    ///
    /// ```
    /// use terrella::healpix::Pixel;
    /// let [south, east, north, west] = Pixel::new(0, 4)?.corners::<f64>();
    /// assert_eq!((south.lon(), north.lon()), (0.0, 0.0));
    /// assert_eq!((east.lat(), east.lon(), west.lon()), (0.0, 45.0, -45.0));
    /// assert!((north.lat() - (2.0_f64 / 3.0).asin().to_degrees()).abs() < 1e-13);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[doc(alias = "boundaries")]
    #[doc(alias = "vertices")]
    #[must_use]
    #[inline]
    pub fn corners<T: Real>(self) -> [LatLon<T>; 4] {
        self.tips().map(Spot::on_sphere)
    }

    /// The centre.
    #[inline(always)]
    pub(crate) fn middle<T: Real>(self) -> Spot<T> {
        let half = T::of(0.5);
        self.at([half, half])
    }

    /// The corners: south, east, north, west.
    #[inline(always)]
    pub(super) fn tips<T: Real>(self) -> [Spot<T>; 4] {
        let (zero, one) = (T::ZERO, T::ONE);
        [[zero, zero], [one, zero], [one, one], [zero, one]].map(|inside| self.at(inside))
    }

    /// Returns the place at (dx, dy) ∈ [0, 1]² in the pixel. dx increases from the southern corner to the
    /// eastern one, dy from the southern corner to the western one.
    ///
    /// The worst error is 4.3·10⁻¹⁶ (`f64`) or 2.3·10⁻⁷ (`f32`) radians on the sphere, including the rounding
    /// of latitude and longitude.
    ///
    /// ```
    /// use terrella::healpix::Pixel;
    /// let base = Pixel::new(0, 5)?;
    /// let [south, east] = [base.place([0.0, 0.0])?, base.place([1.0, 0.0])?];
    /// assert_eq!((south.lon(), east.lat(), east.lon()), (90.0, 0.0, 135.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPixelPlace`] if dx or dy is outside [0, 1] or NaN.
    #[inline]
    pub fn place<T: Real>(self, inside: [T; 2]) -> Result<LatLon<T>, InvalidPixelPlace<T>> {
        Ok(self.spot(inside)?.on_sphere())
    }

    /// The place at (dx, dy), if both are in [0, 1].
    #[inline(always)]
    pub(super) fn spot<T: Real>(self, [dx, dy]: [T; 2]) -> Result<Spot<T>, InvalidPixelPlace<T>> {
        let inside = |d: T| (d >= T::ZERO) & (d <= T::ONE);
        if !(inside(dx) & inside(dy)) {
            return Err(InvalidPixelPlace { dx, dy });
        }
        Ok(self.at([dx, dy]))
    }

    /// The same for a place that is known to be in the pixel.
    #[inline(always)]
    fn at<T: Real>(self, [dx, dy]: [T; 2]) -> Spot<T> {
        let (base, last, [x, y]) = (self.base(), self.last(), self.square());
        let (zero, one) = (T::ZERO, T::ONE);
        let whole = |number: u32| T::whole(number.into());
        // The distances from the southern corner, from the northern corner, and eastward from the line
        // between the two, in halves of the base pixel's diagonal.
        let across = T::whole(1 << self.depth);
        let south = (whole(x + y) + (dx + dy)) / across;
        let north = (whole(2 * last - (x + y)) + ((one - dx) + (one - dy))) / across;
        let apart = whole(x.abs_diff(y));
        let east = (select(x < y, -apart, apart) + (dx - dy)) / across;
        let (row, column) = (base / 4, base % 4);
        // `height` counts from the equator and `outward` from the pole: each serves the half of the base
        // pixel next to it.
        let (height, outward) = match row {
            0 => (south, north),
            1 => (south - one, one),
            _ => (-north, south),
        };
        let is_cap = height.abs() > one;
        let (sin, cos) = select(is_cap, cap(outward), belt(height.abs()));
        let share = east / select(is_cap & (outward > zero), outward, one);
        let equatorial = T::of(90.0) * T::from_byte(column);
        let back = (column > 2) | ((column == 2) & (east > zero));
        let equatorial = equatorial - either(back, T::of(360.0));
        let lon = select(row == 1, equatorial, middle(column)) + T::of(45.0) * share;
        Spot {
            latitude: (sin.copysign(height), cos),
            lon,
        }
    }
}

/// The error of creating a [`Pixel`]: the depth or the number is out of range.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum InvalidPixel {
    /// The depth; it is above 29.
    Depth(u8),
    /// The number is not in 0 to 12·4^depth − 1.
    Number {
        /// The depth.
        depth: u8,
        /// The number.
        number: u64,
    },
}

impl fmt::Display for InvalidPixel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Depth(depth) => write!(f, "depth {depth} is not in 0 to 29"),
            Self::Number { depth, number } => write!(f, "pixel {number} is not in 0 to 12·4^{depth} - 1"),
        }
    }
}

impl core::error::Error for InvalidPixel {}

/// The error of [`Pixel::place`]: dx or dy is outside [0, 1] or NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct InvalidPixelPlace<T> {
    /// The coordinate from the southern corner to the eastern one.
    pub dx: T,
    /// The coordinate from the southern corner to the western one.
    pub dy: T,
}

impl<T: fmt::Debug> fmt::Display for InvalidPixelPlace<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:?}, {:?}) is not in [0, 1]²", self.dx, self.dy)
    }
}

impl<T: fmt::Debug> core::error::Error for InvalidPixelPlace<T> {}
