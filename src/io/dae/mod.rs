//! Collada (`.dae`): rigged characters and static meshes.
//!
//! The reader is forgiving: a broken part is left out with a warning, and only a file with nothing
//! left is an error. Everything ends up in one space, +Y up and in
//! meters. As elsewhere joints are parallel to the axes at rest, so a joint is a place: its
//! file's rest orientation is not kept but in the direction of its bone. All angles are 0 in the
//! pose that the nodes of the scene have (`rest_pose`).
//!
//! Memory and time stay in proportion to the size of the file (limits in `document`).

mod assemble;
mod document;
mod instances;
mod materials;
mod meshes;
mod report;
mod rest_pose;
mod rigs;
mod skin;
mod sources;
mod visual_scene;

use super::encoding::no_text;
use super::scanner::quoted;
use super::{Diagnostic, Files, Imported};
use crate::character::{Character, FileFrames, Joint, SkeletalModel};
use crate::geometry::Mesh;
use crate::steps::{Pace, at_once};
use assemble::{Assembler, Part, Placement, SkinPlacement};
use document::{Dae, FARTHEST, Impact, label, parse_xml};
use glam::DMat4;
use instances::{Instance, collect};
use materials::Materials;
pub use report::{DaeReport, InverseBind};
use rigs::{Rig, Rigs};
use std::borrow::Cow;
use std::path::Path;
use visual_scene::SceneNode;
pub use visual_scene::{FileSpace, UpAxis};

/// Content of a Collada file.
#[derive(Clone, Debug)]
pub struct DaeScene {
    /// Skeletons with the meshes bound to them, in the order of their first skin. The skins of
    /// one skeleton are one mesh, one after the other in the order of the scene, followed by
    /// meshes that hang rigidly below its joints. One without any skin has a mesh without
    /// positions.
    pub characters: Vec<DaeCharacter>,
    /// Meshes that no skeleton moves, in the order of the scene.
    pub meshes: Vec<DaeMesh>,
    /// Facts about the file.
    pub report: DaeReport,
}

/// A character and its name in the file.
#[derive(Clone, Debug)]
pub struct DaeCharacter {
    /// The name of the node that holds its roots.
    pub name: String,
    /// Its joints are in the order of the scene, parents before children.
    pub character: Character,
}

/// A static mesh and its name in the file.
#[derive(Clone, Debug)]
pub struct DaeMesh {
    /// The name of its node.
    pub name: String,
    /// In our space, its node's transform applied.
    pub mesh: Mesh,
}

/// Reads the Collada file at `path`, and the pictures that it names, from `files`.
///
/// # Errors
/// If the file cannot be read, is no Collada, exceeds the reader's limits, or shows nothing; then
/// the error is the first thing that went wrong, where something did.
pub fn read_dae(files: &dyn Files, path: &Path) -> Result<Imported<DaeScene>, Diagnostic> {
    at_once(|pace| async move { read_dae_by(files, path, &pace).await })
}

/// As [`read_dae`], at a pace that is told of bytes.
///
/// # Errors
/// As [`read_dae`].
pub(super) async fn read_dae_by(
    files: &dyn Files,
    path: &Path,
    pace: &Pace,
) -> Result<Imported<DaeScene>, Diagnostic> {
    let bytes = files.read(path)?;
    pace.after(bytes.len() / 8).await;
    if let Some(found) = no_text(&bytes) {
        return Err(Diagnostic::new(
            path,
            format!("expected Collada, found {found}"),
        ));
    }
    let text = document_text(&bytes);
    pace.after(bytes.len() / 8).await;
    let xml = parse_xml(path, &text)?;
    pace.after(bytes.len()).await;
    let dae = Dae::new(path, &text, &xml)?;
    let mut scene = read_scene(&dae, files, pace).await?;
    let mut empty = None;
    if scene.characters.is_empty() && scene.meshes.is_empty() {
        let message = "expected meshes or joints in the scene, found none";
        empty = Some(dae.error(visual_scene::find(&dae)?, message));
    }
    let (warnings, ignored) = dae.into_notes();
    if let Some(empty) = empty {
        return Err(warnings.into_iter().next().unwrap_or(empty));
    }
    scene.report.ignored = ignored;
    Ok(Imported {
        value: scene,
        warnings,
    })
}

