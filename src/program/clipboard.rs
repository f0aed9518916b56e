//! Shapes and poses on the clipboard, as the texts of scene and pose files, so that they go from
//! window to window and into mails.

use super::Host;
use super::autosave::WithText;
use super::awaited::Awaited;
use super::files::{CLIPBOARD, listed};
use super::reading::Use;
use super::running::Program;
use crate::character::{Mirror, Pose, SkeletalModel};
use crate::editor::{Edit, Severity, for_all_selected, scene_of_selected, set_apart};
use crate::io::{self, Loaded, Missing, PoseFile, ReadJob, Wanted};
use crate::revision::Revision;
use crate::scene::ShapeId;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Name under which the text on the clipboard is read as a scene.
const AS_SCENE: &str = "clipboard.scene";

/// What gets what is on the clipboard.
#[derive(Clone, Debug)]
pub(super) struct PasteInto {
    /// The document.
    opened: Revision,
    /// The character that a pose would be for.
    shape: Option<ShapeId>,
    pasted: Pasted,
    /// Whether shapes would be added.
    takes_shapes: bool,
}

/// What a character gets of a pose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Pasted {
    pub sides: Sides,
    /// The joints that get it; `None` for all.
    pub joints: Option<Vec<usize>>,
    /// Whether these are the ones of which it was copied, and not those that are selected.
    pub as_copied: bool,
    /// Selected joints that the character of which it was copied has not, so that they stay as they are.
    pub unknown: Vec<usize>,
    /// Joints of which it was copied that the character which gets it has not.
    pub lacking: Vec<String>,
}

impl Pasted {
    /// All of a pose.
    pub(super) fn whole(sides: Sides) -> Self {
        Self {
            sides,
            joints: None,
            as_copied: false,
            unknown: Vec::new(),
            lacking: Vec::new(),
        }
    }

    /// The pose `before` with what it gets of `pose`, and the joints that get it, if these are not all.
    pub(super) fn onto(
        &self,
        skeleton: &SkeletalModel,
        before: &Pose,
        pose: Pose,
    ) -> (Pose, Option<Vec<usize>>) {
        let pose = match self.sides {
            Sides::AsTheyAre => pose,
            Sides::Exchanged => Mirror::new(skeleton).pose(&pose),
        };
        let Some(joints) = &self.joints else {
            return (pose, None);
        };
        let there = joints.iter().copied();
        let joints: Vec<usize> = there
            .filter(|&joint| joint < skeleton.joints().len())
            .collect();
        (before.with_joints_of(&pose, &joints), Some(joints))
    }

    /// That these joints alone get it, or why none does. The character has not all joints that the pose turns: not the
    /// `missing` ones.
    pub(super) fn told(
        &self,
        skeleton: &SkeletalModel,
        joints: &[usize],
        missing: &[&str],
    ) -> (Severity, String) {
        let has_no = self.has_no(skeleton);
        let onto = match joints {
            [] => {
                let text = match has_no {
                    Some(has_no) => format!("Nothing is pasted: {has_no}"),
                    None => {
                        "The pose on the clipboard is of joints that this character does not have"
                            .to_owned()
                    }
                };
                return (Severity::Warning, text);
            }
            &[joint] => format!("{} alone", skeleton.joints()[joint].name),
            joints => format!("{} joints", joints.len()),
        };
        let mirrored = match self.sides {
            Sides::AsTheyAre => "",
            Sides::Exchanged => "mirrored ",
        };
        let is_lacking = |name: &&str| self.lacking.iter().any(|lacking| lacking == name);
        let lacking: Vec<&str> = missing.iter().copied().filter(is_lacking).collect();
        let (severity, why) = match (self.as_copied, has_no) {
            (true, _) if lacking.is_empty() => (Severity::Info, ", as copied".to_owned()),
            (true, _) => {
                let lacking = listed(&lacking);
                let why = format!(", without {lacking}, which this character does not have");
                (Severity::Warning, why)
            }
            (false, None) => (
                Severity::Info,
                "; with no joint selected, onto all".to_owned(),
            ),
            (false, Some(has_no)) => (Severity::Info, format!("; {has_no}")),
        };
        (severity, format!("Pasted {mirrored}onto {onto}{why}"))
    }

