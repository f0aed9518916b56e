/// Axes along which alone a drag moves or scales. Numbers are axes: 0 for x, 1 for y, 2 for z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Constraint {
    /// One axis.
    Axis(usize),
    /// The plane of the two axes other than this one.
    Plane(usize),
}

impl Constraint {
    /// The axis that it is named after: the only one, or the normal of the plane.
    pub fn named(self) -> usize {
        match self {
            Self::Axis(axis) | Self::Plane(axis) => axis,
        }
    }

    /// The axes that are free, in their order.
    pub fn axes(self) -> impl Iterator<Item = usize> {
        (0..3).filter(move |&axis| match self {
            Self::Axis(only) => axis == only,
            Self::Plane(normal) => axis != normal,
        })
    }
}
