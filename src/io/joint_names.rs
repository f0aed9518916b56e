//! Joints by their names or indices in files, and what is said of those that no skeleton has.

use super::pose_data::Key;
use super::scanner;
use crate::character::{Pose, PoseError, SkeletalModel};
use std::collections::HashSet;
use strsim::levenshtein;

/// An entry that fits no skeleton.
#[derive(Debug)]
pub(super) struct Misfit {
    /// The byte of the text where its key starts.
    pub at: usize,
    /// The message: what was expected and what was found.
    pub message: String,
}

/// Index of the joint of `skeleton` that `key` means.
///
/// # Errors
/// If it has none; the message lists names like it.
pub(super) fn find_joint(skeleton: &SkeletalModel, key: &Key) -> Result<usize, Misfit> {
    Pose::find_joint(skeleton, key.as_str()).map_err(|_| Misfit {
        at: key.at(),
        message: no_such_joint(key.as_str(), &[skeleton]),
    })
}

/// Index of the root of `skeleton` that `key` means.
///
/// # Errors
/// If it has no such joint, or that is no root.
pub(super) fn find_root(skeleton: &SkeletalModel, key: &str) -> Result<usize, PoseError> {
    let joint = Pose::find_joint(skeleton, key)?;
    if skeleton.roots().contains(&joint) {
        Ok(joint)
    } else {
        Err(PoseError::NotARoot(key.to_owned()))
    }
}

/// How many names an error suggests.
const SUGGESTED: usize = 3;

/// The message about `key`, which is a joint of none of `skeletons`; it lists names like it.
pub fn no_such_joint(key: &str, skeletons: &[&SkeletalModel]) -> String {
    let found = scanner::quoted(key);
    if key.parse::<i64>().is_ok() {
        let most = skeletons.iter().map(|skeleton| skeleton.joints().len());
        let last = most.max().unwrap_or(0).saturating_sub(1);
        return format!(
            "expected the name of a joint, or an index from 0 to {last}, found {found}"
        );
    }
    let names = skeletons.iter().flat_map(|skeleton| skeleton.joints());
    let names: HashSet<&str> = names.map(|joint| joint.name.as_str()).collect();
    let key = key.to_lowercase();
    let mut near: Vec<(usize, &str)> = names
        .into_iter()
        .map(|name| (levenshtein(&key, &name.to_lowercase()), name))
        .collect();
    near.sort_unstable();
    let near: Vec<String> = near
        .iter()
        .take(SUGGESTED)
        .map(|(_, name)| scanner::quoted(name))
        .collect();
    format!(
        "expected the name or index of a joint, such as {}, found {found}",
        near.join(", ")
    )
}
