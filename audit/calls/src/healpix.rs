use terrella::healpix::{self, InvalidPixel, InvalidPixelPlace, OutsidePlane, Pixel};

use crate::{Arguments, Bits, Hash, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.below(31) as u8);
    visitor.function::<T, _, _>("Pixel::containing", draw, |(place, depth)| {
        Pixel::containing(place, depth)
    });
    let draw = |arguments: &mut Arguments| {
        let depth = arguments.below(31) as u8;
        (
            depth,
            arguments.below(1 << 31) << 31 | arguments.below(1 << 31),
            arguments.units::<T, 2>(),
        )
    };
    visitor.function::<T, _, _>("Pixel::place", draw, |(depth, number, [dx, dy])| {
        let refused = Pixel::new(depth, number);
        let pixel = Pixel::new(depth, number & ((8 << (2 * depth.min(Pixel::MAX_DEPTH))) - 1));
        let places = pixel.map(|pixel| {
            let centre = Pixel::centre::<T>(pixel);
            (
                Pixel::place(pixel, [T::abs(dx), dy]),
                centre,
                Pixel::depth(pixel),
                Pixel::number(pixel),
            )
        });
        (refused, places)
    });
    visitor.function::<T, _, _>("healpix::to_plane", Arguments::place::<T>, |place| {
        let [x, y] = healpix::to_plane(place);
        ([x, y], healpix::from_plane([x, y]))
    });
    visitor.function::<T, _, _>("healpix::from_plane", Arguments::units::<T, 2>, |[x, y]| {
        healpix::from_plane([T::of(8.0) * T::abs(x), T::of(2.0) * y])
    });
}

impl Bits for Pixel {
    fn add_to(&self, hash: &mut Hash) {
        (Pixel::depth(*self), Pixel::number(*self)).add_to(hash);
    }
}

impl Bits for InvalidPixel {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Depth(depth) => (*depth, None),
            Self::Number { depth, number } => (*depth, Some(*number)),
        }
        .add_to(hash);
    }
}

impl<T: Scalar> Bits for InvalidPixelPlace<T> {
    fn add_to(&self, hash: &mut Hash) {
        [self.dx, self.dy].add_to(hash);
    }
}

impl<T: Scalar> Bits for OutsidePlane<T> {
    fn add_to(&self, hash: &mut Hash) {
        [self.x, self.y].add_to(hash);
    }
}
