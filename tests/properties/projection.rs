//! A projection of the sphere: where its coordinates and vectors lie, the way there and back, the truth, the cube's symmetries;
//! and the same on an ellipsoid.

use terrella::cube::{CubeMap, CubeProjection, Face, FacePoint, Faces, Projection, Rotation, Stretched, Turned};
use terrella::{Direction, Real, Shift};
use testkit::maximum;
use testkit::vector;

use super::reference;
use testkit::bytes::Bytes;
use testkit::properties;
use testkit::scalar::{Scalar, same, ulps};
use testkit::table::{claim, claims_of};
use testkit::vector::{angle, apart, excess};

properties! { forward inverse round_trip forward_is_true inverse_is_true symmetries ellipsoid grows oblique }

/// How far, in radians, a direction moves at most while x and y move by 1 each.
const STEP: f64 = 1.8;

/// The coordinates of the bare projection exceed [−1, 1] by at most an ulp (and are numbers: `project`'s bounds would hide a NaN),
/// on the face of the largest component.
fn forward<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let direction = bytes.direction::<T>();
    let face = projection.face(direction);
    let [x, y] = projection.forward(face, face.to_local(direction.to_array()));
    let limit = T::ONE + T::EPSILON;
    let context = format!("{projection} {}: {direction:?} on {face:?} is ({x:?}, {y:?})", T::NAME);
    assert!(x.abs() <= limit && y.abs() <= limit, "{context}");
    assert!(
        projection == Projection::Healpix || face == Face::containing(direction),
        "{context}"
    );
    let bounded = |v: T| if v.abs() > T::ONE { T::ONE.copysign(v) } else { v };
    let point = projection.project(direction);
    assert!(
        point.face() == face && same(point.x(), bounded(x)) && same(point.y(), bounded(y)),
        "{context}, {point:?}"
    );
}

/// Every point is a unit vector, and inside of a face one of that face.
fn inverse<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let point = bytes.point::<T>();
    let direction = projection.unproject(point);
    let context = || format!("{projection} {}: {point:?} is {direction:?}", T::NAME);
    let excess = excess(direction.to_array().map(Into::into)).abs();
    assert!(excess <= 5.0 * T::EPSILON.into(), "{}", context());
    let inside = T::of(0.999);
    if point.x().abs() <= inside && point.y().abs() <= inside {
        assert_eq!(projection.face(direction), point.face(), "{}", context());
    }
}

/// How far a direction may move, in radians, on its way to a point and back.
fn closes<T: Scalar>(projection: Projection) -> f64 {
    let (forward, inverse) = claims_of(projection);
    // COBE's published pair does not close.
    let miss = if projection == Projection::Cobe { 4e-4 } else { 0.0 };
    miss + inverse[T::CLAIM] + STEP * forward[T::CLAIM]
}

/// A direction comes back from its point.
fn round_trip<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let direction = bytes.direction::<T>();
    let point = projection.project(direction);
    let back = projection.unproject(point);
    let moved = angle(direction.to_array().map(Into::into), back.to_array().map(Into::into));
    assert!(
        moved <= closes::<T>(projection),
        "{projection} {}: {direction:?}, {point:?}, {back:?}: {moved:e}",
        T::NAME
    );
}

/// How far the way back is from the formula in twice the digits, in radians.
fn error_back<T: Scalar>(projection: Projection, point: FacePoint<T>) -> Option<f64> {
    let exact = exact(projection, point)?;
    let computed = projection.unproject(point).to_array().map(Into::<f64>::into);
    Some(vector::length(core::array::from_fn(|i| {
        (computed[i] - exact[i][0]) - exact[i][1]
    })))
}

/// The way back is as near as claimed to the formula in twice the digits; of the conformal cube, `f32` to `f64`.
fn inverse_is_true<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let point = bytes.point::<T>();
    let Some(error) = error_back(projection, point) else {
        return;
    };
    let (_, claimed) = claims_of(projection);
    assert!(
        error <= claimed[T::CLAIM],
        "{projection} {}: {point:?}, {error:e} off",
        T::NAME
    );
}

