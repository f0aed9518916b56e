//! Files that several mistakes give alike: the other meshes of the submission tell which of them it makes.

use super::graded::Graded;
use super::late::settle_late;
use super::rubric::points_left;
use crate::diagnose::POSE_NOT_APPLIED;
use crate::io::{TestData, TestKind, TestsFile};
use std::collections::{BTreeMap, BTreeSet};

/// What is known of an explanation.
#[derive(Clone, Copy, Debug, Default, PartialEq, PartialOrd)]
struct Given {
    /// How many results it gives.
    results: usize,
    /// How many points it leaves in all of them.
    points: f64,
}

/// Has meshes count as late that are in the poses of the tests before. Of the explanations of each mesh, brings forward the
/// one that most meshes of the submission have, of as many the one that costs least, and of those of each picture the one
/// with mistakes that its meshes show, or else the one that most pictures have. `graded` has the results of the tests of
/// `file`, in their order.
pub(super) fn settle(file: &TestsFile, graded: &mut [Graded]) {
    settle_late(file, graded);
    let all = file.tests.iter().zip(graded);
    let (mut meshes, mut pictures): (Vec<_>, Vec<_>) =
        all.partition(|(test, _)| test.kind == TestKind::Mesh);
    settle_by_most(&mut meshes, "meshes", file);
    for (_, picture) in &mut pictures {
        let shown = picture.shows.clone();
        let mut all = meshes.iter();
        if let Some((mesh, graded)) = all.find(|(mesh, _)| shown.as_ref() == Some(&mesh.name)) {
            **picture = picture.clone().showing(&mesh.name, graded);
        }
    }
    let mut undecided = settle_by_meshes(pictures, &meshes);
    settle_by_most(&mut undecided, "pictures", file);
}

/// Brings forward the explanation that most of `results` have, all of which are of the same `kind`.
fn settle_by_most(results: &mut [(&TestData, &mut Graded)], kind: &str, file: &TestsFile) {
    // The same two are alike, whichever of them accounts for more.
    let sorted = |ids: &Vec<String>| {
        let mut ids = ids.clone();
        ids.sort();
        ids
    };
    let mut all: BTreeMap<Vec<String>, Given> = BTreeMap::new();
    for (test, result) in &*results {
        let explanations: BTreeSet<_> = result.causes.iter().map(sorted).collect();
        for ids in explanations {
            let points = points_left(&ids, test, result, &file.rubric);
            let given = all.entry(ids).or_default();
            given.results += 1;
            given.points += points;
        }
    }
    for (_, result) in results {
        let given: Vec<Given> = result.causes.iter().map(|ids| all[&sorted(ids)]).collect();
        let Some(&first) = given.first() else {
            continue;
        };
        // Where no pose is applied nothing else can be told.
        let is_unposed = result.causes[0].iter().any(|id| id == POSE_NOT_APPLIED);
        let is_better = |one: Given, other: Given| {
            one.results > other.results
                || !is_unposed && one.results == other.results && one.points > other.points + 1e-9
        };
        let mut best = 0;
        for place in 1..given.len() {
            // Of equals the one that is named first.
            if is_better(given[place], given[best]) {
                best = place;
            }
        }
        if best > 0 {
            let why = match given[best].results > first.results {
                true => format!("which gives other {kind} of the submission as well"),
                false => "which costs least of what gives the same".to_owned(),
            };
            bring_forward(result, best, &why);
        }
    }
}

