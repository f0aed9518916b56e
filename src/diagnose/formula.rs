//! The formula of skinning as a value: what each mistake changes of it.

pub use super::angle_formula::{About, AngleAtEnd, AngleUnits, AnglesOf, RoundedAngles, Shifted};
pub use super::factor_formula::{Divided, Factor, Factors, Shaped};
pub use super::tree_formula::{LeftOnStack, OtherJoint, Parents, Popped, Reached, Unfilled};
pub use super::weight_formula::{
    AtEnd, Columns, Halves, Kept, Rescaled, Rounded, Rows, WeightFormula,
};
use crate::character::{Character, FileFrames, Joint, Pose};
use glam::{DMat3, DQuat, Vec3};

/// How a program gets from a character and a pose to vertices: v' = Σ wᵢ Tᵢ Bᵢ⁻¹ v, part by part.
/// The default is the exact formula. Mistakes change parts of it, so two mistakes in different parts
/// are one formula as well.
#[derive(Clone, Debug, PartialEq)]
pub struct Formula {
    /// How a joint is placed relative to its parent.
    pub joint: JointFormula,
    /// How the transforms of the joints follow from one another in T.
    pub chain: Chain,
    /// The same in B.
    pub bind_chain: Chain,
    /// Which of T and B move a vertex.
    pub factors: Factors,
    /// How vertices are placed by the matrix of a Collada file's skin first.
    pub shaped: Shaped,
    /// What is divided by its fourth coordinate then.
    pub divided: Divided,
    /// Which weights count.
    pub weights: WeightFormula,
    /// Order in which a program has its joints.
    pub joint_order: JointOrder,
    /// Order in which a program has its vertices.
    pub vertex_order: VertexOrder,
    /// Factor of each coordinate that is written.
    pub written: [f64; 3],
    /// What joints hang on.
    pub parents: Parents,
    /// Whether offsets are taken for places in the model, in T and in B: each joint is offset by the difference from its parent's.
    pub offsets_are_places: bool,
    /// A joint that a program has otherwise than the file.
    pub other_joint: Option<OtherJoint>,
    /// After which joints the matrix stack is popped, in T and in B.
    pub popped: [Popped; 2],
    /// What B has left on the matrix stack when T begins.
    pub left_on_stack: LeftOnStack,
    /// Joints for which something is worked out, if not all, and what the others have.
    pub reached: Option<(Reached, Unfilled)>,
    /// Whether joints have the transforms of their parents, and roots none, in T and in B.
    pub keeps_parents: [bool; 2],
    /// Whether the transforms of roots are multiplied on twice, in T and in B.
    pub roots_twice: [bool; 2],
    /// What is made of the rotation in T, while joints are where they should be.
    pub current_rotations: Rotations,
    /// What the sum begins with.
    pub begun: Begun,
    /// Whether what comes of it is moved once more in the same way.
    pub moves_twice: bool,
}

/// What the weighted sum of a vertex begins with.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Begun {
    /// 0.
    AtZero,
    /// The vertex at rest.
    AtRest,
    /// What it is at rest as the formula gives it, of an earlier sum.
    Summed,
    /// Both of these.
    AtRestAndSummed,
}

impl Begun {
    /// How many times the vertex at rest is in it, whose weights have this sum.
    pub(super) fn times(self, weights: f64) -> f64 {
        match self {
            Self::AtZero => 0.0,
            Self::AtRest => 1.0,
            Self::Summed => weights,
            Self::AtRestAndSummed => 1.0 + weights,
        }
    }
}

/// A joint's transform relative to its parent.
#[derive(Clone, Debug, PartialEq)]
pub struct JointFormula {
    /// Joint whose angles each is given.
    pub angles_of: AnglesOf,
    /// Which of the pose's angles, 0 for that about X, is used about X, Y and Z.
    pub axes: [usize; 3],
    /// How the angles are rounded first.
    pub rounded: RoundedAngles,
    /// Factor of the angles about X, Y and Z.
    pub angles: [f64; 3],
    /// What the angles about X, Y and Z are converted to.
    pub units: [AngleUnits; 3],
    /// Whose axes they are about.
    pub about: About,
    /// Axes of the rotations in the order in which they are multiplied: `[0, 1, 2]` is Rx · Ry · Rz.
    pub order: [usize; 3],
    /// What is made of the rotation.
    pub rotations: Rotations,
    /// How many times it is multiplied on.
    pub times: usize,
    /// Whether it is R · T instead of T · R.
    pub rotates_first: bool,
    /// Whether that is so at roots, also where it is not at other joints.
    pub roots_rotate_first: bool,
    /// Whether roots are moved by the pose.
    pub roots_are_moved: bool,
    /// Which offsets count in T.
    pub offsets: Offsets,
    /// Which offsets count in B.
    pub bind_offsets: Offsets,
    /// Whether the pose counts.
    pub has_pose: bool,
}

