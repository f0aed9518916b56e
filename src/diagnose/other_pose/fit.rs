//! The pose whose mesh is nearest to one, by least squares.

use super::solve::Equations;
use crate::character::Pose;
use crate::compare::nearest_rotation;
use crate::diagnose::VertexOrder;
use crate::diagnose::model::Model;
use crate::steps::Pace;
use glam::{DAffine3, DMat3, DQuat, DVec3};

/// Vertices of each joint that the fit is made with.
const OF_A_JOINT: usize = 100;
/// Joints of which more take too long.
const MOST_JOINTS: usize = 128;
/// Steps after which the fit is given up.
const MOST_STEPS: usize = 60;
/// How cautious the first step is.
const DAMPING: f64 = 1e-4;
/// The least and the greatest caution.
const DAMPINGS: (f64, f64) = (1e-9, 1e3);
/// By how much the caution changes from step to step.
const CHANGE: f64 = 10.0;

/// A pose on its way to the one of a mesh. Its unknowns are three numbers for a small turn of each joint
/// about its place, and three for a small movement of each root, all in model space.
#[derive(Clone)]
pub(super) struct Fit<'a> {
    model: &'a Model<'a>,
    order: VertexOrder,
    theirs: &'a [DVec3],
    /// Where the joints are at rest, in model space.
    bind_places: Vec<DVec3>,
    /// Vertices that it is made with.
    vertices: Vec<usize>,
    /// The first unknown of the turn of each joint that moves one of these.
    turns: Vec<Option<usize>>,
    /// The first unknown of the movement of each root.
    moves: Vec<Option<usize>>,
    unknowns: usize,
    /// The pose that the mesh was expected in.
    expected: Posed,
    posed: Posed,
}

/// A pose as matrices.
#[derive(Clone)]
pub(super) struct Posed {
    /// Rotation of each joint in its parent's frame.
    pub(super) rotations: Vec<DMat3>,
    /// How far each root is moved.
    pub(super) offsets: Vec<DVec3>,
}

impl Posed {
    /// T of each joint.
    fn model_from_joint(&self, model: &Model) -> Vec<DAffine3> {
        let joints = model.skeleton().joints();
        let mut found = vec![DAffine3::IDENTITY; joints.len()];
        for &joint in &model.by_depth {
            let offset = joints[joint].offset.as_dvec3() + self.offsets[joint];
            let own = DAffine3::from_mat3_translation(self.rotations[joint], offset);
            let parent = joints[joint].parent;
            found[joint] = parent.map_or(own, |parent| found[parent] * own);
        }
        found
    }
}

/// What a vertex tells of one unknown turn or movement: its first number, and by which matrix the
/// three take the vertex along.
type Part = (usize, DMat3);

impl<'a> Fit<'a> {
    /// A fit that begins with the pose in which the vertices near each joint are turned as a whole as they
    /// are in `theirs`. `None` if there are too many joints, or numbers that are not finite.
    pub(super) fn new(
        model: &'a Model<'a>,
        expected: &Pose,
        order: VertexOrder,
        theirs: &'a [DVec3],
    ) -> Option<Self> {
        let joints = model.skeleton().joints();
        if !theirs.iter().all(|point| point.is_finite()) {
            return None;
        }
        let of_joints = vertices_of_joints(model, order, theirs.len());
        let mut is_moving: Vec<bool> = of_joints.iter().map(|own| !own.is_empty()).collect();
        for &joint in model.by_depth.iter().rev() {
            if let Some(parent) = joints[joint].parent {
                is_moving[parent] |= is_moving[joint];
            }
        }
        let mut unknowns = 0;
        let mut next = |is_one: bool| {
            let first = unknowns;
            unknowns += if is_one { 3 } else { 0 };
            is_one.then_some(first)
        };
        let turns: Vec<_> = is_moving.iter().map(|&moving| next(moving)).collect();
        let is_root = |joint: usize| is_moving[joint] && joints[joint].parent.is_none();
        let moves = (0..joints.len()).map(|joint| next(is_root(joint)));
        let moves: Vec<_> = moves.collect();
        if unknowns == 0 || is_moving.iter().filter(|moving| **moving).count() > MOST_JOINTS {
            return None;
        }
        let joint_indices = 0..joints.len();
        let bind_places = model.skeleton().bind_positions();
        let expected = Posed {
            rotations: joint_indices
                .clone()
                .map(|joint| expected.rotation(joint).to_dmat3())
                .collect(),
            offsets: joint_indices
                .map(|joint| expected.root_offset(joint).as_dvec3())
                .collect(),
        };
        let mut fit = Self {
            model,
            order,
            theirs,
            bind_places: bind_places.iter().map(|at| at.as_dvec3()).collect(),
            vertices: Vec::new(),
            turns,
            moves,
            unknowns,
            posed: expected.clone(),
            expected,
        };
        fit.turn_as_a_whole(&of_joints);
        fit.vertices = of_joints.into_iter().flatten().collect();
        fit.vertices.sort_unstable();
        fit.vertices.dedup();
        Some(fit)
    }

