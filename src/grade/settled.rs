//! Files that several mistakes give alike: the other meshes of the submission tell which of them it makes.

use super::graded::Graded;
use crate::io::{TestData, TestKind};
use std::collections::{BTreeMap, BTreeSet};

/// Of the explanations of each mesh, brings forward the one that most meshes of the submission have, and of those of each
/// picture the one with mistakes that its meshes show, or else the one that most pictures have. `graded` has the results
/// of `tests`, in their order.
pub(super) fn settle(tests: &[TestData], graded: &mut [Graded]) {
    let all = tests.iter().zip(graded);
    let (meshes, pictures): (Vec<_>, Vec<_>) =
        all.partition(|(test, _)| test.kind == TestKind::Mesh);
    let [mut meshes, pictures] = [meshes, pictures].map(|of_kind| {
        let results = of_kind.into_iter().map(|(_, graded)| graded);
        results.collect::<Vec<&mut Graded>>()
    });
    settle_by_most(&mut meshes, "meshes");
    let mut undecided = settle_by_meshes(pictures, &meshes);
    settle_by_most(&mut undecided, "pictures");
}

/// Brings forward the explanation that most of `results` have, all of which are of the same `kind`.
fn settle_by_most(results: &mut [&mut Graded], kind: &str) {
    // The same two are alike, whichever of them accounts for more.
    let sorted = |ids: &Vec<String>| {
        let mut ids = ids.clone();
        ids.sort();
        ids
    };
    let mut counts: BTreeMap<Vec<String>, usize> = BTreeMap::new();
    for result in &*results {
        let given: BTreeSet<_> = result.causes.iter().map(sorted).collect();
        for ids in given {
            *counts.entry(ids).or_default() += 1;
        }
    }
    for result in results {
        let count = |place: &usize| counts[&sorted(&result.causes[*place])];
        // Of as many the one that is named first.
        let places = (0..result.causes.len()).rev();
        if let Some(place @ 1..) = places.max_by_key(count) {
            let why = format!("which gives other {kind} of the submission as well");
            bring_forward(result, place, &why);
        }
    }
}

/// Brings forward the explanations with mistakes that `meshes` show. Returns the pictures without one.
fn settle_by_meshes<'a>(
    pictures: Vec<&'a mut Graded>,
    meshes: &[&mut Graded],
) -> Vec<&'a mut Graded> {
    let shown = meshes.iter().filter_map(|mesh| mesh.causes.first());
    let shown: BTreeSet<&String> = shown.flatten().collect();
    let mut undecided = Vec::new();
    for picture in pictures {
        let is_shown = |ids: &Vec<String>| ids.iter().all(|id| shown.contains(id));
        match picture.causes.iter().position(is_shown) {
            None => undecided.push(picture),
            Some(0) => {}
            Some(place) => bring_forward(picture, place, "which meshes of the submission show"),
        }
    }
    undecided
}

/// Has the explanation at `place` count, and says `why`.
fn bring_forward(graded: &mut Graded, place: usize, why: &str) {
    graded.causes[..=place].rotate_right(1);
    let counted = graded.causes[0].join(" + ");
    (graded.text).push_str(&format!("\n  counted  as {counted}, {why}"));
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grade::Outcome;
    use crate::io::TestsFile;
    use std::path::Path;

    fn graded(causes: &[&[&str]]) -> Graded {
        Graded {
            causes: causes
                .iter()
                .map(|ids| ids.iter().map(|&id| id.to_owned()).collect())
                .collect(),
            ..Graded::without(Outcome::Explained, "told")
        }
    }

    #[test]
    fn of_mistakes_with_one_mesh_that_counts_which_gives_most_meshes() {
        let row =
            r#""character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1}"#;
        let rows = ["a", "b", "c"].map(|name| format!(r#"{{"name": "{name}", {row}}}"#));
        let text = format!(r#"{{"tests": [{}]}}"#, rows.join(", "));
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let settled = |meshes: [&[&[&str]]; 3]| {
            let mut all = meshes.map(graded);
            settle(&file.tests, &mut all);
            let counted = all.map(|graded| {
                let text = graded.text.strip_prefix("told").unwrap().to_owned();
                (graded.causes.first().map(|ids| ids.join(" ")), text)
            });
            counted.map(|(ids, text)| ids.unwrap_or_default() + &text)
        };
        let why = "which gives other meshes of the submission as well";
        assert_eq!(
            settled([&[&["x"], &["w"], &["y"]], &[&["y"]], &[&["y"]]]),
            [&format!("y\n  counted  as y, {why}"), "y", "y"]
        );
        assert_eq!(
            settled([&[&["x", "z"], &["y", "z"]], &[&["z", "y"]], &[]]),
            [&format!("y z\n  counted  as y + z, {why}"), "z y", ""]
        );
        // As many have the one as the other.
        assert_eq!(
            settled([&[&["x"], &["y"]], &[&["x"]], &[&["y"]]]),
            ["x", "x", "y"]
        );
    }

    #[test]
    fn pictures_without_meshes_decide_among_themselves() {
        let row = r#""character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1},
            "kind": "picture", "camera": [80, 10, 3]"#;
        let text = format!(r#"{{"tests": [{{"name": "a", {row}}}, {{"name": "b", {row}}}]}}"#);
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let mut both = [graded(&[&["x"], &["y"]]), graded(&[&["y"]])];
        settle(&file.tests, &mut both);
        let [first, second] = both;
        let counted = "told\n  counted  as y, which gives other pictures of the submission as well";
        assert_eq!((&*first.causes[0][0], &*first.text), ("y", counted));
        assert_eq!((&*second.causes[0][0], &*second.text), ("y", "told"));
    }

    #[test]
    fn of_mistakes_with_one_silhouette_those_count_that_a_mesh_shows() {
        let text = r#"{"tests": [
            {"name": "a", "character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1}},
            {"name": "b", "character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1},
             "kind": "picture", "camera": [80, 10, 3]}
        ]}"#;
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let settled = |mesh: &[&str]| {
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
