//! The content of pose files: joints by name or index with their angles, read and written.

use super::angle::{self, Angle, Degrees};
use super::{json_text, json_values};
use crate::character::{Pose, SkeletalModel};
use crate::math::Euler;
use crate::scene::MissingPose;
use glam::Vec3;
use serde::Deserialize;
use serde::de::{Deserializer, MapAccess, Visitor};
use serde_spanned::Spanned;
use std::collections::HashMap;
use std::fmt::{self, Write};
use std::marker::PhantomData;

/// A pose as files have it: joints by name or index.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PoseData {
    /// Name or index of a joint, and its angles about X, Y and Z.
    pub joints: Entries<Euler>,
    /// Name or index of a root, and how far it has moved, in the character's model space.
    pub roots: Entries<Vec3>,
}

/// Joints with three numbers each, in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Entries<V>(pub Vec<(Key, V)>);

impl<V> Default for Entries<V> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

/// The name or the index of a joint, as a file has it.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(transparent)]
pub struct Key(Spanned<String>);

impl Key {
    /// A key that is in no file yet.
    pub(super) fn named(name: &str) -> Self {
        Self(Spanned::new(0..0, name.to_owned()))
    }

    /// The name, or the index in decimal.
    pub fn as_str(&self) -> &str {
        self.0.get_ref()
    }

    /// The byte of the file's text where it starts.
    pub(super) fn at(&self) -> usize {
        self.0.span().start
    }
}

impl<V> Entries<V> {
    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Names and indices, in the order of the file.
    pub fn keys(&self) -> impl Iterator<Item = &Key> {
        self.0.iter().map(|(key, _)| key)
    }

    /// The first two keys that mean one joint of `skeleton`, by its name, sid or index.
    pub(super) fn same_joint(&self, skeleton: &SkeletalModel) -> Option<(&Key, &Key)> {
        let mut seen: HashMap<usize, &Key> = HashMap::new();
        self.keys().find_map(|key| {
            let joint = Pose::find_joint(skeleton, key.as_str()).ok()?;
            Some((seen.insert(joint, key)?, key))
        })
    }
}

impl<'de, V: Deserialize<'de>> Deserialize<'de> for Entries<V> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Pairs<V>(PhantomData<V>);
        impl<'de, V: Deserialize<'de>> Visitor<'de> for Pairs<V> {
            type Value = Entries<V>;

            fn expecting(&self, f: &mut fmt::Formatter) -> fmt::Result {
                f.write_str("joints with three numbers each")
            }

            fn visit_map<A: MapAccess<'de>>(self, mut map: A) -> Result<Entries<V>, A::Error> {
                let mut entries = Vec::new();
                while let Some(entry) = map.next_entry()? {
                    entries.push(entry);
                }
                Ok(Entries(entries))
            }
        }
        deserializer.deserialize_map(Pairs(PhantomData))
    }
}

/// Three angles of a file.
pub(super) struct Angles<A>(pub [A; 3]);

impl<'de, A: Angle> Deserialize<'de> for Angles<A> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        json_values::three(deserializer, PhantomData::<A>).map(Self)
    }
}

/// Three lengths of a file.
struct Offset(Vec3);

impl<'de> Deserialize<'de> for Offset {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        json_values::vec3(deserializer, |_| Ok(())).map(Self)
    }
}

#[derive(Deserialize)]
#[serde(default, deny_unknown_fields, bound = "A: Angle")]
struct Fields<A> {
    joints: Entries<Angles<A>>,
    roots: Entries<Offset>,
}

impl<A> Default for Fields<A> {
    fn default() -> Self {
        Self {
            joints: Entries::default(),
            roots: Entries::default(),
        }
    }
}

impl<'de> Deserialize<'de> for PoseData {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Self::with_angles::<D, Degrees>(deserializer)
    }
}

