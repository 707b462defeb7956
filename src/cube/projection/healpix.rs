use super::decay::creased;
use super::profile::{Kept, projection};
use super::{CubeProjection, Face, Faces, on_face};
use crate::math::{ADJUSTED_U, ADJUSTED_X, either, odd_unit, select};
use crate::{Direction, Real};

projection! {
    #[doc(alias = "rHEALPix")]
    Healpix "healpix" {
        title: "HEALPix",
        also: "rHEALPix, hierarchical equal-area iso-latitude pixelation",
        summary: "rHEALPix, HEALPix on a cube: equal-area, with faces that meet along parallels.",
        idea: "Where the absolute value of the sine of the latitude is below ⅔, the side faces are Lambert’s \
            cylindrical equal-area projection. Beyond, each pole has a square of four triangles, in which \
            parallels become squares around the pole.",
        origin: "Górski and others (2005), arranged as in Dimitrijević, Lambers & Rančić (2016), §4.7. The \
            arrangement is that of rHEALPix (Gibb, Raichev & Speth 2013; PROJ’s `rhealpix`) with one \
            difference: the side faces are centred on the longitudes 0°, 90°, 180° and 270° here, and on \
            45°, 135°, 225° and 315° in rHEALPix and in standard HEALPix. So a place has the coordinates \
            here that the place 45° to its east has there; [`Turned`](crate::cube::Turned) has an example of \
            PROJ’s coordinates.",
        choose: "Take it for equal areas where rows of cells should follow parallels. Between latitude and \
            longitude and the cube, use a [`CubeMap`](crate::cube::CubeMap): it computes this projection \
            without unit vectors. [`Vertex`](super::Vertex) has equal areas with less distortion (ω 20.3° \
            instead of 49.3°, aspect ratio 2.035 instead of 3.334). The pixels of standard HEALPix, which \
            are diamonds, are in [`healpix`](crate::healpix).",
        keeps: Some(Kept::Areas),
        area_ratio: 1.000,
        aspect_ratio: 3.334,
        oversize: 3.334,
        deformation: 49.3,
        forward: Polynomial, error [5.3e-16, 2.9e-7], instructions [190, 170];
        inverse: Polynomial, error [5.2e-16, 2.9e-7], instructions [130, 110];
        tiles: creased(0.565, 2.77),
    }
}

/// Whether a latitude is a cap's, by its sine.
#[inline(always)]
fn is_cap<T: Real>(sin: T) -> bool {
    T::of(3.0) * sin.abs() >= T::of(2.0)
}

impl CubeProjection for Healpix {
    const KEEPS_AREAS: bool = true;

    const TAKES_PLACES: bool = true;

    #[inline(always)]
    fn faces(&self) -> Faces {
        Faces::SideAndPolar
    }

    #[inline(always)]
    fn is_polar<T: Real>(&self, direction: Direction<T>) -> bool {
        is_cap(direction.z())
    }

    #[inline(always)]
    fn forward<T: Real>(&self, face: Face, [right, up, outward]: [T; 3]) -> [T; 2] {
        let polar = face.is_polar();
        let length = (right * right + up * up + outward * outward).sqrt();
        // The longitude within its quarter: on a side face from the centre of the face, on a polar face from
        // that of the triangle.
        let steep = polar & (up.abs() > right.abs());
        let major = select(polar, select(steep, up, right), outward);
        let minor = select(steep | !polar, right, up);
        let t = minor / select(major == T::ZERO, T::ONE, major);
        let longitude = odd_unit(t, &ADJUSTED_X);
        // √(3(1 − z)) without the difference.
        let sigma = major * (T::of(3.0) * (T::ONE + t * t) / (length * (length + outward))).sqrt();
        let side = [longitude, T::of(1.5) * up / length];
        let cap = select(steep, [sigma * longitude, sigma], [sigma, sigma * longitude]);
        select(polar, cap, side)
    }

    #[inline(always)]
    fn project_place<T: Real>(&self, (sin, cos): (T, T), lon: T) -> [T; 3] {
        let polar = is_cap(sin);
        let right_angle = T::of(90.0);
        let from_y = (lon.abs() - right_angle).abs();
        // The side face, or the triangle of a cap: of the y axis or of the x axis, and on which side.
        let sideways = from_y <= T::of(45.0);
        let sign = T::ONE.copysign(select(sideways, lon, right_angle - lon.abs()));
        let middle = select(sideways, right_angle, either(sign < T::ZERO, T::of(180.0))).copysign(lon);
        let east = lon - middle;
        // A zero tells 180 from −180.
        let along = select(sideways, east, east.signed_like(sign * lon)) * T::of(1.0 / 45.0);
        // √(3(1 − |sin φ|)) without the difference.
        let outward = sign * cos * (T::of(3.0) / (T::ONE + sin.abs())).sqrt();
        let across = outward * along;
        let north = T::ONE.copysign(sin);
        let cap = [
            select(sideways, outward, across),
            north * select(sideways, across, -outward),
        ];
        let side = [along, T::of(1.5) * sin];
        let [x, y] = on_face(select(polar, cap, side));
        let of_side = select(sideways, T::of(2.0), T::ONE) - sign;
        [select(polar, T::of(4.5) - T::of(0.5) * north, of_side), x, y]
    }

    #[inline(always)]
    fn unproject_place<T: Real>(&self, [number, x, y]: [T; 3]) -> ((T, T), T) {
        let (one, half) = (T::ONE, T::of(0.5));
        let polar = number > T::of(3.5);
        // As seen from the north.
        let north = one.copysign(T::of(4.5) - number);
        let y_north = north * y;
        let steep = y.abs() > x.abs();
        let (outward, across) = (select(steep, -y_north, x), select(steep, x, y_north));
        let sideways = select(
            polar,
            either(!steep, one),
            either((number - T::of(2.0)).abs() == one, one),
        ) > half;
        let sign = one.copysign(select(polar, outward, T::of(1.5) - number));
        let along = select(polar, across / select(outward == T::ZERO, one, outward), x);
        let right_angle = T::of(90.0);
        let middle = select(
            sideways,
            sign * right_angle,
            either(sign < T::ZERO, T::of(-180.0).copysign(-along)),
        );
        let lon = T::of(45.0) * along + middle;

        let height = y * T::of(2.0 / 3.0);
        let side = (height, ((one - height) * (one + height)).sqrt());
        let square = outward * outward;
        let cap = (
            north * (one - square * T::of(1.0 / 3.0)),
            outward.abs() * (T::of(6.0) - square).sqrt() * T::of(1.0 / 3.0),
        );
        (select(polar, cap, side), lon)
    }

    #[inline(always)]
    fn inverse<T: Real>(&self, face: Face, [x, y]: [T; 2]) -> [T; 3] {
        let polar = face.is_polar();
        let steep = y.abs() > x.abs();
        let sigma = select(steep, y, x);
        let along = select(steep, x, y) / select(sigma == T::ZERO, T::ONE, sigma);
        let t = odd_unit(select(polar, along, x), &ADJUSTED_U);
        let cosine = T::ONE / (T::ONE + t * t).sqrt();

        let height = y * T::of(2.0 / 3.0);
        let radius = (T::ONE - height * height).sqrt() * cosine;
        let side = [t * radius, height, radius];

        let square = sigma * sigma;
        let major = sigma * (T::of(6.0) - square).sqrt() * T::of(1.0 / 3.0) * cosine;
        let minor = t * major;
        let outward = T::ONE - square * T::of(1.0 / 3.0);
        let [right, up] = select(steep, [minor, major], [major, minor]);
        select(polar, [right, up, outward], side)
    }
}
