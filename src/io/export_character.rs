//! A character of the scene as the three files of the course's format and a pose file.

use super::export::on_one_line;
use super::{PoseData, TooFarOut, read_skel};
use crate::character::{Attachments, Character, Pose, SkeletalModel};
use crate::geometry::Normals;
use crate::math::{Euler, Transform};
use crate::scene::{CharacterShape, Shape};
use glam::{DMat3, DQuat, Mat4, Vec3};
use std::collections::HashSet;
use std::f64::consts::PI;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// Content of the files of a character.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CharacterFiles {
    /// The `.skel` file.
    pub skel: String,
    /// The `.attach` file.
    pub attach: String,
    /// The `.obj` file, in the bind pose.
    pub obj: String,
    /// The `POSE.json` of the current pose.
    pub pose: String,
}

impl CharacterFiles {
    /// All files to write for a `.skel` file at `path`; the `.obj` file, by which a character is
    /// opened, comes last.
    pub fn into_files(self, path: &Path) -> Vec<(PathBuf, Vec<u8>)> {
        vec![
            (path.with_extension("json"), self.pose.into_bytes()),
            (path.to_owned(), self.skel.into_bytes()),
            (path.with_extension("attach"), self.attach.into_bytes()),
            (path.with_extension("obj"), self.obj.into_bytes()),
        ]
    }
}

/// What is said of a character that has more than the course's files; `None` if it has not.
pub fn left_out_of_course(character: &CharacterShape) -> Option<String> {
    let mesh = character.character.bind_mesh();
    let has = [
        (!mesh.groups.is_empty(), "materials"),
        (!mesh.texture_coordinates.is_empty(), "texture coordinates"),
        (matches!(mesh.normals, Normals::PerVertex(_)), "normals"),
    ];
    let all: Vec<&str> = has
        .iter()
        .filter_map(|(has, what)| has.then_some(*what))
        .collect();
    let (last, others) = all.split_last()?;
    let all = match others {
        [] => (*last).to_owned(),
        others => format!("{} or {last}", others.join(", ")),
    };
    Some(format!(
        "The course's files have no {all}: what the character has of these is left out. Export with Materials writes \
         them, without the skeleton"
    ))
}

/// Reason why a character cannot be written in the course's format.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotExpressible {
    /// Turned joints would shear the mesh.
    #[error(
        "expected a character with one scale for all axes, found “{shape}” with scales of {x}, {y} \
         and {z}: its joints cannot turn in a .skel file as they do here"
    )]
    UnevenScale {
        /// Name of the shape.
        shape: String,
        /// Scale along X, as text.
        x: String,
        /// Scale along Y, as text.
        y: String,
        /// Scale along Z, as text.
        z: String,
    },
    /// The scale is zero.
    #[error("expected a character with a size, found “{shape}” with a scale of 0")]
    NoSize {
        /// Name of the shape.
        shape: String,
    },
    /// There is nothing to bind to the skeleton.
    #[error("expected a character with triangles, found “{shape}” without any")]
    NoMesh {
        /// Name of the shape.
        shape: String,
    },
    /// The weights have a column for every joint, zeros included.
    #[error(
        "expected a character of at most {MOST_WEIGHTS} vertices times joints, found {found}: its \
         .attach file would be too large to be read"
    )]
    TooManyWeights {
        /// Number of vertices times number of joints.
        found: usize,
    },
    /// A number is not finite.
    #[error(transparent)]
    TooFarOut(#[from] TooFarOut),
}

/// Largest number of weights of an `.attach` file. A weight takes two bytes at least, and no file
/// of more than 1 GiB is read.
const MOST_WEIGHTS: usize = 1 << 28;

/// The character `shape` in the world, as the files of the course's format: joints and mesh at
/// rest, and the current pose. Read back and posed by that pose, it has the same vertices as
/// `shape`, up to rounding.
///
/// A `.skel` file has one root, and an `.attach` file no weights of joint 0. A character with
/// several roots, or with weights of joint 0, gets a root above all others; joint `i` is joint
/// `i + 1` then. Only that root can be moved: a root that has moved otherwise than the first one
/// hangs on a joint added for that, its lever. Frames at rest stay parallel to the axes: where the
/// shape is turned, the rotation `R` of a joint is written as `Q R Qᵀ`, with `Q` the rotation of
/// the shape, in Euler angles again.
///
/// # Errors
/// If the format cannot hold the character or its pose; see [`NotExpressible`].
pub fn export_character(
    shape: &Shape,
    character: &CharacterShape,
) -> Result<CharacterFiles, NotExpressible> {
    let name = on_one_line(&shape.name);
    let placed = Placed::new(&name, shape.placement.transform)?;
    let pose = character.pose();
    let character = &character.character;
    let skeleton = character.skeleton();
    let layout = Layout::new(character, pose, &placed);
    let joints = skeleton.joints().len() + layout.added + layout.levers.len();
    let weights = character.attachments().vertex_count() * joints;
    if weights > MOST_WEIGHTS {
        return Err(NotExpressible::TooManyWeights { found: weights });
    }
    let skel = skel_text(skeleton, &placed, &layout);
    // Also tells whether all joints are where numbers reach.
    let read = read_skel(Path::new("written.skel"), skel.as_bytes());
    let far_out = || TooFarOut {
        shape: name.clone(),
    };
    let read = read.map_err(|_| far_out())?.value;
    let pose = placed_pose(skeleton, pose, &placed, &layout);
    Ok(CharacterFiles {
        attach: attach_text(character.attachments(), joints - 1, layout.added),
        obj: obj_text(&name, character, &placed)?,
        pose: PoseData::new(&read, &pose).to_json(),
        skel,
    })
}

