use crate::character::Facing;
use glam::Vec3;
use std::collections::BTreeSet;

/// Settings of inverse kinematics of a character, with its pins.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IkSettings {
    /// Number of joints that turn, at least 1; fewer if a root or a pin comes first, and of
    /// [`IkSettings::LIMB`] only one if the other is where limbs meet.
    pub length: usize,
    /// Direction in which knees and elbows point.
    pub pole: IkPole,
    /// Whether the joint that is dragged keeps its orientation, as a foot that stays flat.
    pub keep_orientation: bool,
    /// Indices of the joints that keep their position and orientation.
    pub pins: BTreeSet<usize>,
}

impl IkSettings {
    /// Greatest length of a chain, in joints.
    pub const LONGEST: usize = 999;
    /// Usual length of a chain: thigh and shin, upper arm and forearm.
    pub const LIMB: usize = 2;
}

impl Default for IkSettings {
    fn default() -> Self {
        Self {
            length: Self::LIMB,
            pole: IkPole::default(),
            keep_orientation: true,
            pins: BTreeSet::new(),
        }
    }
}

/// Direction in which a chain bends, relative to the character at rest ([`Facing`]).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum IkPole {
    /// As it is bent already; a straight chain like a knee or an elbow.
    #[default]
    AsBent,
    /// To the front.
    Front,
    /// To the back.
    Back,
    /// To the character's left.
    Left,
    /// To the character's right.
    Right,
    /// +Y.
    Up,
    /// -Y.
    Down,
}

impl IkPole {
    /// All directions, in the order of the panel.
    pub const ALL: [Self; 7] = [
        Self::AsBent,
        Self::Front,
        Self::Back,
        Self::Left,
        Self::Right,
        Self::Up,
        Self::Down,
    ];

    /// Name in the panel, with the axis of the direction for a character of this facing.
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

    /// Unit vector in the character's space, for a character of this facing; `None` for
    /// [`IkPole::AsBent`].
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
