use super::decay::smooth;
use super::profile::projection;
use super::tangent::tangent;

projection! {
    Separable "separable" {
        title: "Separable",
        also: "",
        summary: "The best projection that treats the two coordinates apart: u = tan(θx)/tan θ with θ = \
            acos(2^(−5/12)).",
        idea: "It is the adjusted cube with an angle of 41.5° in place of 45°. Aspect ratio and area ratio \
            are both 2^(2/3), and no map u = w(x), v = w(y) has the larger of them smaller.",
        origin: "Made for terrella.",
        choose: "Take it where each coordinate must be a function of its own. \
            [`Balanced`](super::Balanced) has less texture oversize, and its way to the sphere is cheaper.",
        keeps: None,
        area_ratio: 1.637,
        aspect_ratio: 1.587,
        oversize: 1.587,
        deformation: 31.1,
        forward: Trigonometric, error [3.0e-16, 1.6e-7], instructions [220, 200];
        inverse: Trigonometric, error [3.1e-16, 1.7e-7], instructions [84, 58];
        tiles: smooth(0.86, 1.15),
    }
}

tangent! { Separable, 0.724_013_050_605_694 }
