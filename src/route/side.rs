use core::fmt;

/// On which side of a [`Fence`](super::Fence) a place is.
///
/// Written as `inside`, `outside` or `edge`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Side {
    /// Inside.
    Inside,
    /// Outside.
    #[default]
    Outside,
    /// On an edge, or so near to one that rounding decides: the surface says how near.
    Edge,
}

impl fmt::Display for Side {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Inside => "inside",
            Self::Outside => "outside",
            Self::Edge => "edge",
        })
    }
}
