use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    Separable "separable" {
        title: "Separable",
        also: "",
        summary: "The projection with the least texture oversize among those that treat each coordinate by \
            itself: u = tan(θx)/tan θ with θ = acos(2^(−5/12)).",
        idea: "It is the adjusted cube with an angle of 41.5° in place of 45°. Aspect ratio and texture \
            oversize are both 2^(2/3): no pair of maps u = w(x), v = w(y) has a smaller oversize.",
        origin: "Made for terrella.",
        choose: "Take it where x must be a function of u alone, and y of v alone. \
            [`Balanced`](super::Balanced) has less texture oversize (1.405 instead of 1.587) and costs less \
            to the sphere (63 instructions instead of 86).",
        keeps: None,
        area_ratio: 1.637,
        aspect_ratio: 1.587,
        oversize: 1.587,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1e-7], instructions [120, 100];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [86, 64];
        tiles: smooth(0.86, 1.15),
    }
}

odd! { Separable, SEPARABLE_X, SEPARABLE_U }
