//! Skeletons: which joints of the scene make one, and where their bones end.

use super::document::{child, children};
use super::instances::{Binding, Instance};
use super::sources::text;
use super::visual_scene::{SceneNode, ancestors};
use crate::character::Joint;
use glam::{DMat4, DVec3};
use std::collections::HashMap;

/// A forest of joints that are posed together.
pub(super) struct Rig {
    /// Nodes of the scene, in the order of the document: parents before children.
    pub nodes: Vec<usize>,
    /// The joint of each node that is one.
    pub joint_of_node: HashMap<usize, u32>,
}

/// The rigs of a scene, and the rig of each node.
pub(super) struct Rigs {
    pub rigs: Vec<Rig>,
    rig_of_tree: HashMap<usize, usize>,
    /// The nearest joint at or above each node.
    pub joint_above: Vec<Option<usize>>,
    tree: Vec<Option<usize>>,
}

impl Rigs {
    /// Sorts the joints of a scene into rigs.
    ///
    /// A tree is a joint without a joint above it and all joints below. Trees that one skin uses
    /// are one rig, and with them trees that no skin uses but that stand below the same node: a
    /// rig's further roots. Rigs are in the order of their first skin, then of their first joint.
    pub fn new(nodes: &[SceneNode], instances: &[Instance]) -> Self {
        let mut rigs = Self {
            rigs: Vec::new(),
            rig_of_tree: HashMap::new(),
            joint_above: Vec::with_capacity(nodes.len()),
            tree: Vec::with_capacity(nodes.len()),
        };
        for (at, node) in nodes.iter().enumerate() {
            let above = node.parent.and_then(|parent| rigs.joint_above[parent]);
            let tree = above.and_then(|above| rigs.tree[above]);
            rigs.joint_above
                .push(if node.is_joint { Some(at) } else { above });
            rigs.tree.push(if node.is_joint {
                tree.or(Some(at))
            } else {
                tree
            });
        }
        let first_skin = rigs.unite(nodes, instances);
        rigs.number(nodes, &first_skin);
        rigs
    }

    /// The rig that `binding` binds to, if any.
    pub fn of_binding(&self, binding: &Binding) -> Option<usize> {
        let tree = self.trees(binding).next()?;
        self.rig_of_tree.get(&tree).copied()
    }

    /// The rig and joint that carry the things at `node`, if any.
    pub fn carrier(&self, node: usize) -> Option<(usize, u32)> {
        let rig = *self.rig_of_tree.get(&self.tree[node]?)?;
        let joint = self.rigs[rig].joint_of_node.get(&self.joint_above[node]?)?;
        Some((rig, *joint))
    }

    fn trees<'b>(&'b self, binding: &'b Binding) -> impl Iterator<Item = usize> + 'b {
        let named = binding.joints.iter().flatten();
        named
            .chain(&binding.skeletons)
            .filter_map(|&node| self.tree[node])
    }

    /// Unites trees; the number of the first skin of each united tree, by its representative.
    fn unite(&mut self, nodes: &[SceneNode], instances: &[Instance]) -> HashMap<usize, usize> {
        let mut first_skin = HashMap::new();
        let mut above: Vec<usize> = (0..nodes.len()).collect();
        let mut used = vec![false; nodes.len()];
        let bindings = instances
            .iter()
            .filter_map(|instance| instance.binding.as_ref());
        for binding in bindings.clone() {
            let mut trees = self.trees(binding);
            if let Some(first) = trees.next() {
                used[first] = true;
                for tree in trees {
                    used[tree] = true;
                    join(&mut above, first, tree);
                }
            }
        }
        let is_tree = |&at: &usize| self.tree[at] == Some(at);
        let mut used_below: HashMap<usize, usize> = HashMap::new();
        for at in (0..nodes.len()).filter(is_tree).filter(|&at| used[at]) {
            if let Some(parent) = nodes[at].parent {
                used_below.entry(parent).or_insert(at);
            }
        }
        let mut unused_below: HashMap<Option<usize>, usize> = HashMap::new();
        for at in (0..nodes.len()).filter(is_tree).filter(|&at| !used[at]) {
            let parent = nodes[at].parent;
            let with = parent.and_then(|parent| used_below.get(&parent).copied());
            let with = with.unwrap_or_else(|| *unused_below.entry(parent).or_insert(at));
            join(&mut above, with, at);
        }
        for (number, binding) in bindings.enumerate() {
            if let Some(tree) = self.trees(binding).next() {
                first_skin.entry(find(&mut above, tree)).or_insert(number);
            }
        }
        self.rig_of_tree = (0..nodes.len())
            .filter(is_tree)
            .map(|at| (at, find(&mut above, at)))
            .collect();
        first_skin
    }

