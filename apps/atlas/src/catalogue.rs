//! What is to be said about each projection and cannot be measured.

use terrella::cube::Projection;

/// One projection in words.
pub struct Entry {
    pub projection: Projection,
    pub title: &'static str,
    /// Other names.
    pub also: &'static str,
    /// How it works.
    pub idea: &'static str,
    /// Where it comes from and who uses it.
    pub origin: &'static str,
    /// How a place on the cube is computed from one on the sphere.
    pub forward: Method,
    /// How a place on the sphere is computed from one on the cube.
    pub inverse: Method,
}

/// How an answer is computed.
#[derive(Clone, Copy)]
pub enum Method {
    /// A formula of arithmetic and square roots only.
    Algebraic,
    /// A formula with trigonometric functions.
    Closed,
    /// A polynomial fitted to the purpose.
    Fitted,
    /// The sum of a power series.
    Series,
    /// A few steps of Newton's method.
    Newton,
}

impl Method {
    /// What it is called on the page.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Algebraic => "algebraic",
            Self::Closed => "closed form",
            Self::Fitted => "fitted polynomial",
            Self::Series => "power series",
            Self::Newton => "iteration",
        }
    }
}

/// The words about a projection; none about one that is newer than this catalogue.
pub fn entry(projection: Projection) -> Option<&'static Entry> {
    ENTRIES.iter().find(|entry| entry.projection == projection)
}