/// The worst points that were found, of millions.
#[cfg(test)]
#[test]
fn worst_points_back() {
    use Projection::{Adjusted, Healpix, Outerra, Quadrilateralized, Square, Vertex};
    for (projection, face, [x, y]) in [
        (Quadrilateralized, Face::Top, [0.9998786089290815, 0.9846793071375445]),
        (Outerra, Face::Top, [0.999730182616684, 0.9994945185210922]),
        (Adjusted, Face::Top, [0.9831546790417187, 0.9176449919952118]),
        (Healpix, Face::Top, [0.9781929664231611, 0.9739754262423761]),
        (Vertex, Face::Front, [0.9994555124538639, 0.29989309132773306]),
        (Square, Face::Front, [0.9792224334111574, 1.0]),
    ] {
        let error = error_back(projection, FacePoint::new(face, x, y).unwrap()).unwrap();
        let (_, [claimed, _]) = claims_of(projection);
        assert!(
            (0.66 * claimed..=claimed).contains(&error),
            "{projection}: {error:e} of {claimed:e}"
        );
    }
}

/// The largest error that climbing from the worst of a million places finds, and where.
#[cfg(test)]
fn climb<P: Copy>(
    anywhere: impl Fn(&mut fastrand::Rng) -> P,
    moved: impl Fn(&mut fastrand::Rng, P) -> P,
    error: impl Fn(P) -> f64,
) -> (f64, P) {
    // No number is worse than any.
    let error = |place| {
        Some(error(place))
            .filter(|error| !error.is_nan())
            .unwrap_or(f64::INFINITY)
    };
    let rng = &mut fastrand::Rng::with_seed(7);
    let mut found: Vec<(f64, P)> = (0..1_000_000)
        .map(|_| {
            let place = anywhere(rng);
            (error(place), place)
        })
        .collect();
    found.sort_by(|(a, _), (b, _)| b.total_cmp(a));
    found.truncate(60);
    for (most, at) in &mut found {
        for _ in 0..4000 {
            let place = moved(rng, *at);
            let error = error(place);
            if error > *most {
                (*most, *at) = (error, place);
            }
        }
    }
    found.into_iter().max_by(|(a, _), (b, _)| a.total_cmp(b)).unwrap()
}

/// Two numbers from 0 to 1, often near 1 or each other.
#[cfg(test)]
fn corner(rng: &mut fastrand::Rng) -> [f64; 2] {
    let mut near = || rng.f64() * 10.0_f64.powf(-4.0 * rng.f64());
    let (close, apart) = (near(), near());
    let x = if rng.bool() { rng.f64() } else { 1.0 - close };
    [x, if rng.bool() { rng.f64() } else { x - apart }]
}

/// A number moved by as much as its digits, or as little.
#[cfg(test)]
fn nudged<T: Scalar>(rng: &mut fastrand::Rng, v: T) -> T {
    T::of(v.into() + (rng.f64() - 0.5) * 10.0_f64.powf(-16.0 * rng.f64()))
}

#[cfg(test)]
fn worst_back<T: Scalar>(projection: Projection) -> (f64, FacePoint<T>) {
    let bounded = |v: T| if v.abs() > T::ONE { T::ONE.copysign(v) } else { v };
    climb(
        |rng| {
            let [x, y] = corner(rng).map(|v| bounded(T::of(v)));
            // Of the other faces Healpix's equatorial ones alone are different.
            FacePoint::new(rng.choice([Face::Top, Face::Front]).unwrap(), x, y).unwrap()
        },
        |rng, at| {
            let [x, y] = [at.x(), at.y()].map(|v| bounded(nudged(rng, v)));
            FacePoint::new(at.face(), x, y).unwrap()
        },
        |point| error_back(projection, point).unwrap(),
    )
}

