use crate::character::Facing;
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

/// Where a chain bends to, as the character stands at rest ([`Facing`]), in its own space.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum IkPole {
    /// As it is bent already; straight ones as a knee or an elbow.
    #[default]
    AsBent,
    /// Where the character looks.
    Front,
    /// Behind it.
    Back,
    /// To its left.
    Left,
    /// To its right.
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

    /// Its name in the panel, with the axis that it is along for a character of this facing.
    pub fn label(self, facing: Facing) -> String {
        let word = match self {
            Self::AsBent => "as it is",
            Self::Front => "front",
            Self::Back => "back",
            Self::Left => "left",
            Self::Right => "right",
            Self::Up => "up",
            Self::Down => "down",
        };
        let Some(direction) = self.direction(facing) else {
            return word.to_owned();
        };
        let sign = if direction.element_sum() < 0.0 {
            '−'
        } else {
            '+'
        };
        let axis = ['X', 'Y', 'Z'][direction.abs().max_position()];
        format!("{word} ({sign}{axis})")
    }

    /// The direction, of unit length, for a character of this facing.
    pub fn direction(self, facing: Facing) -> Option<Vec3> {
        match self {
            Self::AsBent => None,
            Self::Front => Some(facing.front()),
            Self::Back => Some(-facing.front()),
            Self::Left => Some(facing.left()),
            Self::Right => Some(-facing.left()),
            Self::Up => Some(Vec3::Y),
            Self::Down => Some(Vec3::NEG_Y),
        }
    }
}
