use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    Tanh "tanh" {
        title: "Hyperbolic tangent",
        also: "",
        summary: "Lambers’ hyperbolic tangent: x = tanh(cu)/tanh c, c = 0.9721.",
        idea: "A hyperbolic tangent in each coordinate takes the place of the adjusted cube’s arc tangent.",
        origin: "Lambers’ survey of cube maps for interactive graphics (2019).",
        choose: "Take it for the areas that vary least among maps of each coordinate alone (1.243 to 1). \
            [`Algebraic`](super::Algebraic) costs less, and its areas vary little more (1.268 to 1).",
        keeps: None,
        area_ratio: 1.243,
        aspect_ratio: 2.606,
        oversize: 2.606,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1.1e-7], instructions [120, 94];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [100, 76];
        tiles: smooth(1.14, 1.37),
    }
}

odd! { Tanh, TANH_X, TANH_U }
