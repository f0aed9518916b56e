use super::content_kind::extension_of;
use super::joint_names::{Misfit, find_joint, find_root, no_such_joint};
use super::json::Json;
use super::pose_data::{Entries, Key, PoseData};
use super::{Diagnostic, Position, scanner};
use crate::character::{Pose, PoseError, SkeletalModel};
use crate::scene::{MissingPose, Scene, ShapeId, ShapeKind};
use std::path::{Path, PathBuf};

/// A pose file: the pose, and the text that errors point into.
#[derive(Clone, Debug)]
pub struct PoseFile {
    path: PathBuf,
    text: String,
    data: PoseData,
}

impl PoseFile {
    /// Reads a `POSE.json`: `{"joints": {"Left elbow": [0, 0, 50], "3": [10, 0, 0]},
    /// "roots": {"Root": [0, 0.2, 0]}}`.
    ///
    /// # Errors
    /// If it is no JSON, or not of this form, or has a name or an index twice, or several poses; one that is
    /// alone among `"poses"` is read.
    pub fn read(path: &Path, bytes: &[u8]) -> Result<Self, Diagnostic> {
        // What is read counts, for a joint of a pose may be called as what tells a scene.
        Self::read_one(path, bytes).map_err(|error| match extension_of(bytes) {
            "scene" | "zip" => {
                let message = "expected a pose, found a scene: open it, and save the pose of its character by \
                               Pose ⏵ Save Pose";
                Diagnostic::new(path, message)
            }
            _ => error,
        })
    }

    fn read_one(path: &Path, bytes: &[u8]) -> Result<Self, Diagnostic> {
        let json = Json::parse(path, bytes)?;
        match json.read() {
            Ok(data) => Ok(Self::of(&json, path, data)),
            Err(error) => match Self::read_several(path, bytes) {
                Ok(Some(several)) => Self::only(path, several),
                _ => Err(error),
            },
        }
    }

    /// The pose `data`, which was read from `json`.
    pub(super) fn of(json: &Json, path: &Path, data: PoseData) -> Self {
        Self {
            path: path.to_owned(),
            text: json.text().to_owned(),
            data,
        }
    }

    /// Its content.
    pub fn data(&self) -> &PoseData {
        &self.data
    }

    /// The poses of those characters of `scene` that have joints of the names or indices in the
    /// file; their other joints are at rest.
    ///
    /// # Errors
    /// If there is no character, or a joint that none has; the message lists names like it. Or if
    /// two entries name one joint.
    pub fn poses_for(&self, scene: &Scene) -> Result<Vec<(ShapeId, Pose)>, Diagnostic> {
        let characters: Vec<(ShapeId, &SkeletalModel)> = scene
            .shapes()
            .iter()
            .filter_map(|shape| match &shape.kind {
                ShapeKind::Character(character) => Some((shape.id, character.character.skeleton())),
                _ => None,
            })
            .collect();
        if characters.is_empty() {
            let message = "expected a character to pose, found none";
            return Err(Diagnostic::new(&self.path, message));
        }
        let skeletons: Vec<_> = characters.iter().map(|(_, skeleton)| *skeleton).collect();
        let poses = self.poses_of(&skeletons)?;
        let posed = characters.into_iter().zip(poses);
        Ok(posed
            .filter_map(|((id, _), pose)| Some((id, pose?)))
            .collect())
    }

    /// The pose for `skeleton`, which must have all its joints.
    ///
    /// # Errors
    /// If it lacks one; the message lists names like it. Or if two entries mean one joint.
    pub fn pose_of(&self, skeleton: &SkeletalModel) -> Result<Pose, Diagnostic> {
        let pose = self.poses_of(&[skeleton])?.pop().flatten();
        Ok(pose.unwrap_or_default())
    }

    /// Whether `skeleton` has any of its joints.
    pub fn fits(&self, skeleton: &SkeletalModel) -> bool {
        self.data.pose_of(skeleton).is_some()
    }

    /// Name or index of the first joint in it, as it is written; `None` if there is none.
    pub fn first_joint(&self) -> Option<&str> {
        let joints = self.data.joints.keys();
        let first = joints.chain(self.data.roots.keys()).next();
        first.map(Key::as_str)
    }