    /// Turns representatives into numbers of rigs and lists the joints of each.
    fn number(&mut self, nodes: &[SceneNode], first_skin: &HashMap<usize, usize>) {
        let order = |tree: &usize| (first_skin.get(tree).copied().unwrap_or(usize::MAX), *tree);
        let mut heads: Vec<usize> = self.rig_of_tree.values().copied().collect();
        heads.sort_unstable();
        heads.dedup();
        heads.sort_by_key(order);
        let number: HashMap<usize, usize> =
            heads.iter().enumerate().map(|(i, &h)| (h, i)).collect();
        self.rig_of_tree
            .values_mut()
            .for_each(|head| *head = number[head]);
        self.rigs = heads
            .iter()
            .map(|_| Rig {
                nodes: Vec::new(),
                joint_of_node: HashMap::new(),
            })
            .collect();
        for (at, _) in nodes.iter().enumerate().filter(|(_, node)| node.is_joint) {
            if let Some(tree) = self.tree[at]
                && let Some(&rig) = self.rig_of_tree.get(&tree)
            {
                let rig = &mut self.rigs[rig];
                rig.joint_of_node.insert(at, rig.nodes.len() as u32);
                rig.nodes.push(at);
            }
        }
    }

    /// The joints of `rig` at rest, in the space that `ours_from_file` leads to.
    pub fn joints(&self, rig: &Rig, nodes: &[SceneNode], ours_from_file: DMat4) -> Vec<Joint> {
        let ours_from_joint: Vec<DMat4> = rig
            .nodes
            .iter()
            .map(|&node| ours_from_file * nodes[node].world)
            .collect();
        let parents: Vec<Option<usize>> = rig
            .nodes
            .iter()
            .map(|&node| {
                let above = nodes[node]
                    .parent
                    .and_then(|parent| self.joint_above[parent]);
                above.and_then(|above| rig.joint_of_node.get(&above).map(|&joint| joint as usize))
            })
            .collect();
        let place = |joint: usize| ours_from_joint[joint].w_axis.truncate();
        let tips = tips_of_joints(rig, nodes, &ours_from_joint, &parents);
        rig.nodes
            .iter()
            .enumerate()
            .map(|(joint, &node)| Joint {
                name: nodes[node].name().to_owned(),
                sid: nodes[node].xml.attribute("sid").map(str::to_owned),
                parent: parents[joint],
                offset: parents[joint]
                    .map_or(place(joint), |parent| place(joint) - place(parent))
                    .as_vec3(),
                tip: tips[joint].map(|tip| tip.as_vec3()),
            })
            .collect()
    }

    /// Name of `rig`: that of the node that holds its roots, else of its first root.
    pub fn name<'a>(rig: &Rig, nodes: &[SceneNode<'a>]) -> &'a str {
        let root = rig.nodes.first().copied();
        ancestors(nodes, root)
            .find(|&node| !nodes[node].is_joint)
            .or(root)
            .map_or("Character", |node| nodes[node].name())
    }
}

fn find(above: &mut [usize], mut at: usize) -> usize {
    while above[at] != at {
        above[at] = above[above[at]];
        at = above[at];
    }
    at
}

/// The smaller number stays the head, so that heads are first joints.
fn join(above: &mut [usize], a: usize, b: usize) {
    let (a, b) = (find(above, a), find(above, b));
    above[a.max(b)] = a.min(b);
}

/// A bone without any word of its length gets this share of its parent's.
const SHARE_OF_PARENT: f64 = 0.4;

/// The end of each joint's bone at rest, relative to the joint, in our axes; `None` where nothing
/// in the file says.
fn tips_of_joints(
    rig: &Rig,
    nodes: &[SceneNode],
    ours_from_joint: &[DMat4],
    parents: &[Option<usize>],
) -> Vec<Option<DVec3>> {
    let mut first_child = vec![None; parents.len()];
    for (joint, parent) in parents.iter().enumerate() {
        if let Some(parent) = *parent {
            first_child[parent].get_or_insert(joint);
        }
    }
    let mut tips: Vec<Option<DVec3>> = Vec::with_capacity(parents.len());
    for (joint, matrix) in ours_from_joint.iter().enumerate() {
        let along = matrix.y_axis.truncate();
        let to_child = first_child[joint].and_then(|child: usize| {
            let height = height_above(matrix, ours_from_joint[child].w_axis.truncate());
            height.map(|height| along * height)
        });
        let written = || {
            let length = blender_tip(&nodes[rig.nodes[joint]])?.length();
            (length > 0.0).then(|| along * length)
        };
        let share = || {
            let parent: DVec3 = tips[parents[joint]?]?;
            Some(along.try_normalize()? * parent.length() * SHARE_OF_PARENT)
        };
        let tip = to_child.or_else(written).or_else(share);
        tips.push(tip.filter(|tip| tip.is_finite() && *tip != DVec3::ZERO));
    }
    tips
}

/// How far along a joint's +Y `point` lies, in the joint's own units; `None` if it does not.
fn height_above(ours_from_joint: &DMat4, point: DVec3) -> Option<f64> {
    let determinant = ours_from_joint.determinant();
    let height = ours_from_joint.inverse().transform_point3(point).y;
    (determinant != 0.0 && height.is_finite() && height > 1e-6).then_some(height)
}

/// The vector from head to tip that Blender writes for a bone without children.
fn blender_tip(node: &SceneNode) -> Option<DVec3> {
    let technique = children(node.xml, "extra")
        .flat_map(|extra| children(extra, "technique"))
        .find(|technique| technique.attribute("profile") == Some("blender"))?;
    let number = |tag| text(child(technique, tag)?).parse::<f64>().ok();
    let tip = DVec3::new(number("tip_x")?, number("tip_y")?, number("tip_z")?);
    tip.is_finite().then_some(tip)
}
