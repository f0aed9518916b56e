use glam::Vec3;
use std::collections::BTreeSet;

/// How the IK tool brings what it is given to the pointer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IkSettings {
    /// How many joints turn, at least 1; fewer where a root or a pin comes before.
    pub length: usize,
    /// Where knees and elbows point to.
    pub pole: IkPole,
    /// Whether the joint that is dragged stays turned as it is, as a foot stays flat.
    pub keep_orientation: bool,
    /// Joints of the character that stay where they are, and as they are turned.
    pub pins: BTreeSet<usize>,
}

impl Default for IkSettings {
    fn default() -> Self {
        Self {
            // Thigh and shin, upper arm and forearm.
            length: 2,
            pole: IkPole::default(),
            keep_orientation: true,
            pins: BTreeSet::new(),
        }
    }
}

/// Where a chain bends to, in the character's own space: figures look along +Z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IkPole {
    /// As it is bent already; straight ones as a knee or an elbow.
    #[default]
    AsBent,
    /// +Z.
    Front,
    /// -Z.
    Back,
    /// +X, which is the left of a figure.
    Left,
    /// -X.
    Right,
    /// +Y.
    Up,
    /// -Y.
    Down,
}

impl IkPole {
    /// All, in the order of the panel.
    pub const ALL: [Self; 7] = [
        Self::AsBent,
        Self::Front,
        Self::Back,
        Self::Left,
        Self::Right,
        Self::Up,
        Self::Down,
    ];

    /// Its name in the panel.
    pub fn label(self) -> &'static str {
        match self {
            Self::AsBent => "as it is",
            Self::Front => "front (+Z)",
            Self::Back => "back (−Z)",
            Self::Left => "left (+X)",
            Self::Right => "right (−X)",
            Self::Up => "up (+Y)",
            Self::Down => "down (−Y)",
        }
    }

    /// The direction, of unit length.
    pub fn direction(self) -> Option<Vec3> {
        match self {
            Self::AsBent => None,
            Self::Front => Some(Vec3::Z),
            Self::Back => Some(Vec3::NEG_Z),
            Self::Left => Some(Vec3::X),
            Self::Right => Some(Vec3::NEG_X),
            Self::Up => Some(Vec3::Y),
            Self::Down => Some(Vec3::NEG_Y),
        }
    }
}
