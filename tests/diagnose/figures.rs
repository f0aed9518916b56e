//! Characters in poses, as any program reads them from their files.

use editor_core::character::{Attachments, Character, Influence, Pose};
use editor_core::diagnose::{Diagnosis, diagnose};
use editor_core::disk::files;
use editor_core::geometry::Mesh;
use editor_core::io::{PoseFile, import_any};
use editor_core::math::Euler;
use editor_core::scene::ShapeKind;
use glam::Vec3;
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

/// A character in a pose: what is in its files, and the degrees of its joints.
pub struct Figure {
    pub name: String,
    pub character: Arc<Character>,
    pub parents: Vec<Option<usize>>,
    pub offsets: Vec<Vec3>,
    pub positions: Vec<Vec3>,
    pub triangles: Vec<[u32; 3]>,
    /// Rows of an `.attach` file: column c belongs to joint c + 1.
    pub rows: Vec<Vec<f32>>,
    /// Degrees about x, y and z by joint.
    pub degrees: Vec<Vec3>,
    /// How far the first root is moved.
    pub moved: Vec3,
}

impl Figure {
    /// The first character of the file `path` with the angles of `degrees`.
    pub fn new(path: &Path, degrees: impl Fn(usize) -> Vec3) -> Self {
        let shapes = import_any(&files(), path).unwrap().value;
        let character = shapes.into_iter().find_map(|shape| match shape.kind {
            ShapeKind::Character(character) => Some(character.character),
            _ => None,
        });
        let character = character.unwrap();
        let joints = character.skeleton().joints();
        let row = |vertex| {
            let mut row = vec![0.0; joints.len() - 1];
            for influence in character.attachments().of_vertex(vertex) {
                // A skin of a Collada file may name its root, which an `.attach` file cannot.
                if let Some(column) = (influence.joint as usize).checked_sub(1) {
                    row[column] = influence.weight;
                }
            }
            row
        };
        Self {
            name: path.display().to_string(),
            parents: joints.iter().map(|joint| joint.parent).collect(),
            offsets: joints.iter().map(|joint| joint.offset).collect(),
            positions: character.bind_mesh().positions.clone(),
            triangles: character.bind_mesh().triangles.clone(),
            rows: (0..character.attachments().vertex_count())
                .map(row)
                .collect(),
            degrees: (0..joints.len()).map(degrees).collect(),
            moved: Vec3::ZERO,
            character,
        }
    }

    /// The same with other weights.
    pub fn with_rows(self, rows: Vec<Vec<f32>>) -> Self {
        let mut attachments = Attachments::new();
        for row in &rows {
            let influences = (1..).zip(row);
            attachments.push_vertex(influences.map(|(joint, &weight)| Influence { joint, weight }));
        }
        let mesh = Mesh::new(self.positions.clone(), self.triangles.clone());
        let skeleton = self.character.skeleton().clone();
        Self {
            character: Arc::new(Character::new(skeleton, attachments, mesh).unwrap()),
            rows,
            ..self
        }
    }

    /// The same with weights that are rounded to so many digits after the point, so that they do not
    /// sum to 1.
    pub fn with_weights_of(self, digits: usize) -> Self {
        let rounded = |weight: &f32| format!("{weight:.digits$}").parse().unwrap();
        let rows = self
            .rows
            .iter()
            .map(|row| row.iter().map(rounded).collect())
            .collect();
        self.with_rows(rows)
    }

    /// A character of our own, called `name`.
    pub fn builtin(name: &str, degrees: impl Fn(usize) -> Vec3) -> Self {
        Self::new(Path::new(&format!("builtin:{name}")), degrees)
    }

    /// The same with the angles of a pose of ours, but in its place.
    pub fn posed(name: &str, pose: &str) -> Self {
        let plain = Self::builtin(name, |_| Vec3::ZERO);
        let file = PoseFile::open(&files(), Path::new(&format!("builtin:{pose}"))).unwrap();
        let pose = file.pose_of(plain.character.skeleton()).unwrap();
        Self::builtin(name, |joint| pose.rotation(joint).degrees())
    }

    /// The same with one joint that is not turned.
    pub fn without(mut self, joint: usize) -> Self {
        self.degrees[joint] = Vec3::ZERO;
        self
    }

    pub fn pose(&self) -> Pose {
        let mut pose = Pose::new();
        for (joint, &degrees) in self.degrees.iter().enumerate() {
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        let root = self.parents.iter().position(Option::is_none).unwrap();
        pose.set_root_offset(root, self.moved);
        pose
    }

    /// What is found out about a whole mesh with the vertices `theirs`.
    #[track_caller]
    pub fn diagnose(&self, theirs: &[Vec3]) -> Diagnosis {
        self.diagnose_in(&self.pose(), theirs)
    }

    /// The same where `expected` is the pose that the mesh should have.
    #[track_caller]
    pub fn diagnose_in(&self, expected: &Pose, theirs: &[Vec3]) -> Diagnosis {
        diagnose(&self.character, expected, &self.mesh(theirs)).unwrap()
    }

    /// The mesh with the vertices `theirs`. Repeated corners have triangles of their own.
    pub fn mesh(&self, theirs: &[Vec3]) -> Mesh {
        let triangles = if theirs.len() == self.positions.len() {
            self.triangles.clone()
        } else {
            let corners = (0..theirs.len() as u32 / 3).map(|at| 3 * at);
            corners.map(|at| [at, at + 1, at + 2]).collect()
        };
        Mesh::new(theirs.to_vec(), triangles)
    }
}

/// Angles about all axes at all joints, different for each and for each `seed`, up to 70 degrees.
pub fn turned(seed: u32) -> impl Fn(usize) -> Vec3 {
    move |joint| {
        let mut state = (seed << 8)
            .wrapping_add(joint as u32 + 1)
            .wrapping_mul(2_654_435_761);
        let mut angle = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            ((state >> 8) as f32 / (1 << 24) as f32 * 140.0 - 70.0).round()
        };
        Vec3::new(angle(), angle(), angle())
    }
}

/// `points` as a file has them whose numbers have so many digits after the point.
pub fn written(points: &[Vec3], digits: usize) -> Vec<Vec3> {
    let read = |number: f32| format!("{number:.digits$}").parse().unwrap();
    points
        .iter()
        .map(|point| point.to_array().map(read).into())
        .collect()
}

/// `points` as a file has them whose numbers have so many digits in all.
pub fn written_in_all(points: &[Vec3], digits: usize) -> Vec<Vec3> {
    let after = digits - 1;
    let read = |number: f32| format!("{number:.after$e}").parse().unwrap();
    points
        .iter()
        .map(|point| point.to_array().map(read).into())
        .collect()
}

/// How a program writes numbers.
pub type Format = fn(f32) -> String;

/// A posed mesh as a program writes it. Repeated corners have faces of their own.
pub fn obj(places: &[Vec3], figure: &Figure, format: Format) -> String {
    let mut text = String::new();
    for place in places {
        let [x, y, z] = place.to_array().map(format);
        writeln!(text, "v {x} {y} {z}").unwrap();
    }
    let is_same = places.len() == figure.positions.len();
    for (index, &[a, b, c]) in figure.triangles.iter().enumerate() {
        let first = 3 * index as u32;
        let [a, b, c] = if is_same {
            [a, b, c]
        } else {
            [first, first + 1, first + 2]
        };
        if a.max(b).max(c) < places.len() as u32 {
            writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).unwrap();
        }
    }
    text
}
