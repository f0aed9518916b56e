//! The transforms of joints by any formula, in double precision.

use super::formula::{
    About, AngleUnits, Columns, Factor, Formula, JointFormula, JointsBy, LeftOnStack, Popped,
    Shaped, Unfilled,
};
use super::joint_list::JointList;
use super::joint_tree::Tree;
use super::model::Model;
use crate::character::{FileFrames, Pose};
use glam::{DAffine3, DMat3, DMat4, DVec3};
use std::f64::consts::FRAC_PI_2;

/// The transforms of all joints from their frames to model space, by a formula.
#[derive(Debug)]
pub(super) struct Joints<'a> {
    /// T.
    current: Vec<DAffine3>,
    /// B.
    bind: Vec<DAffine3>,
    /// Which joint each index of a program means.
    list: JointList<'a>,
    /// Frames of the character's file.
    frames: Option<&'a FileFrames>,
}

impl<'a> Joints<'a> {
    pub(super) fn new(model: &Model<'a>, pose: &Pose, formula: &Formula) -> Self {
        Self::after(model, &[], pose, formula)
    }

    /// The same where joints turn on from the rotations that they were given in the poses `before`.
    pub(super) fn after(
        model: &Model<'a>,
        before: &[&Pose],
        pose: &Pose,
        formula: &Formula,
    ) -> Self {
        let list = JointList::new(model, formula);
        let order = list.order();
        // Which joint's angles of the pose each joint is given.
        let mut angles_of: Vec<usize> = (0..order.len()).collect();
        if formula.joint_order.has_angles {
            for (index, &joint) in order.iter().enumerate() {
                angles_of[joint] = index;
            }
        }
        let is_reached =
            (formula.reached).map(|(reached, unfilled)| (reached.of(model.skeleton()), unfilled));
        let tree = |popped: Popped, is_of_bind: bool| {
            let tree = Tree::new(model, formula);
            if popped == Popped::All {
                return tree;
            }
            let mut visited = model.joints_by(JointsBy::Depth);
            // What the recursion does not come to, it does not push either.
            if let Some((is_reached, unfilled)) = &is_reached
                && (!is_of_bind || *unfilled == Unfilled::IdentityInBoth)
            {
                visited.retain(|&joint| is_reached[joint]);
            }
            tree.on_stack(visited, popped)
        };
        let [popped, popped_in_bind] = formula.popped;
        let (tree, bind_tree) = (tree(popped, false), tree(popped_in_bind, true));
        let offset = |joint: usize| tree.offsets[joint];
        let parent = |joint: usize| model.skeleton().joints()[joint].parent;
        let is_root = |joint: usize| parent(joint).is_none();
        let own = &formula.joint;
        let frames = model.character.file_frames();
        let axes = |joint: usize| match own.about {
            About::Model => None,
            About::Bone => frames.and_then(|it| it.directions(joint)),
            About::BoneFromFile => {
                frames.and_then(|it| Some(it.directions(joint)? * it.placed.inverse()))
            }
            About::File => frames.map(|it| it.placed),
        };
        let [twice_in_current, twice_in_bind] = formula.roots_twice;
        let pushed = |twice: bool, joint: usize, transform: DAffine3| {
            if twice && is_root(joint) {
                transform * transform
            } else {
                transform
            }
        };
        let angles_of = |pose: &Pose, joint: usize| {
            let parent = parent(joint).map(|parent| angles_of[parent]);
            let count = angles_of.len();
            let of = own.angles_of.joint(angles_of[joint], parent, count);
            of.map_or(DVec3::ZERO, |of| pose.rotation(of).radians.as_dvec3())
        };
        let at_rest = |joint: usize| {
            let times = own.bind_offsets.times(is_root(joint), false);
            let translation = bind_tree.offsets[joint] * times;
            pushed(
                twice_in_bind,
                joint,
                DAffine3::from_translation(translation),
            )
        };
        let bind = bind_tree.chained(formula.bind_chain, DAffine3::IDENTITY, None, at_rest);
        let left = match formula.left_on_stack {
            LeftOnStack::Nothing => None,
            LeftOnStack::Root => bind_tree.order.first().map(|&root| bind[root]),
            LeftOnStack::LastVisited(times) => {
                let visited = model.joints_by(JointsBy::Depth);
                let last = visited.last().copied();
                let tree = Tree::new(model, formula).on_stack(visited, Popped::None);
                let bind = tree.chained(formula.bind_chain, DAffine3::IDENTITY, None, at_rest);
                last.map(|last| std::iter::repeat_n(&bind[last], times).product())
            }
        };
        let current = tree.chained(
            formula.chain,
            left.unwrap_or_default(),
            Some(&bind),
            |joint| {
                let mut translation = DVec3::ZERO;
                let mut angles = DVec3::ZERO;
                let mut moved = DVec3::ZERO;
                let mut rotation = DMat3::IDENTITY;
                if own.has_pose {
                    angles = angles_of(pose, joint);
                    if own.roots_are_moved {
                        moved = pose.root_offset(joint).as_dvec3();
                    }
                    let all = before.iter().copied().chain([pose]);
                    rotation = all
                        .map(|pose| own.rotation(angles_of(pose, joint)))
                        .product();
                    if let Some(axes) = axes(joint).map(DMat3::from_mat4) {
                        rotation = axes * rotation * axes.inverse();
                        if own.about == About::File {
                            moved = axes * moved;
                        }
                    }
                }
                let is_posed = angles != DVec3::ZERO || moved != DVec3::ZERO;
                let times = own.offsets.times(is_root(joint), is_posed);
                if times > 0.0 {
                    translation = offset(joint) * times + moved;
                }
                let rotates_first = own.rotates_first || own.roots_rotate_first && is_root(joint);
                let transform = parent_from_joint(translation, rotation, rotates_first);
                pushed(twice_in_current, joint, transform)
            },
        );
        let kept = |tree: &Tree, of_parents: bool, all: Vec<DAffine3>| {
            if of_parents {
                tree.of_parents(&all)
            } else {
                all
            }
        };
        let [current_of_parents, bind_of_parents] = formula.keeps_parents;
        let mut current = kept(&tree, current_of_parents, current);
        let mut bind = kept(&bind_tree, bind_of_parents, bind);
        for transform in &mut current {
            transform.matrix3 = formula.current_rotations.of(transform.matrix3);
        }
        if let Some((is_reached, unfilled)) = is_reached {
            for (joint, _) in is_reached.iter().enumerate().filter(|(_, it)| !**it) {
                current[joint] = match unfilled {
                    Unfilled::Zero => DAffine3::ZERO,
                    Unfilled::Identity | Unfilled::IdentityInBoth => DAffine3::IDENTITY,
                };
                if unfilled == Unfilled::IdentityInBoth {
                    bind[joint] = DAffine3::IDENTITY;
                }
            }
        }
        Self {
            current,
            bind,
            list,
            frames,
        }
    }

