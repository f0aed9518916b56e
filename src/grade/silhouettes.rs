//! Pictures whose silhouettes several mistakes give: the meshes of the submission tell which of them it makes.

use super::graded::Graded;
use crate::io::{TestData, TestKind};
use std::collections::BTreeSet;

/// Of the explanations of each picture, brings forward the one with mistakes that meshes of the same submission show.
/// `graded` has the results of `tests`, in their order.
pub(super) fn settle(tests: &[TestData], graded: &mut [Graded]) {
    let is_mesh = |test: &TestData| test.kind == TestKind::Mesh;
    let meshes = tests.iter().zip(&*graded).filter(|(test, _)| is_mesh(test));
    let shown = meshes.filter_map(|(_, graded)| graded.causes.first());
    let shown: BTreeSet<String> = shown.flatten().cloned().collect();
    let pictures = tests.iter().zip(graded).filter(|(test, _)| !is_mesh(test));
    for (_, graded) in pictures {
        let is_shown = |ids: &Vec<String>| ids.iter().all(|id| shown.contains(id));
        let Some(place @ 1..) = graded.causes.iter().position(is_shown) else {
            continue;
        };
        graded.causes[..=place].rotate_right(1);
        let counted = graded.causes[0].join(" + ");
        graded.text.push_str(&format!(
            "\n  counted  as {counted}, which meshes of the submission show"
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::Outcome;
    use crate::io::TestsFile;
    use std::path::Path;

    #[test]
    fn of_mistakes_with_one_silhouette_those_count_that_a_mesh_shows() {
        let text = r#"{"tests": [
            {"name": "a", "character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1}},
            {"name": "b", "character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1},
             "kind": "picture", "camera": [80, 10, 3]}
        ]}"#;
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let settled = |mesh: &[&str]| {
            let graded = |causes: &[&[&str]]| Graded {
                causes: causes
                    .iter()
                    .map(|ids| ids.iter().map(|&id| id.to_owned()).collect())
                    .collect(),
                ..Graded::without(Outcome::Explained, "told")
            };
            let picture: [&[&str]; 3] = [&["x"], &["y", "z"], &["z", "w"]];
            let mut both = [graded(&[mesh]), graded(&picture)];
            settle(&file.tests, &mut both);
            let [_, picture] = both;
            (
                picture.causes[0].join(" "),
                picture.causes.len(),
                picture.text,
            )
        };
        let counted = "told\n  counted  as z + w, which meshes of the submission show";
        assert_eq!(settled(&["w", "z"]), ("z w".into(), 3, counted.into()));
        for mesh in [&["x", "y", "z"][..], &["z"], &[]] {
            assert_eq!(settled(mesh), ("x".into(), 3, "told".into()), "{mesh:?}");
        }
    }
}