/// Forward in `f32`, next to `f64`.
#[cfg(test)]
fn worst_forward(projection: Projection) -> (f64, Direction<f32>) {
    let unit = |[x, y, z]: [f32; 3]| Direction::new(x, y, z).unwrap();
    climb(
        |rng| {
            let [x, y] = corner(rng).map(|v| v as f32);
            let [x, y, z] = unit([x, y, 1.0]).to_array();
            unit(if rng.bool() { [x, y, z] } else { [z, y, x] })
        },
        |rng, at| unit(at.to_array().map(|v| nudged(rng, v))),
        |direction| {
            let [x, y, z] = direction.to_array().map(f64::from);
            let (point, exact) = (projection.project(direction), Direction::new(x, y, z).unwrap());
            let face = point.face();
            if face != projection.face(exact) {
                return 0.0;
            }
            let [x, y] = projection.forward(face, face.to_local(exact.to_array()));
            let off = |found: f32, exact: f64| (f64::from(found) - exact.clamp(-1.0, 1.0)).abs();
            maximum(off(point.x(), x), off(point.y(), y))
        },
    )
}

/// No place is found where a projection is farther from the truth than claimed, forward (in `f32`) or back.
#[cfg(test)]
#[test]
#[ignore = "a search of minutes"]
fn climbing_finds_nothing_worse() {
    let mut exceeded = vec![];
    let mut hold = |what: String, error: f64, claimed: f64, place: &dyn core::fmt::Debug| {
        println!("{what}: {error:.3e} of {claimed:e} at {place:?}");
        if error > claimed {
            exceeded.push(what);
        }
    };
    for &projection in Projection::ALL {
        let (forward, back) = claims_of(projection);
        let (error, place) = worst_forward(projection);
        hold(format!("{projection} forward, f32"), error, forward[1], &place);
        let (error, place) = worst_back::<f32>(projection);
        hold(format!("{projection} back, f32"), error, back[1], &place);
        let middle = FacePoint::new(Face::Front, 0.0, 0.0).unwrap();
        if exact::<f64>(projection, middle).is_none() {
            println!("{projection} back, f64: not searched, no formula in twice the digits");
            continue;
        }
        let (error, place) = worst_back::<f64>(projection);
        hold(format!("{projection} back, f64"), error, back[0], &place);
    }
    assert!(exceeded.is_empty(), "{exceeded:?}");
}

/// The formula back leads from where a direction is put to where it was.
fn forward_is_true<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let direction = bytes.direction::<T>();
    if projection == Projection::Cobe {
        return; // its formula back is another map's
    }
    let point = projection.project(direction);
    let Some(exact) = exact(projection, point) else { return };
    // The direction need not be of unit length, so the angle counts; of the small rest all.
    let [high, low] = [0, 1].map(|part| exact.map(|component| component[part]));
    let error = angle(high, direction.to_array().map(Into::into)) - vector::length(low);
    let (claimed, _) = claims_of(projection);
    assert!(
        error <= STEP * claimed[T::CLAIM],
        "{projection} {}: {direction:?} is put at {point:?}, {error:e} off",
        T::NAME
    );
}

/// The direction of a point in Earth axes, each component as a sum of two numbers.
fn exact<T: Scalar>(projection: Projection, point: FacePoint<T>) -> Option<[[f64; 2]; 3]> {
    let face = point.face();
    let (x, y) = (point.x().into(), point.y().into());
    let local = match reference::direction(projection, face.is_polar(), [x, y]) {
        Some(local) => local,
        None if T::NAME == "f32" => projection.inverse(face, [x, y]).map(|component| [component, 0.0]),
        None => return None,
    };
    let [high, low] = [0, 1].map(|part| face.to_earth(local.map(|component| component[part])));
    Some(core::array::from_fn(|i| [high[i], low[i]]))
}

/// A symmetry of the cube: an axis of the Earth for each axis, and its sign.
#[derive(Clone, Copy, Debug)]
struct Symmetry {
    axes: [usize; 3],
    signs: [bool; 3],
}

impl Symmetry {
    fn apply<T: Real>(self, vector: [T; 3]) -> [T; 3] {
        core::array::from_fn(|i| {
            let component = vector[self.axes[i]];
            if self.signs[i] { -component } else { component }
        })
    }
}