/// Joints of the file beside those of the character.
struct Layout {
    /// 1 if there is a root above all others, as joint 0, else 0.
    added: usize,
    /// After all other joints, in the order of their roots.
    levers: Vec<Lever>,
}

/// A joint half way between a root at rest and where it has moved to, relative to the first root.
/// The root hangs on it at the end of a bone that points back; half a turn of the lever takes it to
/// its place, and half a turn of the root itself takes its frame back. So a turn says what a pose
/// file can only say of the one root: how far it has moved.
struct Lever {
    /// Index of the root in the character.
    root: usize,
    /// From the root at rest to the lever, in the world.
    half_way: Vec3,
    /// The half turn, about an axis across `half_way`.
    turn: DMat3,
}

impl Layout {
    fn new(character: &Character, pose: &Pose, placed: &Placed) -> Self {
        let roots = character.skeleton().roots();
        let first = roots
            .first()
            .map_or(Vec3::ZERO, |&root| pose.root_offset(root));
        let lever = |&root: &usize| {
            let half_way = placed.offset(pose.root_offset(root) - first) * 0.5;
            let along = half_way.as_dvec3().try_normalize()?;
            let axis = DQuat::from_axis_angle(along.any_orthonormal_vector(), PI);
            Some(Lever {
                root,
                half_way,
                turn: DMat3::from_quat(axis),
            })
        };
        let mut influences = character.attachments().vertices().flatten();
        let needs_root = roots.len() > 1 || influences.any(|influence| influence.joint == 0);
        Self {
            added: usize::from(needs_root),
            levers: roots.iter().filter_map(lever).collect(),
        }
    }

    /// Number of the lever that `root` hangs on, and the lever.
    fn lever_of(&self, root: usize) -> Option<(usize, &Lever)> {
        let found = self.levers.binary_search_by_key(&root, |lever| lever.root);
        let number = found.ok()?;
        Some((number, &self.levers[number]))
    }
}

/// Placement of the character in the world, apart as far as joints need it.
struct Placed {
    world_from_model: Mat4,
    /// Rotation of the placement, mirrored where it is; the identity if it only moves and scales.
    turn: DMat3,
    mirrored: bool,
}

impl Placed {
    fn new(name: &str, transform: Transform) -> Result<Self, NotExpressible> {
        let scale = transform.scale;
        let size = scale.abs();
        if size.min_element() == 0.0 {
            let shape = name.to_owned();
            return Err(NotExpressible::NoSize { shape });
        }
        // Panels and files round scales, each for itself.
        if size.max_element() - size.min_element() > 1e-6 * size.max_element() {
            return Err(NotExpressible::UnevenScale {
                shape: name.to_owned(),
                x: scale.x.to_string(),
                y: scale.y.to_string(),
                z: scale.z.to_string(),
            });
        }
        let turn = transform.rotation.to_dmat3() * DMat3::from_diagonal(scale.signum().as_dvec3());
        Ok(Self {
            world_from_model: transform.world_from_model(),
            turn,
            mirrored: turn.determinant() < 0.0,
        })
    }

    /// Where a point of model space lies in the world.
    fn point(&self, model: Vec3) -> Vec3 {
        if self.world_from_model == Mat4::IDENTITY {
            model
        } else {
            self.world_from_model.transform_point3(model)
        }
    }

    /// A difference of two points of model space, in the world.
    fn offset(&self, model: Vec3) -> Vec3 {
        if self.world_from_model == Mat4::IDENTITY {
            model
        } else {
            self.world_from_model.transform_vector3(model)
        }
    }

