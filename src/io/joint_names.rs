use super::scanner;
use crate::character::SkeletalModel;
use std::collections::HashSet;
use strsim::levenshtein;

/// How many names an error suggests.
const SUGGESTED: usize = 3;

/// What to say about `key`, which is a joint of none of `skeletons`; it lists names like it.
pub(super) fn no_such_joint(key: &str, skeletons: &[&SkeletalModel]) -> String {
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