    /// As much of the pose as `skeleton` has joints for, and the joints and roots that it has
    /// not, as the file has them.
    ///
    /// # Errors
    /// If it has none of them, or if two entries mean one joint.
    pub fn what_fits(&self, skeleton: &SkeletalModel) -> Result<(Pose, Vec<&str>), Diagnostic> {
        let Some(pose) = self.data.pose_of(skeleton) else {
            return Ok((self.pose_of(skeleton)?, Vec::new()));
        };
        let once = self.data.check_once(skeleton);
        once.map_err(|misfit| self.diagnostic(misfit))?;
        let joints = self.data.joints.keys().map(Key::as_str);
        let joints = joints.filter(|key| Pose::find_joint(skeleton, key).is_err());
        let roots = self.data.roots.keys().map(Key::as_str);
        let roots = roots.filter(|key| find_root(skeleton, key).is_err());
        Ok((pose, joints.chain(roots).collect()))
    }

    /// The pose for each of `skeletons`, by the joints that it has; `None` for one that has none of them.
    ///
    /// # Errors
    /// If a joint is in none of them; the message lists names like it. Or if two entries mean one joint.
    pub fn poses_of(&self, skeletons: &[&SkeletalModel]) -> Result<Vec<Option<Pose>>, Diagnostic> {
        let poses = self.data.poses_of(skeletons);
        poses.map_err(|misfit| self.diagnostic(misfit))
    }

    fn diagnostic(&self, Misfit { at, message }: Misfit) -> Diagnostic {
        Diagnostic {
            position: Some(Position::in_text(&self.text, at)),
            ..Diagnostic::new(&self.path, message)
        }
    }
}

impl PoseData {
    /// This pose for each of `skeletons`, by the joints that it has; `None` for one that has none
    /// of them.
    ///
    /// # Errors
    /// If a joint is in none of them, or named twice.
    pub(super) fn poses_of(
        &self,
        skeletons: &[&SkeletalModel],
    ) -> Result<Vec<Option<Pose>>, Misfit> {
        self.check(skeletons)?;
        Ok(skeletons
            .iter()
            .map(|skeleton| self.pose_of(skeleton))
            .collect())
    }

    /// As much of this pose as `skeleton` has joints for; adds what it has not to `misfits`.
    pub(super) fn fit(&self, skeleton: &SkeletalModel, misfits: &mut Vec<Misfit>) -> Pose {
        misfits.extend(self.check_once(skeleton).err());
        for key in self.joints.keys() {
            misfits.extend(find_joint(skeleton, key).err());
        }
        for key in self.roots.keys() {
            let at = key.at();
            let not_a_root = |_| find_root(skeleton, key.as_str()).err();
            let found = find_joint(skeleton, key).map(not_a_root);
            let message = |error: PoseError| error.to_string();
            misfits.extend(match found {
                Ok(error) => error.map(message).map(|message| Misfit { at, message }),
                Err(misfit) => Some(misfit),
            });
        }
        self.pose_of(skeleton).unwrap_or_default()
    }

    /// The rest of this pose, which [`PoseData::fit`] leaves out.
    pub(super) fn missing(&self, skeleton: &SkeletalModel) -> MissingPose {
        fn of<V: Copy>(entries: &Entries<V>, is_there: impl Fn(&str) -> bool) -> Vec<(String, V)> {
            let named = entries.0.iter().map(|(key, value)| (key.as_str(), *value));
            let missing = named.filter(|(key, _)| !is_there(key));
            missing
                .map(|(key, value)| (key.to_owned(), value))
                .collect()
        }
        MissingPose {
            joints: of(&self.joints, |key| Pose::find_joint(skeleton, key).is_ok()),
            roots: of(&self.roots, |key| find_root(skeleton, key).is_ok()),
        }
    }

    fn pose_of(&self, skeleton: &SkeletalModel) -> Option<Pose> {
        let mut pose = Pose::new();
        let mut any = false;
        for (key, rotation) in &self.joints.0 {
            if let Ok(joint) = Pose::find_joint(skeleton, key.as_str()) {
                pose.set_joint_transform(joint, *rotation);
                any = true;
            }
        }
        for (key, offset) in &self.roots.0 {
            if let Ok(root) = find_root(skeleton, key.as_str()) {
                pose.set_root_offset(root, *offset);
                any = true;
            }
        }
        any.then_some(pose)
    }

