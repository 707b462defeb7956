use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    ZuckerHigashi "zucker-higashi" {
        title: "Zucker & Higashi’s tangent",
        also: "",
        summary: "Zucker & Higashi’s tangent: u = tan(θx)/tan θ, θ = 0.8687.",
        idea: "It is the adjusted cube with a larger angle, for which the authors’ measure of areas is least.",
        origin: "Zucker & Higashi (2018), Cube-to-sphere projections for procedural texturing and beyond, JCGT 7(2).",
        choose: "Take it to agree with programs that use it. [`Algebraic`](super::Algebraic) costs less and varies \
            less, in area (1.268 to 1 instead of 1.305 to 1) and in texture oversize (2.712 instead of 2.875).",
        keeps: None,
        area_ratio: 1.305,
        aspect_ratio: 2.875,
        oversize: 2.875,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1.1e-7], instructions [130, 110];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [90, 66];
        tiles: smooth(0.99, 1.74),
    }
}

odd! { ZuckerHigashi, ZUCKER_HIGASHI_X, ZUCKER_HIGASHI_U }