    /// What vertices at rest are multiplied by before all else.
    pub(super) fn shape(&self, formula: &Formula) -> DMat4 {
        let shape = |frames: &FileFrames| {
            let (placed, bind_shape) = (frames.placed, frames.bind_shape?);
            let shaped = match formula.shaped {
                Shaped::Exactly => return None,
                Shaped::Not => DMat4::IDENTITY,
                Shaped::Transposed => bind_shape.transpose(),
                Shaped::TransposedAsPoints => {
                    DMat4::from_mat3(DMat3::from_mat4(bind_shape)).transpose()
                }
            };
            Some(placed * shaped * (placed * bind_shape).inverse())
        };
        self.frames.and_then(shape).unwrap_or_default()
    }

    /// A matrix of `joint`, which is the first one of the vertex for a factor that is of that.
    pub(super) fn matrix(&self, factor: Factor, joint: usize) -> DMat4 {
        let (current, bind) = (self.current[joint], self.bind[joint]);
        let of_file = |matrix: &dyn Fn(&FileFrames) -> Option<DMat4>| {
            self.frames.and_then(matrix).unwrap_or_default()
        };
        match factor {
            // Where nothing is worked out, the fourth row is 0 as well.
            Factor::Current if current == DAffine3::ZERO => DMat4::ZERO,
            Factor::Current => current.into(),
            Factor::Bind => bind.into(),
            Factor::InverseBind | Factor::InverseBindOfFirst => bind.inverse().into(),
            Factor::CurrentTransposed => DMat4::from(current).transpose(),
            Factor::BindTransposed => DMat4::from(bind).transpose(),
            Factor::InverseCurrent => current.inverse().into(),
            Factor::InverseBindTransposed => DMat4::from(bind.inverse()).transpose(),
            Factor::ToFile => of_file(&|it| Some(it.placed.inverse())),
            Factor::FromFile => of_file(&|it| Some(it.placed)),
            Factor::FromFileTransposed => of_file(&|it| Some(it.placed.transpose())),
            Factor::DirectionsInFile => of_file(&|it| it.directions(joint)),
            Factor::InverseBindOfFile | Factor::InverseBindOfNumber => {
                of_file(&|it| it.inverse_bind(joint))
            }
            Factor::InverseBindOfFileTransposed => {
                of_file(&|it| Some(it.inverse_bind(joint)?.transpose()))
            }
        }
    }