/// Line ends as XML wants them and no byte that is not UTF-8: names in other encodings suffer,
/// numbers do not.
fn document_text(bytes: &[u8]) -> Cow<'_, str> {
    // The search for what is not UTF-8 is slower than to see that there is nothing of it.
    let text = std::str::from_utf8(bytes);
    let text = text.map_or_else(|_| String::from_utf8_lossy(bytes), Cow::Borrowed);
    if bytes.contains(&b'\r') {
        Cow::Owned(text.replace("\r\n", "\n").replace('\r', "\n"))
    } else {
        text
    }
}

async fn read_scene<'a>(
    dae: &Dae<'a>,
    files: &'a dyn Files,
    pace: &Pace,
) -> Result<DaeScene, Diagnostic> {
    let space = FileSpace::read(dae);
    let ours_from_file = space.ours_from_file();
    let mut nodes = visual_scene::flatten(dae)?;
    pace.begin(0.2..0.7);
    let instances = collect(dae, &mut nodes, pace).await?;
    ignore_libraries(dae);
    let rigs = Rigs::new(&nodes, &instances);
    let mut assembler = Assembler::new(dae, Materials::new(files), DaeReport::new(space));
    let mut parts: Vec<Part> = rigs.rigs.iter().map(|_| Part::default()).collect();
    let mut rigid = Vec::new();
    let mut meshes = Vec::new();
    pace.begin(0.7..1.0);
    for (index, instance) in instances.iter().enumerate() {
        pace.tell(index as f32 / instances.len() as f32);
        pace.after(instance.bytes()).await;
        let world = nodes[instance.node].world;
        if let Some(binding) = &instance.binding {
            assembler.report.skins += 1;
            if let Some(rig) = rigs.of_binding(binding) {
                let joint_of_node = &rigs.rigs[rig].joint_of_node;
                assembler.add_skin(&mut parts[rig], instance, binding, &nodes, joint_of_node)?;
            } else {
                dae.warn(
                    Impact::Shape,
                    instance.xml,
                    "expected a skeleton, found no joint: the mesh stays as it is",
                );
                let ours_from_mesh = ours_from_file * binding.skin.bind_shape;
                meshes.push(static_mesh(
                    &mut assembler,
                    instance,
                    ours_from_mesh,
                    &nodes,
                )?);
            }
        } else if let Some((rig, joint)) = rigs.carrier(instance.node) {
            rigid.push((instance, rig, joint));
        } else {
            meshes.push(static_mesh(
                &mut assembler,
                instance,
                ours_from_file * world,
                &nodes,
            )?);
        }
    }
    for (instance, rig, joint) in rigid {
        let ours_from_mesh = ours_from_file * nodes[instance.node].world;
        let placement = Placement::Whole(ours_from_mesh);
        assembler.add(&mut parts[rig].builder, instance, &placement)?;
        assembler.add_rigid(&mut parts[rig], instance, joint);
    }
    assembler.materials.warn_of_missing_pictures(dae);
    let characters = rigs
        .rigs
        .iter()
        .zip(parts)
        .map(|(rig, part)| {
            Ok(DaeCharacter {
                name: Rigs::name(rig, &nodes).to_owned(),
                character: character(dae, &rigs, rig, part, &nodes, ours_from_file)?,
            })
        })
        .collect::<Result<_, Diagnostic>>()?;
    Ok(DaeScene {
        characters,
        meshes,
        report: assembler.report,
    })
}

