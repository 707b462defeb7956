use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    Unicube "unicube" {
        title: "Unicube",
        also: "",
        summary: "Unicube: u = s/√(½ − s²), s = sin(πx/6).",
        idea: "Great circles through two opposite points of the cube’s axis cut a face into strips of equal area, in \
            each coordinate.",
        origin: "Ho, Wan, Wong & Leung (2011), Unicube for dynamic environment mapping, IEEE TVCG 17(1).",
        choose: "Take it to agree with textures that were made with it. [`Algebraic`](super::Algebraic) costs less \
            and varies less, in area (1.268 to 1 instead of 1.333 to 1) and in texture oversize (2.712 instead \
            of 3.000).",
        keeps: None,
        area_ratio: 1.333,
        aspect_ratio: 3.000,
        oversize: 3.000,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1.1e-7], instructions [130, 100];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [98, 74];
        tiles: smooth(1.13, 1.11),
    }
}

odd! { Unicube, UNICUBE_X, UNICUBE_U }
