use glam::DVec3;
use serde::{Serialize, Serializer};

const NAMES: [[&str; 2]; 3] = [["x", "-x"], ["y", "-y"], ["z", "-z"]];

/// An axis or its opposite.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SignedAxis {
    /// 0 to 2 for x, y and z.
    pub axis: usize,
    /// Whether it points the other way.
    pub is_reversed: bool,
}

impl SignedAxis {
    /// Its name, such as `-z`.
    pub fn name(self) -> &'static str {
        NAMES[self.axis][usize::from(self.is_reversed)]
    }

    /// The coordinate of `point` along it.
    pub(super) fn of(self, point: DVec3) -> f64 {
        let along = point[self.axis];
        if self.is_reversed { -along } else { along }
    }
}

impl Serialize for SignedAxis {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.serialize_str(self.name())
    }
}