const ENTRIES: &[Entry] = &[
    Entry {
        projection: Projection::Tangential,
        title: "Tangential",
        also: "gnomonic cube, TSC",
        idea: "A lamp at the centre of the Earth casts every point straight onto a cube around it. Great circles become straight \
               lines, and a cell in the middle of a face covers five times the ground of one in its corner.",
        origin: "The cube map of every graphics card, the box of every sky in a game, and TSC in the FITS standard of astronomy.",
        forward: Method::Algebraic,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::Adjusted,
        title: "Adjusted",
        also: "equi-angular cube, EAC, ASC",
        idea: "Equal steps along the midline of a face are equal angles at the centre of the Earth: each coordinate of the tangential \
               cube is replaced by its arc tangent, scaled so that 45° falls on the edge.",
        origin: "The cubed sphere of Ronchi, Iacono and Paolucci (1996), on which many models of the atmosphere compute; Google’s EAC \
                 for panoramic video; the “tan” option of the S2 library.",
        forward: Method::Closed,
        inverse: Method::Closed,
    },
    Entry {
        projection: Projection::Outerra,
        title: "Outerra",
        also: "OSC",
        idea: "The flat face is first puffed up like a cushion, by (√2 − 1)/2 · (1 − x²)(1 − y²), and every point of the cushion is then \
               drawn straight in to the sphere. Cells are almost as wide as high everywhere.",
        origin: "The planet engine Outerra, where it keeps the texture of the ground from looking stretched.",
        forward: Method::Newton,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::Cobe,
        title: "COBE",
        also: "COBE sky cube, CSC",
        idea: "A polynomial in the coordinates of the tangential cube, fitted to spread area almost evenly, and a second polynomial, \
               fitted to lead back again. There and back is not quite the same point.",
        origin: "The sky maps of NASA’s Cosmic Background Explorer (1989 to 1993), after Chan and O’Neill (1975); CSC in the FITS \
                 standard. The figures here are those of the published way back.",
        forward: Method::Fitted,
        inverse: Method::Fitted,
    },
    Entry {
        projection: Projection::CobeExact,
        title: "COBE, exact",
        also: "",
        idea: "COBE’s polynomial from the sphere to the cube, with the way back found by solving that very polynomial instead of \
               fitting another. There and back is the same point.",
        origin: "For those who want COBE’s cells without its gap between the two directions.",
        forward: Method::Fitted,
        inverse: Method::Newton,
    },
    Entry {
        projection: Projection::Quadrilateralized,
        title: "Quadrilateralized",
        also: "QSC, Snyder’s cube",
        idea: "Each face is cut along its diagonals into four triangles. In each, areas swept around the centre of the face and areas \
               gathered outward from it stay in proportion, so that every cell covers the same area. The price is a crease along both \
               diagonals.",
        origin: "O’Neill and Laubscher (1976); also found by Snyder (1992) and by Roşca and Plonka (2011). QSC in the FITS standard \
                 and in the cartographic library PROJ.",
        forward: Method::Closed,
        inverse: Method::Closed,
    },
    Entry {
        projection: Projection::Cartesian,
        title: "Cartesian",
        also: "Nowell’s cube, KSC",
        idea: "Each coordinate of a point on the cube is shrunk by a square root in which the squares of the other two stand, chosen so \
               that the three new squares always add up to one: x√(½ − y²/6) to the right, y√(½ − x²/6) upward.",
        origin: "Philip Nowell’s note on mapping a cube to a sphere (2005), a favourite of those who make planets for games.",
        forward: Method::Algebraic,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::Healpix,
        title: "HEALPix",
        also: "hierarchical equal-area iso-latitude pixelation",
        idea: "Around the equator, to where the sine of the latitude is ⅔, the side faces are a cylindrical equal-area map. Beyond, each \
               pole has a square of four triangles, whose parallels are squares around the pole.",
        origin: "Górski and others (2005), for the maps of the cosmic microwave background by WMAP and Planck. Here the faces meet along \
                 parallels near 42° north and south; the diamonds of the original are arranged as a cube.",
        forward: Method::Closed,
        inverse: Method::Closed,
    },
    Entry {
        projection: Projection::S2Quadratic,
        title: "S2, quadratic",
        also: "",
        idea: "An imitation of the adjusted cube with a parabola on either side of the midline: the coordinate of the tangential cube is \
               x(2 + |x|)/3.",
        origin: "The standard projection of Google’s S2 library, and so of the spatial indexes of many databases.",
        forward: Method::Algebraic,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::EquiEdge,
        title: "Equi-edge",
        also: "equal-distance gnomonic grid",
        idea: "The adjusted cube once more, but the steps of equal angle are measured along the edges of the cube instead of the \
               midlines of its faces.",
        origin: "FV3, the dynamical core of the weather forecast of the United States and of NASA’s GEOS model.",
        forward: Method::Closed,
        inverse: Method::Closed,
    },
    Entry {
        projection: Projection::Algebraic,
        title: "Algebraic",
        also: "",
        idea: "Another stand-in for the arc tangent, without a trigonometric function: the coordinate of the tangential cube is \
               x/√(1 + c²(1 − x²)) with c = 0.87.",
        origin: "Lambers’ survey of cube maps for interactive graphics (2019).",
        forward: Method::Algebraic,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::Vertex,
        title: "Vertex",
        also: "vertex-oriented equal-area cube",
        idea: "Equal-area in the manner of the quadrilateralized cube, but its triangles are sliced from the corners of the cube instead \
               of the centres of its faces. Every cell covers the same area and the creases all but vanish.",
        origin: "The slice-and-dice method of van Leeuwen and Strebe (2006), applied to the 48 triangles of the cube.",
        forward: Method::Closed,
        inverse: Method::Closed,
    },
    Entry {
        projection: Projection::Conformal,
        title: "Conformal",
        also: "",
        idea: "Small shapes keep their shape: every angle on the ground is the same angle on the cube. About each corner a power series \
               turns the 120° of a face on the sphere into the 90° of a square, and cells shrink to nothing there.",
        origin: "Rančić, Purser and Mesinger (1996), for models of ocean and atmosphere; the MIT general circulation model \
                 computes on it.",
        forward: Method::Series,
        inverse: Method::Series,
    },
    Entry {
        projection: Projection::Balanced,
        title: "Balanced",
        also: "",
        idea: "A polynomial with three coefficients, chosen by search so that cells differ as little as they can, be it in area or in \
               the ratio of their sides.",
        origin: "Made for terrella, to have the smallest texture oversize: 1.41, where the best of the older projections have 2.",
        forward: Method::Newton,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::Square,
        title: "Square",
        also: "",
        idea: "A polynomial found by search: cells as square as Outerra’s, with an area that varies much less.",
        origin: "Made for terrella.",
        forward: Method::Newton,
        inverse: Method::Algebraic,
    },
    Entry {
        projection: Projection::Separable,
        title: "Separable",
        also: "",
        idea: "The adjusted cube with a slightly smaller angle, 41.5° instead of 45°, which makes the worst ratio of sides equal to the \
               worst ratio of areas. No map that treats the two coordinates of a face apart can do better.",
        origin: "Made for terrella.",
        forward: Method::Closed,
        inverse: Method::Closed,
    },
];
