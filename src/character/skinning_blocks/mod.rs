//! Skinning of many vertices at once: the layout of the weights, and the way through it.

mod kernel;
#[cfg(test)]
mod tests;

use super::{Attachments, Influence};
use crate::geometry::{Mesh, Normals};
use fearless_simd::{Level, dispatch};
use glam::{Mat4, Vec3};
use kernel::{Rows, Span, rows, skin_span};
use std::ops::Range;

/// Vertices of a window: few enough for an index of 16 bits and for the cache, enough for most of the
/// sets of joints to fill blocks of their own.
const WINDOW: usize = 4096;
/// Windows that are worth a thread: below, waking it takes longer than the work.
#[cfg(not(target_arch = "wasm32"))]
const WINDOWS_FOR_A_THREAD: usize = 8;

/// Weights in blocks for each influence, beyond which blocks are not worth it, and so many more that do
/// not matter. Lanes have a weight for each joint of their block: vertices that share no joints, or have
/// them in all orders, would fill memory with zeros.
const MOST_WEIGHTS: usize = 8;
const FEW_WEIGHTS: usize = 1 << 18;

/// Weights of a mesh, laid out for skinning as many vertices at once as the processor has lanes.
///
/// Vertices with the same joints are put into blocks, one vertex a lane, and a block lists each joint
/// once, or more often where its vertices have them in different orders, with one weight a lane: no vertex
/// has an index of its own, and there is no largest number of influences. A lane without a joint that another lane has
/// gets a weight of 0.
///
/// The result is that of [`super::skinning`], bit for bit, on every processor: each lane does the same
/// multiplications and additions in the same order, that of the file, none of them fused. Fused
/// ones were 5 % faster where they were measured; this way, pictures and files are the same everywhere.
///
/// Blocks are made within windows of vertices that follow one another in the file. Each window writes
/// a part of the result of its own, which lets windows be shared out among threads.
#[derive(Clone, Debug)]
pub struct SkinningBlocks {
    level: Level,
    lanes: usize,
    has_normals: bool,
    vertices: usize,
    positions: usize,
    /// Blocks of each window.
    windows: Vec<Range<usize>>,
    /// Start of each block in `joints`, and the end of the last.
    starts: Vec<u32>,
    joints: Vec<u32>,
    /// For each of `joints`, the weights of the block's lanes.
    weights: Vec<f32>,
    /// For each block, what its lanes have in the bind pose: all x, all y, all z of the positions, then
    /// of the normals where there are any.
    bind: Vec<f32>,
    /// For each lane of each block, its vertex, counted from the window's first.
    places: Vec<u16>,
}

/// Skinned vertices, in model space.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skinned {
    /// Positions, in the order of the file.
    pub positions: Vec<Vec3>,
    /// Unit normals, one per vertex of the mesh; `None` for a mesh with flat triangles, whose normals
    /// follow from their corners.
    pub normals: Option<Vec<Vec3>>,
}