    /// Checks that every joint it names is in one of `skeletons`, and named once.
    fn check(&self, skeletons: &[&SkeletalModel]) -> Result<(), Misfit> {
        type Find = fn(&SkeletalModel, &str) -> Result<usize, PoseError>;
        let in_any = |key: &Key, find: Find| {
            let mut found = skeletons
                .iter()
                .map(|skeleton| find(skeleton, key.as_str()));
            found.any(|found| found.is_ok())
        };
        let misfit = |key: &Key, message| Misfit {
            at: key.at(),
            message,
        };
        if let Some(key) = self
            .joints
            .keys()
            .find(|key| !in_any(key, Pose::find_joint))
        {
            return Err(misfit(key, no_such_joint(key.as_str(), skeletons)));
        }
        if let Some(key) = self.roots.keys().find(|key| !in_any(key, find_root)) {
            let message = if in_any(key, Pose::find_joint) {
                PoseError::NotARoot(key.as_str().to_owned()).to_string()
            } else {
                no_such_joint(key.as_str(), skeletons)
            };
            return Err(misfit(key, message));
        }
        skeletons
            .iter()
            .try_for_each(|skeleton| self.check_once(skeleton))
    }

    /// Checks that no two entries mean one joint.
    fn check_once(&self, skeleton: &SkeletalModel) -> Result<(), Misfit> {
        let joints = self.joints.same_joint(skeleton);
        match joints.or_else(|| self.roots.same_joint(skeleton)) {
            None => Ok(()),
            Some((earlier, key)) => {
                let [found, earlier] = [key, earlier].map(|key| scanner::quoted(key.as_str()));
                let message = format!(
                    "expected each joint once, found {found} and {earlier}, which are the same"
                );
                Err(Misfit {
                    at: key.at(),
                    message,
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::character::{Attachments, Character, Joint};
    use crate::geometry::Mesh;
    use crate::scene::CharacterShape;
    use crate::scene::NewShape;
    use glam::Vec3;
    use std::sync::Arc;

    fn scene_with(names: &[&[&str]]) -> Scene {
        let mut scene = Scene::new();
        for names in names {
            let joints = names.iter().enumerate().map(|(index, name)| Joint {
                name: (*name).to_owned(),
                parent: index.checked_sub(1),
                offset: Vec3::Y,
                ..Joint::default()
            });
            let skeleton = SkeletalModel::new(joints.collect()).unwrap();
            let character = Character::new(skeleton, Attachments::new(), Mesh::default()).unwrap();
            let shape = CharacterShape::new(Arc::new(character));
            scene.add(NewShape::new("C", ShapeKind::Character(shape)));
        }
        scene
    }

    fn apply(text: &str, scene: &mut Scene) -> Result<(), String> {
        PoseFile::read(Path::new("p.json"), text.as_bytes())
            .and_then(|pose| pose.poses_for(scene))
            .map_err(|error| error.to_string())
            .map(|poses| {
                for (id, pose) in poses {
                    scene.character_mut(id).unwrap().set_pose(pose);
                }
            })
    }

    fn degrees(scene: &Scene, shape: u32, joint: usize) -> Vec3 {
        let pose = scene.character(ShapeId(shape)).unwrap().pose();
        pose.rotation(joint).degrees()
    }

    #[test]
    fn as_much_of_a_pose_as_fits_goes_to_another_character_and_the_rest_is_named() {
        let scene = scene_with(&[&["Root", "Elbow"]]);
        let skeleton = scene.character(ShapeId(1)).unwrap().character.skeleton();
        let read = |text: &str| PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap();
        let file = read(
            r#"{"joints": {"Tail": [1, 2, 3], "Elbow": [0, 0, 50]}, "roots": {"Elbow": [0, 1, 0]}}"#,
        );
        let (pose, missing) = file.what_fits(skeleton).unwrap();
        assert!(pose.rotation(1).degrees().abs_diff_eq(Vec3::Z * 50.0, 1e-4));
        assert_eq!(missing, ["Tail", "Elbow"]);
        let error = |text: &str| read(text).what_fits(skeleton).unwrap_err().to_string();
        assert!(error(r#"{"joints": {"Tail": [1, 2, 3]}}"#).starts_with("p.json:1:13: expected"));
        let twice = error(r#"{"joints": {"Elbow": [0, 0, 5], "1": [0, 0, 6], "Tail": [0, 0, 1]}}"#);
        assert!(twice.contains("each joint once"), "{twice}");
    }

    #[test]
    fn a_pose_goes_to_every_character_that_has_the_joints() {
        let mut scene = scene_with(&[&["Root", "Elbow"], &["Root", "Tail"], &["Hip"]]);
        let pose = r#"{"joints": {"Elbow": [0, 0, 50], "Tail": [1, 2, 3]}, "roots": {"Root": [0, 0.2, 0]}}"#;
        apply(pose, &mut scene).unwrap();
        assert!(degrees(&scene, 1, 1).abs_diff_eq(Vec3::Z * 50.0, 1e-4));
        assert!(degrees(&scene, 2, 1).abs_diff_eq(Vec3::new(1.0, 2.0, 3.0), 1e-4));
        let root = scene.character(ShapeId(2)).unwrap().pose().root_offset(0);
        assert_eq!(root, Vec3::new(0.0, 0.2, 0.0));
        assert!(scene.character(ShapeId(3)).unwrap().pose().is_bind());
    }

    #[test]
    fn a_joint_may_be_given_by_its_index_and_joints_not_named_go_to_rest() {
        let mut scene = scene_with(&[&["Root", "Elbow"]]);
        apply(r#"{"joints": {"1": [10, 0, 0]}}"#, &mut scene).unwrap();
        assert!(degrees(&scene, 1, 1).abs_diff_eq(Vec3::X * 10.0, 1e-5));
        apply(r#"{"joints": {"0": [20, 0, 0]}}"#, &mut scene).unwrap();
        assert_eq!(degrees(&scene, 1, 1), Vec3::ZERO);
    }

    #[test]
    fn each_fault_is_told_where_it_is_and_nothing_is_posed() {
        for (text, error) in [
            (
                "{\"joints\": {\n  \"Root\": [1, 2, 3],\n  \"left elbo\": [0, 0, 0]}}",
                "p.json:3:3: expected the name or index of a joint, such as “Left elbow”, “Left foot”, “Root”, found “left elbo”",
            ),
            (
                "{\"joints\": {\"9\": [0, 0, 0]}}",
                "p.json:1:13: expected the name of a joint, or an index from 0 to 2, found “9”",
            ),
            (
                "{\"roots\": {\"Left foot\": [0, 0, 0]}}",
                "p.json:1:12: expected a root joint, found “Left foot”, which has a parent",
            ),
            (
                "{\"joints\": {\"Root\": [0, 0]}}",
                "p.json:1:21: expected three numbers [x, y, z], found 2",
            ),
            (
                "{\"joints\": {\"Root\": [0, 0, \"é\"]}}",
                "p.json:1:28: expected a number, found “é”",
            ),
            (
                "{\"joints\": {\"Root\": [0, 0, 1e300]}}",
                "p.json:1:28: expected a number below 3.4e38, found a larger one",
            ),
            (
                "{\"joints\": {\"0\": [1, 0, 0],\n \"0\": [0, 0, 0]}}",
                "p.json:2:2: expected each name once, found “0” again",
            ),
            (
                "{\"joints\": {\"Left elbow\": [1, 0, 0],\n \"1\": [0, 0, 0]}}",
                "p.json:2:2: expected each joint once, found “1” and “Left elbow”, which are the same",
            ),
            (
                "{\"roots\": {\"0\": [1, 0, 0],\n \"Root\": [0, 0, 0]}}",
                "p.json:2:2: expected each joint once, found “Root” and “0”, which are the same",
            ),
            (
                "{\"joints\": {\"Root\": [0, 0, 0],}}",
                "p.json:1:31: expected another entry after the comma, found “}”",
            ),
            (
                "{\"joints\": {\"Root\": \"up\"}}",
                "p.json:1:21: expected three numbers [x, y, z], found “up”",
            ),
            (
                "{\"Joints\": {}}",
                "p.json:1:2: expected `joints` or `roots`, found “Joints”",
            ),
            (
                "{\"joints\": {",
                "p.json:1:13: expected the rest of an object, found the end of the file",
            ),
            (
                // The same name stands before, as a value, and its key is spelled with an escape.
                "{\"roots\": {\"Root\": [0, 0, 0]},\n \"joints\": {\"R\\u006fot\": [0, 0, 0], \"R\\u006f\": [0, 0, 0]}}",
                "p.json:2:37: expected the name or index of a joint, such as “Root”, “Left foot”, “Left elbow”, found “Ro”",
            ),
            (
                "",
                "p.json:1:1: expected a value, found the end of the file",
            ),
        ] {
            let mut scene = scene_with(&[&["Root", "Left elbow", "Left foot"]]);
            assert_eq!(apply(text, &mut scene), Err(error.to_owned()), "{text}");
            assert!(scene.character(ShapeId(1)).unwrap().pose().is_bind());
        }
        let none = apply("{}", &mut Scene::new());
        assert_eq!(
            none,
            Err("p.json: expected a character to pose, found none".into())
        );
    }
}
