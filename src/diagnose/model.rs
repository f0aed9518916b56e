//! What all formulas share of a character: orders of its joints and vertices.

use super::formula::{JointsBy, Rows, VertexOrder};
use crate::character::{Attachments, Character, Influence, SkeletalModel};
use glam::DVec3;

/// A vertex as a program has it: where its position and its weights are in the files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Source {
    pub(super) position: usize,
    pub(super) weights: usize,
}

/// A character with the orders that formulas may take its parts in.
#[derive(Debug)]
pub(super) struct Model<'a> {
    pub(super) character: &'a Character,
    /// Bind positions in model space.
    pub(super) positions: Vec<DVec3>,
    /// Joints, parents before their children, depth first.
    pub(super) by_depth: Vec<usize>,
    /// For each joint whether it has a weight other than 0.
    pub(super) moves: Vec<bool>,
    /// Vertices that faces use, in the order of their first use.
    first_use: Vec<usize>,
    /// For each vertex its place in that order; its own index if no face uses it.
    place: Vec<usize>,
}

impl<'a> Model<'a> {
    pub(super) fn new(character: &'a Character) -> Self {
        let mesh = character.bind_mesh();
        let (first_use, place) = first_use(&mesh.triangles, mesh.positions.len());
        Self {
            character,
            positions: mesh.positions.iter().map(|p| p.as_dvec3()).collect(),
            by_depth: by_depth(character.skeleton()),
            moves: moves(character),
            first_use,
            place,
        }
    }

    pub(super) fn skeleton(&self) -> &SkeletalModel {
        self.character.skeleton()
    }

    /// A joint by its name and its number, as the file counts them.
    pub(super) fn named(&self, joint: usize) -> String {
        let name = &self.skeleton().joints()[joint].name;
        format!("{name} ({joint})")
    }

