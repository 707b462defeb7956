use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    Lambers "lambers" {
        title: "Lambers’ tangent",
        also: "",
        summary: "Lambers’ tangent: u = tan(x·atan c)/c, c = 1.1968.",
        idea: "It is the adjusted cube with a larger angle.",
        origin: "Lambers’ survey of cube maps for interactive graphics (2019).",
        choose: "Take it to agree with programs that use it. [`Algebraic`](super::Algebraic) costs less and varies \
            less, in area (1.268 to 1 instead of 1.324 to 1) and in texture oversize (2.712 instead of 2.958).",
        keeps: None,
        area_ratio: 1.324,
        aspect_ratio: 2.958,
        oversize: 2.958,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1.1e-7], instructions [130, 110];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [92, 66];
        tiles: smooth(1.01, 1.77),
    }
}

odd! { Lambers, LAMBERS_X, LAMBERS_U }