    /// The rotation of a joint, about axes parallel to the world's, after which `lever` is undone.
    fn rotation(&self, euler: Euler, lever: Option<&Lever>) -> Euler {
        if self.turn == DMat3::IDENTITY && lever.is_none() {
            return euler;
        }
        let turned = self.turn * euler.to_dmat3() * self.turn.transpose();
        let turned = lever.map_or(turned, |lever| lever.turn.transpose() * turned);
        Euler::nearest(turned.as_mat3(), euler)
    }
}

/// Lines of the `.skel` file: the added root, the joints of the character, the levers.
fn skel_text(skeleton: &SkeletalModel, placed: &Placed, layout: &Layout) -> String {
    let joints = skeleton.joints();
    let mut taken: HashSet<String> = joints.iter().map(|joint| joint.name.clone()).collect();
    let mut own_name = |base: String| {
        let numbered = (2..).map(|number| format!("{base} {number}"));
        let mut names = std::iter::once(base.clone()).chain(numbered);
        // There are more numbers than joints.
        let name = names.find(|name| !taken.contains(name)).unwrap_or(base);
        taken.insert(name.clone());
        on_one_line(&name)
    };
    let mut out = String::new();
    if layout.added > 0 {
        out += &format!("0 0 0 -1 # {}\n", own_name("Added root".to_owned()));
    }
    for (index, joint) in joints.iter().enumerate() {
        let (at, parent) = match (joint.parent, layout.lever_of(index)) {
            (Some(parent), _) => (placed.offset(joint.offset), (parent + layout.added) as i64),
            (None, Some((number, lever))) => {
                let parent = joints.len() + layout.added + number;
                (-lever.half_way, parent as i64)
            }
            (None, None) => (placed.point(joint.offset), layout.added as i64 - 1),
        };
        let name = on_one_line(&joint.name);
        out += &format!("{} {} {} {parent} # {name}\n", at.x, at.y, at.z);
    }
    for lever in &layout.levers {
        let root = &joints[lever.root];
        let at = placed.point(root.offset) + lever.half_way;
        let name = own_name(format!("Lever of {}", root.name));
        out += &format!("{} {} {} 0 # {name}\n", at.x, at.y, at.z);
    }
    out
}

/// Weights of all joints of the file but the first, `columns` a vertex; joint `i` of `attachments`
/// is joint `i + added` of the file.
fn attach_text(attachments: &Attachments, columns: usize, added: usize) -> String {
    let mut out = String::new();
    let mut row = vec![0.0_f32; columns];
    for influences in attachments.vertices() {
        row.fill(0.0);
        for influence in influences {
            row[influence.joint as usize + added - 1] += influence.weight;
        }
        for (column, weight) in row.iter().enumerate() {
            let space = if column == 0 { "" } else { " " };
            // Writing to a string cannot fail.
            let _ = write!(out, "{space}{weight}");
        }
        out.push('\n');
    }
    out
}

fn obj_text(name: &str, character: &Character, placed: &Placed) -> Result<String, NotExpressible> {
    let mesh = character.bind_mesh();
    let shape = || name.to_owned();
    if mesh.triangles.is_empty() {
        return Err(NotExpressible::NoMesh { shape: shape() });
    }
    let mut out = format!("o {name}\n");
    for &position in &mesh.positions {
        let at = placed.point(position);
        if !at.is_finite() {
            return Err(TooFarOut { shape: shape() }.into());
        }
        // Writing to a string cannot fail.
        let _ = writeln!(out, "v {} {} {}", at.x, at.y, at.z);
    }
    for &[a, b, c] in &mesh.triangles {
        // A mirrored shape would be inside out if its triangles kept their order.
        let [a, b, c] = if placed.mirrored {
            [a, c, b]
        } else {
            [a, b, c]
        };
        let _ = writeln!(out, "f {} {} {}", a + 1, b + 1, c + 1);
    }
    Ok(out)
}

/// `pose` for the skeleton that is written.
fn placed_pose(skeleton: &SkeletalModel, pose: &Pose, placed: &Placed, layout: &Layout) -> Pose {
    let joints = skeleton.joints().len();
    let mut written = Pose::new();
    for joint in 0..joints {
        let lever = layout.lever_of(joint).map(|(_, lever)| lever);
        let rotation = placed.rotation(pose.rotation(joint), lever);
        written.set_joint_transform(joint + layout.added, rotation);
    }
    for (number, lever) in layout.levers.iter().enumerate() {
        let turn = Euler::nearest(lever.turn.as_mat3(), Euler::ZERO);
        written.set_joint_transform(joints + layout.added + number, turn);
    }
    if let Some(&first) = skeleton.roots().first() {
        let root = if layout.added > 0 { 0 } else { first };
        written.set_root_offset(root, placed.offset(pose.root_offset(first)));
    }
    written
}
