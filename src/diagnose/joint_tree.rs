//! The tree of joints as a program has it, and transforms from joint to joint along it.

use super::formula::{Chain, Formula, Parents, Popped};
use super::model::Model;
use glam::{DAffine3, DVec3};

/// The joints as a program has them.
pub(super) struct Tree {
    parents: Vec<Option<usize>>,
    /// From each joint's parent.
    pub offsets: Vec<DVec3>,
    /// Parents before their children.
    pub order: Vec<usize>,
}

impl Tree {
    pub fn new(model: &Model, formula: &Formula) -> Self {
        let (skeleton, parents) = (model.skeleton(), formula.parents);
        let joints = skeleton.joints();
        let all = 0..joints.len();
        let order = match parents {
            Parents::OfFile => None,
            parents => parents.order(skeleton),
        };
        let mut tree = Self {
            parents: all.map(|joint| parents.of(skeleton, joint)).collect(),
            offsets: joints.iter().map(|joint| joint.offset.as_dvec3()).collect(),
            order: order.unwrap_or_else(|| model.by_depth.clone()),
        };
        if formula.offsets_are_places {
            let of_parent = |joint: usize| joints[joint].parent.map(|parent| joints[parent].offset);
            for (joint, offset) in tree.offsets.iter_mut().enumerate() {
                *offset -= of_parent(joint).unwrap_or_default().as_dvec3();
            }
        }
        if let Some(other) = formula.other_joint {
            tree.parents[other.joint] = other.parent;
            tree.offsets[other.joint] = other.offset;
            // What hangs on the joint stays behind it, and its new parent is none of these.
            let (moved, others): (Vec<usize>, _) = tree
                .order
                .iter()
                .partition(|&&joint| model.hangs_on(joint, other.joint));
            tree.order = others.into_iter().chain(moved).collect();
        }
        tree
    }

    /// The same joints, each of which hangs on what is on top of the matrix stack when it is pushed, in the order
    /// `visited`.
    pub fn on_stack(mut self, visited: Vec<usize>, popped: Popped) -> Self {
        let own = self.parents.clone();
        let mut is_leaf = vec![true; own.len()];
        for &parent in own.iter().flatten() {
            is_leaf[parent] = false;
        }
        let mut stack = Vec::new();
        let mut open: Vec<usize> = Vec::new();
        for &joint in &visited {
            // Those whose children have all been visited end first.
            while let Some(last) = open.pop_if(|last| own[joint] != Some(*last)) {
                if popped.pops(is_leaf[last]) {
                    stack.pop();
                }
            }
            self.parents[joint] = stack.last().copied();
            stack.push(joint);
            open.push(joint);
        }
        self.order = visited;
        self
    }

    /// Of `model_from_joint` those of the joints' parents.
    pub fn of_parents(&self, model_from_joint: &[DAffine3]) -> Vec<DAffine3> {
        let of_parent = |parent: &Option<usize>| parent.map(|parent| model_from_joint[parent]);
        let of_parents = self.parents.iter().map(of_parent);
        of_parents.map(Option::unwrap_or_default).collect()
    }

    /// The transform of each joint from `own`, relative to its parent. Roots follow `left`. At rest joints have `bind`, and
    /// what this gives if there is none.
    pub fn chained(
        &self,
        chain: Chain,
        left: DAffine3,
        bind: Option<&[DAffine3]>,
        own: impl Fn(usize) -> DAffine3,
    ) -> Vec<DAffine3> {
        let mut model_from_joint = vec![DAffine3::IDENTITY; self.parents.len()];
        let mut in_place = model_from_joint.clone();
        for &joint in &self.order {
            let of_joint = own(joint);
            let Some(parent) = self.parents[joint] else {
                model_from_joint[joint] = left * of_joint;
                in_place[joint] = model_from_joint[joint];
                continue;
            };
            let model_from_parent = model_from_joint[parent];
            in_place[joint] = in_place[parent] * of_joint;
            model_from_joint[joint] = match chain {
                Chain::Own => of_joint,
                Chain::ParentOwn => model_from_parent * of_joint,
                Chain::OwnParent => of_joint * model_from_parent,
                Chain::ParentsOwn => own(parent) * of_joint,
                Chain::WithoutRotations => {
                    DAffine3::from_translation(model_from_parent.translation) * of_joint
                }
                Chain::OwnParentRotation => DAffine3 {
                    matrix3: of_joint.matrix3 * model_from_parent.matrix3,
                    ..model_from_parent * of_joint
                },
                Chain::OwnRotation => DAffine3 {
                    matrix3: of_joint.matrix3,
                    ..model_from_parent * of_joint
                },
                Chain::OwnRotationInPlace => DAffine3 {
                    matrix3: of_joint.matrix3,
                    ..in_place[joint]
                },
                Chain::OffsetsNotTurned => DAffine3 {
                    translation: model_from_parent.translation + of_joint.translation,
                    ..model_from_parent * of_joint
                },
                Chain::ParentAtRest => {
                    bind.map_or(model_from_parent, |bind| bind[parent]) * of_joint
                }
                Chain::TurnsOwnParent => match bind {
                    None => model_from_parent * of_joint,
                    Some(bind) => {
                        let turn = bind[parent] * of_joint * bind[joint].inverse();
                        turn * model_from_parent * bind[parent].inverse() * bind[joint]
                    }
                },
            };
        }
        model_from_joint
    }
}
