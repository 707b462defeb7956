use terrella::latitude::Conversion;
use terrella::{Ellipsoid, Latitude, Shift, Shifted};

use crate::{Arguments, Function, Scalar, Visitor};

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    let earth = Ellipsoid::WGS84;
    for &latitude in Latitude::ALL {
        let (Ok(there), Ok(back)) = (
            Conversion::new(earth, Latitude::Geodetic, latitude),
            Conversion::new(earth, latitude, Latitude::Geodetic),
        ) else {
            continue;
        };
        let unit = Arguments::unit::<T>;
        let name = |function| Function::of(function, Latitude::name(latitude));
        visitor.visit::<T, _, _>(name("Conversion::degrees"), unit, |x| {
            Conversion::degrees(&there, x * T::of(91.0))
        });
        visitor.visit::<T, _, _>(name("Conversion::radians"), unit, |x| {
            Conversion::radians(&there, x * T::of(1.6))
        });
        visitor.visit::<T, _, _>(name("Conversion::degrees to geodetic"), unit, |x| {
            Conversion::degrees(&back, x * T::of(91.0))
        });
        visitor.visit::<T, _, _>(name("Conversion::radians to geodetic"), unit, |x| {
            Conversion::radians(&back, x * T::of(1.6))
        });
        visitor.visit::<T, _, _>(
            name("Conversion::new"),
            |arguments| (arguments.ellipsoid::<T>(), arguments.unit::<T>()),
            |(ellipsoid, x)| {
                let there = Conversion::new(ellipsoid, Latitude::Authalic, latitude);
                there.map(|there| Conversion::degrees(&there, x * T::of(90.0)))
            },
        );
    }
    for &shift in Shift::ALL {
        let Ok(shifted) = Shifted::new(earth, shift) else {
            continue;
        };
        let name = |function| Function::of(function, Shift::name(shift));
        visitor.visit::<T, _, _>(name("Shifted::to_direction"), Arguments::place::<T>, |place| {
            Shifted::to_direction(&shifted, place)
        });
        visitor.visit::<T, _, _>(name("Shifted::to_lat_lon"), Arguments::direction::<T>, |direction| {
            Shifted::to_lat_lon(&shifted, direction)
        });
        visitor.visit::<T, _, _>(
            name("Shifted::new"),
            |arguments| (arguments.ellipsoid::<T>(), arguments.place::<T>()),
            |(ellipsoid, place)| {
                let shifted = Shifted::new(ellipsoid, shift)?;
                let direction = Shifted::to_direction(&shifted, place);
                let name = Shift::name(Shifted::shift(&shifted));
                Ok::<_, terrella::latitude::UnsupportedFlattening<T>>((Shifted::ellipsoid(&shifted), name, direction))
            },
        );
    }
    visitor.function::<T, _, _>("Latitude and Shift, by name", any_name, |name| {
        let latitude = name.parse().map(Latitude::name).ok();
        let shift = name
            .parse()
            .map(|shift: Shift| Latitude::name(Latitude::from(shift)))
            .ok();
        (latitude, shift, Shift::name(Shift::default()))
    });
}

fn any_name(arguments: &mut Arguments) -> &'static str {
    let index = arguments.below(8) as usize;
    Latitude::ALL.get(index).map_or("nothing", |latitude| latitude.name())
}
