//! Files with several poses, each with a name, as those of the course are:
//! `{"poses": {"walk": {"3": {"name": "Neck", "xyz_deg": [0, 20, 0]}}}}`.

use super::angle::{self, Degrees};
use super::json::Json;
use super::pose_data::{Angles, Entries, Key, PoseData};
use super::{Diagnostic, PoseFile};
use serde::Deserialize;
use serde::de::IgnoredAny;
use std::path::Path;

/// Whatever has several poses.
#[derive(Deserialize)]
struct HasPoses {
    #[serde(rename = "poses")]
    _poses: IgnoredAny,
}

/// Members beside the poses are notes.
#[derive(Deserialize)]
struct Collection {
    poses: Entries<Entries<Turned>>,
}

#[derive(Deserialize)]
struct Turned {
    xyz_deg: Angles<Degrees>,
}

impl PoseFile {
    /// The poses of a file that has several, with their names, in its order; `None` for any other file.
    ///
    /// # Errors
    /// If it is no JSON, or one of its poses is not of that form.
    pub fn read_several(
        path: &Path,
        bytes: &[u8],
    ) -> Result<Option<Vec<(String, Self)>>, Diagnostic> {
        let json = Json::parse(path, bytes)?;
        if json.read::<HasPoses>().is_err() {
            return Ok(None);
        }
        let Collection { poses } = json.read()?;
        let turned = |(key, turned): (Key, Turned)| (key, angle::euler(turned.xyz_deg.0));
        let named = poses.0.into_iter().map(|(name, joints)| {
            let joints = Entries(joints.0.into_iter().map(turned).collect());
            let roots = Entries::default();
            let pose = PoseData { joints, roots };
            (name.as_str().to_owned(), Self::of(&json, path, pose))
        });
        Ok(Some(named.collect()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SEVERAL: &str = r#"{"euler": "Rx Ry Rz", "poses": {
        "walk": {"3": {"name": "Neck", "xyz_deg": [0, 20, 0]}},
        "kick": {"0": {"xyz_deg": [0, 0, 30]}, "Left knee": {"xyz_deg": [50, 0, 0]}}}}"#;

    fn read(text: &str) -> Result<Option<Vec<(String, PoseFile)>>, Diagnostic> {
        PoseFile::read_several(Path::new("p.json"), text.as_bytes())
    }

    #[test]
    fn each_pose_has_its_name_and_its_joints() {
        let poses = read(SEVERAL).unwrap().unwrap();
        let written: Vec<(&str, String)> = poses
            .iter()
            .map(|(name, pose)| (&**name, pose.data().to_json()))
            .collect();
        let expected = [
            ("walk", r#"{"joints": {"3": [0, 20, 0]}}"#),
            (
                "kick",
                r#"{"joints": {"0": [0, 0, 30], "Left knee": [50, 0, 0]}}"#,
            ),
        ];
        let expected = expected.map(|(name, text)| {
            let pose = PoseFile::read(Path::new("p.json"), text.as_bytes()).unwrap();
            (name, pose.data().to_json())
        });
        assert_eq!(written, expected);
    }

    #[test]
    fn a_file_with_one_pose_is_another_matter_and_a_wrong_one_tells_where() {
        assert!(read(r#"{"joints": {}}"#).unwrap().is_none());
        let error = read(r#"{"poses": {"walk": {"3": {"xyz_deg": [0, 20]}}}}"#).unwrap_err();
        assert!(error.to_string().starts_with("p.json:1:"), "{error}");
    }

    #[test]
    fn where_one_pose_is_expected_the_names_of_several_are_told() {
        let error = PoseFile::read(Path::new("p.json"), SEVERAL.as_bytes()).unwrap_err();
        assert_eq!(
            error.to_string(),
            "p.json: expected one pose, found 2 (walk, kick): Load Pose in the window keeps them all with a character"
        );
    }
}