    /// Which of the selected joints the pose lacks.
    fn has_no(&self, skeleton: &SkeletalModel) -> Option<String> {
        match self.unknown[..] {
            [] => None,
            [joint] => Some(format!("the pose has no {}", skeleton.joints()[joint].name)),
            _ => Some(format!(
                "the pose lacks {} of the selected joints",
                self.unknown.len()
            )),
        }
    }
}

/// A pose that was put on the clipboard. Its text, which other windows read, has neither joints at rest nor which are meant.
#[derive(Clone, Debug)]
pub(super) struct CopiedPose {
    /// The character that has it.
    shape: ShapeId,
    /// The joints that are meant, by index and name: those that were selected, or else all.
    joints: Vec<(usize, String)>,
    /// Whether they were selected, so that they are meant whatever is selected when it is pasted.
    were_selected: bool,
    /// What was put on the clipboard.
    text: String,
}

impl CopiedPose {
    /// The joints of the character `shape` that get it: those of the same names in another one.
    fn onto(&self, shape: ShapeId, skeleton: &SkeletalModel, sides: Sides) -> Vec<usize> {
        let all = skeleton.joints();
        let named = |name: &str| all.iter().position(|joint| joint.name == name);
        let joints = self
            .joints
            .iter()
            .filter_map(|(index, name)| match self.shape == shape {
                true => Some(*index),
                false => named(name),
            });
        match sides {
            Sides::AsTheyAre => joints.collect(),
            Sides::Exchanged => {
                let mirror = Mirror::new(skeleton);
                joints.map(|joint| mirror.partner(joint)).collect()
            }
        }
    }

    /// Names of the joints that the character `shape` has not.
    fn lacking(&self, shape: ShapeId, skeleton: &SkeletalModel) -> Vec<String> {
        let has = |name: &str| skeleton.joints().iter().any(|joint| joint.name == name);
        let names = self.joints.iter().map(|(_, name)| name);
        let lacking = names.filter(|name| self.shape != shape && !has(name));
        lacking.cloned().collect()
    }

    /// What the character `shape` gets of it, where the user asked for `pasted`.
    fn meant(&self, pasted: Pasted, shape: ShapeId, skeleton: &SkeletalModel) -> Pasted {
        let known = self.onto(shape, skeleton, pasted.sides);
        match pasted.joints {
            _ if self.were_selected => Pasted {
                joints: Some(known),
                as_copied: true,
                lacking: self.lacking(shape, skeleton),
                ..pasted
            },
            Some(selected) => {
                let is_known = |joint: &usize| known.contains(joint);
                let (joints, unknown) = selected.into_iter().partition(is_known);
                Pasted {
                    joints: Some(joints),
                    unknown,
                    ..pasted
                }
            }
            None => pasted,
        }
    }
}

/// What is left and right in a pose that a character gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sides {
    AsTheyAre,
    Exchanged,
}

impl Program {
    /// Asks the host for what is on the clipboard: shapes, or a pose for the character `shape`.
    pub(super) fn ask_for_clipboard(
        &mut self,
        shape: Option<ShapeId>,
        pasted: Pasted,
        host: &mut dyn Host,
    ) {
        self.paste_into = Some(PasteInto {
            opened: self.session.opened(),
            shape,
            pasted,
            takes_shapes: true,
        });
        host.request_paste();
    }

    /// Asks the host for a pose on the clipboard, for the character `shape`.
    pub(super) fn ask_for_pose(&mut self, shape: ShapeId, sides: Sides, host: &mut dyn Host) {
        self.paste_into = Some(PasteInto {
            opened: self.session.opened(),
            shape: Some(shape),
            pasted: Pasted::whole(sides),
            takes_shapes: false,
        });
        host.request_paste();
    }

    /// Puts the pose of the character `shape` on the clipboard, of which the `selected` joints alone are meant if there are
    /// any.
    pub(super) fn copy_pose(&mut self, shape: ShapeId, selected: Vec<usize>, host: &mut dyn Host) {
        let scene = self.session.scene();
        let of = scene.shape(shape).zip(scene.character(shape));
        let Some(((of, character), text)) = of.zip(self.pose_text(shape, None)) else {
            return;
        };
        host.copy_text(text.clone());
        let all = character.character.skeleton().joints();
        let were_selected = !selected.is_empty();
        let meant = match were_selected {
            true => selected,
            false => (0..all.len()).collect(),
        };
        let joints: Vec<(usize, String)> = meant
            .into_iter()
            .filter_map(|joint| Some((joint, all.get(joint)?.name.clone())))
            .collect();
        let told = match &*joints {
            all_of_it if all_of_it.len() == all.len() => format!("Copied the pose of {}", of.name),
            [(_, name)] => {
                format!("Copied the pose of {name} alone; with no joint selected, of all")
            }
            some => format!(
                "Copied the pose of {} joints; with none selected, of all",
                some.len()
            ),
        };
        self.tell(Severity::Info, told);
        self.copied_pose = Some(CopiedPose {
            shape,
            joints,
            were_selected,
            text,
        });
    }