/// What a program makes of a rotation.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Rotations {
    /// The same.
    Exact,
    /// Its transpose, which turns the other way.
    Transposed,
    /// The numbers x, y, z, w of its quaternion are taken for w, x, y, z.
    ScalarTakenFirst,
    /// The numbers w, x, y, z of its quaternion are taken for x, y, z, w.
    ScalarTakenLast,
}

impl Rotations {
    pub(super) fn of(self, rotation: DMat3) -> DMat3 {
        let of_numbers =
            |numbers: fn(DQuat) -> DQuat| DMat3::from_quat(numbers(DQuat::from_mat3(&rotation)));
        match self {
            Self::Exact => rotation,
            Self::Transposed => rotation.transpose(),
            Self::ScalarTakenFirst => of_numbers(|q| DQuat::from_xyzw(q.y, q.z, q.w, q.x)),
            Self::ScalarTakenLast => of_numbers(|q| DQuat::from_xyzw(q.w, q.x, q.y, q.z)),
        }
    }
}

/// Joints whose offsets from their parents count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Offsets {
    /// Every joint.
    All,
    /// None.
    None,
    /// Roots.
    OfRoots,
    /// All but roots.
    ButOfRoots,
    /// Those that the pose neither turns nor moves.
    OfUnposed,
    /// Every joint, twice.
    Twice,
    /// Every joint, twice where the pose turns or moves it.
    TwiceOfPosed,
}

impl Offsets {
    /// How many times that of a joint counts.
    pub(super) fn times(self, is_root: bool, is_posed: bool) -> f64 {
        match self {
            Self::All => 1.0,
            Self::None => 0.0,
            Self::OfRoots => f64::from(is_root),
            Self::ButOfRoots => f64::from(!is_root),
            Self::OfUnposed => f64::from(!is_posed),
            Self::Twice => 2.0,
            Self::TwiceOfPosed => 1.0 + f64::from(is_posed),
        }
    }
}

/// How a joint's transform follows from its own and its parent's.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chain {
    /// parent · own.
    ParentOwn,
    /// own · parent.
    OwnParent,
    /// own.
    Own,
    /// parent's own · own, without those above.
    ParentsOwn,
    /// parent · own, where what is handed down is without rotations.
    WithoutRotations,
    /// The rotation of own · parent at the place of parent · own.
    OwnParentRotation,
    /// The rotation of own at the place of parent · own, of which the parent's has its own rotation alone as well.
    OwnRotation,
    /// The rotation of own at the right place, to which the rotations of all above lead.
    OwnRotationInPlace,
    /// parent · own, where own's offset is not turned by the parent.
    OffsetsNotTurned,
    /// parent · own, where the parent is at rest.
    ParentAtRest,
    /// own · parent of what turns joints about their places at rest, each of them in model space.
    TurnsOwnParent,
}

/// Which joint an index means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct JointOrder {
    /// Which joint comes when.
    pub by: JointsBy,
    /// Whether angles are given to joints in that order, too, and not weights alone.
    pub has_angles: bool,
}

/// Orders of joints.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum JointsBy {
    /// As the file has them.
    File,
    /// Each before its children, and these before its next sibling.
    Depth,
    /// The roots, then their children, then theirs.
    Level,
    /// By the number of joints above, of equals as the file has them.
    Height,
    /// At the number that the skin of a Collada file has for another joint.
    SkinList,
}

/// Which vertex comes when.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VertexOrder {
    /// As the file has them.
    File,
    /// In the order in which faces use them first, each with its own weights.
    FirstUse,
    /// In the order in which faces use them first, with the weights that the file has at that place.
    FirstUseOfPositions,
    /// With the same wrong weights, but written in the order of the file.
    FirstUseInside,
    /// One for each corner of each triangle.
    Corners,
}

