use super::decay::smooth;
use super::profile::projection;
use super::tangent::tangent;

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
            to the sphere (63 instructions instead of 93).",
        keeps: None,
        area_ratio: 1.637,
        aspect_ratio: 1.587,
        oversize: 1.587,
        deformation: 31.1,
        forward: Trigonometric, error [3.0e-16, 1.6e-7], instructions [190, 180];
        inverse: Trigonometric, error [3.1e-16, 1.7e-7], instructions [93, 68];
        tiles: smooth(0.86, 1.15),
    }
}

tangent! { Separable, 0.724_013_050_605_694 }