impl PoseData {
    /// A pose whose angles are read as `A`.
    pub(super) fn with_angles<'de, D: Deserializer<'de>, A: Angle>(
        deserializer: D,
    ) -> Result<Self, D::Error> {
        let Fields::<A> { joints, roots } = Fields::deserialize(deserializer)?;
        let turned = |(key, Angles(angles))| (key, angle::euler(angles));
        let moved = |(key, Offset(offset))| (key, offset);
        Ok(Self {
            joints: Entries(joints.0.into_iter().map(turned).collect()),
            roots: Entries(roots.0.into_iter().map(moved).collect()),
        })
    }
}

impl PoseData {
    /// The joints and roots of `pose` that differ from rest: by name, or by index where the name
    /// is another joint's too. Angles are those of the pose, however many turns they make.
    pub fn new(skeleton: &SkeletalModel, pose: &Pose) -> Self {
        let joints = 0..skeleton.joints().len();
        let turned = joints.filter_map(|joint| {
            let rotation = pose.rotation(joint);
            (rotation != Euler::ZERO).then(|| (key(skeleton, joint), rotation))
        });
        let roots = skeleton.roots().iter().filter_map(|&root| {
            let offset = pose.root_offset(root);
            (offset != Vec3::ZERO).then(|| (key(skeleton, root), offset))
        });
        Self {
            joints: Entries(turned.collect()),
            roots: Entries(roots.collect()),
        }
    }

    /// Adds what is known of joints that the character does not have.
    pub(super) fn with_missing(mut self, missing: &MissingPose) -> Self {
        let joints = missing.joints.iter();
        let joints = joints.map(|(name, rotation)| (Key::named(name), *rotation));
        self.joints.0.extend(joints);
        let roots = missing.roots.iter();
        let roots = roots.map(|(name, offset)| (Key::named(name), *offset));
        self.roots.0.extend(roots);
        self
    }

    /// The text of a `POSE.json`, a joint a line. Numbers have as many digits as it takes to read
    /// the same ones back.
    pub fn to_json(&self) -> String {
        let mut text = format!(
            "{{\n  \"joints\": {}",
            object(&self.joints, Euler::shortest_degrees)
        );
        if !self.roots.is_empty() {
            // Writing to a string cannot fail.
            let _ = write!(text, ",\n  \"roots\": {}", object(&self.roots, |v| v));
        }
        text + "\n}\n"
    }
}

fn object<V: Copy>(entries: &Entries<V>, numbers: fn(V) -> Vec3) -> String {
    if entries.is_empty() {
        return "{}".to_owned();
    }
    let mut text = "{".to_owned();
    for (index, (key, value)) in entries.0.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        let key = json_text::string(key.as_str());
        // Adding 0 takes the sign from -0.
        let [x, y, z] = (numbers(*value) + Vec3::ZERO).to_array();
        let _ = write!(text, "{comma}\n    {key}: [{x}, {y}, {z}]");
    }
    text + "\n  }"
}

