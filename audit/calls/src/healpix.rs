use terrella::Ellipsoid;
use terrella::batch::{self, healpix::InvalidPixelled};
use terrella::healpix::{self, Corner, InvalidPixel, InvalidPixelPlace, OnEllipsoid, OutsidePlane, Pixel, Side};

use crate::batch::{function, into, lent, places};
use crate::{Arguments, Bits, Hash, POINTS, Scalar, Visitor};

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
    visitor.function::<T, _, _>("Pixel::corners", any_pixel, |pixel| Pixel::corners::<T>(pixel));
    on_ellipsoid::<T, V>(visitor);
    if T::NAME == f64::NAME {
        numbers(visitor);
    }
}

/// Of whole numbers: the same for all scalars.
fn numbers<V: Visitor>(visitor: &mut V) {
    visitor.function::<f64, _, _>("Pixel::from_ring", any_number, |(depth, number)| {
        Pixel::from_ring(depth, number)
    });
    visitor.function::<f64, _, _>("Pixel::ring_number", any_pixel, |pixel| {
        (Pixel::base(pixel), Pixel::ring_number(pixel))
    });
    visitor.function::<f64, _, _>("Pixel::neighbours", any_pixel, Pixel::neighbours);
    let draw = |arguments: &mut Arguments| (any_pixel(arguments), arguments.below(4) as usize);
    visitor.function::<f64, _, _>("Pixel::neighbour", draw, |(pixel, at)| {
        let side = Side::ALL.get(at).copied().unwrap_or(Side::SouthWest);
        let corner = Corner::ALL.get(at).copied().unwrap_or(Corner::South);
        (Pixel::neighbour(pixel, side), Pixel::diagonal(pixel, corner))
    });
}

fn on_ellipsoid<T: Scalar, V: Visitor>(visitor: &mut V) {
    let draw = |arguments: &mut Arguments| (arguments.ellipsoid::<T>(), any_pixel(arguments));
    visitor.function::<T, _, _>("OnEllipsoid::new", draw, |(ellipsoid, pixel)| {
        let ground = OnEllipsoid::new(ellipsoid)?;
        let [of, area] = [OnEllipsoid::ellipsoid(&ground).f(), OnEllipsoid::area(&ground, pixel)];
        Ok::<_, terrella::latitude::UnsupportedFlattening<T>>([of, area])
    });
    let Ok(earth) = OnEllipsoid::new(Ellipsoid::<T>::WGS84) else {
        return;
    };
    let draw = |arguments: &mut Arguments| (arguments.place::<T>(), arguments.below(31) as u8);
    visitor.function::<T, _, _>("OnEllipsoid::containing", draw, |(place, depth)| {
        OnEllipsoid::containing(&earth, place, depth)
    });
    let draw = |arguments: &mut Arguments| (any_pixel(arguments), arguments.units::<T, 2>());
    visitor.function::<T, _, _>("OnEllipsoid::place", draw, |(pixel, [dx, dy])| {
        let (centre, corners) = (OnEllipsoid::centre(&earth, pixel), OnEllipsoid::corners(&earth, pixel));
        (OnEllipsoid::place(&earth, pixel, [T::abs(dx), dy]), centre, corners)
    });
    visitor.function::<T, _, _>("OnEllipsoid::to_plane", Arguments::place::<T>, |place| {
        let [x, y] = OnEllipsoid::to_plane(&earth, place);
        ([x, y], OnEllipsoid::from_plane(&earth, [x, y]))
    });
    visitor.function::<T, _, _>("OnEllipsoid::from_plane", Arguments::units::<T, 2>, |[x, y]| {
        OnEllipsoid::from_plane(&earth, [T::of(8.0) * T::abs(x), T::of(2.0) * y])
    });
    batches(visitor, &earth);
}

fn batches<T: Scalar, V: Visitor>(visitor: &mut V, earth: &OnEllipsoid<T>) {
    let draw = |arguments: &mut Arguments| (arguments.below(31) as u8, places::<T>(arguments));
    visitor.visit::<T, _, _>(function("batch::healpix::containing", ""), draw, |(depth, places)| {
        let mut numbers = [0; POINTS];
        let outcome = batch::healpix::containing(earth, depth, lent(&places), &mut numbers);
        (numbers, outcome)
    });
    let draw = |arguments: &mut Arguments| {
        let numbers = [(); POINTS].map(|()| any_pixel(arguments).number());
        (arguments.below(31) as u8, numbers)
    };
    visitor.visit::<T, _, _>(function("batch::healpix::centre", ""), draw, |(depth, numbers)| {
        into(|centres| batch::healpix::centre(earth, depth, &numbers, centres))
    });
}

/// A depth that may be too large, and a number of any size.
fn any_number(arguments: &mut Arguments) -> (u8, u64) {
    let number = arguments.below(1 << 31) << 31 | arguments.below(1 << 31);
    (arguments.below(31) as u8, number >> arguments.below(62))
}

/// A pixel of any depth.
fn any_pixel(arguments: &mut Arguments) -> Pixel {
    loop {
        let (depth, number) = any_number(arguments);
        if let Ok(pixel) = Pixel::new(depth, number) {
            return pixel;
        }
    }
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

impl<T: Scalar> Bits for InvalidPixelled<T> {
    fn add_to(&self, hash: &mut Hash) {
        match self {
            Self::Place(why) => why.add_to(hash),
            Self::Pixel(why) => why.add_to(hash),
        }
    }
}

impl<T: Scalar> Bits for OutsidePlane<T> {
    fn add_to(&self, hash: &mut Hash) {
        [self.x, self.y].add_to(hash);
    }
}
