//! What version 2 of scene files says of a character besides its file: pose, kept poses, settings of
//! inverse kinematics, display. Joints are named, so that it fits a character that has changed.

use super::data::set_display;
use super::text::{degrees, word};
use crate::character::{Pose, SkeletalModel};
use crate::io::PoseData;
use crate::io::angle::ExactDegrees;
use crate::io::joint_names::{Misfit, find_joint};
use crate::io::json_text::{Members, Text};
use crate::io::pose_data::{Entries, Key, key};
use crate::scene::{
    CharacterDisplay, CharacterShape, IkPole, IkSettings, KeptPose, MissingJoints, MissingPose,
    SkinningMethod,
};
use serde::Deserialize;
use serde::de::{Deserializer, Error, MapAccess, Visitor};
use std::collections::BTreeSet;
use std::fmt;
use std::sync::Arc;

/// Everything about a character that is in the scene and not in the character's file.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub(super) struct CharacterData {
    pose: ExactPose,
    poses: KeptPoses,
    ik: IkData,
    skinning_method: SkinningMethod,
    display: CharacterDisplay,
}

/// A pose in which every angle can be written.
#[derive(Clone, Debug, Default)]
struct ExactPose(PoseData);

impl<'de> Deserialize<'de> for ExactPose {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        PoseData::with_angles::<D, ExactDegrees>(deserializer).map(Self)
    }
}

/// Kept poses with their names, in the order of the list.
#[derive(Clone, Debug, Default)]
struct KeptPoses(Vec<(String, ExactPose)>);

impl<'de> Deserialize<'de> for KeptPoses {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Named;
        impl<'de> Visitor<'de> for Named {
            type Value = KeptPoses;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("poses by name")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<KeptPoses, A::Error> {
                let mut poses = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    poses.push(entry);
                }
                Ok(KeptPoses(poses))
            }
        }
        deserializer.deserialize_map(Named)
    }
}

#[derive(Clone, Debug, Deserialize)]
#[serde(default, deny_unknown_fields)]
struct IkData {
    #[serde(deserialize_with = "length")]
    length: usize,
    pole: IkPole,
    keep_orientation: bool,
    pins: Vec<Key>,
}

/// Length of a chain in joints.
fn length<'de, D: Deserializer<'de>>(deserializer: D) -> Result<usize, D::Error> {
    match u32::deserialize(deserializer)? as usize {
        length @ 1..=IkSettings::LONGEST => Ok(length),
        other => Err(D::Error::custom(format!(
            "expected a length from 1 to {}, found {other}",
            IkSettings::LONGEST
        ))),
    }
}

impl Default for IkData {
    fn default() -> Self {
        let IkSettings {
            length,
            pole,
            keep_orientation,
            pins: _,
        } = IkSettings::default();
        Self {
            length,
            pole,
            keep_orientation,
            pins: Vec::new(),
        }
    }
}

impl CharacterData {
    /// A pose and display options.
    pub fn new(pose: PoseData, display: CharacterDisplay) -> Self {
        Self {
            pose: ExactPose(pose),
            display,
            ..Self::default()
        }
    }

    /// What is in the scene about `shape`.
    pub fn of(shape: &CharacterShape) -> Self {
        let skeleton = shape.character.skeleton();
        let missing = &*shape.missing_joints;
        let none = MissingPose::default();
        let named = |pose: &Pose, missing: &MissingPose| {
            ExactPose(PoseData::new(skeleton, pose).with_missing(missing))
        };
        let kept = |kept: &KeptPose| {
            let missing = missing.of_kept(&kept.name).unwrap_or(&none);
            (kept.name.clone(), named(&kept.pose, missing))
        };
        let joints = skeleton.joints().len();
        let pins = shape.ik.pins.iter().filter(|&&pin| pin < joints);
        Self {
            pose: named(shape.pose(), &missing.pose),
            poses: KeptPoses(shape.poses().iter().map(kept).collect()),
            ik: IkData {
                length: shape.ik.length.clamp(1, IkSettings::LONGEST),
                pole: shape.ik.pole,
                keep_orientation: shape.ik.keep_orientation,
                pins: pins
                    .map(|&pin| key(skeleton, pin))
                    .chain(missing.pins.iter().map(|name| Key::named(name)))
                    .collect(),
            },
            skinning_method: shape.skinning_method(),
            display: shape.display,
        }
    }