/// Brings forward the explanations with mistakes that `meshes` show. Returns the pictures without one.
fn settle_by_meshes<'a>(
    pictures: Vec<(&'a TestData, &'a mut Graded)>,
    meshes: &[(&TestData, &mut Graded)],
) -> Vec<(&'a TestData, &'a mut Graded)> {
    let shown = meshes.iter().filter_map(|(_, mesh)| mesh.causes.first());
    let shown: BTreeSet<&String> = shown.flatten().collect();
    let mut undecided = Vec::new();
    for (test, picture) in pictures {
        let is_shown = |ids: &Vec<String>| ids.iter().all(|id| shown.contains(id));
        match picture.causes.iter().position(is_shown) {
            None => undecided.push((test, picture)),
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
    use crate::diagnose::MOVED_AS_A_WHOLE;
    use crate::grade::Outcome;
    use crate::grade::rubric::points;
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
            settle(&file, &mut all);
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
    fn of_mistakes_that_give_as_many_meshes_that_counts_which_costs_least() {
        let row = r#""character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 6, "4.2": 1}"#;
        let text = format!(r#"{{"tests": [{{"name": "a", {row}}}, {{"name": "b", {row}}}]}}"#);
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let (dear, cheap) = (&["euler-zyx"][..], &["no-inverse-bind"][..]);
        let settled = |causes: [&[&[&str]]; 2]| {
            let mut both = causes.map(graded);
            settle(&file, &mut both);
            both.map(|graded| {
                graded.causes[0][0].clone() + graded.text.strip_prefix("told").unwrap()
            })
        };
        let least = "no-inverse-bind\n  counted  as no-inverse-bind, which costs least of what gives the same";
        assert_eq!(settled([&[dear, cheap]; 2]), [least; 2]);
        assert_eq!(settled([&[dear, cheap], &[dear]]), ["euler-zyx"; 2]);
        // Where no pose is applied nothing else is seen.
        assert_eq!(
            settled([&[&[POSE_NOT_APPLIED], cheap]; 2]),
            [POSE_NOT_APPLIED; 2]
        );
    }

    #[test]
    fn pictures_without_meshes_decide_among_themselves() {
        let row = r#""character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1},
            "kind": "picture", "camera": [80, 10, 3]"#;
        let text = format!(r#"{{"tests": [{{"name": "a", {row}}}, {{"name": "b", {row}}}]}}"#);
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let mut both = [graded(&[&["x"], &["y"]]), graded(&[&["y"]])];
        settle(&file, &mut both);
        let [first, second] = both;
        let counted = "told\n  counted  as y, which gives other pictures of the submission as well";
        assert_eq!((&*first.causes[0][0], &*first.text), ("y", counted));
        assert_eq!((&*second.causes[0][0], &*second.text), ("y", "told"));
    }

    #[test]
    fn a_picture_that_shows_a_mesh_of_the_submission_counts_as_that() {
        let row =
            r#""character": "builtin:robot", "pose": "builtin:robot-greet", "points": {"3.4": 1}"#;
        let picture = r#""kind": "picture", "camera": [80, 10, 3]"#;
        let text =
            format!(r#"{{"tests": [{{"name": "a", {row}}}, {{"name": "b", {row}, {picture}}}]}}"#);
        let file = TestsFile::read(Path::new("tests.json"), text.as_bytes()).unwrap();
        let settled = |mesh: Graded, shows: Option<&str>| {
            let picture = Graded {
                shows: shows.map(str::to_owned),
                ..Graded::without(Outcome::Unexplained, "of the picture")
            };
            let mut both = [mesh, picture];
            settle(&file, &mut both);
            let [_, picture] = both;
            (
                picture.outcome,
                picture.causes.concat().join(" "),
                picture.text,
            )
        };
        let explained = graded(&[&["x", "y"]]);
        let told = "it shows a.obj of the submission:\ntold".to_owned();
        assert_eq!(
            settled(explained.clone(), Some("a")),
            (Outcome::Explained, "x y".to_owned(), told)
        );
        let own = (
            Outcome::Unexplained,
            String::new(),
            "of the picture".to_owned(),
        );
        assert_eq!(settled(explained, None), own);
        // One that is nearly right is explained by what is wrong with it.
        let turned = Graded {
            nearly: vec![MOVED_AS_A_WHOLE.to_owned()],
            error: Some(1.4),
            ..Graded::without(Outcome::Unexplained, "of axes")
        };
        let (test, rubric) = (&file.tests[1], &file.rubric);
        let left = |of: &Graded| points(test, of, rubric)["3.4"];
        let shown = Graded::without(Outcome::Unexplained, "of the picture").showing("a", &turned);
        assert_eq!(shown.text, "it shows a.obj of the submission:\nof axes");
        assert_eq!((left(&shown), left(&turned)), (0.75, 0.75));
        let unexplained = Graded::without(Outcome::Unexplained, "of the mesh");
        let told =
            "it shows a.obj of the submission, which nothing explains either\nof the picture";
        assert_eq!(settled(unexplained, Some("a")).2, told);
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
            settle(&file, &mut both);
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