    pub(super) fn triangles(&self) -> &'a [[u32; 3]] {
        &self.character.bind_mesh().triangles
    }

    pub(super) fn influences(&self, row: usize) -> &[Influence] {
        self.character.attachments().of_vertex(row)
    }

    /// The weights that a program takes for those of `row`; none if there are none.
    pub(super) fn influences_by(&self, rows: Rows, row: usize) -> &[Influence] {
        let row = match rows {
            Rows::Exact => Some(row),
            Rows::Before => row.checked_sub(1),
            Rows::After => Some(row + 1).filter(|&row| row < self.positions.len()),
        };
        row.map_or(&[], |row| self.influences(row))
    }

    /// The rows that a program may take instead where [`Self::influences_by`] is beyond an end of the weights: the one
    /// at that end again, or the one at the other end.
    pub(super) fn rows_beyond(&self, rows: Rows, row: usize) -> Vec<usize> {
        let last = self.positions.len().saturating_sub(1);
        match rows {
            Rows::Before if row == 0 => vec![0, last],
            Rows::After if row == last => vec![last, 0],
            Rows::Exact | Rows::Before | Rows::After => Vec::new(),
        }
    }

    /// Whether `joint` is `above` or hangs on it, over however many others.
    pub(super) fn hangs_on(&self, joint: usize, above: usize) -> bool {
        let joints = self.skeleton().joints();
        let mut line = std::iter::successors(Some(joint), |&joint| joints[joint].parent);
        line.any(|joint| joint == above)
    }

    /// For each joint, whether it or one below it moves vertices.
    pub(super) fn moving_or_below(&self) -> Vec<bool> {
        let joints = self.skeleton().joints();
        let mut below = self.moves.clone();
        for &joint in self.by_depth.iter().rev() {
            if let Some(parent) = joints[joint].parent {
                below[parent] |= below[joint];
            }
        }
        below
    }

    /// Joint that each index means.
    pub(super) fn joints_by(&self, order: JointsBy) -> Vec<usize> {
        match order {
            JointsBy::File => (0..self.skeleton().joints().len()).collect(),
            JointsBy::Depth => self.by_depth.clone(),
            JointsBy::Level => by_level(self.skeleton()),
            JointsBy::Height => self.by_height(),
            JointsBy::SkinList => self.by_skin_list(),
        }
    }

    /// For each joint the one that its number in the skin's own list means in the list of all.
    fn by_skin_list(&self) -> Vec<usize> {
        let mut order = self.joints_by(JointsBy::File);
        let frames = self.character.file_frames();
        let list = frames.map_or(&[][..], |frames| &frames.skin_joints);
        for (number, &joint) in list.iter().enumerate() {
            order[joint] = number;
        }
        order
    }

    fn by_height(&self) -> Vec<usize> {
        let joints = self.skeleton().joints();
        let mut above = vec![0_usize; joints.len()];
        for &joint in &self.by_depth {
            if let Some(parent) = joints[joint].parent {
                above[joint] = above[parent] + 1;
            }
        }
        let mut order: Vec<usize> = (0..joints.len()).collect();
        order.sort_by_key(|&joint| above[joint]);
        order
    }

    /// Number of vertices that a program writes that has them in `order`.
    pub(super) fn count(&self, order: VertexOrder) -> usize {
        match order {
            VertexOrder::File | VertexOrder::FirstUseInside => self.positions.len(),
            VertexOrder::FirstUse | VertexOrder::FirstUseOfPositions => self.first_use.len(),
            VertexOrder::Corners => self.character.bind_mesh().triangles.len() * 3,
        }
    }

    /// The vertex that such a program writes at `index`, below [`Model::count`].
    pub(super) fn source(&self, order: VertexOrder, index: usize) -> Source {
        let whole = |vertex| Source {
            position: vertex,
            weights: vertex,
        };
        match order {
            VertexOrder::File => whole(index),
            VertexOrder::FirstUse => whole(self.first_use[index]),
            VertexOrder::FirstUseOfPositions => Source {
                position: self.first_use[index],
                weights: index,
            },
            VertexOrder::FirstUseInside => Source {
                position: index,
                weights: self.place[index],
            },
            VertexOrder::Corners => {
                let triangle = self.character.bind_mesh().triangles[index / 3];
                whole(triangle[index % 3] as usize)
            }
        }
    }

    /// The joint that moves a vertex most; `None` for one without weights.
    pub(super) fn strongest(&self, vertex: usize) -> Option<usize> {
        strongest(self.influences(vertex))
    }
}

/// The joint of the largest weight; `None` if there is no weight.
pub(super) fn strongest(influences: &[Influence]) -> Option<usize> {
    Attachments::strongest(influences).map(|joint| joint as usize)
}

fn moves(character: &Character) -> Vec<bool> {
    let mut moves = vec![false; character.skeleton().joints().len()];
    let attachments = character.attachments();
    let rows = (0..attachments.vertex_count()).map(|vertex| attachments.of_vertex(vertex));
    for influence in rows.flatten().filter(|influence| influence.weight != 0.0) {
        moves[influence.joint as usize] = true;
    }
    moves
}

fn first_use(triangles: &[[u32; 3]], vertices: usize) -> (Vec<usize>, Vec<usize>) {
    let mut order = Vec::with_capacity(vertices);
    let mut place: Vec<usize> = (0..vertices).collect();
    let mut is_used = vec![false; vertices];
    for corner in triangles.iter().flatten() {
        let vertex = *corner as usize;
        if !std::mem::replace(&mut is_used[vertex], true) {
            place[vertex] = order.len();
            order.push(vertex);
        }
    }
    (order, place)
}

fn by_depth(skeleton: &SkeletalModel) -> Vec<usize> {
    let mut order = Vec::new();
    let mut open: Vec<usize> = skeleton.roots().iter().rev().copied().collect();
    while let Some(joint) = open.pop() {
        order.push(joint);
        open.extend(skeleton.children(joint).iter().rev());
    }
    order
}

fn by_level(skeleton: &SkeletalModel) -> Vec<usize> {
    let mut order = skeleton.roots().to_vec();
    let mut next = 0;
    while let Some(&joint) = order.get(next) {
        order.extend(skeleton.children(joint));
        next += 1;
    }
    order
}