    /// The joint that a weight moves a vertex with whose index in the file is `index`; `None` if it is
    /// taken for none.
    pub(super) fn moved_by(&self, columns: Columns, index: usize) -> Option<usize> {
        self.list.joint(columns, index)
    }

    /// What moves vertices, by the index that a weight has, after what the first joint of a vertex does to all of it.
    pub(super) fn palette(&self, formula: &Formula) -> Vec<Option<DMat4>> {
        match formula.factors.in_order() {
            [Factor::InverseBindOfFirst, others @ ..] => {
                self.products(formula, others, DMat4::IDENTITY)
            }
            all => self.products(formula, all, self.shape(formula)),
        }
    }

    /// What the joint of the first weight does to a vertex for all of them, by the index that the weight has; `None` if each
    /// joint does it for itself.
    pub(super) fn of_first(&self, formula: &Formula) -> Option<Vec<Option<DMat4>>> {
        match formula.factors.in_order() {
            [first @ Factor::InverseBindOfFirst, ..] => {
                Some(self.products(formula, std::slice::from_ref(first), self.shape(formula)))
            }
            _ => None,
        }
    }

    /// The product of `factors`, which come to what `begin` leaves, by the index that a weight has.
    fn products(&self, formula: &Formula, factors: &[Factor], begin: DMat4) -> Vec<Option<DMat4>> {
        let by_index = (0..self.list.order().len()).map(|index| {
            let joint = self.moved_by(formula.weights.columns, index)?;
            let factors = factors.iter();
            Some(factors.fold(begin, |product, &factor| {
                self.matrix(factor, factor.joint(index, joint)) * product
            }))
        });
        by_index.collect()
    }
}

impl JointFormula {
    /// The rotation of a joint from its angles in radians.
    fn rotation(&self, radians: DVec3) -> DMat3 {
        let rounded = radians.map(|angle| self.rounded.angle(angle));
        let used = DVec3::from_array(self.axes.map(|axis| rounded[axis]));
        let angles = used * DVec3::from_array(self.angles);
        let in_units = [0, 1, 2].map(|axis| match self.units[axis] {
            AngleUnits::Radians => angles[axis],
            AngleUnits::Degrees => angles[axis].to_degrees(),
            AngleUnits::ConvertedTwice => angles[axis].to_radians(),
            AngleUnits::Complements => FRAC_PI_2 - angles[axis],
        });
        let angles = DVec3::from_array(in_units);
        let rotation: DMat3 = self.order.map(|axis| about(axis, angles)).iter().product();
        std::iter::repeat_n(self.rotations.of(rotation), self.times).product()
    }
}

/// The transform of a joint from its translation and its rotation: T · R, or R · T if it `rotates_first`.
fn parent_from_joint(translation: DVec3, rotation: DMat3, rotates_first: bool) -> DAffine3 {
    DAffine3 {
        matrix3: rotation,
        translation: if rotates_first {
            rotation * translation
        } else {
            translation
        },
    }
}

fn about(axis: usize, angles: DVec3) -> DMat3 {
    match axis {
        0 => DMat3::from_rotation_x(angles.x),
        1 => DMat3::from_rotation_y(angles.y),
        _ => DMat3::from_rotation_z(angles.z),
    }
}