    /// The pose that the mesh was expected in.
    pub(super) fn expected(&self) -> Posed {
        self.expected.clone()
    }

    /// `posed` with these joints as in the pose that the mesh was expected in.
    pub(super) fn put_back(&self, posed: &Posed, joints: &[usize]) -> Posed {
        let mut back = posed.clone();
        for &joint in joints {
            back.rotations[joint] = self.expected.rotations[joint];
            back.offsets[joint] = self.expected.offsets[joint];
        }
        back
    }

    /// The same from `posed` on, in which the joints `free` alone are turned, and moved if they are roots.
    pub(super) fn of(&self, free: &[usize], posed: Posed) -> Self {
        let mut fit = Self {
            posed,
            ..self.clone()
        };
        for joint in 0..fit.turns.len() {
            if !free.contains(&joint) {
                (fit.turns[joint], fit.moves[joint]) = (None, None);
            }
        }
        fit
    }

    /// The joint, other than those in `free`, that promises to bring `posed` nearest to the mesh if it alone is turned
    /// or moved.
    pub(super) fn most_promising(&self, posed: &Posed, free: &[usize]) -> Option<usize> {
        let from = Self {
            posed: posed.clone(),
            ..self.clone()
        };
        let (equations, _) = from.equations();
        let promise = |joint: usize| {
            let own = self.turns[joint].into_iter().chain(self.moves[joint]);
            own.map(|first| equations.promise(first))
                .fold(0.0, f64::max)
        };
        let others = (0..self.turns.len()).filter(|joint| !free.contains(joint));
        let promises = others.map(|joint| (joint, promise(joint)));
        let best = promises.max_by(|a, b| a.1.total_cmp(&b.1))?;
        (best.1 > 0.0).then_some(best.0)
    }

    /// Turns each joint, from the root on, as the vertices that it moves most are turned as a whole.
    fn turn_as_a_whole(&mut self, of_joints: &[Vec<usize>]) {
        let joints = self.model.skeleton().joints();
        let mut turned = vec![DMat3::IDENTITY; joints.len()];
        for &joint in &self.model.by_depth {
            let parent = joints[joint]
                .parent
                .map_or(DMat3::IDENTITY, |parent| turned[parent]);
            let own = &of_joints[joint];
            let bind: Vec<DVec3> = own.iter().map(|&index| self.bind(index)).collect();
            let theirs: Vec<DVec3> = own.iter().map(|&index| self.theirs[index]).collect();
            if own.len() > 2
                && let Some(rotation) = nearest_rotation(&bind, &theirs)
            {
                self.posed.rotations[joint] = parent.transpose() * DMat3::from_quat(rotation);
            }
            turned[joint] = parent * self.posed.rotations[joint];
        }
    }

    /// Improves the pose until vertices are within a hundredth of the tolerance, or nothing helps any more: by
    /// Levenberg's and Marquardt's method.
    pub(super) async fn improve(mut self, tolerance: f64, pace: &Pace) -> Posed {
        let enough = self.vertices.len() as f64 * (0.01 * tolerance).powi(2);
        let (mut equations, mut error) = self.equations();
        let mut damping = DAMPING;
        for _ in 0..MOST_STEPS {
            if error <= enough || damping > DAMPINGS.1 {
                break;
            }
            pace.after(self.vertices.len() + self.unknowns * self.unknowns)
                .await;
            let Some(step) = equations.clone().solve(damping) else {
                break;
            };
            let before = self.posed.clone();
            self.take(&step);
            let (next, left) = self.equations();
            if left < error {
                (equations, error) = (next, left);
                damping = (damping / CHANGE).max(DAMPINGS.0);
            } else {
                self.posed = before;
                damping *= CHANGE;
            }
        }
        self.posed
    }