/// By how many ulps of 1 swapping right and up may differ from swapping x and y, forward and inverse.
fn swap(projection: Projection) -> [f64; 2] {
    match projection {
        // The product of the sum and the difference of uv.
        Projection::Cartesian => [3.0, 0.0],
        // On the diagonals, where x and y are computed differently.
        Projection::Conformal => [2.0, 2.0],
        _ => [0.0, 0.0],
    }
}

/// A direction turned or mirrored by one of the 48 symmetries of the cube goes to the point turned or mirrored by it, in every bit but
/// what [`swap`] says. If the polar faces are others, it has the 16 that leave the poles poles; if x and y differ on each face, the 8
/// mirrors. On a tie of two faces the points are one direction.
fn symmetries<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let kinds = match projection.faces() {
        Faces::Alike => 6,
        Faces::SideAndPolar => 2,
        _ => 1,
    };
    let axes = [[0, 1, 2], [1, 0, 2], [0, 2, 1], [2, 1, 0], [1, 2, 0], [2, 0, 1]];
    let symmetry = Symmetry {
        axes: bytes.choice(&axes[..kinds]),
        signs: [bytes.flag(), bytes.flag(), bytes.flag()],
    };
    let direction = bytes.direction::<T>();
    let [x, y, z] = symmetry.apply(direction.to_array());
    let moved = Direction::new(x, y, z).unwrap();
    if moved.to_array() != [x, y, z] {
        return; // another order of the sum calls it no unit vector
    }
    let point = projection.project(direction);
    let image = projection.project(moved);
    let context = || {
        format!(
            "{projection} {}: {symmetry:?} of {direction:?}: {point:?}, {image:?}",
            T::NAME
        )
    };

    // The point as a vector of the unfolded cube: its face's frame with the coordinates in place of right and up.
    let on_cube = |point: FacePoint<T>| point.face().to_earth([point.x(), point.y(), T::ONE]);
    let (expected, found) = (symmetry.apply(on_cube(point)), on_cube(image));
    let outward = symmetry.apply(point.face().to_earth([T::ZERO, T::ZERO, T::ONE]));
    let same_face = image.face().to_local(outward) == [T::ZERO, T::ZERO, T::ONE];
    if same_face {
        let allowed = swap(projection)[0];
        assert!((0..3).all(|i| ulps(expected[i], found[i]) <= allowed), "{}", context());
    } else {
        // A tie, and the other face is taken: both are on the border.
        let border = |point: FacePoint<T>| {
            point.x().abs() >= T::ONE - T::of(2.0) * T::EPSILON || point.y().abs() >= T::ONE - T::of(2.0) * T::EPSILON
        };
        assert!(border(point) && border(image), "{}", context());
    }

    // And back.
    let back = symmetry.apply(projection.unproject(point).to_array());
    let from = projection.unproject(image).to_array();
    let allowed = swap(projection)[1] + if same_face { swap(projection)[0] } else { 4.0 };
    let allowed = allowed * 0.5 * T::EPSILON.into() * 2.0;
    assert!(
        apart(back.map(Into::into), from.map(Into::into)) <= allowed,
        "{}: {back:?} {from:?}",
        context()
    );
}

/// A latitude and longitude come back from the cube, for any shift.
fn ellipsoid<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let shift = bytes.choice(Shift::ALL);
    let (least, most) = match shift {
        Shift::Geodetic | Shift::Geocentric | Shift::Parametric => (-1.0, 0.5),
        _ => (-1.0 / 9.0, 0.1),
    };
    let ellipsoid = bytes.ellipsoid::<T>(least, most);
    let place = bytes.place::<T>();
    if projection == Projection::Cobe {
        return;
    }
    let map = CubeMap::new(ellipsoid, shift, projection).unwrap();
    let point = map.project(place);
    let back = map.unproject(point);
    let north = back.lat().into() - place.lat().into();
    let east = (back.lon().into() - place.lon().into() + 540.0).rem_euclid(360.0) - 180.0;
    let moved = north.hypot(east * place.lat().into().to_radians().cos()).to_radians();
    let claimed = claim("LatLon to FacePoint and back, any projection and shift")[T::CLAIM] / 6_378_137.0;
    // A step of the sphere's latitude is one of up to (1 − f)^±2 of the geodetic.
    let squeeze = (1.0 - ellipsoid.f().into()).powi(2);
    let stretch = maximum(squeeze, 1.0 / squeeze);
    assert!(
        moved <= claimed * stretch,
        "{projection} {shift} {} {ellipsoid:?}: {place:?}, {point:?}, {back:?}: {moved:e} rad",
        T::NAME
    );
}