    /// What the character `shape` gets of the pose `text`.
    fn meant(&self, pasted: Pasted, shape: ShapeId, text: &str) -> Pasted {
        let copied = self.copied_pose.as_ref();
        let copied = copied.filter(|it| it.text.lines().eq(text.lines()));
        match copied.zip(self.session.scene().character(shape)) {
            Some((copied, character)) => {
                copied.meant(pasted, shape, character.character.skeleton())
            }
            None => pasted,
        }
    }

    /// Puts the selected shapes on the clipboard, which messages call `done`; whether that was possible.
    pub(super) fn copy_shapes(&mut self, done: &str, host: &mut dyn Host) -> bool {
        let scene = scene_of_selected(&self.session);
        match io::scene_text(&scene, self.session.view(), None) {
            Ok(text) => {
                host.copy_text(text);
                let text = match scene.shapes() {
                    [shape] => format!("{done} {}", shape.name),
                    shapes => format!("{done} {} shapes", shapes.len()),
                };
                self.tell(Severity::Info, text);
                true
            }
            Err(error) => {
                self.tell(Severity::Error, format!("Not copied: {error}"));
                false
            }
        }
    }

    /// Puts the selected shapes on the clipboard, and deletes them.
    pub(super) fn cut_shapes(&mut self, host: &mut dyn Host) {
        let Some(id) = self.session.selected() else {
            return;
        };
        if self.copy_shapes("Cut", host) {
            let edit = for_all_selected(&self.session, Edit::Delete(id));
            self.edit(edit);
        }
    }

    /// Adds the shapes that were asked for from the clipboard, or gives the pose to its character.
    pub(super) fn paste(&mut self, text: &str, host: &mut dyn Host) {
        let Some(into) = self.paste_into.take() else {
            return;
        };
        let PasteInto {
            opened,
            shape,
            pasted,
            takes_shapes,
        } = into;
        if self.is_from_another_scene(opened) {
            return;
        }
        let is_scene = text.contains("\"editor-scene\"");
        let path = Path::new(CLIPBOARD);
        let posed = shape.filter(|&shape| self.session.scene().character(shape).is_some());
        let neither = match posed {
            _ if text.trim().is_empty() => {
                "There is nothing on the clipboard: Copy and Copy Pose put something there"
            }
            _ if is_scene && takes_shapes => return self.paste_shapes(text, host),
            _ if is_scene => {
                "There are shapes on the clipboard and no pose: Copy Pose puts one there, Paste adds the shapes"
            }
            // What begins like this is meant to be a pose, whose fault is worth telling.
            Some(shape) if text.trim_start().starts_with('{') => {
                let pasted = self.meant(pasted, shape, text);
                return self.take_pose(shape, path, text.as_bytes(), &pasted);
            }
            None if PoseFile::read(path, text.as_bytes()).is_ok() => {
                "There is a pose on the clipboard, no shape: select the character that takes it"
            }
            _ => "There are no shapes and no pose on the clipboard",
        };
        self.tell(Severity::Warning, neither);
    }

    pub(super) fn paste_shapes(&mut self, text: &str, host: &mut dyn Host) {
        if self.has_to_wait(&Awaited::Paste(text.to_owned()), host) {
            return;
        }
        let path = PathBuf::from(AS_SCENE);
        let files = WithText {
            path: path.clone(),
            text: text.to_owned(),
            rest: host.files(),
        };
        let job = ReadJob {
            files: Arc::new(files),
            paths: vec![path],
            wanted: Wanted::Document(Missing::StandIn),
        };
        self.read(job, Use::Paste, host);
    }

    /// Adds shapes that were on the clipboard.
    pub(super) fn insert_pasted(&mut self, loaded: Loaded) {
        let mut shapes = loaded.shapes;
        set_apart(&self.session, &mut shapes);
        self.edit(Edit::Paste(shapes));
        self.tell_all(Severity::Warning, loaded.warnings);
    }
}
