use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    #[doc(alias = "EAC")]
    #[doc(alias = "ASC")]
    #[doc(alias = "equiangular")]
    Adjusted "adjusted" {
        title: "Adjusted",
        also: "equi-angular cube, EAC, ASC",
        summary: "The adjusted (equi-angular) cube, ASC, EAC: x = 4/π·atan u.",
        idea: "Equal steps along the midline of a face are equal angles at the centre of the sphere. Each \
            coordinate of the tangential cube is replaced by its arc tangent, scaled so that 45° is on the \
            edge.",
        origin: "The cubed sphere of Ronchi, Iacono & Paolucci (1996), for models of the atmosphere; \
            Google’s EAC for panoramic video; the option \"tan\" of S2; Dimitrijević, Lambers & Rančić \
            (2016), §4.2.",
        choose: "Take it for agreement with equi-angular cube maps. Of the published projections here \
            [`Continuous`](super::Continuous) alone has less texture oversize (1.805 instead of 2.000); \
            [`Balanced`](super::Balanced) has 1.405 and costs less on the way to the sphere. \
            [`Algebraic`](super::Algebraic) costs less (79 instructions to the cube instead of 130), and its \
            areas vary less (1.268 to 1 instead of 1.414 to 1), but its texture oversize is 2.712.",
        keeps: None,
        area_ratio: 1.414,
        aspect_ratio: 2.000,
        oversize: 2.000,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1e-7], instructions [130, 100];
        inverse: Polynomial, error [2.7e-16, 1.4e-7], instructions [88, 64];
        tiles: smooth(0.79, 1.37),
    }
}

odd! { Adjusted, ADJUSTED_X, ADJUSTED_U }
