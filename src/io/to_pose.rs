use super::{Entries, PoseData};
use crate::character::{Pose, SkeletalModel};
use glam::Vec3;
use std::fmt::Write;

impl PoseData {
    /// `pose` as a file has it, with the joints and roots that differ from rest: by name, or by
    /// index where the name is another joint's too.
    pub fn new(skeleton: &SkeletalModel, pose: &Pose) -> Self {
        let joints = 0..skeleton.joints().len();
        let turned = joints.filter_map(|joint| {
            let degrees = pose.rotation(joint).degrees();
            (degrees != Vec3::ZERO).then(|| (key(skeleton, joint), degrees))
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

    /// The text of a `POSE.json`, a joint a line. Numbers have as many digits as it takes to read
    /// the same ones back.
    pub fn to_json(&self) -> String {
        let sections = [("joints", &self.joints), ("roots", &self.roots)];
        let sections = sections
            .iter()
            .filter(|(name, entries)| *name == "joints" || !entries.is_empty());
        let text: Vec<String> = sections
            .map(|(name, entries)| format!("  \"{name}\": {}", object(entries)))
            .collect();
        format!("{{\n{}\n}}\n", text.join(",\n"))
    }
}

fn object(entries: &Entries) -> String {
    if entries.is_empty() {
        return "{}".to_owned();
    }
    let mut text = "{".to_owned();
    for (index, (key, value)) in entries.0.iter().enumerate() {
        let comma = if index == 0 { "" } else { "," };
        // A key can only fail to be written where memory ends; writing to a string cannot fail.
        let key = serde_json::to_string(key).unwrap_or_default();
        let [x, y, z] = value.to_array();
        let _ = write!(text, "{comma}\n    {key}: [{x}, {y}, {z}]");
    }
    text + "\n  }"
}

/// What a pose file calls a joint so that it is this joint again.
fn key(skeleton: &SkeletalModel, joint: usize) -> String {
    let described = &skeleton.joints()[joint];
    let names = [Some(&described.name), described.sid.as_ref()];
    let found = names.into_iter().flatten().find(|name| {
        let is_it = Pose::find_joint(skeleton, name) == Ok(joint);
        is_it && !name.is_empty()
    });
    found.cloned().unwrap_or_else(|| joint.to_string())
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
}
