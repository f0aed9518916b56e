//! Skinning on the processor: milliseconds for a million vertices, which are nanoseconds for one.

mod bucketed;
mod course;

use crate::report::Report;
use bucketed::Bucketed;
pub use course::Course;
use cpu_time::ProcessTime;
use editor_core::character::{Attachments, Character, Influence, Pose, Skinned, SkinningBlocks};
use editor_core::disk::Disk;
use editor_core::geometry::Mesh;
use editor_core::io::Loaded;
use editor_core::io::builtin::WithBuiltin;
use editor_core::math::Euler;
use editor_core::scene::ShapeKind;
use fearless_simd::Level;
use glam::{Mat4, Quat, Vec3};
use rayon::iter::{IndexedParallelIterator, ParallelIterator};
use rayon::slice::{ParallelSlice, ParallelSliceMut};
use rayon::{ThreadPool, ThreadPoolBuilder};
use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

const ROUNDS: usize = 60;
const MILLION: usize = 1_000_000;

pub fn run(report: &mut Report) {
    let one = figure(&adult());
    for (name, level, most) in levels() {
        report.ratio(
            &format!("Skinning by blocks with {name} against one vertex's matrices at a time"),
            most,
            || {
                let bucketed = Bucketed::new(&one.attachments, &one.mesh, Level::new());
                let blocks = one.blocks(level);
                let (mut skinned, mut out) = (Skinned::default(), Vec::new());
                one.least(
                    || blocks.skin(black_box(&one.palette), &mut skinned),
                    || bucketed.skin(black_box(&one.palette), &mut out),
                )
            },
        );
        report.ratio(
            &format!("Skinning by blocks with {name} against one vertex's matrices at a time, put into the file's order"),
            most,
            || {
                let bucketed = Bucketed::new(&one.attachments, &one.mesh, Level::new());
                let blocks = one.blocks(level);
                let mut skinned = Skinned::default();
                let (mut sorted, mut out) = (Vec::new(), Vec::new());
                one.least(
                    || blocks.skin(black_box(&one.palette), &mut skinned),
                    || bucketed.skin_in_order(black_box(&one.palette), &mut sorted, &mut out),
                )
            },
        );
    }
    report.ratio(
        "Skinning by blocks against the course's loop",
        1.0 / 30.0,
        || {
            let course = Course::new(&one.attachments, one.palette.len());
            let blocks = one.blocks(Level::new());
            let (mut skinned, mut out) = (Skinned::default(), Vec::new());
            one.least(
                || blocks.skin(black_box(&one.palette), &mut skinned),
                || course.skin(black_box(&one.current), &one.bind, &one.mesh, &mut out),
            )
        },
    );
    report.ratio(
        "Skinning by blocks with normals against without",
        2.0,
        || {
            let mut with_normals = one.clone();
            let up = vec![Vec3::Y; one.mesh.positions.len()];
            with_normals.mesh = with_normals.mesh.with_normals(up);
            let (with, without) = (with_normals.blocks(Level::new()), one.blocks(Level::new()));
            let (mut all, mut positions) = (Skinned::default(), Skinned::default());
            one.least(
                || with.skin(black_box(&one.palette), &mut all),
                || without.skin(black_box(&one.palette), &mut positions),
            )
        },
    );
    report.ratio(
        "Skinning a mesh of 100 characters on two threads against on one, by the clock",
        1.0 / 1.8,
        || {
            let crowd = one.repeated(100);
            let blocks = crowd.blocks(Level::new());
            let (mut skinned, mut too) = (Skinned::default(), Skinned::default());
            let (two, one) = (pool(2), pool(1));
            crowd.least_by_the_clock(
                || two.install(|| blocks.skin(black_box(&crowd.palette), &mut skinned)),
                || one.install(|| blocks.skin(black_box(&crowd.palette), &mut too)),
            )
        },
    );
    for threads in [1, 2] {
        let what = format!(
            "Skinning a million coherent vertices against copying as many bytes, threads: {threads}, by the clock"
        );
        report.ratio(&what, 1.0 / 0.9, || {
            let coherent = coherent();
            let blocks = coherent.blocks(Level::new());
            let mut skinned = Skinned::default();
            // Four weights, a position and its place are read, a position is written; a copy does both.
            let bytes = MILLION * (4 * 4 + 12 + 2 + 12) / 2;
            let (from, mut to) = (vec![1_u8; bytes], vec![0_u8; bytes]);
            let pool = pool(threads);
            coherent.least_by_the_clock(
                || pool.install(|| blocks.skin(black_box(&coherent.palette), &mut skinned)),
                || pool.install(|| copy(black_box(&from), &mut to, threads)),
            )
        });
    }
}

/// Levels of dispatch of this processor, and how much of a bucketed kernel's time each may take.
fn levels() -> Vec<(&'static str, Level, f64)> {
    let best = Level::new();
    #[cfg(target_arch = "x86_64")]
    if let Some(avx2) = best.as_avx2() {
        let mut levels = vec![("AVX2", Level::Avx2(avx2), 0.5)];
        if best.as_avx512().is_some() {
            levels.push(("AVX-512", best, 1.0 / 3.0));
        }
        return levels;
    }
    vec![("what the processor has", best, 1.0)]
}

/// A mesh with weights, in a pose.
#[derive(Clone)]
pub struct Posed {
    mesh: Mesh,
    attachments: Attachments,
    /// From each joint to the model, in the bind pose and now.
    bind: Vec<Mat4>,
    current: Vec<Mat4>,
    /// `current` times the inverse of `bind`.
    palette: Vec<Mat4>,
}

impl Posed {
    fn blocks(&self, level: Level) -> SkinningBlocks {
        SkinningBlocks::new(&self.attachments, &self.mesh, level)
            .expect("its vertices have much in common")
    }

