//! What is chosen by its name, and what is known of it.

use terrella::Ellipsoid;
use terrella::cube::{Face, Formula, Projection, UnknownFace, UnknownProjection};
use terrella::geodesic::{self, AnyMethod, Geodesic, Inverse, Method, UnknownMethod};
use terrella::latitude::{UnknownLatitude, UnknownShift};
use terrella::{LatLon, Latitude, Shift, UnknownEllipsoid};

use crate::{Arguments, Scalar, Visitor};

const NOBODYS: [&str; 4] = ["nothing", "", "Karney", "a name that is longer than what is kept of it"];

pub fn show<T: Scalar, V: Visitor>(visitor: &mut V) {
    visitor.function::<T, _, _>(
        "names that are nobody's",
        |arguments| arguments.below(4) as usize,
        |index| {
            let name = NOBODYS.get(index).copied().unwrap_or_default();
            let projection = name.parse::<Projection>().err();
            let method = name.parse::<Method>().err();
            let latitude = name.parse::<Latitude>().err();
            let shift = name.parse::<Shift>().err();
            let ellipsoid = name.parse::<Ellipsoid<T>>().err();
            let face = name.parse::<Face>().err();
            (
                projection.map(|unknown| UnknownProjection::name(&unknown).len()),
                method.map(|unknown| UnknownMethod::name(&unknown).len()),
                latitude.map(|unknown| UnknownLatitude::name(&unknown).len()),
                shift.map(|unknown| UnknownShift::name(&unknown).len()),
                (
                    ellipsoid.map(|unknown| UnknownEllipsoid::name(&unknown).len()),
                    face.map(|unknown| UnknownFace::name(&unknown).len()),
                ),
            )
        },
    );
    // Figures of a profile are in double precision, whatever they are about.
    if T::NAME == f64::NAME {
        visitor.function::<f64, _, _>(
            "Projection::profile",
            |arguments| arguments.below(64) as usize,
            |index| {
                Projection::ALL.get(index % Projection::ALL.len()).map(|&projection| {
                    let profile = Projection::profile(projection);
                    let formulas = [profile.forward, profile.inverse].map(|way| Formula::name(way.formula).len());
                    ([profile.area_ratio, profile.oversize], formulas)
                })
            },
        );
    }
    let two = Arguments::units::<T, 2>;
    visitor.function::<T, _, _>("Ellipsoid, from axes", two, |[a, b]| {
        (
            Ellipsoid::from_semi_axes(a, b).ok(),
            Ellipsoid::from_inverse_flattening(a, T::of(300.0) * b).ok(),
        )
    });
    visitor.function::<T, _, _>(
        "AnyMethod::visit",
        |arguments| (arguments.below(64) as usize, arguments.pair::<T>()),
        |(index, pair)| {
            let method = Method::ALL
                .get(index % Method::ALL.len())
                .copied()
                .unwrap_or(Method::Flat);
            let any = Method::about(method, Ellipsoid::WGS84, pair[0]).ok();
            (
                Method::needs_place(method),
                any.and_then(|any| AnyMethod::visit(any, Line(pair))),
                any.and_then(|any| geodesic::Visitor::visit(Line(pair), any)),
            )
        },
    );
}

/// Solves the inverse problem by a method of any type.
struct Line<T>([LatLon<T>; 2]);

impl<T: Scalar> geodesic::Visitor<T> for Line<T> {
    type Output = Option<Inverse<T>>;

    fn visit<M: Geodesic<T>>(self, method: M) -> Self::Output {
        let Self([from, to]) = self;
        method.inverse(from, to).ok()
    }
}