    /// Sets all of it that fits `shape`, and returns what does not.
    pub fn apply_to(&self, shape: &mut CharacterShape) -> Vec<Misfit> {
        let character = shape.character.clone();
        let skeleton = character.skeleton();
        let mut misfits = Vec::new();
        shape.set_pose(self.pose.0.fit(skeleton, &mut misfits));
        let kept = self.poses.0.iter().map(|(name, pose)| KeptPose {
            name: name.clone(),
            pose: pose.0.fit(skeleton, &mut misfits),
        });
        let kept = kept.collect();
        shape.set_poses(kept);
        shape.ik = self.ik.settings(skeleton, &mut misfits);
        shape.set_skinning_method(self.skinning_method);
        shape.missing_joints = Arc::new(self.missing(skeleton));
        set_display(shape, self.display);
        misfits
    }

    /// What it says about joints that `skeleton` does not have.
    fn missing(&self, skeleton: &SkeletalModel) -> MissingJoints {
        let poses = self.poses.0.iter();
        let poses = poses.map(|(name, pose)| (name.clone(), pose.0.missing(skeleton)));
        let pins = self.ik.pins.iter();
        let pins = pins.filter(|key| find_joint(skeleton, key).is_err());
        MissingJoints {
            pose: self.pose.0.missing(skeleton),
            poses: poses
                .filter(|(_, missing)| *missing != MissingPose::default())
                .collect(),
            pins: pins.map(|key| key.as_str().to_owned()).collect(),
        }
    }

    /// The members that are not as in a new character.
    pub fn members(&self) -> Members {
        let mut members = Members::default();
        members.push_some("pose", self.pose.members());
        let mut poses = Members::default();
        for (name, pose) in &self.poses.0 {
            poses.push(name, pose.members());
        }
        members.push_some("poses", poses);
        members.push_some("ik", self.ik.members());
        if self.skinning_method != SkinningMethod::default() {
            members.push("skinning_method", word(self.skinning_method));
        }
        members.push_some("display", display_members(&self.display));
        members
    }
}

impl ExactPose {
    fn members(&self) -> Members {
        let mut members = Members::default();
        members.push_some("joints", entries(&self.0.joints, degrees));
        members.push_some("roots", entries(&self.0.roots, Text::from));
        members
    }
}

fn entries<V: Copy>(entries: &Entries<V>, text: fn(V) -> Text) -> Members {
    let mut members = Members::default();
    for (key, value) in &entries.0 {
        members.push(key.as_str(), text(*value));
    }
    members
}

impl IkData {
    /// The settings for `skeleton`, with those pins that it has.
    fn settings(&self, skeleton: &SkeletalModel, misfits: &mut Vec<Misfit>) -> IkSettings {
        let mut pins = BTreeSet::new();
        for key in &self.pins {
            match find_joint(skeleton, key) {
                Ok(joint) => drop(pins.insert(joint)),
                Err(misfit) => misfits.push(misfit),
            }
        }
        IkSettings {
            length: self.length,
            pole: self.pole,
            keep_orientation: self.keep_orientation,
            pins,
        }
    }

    fn members(&self) -> Members {
        let standard = Self::default();
        let mut members = Members::default();
        members.push_unless("length", self.length, standard.length);
        if self.pole != standard.pole {
            members.push("pole", word(self.pole));
        }
        members.push_unless(
            "keep_orientation",
            self.keep_orientation,
            standard.keep_orientation,
        );
        if !self.pins.is_empty() {
            let pins = self.pins.iter().map(|pin| Text::from(pin.as_str()));
            members.push("pins", pins.collect::<Vec<_>>());
        }
        members
    }
}

fn display_members(display: &CharacterDisplay) -> Members {
    let standard = CharacterDisplay::default();
    let mut members = Members::default();
    if display.mode != standard.mode {
        members.push("mode", word(display.mode));
    }
    if display.joints != standard.joints {
        members.push("joints", word(display.joints));
    }
    if display.bones != standard.bones {
        members.push("bones", word(display.bones));
    }
    members.push_unless("point_size", display.point_size, standard.point_size);
    members.push_unless("line_width", display.line_width, standard.line_width);
    members
}
