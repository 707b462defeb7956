use super::decay::smooth;
use super::odd::odd;
use super::profile::projection;

projection! {
    #[doc(alias = "FV3")]
    EquiEdge "equi-edge" {
        title: "Equi-edge",
        also: "equal-distance gnomonic grid",
        summary: "The equi-edge cube of FV3: u = √2·tan(x·atan(1/√2)).",
        idea: "It is the adjusted cube, but steps are of equal angle along the edges of the cube instead of \
            the midlines of its faces.",
        origin: "FV3, the dynamical core of the weather forecast of the United States and of NASA’s GEOS \
            model.",
        choose: "Take it to exchange data with FV3. Its cells are nearly square (aspect ratio 1.125), but \
            their areas vary more than those of [`Adjusted`](super::Adjusted) (2.309 to 1 instead of 1.414 \
            to 1). [`Square`](super::Square) has squarer cells (1.013) and areas that vary slightly less \
            (2.229 to 1).",
        keeps: None,
        area_ratio: 2.309,
        aspect_ratio: 1.125,
        oversize: 2.000,
        deformation: 31.1,
        forward: Polynomial, error [1.9e-16, 1e-7], instructions [120, 92];
        inverse: Polynomial, error [2.7e-16, 1.5e-7], instructions [82, 62];
        tiles: smooth(0.97, 1.02),
    }
}

odd! { EquiEdge, EQUI_EDGE_X, EQUI_EDGE_U }