    /// Turns the joints and moves the roots by the numbers of `step`.
    fn take(&mut self, step: &[f64]) {
        let number = |first: usize| DVec3::from_slice(&step[first..first + 3]);
        let model_from_joint = self.posed.model_from_joint(self.model);
        let joints = self.model.skeleton().joints();
        for (joint, described) in joints.iter().enumerate() {
            if let Some(first) = self.turns[joint] {
                let turn = DMat3::from_quat(DQuat::from_scaled_axis(number(first)));
                let parent = described.parent;
                let parent =
                    parent.map_or(DMat3::IDENTITY, |parent| model_from_joint[parent].matrix3);
                let rotation = parent.transpose() * turn * parent * self.posed.rotations[joint];
                self.posed.rotations[joint] = rotation;
            }
            if let Some(first) = self.moves[joint] {
                self.posed.offsets[joint] += number(first);
            }
        }
    }

    /// The normal equations of the next step, and the sum of the squared distances.
    fn equations(&self) -> (Equations, f64) {
        let joints = self.model.skeleton().joints();
        let model_from_joint = self.posed.model_from_joint(self.model);
        let moved: Vec<DAffine3> = (0..joints.len())
            .map(|joint| {
                let to_joint = DAffine3::from_translation(-self.bind_places[joint]);
                model_from_joint[joint] * to_joint
            })
            .collect();
        let mut equations = Equations::new(self.unknowns);
        let mut error = 0.0;
        // What each joint and those below it add to a vertex, and with how much weight.
        let mut added: Vec<(DVec3, f64)> = vec![(DVec3::ZERO, 0.0); joints.len()];
        let mut reached = Vec::new();
        let mut parts: Vec<Part> = Vec::new();
        for &index in &self.vertices {
            let source = self.model.source(self.order, index);
            let mut left = self.theirs[index];
            for influence in self.model.influences(source.weights) {
                let (joint, weight) = (influence.joint as usize, f64::from(influence.weight));
                let place = moved[joint].transform_point3(self.model.positions[source.position]);
                left -= weight * place;
                let mut up = Some(joint);
                while let Some(joint) = up {
                    if added[joint].1 == 0.0 {
                        reached.push(joint);
                    }
                    added[joint].0 += weight * place;
                    added[joint].1 += weight;
                    up = joints[joint].parent;
                }
            }
            error += left.length_squared();
            parts.clear();
            for joint in reached.drain(..) {
                let (sum, weight) = std::mem::take(&mut added[joint]);
                let arm = sum - weight * model_from_joint[joint].translation;
                parts.extend(self.turns[joint].map(|first| (first, turning(arm))));
                let moving = DMat3::from_diagonal(DVec3::splat(weight));
                parts.extend(self.moves[joint].map(|first| (first, moving)));
            }
            add(&mut equations, &parts, left);
        }
        (equations, error)
    }

    fn bind(&self, index: usize) -> DVec3 {
        let source = self.model.source(self.order, index);
        self.model.positions[source.position]
    }
}

/// What a small turn moves the end of `arm` by, as a matrix: turn × arm.
fn turning(arm: DVec3) -> DMat3 {
    let across = |axis: DVec3| axis.cross(arm);
    DMat3::from_cols(across(DVec3::X), across(DVec3::Y), across(DVec3::Z))
}

/// Adds what one vertex tells, of which `left` is left.
fn add(equations: &mut Equations, parts: &[Part], left: DVec3) {
    for (row, of_row) in parts {
        let transposed = of_row.transpose();
        let right = transposed * left;
        for i in 0..3 {
            equations.add_right(row + i, right[i]);
        }
        for (column, of_column) in parts.iter().filter(|(column, _)| column <= row) {
            let product = transposed * *of_column;
            for i in 0..3 {
                for j in 0..3 {
                    equations.add(row + i, column + j, product.col(j)[i]);
                }
            }
        }
    }
}

/// Of the vertices that each joint moves nearly as much as any, some from all over.
fn vertices_of_joints(model: &Model, order: VertexOrder, count: usize) -> Vec<Vec<usize>> {
    let joints = model.skeleton().joints().len();
    let mut most = vec![0.0_f32; joints];
    let influences = |index: usize| model.influences(model.source(order, index).weights);
    for influence in (0..count).flat_map(influences) {
        let most = &mut most[influence.joint as usize];
        *most = most.max(influence.weight);
    }
    let mut found = vec![Vec::new(); joints];
    for index in 0..count {
        for influence in influences(index) {
            let joint = influence.joint as usize;
            if influence.weight > 0.0 && influence.weight >= 0.5 * most[joint] {
                found[joint].push(index);
            }
        }
    }
    for own in &mut found {
        let step = own.len().div_ceil(OF_A_JOINT).max(1);
        *own = own.iter().copied().step_by(step).collect();
    }
    found
}