fn static_mesh<'a>(
    assembler: &mut Assembler<'_, 'a>,
    instance: &Instance<'a>,
    ours_from_mesh: DMat4,
    nodes: &[SceneNode<'a>],
) -> Result<DaeMesh, Diagnostic> {
    let mut part = Part::default();
    let placement = Placement::Whole(ours_from_mesh);
    assembler.add(&mut part.builder, instance, &placement)?;
    let name = nodes[instance.node].xml.attribute("name");
    Ok(DaeMesh {
        name: name.unwrap_or(&instance.geometry.name).to_owned(),
        mesh: part.builder.build(),
    })
}

fn character(
    dae: &Dae,
    rigs: &Rigs,
    rig: &Rig,
    part: Part,
    nodes: &[SceneNode],
    ours_from_file: DMat4,
) -> Result<Character, Diagnostic> {
    let at = |joint: usize| {
        rig.nodes
            .get(joint)
            .map_or(dae.root, |&node| nodes[node].xml)
    };
    let joints = rigs.joints(rig, nodes, ours_from_file);
    if let Some(far) = joints.iter().position(is_far) {
        return Err(dae.error(
            at(far),
            "expected a joint at a finite place, found one too far away",
        ));
    }
    let skeleton = SkeletalModel::new(joints)
        .map_err(|error| dae.error(at(error.joint().unwrap_or(0)), error.to_string()))?;
    let frames = file_frames(rig, &part.placements, nodes, ours_from_file);
    let character = Character::new(skeleton, part.attachments, part.builder.build())
        .map_err(|error| dae.error(at(0), error.to_string()))?;
    Ok(match frames {
        Some(frames) => character.with_file_frames(frames),
        None => character,
    })
}

/// The frames of the joints in the file, and what places the mesh there; `None` where that is not the same for the whole
/// mesh, or cannot be taken back.
fn file_frames(
    rig: &Rig,
    placements: &[SkinPlacement],
    nodes: &[SceneNode],
    ours_from_file: DMat4,
) -> Option<FileFrames> {
    let first = placements.first()?;
    let rest = first.rest?;
    if placements.iter().any(|other| other.rest != first.rest) {
        return None;
    }
    let model_from_joint = rig
        .nodes
        .iter()
        .map(|&node| ours_from_file * nodes[node].world);
    let is_shared = placements
        .iter()
        .all(|other| other.bind_shape == first.bind_shape);
    let changes = first.bind_shape != DMat4::IDENTITY;
    let has_inverse = |matrix: DMat4| matrix.inverse().is_finite();
    let bind_shape = Some(first.bind_shape)
        .filter(|bind_shape| is_shared && changes && has_inverse(rest * *bind_shape));
    let list = |placement: &SkinPlacement| {
        let joints = placement.joints.iter().copied();
        let joints: Option<Vec<usize>> = joints.map(|it| Some(it? as usize)).collect();
        joints.unwrap_or_default()
    };
    let frames = FileFrames {
        model_from_joint: model_from_joint.collect(),
        placed: rest,
        bind_shape,
        skin_joints: match placements.iter().all(|other| other.joints == first.joints) {
            true => list(first),
            false => Vec::new(),
        },
    };
    let mut of_joints = frames.model_from_joint.iter().copied();
    (has_inverse(rest) && of_joints.all(has_inverse)).then_some(frames)
}

fn is_far(joint: &Joint) -> bool {
    // Not a number compares as false.
    let near = f64::from(joint.offset.abs().max_element()) < FARTHEST;
    !near || joint.offset.is_nan()
}

/// Counts the libraries whose content is not used.
fn ignore_libraries(dae: &Dae) {
    for library in dae.root.children().filter(roxmltree::Node::is_element) {
        let tag = library.tag_name().name();
        let read = [
            "asset",
            "scene",
            "extra",
            "library_controllers",
            "library_effects",
            "library_geometries",
            "library_images",
            "library_materials",
            "library_nodes",
            "library_visual_scenes",
        ];
        if !read.contains(&tag) && library.has_children() {
            dae.ignore(tag);
        }
    }
}
