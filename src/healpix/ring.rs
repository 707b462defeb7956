use super::{InvalidPixel, Pixel};

/// The pixels of a depth by rings: 4·2^depth − 1 rings of pixels whose centres have the same latitude, from
/// the north pole to the south pole.
///
/// The i-th ring from a pole has 4i pixels, as long as it is in the polar cap (i < 2^depth); the others have
/// 4·2^depth. Górski et al. (2005), section 4.1.
struct Rings {
    depth: u8,
    /// The number of pixels along an edge of a base pixel.
    side: u64,
}

impl Rings {
    const fn of(depth: u8) -> Self {
        Self {
            depth,
            side: 1 << depth,
        }
    }

    const fn pixels(&self) -> u64 {
        12 << (2 * self.depth)
    }

    /// The number of pixels in a cap's rings before one of them, counted from 1 at the pole.
    const fn before(ring: u64) -> u64 {
        2 * ring * (ring - 1)
    }

    /// The ring of a cap, from 1 at the pole, that contains the pixel of this number: the largest whose
    /// [`before`](Self::before) is not larger.
    const fn ring_in_cap(number: u64) -> u64 {
        (2 * number + 1).isqrt().div_ceil(2)
    }

    /// The quarter of a cap's ring, and the place in it, of the pixel that has this place in the ring; without
    /// a division, which would have to refuse a zero.
    const fn quarter_in_cap(ring: u64, along: u64) -> (u8, u64) {
        let quarter = (along >= ring) as u8 + (along >= 2 * ring) as u8 + (along >= 3 * ring) as u8;
        (quarter, along - quarter as u64 * ring)
    }

    /// The number in the ring scheme, from the base pixel, and column and row in it.
    const fn number(&self, base: u8, [x, y]: [u64; 2]) -> u64 {
        let Self { side, .. } = *self;
        let (row, quarter) = ((base / 4) as u64, (base % 4) as u64);
        // The ring, from 1 at the north pole.
        let ring = (row + 2) * side - (x + y + 1);
        if ring < side {
            return Self::before(ring) + quarter * ring + (side - 1 - y);
        }
        if ring > 3 * side {
            let ring = 4 * side - ring;
            return self.pixels() - Self::before(ring + 1) + quarter * ring + x;
        }
        // Eastward in halves of the distance between centres, as those of every second ring are shifted by.
        let middle = 2 * quarter + (row != 1) as u64;
        let east = ((middle + 8) * side + x - y) & (8 * side - 1);
        Self::before(side) + (ring - side) * 4 * side + east / 2
    }

    /// The base pixel, and column and row in it, from the number in the ring scheme.
    const fn square(&self, number: u64) -> (u8, [u64; 2]) {
        let Self { depth, side } = *self;
        let last = side - 1;
        let (caps, back) = (Self::before(side), self.pixels() - 1 - number);
        if number < caps {
            let ring = Self::ring_in_cap(number);
            let (quarter, east) = Self::quarter_in_cap(ring, number - Self::before(ring));
            return (quarter, [side - ring + east, last - east]);
        }
        if back < caps {
            let ring = Self::ring_in_cap(back);
            let (quarter, east) = Self::quarter_in_cap(ring, 4 * ring - 1 - (back - Self::before(ring)));
            return (8 + quarter, [east, ring - 1 - east]);
        }
        let (south, along) = ((number - caps) >> (depth + 2), (number - caps) & (4 * side - 1));
        let (north, east) = (2 * side - south, 2 * along + 1 - south % 2);
        // The lines between base pixels that rise to the east, and those that fall, are as far apart as two
        // sides are long; the row follows from the sum of both counts.
        let (rising, falling) = (east + north, north + 8 * side - east);
        let (across, up) = (rising >> (depth + 1), falling >> (depth + 1));
        let row = 5 - (across + up);
        let quarter = (across + 4 - (row == 0) as u64) % 4;
        ((4 * row + quarter) as u8, [(rising / 2) & last, (falling / 2) & last])
    }
}

impl Pixel {
    /// Creates the pixel of a depth (0 to 29) and a number in the ring scheme (0 to 12·4^depth − 1).
    ///
    /// The ring scheme counts pixels along parallels, eastward from longitude 0, from the north pole to the
    /// south pole.
    ///
    /// ```
    /// use terrella::healpix::Pixel;
    /// let pixel = Pixel::from_ring(4, 1504)?;
    /// assert_eq!((pixel.number(), pixel.ring_number()), (1130, 1504));
    /// # Ok::<(), terrella::healpix::InvalidPixel>(())
    /// ```
    ///
    /// # Errors
    /// [`InvalidPixel`] if the depth is above 29, or the number is not in 0 to 12·4^depth − 1.
    #[doc(alias("RING", "ring2nest"))]
    #[inline]
    pub const fn from_ring(depth: u8, number: u64) -> Result<Self, InvalidPixel> {
        if let Err(why) = Self::new(depth, number) {
            return Err(why);
        }
        let (base, [x, y]) = Rings::of(depth).square(number);
        Ok(Self::within(depth, base, [x as u32, y as u32]))
    }

    /// Returns the number in the ring scheme, 0 to 12·4^depth − 1. [`from_ring`](Self::from_ring) is the
    /// inverse. Both compute with whole numbers, and are exact.
    ///
    /// ```
    /// use terrella::healpix::Pixel;
    /// const LAST: Result<Pixel, terrella::healpix::InvalidPixel> = Pixel::new(29, 11 << 58);
    /// assert_eq!(LAST?.ring_number(), (12 << 58) - 1);
    /// # Ok::<(), terrella::healpix::InvalidPixel>(())
    /// ```
    #[doc(alias("RING", "nest2ring"))]
    #[must_use]
    #[inline]
    pub const fn ring_number(self) -> u64 {
        let [x, y] = self.square();
        Rings::of(self.depth()).number(self.base(), [x as u64, y as u64])
    }
}