/// The key under which a pose file finds `joint` again: its name, its sid or its index.
pub(super) fn key(skeleton: &SkeletalModel, joint: usize) -> Key {
    let described = &skeleton.joints()[joint];
    let names = [Some(&described.name), described.sid.as_ref()];
    let found = names.into_iter().flatten().find(|name| {
        let is_it = Pose::find_joint(skeleton, name) == Ok(joint);
        is_it && !name.is_empty()
    });
    // Where another joint is called by the number, `#` tells the two apart.
    let mut index = joint.to_string();
    while found.is_none() && Pose::find_joint(skeleton, &index) != Ok(joint) {
        index.insert(0, '#');
    }
    Key::named(found.unwrap_or(&index))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::Joint;
    use crate::io::PoseFile;
    use crate::math::Euler;
    use std::path::Path;

    fn skeleton(names: &[&str]) -> SkeletalModel {
        let joints = names.iter().enumerate().map(|(index, name)| Joint {
            name: (*name).to_owned(),
            parent: index.checked_sub(1),
            offset: Vec3::Y,
            ..Joint::default()
        });
        SkeletalModel::new(joints.collect()).unwrap()
    }

    #[test]
    fn a_pose_that_was_written_is_read_back() {
        let skeleton = skeleton(&["Root", "El\"bow", "Same", "Same"]);
        let mut pose = Pose::new();
        pose.set_root_offset(0, Vec3::new(0.1, 0.2, -1.0e-7));
        for joint in 1..4 {
            let degrees = Vec3::new(12.34, -0.1, 100.0 / 3.0) * joint as f32;
            pose.set_joint_transform(joint, Euler::from_degrees(degrees));
        }
        let text = PoseData::new(&skeleton, &pose).to_json();
        let read = PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap();
        let back = read.pose_of(&skeleton).unwrap();
        for joint in 0..4 {
            let (found, expected) = (back.rotation(joint).radians, pose.rotation(joint).radians);
            assert!(
                found.abs_diff_eq(expected, 1e-6),
                "{joint}: {found} {expected}\n{text}"
            );
            assert_eq!(back.root_offset(joint), pose.root_offset(joint));
        }
        assert!(
            text.contains("\"3\": ["),
            "the second of one name goes by its index\n{text}"
        );
    }

    #[test]
    fn the_rest_pose_is_a_file_without_joints() {
        let text = PoseData::new(&skeleton(&["Root"]), &Pose::new()).to_json();
        assert_eq!(text, "{\n  \"joints\": {}\n}\n");
        assert!(PoseFile::read(Path::new("p.json"), text.as_bytes()).is_ok());
    }

    #[test]
    fn angles_are_written_as_they_are_in_the_pose() {
        let skeleton = skeleton(&["Root", "Arm"]);
        let written = |degrees: Vec3| {
            let mut pose = Pose::new();
            pose.set_joint_transform(1, Euler::from_degrees(degrees));
            PoseData::new(&skeleton, &pose).to_json()
        };
        for (degrees, text) in [
            ([-6.0, 0.0, 90.0], "[-6, 0, 90]"),
            ([354.0, -720.0, 1080.5], "[354, -720, 1080.5]"),
            ([0.1, -12.34, 179.99], "[0.1, -12.34, 179.99]"),
            ([33.333332, 1e-7, -359.9], "[33.333332, 0.0000001, -359.9]"),
        ] {
            let found = written(Vec3::from(degrees));
            assert!(found.contains(&format!("\"Arm\": {text}")), "{found}");
        }
        for tenths in -7200..=7200_i16 {
            let found = written(Vec3::X * (f32::from(tenths) / 10.0));
            let (sign, size) = (if tenths < 0 { "-" } else { "" }, tenths.unsigned_abs());
            let text = match size % 10 {
                0 => format!("{sign}{}", size / 10),
                tenth => format!("{sign}{}.{tenth}", size / 10),
            };
            let whole = tenths == 0 || found.contains(&format!("[{text}, 0, 0]"));
            assert!(whole, "{text} {found}");
        }
    }

    #[test]
    fn an_angle_that_was_written_is_read_as_the_nearest_there_is() {
        let skeleton = skeleton(&["Root", "Arm"]);
        let mut same = 0;
        let angles = (1..2000_u16).map(|i| f32::from(i) * -0.006_931);
        for radians in angles.clone() {
            let mut pose = Pose::new();
            pose.set_joint_transform(1, Euler::from_radians(Vec3::X * radians));
            let text = PoseData::new(&skeleton, &pose).to_json();
            let read = PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap();
            let back = read.pose_of(&skeleton).unwrap().rotation(1).radians.x;
            same += u32::from(back == radians);
            // One step of an `f32` at most: not every angle is a number of degrees.
            let step = (back.to_bits().abs_diff(radians.to_bits())) <= 1;
            assert!(step, "{radians} {back} {text}");
        }
        assert!(same > 1500, "{same}");
    }
}