impl Formula {
    /// Whether digits of angles or weights are rounded off.
    pub(super) fn rounds_digits(&self) -> bool {
        self.joint.rounded != RoundedAngles::No
            || matches!(self.weights.rounded, Rounded::ToDigits(1.., _))
    }

    /// Whether it changes something of a character: what it changes may be what only Collada files have, or only others.
    pub fn is_of(&self, character: &Character) -> bool {
        let frames = character.file_frames();
        let bind_shape = frames.and_then(|frames| frames.bind_shape);
        let has_parents = match self.parents {
            Parents::OfFile => true,
            parents => frames.is_none() && parents.order(character.skeleton()).is_some(),
        };
        let joints = character.skeleton().joints();
        let is_child_of_offset = |joint: &Joint| {
            let of_parent = joint.parent.map(|parent| joints[parent].offset);
            of_parent.is_some_and(|offset| offset != Vec3::ZERO)
        };
        let has_offsets = || frames.is_none() && joints.iter().any(is_child_of_offset);
        let is_of_file = self.factors.are_of_file() || self.joint.about != About::Model;
        let has_shape = self.shaped == Shaped::Exactly || bind_shape.is_some();
        let leaves_out = |(reached, _): (Reached, Unfilled)| {
            let is_reached = reached.of(character.skeleton());
            is_reached.contains(&false)
        };
        let has_list = self.joint_order.by != JointsBy::SkinList
            || frames.is_some_and(FileFrames::has_other_numbers);
        let has_zeros = frames.is_none() || self.weights.kept != Kept::BeforeZero;
        let reaches = self.reached.is_none_or(leaves_out);
        reaches
            && has_zeros
            && has_list
            && has_parents
            && (!self.offsets_are_places || has_offsets())
            && (!is_of_file || frames.is_some())
            && has_shape
    }

    /// Whether a pose can show all that it changes at roots: not that they are not moved where none is, and not that they are
    /// neither moved nor turned where none is turned, which is the same as that they are not moved. That joints follow parents
    /// at rest is the same as that they follow their offsets, where no root is moved.
    pub(super) fn is_of_pose(&self, pose: &Pose, roots: &[usize]) -> bool {
        let moves = |&root: &usize| pose.root_offset(root) != Vec3::ZERO;
        let turns = |&root: &usize| pose.rotation(root).radians != Vec3::ZERO;
        let turns_roots = self.joint.angles_of != AnglesOf::ItselfButRoots;
        if self.chain == Chain::ParentAtRest && !roots.iter().any(moves) {
            return false;
        }
        self.joint.roots_are_moved
            || roots.iter().any(moves) && (turns_roots || roots.iter().any(turns))
    }
}

impl Default for Formula {
    fn default() -> Self {
        Self {
            joint: JointFormula {
                angles_of: AnglesOf::Itself,
                axes: [0, 1, 2],
                rounded: RoundedAngles::No,
                angles: [1.0; 3],
                units: [AngleUnits::Radians; 3],
                about: About::Model,
                order: [0, 1, 2],
                rotations: Rotations::Exact,
                times: 1,
                rotates_first: false,
                roots_rotate_first: false,
                roots_are_moved: true,
                offsets: Offsets::All,
                bind_offsets: Offsets::All,
                has_pose: true,
            },
            chain: Chain::ParentOwn,
            bind_chain: Chain::ParentOwn,
            factors: Factors::Exact,
            shaped: Shaped::Exactly,
            divided: Divided::Nothing,
            weights: WeightFormula {
                rows: Rows::Exact,
                rounded: Rounded::No,
                is_normalized: false,
                is_completed: false,
                kept: Kept::All,
                rescaled: Rescaled::No,
                is_overwritten: false,
                columns: Columns::Exact,
                unused_first: false,
                factor: 1.0,
            },
            joint_order: JointOrder {
                by: JointsBy::File,
                has_angles: false,
            },
            vertex_order: VertexOrder::File,
            written: [1.0; 3],
            parents: Parents::OfFile,
            offsets_are_places: false,
            other_joint: None,
            popped: [Popped::All; 2],
            left_on_stack: LeftOnStack::Nothing,
            reached: None,
            keeps_parents: [false; 2],
            roots_twice: [false; 2],
            current_rotations: Rotations::Exact,
            begun: Begun::AtZero,
            moves_twice: false,
        }
    }
}