/// To the right of a point of the same row, x is greater, both ways; by a rounding it may fall back by 4 ulps of 1. Likewise y upward.
/// (Healpix's rows are not those of the cube.)
fn grows<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    if projection == Projection::Healpix {
        return;
    }
    let face = bytes.face();
    let row = bytes.within::<T>(1.0);
    let (a, b) = (bytes.within::<T>(1.0), bytes.within::<T>(1.0));
    let (low, high) = if a < b { (a, b) } else { (b, a) };
    let upward = bytes.flag();
    let pair = |along: T| if upward { [row, along] } else { [along, row] };
    let picked = |[x, y]: [T; 2]| if upward { y } else { x };
    let forward = |along: T| {
        let [u, v] = pair(along);
        let [x, y, z] = face.to_earth([u, v, T::ONE]);
        let unit = Direction::new(x, y, z).unwrap();
        picked(projection.forward(face, face.to_local(unit.to_array())))
    };
    let inverse = |along: T| {
        let [right, up, outward] = projection.inverse(face, pair(along));
        picked([right / outward, up / outward])
    };
    for (way, [first, second]) in [
        ("forward", [low, high].map(forward)),
        ("inverse", [low, high].map(inverse)),
    ] {
        assert!(
            second >= first || ulps(first, second) <= 4.0,
            "{projection} {} {way}: {face:?} row {row:?}, {low:?} to {first:?}, {high:?} to {second:?}",
            T::NAME
        );
    }
}

/// On a cube that is turned and stretched a direction is where the plain cube has it, and comes back from there; every point is a
/// unit vector.
fn oblique<T: Scalar>(bytes: &mut Bytes<'_>) {
    let projection = bytes.projection();
    let (face, place) = (bytes.face(), bytes.place::<f64>());
    let rotation = Rotation::facing(face, place.to_direction(), bytes.within(360.0)).unwrap();
    let factor = (4.0 * bytes.even()).exp2();
    let turned = Turned::new(projection, rotation);
    let stretched = Turned::new(Stretched::new(projection, factor).unwrap(), rotation);
    let direction = bytes.direction::<T>();
    let context = || format!("{projection} {} {rotation:?} {factor}: {direction:?}", T::NAME);
    let double = |direction: Direction<T>| direction.to_array().map(Into::into);

    let point = turned.project(direction);
    let moved = angle(double(direction), double(turned.unproject(point)));
    let rounding = 4.0 * T::EPSILON.into();
    assert!(moved <= closes::<T>(projection) + rounding, "{}: {moved:e}", context());
    let [x, y, z] = turned.to_cube(direction.to_array());
    if let Ok(on_cube) = Direction::new(x, y, z) {
        assert_eq!(point.face(), turned.face(direction), "{}", context());
        let moved = angle(
            double(projection.unproject(projection.project(on_cube))),
            double(projection.unproject(point)),
        );
        assert!(moved <= closes::<T>(projection) + rounding, "{}: {moved:e}", context());
    }

    // Where cells are wide, a step on the cube is a long one.
    let wide = if factor > 1.0 { factor } else { 1.0 / factor };
    let point = stretched.project(direction);
    let back = stretched.unproject(point);
    let moved = angle(double(direction), double(back));
    let allowed = wide * (closes::<T>(projection) + rounding);
    assert!(moved <= allowed, "{}: {moved:e} of {allowed:e}", context());
    for vector in [
        double(back),
        double(turned.unproject(bytes.point())),
        double(stretched.unproject(point)),
    ] {
        assert!(
            excess(vector).abs() <= 14.0 * T::EPSILON.into(),
            "{}: {vector:?}",
            context()
        );
    }
}