impl SkinningBlocks {
    /// Lays out `attachments`, one run for each position of `mesh`, for processors of `level`; `None` if
    /// its vertices have too little in common.
    pub fn new(attachments: &Attachments, mesh: &Mesh, level: Level) -> Option<Self> {
        let normals = match &mesh.normals {
            Normals::Flat => None,
            Normals::PerVertex(normals) => Some(&normals[..]),
        };
        let positions = mesh.positions.len();
        // Only normals tell copies of a position apart.
        let vertices = normals.map_or(positions, <[_]>::len);
        let mut blocks = Self {
            level,
            lanes: kernel::lanes(level),
            has_normals: normals.is_some(),
            vertices,
            positions,
            windows: Vec::new(),
            starts: vec![0],
            joints: Vec::new(),
            weights: Vec::new(),
            bind: Vec::new(),
            places: Vec::new(),
        };
        let sources: Vec<u32> = mesh.position_of_vertices().take(vertices).collect();
        let vertex = |index: usize| {
            let position = sources[index] as usize;
            Vertex {
                influences: attachments.of_vertex(position),
                position: mesh.positions[position],
                normal: normals.map(|normals| normals[index]),
            }
        };
        let mut order = Vec::with_capacity(WINDOW);
        let mut influences = 0;
        for first in (0..vertices).step_by(WINDOW) {
            let first_block = blocks.starts.len() - 1;
            let window = first..(first + WINDOW).min(vertices);
            order.clear();
            order.extend(window.map(|i| (likeness(vertex(i).influences), (i - first) as u16)));
            order.sort_unstable();
            // Vertices without weights come first, in blocks of their own: these stay as they are.
            let at_rest = order.partition_point(|&(likeness, _)| likeness == 0);
            let (at_rest, moved) = order.split_at(at_rest);
            let lanes = blocks.lanes;
            for block in at_rest.chunks(lanes).chain(moved.chunks(lanes)) {
                blocks.push(block, |place| vertex(first + usize::from(place)));
            }
            blocks.windows.push(first_block..blocks.starts.len() - 1);
            let of_window = order.iter().map(|&(_, place)| {
                let vertex = vertex(first + usize::from(place));
                vertex.influences.len()
            });
            influences += of_window.sum::<usize>();
            if blocks.weights.len() > MOST_WEIGHTS * influences + FEW_WEIGHTS {
                return None;
            }
        }
        Some(blocks)
    }

    /// Adds a block of the vertices in `block`. Lanes that are left over repeat the last vertex.
    fn push<'a>(&mut self, block: &[(u64, u16)], vertex: impl Fn(u16) -> Vertex<'a>) {
        let place = |lane: usize| block[lane.min(block.len() - 1)].1;
        let mut joints = Vec::new();
        for &(_, place) in block {
            hold(&mut joints, vertex(place).influences);
        }
        let first_weight = self.weights.len();
        self.weights
            .resize(first_weight + joints.len() * self.lanes, 0.0);
        let first_bind = self.bind.len();
        let numbers = if self.has_normals { 6 } else { 3 };
        self.bind.resize(first_bind + numbers * self.lanes, 0.0);
        for lane in 0..self.lanes {
            let place = place(lane);
            self.places.push(place);
            let vertex = vertex(place);
            let mut from = 0;
            for influence in vertex.influences {
                // All of them are held in this order.
                let Some(at) = find(&joints, from, influence.joint) else {
                    break;
                };
                self.weights[first_weight + at * self.lanes + lane] = influence.weight;
                from = at + 1;
            }
            let position = vertex.position.to_array();
            let normal = vertex.normal.map(|normal| normal.to_array());
            let bind = position.into_iter().chain(normal.into_iter().flatten());
            for (row, number) in bind.enumerate() {
                self.bind[first_bind + row * self.lanes + lane] = number;
            }
        }
        self.joints.extend(joints);
        self.starts.push(self.joints.len() as u32);
    }

    /// Skins all vertices under `palette`, `T · B⁻¹` by joint, whose numbers are finite: those that are
    /// not would spread to vertices that have nothing to do with the joint. What is in `skinned` is
    /// replaced, its memory used again.
    ///
    /// # Panics
    /// If an influence names a joint that the palette lacks.
    pub fn skin(&self, palette: &[Mat4], skinned: &mut Skinned) {
        let palette = rows(palette);
        let Skinned { positions, normals } = skinned;
        positions.resize(self.vertices, Vec3::ZERO);
        if self.has_normals {
            let normals = normals.get_or_insert_default();
            normals.resize(self.vertices, Vec3::ZERO);
        } else {
            *normals = None;
        }
        let of_windows = normals.iter_mut().flat_map(|all| all.chunks_mut(WINDOW));
        let of_windows = of_windows.map(Some).chain(std::iter::repeat_with(|| None));
        let parts = positions.chunks_mut(WINDOW).zip(of_windows);
        let windows = self.windows.iter().cloned().zip(parts);
        self.skin_windows(windows.collect(), &palette);
        positions.truncate(self.positions);
    }

    #[cfg(not(target_arch = "wasm32"))]
    fn skin_windows(&self, windows: Vec<Window<'_>>, palette: &[Rows]) {
        use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, ParallelIterator};
        if windows.len() < 2 * WINDOWS_FOR_A_THREAD {
            self.skin_one_by_one(windows, palette);
        } else {
            windows
                .into_par_iter()
                .with_min_len(WINDOWS_FOR_A_THREAD)
                .for_each(|window| self.skin_window(window, palette));
        }
    }

    /// A page has one thread.
    #[cfg(target_arch = "wasm32")]
    fn skin_windows(&self, windows: Vec<Window<'_>>, palette: &[Rows]) {
        self.skin_one_by_one(windows, palette);
    }

    fn skin_one_by_one(&self, windows: Vec<Window<'_>>, palette: &[Rows]) {
        for window in windows {
            self.skin_window(window, palette);
        }
    }

    fn skin_window(&self, (blocks, (positions, normals)): Window<'_>, palette: &[Rows]) {
        let span = self.span(blocks);
        match normals {
            None => {
                dispatch!(self.level, simd => skin_span::<_, false>(simd, &span, palette, positions, &mut []));
            }
            Some(normals) => {
                dispatch!(self.level, simd => skin_span::<_, true>(simd, &span, palette, positions, normals));
            }
        }
    }

    fn span(&self, blocks: Range<usize>) -> Span<'_> {
        let starts = &self.starts[blocks.start..=blocks.end];
        let joints = starts[0] as usize..starts[starts.len() - 1] as usize;
        let lanes = blocks.start * self.lanes..blocks.end * self.lanes;
        let numbers = if self.has_normals { 6 } else { 3 };
        Span {
            starts,
            weights: &self.weights[joints.start * self.lanes..joints.end * self.lanes],
            joints: &self.joints[joints],
            bind: &self.bind[lanes.start * numbers..lanes.end * numbers],
            places: &self.places[lanes],
        }
    }

    /// Estimated memory, in bytes.
    pub fn memory(&self) -> usize {
        size_of_val(&*self.windows)
            + size_of_val(&*self.starts)
            + size_of_val(&*self.joints)
            + size_of_val(&*self.weights)
            + size_of_val(&*self.bind)
            + size_of_val(&*self.places)
    }
}

