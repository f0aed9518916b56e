//! Faces of `.obj` files, as indices of what their corners have.

use crate::geometry::Triangulator;
use glam::Vec3;
use std::ops::Range;

/// One corner of a face, in indices from 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Corner {
    pub position: u32,
    pub texture: Option<u32>,
    pub normal: Option<u32>,
}

/// The faces of a file, each of three corners or more. Large files hold millions of corners: what
/// none of them has takes no space.
#[derive(Debug, Default)]
pub(super) struct Faces {
    count: usize,
    /// Indices of positions, one a corner.
    positions: Vec<u32>,
    /// Those of texture coordinates, [`NONE`] where a corner has none; empty as long as none has.
    texture: Vec<u32>,
    /// Those of normals, as those of texture coordinates.
    normals: Vec<u32>,
    /// Where each face ends among the corners; empty as long as all are triangles.
    ends: Vec<usize>,
}

const NONE: u32 = u32::MAX;

/// Faces that take about as long to be made triangles as [`STRETCH`](super::scanner::STRETCH) bytes to be
/// read.
const FACES: usize = 1 << 11;

impl Faces {
    /// How many there are.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Ranges of faces, in their order, after each of which work may rest.
    pub fn stretches(&self) -> impl Iterator<Item = Range<usize>> {
        let starts = (0..self.count).step_by(FACES);
        starts.map(|start| start..(start + FACES).min(self.count))
    }

    /// Which corners a face has.
    fn corners(&self, face: usize) -> Range<usize> {
        let end = |face: usize| self.ends.get(face).copied().unwrap_or(3 * (face + 1));
        face.checked_sub(1).map_or(0, end)..end(face)
    }

    /// Makes room for so many triangles.
    pub fn make_room(&mut self, triangles: usize) {
        self.positions.reserve_exact(3 * triangles);
    }

    /// How many corners there are.
    pub fn corner_count(&self) -> usize {
        self.positions.len()
    }

    fn corner(&self, at: usize) -> Corner {
        let index = |indices: &[u32]| indices.get(at).copied().filter(|&index| index != NONE);
        Corner {
            position: self.positions[at],
            texture: index(&self.texture),
            normal: index(&self.normals),
        }
    }

    /// Adds a corner to the face that [`Faces::close`] ends.
    #[inline]
    pub fn push(&mut self, corner: Corner) {
        let before = self.positions.len();
        self.positions.push(corner.position);
        for (indices, index) in [
            (&mut self.texture, corner.texture),
            (&mut self.normals, corner.normal),
        ] {
            if index.is_some() || !indices.is_empty() {
                if indices.is_empty() {
                    indices.reserve_exact(self.positions.capacity());
                }
                indices.resize(before, NONE);
                indices.push(index.unwrap_or(NONE));
            }
        }
    }

    /// Makes the corners from `first` on one more face.
    pub fn close(&mut self, first: usize) {
        let end = self.positions.len();
        if end - first != 3 || !self.ends.is_empty() {
            if self.ends.is_empty() {
                self.ends.extend((1..=self.count).map(|face| 3 * face));
            }
            self.ends.push(end);
        }
        self.count += 1;
    }

    /// Whether the corners from `first` on are too few for a face, or the last one lacks a texture coordinate
    /// or a normal that the first one has.
    pub fn is_broken_off(&self, first: usize) -> bool {
        let count = self.positions.len() - first;
        if count < 3 {
            return true;
        }
        let [first, last] = [first, first + count - 1].map(|at| self.corner(at));
        first.texture.is_some() && last.texture.is_none()
            || first.normal.is_some() && last.normal.is_none()
    }

    /// Leaves out the corners from `first` on.
    pub fn truncate(&mut self, first: usize) {
        self.positions.truncate(first);
        self.texture.truncate(first);
        self.normals.truncate(first);
    }

    /// Whether a face has a corner beyond the first so many positions.
    fn is_outside(&self, face: usize, positions: usize) -> bool {
        let mut corners = self.positions[self.corners(face)].iter();
        corners.any(|&position| position as usize >= positions)
    }

    /// How many faces have a corner beyond the first so many positions. They are cut into no triangles.
    pub fn outside(&self, positions: usize) -> usize {
        let all = 0..self.count;
        all.filter(|&face| self.is_outside(face, positions)).count()
    }

    /// Cuts some faces into triangles, as [`Faces::cut`] does one.
    pub fn cut_all(
        &self,
        faces: Range<usize>,
        positions: &[Vec3],
        cutter: &mut Triangulator,
        mut take: impl FnMut([Corner; 3]),
    ) {
        for face in faces.filter(|&face| !self.is_outside(face, positions.len())) {
            self.cut(face, positions, cutter, &mut take);
        }
    }

    /// Cuts a face into triangles. `positions` are those of the file.
    #[inline]
    pub fn cut(
        &self,
        face: usize,
        positions: &[Vec3],
        cutter: &mut Triangulator,
        mut take: impl FnMut([Corner; 3]),
    ) {
        let face = self.corners(face);
        let corner = |at: usize| self.corner(face.start + at);
        if face.len() == 3 {
            return take([0, 1, 2].map(corner));
        }
        let outline = self.positions[face.clone()].iter();
        let outline: Vec<Vec3> = outline.map(|&at| positions[at as usize]).collect();
        for triangle in cutter.cut(&outline) {
            take(triangle.map(corner));
        }
    }

    /// Takes the positions that no face uses out of `positions`, those of the file.
    pub fn keep_used(&mut self, positions: &mut Vec<Vec3>) {
        let mut used = vec![false; positions.len()];
        for &position in &self.positions {
            used[position as usize] = true;
        }
        if used.iter().all(|&used| used) {
            return;
        }
        let mut next = 0;
        let numbered = used.iter().map(|&used| {
            let index = next;
            next += u32::from(used);
            index
        });
        let numbered: Vec<u32> = numbered.collect();
        let mut used = used.into_iter();
        positions.retain(|_| used.next() == Some(true));
        for position in &mut self.positions {
            *position = numbered[*position as usize];
        }
    }
}