    /// So many vertices with so many influences each, those of a hundred neighbors alike.
    pub fn regular(vertices: usize, joints: usize, influences: usize) -> Self {
        let mut attachments = Attachments::new();
        for vertex in 0..vertices {
            let first = vertex / 100;
            attachments.push_vertex((first..first + influences).map(|joint| Influence {
                joint: (joint % joints) as u32,
                weight: 1.0 / influences as f32,
            }));
        }
        let positions = (0..vertices).map(|at| Vec3::new(at as f32 * 1e-6, 1.0, 2.0));
        let palette = (0..joints).map(|joint| {
            Mat4::from_rotation_translation(Quat::from_rotation_y(joint as f32 * 0.01), Vec3::X)
        });
        Self {
            mesh: Mesh::new(positions.collect(), Vec::new()),
            attachments,
            bind: Vec::new(),
            current: Vec::new(),
            palette: palette.collect(),
        }
    }

    /// What skins it once on so many threads.
    pub fn skinning(&self, threads: usize) -> impl FnMut() + use<> {
        let blocks = self.blocks(Level::new());
        let (pool, palette) = (pool(threads), self.palette.clone());
        let mut skinned = Skinned::default();
        move || pool.install(|| blocks.skin(black_box(&palette), &mut skinned))
    }

    /// The same so many times in one mesh.
    fn repeated(&self, times: usize) -> Self {
        let mut attachments = Attachments::new();
        let mut positions = Vec::new();
        for _ in 0..times {
            positions.extend_from_slice(&self.mesh.positions);
            for vertex in self.attachments.vertices() {
                attachments.push_vertex(vertex.iter().copied());
            }
        }
        Self {
            mesh: Mesh::new(positions, Vec::new()),
            attachments,
            ..self.clone()
        }
    }

    /// Milliseconds of the processor of both, each for a million vertices.
    fn least(&self, one: impl FnMut(), other: impl FnMut()) -> (f64, f64) {
        self.least_by(
            ProcessTime::now,
            |start| start.elapsed().as_secs_f64(),
            one,
            other,
        )
    }

    /// Milliseconds of both, each for a million vertices.
    fn least_by_the_clock(&self, one: impl FnMut(), other: impl FnMut()) -> (f64, f64) {
        self.least_by(
            Instant::now,
            |start| start.elapsed().as_secs_f64(),
            one,
            other,
        )
    }

    fn least_by<T>(
        &self,
        now: impl Fn() -> T,
        seconds_since: impl Fn(&T) -> f64,
        mut one: impl FnMut(),
        mut other: impl FnMut(),
    ) -> (f64, f64) {
        let times = MILLION.div_ceil(self.mesh.positions.len());
        let millions = (times * self.mesh.positions.len()) as f64 / MILLION as f64;
        let timed = |work: &mut dyn FnMut()| {
            let start = now();
            for _ in 0..times {
                work();
            }
            seconds_since(&start) * 1e3 / millions
        };
        let rounds = (0..ROUNDS).map(|_| (timed(&mut one), timed(&mut other)));
        rounds.fold((f64::INFINITY, f64::INFINITY), |least, round| {
            (least.0.min(round.0), least.1.min(round.1))
        })
    }
}

fn adult() -> Arc<Character> {
    let mut loaded = Loaded::default();
    loaded
        .add(&WithBuiltin(Disk), Path::new("builtin:adult"))
        .expect("a built-in character");
    let shape = loaded.shapes.remove(0);
    let ShapeKind::Character(shape) = shape.kind else {
        panic!("builtin:adult is a character");
    };
    shape.character
}

fn figure(character: &Character) -> Posed {
    let skeleton = character.skeleton();
    let mut pose = Pose::new();
    for joint in 0..skeleton.joints().len() {
        let angles = Vec3::new(10.0, -20.0, 7.0) * (joint as f32).sin();
        pose.set_joint_transform(joint, Euler::from_degrees(angles));
    }
    let current = skeleton.update_current_joint_to_world_transforms(&pose);
    let mesh = character.bind_mesh();
    Posed {
        mesh: Mesh::new(mesh.positions.clone(), Vec::new()),
        attachments: character.attachments().clone(),
        bind: skeleton.update_current_joint_to_world_transforms(&Pose::new()),
        palette: skeleton.palette(&current),
        current,
    }
}

/// A million vertices with four influences each, those of neighbors alike.
fn coherent() -> Posed {
    let mut attachments = Attachments::new();
    for vertex in 0..MILLION {
        let joint = (vertex / 5000 % 60) as u32;
        attachments.push_vertex(
            [0.4, 0.3, 0.2, 0.1]
                .iter()
                .zip(joint..)
                .map(|(&weight, joint)| Influence { joint, weight }),
        );
    }
    let positions = (0..MILLION).map(|at| Vec3::new(at as f32 * 1e-6, 1.0, 2.0));
    let palette = (0..64).map(|joint| {
        Mat4::from_rotation_translation(Quat::from_rotation_y(joint as f32 * 0.01), Vec3::X)
    });
    Posed {
        mesh: Mesh::new(positions.collect(), Vec::new()),
        attachments,
        bind: Vec::new(),
        current: Vec::new(),
        palette: palette.collect(),
    }
}

fn pool(threads: usize) -> ThreadPool {
    ThreadPoolBuilder::new()
        .num_threads(threads)
        .build()
        .expect("threads")
}

fn copy(from: &[u8], to: &mut [u8], parts: usize) {
    let part = from.len().div_ceil(parts);
    let both = to.par_chunks_mut(part).zip(from.par_chunks(part));
    both.for_each(|(to, from)| to.copy_from_slice(from));
}