/// Blocks of a window, and where their positions and normals go.
type Window<'a> = (Range<usize>, (&'a mut [Vec3], Option<&'a mut [Vec3]>));

struct Vertex<'a> {
    influences: &'a [Influence],
    position: Vec3,
    normal: Option<Vec3>,
}

/// A number by which vertices with the same joints come together, and those with similar ones near to
/// each other: how many influences there are, and which. 0 if there is none.
fn likeness(influences: &[Influence]) -> u64 {
    const BITS: u32 = 48;
    let joints = influences
        .iter()
        .fold(0, |joints, i| joints | 1_u64 << (BITS - 1 - i.joint % BITS));
    let count = (influences.len() as u64).min(u64::from(u16::MAX));
    count << BITS | joints
}

/// Inserts joints, so that those of `influences` are among `joints` in their order, which may be any and
/// may name a joint twice; `joints` that ascend do so still if theirs do.
fn hold(joints: &mut Vec<u32>, influences: &[Influence]) {
    let mut from = 0;
    for &Influence { joint, .. } in influences {
        let at = find(joints, from, joint).unwrap_or_else(|| {
            let larger = joints[from..].iter().position(|&other| other > joint);
            let at = larger.map_or(joints.len(), |place| from + place);
            joints.insert(at, joint);
            at
        });
        from = at + 1;
    }
}

/// The first place from `from` on at which `joint` is.
fn find(joints: &[u32], from: usize, joint: u32) -> Option<usize> {
    let place = joints[from..].iter().position(|&other| other == joint);
    place.map(|place| from + place)
}
